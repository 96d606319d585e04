//! A torus of triangles on a grid.

use std::f64::consts::TAU;

use super::Raw;

/// The distance of the tube's axis from the middle, and the tube's radius.
const RADII: [f64; 2] = [700.0, 300.0];
/// Coordinates are multiples of one part in so many.
const STEPS: f64 = 64.0;
/// A hole in every so many cells each way.
const HOLE_SPACING: usize = 16;

/// Twice as many cells round as across, each of two triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Torus {
    round: usize,
    across: usize,
}

impl Torus {
    /// The torus of about so many faces.
    pub(super) fn of_about(faces: usize) -> Self {
        let across = (faces / 4).isqrt().max(3);
        Torus { round: (faces / 2 / across).max(3), across }
    }

    pub(super) fn vertex_count(&self) -> usize {
        self.round * self.across
    }

    pub(super) fn face_count(&self) -> usize {
        2 * self.vertex_count()
    }

    /// One face is missing in each whole block of cells.
    pub(super) fn hole_count(&self) -> usize {
        (self.round / HOLE_SPACING) * (self.across / HOLE_SPACING)
    }

    pub(super) fn raw(&self) -> Raw {
        self.without(|_, _, _| false)
    }

    /// How many square holes of so many cells each way there are, with two rows of cells between them.
    pub(super) fn square_hole_count(&self, cells: usize) -> usize {
        (self.round / (cells + 2)) * (self.across / (cells + 2))
    }

    /// With square holes of so many cells each way; the vertices inside of them are loose.
    pub(super) fn with_square_holes(&self, cells: usize) -> Raw {
        let spacing = cells + 2;
        let is_hole =
            |i: usize, count: usize| i < count / spacing * spacing && (1..=cells).contains(&(i % spacing));
        self.without(|i, j, _| is_hole(i, self.round) && is_hole(j, self.across))
    }

    /// How many fins there are.
    pub(super) fn fin_count(&self) -> usize {
        self.vertex_count()
    }

    /// With a small triangle through the middle of the first triangle of each cell.
    pub(super) fn with_fins(&self) -> Raw {
        const STEP: f64 = 1.0 / 128.0;
        const LENGTH: f64 = 8.0 * STEP;
        let mut raw = self.raw();
        for first in (0..raw.triangles.len()).step_by(2) {
            let corners = raw.triangles[first].map(|corner| raw.positions[corner as usize]);
            let middle = [0, 1, 2].map(|axis| {
                (corners.iter().map(|corner| corner[axis]).sum::<f64>() / 3.0 / STEP).round() * STEP
            });
            let [u, v] = [1, 2].map(|at: usize| [0, 1, 2].map(|i: usize| corners[at][i] - corners[0][i]));
            let across = [0, 1, 2].map(|i: usize| {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                (u[j] * v[k] - u[k] * v[j]).abs()
            });
            let steepest = (1..3).fold(0, |most, i| if across[i] > across[most] { i } else { most });
            let beside = |axis: usize, length: f64| {
                let mut point = middle;
                point[axis] += length;
                point
            };
            let count = raw.positions.len() as u32;
            raw.positions.extend([
                beside(steepest, LENGTH),
                beside(steepest, -LENGTH),
                beside((steepest + 1) % 3, LENGTH),
            ]);
            raw.triangles.push([count, count + 1, count + 2]);
        }
        raw
    }

    pub(super) fn with_holes(&self) -> Raw {
        let is_whole = |i: usize, count: usize| i < count / HOLE_SPACING * HOLE_SPACING;
        let is_middle = |i: usize| i % HOLE_SPACING == HOLE_SPACING / 2;
        self.without(|i, j, which| {
            which == 0 && is_middle(i) && is_middle(j) && is_whole(i, self.round) && is_whole(j, self.across)
        })
    }

    /// The torus without the first (0) or the second triangle (1) of some cells.
    fn without(&self, is_missing: impl Fn(usize, usize, usize) -> bool) -> Raw {
        let mut raw = Raw {
            positions: Vec::with_capacity(self.vertex_count()),
            triangles: Vec::with_capacity(self.face_count()),
        };
        let name = |i: usize, j: usize| ((i % self.round) * self.across + j % self.across) as u32;
        for i in 0..self.round {
            for j in 0..self.across {
                raw.positions.push(self.point(i, j));
                let [a, b, c, d] = [name(i, j), name(i + 1, j), name(i + 1, j + 1), name(i, j + 1)];
                let both = [[a, b, c], [a, c, d]].into_iter().enumerate();
                let left = both.filter(|&(which, _)| !is_missing(i, j, which));
                raw.triangles.extend(left.map(|(_, triangle)| triangle));
            }
        }
        raw
    }

    fn point(&self, i: usize, j: usize) -> [f64; 3] {
        let (round, across) = (TAU * i as f64 / self.round as f64, TAU * j as f64 / self.across as f64);
        let radius = RADII[0] + RADII[1] * across.cos();
        [radius * round.cos(), radius * round.sin(), RADII[1] * across.sin()]
            .map(|x| (x * STEPS).round() / STEPS + 0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_largest_torus_has_its_vertices_further_apart_than_jitter_joins() {
        let torus = Torus::of_about(crate::inputs::MOST_FACES);
        let inner = TAU * (RADII[0] - RADII[1]) / torus.round as f64;
        let across = TAU * RADII[1] / torus.across as f64;
        // Each of two vertices is rounded to 1/64 and jittered by 3/128 along each axis.
        let moved = 3.0_f64.sqrt() * 2.0 * (0.5 / STEPS + 3.0 / 128.0);
        assert!(inner.min(across) - moved > crate::inputs::JITTER);
        assert!(3.0_f64.sqrt() * 6.0 / 128.0 < crate::inputs::JITTER);
    }

    #[test]
    fn a_million_faces_are_a_million() {
        assert_eq!(Torus::of_about(1_000_000).face_count(), 1_000_000);
    }
}
