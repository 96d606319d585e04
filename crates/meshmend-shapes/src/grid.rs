//! Rectangular grids of quads whose sides are glued, or not.
//!
//! ```text
//!   j ↑  ┌──┬──┬──┐        torus:          (n, j) is (0, j),      (i, m) is (i, 0)
//!   m    ├──┼──┼──┤        Klein bottle:   (n, j) is (0, m − j),  (i, m) is (i, 0)
//!        └──┴──┴──┘        Möbius band:    (n, j) is (0, m − j)
//!            n   → i       annulus:        (n, j) is (0, j)
//! ```

use std::f64::consts::TAU;

use crate::mesh_builder::{MeshBuilder, at_least};
use crate::{Closed, Shape, ShapeError};

const ROUND: &str = "the number of cells round";
const ACROSS: &str = "the number of cells across";

/// V = nm, E = 2nm, F = nm; n, m ≥ 3.
///
/// # Errors
/// When n or m is too small or the grid too large.
pub fn torus(n: usize, m: usize) -> Result<Shape, ShapeError> {
    at_least(3, ROUND, n)?;
    at_least(3, ACROSS, m)?;
    let mut builder = MeshBuilder::with_room(&[4, n, m])?;
    builder.points(places(n, m, |i, j| ring_point(i as f64 / n as f64, j as f64 / m as f64)));
    cells(&mut builder, n, m, |i, j| (i % n) * m + j % m);
    builder.surface(format!("{n}x{m} torus"), Closed::Handles(1), 0, [n * m, 2 * n * m, n * m])
}

/// V = nm, E = 2nm, F = nm; n, m ≥ 3. Its vertices are those of the torus, and the last cells run across the ring.
///
/// # Errors
/// When n or m is too small or the grid too large.
pub fn klein_bottle(n: usize, m: usize) -> Result<Shape, ShapeError> {
    at_least(3, ROUND, n)?;
    at_least(3, ACROSS, m)?;
    let mut builder = MeshBuilder::with_room(&[4, n, m])?;
    builder.points(places(n, m, |i, j| ring_point(i as f64 / n as f64, j as f64 / m as f64)));
    cells(&mut builder, n, m, |i, j| if i == n { (2 * m - j) % m } else { i * m + j % m });
    builder.surface(format!("{n}x{m} Klein bottle"), Closed::CrossCaps(2), 0, [n * m, 2 * n * m, n * m])
}

/// V = n(m + 1), E = n(2m + 1), F = nm; n ≥ 3, m ≥ 1.
///
/// # Errors
/// When n or m is too small or the grid too large.
pub fn moebius_band(n: usize, m: usize) -> Result<Shape, ShapeError> {
    at_least(3, ROUND, n)?;
    at_least(1, ACROSS, m)?;
    let mut builder = MeshBuilder::with_room(&[4, n, m])?;
    builder.points(places(n, m + 1, |i, j| {
        let (turn, across) = (TAU * i as f64 / n as f64, j as f64 / m as f64 - 0.5);
        let radius = 1.0 + across * (turn / 2.0).cos();
        [radius * turn.cos(), radius * turn.sin(), across * (turn / 2.0).sin()]
    }));
    cells(&mut builder, n, m, |i, j| if i == n { m - j } else { i * (m + 1) + j });
    let counts = [n * (m + 1), n * (2 * m + 1), n * m];
    builder.surface(format!("{n}x{m} Möbius band"), Closed::CrossCaps(1), 1, counts)
}

/// V = n(m + 1), E = n(2m + 1), F = nm; n ≥ 3, m ≥ 1. In the plane z = 0.
///
/// # Errors
/// When n or m is too small or the grid too large.
pub fn annulus(n: usize, m: usize) -> Result<Shape, ShapeError> {
    at_least(3, ROUND, n)?;
    at_least(1, ACROSS, m)?;
    let mut builder = MeshBuilder::with_room(&[4, n, m])?;
    builder.points(places(n, m + 1, |i, j| {
        let (turn, radius) = (TAU * i as f64 / n as f64, (j + 1) as f64);
        [radius * turn.cos(), radius * turn.sin(), 0.0]
    }));
    cells(&mut builder, n, m, |i, j| (i % n) * (m + 1) + j);
    let counts = [n * (m + 1), n * (2 * m + 1), n * m];
    builder.surface(format!("{n}x{m} annulus"), Closed::Handles(0), 2, counts)
}

/// V = (n + 1)(m + 1), E = n(m + 1) + m(n + 1), F = nm; n, m ≥ 1. In the plane z = 0, at integer points.
///
/// # Errors
/// When n or m is 0 or the grid too large.
pub fn disc(n: usize, m: usize) -> Result<Shape, ShapeError> {
    at_least(1, ACROSS, n)?;
    at_least(1, ACROSS, m)?;
    let mut builder = MeshBuilder::with_room(&[4, n, m])?;
    builder.points(places(n + 1, m + 1, |i, j| [i as f64, j as f64, 0.0]));
    cells(&mut builder, n, m, |i, j| i * (m + 1) + j);
    let counts = [(n + 1) * (m + 1), n * (m + 1) + m * (n + 1), n * m];
    builder.surface(format!("{n}x{m} disc"), Closed::Handles(0), 1, counts)
}

/// The cells of a grid whose point (i, j) has a name.
fn cells(builder: &mut MeshBuilder, n: usize, m: usize, name: impl Fn(usize, usize) -> usize) {
    for i in 0..n {
        for j in 0..m {
            builder.face(&[(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| name(i, j) as u32));
        }
    }
}

fn places(n: usize, m: usize, place: impl Fn(usize, usize) -> [f64; 3]) -> impl Iterator<Item = [f64; 3]> {
    (0..n * m).map(move |v| place(v / m, v % m))
}

/// A point of a ring of radius 3 and thickness 1; both turns as a part of a whole one.
fn ring_point(round: f64, across: f64) -> [f64; 3] {
    let (u, v) = (TAU * round, TAU * across);
    let radius = 3.0 + v.cos();
    [radius * u.cos(), radius * u.sin(), v.sin()]
}
