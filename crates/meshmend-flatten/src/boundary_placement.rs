//! Where the boundary of a disc goes: on a circle or a square, by its length in space.

use std::f64::consts::TAU;

use robust::{Coord, orient2d};

/// The polygon on which a rim is put.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Outline {
    Circle,
    /// With the places in the rim of the nodes that stand in its corners, in order.
    Square([usize; 4]),
}

/// A square of the plane in which one disc is laid out.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cell {
    low: [f64; 2],
    side: f64,
}

/// How much of a cell is left free at each side where there are several.
const MARGIN: f64 = 1.0 / 64.0;

/// Parts of equal lengths, rather than of those in space, in turn until the polygon is convex in doubles.
const EVENNESS: [f64; 3] = [0.0, 0.5, 1.0];

impl Cell {
    /// The cells of a number of discs, row by row; the whole unit square for one.
    pub(crate) fn grid(count: usize) -> impl Iterator<Item = Cell> {
        let rows = (1usize..).find(|rows| rows * rows >= count).unwrap_or(1);
        let (side, margin) = (1.0 / rows as f64, if count > 1 { MARGIN } else { 0.0 });
        (0..count).map(move |i| {
            let [x, y] = [i % rows, i / rows].map(|at| (at as f64 + margin) * side);
            Cell { low: [x, y], side: side * (1.0 - 2.0 * margin) }
        })
    }

    /// The line that a node which is on a side lies on: which coordinate, and its value. Sides are counted as a
    /// square's corners are.
    pub(crate) fn line(self, side: usize) -> (usize, f64) {
        let axis = (side + 1) % 2;
        let [low, high] = [self.at([0.0; 2])[axis], self.at([1.0; 2])[axis]];
        (axis, if side == 0 || side == 3 { low } else { high })
    }

    /// The point at parts of the cell's sides.
    fn at(self, [u, v]: [f64; 2]) -> [f64; 2] {
        [self.low[0] + u * self.side, self.low[1] + v * self.side]
    }
}

/// The points of a rim, counter-clockwise from its first node.
///
/// Lengths are those of the edge from each node to the next. Where they are so unlike, or not numbers, that doubles
/// can't tell the points apart, they are evened out.
pub(crate) fn rim_points(lengths: &[f64], outline: Outline, cell: Cell) -> Vec<[f64; 2]> {
    let count = lengths.len() as f64;
    let total: f64 = lengths.iter().sum();
    let is_measured = total.is_finite() && total > 0.0;
    let mut points = Vec::new();
    for even in EVENNESS.into_iter().filter(|&even| is_measured || even == 1.0) {
        let share = |length: &f64| {
            let own = if is_measured { length / total } else { 0.0 };
            (1.0 - even) * own + even / count
        };
        let shares: Vec<f64> = lengths.iter().map(share).collect();
        points = match outline {
            Outline::Circle => on_circle(&shares, cell),
            Outline::Square(corners) => on_square(&shares, corners, cell),
        };
        if is_convex(&points, outline) {
            break;
        }
    }
    points
}

fn on_circle(shares: &[f64], cell: Cell) -> Vec<[f64; 2]> {
    let point = |part: f64| {
        let turn = TAU * part;
        cell.at([0.5 + 0.5 * turn.cos(), 0.5 + 0.5 * turn.sin()])
    };
    starts(shares).map(point).collect()
}

/// A node in each corner, from the lower left one on. Opposite sides whose edges are as long, the other way round,
/// have their points at the same places.
fn on_square(shares: &[f64], corners: [usize; 4], cell: Cell) -> Vec<[f64; 2]> {
    let side_shares = |side: usize| -> Vec<f64> {
        let (from, to) = (corners[side], corners[(side + 1) % 4]);
        let to = if to > from { to } else { to + shares.len() };
        (from..to).map(|i| shares[i % shares.len()]).collect()
    };
    let mut points = vec![[0.0; 2]; shares.len()];
    for side in 0..4 {
        let (own, across) = (side_shares(side), side_shares((side + 2) % 4));
        let is_mirrored = own.iter().eq(across.iter().rev());
        let along: Vec<f64> = match side {
            0 | 1 => parts(&own),
            _ if is_mirrored => parts(&across).into_iter().rev().collect(),
            _ => parts(&own).into_iter().map(|part| 1.0 - part).collect(),
        };
        for (i, &part) in along[..own.len()].iter().enumerate() {
            points[(corners[side] + i) % shares.len()] = cell.at(match side {
                0 => [part, 0.0],
                1 => [1.0, part],
                2 => [part, 1.0],
                _ => [0.0, part],
            });
        }
    }
    points
}

/// Where each part of a side begins, from 0, and the end, which is 1.
fn parts(shares: &[f64]) -> Vec<f64> {
    let total: f64 = shares.iter().sum();
    let part = |(i, start): (usize, f64)| {
        if total > 0.0 { start / total } else { i as f64 / shares.len() as f64 }
    };
    starts(shares).enumerate().map(part).chain([1.0]).collect()
}

/// The nodes of a rim that start nearest to 0, 1/4, 1/2 and 3/4 of its length, all different; `None` where it has
/// fewer than four.
pub(crate) fn corners_by_length(lengths: &[f64]) -> Option<[usize; 4]> {
    let (count, total) = (lengths.len(), lengths.iter().sum::<f64>());
    if count < 4 {
        return None;
    }
    let starts: Vec<f64> = if total.is_finite() && total > 0.0 {
        starts(lengths).map(|start| start / total).collect()
    } else {
        (0..count).map(|i| i as f64 / count as f64).collect()
    };
    let mut corners = [0; 4];
    for side in 1..4 {
        let quarter = side as f64 / 4.0;
        let above = starts.partition_point(|&start| start < quarter);
        let is_nearer =
            above > 0 && (above == count || quarter - starts[above - 1] < starts[above] - quarter);
        let nearest = if is_nearer { above - 1 } else { above };
        corners[side] = nearest.clamp(corners[side - 1] + 1, count - 4 + side);
    }
    Some(corners)
}

/// Where each part begins, when they follow one another from 0.
fn starts(shares: &[f64]) -> impl Iterator<Item = f64> {
    shares.iter().scan(0.0, |sum, share| Some(std::mem::replace(sum, *sum + share)))
}

/// Whether a circle's points turn left at each, and a square's go on along their side, exactly.
fn is_convex(points: &[[f64; 2]], outline: Outline) -> bool {
    let count = points.len();
    let coordinate = |i: usize| Coord { x: points[i % count][0], y: points[i % count][1] };
    match outline {
        Outline::Circle => {
            (0..count).all(|i| orient2d(coordinate(i), coordinate(i + 1), coordinate(i + 2)) > 0.0)
        }
        Outline::Square(_) => (0..count).all(|i| points[i] != points[(i + 1) % count]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn only_cell() -> Cell {
        Cell::grid(1).next().unwrap()
    }

    fn square(lengths: &[f64]) -> Option<Vec<[f64; 2]>> {
        Some(rim_points(lengths, Outline::Square(corners_by_length(lengths)?), only_cell()))
    }

    #[test]
    fn a_square_of_equal_edges_has_its_corners_at_the_quarters() {
        let expected =
            [[0.0, 0.0], [0.5, 0.0], [1.0, 0.0], [1.0, 0.5], [1.0, 1.0], [0.5, 1.0], [0.0, 1.0], [0.0, 0.5]];
        assert_eq!(square(&[1.0; 8]).unwrap(), expected);
    }

    #[test]
    fn a_square_needs_four_nodes_and_uses_different_ones() {
        assert_eq!(square(&[1.0; 3]), None);
        for lengths in [[100.0, 1.0, 1.0, 1.0, 1.0], [1.0, 1.0, 1.0, 1.0, 100.0], [0.0; 5], [f64::NAN; 5]] {
            let points = square(&lengths).unwrap();
            for corner in [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]] {
                assert!(points.contains(&corner), "{lengths:?} {points:?}");
            }
        }
    }

    #[test]
    fn sides_that_are_as_long_have_their_points_at_the_same_places() {
        let (bottom, right) = ([0.1, 0.7, 0.3], [1.0, 0.2]);
        let back = |side: &[f64]| side.iter().rev().copied().collect::<Vec<_>>();
        let lengths = [bottom.to_vec(), right.to_vec(), back(&bottom), back(&right)].concat();
        let points = rim_points(&lengths, Outline::Square([0, 3, 5, 8]), only_cell());
        for i in 0..=3 {
            assert_eq!(points[i][0], points[8 - i][0]);
        }
        for i in 0..=2 {
            assert_eq!(points[3 + i][1], points[(10 - i) % 10][1]);
        }
        // The same with the rim begun elsewhere.
        let turned = [&lengths[9..], &lengths[..9]].concat();
        let again = rim_points(&turned, Outline::Square([1, 4, 6, 9]), only_cell());
        assert_eq!(again[1..], points[..9]);
    }

    #[test]
    fn lengths_that_doubles_cannot_tell_apart_are_evened_out() {
        let circle = |lengths: &[f64]| rim_points(lengths, Outline::Circle, only_cell());
        for lengths in
            [vec![1.0, 0.0, 1.0, 1.0], vec![1.0, 1e-300, 1e300, 1.0], vec![f64::INFINITY, 1.0, 1.0]]
        {
            assert!(is_convex(&circle(&lengths), Outline::Circle), "{lengths:?}");
        }
        assert_eq!(circle(&[1.0, 2.0, 1.0])[1], [0.5, 1.0]);
    }

    #[test]
    fn cells_lie_apart_in_the_unit_square() {
        let cells: Vec<Cell> = Cell::grid(5).collect();
        for (i, cell) in cells.iter().enumerate() {
            assert!(cell.low.iter().all(|&x| x > 0.0 && x + cell.side < 1.0));
            let is_apart =
                |other: &Cell| (0..2).any(|axis| (cell.low[axis] - other.low[axis]).abs() > cell.side);
            assert!(cells[..i].iter().all(is_apart));
        }
    }
}
