//! Plain discs of extreme shape, where careless code becomes quadratic, and faces that fold onto themselves.

use crate::mesh_builder::{MeshBuilder, at_least, circle};
use crate::{Closed, Shape, ShapeError};

/// n triangles round one vertex, open. V = n + 2, E = 2n + 1, F = n: a disc; n ≥ 1.
///
/// # Errors
/// When n is 0 or too large.
pub fn fan(n: usize) -> Result<Shape, ShapeError> {
    at_least(1, "the number of triangles", n)?;
    let mut builder = MeshBuilder::with_room(&[n, 3])?;
    builder.point([0.0, 0.0, 1.0]);
    builder.points(circle(n + 1, 1.0, 0.0));
    (1..=n as u32).for_each(|i| builder.face(&[0, i, i + 1]));
    disc(builder, format!("fan of {n}"), [n + 2, 2 * n + 1, n])
}

/// n triangles in one row. V = n + 2, E = 2n + 1, F = n: a disc; n ≥ 1.
///
/// # Errors
/// When n is 0 or too large.
pub fn strip(n: usize) -> Result<Shape, ShapeError> {
    at_least(1, "the number of triangles", n)?;
    let mut builder = MeshBuilder::with_room(&[n, 3])?;
    builder.points((0..n + 2).map(|i| [i as f64 / 2.0, (i % 2) as f64, 0.0]));
    for i in 0..n as u32 {
        let turned = if i.is_multiple_of(2) { [i, i + 1, i + 2] } else { [i + 1, i, i + 2] };
        builder.face(&turned);
    }
    disc(builder, format!("strip of {n}"), [n + 2, 2 * n + 1, n])
}

/// One face of n corners. V = E = n, F = 1: a disc; n ≥ 3.
///
/// # Errors
/// When n is below 3 or too large.
pub fn polygon(n: usize) -> Result<Shape, ShapeError> {
    at_least(3, "the number of corners", n)?;
    let mut builder = MeshBuilder::with_room(&[n])?;
    builder.points(circle(n, 1.0, 0.0));
    builder.face(&(0..n as u32).collect::<Vec<_>>());
    disc(builder, format!("face of {n} corners"), [n, n, 1])
}

/// One face that walks along a path of n vertices and straight back. V = n, E = n − 1, F = 1: a sphere, as each edge
/// is used once each way; n ≥ 3.
///
/// # Errors
/// When n is below 3 or too large.
pub fn out_and_back(n: usize) -> Result<Shape, ShapeError> {
    at_least(3, "the number of vertices", n)?;
    let mut builder = MeshBuilder::with_room(&[n, 2])?;
    builder.points((0..n).map(|i| [i as f64, (i * i) as f64, 0.0]));
    builder.face(&(0..n as u32).chain((1..n as u32 - 1).rev()).collect::<Vec<_>>());
    builder.surface(format!("{n} out and back"), Closed::Handles(0), 0, [n, n - 1, 1])
}

fn disc(builder: MeshBuilder, name: String, counts: [usize; 3]) -> Result<Shape, ShapeError> {
    builder.surface(name, Closed::Handles(0), 1, counts)
}
