//! What lies round a vertex, for schemes of subdivision.

use meshmend_edit::{Editor, StaleKey, VertexKey};

pub(crate) type Point = [f64; 3];

/// The points round a vertex.
pub(crate) struct Star {
    /// Where the vertex is.
    pub(crate) at: Point,
    /// The other ends of its edges, counter-clockwise.
    pub(crate) ends: Vec<Point>,
    /// The other ends of its edges along the boundary.
    pub(crate) rim: Vec<Point>,
}

pub(crate) fn star(editor: &Editor, vertex: VertexKey) -> Result<Star, StaleKey> {
    let at = editor.position(vertex)?;
    let mut star = Star { at, ends: Vec::new(), rim: Vec::new() };
    for half in editor.vertex_halves(vertex)? {
        let end = editor.position(editor.target(half)?)?;
        star.ends.push(end);
        if editor.face(half)?.is_none() || editor.face(editor.twin(half)?)?.is_none() {
            star.rim.push(end);
        }
    }
    Ok(star)
}

/// The sum of points, each times its weight.
pub(crate) fn sum<const N: usize>(terms: [(f64, Point); N]) -> Point {
    [0, 1, 2].map(|axis| terms.iter().map(|(weight, point)| weight * point[axis]).sum())
}

pub(crate) fn mean(points: &[Point]) -> Point {
    [0, 1, 2].map(|axis| points.iter().map(|point| point[axis]).sum::<f64>() / points.len() as f64)
}
