//! A polygon in a plane, with its corners from left to right.

use robust::{Coord, orient2d};

/// A polygon in a plane that runs round its inside anticlockwise. Corners are named after their places.
pub(super) struct Plane {
    points: Vec<[f64; 2]>,
    /// The corners from left to right, of those above each other from below, of those at one point by their places.
    order: Vec<u32>,
    /// The place of each corner in that order.
    ranks: Vec<u32>,
}

impl Plane {
    /// *Cost*: O(n log n).
    pub(super) fn of(points: Vec<[f64; 2]>) -> Self {
        let mut order: Vec<u32> = (0..points.len() as u32).collect();
        order.sort_unstable_by(|&one, &other| {
            let ([x, y], [u, v]) = (points[one as usize], points[other as usize]);
            x.total_cmp(&u).then(y.total_cmp(&v)).then(one.cmp(&other))
        });
        let mut ranks = vec![0; points.len()];
        for (rank, &corner) in order.iter().enumerate() {
            ranks[corner as usize] = rank as u32;
        }
        Plane { points, order, ranks }
    }

    pub(super) fn len(&self) -> usize {
        self.points.len()
    }

    pub(super) fn point(&self, corner: usize) -> [f64; 2] {
        self.points[corner]
    }

    /// The corners from left to right.
    pub(super) fn left_to_right(&self) -> impl Iterator<Item = usize> + '_ {
        self.order.iter().map(|&corner| corner as usize)
    }

    pub(super) fn corner_at(&self, rank: usize) -> usize {
        self.order[rank] as usize
    }

    pub(super) fn rank(&self, corner: usize) -> usize {
        self.ranks[corner] as usize
    }

    pub(super) fn next(&self, corner: usize) -> usize {
        if corner + 1 == self.len() { 0 } else { corner + 1 }
    }

    pub(super) fn previous(&self, corner: usize) -> usize {
        corner.checked_sub(1).unwrap_or(self.len() - 1)
    }

    /// Above zero where the way through three corners turns left, zero where it runs straight on or back.
    pub(super) fn turn(&self, one: usize, two: usize, three: usize) -> f64 {
        let [a, b, c] =
            [one, two, three].map(|corner| Coord { x: self.points[corner][0], y: self.points[corner][1] });
        orient2d(a, b, c)
    }

    /// The height of the side that starts at a corner, over a place within its reach.
    pub(super) fn height(&self, side: usize, x: f64) -> f64 {
        let ([x0, y0], [x1, y1]) = (self.points[side], self.points[self.next(side)]);
        let share = ((x - x0) / (x1 - x0)).clamp(0.0, 1.0);
        if share.is_nan() { y0 } else { y0 * (1.0 - share) + y1 * share }
    }
}
