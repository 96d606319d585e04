//! A step of Catmull and Clark (1978): every edge is split, every face is poked, and the spokes to old vertices are removed.

use std::error::Error;

use meshmend_core::PolygonMesh;
use meshmend_edit::{Editor, StaleKey, VertexKey};

#[path = "common/star.rs"]
mod star;
use star::{Point, mean, star, sum};

/// The mesh after one step. All its faces have four sides, and its attributes go with it.
pub(crate) fn catmull_clark(mesh: &PolygonMesh) -> Result<PolygonMesh, Box<dyn Error>> {
    let mut editor = Editor::new(mesh)?;
    let old: Vec<_> = editor.vertices().collect();
    let faces: Vec<_> = editor.faces().collect();
    let mut middles = Vec::new();
    for edge in editor.edges().collect::<Vec<_>>() {
        middles.extend(editor.split_edge(edge, 0.5)?.vertices);
    }
    for face in faces {
        // Old vertices and middles of edges take turns round the face, an old one first; so do the spokes.
        let corners = editor.face_halves(face)?.step_by(2).map(|half| editor.position(editor.origin(half)?));
        let centre = mean(&corners.collect::<Result<Vec<_>, _>>()?);
        for spoke in editor.poke(face, centre)?.edges.into_iter().step_by(2) {
            editor.join_faces(spoke)?;
        }
    }
    let old = old.into_iter().map(|vertex| Ok((vertex, vertex_point(&editor, vertex)?)));
    let middles = middles.into_iter().map(|vertex| Ok((vertex, edge_point(&editor, vertex)?)));
    for (vertex, point) in old.chain(middles).collect::<Result<Vec<_>, StaleKey>>()? {
        editor.set_position(vertex, point)?;
    }
    Ok(editor.finish()?.0)
}

/// (F + 2 R + (n − 3) P) / n, of the points of the n faces and the middles of the n edges round it.
fn vertex_point(editor: &Editor, vertex: VertexKey) -> Result<Point, StaleKey> {
    let star = star(editor, vertex)?;
    if star.ends.is_empty() || !star.rim.is_empty() {
        let rim = if star.rim.is_empty() { star.at } else { mean(&star.rim) };
        return Ok(sum([(0.5, star.at), (0.5, rim)]));
    }
    let opposite =
        editor.vertex_halves(vertex)?.map(|half| editor.position(editor.target(editor.next(half)?)?));
    let (centres, n) = (opposite.collect::<Result<Vec<_>, _>>()?, star.ends.len() as f64);
    Ok(sum([(1.0 / n, mean(&centres)), (2.0 / n, mean(&star.ends)), ((n - 3.0) / n, star.at)]))
}

/// The mean of the ends and of the points of the two faces; on the boundary the middle.
fn edge_point(editor: &Editor, middle: VertexKey) -> Result<Point, StaleKey> {
    let star = star(editor, middle)?;
    Ok(if star.rim.is_empty() { mean(&star.ends) } else { star.at })
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("a cube, subdivided: {:?}", catmull_clark(&meshmend_shapes::cube()?.mesh)?.counts());
    Ok(())
}
