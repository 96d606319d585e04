//! Rectangular grids whose sides are glued, or not.
//!
//! ```text
//!   j ↑  ┌──┬──┬──┐        torus:          (n, j) is (0, j),      (i, m) is (i, 0)
//!   m    ├──┼──┼──┤        Klein bottle:   (n, j) is (0, m − j),  (i, m) is (i, 0)
//!        └──┴──┴──┘        Möbius band:    (n, j) is (0, m − j)
//!            n   → i       annulus:        (n, j) is (0, j)
//! ```

use std::f64::consts::TAU;

use super::{Closed, Shape};
use crate::Soup;

/// What the cells of a grid are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tiles {
    /// One quad a cell.
    Quads,
    /// Two triangles a cell.
    Triangles,
}

/// V = nm, E = 2nm or 3nm, F = nm or 2nm; n, m ≥ 3.
pub fn torus(n: usize, m: usize, tiles: Tiles) -> Shape {
    assert!(n >= 3 && m >= 3, "a torus grid needs three cells each way");
    let faces = cells(n, m, tiles, |i, j| (i % n) * m + j % m);
    let positions = places(n, m, |i, j| ring_point(i as f64 / n as f64, j as f64 / m as f64));
    let counts = counts(n * m, 2 * n * m, n * m, tiles);
    Shape::surface(format!("{n}x{m} torus"), Soup { positions, faces }, Closed::Handles(1), 0, counts)
}

/// V = nm, E = 2nm or 3nm, F = nm or 2nm; n, m ≥ 3.
pub fn klein_bottle(n: usize, m: usize, tiles: Tiles) -> Shape {
    assert!(n >= 3 && m >= 3, "a Klein bottle grid needs three cells each way");
    let name = |i: usize, j: usize| if i == n { (2 * m - j) % m } else { i * m + j % m };
    let faces = cells(n, m, tiles, name);
    let positions = places(n, m, |i, j| ring_point(i as f64 / n as f64, j as f64 / m as f64));
    let counts = counts(n * m, 2 * n * m, n * m, tiles);
    Shape::surface(
        format!("{n}x{m} Klein bottle"),
        Soup { positions, faces },
        Closed::CrossCaps(2),
        0,
        counts,
    )
}

/// V = n(m + 1), E = n(2m + 1) or n(3m + 1), F = nm or 2nm; n ≥ 3, m ≥ 1.
pub fn moebius_band(n: usize, m: usize, tiles: Tiles) -> Shape {
    assert!(n >= 3 && m >= 1, "a Möbius band needs three cells round");
    let faces = cells(n, m, tiles, |i, j| if i == n { m - j } else { i * (m + 1) + j });
    let positions = places(n, m + 1, |i, j| {
        let (turn, across) = (TAU * i as f64 / n as f64, j as f64 / m as f64 - 0.5);
        let radius = 1.0 + across * (turn / 2.0).cos();
        [radius * turn.cos(), radius * turn.sin(), across * (turn / 2.0).sin()]
    });
    let counts = counts(n * (m + 1), n * (2 * m + 1), n * m, tiles);
    Shape::surface(format!("{n}x{m} Möbius band"), Soup { positions, faces }, Closed::CrossCaps(1), 1, counts)
}

/// V = n(m + 1), E = n(2m + 1) or n(3m + 1), F = nm or 2nm; n ≥ 3, m ≥ 1.
pub fn annulus(n: usize, m: usize, tiles: Tiles) -> Shape {
    assert!(n >= 3 && m >= 1, "an annulus needs three cells round");
    let faces = cells(n, m, tiles, |i, j| (i % n) * (m + 1) + j);
    let positions = places(n, m + 1, |i, j| {
        let (turn, radius) = (TAU * i as f64 / n as f64, (j + 1) as f64);
        [radius * turn.cos(), radius * turn.sin(), 0.0]
    });
    let counts = counts(n * (m + 1), n * (2 * m + 1), n * m, tiles);
    Shape::surface(format!("{n}x{m} annulus"), Soup { positions, faces }, Closed::Handles(0), 2, counts)
}

/// V = (n + 1)(m + 1), E = n(m + 1) + m(n + 1) and nm more for triangles, F = nm or 2nm; n, m ≥ 1.
///
/// In the plane z = 0, at integer points.
pub fn disc(n: usize, m: usize, tiles: Tiles) -> Shape {
    assert!(n >= 1 && m >= 1, "a disc has a cell");
    let faces = cells(n, m, tiles, |i, j| i * (m + 1) + j);
    let positions = places(n + 1, m + 1, |i, j| [i as f64, j as f64, 0.0]);
    let counts = counts((n + 1) * (m + 1), n * (m + 1) + m * (n + 1), n * m, tiles);
    Shape::surface(format!("{n}x{m} disc"), Soup { positions, faces }, Closed::Handles(0), 1, counts)
}

/// The cells of a grid whose point (i, j) has a name.
fn cells(n: usize, m: usize, tiles: Tiles, name: impl Fn(usize, usize) -> usize) -> Vec<Vec<u32>> {
    let mut faces = Vec::new();
    for i in 0..n {
        for j in 0..m {
            let [a, b, c, d] =
                [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| name(i, j) as u32);
            match tiles {
                Tiles::Quads => faces.push(vec![a, b, c, d]),
                Tiles::Triangles => faces.extend([vec![a, b, c], vec![a, c, d]]),
            }
        }
    }
    faces
}

fn places(n: usize, m: usize, place: impl Fn(usize, usize) -> [f64; 3]) -> Vec<[f64; 3]> {
    (0..n * m).map(|v| place(v / m, v % m)).collect()
}

fn counts(vertices: usize, edges: usize, cells: usize, tiles: Tiles) -> [usize; 3] {
    match tiles {
        Tiles::Quads => [vertices, edges, cells],
        Tiles::Triangles => [vertices, edges + cells, 2 * cells],
    }
}

fn ring_point(round: f64, across: f64) -> [f64; 3] {
    let (u, v) = (TAU * round, TAU * across);
    let radius = 3.0 + v.cos();
    [radius * u.cos(), radius * u.sin(), v.sin()]
}
