//! A step of Loop (1987): every edge is split, and the three corners of every triangle are cut off.

use std::error::Error;
use std::f64::consts::TAU;

use meshmend_core::PolygonMesh;
use meshmend_edit::{Editor, StaleKey, VertexKey};

#[path = "common/star.rs"]
mod star;
use star::{Point, mean, star, sum};

/// The mesh after one step; all faces must be triangles.
pub(crate) fn loop_scheme(mesh: &PolygonMesh) -> Result<PolygonMesh, Box<dyn Error>> {
    let mut editor = Editor::new(mesh)?;
    let (old, faces): (Vec<_>, Vec<_>) = (editor.vertices().collect(), editor.faces().collect());
    let mut middles = Vec::new();
    for edge in editor.edges().collect::<Vec<_>>() {
        middles.extend(editor.split_edge(edge, 0.5)?.vertices);
    }
    for face in faces {
        let halves: Vec<_> = editor.face_halves(face)?.collect();
        let &[_, first, _, second, _, third] = &halves[..] else { Err("a face is not a triangle")? };
        // Each cut takes the corner before a half-edge out of a middle; the face stays between them.
        let cut = editor.split_face(second, first)?.edges[0];
        editor.split_face(third, second)?;
        let [closing, _] = editor.edge_halves(cut)?;
        editor.split_face(closing, third)?;
    }
    let old = old.into_iter().map(|vertex| Ok((vertex, vertex_point(&editor, vertex)?)));
    let middles = middles.into_iter().map(|vertex| Ok((vertex, edge_point(&editor, vertex)?)));
    for (vertex, point) in old.chain(middles).collect::<Result<Vec<_>, StaleKey>>()? {
        editor.set_position(vertex, point)?;
    }
    Ok(editor.finish()?.0)
}

/// (1 − n β) P + β Σ, of the n neighbours; the ends of its edges now are halfway to those.
fn vertex_point(editor: &Editor, vertex: VertexKey) -> Result<Point, StaleKey> {
    let star = star(editor, vertex)?;
    let n_beta = 0.625 - (0.375 + 0.25 * (TAU / star.ends.len() as f64).cos()).powi(2);
    Ok(match (star.ends.is_empty(), star.rim.is_empty()) {
        (true, _) => star.at,
        (_, false) => sum([(0.5, star.at), (0.5, mean(&star.rim))]),
        _ => sum([(1.0 - 2.0 * n_beta, star.at), (2.0 * n_beta, mean(&star.ends))]),
    })
}

/// (3 a + 3 b + c + d) / 8, of which a + b + c + d is the sum of the four middles round it; on the boundary the middle.
fn edge_point(editor: &Editor, middle: VertexKey) -> Result<Point, StaleKey> {
    let star = star(editor, middle)?;
    let middles = [1, 2, 4, 5].map(|at| star.ends.get(at).copied().unwrap_or_default());
    Ok(if star.rim.is_empty() { sum([(0.5, star.at), (0.5, mean(&middles))]) } else { star.at })
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("an octahedron, subdivided: {:?}", loop_scheme(&meshmend_shapes::octahedron()?.mesh)?.counts());
    Ok(())
}
