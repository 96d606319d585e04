//! What closed components enclose, asked at the middle of a face.

use meshmend_core::{Cancelled, FaceId};
use meshmend_geometry::vector::Point;

use crate::Surface;
use crate::boxes::{Bounds, BoxTree, Query};
use crate::exact::{Axis, Centroid, Sign, projection_of, turn_along};
use crate::nesting::passage_of_turns;
use crate::surface::Triangle;

/// How a face lies to what closed components enclose.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Status {
    /// Inside of it on both sides.
    Internal,
    /// Not inside of it on both sides.
    Bounding,
    /// Another face lies on it where it is asked.
    Covered,
}

/// The triangles of all closed oriented components.
pub(super) struct Walls<'a> {
    surface: &'a Surface<'a>,
    triangles: Vec<Triangle>,
    tree: BoxTree,
}

/// What a ray from the middle of a face passes.
#[derive(Clone, Copy)]
struct Passed {
    winding: i64,
    is_covered: bool,
}

impl<'a> Walls<'a> {
    /// The triangles of some faces.
    pub(super) fn of(
        surface: &'a Surface<'a>,
        is_wall: impl Fn(FaceId) -> bool,
        step: &'static str,
    ) -> Result<Self, Cancelled> {
        let walls = surface.triangles().iter().copied().filter(|triangle| is_wall(triangle.face));
        let triangles: Vec<Triangle> = walls.collect();
        let bounds = |item: usize| Bounds::of(surface.points(&triangles[item]));
        let tree = BoxTree::watched(triangles.len(), bounds, (surface.watch(), step))?;
        Ok(Walls { surface, triangles, tree })
    }

    /// How some faces with a surface lie, each at the mean of the corners of its first triangle.
    pub(super) fn statuses(&self, faces: &[FaceId]) -> Vec<Status> {
        let first = |&face: &FaceId| self.surface.triangles_of(face).first().copied();
        let asked: Vec<Triangle> = faces.iter().filter_map(first).collect();
        let points: Vec<[Point; 3]> = asked.iter().map(|triangle| self.surface.points(triangle)).collect();
        let queries: Vec<Query> =
            points.iter().map(|&points| Query { bounds: column(points), from: 0 }).collect();
        let mut passed = vec![Passed { winding: 0, is_covered: false }; asked.len()];
        let bounds = |item: usize| Bounds::of(self.surface.points(&self.triangles[item]));
        self.tree.each_overlap(&queries, bounds, |query, item| {
            if self.triangles[item] != asked[query] {
                passed[query].pass(Centroid::of(points[query]), self.surface.points(&self.triangles[item]));
            }
        });
        passed.iter().zip(&points).map(|(passed, &triangle)| passed.status(triangle)).collect()
    }
}

impl Passed {
    /// Passes a triangle, if it lies above the point or holds it.
    fn pass(&mut self, middle: Centroid, triangle: [Point; 3]) {
        let side = middle.side_of_plane(triangle);
        if side.is_zero() && holds(triangle, middle) {
            self.is_covered = true;
        }
        match passage_of_turns(triangle, middle.turns_along(Axis::Z, triangle), || side) {
            Sign::Positive => self.winding += 1,
            Sign::Zero => {}
            Sign::Negative => self.winding -= 1,
        }
    }

    fn status(&self, triangle: [Point; 3]) -> Status {
        if self.is_covered {
            return Status::Covered;
        }
        // The ray begins on the side of the triangle to which it is moved.
        let faces = [Axis::Z, Axis::X, Axis::Y].map(|axis| turn_along(axis, triangle));
        let is_front = faces.into_iter().find(|sign| !sign.is_zero()) == Some(Sign::Positive);
        let front = if is_front { self.winding } else { self.winding - 1 };
        if front != 0 && front + 1 != 0 { Status::Internal } else { Status::Bounding }
    }
}

/// Whether a triangle holds a point of its plane.
fn holds(triangle: [Point; 3], middle: Centroid) -> bool {
    projection_of(triangle).is_some_and(|(axis, way)| {
        middle.turns_along(axis, triangle).into_iter().all(|turn| turn * way != Sign::Negative)
    })
}

/// A box that holds all above the mean of a triangle's corners.
fn column(triangle: [Point; 3]) -> Bounds {
    let size = triangle.iter().flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
    // More than rounding of the mean can be.
    let margin = (size * 1e-14).max(f64::MIN_POSITIVE);
    let mean = |axis: usize| triangle.iter().map(|corner| corner[axis] / 3.0).sum::<f64>();
    let [x, y, z] = [mean(0), mean(1), mean(2)];
    Bounds { low: [x - margin, y - margin, z - margin], high: [x + margin, y + margin, f64::INFINITY] }
}
