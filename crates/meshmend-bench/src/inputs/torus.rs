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
        self.without(|_, _| false)
    }

    pub(super) fn with_holes(&self) -> Raw {
        let is_whole = |i: usize, count: usize| i < count / HOLE_SPACING * HOLE_SPACING;
        let is_middle = |i: usize| i % HOLE_SPACING == HOLE_SPACING / 2;
        self.without(|i, j| {
            is_middle(i) && is_middle(j) && is_whole(i, self.round) && is_whole(j, self.across)
        })
    }

    /// The torus without the first triangle of some cells.
    fn without(&self, is_hole: impl Fn(usize, usize) -> bool) -> Raw {
        let mut raw = Raw {
            positions: Vec::with_capacity(self.vertex_count()),
            triangles: Vec::with_capacity(self.face_count()),
        };
        let name = |i: usize, j: usize| ((i % self.round) * self.across + j % self.across) as u32;
        for i in 0..self.round {
            for j in 0..self.across {
                raw.positions.push(self.point(i, j));
                let [a, b, c, d] = [name(i, j), name(i + 1, j), name(i + 1, j + 1), name(i, j + 1)];
                if !is_hole(i, j) {
                    raw.triangles.push([a, b, c]);
                }
                raw.triangles.push([a, c, d]);
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
