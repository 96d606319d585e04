//! Whether triangles that are not part of a mesh would cross its faces.

use meshmend_core::{Cancelled, FaceId};
use meshmend_geometry::vector::{Point, place_bits};

use super::STEP;
use crate::boxes::{Bounds, BoxTree, Query};
use crate::exact::are_collinear;
use crate::meeting::Pair;
use crate::surface::{Surface, WHOLE};

/// A surface in which triangles are looked for that cross others.
pub struct CrossingSearch<'s> {
    surface: &'s Surface<'s>,
    tree: BoxTree,
}

impl<'s> CrossingSearch<'s> {
    /// Of all faces that have a surface.
    ///
    /// # Errors
    /// When whoever watches the surface stops it.
    ///
    /// *Cost*: O(n log n), and at most 18 bytes a triangle.
    pub fn new(surface: &'s Surface<'s>) -> Result<Self, Cancelled> {
        let all = surface.triangles();
        let bounds = |at: usize| Bounds::of(surface.points(&all[at]));
        let tree = BoxTree::watched(all.len(), bounds, (surface.watch(), STEP))?;
        Ok(CrossingSearch { surface, tree })
    }

    /// The lowest face that a triangle of finite corners crosses or overlaps: their insides have a point in common, and they do
    /// not have the same corners. Corners are the same where their positions are. A triangle of zero area crosses nothing.
    ///
    /// *Cost*: O(log n), and a comparison for each face whose box overlaps the triangle's.
    pub fn first_crossing(&self, triangle: [Point; 3]) -> Option<FaceId> {
        self.crossings(triangle).first().copied()
    }

    /// All faces that a triangle of finite corners crosses or overlaps, ascending: as [`first_crossing`](Self::first_crossing) says.
    ///
    /// *Cost*: O(log n), and a comparison for each face whose box overlaps the triangle's.
    pub fn crossings(&self, triangle: [Point; 3]) -> Vec<FaceId> {
        let mut faces = Vec::new();
        if are_collinear(triangle) {
            return faces;
        }
        let all = self.surface.triangles();
        let points = |at: usize| self.surface.points(&all[at]);
        let query = Query { bounds: Bounds::of(triangle), from: 0 };
        self.tree.each_overlap(
            &[query],
            |at| Bounds::of(points(at)),
            |_, at| {
                if have_common_insides(triangle, points(at)) {
                    faces.push(all[at].face);
                }
            },
        );
        faces.sort_unstable();
        faces.dedup();
        faces
    }
}

/// Whether two triangles of finite corners cross or overlap: as [`CrossingSearch::first_crossing`] says.
///
/// *Cost*: constant.
pub fn do_cross(one: [Point; 3], other: [Point; 3]) -> bool {
    Bounds::of(one).overlaps(&Bounds::of(other))
        && !are_collinear(one)
        && !are_collinear(other)
        && have_common_insides(one, other)
}

/// Whether the insides of two triangles of positive area have a point in common, and they have not the same corners. Their
/// boxes overlap.
fn have_common_insides(one: [Point; 3], other: [Point; 3]) -> bool {
    let pair = Pair::named([&one, &other], [one, other].map(|triangle| triangle.map(place_bits)));
    let size = Bounds::of(one).size().max(Bounds::of(other).size());
    !pair.is_coincident()
        && !pair.is_seen_to_be_proper(size)
        && pair.meeting().is_some_and(|meeting| meeting.cells == [WHOLE; 2])
}

#[cfg(test)]
mod tests {
    use meshmend_core::PolygonMesh;

    use super::*;

    #[test]
    fn a_triangle_crosses_the_lowest_face_of_those_that_it_passes() {
        let points = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [4.0, 4.0, 0.0]];
        let mesh = PolygonMesh::from_triangles(&points, &[[1, 3, 2], [0, 1, 2]]).unwrap();
        let surface = Surface::of(&mesh).unwrap();
        let search = CrossingSearch::new(&surface).unwrap();
        let [a, b, c, _] = points;
        let cases = [
            ([[1.0, 1.0, -1.0], [1.0, 1.0, 1.0], [2.0, 1.0, 1.0]], Some(FaceId(1))),
            ([[0.0, 4.0, -1.0], [4.0, 0.0, 1.0], [9.0, 0.0, 1.0]], Some(FaceId(0))),
            ([a, b, c], None),
            ([a, b, [9.0, 9.0, -0.0]], Some(FaceId(0))),
            ([a, b, [1.0, 1.0, 1.0]], None),
            ([[1.0, 1.0, -1.0], [1.0, 1.0, 1.0], [1.0, 1.0, 2.0]], None),
        ];
        for (triangle, expected) in cases {
            assert_eq!(search.first_crossing(triangle), expected, "{triangle:?}");
        }
        assert!(do_cross([a, b, c], cases[0].0) && !do_cross([a, b, c], [a, c, b]));
    }
}
