//! Every defect, with what it says.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "these are tests")]

use meshmend_core::{Aspect, Defect, EdgeId, FaceId, Lie, Unjudged, VertexId};

#[test]
fn every_defect_says_where_it_is() {
    let (face, edge, vertex, ends) = (FaceId(1), EdgeId(2), VertexId(3), [VertexId(3), VertexId(4)]);
    let pinched = |boundary_only| Defect::pinched_vertex(vertex, 2, boundary_only);
    let cases = vec![
        (Defect::degenerate_face(face), "f1 has fewer than three different vertices"),
        (Defect::non_simple_face(face, vertex), "f1 comes back to v3"),
        (Defect::face_with_hole(face, vertex), "f1 comes back to v3 round a hole"),
        (Defect::crossing_face(face, vertex), "f1 comes back to v3 and crosses itself"),
        (Defect::repeated_corner(face, vertex), "f1 repeats v3"),
        (Defect::duplicate_face(face, FaceId(0)), "f1 is f0 again"),
        (Defect::opposite_face(face, FaceId(0)), "f1 is f0 the other way round"),
        (
            Defect::differing_face(
                face,
                FaceId(0),
                [Aspect::TexCoord, Aspect::Material].into_iter().collect(),
            ),
            "f1 is f0 again, but for material and texcoord",
        ),
        (Defect::polygon_face(face, 4), "f1 has 4 corners"),
        (Defect::non_finite_face(face, vertex), "f1 uses v3, which is not finite"),
        (Defect::boundary_edge(edge, ends), "e2 v3-v4 has one side"),
        (Defect::non_manifold_edge(edge, ends, 3), "e2 v3-v4 has 3 sides"),
        (Defect::inconsistent_edge(edge, ends), "e2 v3-v4 has both sides running the same way"),
        (Defect::seam_edge(edge, ends), "e2 v3-v4 is cut open"),
        (Defect::coincident_edges(ends), "several edges would join v3-v4"),
        (pinched(true), "v3 joins 2 umbrellas, all open"),
        (pinched(false), "v3 joins 2 umbrellas"),
        (Defect::singular_vertex(vertex), "v3 is on a non-manifold edge"),
        (Defect::non_finite_vertex(vertex), "v3 is not finite"),
        (Defect::unreferenced_vertex(vertex), "v3 is in no face"),
        (Defect::coincident_vertex(vertex, VertexId(0)), "v3 is where v0 is"),
        (Defect::loose_edge(5, ends), "loose edge 5 joins v3-v4"),
        (Defect::loose_point(6, vertex), "loose point 6 at v3"),
        (
            Defect::non_orientable_patch(vec![face; 2], vec![edge; 2]),
            "a strip of 2 faces from f1 comes back reversed",
        ),
        (
            Defect::non_orientable_patch(vec![face], Vec::new()),
            "a strip of 1 face from f1 comes back reversed",
        ),
        (Defect::unjudged_patch(face, 1, Unjudged::Open), "the patch of f1, 1 face in all, is open"),
        (
            Defect::unjudged_patch(face, 2, Unjudged::NoVolume),
            "the patch of f1, 2 faces in all, encloses no volume",
        ),
        (Defect::turned_cavity(face, 12), "the closed patch of f1, 12 faces in all, is inside another"),
        (Defect::crossing_faces(FaceId(0), face, Lie::Overlapping), "f0 and f1 overlap in one plane"),
        (Defect::coincident_faces(face, FaceId(0)), "f1 lies on f0"),
        (Defect::touching_faces(FaceId(0), face, Lie::EdgeFace), "f0 and f1 touch: edge-face"),
        (Defect::self_crossing_face(face), "f1 crosses itself"),
        (Defect::t_junction(VertexId(9), edge, ends, true), "v9 lies on e2 v3-v4 (aligned)"),
        (Defect::internal_face(face), "f1 is inside on both sides"),
        (Defect::internal_component(face, 4), "the component of f1, 4 faces in all, is inside others"),
        (Defect::zero_area_face(face), "f1 has no area"),
        (Defect::sliver_face(face, Lie::Needle), "f1 is a needle"),
        (Defect::inside_out_component(face, 12), "the component of f1, 12 faces in all, looks inward"),
        (
            Defect::solid_within(face, 12),
            "the component of f1, 12 faces in all, lies inside another and looks outward",
        ),
        (Defect::no_volume(face, 2), "the component of f1, 2 faces in all, encloses no volume"),
        (
            Defect::undecided_component(face, 1),
            "the component of f1, 1 face in all, is seen as much from one side as from the other",
        ),
        (Defect::small_component(face, 4), "f1 belongs to a component under the limit, 4 faces in all"),
    ];
    for (defect, text) in cases {
        assert_eq!(defect.to_string(), text);
    }
}
