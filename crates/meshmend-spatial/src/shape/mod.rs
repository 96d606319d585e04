//! Which faces are too thin?
//!
//! A face all of whose corners lie on one line has *zero area*. A triangle with longest edge L and height h over it is a
//! *sliver* when L ≥ R h, R being the limit of the aspect: a *needle* when ten times its shortest edge is not above L, else a
//! *cap*. Every yes or no is that of real arithmetic.

mod aspect;
mod straight;

use meshmend_core::{FaceId, PolygonMesh, distinct_count};
use meshmend_geometry::vector::{Point, is_finite};
use rayon::prelude::*;

pub(crate) use aspect::aspect;
pub use aspect::{SliverKind, compare_aspects, sliver_kind};
pub use straight::is_straight;

/// The faces that are too thin, each list ascending by face.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shapes {
    /// The faces all of whose corners lie on one line, whatever their number.
    pub zero_area: Vec<FaceId>,
    /// The triangles that are slivers, and have an area.
    pub slivers: Vec<Sliver>,
}

/// A triangle that is too thin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sliver {
    /// Which.
    pub face: FaceId,
    /// What it looks like.
    pub kind: SliverKind,
    /// Its longest edge by its height over it: shown, not judged.
    pub aspect: f64,
}

/// The faces of a mesh that are too thin: longer than so many times their height. Degenerate faces and those with a
/// corner that is not finite take no part.
///
/// *Cost*: linear, on all threads; some microseconds for a face of which doubles can't tell.
pub fn shapes(mesh: &PolygonMesh, limit: f64) -> Shapes {
    let faces = mesh.complex().faces();
    let ids: Vec<FaceId> = faces.faces().collect();
    let found = ids.par_chunks(CHUNK).map(|chunk| {
        let mut found = Shapes::default();
        chunk.iter().for_each(|&face| judge(mesh, face, limit, &mut found));
        found
    });
    found.collect::<Vec<Shapes>>().into_iter().fold(Shapes::default(), |mut all, one| {
        all.zero_area.extend(one.zero_area);
        all.slivers.extend(one.slivers);
        all
    })
}

/// Faces of a piece of work.
const CHUNK: usize = 1 << 12;

fn judge(mesh: &PolygonMesh, face: FaceId, limit: f64, found: &mut Shapes) {
    let vertices = mesh.complex().faces().face_vertices(face);
    if let &[a, b, c] = vertices {
        let points = [a, b, c].map(|vertex| mesh.position(vertex));
        if !points.iter().all(is_finite) || a == b || b == c || c == a {
            return;
        }
        // What has no area is a sliver by any limit.
        let Some(kind) = sliver_kind(points, limit) else { return };
        if is_straight(&points) {
            found.zero_area.push(face);
        } else {
            found.slivers.push(Sliver { face, kind, aspect: aspect(points) });
        }
        return;
    }
    let points: Vec<Point> = vertices.iter().map(|&vertex| mesh.position(vertex)).collect();
    if points.iter().all(is_finite) && distinct_count(vertices) > 2 && is_straight(&points) {
        found.zero_area.push(face);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faces_on_a_line_have_no_area_whatever_their_number_of_corners() {
        let points =
            [[0.0, 0.0, 0.0], [1.0, 1.0, 1.0], [3.0, 3.0, 3.0], [2.0, 2.0, 2.0], [f64::NAN, 0.0, 0.0]];
        let mesh = PolygonMesh::from_polygons(
            &points,
            &[0, 1, 2, 0, 2, 3, 1, 0, 1, 4, 0, 1, 0, 1],
            &[0, 3, 7, 10, 12, 14],
        );
        let found = shapes(&mesh.unwrap(), 1000.0);
        assert_eq!(found, Shapes { zero_area: vec![FaceId(0), FaceId(1)], slivers: Vec::new() });
    }

    #[test]
    fn slivers_are_told_with_what_they_look_like() {
        let points =
            [[0.0, 0.0, 0.0], [1000.0, 0.0, 0.0], [500.0, 0.5, 0.0], [1000.0, 0.25, 0.0], [500.0, 1.5, 0.0]];
        let mesh = PolygonMesh::from_triangles(&points, &[[0, 1, 2], [3, 0, 1], [0, 1, 4]]).unwrap();
        let found = shapes(&mesh, 1000.0).slivers;
        assert_eq!(
            found.iter().map(|s| (s.face.0, s.kind)).collect::<Vec<_>>(),
            [(0, SliverKind::Cap), (1, SliverKind::Needle)]
        );
        assert_eq!(found[0].aspect, 2000.0);
    }
}
