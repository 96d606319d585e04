//! A step of Kobbelt's √3 scheme (2000): every triangle is poked, and every old edge is flipped.

use std::error::Error;
use std::f64::consts::TAU;

use meshmend_core::PolygonMesh;
use meshmend_edit::{Editor, StaleKey, VertexKey};

#[path = "common/star.rs"]
mod star;
use star::{Point, mean, star, sum};

/// The mesh after one step. What lies on the boundary stays, as in every other step of the scheme.
pub(crate) fn sqrt3(mesh: &PolygonMesh) -> Result<PolygonMesh, Box<dyn Error>> {
    let mut editor = Editor::new(mesh)?;
    let old: Vec<_> = editor.edges().collect();
    let moved = editor.vertices().map(|vertex| Ok((vertex, vertex_point(&editor, vertex)?)));
    let moved = moved.collect::<Result<Vec<_>, StaleKey>>()?;
    for face in editor.faces().collect::<Vec<_>>() {
        let corners = editor.face_halves(face)?.map(|half| editor.position(editor.origin(half)?));
        let centre = mean(&corners.collect::<Result<Vec<_>, _>>()?);
        editor.poke(face, centre)?;
    }
    for edge in old {
        let [half, twin] = editor.edge_halves(edge)?;
        if editor.face(half)?.is_some() && editor.face(twin)?.is_some() {
            editor.flip(edge)?;
        }
    }
    for (vertex, point) in moved {
        editor.set_position(vertex, point)?;
    }
    Ok(editor.finish()?.0)
}

/// (1 − α) P + α times the mean of the n neighbours, where α is (4 − 2 cos 2π/n) / 9.
fn vertex_point(editor: &Editor, vertex: VertexKey) -> Result<Point, StaleKey> {
    let star = star(editor, vertex)?;
    if star.ends.is_empty() || !star.rim.is_empty() {
        return Ok(star.at);
    }
    let alpha = (4.0 - 2.0 * (TAU / star.ends.len() as f64).cos()) / 9.0;
    Ok(sum([(1.0 - alpha, star.at), (alpha, mean(&star.ends))]))
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("an icosahedron, subdivided: {:?}", sqrt3(&meshmend_shapes::icosahedron()?.mesh)?.counts());
    Ok(())
}
