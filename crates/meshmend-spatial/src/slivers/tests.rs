//! Steps on small meshes.

use meshmend_core::{CornerId, FaceId, PolygonMesh, VertexId};

use super::*;
use crate::SliverKind;

fn mesh(points: &[[f64; 2]], faces: &[[u32; 3]]) -> PolygonMesh {
    let points: Vec<Point> = points.iter().map(|&[x, y]| [x, y, 0.0]).collect();
    PolygonMesh::from_triangles(&points, faces).unwrap()
}

/// A strip in which vertices 1 and 2 are so far apart, inside of a border.
fn needles(gap: f64) -> PolygonMesh {
    let points = [[-4e3, 0.0], [0.0, 0.0], [0.0, gap], [4e3, 0.0], [0.0, -5e3], [0.0, 5e3]];
    let faces = [[1, 3, 2], [2, 0, 1], [0, 4, 1], [1, 4, 3], [3, 5, 2], [2, 5, 0]];
    mesh(&points, &faces)
}

fn task<'a>(mesh: &'a PolygonMesh, reach: f64) -> SliverTask<'a> {
    SliverTask { mesh, aspect: 1000.0, reach, stood_for: &[], attributes: &NoAttributes }
}

fn mended(task: &SliverTask<'_>) -> MendedSlivers {
    mend_slivers(task, &|| true).unwrap()
}

fn reasons(mended: &MendedSlivers) -> Vec<(u32, SliverReason)> {
    mended.left.iter().map(|left| (left.sliver.face.0, left.reason)).collect()
}

#[test]
fn a_needle_is_collapsed_into_the_lower_end() {
    let mesh = needles(1.0);
    let mended = mended(&task(&mesh, 1.0));
    let [step] = mended.steps[..] else { panic!("{mended:?}") };
    assert_eq!(step.mend, SliverMend::Collapse { from: VertexId(2), into: VertexId(1) });
    assert_eq!((step.sliver.face, step.sliver.kind), (FaceId(0), SliverKind::Needle));
    let reshaped = mended.reshaped.unwrap();
    assert_eq!(reshaped.is_gone, [true, true, false, false, false, false]);
    assert_eq!(reshaped.vertices[12..], [3, 5, 1, 1, 5, 0].map(VertexId));
    assert_eq!(reshaped.origins[12..], [12, 13, 0, 0, 16, 17].map(CornerId));
    assert_eq!(mended.left, []);
}

#[test]
fn nothing_moves_farther_than_it_may_from_where_it_was_stored() {
    let mesh = needles(1.0);
    assert_eq!(reasons(&mended(&task(&mesh, 0.5))), [(0, SliverReason::Move), (1, SliverReason::Move)]);
    // Vertex 2 was stored elsewhere: it may not go, but the other one may.
    let stood_for = [(VertexId(2), [0.0, 2.0, 0.0])];
    let other = mended(&SliverTask { stood_for: &stood_for, ..task(&mesh, 1.0) });
    assert_eq!(other.steps[0].mend, SliverMend::Collapse { from: VertexId(1), into: VertexId(2) });
    let both = [(VertexId(1), [0.0, -2.0, 0.0]), (VertexId(2), [0.0, 2.0, 0.0])];
    assert_eq!(mended(&SliverTask { stood_for: &both, ..task(&mesh, 1.0) }).steps, []);
}

/// Corners at a vertex or faces that differ.
struct Differing {
    corner: Option<u32>,
    face: Option<u32>,
}

impl Attributes for Differing {
    fn corners_agree(&self, one: CornerId, other: CornerId) -> bool {
        one == other || self.corner.is_none_or(|corner| one.0 != corner && other.0 != corner)
    }
    fn faces_agree(&self, one: FaceId, other: FaceId) -> bool {
        one == other || self.face.is_none_or(|face| one.0 != face && other.0 != face)
    }
}

#[test]
fn a_vertex_on_a_seam_never_goes() {
    let mesh = needles(1.0);
    let with = |corner: Option<u32>, face: Option<u32>| {
        mended(&SliverTask { attributes: &Differing { corner, face }, ..task(&mesh, 1.0) })
    };
    // Corner 14 is at vertex 2 in face 4: the other end goes.
    let mend = with(Some(14), None).steps[0].mend;
    assert_eq!(mend, SliverMend::Collapse { from: VertexId(1), into: VertexId(2) });
    // Corner 0 is at vertex 1 in face 0: there the seam runs along the needle's edge.
    assert_eq!(reasons(&with(Some(0), None)), [(0, SliverReason::Seam), (1, SliverReason::Seam)]);
    assert_eq!(reasons(&with(None, Some(0))), [(0, SliverReason::Seam), (1, SliverReason::Seam)]);
}

/// A cap over the edge 0–1, below and above which there are two triangles.
fn cap(height: f64) -> PolygonMesh {
    mesh(
        &[[0.0, 0.0], [5e3, 0.0], [2.5e3, height], [2.5e3, -3e3], [2.5e3, 4e3]],
        &[[0, 1, 2], [1, 0, 3], [0, 2, 4], [2, 1, 4]],
    )
}

#[test]
fn a_cap_is_flipped_or_dropped() {
    let inner = cap(1.0);
    let flipped = mended(&task(&inner, 1.0));
    let flip = SliverMend::Flip { edge: [0, 1].map(VertexId), to: [2, 3].map(VertexId), with: FaceId(1) };
    assert_eq!(flipped.steps[0].mend, flip);
    let reshaped = flipped.reshaped.unwrap();
    assert_eq!(reshaped.vertices[..6], [0, 3, 2, 1, 2, 3].map(VertexId));
    assert_eq!(reshaped.origins[..6], [0, 5, 2, 3, 2, 5].map(CornerId));
    assert_eq!(reasons(&mended(&task(&inner, 0.5))), [(0, SliverReason::Move)]);
    let seam = Differing { corner: None, face: Some(1) };
    assert_eq!(
        reasons(&mended(&SliverTask { attributes: &seam, ..task(&inner, 1.0) })),
        [(0, SliverReason::Seam)]
    );
    let border =
        mesh(&[[0.0, 0.0], [5e3, 0.0], [2.5e3, 1.0], [2.5e3, 4e3]], &[[0, 1, 2], [0, 2, 3], [2, 1, 3]]);
    let dropped = mended(&task(&border, 1.0));
    assert_eq!(dropped.steps[0].mend, SliverMend::Drop);
    assert_eq!(dropped.reshaped.unwrap().is_gone, [true, false, false]);
}

#[test]
fn what_is_left_has_its_reason() {
    let lone = mesh(&[[0.0, 0.0], [5e3, 0.0], [2.5e3, 1.0]], &[[0, 1, 2]]);
    assert_eq!(reasons(&mended(&task(&lone, 9.0))), [(0, SliverReason::Boundary)]);
    // Two faces that run the same way along the long edge.
    let clashing = mesh(&[[0.0, 0.0], [5e3, 0.0], [2.5e3, 1.0], [2.5e3, -3e3]], &[[0, 1, 2], [0, 1, 3]]);
    assert_eq!(reasons(&mended(&task(&clashing, 9.0))), [(0, SliverReason::Sides)]);
    // A needle of a solid of four faces: two faces would be left, back to back.
    let points = [[0.0, 0.0, 0.0], [0.0, 0.0, 1.0], [5e3, 0.0, 0.0], [0.0, 5e3, 0.0]];
    let solid = PolygonMesh::from_triangles(&points, &[[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]).unwrap();
    assert_eq!(reasons(&mended(&task(&solid, 9.0))), [(0, SliverReason::Link), (1, SliverReason::Link)]);
    // A face of no area with four corners.
    let line = [0.0, 1.0, 2.0, 3.0].map(|x| [x, x, x]);
    let polygon = PolygonMesh::from_polygons(&line, &[0, 1, 2, 3], &[0, 4]).unwrap();
    assert_eq!(reasons(&mended(&task(&polygon, 9.0))), [(0, SliverReason::NonTriangle)]);
}

#[test]
fn one_may_be_told_to_stop() {
    let mesh = needles(1.0);
    assert!(mend_slivers(&task(&mesh, 1.0), &|| true).is_some());
    let fine: Vec<[u32; 3]> = (0..1500).map(|at| [0, at + 1, at + 2]).collect();
    let points: Vec<[f64; 2]> = (0..1502).map(|at| [f64::from(at), f64::from(at % 2) * 1e-4]).collect();
    assert!(mend_slivers(&task(&self::mesh(&points, &fine), 1.0), &|| false).is_none());
}
