//! Plain discs of extreme shape, where careless code becomes quadratic, and faces that fold onto themselves.

use std::f64::consts::TAU;

use super::{Closed, Shape};
use crate::Soup;

/// n triangles round one vertex, open. V = n + 2, E = 2n + 1, F = n: a disc.
pub fn fan(n: usize) -> Shape {
    let rim = (0..=n).map(|i| {
        let turn = TAU * i as f64 / (n + 1) as f64;
        [turn.cos(), turn.sin(), 0.0]
    });
    let positions = [[0.0, 0.0, 1.0]].into_iter().chain(rim).collect();
    let faces = (1..=n as u32).map(|i| vec![0, i, i + 1]).collect();
    disc(format!("fan of {n}"), Soup { positions, faces }, [n + 2, 2 * n + 1, n])
}

/// n triangles in one row. V = n + 2, E = 2n + 1, F = n: a disc.
pub fn strip(n: usize) -> Shape {
    let positions = (0..n + 2).map(|i| [i as f64 / 2.0, (i % 2) as f64, 0.0]).collect();
    let turned = |i: u32| if i.is_multiple_of(2) { vec![i, i + 1, i + 2] } else { vec![i + 1, i, i + 2] };
    let faces = (0..n as u32).map(turned).collect();
    disc(format!("strip of {n}"), Soup { positions, faces }, [n + 2, 2 * n + 1, n])
}

/// One face of n corners. V = E = n, F = 1: a disc; n ≥ 3.
pub fn polygon(n: usize) -> Shape {
    let turn = |i: usize| TAU * i as f64 / n as f64;
    let positions = (0..n).map(|i| [turn(i).cos(), turn(i).sin(), 0.0]).collect();
    let faces = vec![(0..n as u32).collect()];
    disc(format!("face of {n} corners"), Soup { positions, faces }, [n, n, 1])
}

/// One face that walks along a path of n vertices and straight back. V = n, E = n − 1, F = 1: a sphere, as each edge
/// is used once each way; n ≥ 3.
pub fn out_and_back(n: usize) -> Shape {
    let positions = (0..n).map(|i| [i as f64, (i * i) as f64, 0.0]).collect();
    let faces = vec![(0..n as u32).chain((1..n as u32 - 1).rev()).collect()];
    let counts = [n, n - 1, 1];
    Shape::surface(format!("{n} out and back"), Soup { positions, faces }, Closed::Handles(0), 0, counts)
}

fn disc(name: String, soup: Soup, counts: [usize; 3]) -> Shape {
    Shape::surface(name, soup, Closed::Handles(0), 1, counts)
}
