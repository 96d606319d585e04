//! Each law finds the kernel that breaks it, and admission is what the definitions say.

#![allow(clippy::unwrap_used, reason = "a test stops where it fails")]

use meshmend_core::{
    Build, Capabilities, Complex, Connectivity, CornerId, Defect, DefectKind, EdgeId, EdgeUse, FaceId, Id,
    Refusal, VertexId, admission,
};
use meshmend_testkit::laws::{heap_law, kernel_laws, refusal_law};
use meshmend_testkit::shapes::{self, catalogue};
use meshmend_testkit::worlds::{any_table, oriented_triangle_sets};
use meshmend_testkit::{Soup, oracle};
use proptest::prelude::*;

/// The edge-use table with one answer made wrong, or other capabilities.
struct Broken<const WHICH: u8>(EdgeUse);

const ADMITS_ALL: u8 = 0;
const WRONG_NEXT: u8 = 1;
const WRONG_EDGE_ORDER: u8 = 2;
const LOSES_A_CORNER: u8 = 3;
const STRICT: u8 = 4;
const SAYS_ORDERED: u8 = 5;
const ENDS_SWAPPED: u8 = 6;
const NO_ACROSS: u8 = 7;
const WRONG_WAY: u8 = 8;

impl<const WHICH: u8> Connectivity for Broken<WHICH> {
    const NAME: &'static str = "broken";
    const CAPABILITIES: Capabilities = Capabilities {
        non_manifold_edges: WHICH != STRICT,
        ordered_vertex_stars: WHICH == SAYS_ORDERED,
        ..Capabilities::PERMISSIVE
    };
    fn assemble(complex: &Complex) -> Self {
        Broken(EdgeUse::assemble(complex))
    }
    fn vertex_count(&self) -> usize {
        self.0.vertex_count()
    }
    fn edge_count(&self) -> usize {
        self.0.edge_count()
    }
    fn face_count(&self) -> usize {
        self.0.face_count()
    }
    fn corner_count(&self) -> usize {
        self.0.corner_count()
    }
    fn corner_vertex(&self, corner: CornerId) -> VertexId {
        self.0.corner_vertex(corner)
    }
    fn corner_edge(&self, corner: CornerId) -> EdgeId {
        self.0.corner_edge(corner)
    }
    fn corner_face(&self, corner: CornerId) -> FaceId {
        self.0.corner_face(corner)
    }
    fn next_corner(&self, corner: CornerId) -> CornerId {
        if WHICH == WRONG_NEXT { self.0.prev_corner(corner) } else { self.0.next_corner(corner) }
    }
    fn prev_corner(&self, corner: CornerId) -> CornerId {
        self.0.prev_corner(corner)
    }
    fn edge_ends(&self, edge: EdgeId) -> [VertexId; 2] {
        let [a, b] = self.0.edge_ends(edge);
        if WHICH == ENDS_SWAPPED { [b, a] } else { [a, b] }
    }
    fn face_corners(&self, face: FaceId) -> impl Iterator<Item = CornerId> + Clone {
        self.0.face_corners(face)
    }
    fn edge_corners(&self, edge: EdgeId) -> impl Iterator<Item = CornerId> + Clone {
        let mut corners: Vec<_> = self.0.edge_corners(edge).collect();
        if WHICH == WRONG_EDGE_ORDER {
            corners.reverse();
        }
        corners.into_iter()
    }
    fn edge_sides(&self, edge: EdgeId) -> impl Iterator<Item = (CornerId, bool)> + Clone {
        self.0.edge_sides(edge).map(|(corner, way)| (corner, way && WHICH != WRONG_WAY))
    }
    fn vertex_corners(&self, vertex: VertexId) -> impl Iterator<Item = CornerId> + Clone {
        self.0.vertex_corners(vertex).skip(usize::from(WHICH == LOSES_A_CORNER && vertex.index() == 1))
    }
    fn heap_bytes(&self) -> usize {
        self.0.heap_bytes()
    }
    fn across(&self, corner: CornerId) -> Option<CornerId> {
        if WHICH == NO_ACROSS { None } else { self.0.across(corner) }
    }
}

#[test]
fn the_default_kernel_keeps_the_laws_on_shapes_and_every_small_mesh() {
    for shape in catalogue() {
        assert_eq!(kernel_laws::<EdgeUse>(&shape.soup.complex()), Ok(()), "{}", shape.name);
    }
    for faces in oriented_triangle_sets(4) {
        assert_eq!(kernel_laws::<EdgeUse>(&Soup::generic(4, &faces).complex()), Ok(()), "{faces:?}");
    }
}

#[test]
fn each_law_finds_the_kernel_that_breaks_it() {
    let cube = shapes::cube().soup.complex();
    assert_eq!(kernel_laws::<Broken<ADMITS_ALL>>(&cube), Ok(()));
    let finds = |result: Result<(), String>, what: &str| {
        let law = result.unwrap_err();
        assert!(law.contains(what), "{law}");
    };
    finds(kernel_laws::<Broken<WRONG_NEXT>>(&cube), "`next-and-prev`: next_corner(c0) is");
    finds(kernel_laws::<Broken<WRONG_EDGE_ORDER>>(&cube), "`edge-stars`: edge_corners(e0) is");
    finds(kernel_laws::<Broken<LOSES_A_CORNER>>(&cube), "`vertex-stars`: vertex_corners(v1) is");
    finds(kernel_laws::<Broken<WRONG_WAY>>(&cube), "`edge-stars`: edge_sides(e0) is");
    finds(kernel_laws::<Broken<ENDS_SWAPPED>>(&cube), "`numbering`: edge_ends(e0) is");
    finds(kernel_laws::<Broken<NO_ACROSS>>(&cube), "`across`: across(c0) is None");
    // Ascending corners of a large fan's hub are in order; those of an octahedron's are not.
    finds(
        kernel_laws::<Broken<SAYS_ORDERED>>(&shapes::octahedron().soup.complex()),
        "`rotation`: vertex_corners(v0) is",
    );
}

#[test]
fn a_strict_kernel_may_refuse_but_only_for_the_reasons_that_there_are() {
    let book = shapes::book(3).soup.complex();
    assert_eq!(kernel_laws::<Broken<STRICT>>(&book), Ok(()));
    assert!(Broken::<STRICT>::build(&book).is_err());
    assert_eq!(kernel_laws::<Broken<STRICT>>(&shapes::cube().soup.complex()), Ok(()));
}

#[test]
fn a_refusal_without_a_reason_or_with_another_is_found() {
    let book = shapes::book(3).soup.complex();
    let strict = Broken::<STRICT>::CAPABILITIES;
    let refusal = Broken::<STRICT>::build(&book).err().unwrap();
    assert_eq!(refusal_law(&refusal, "broken", &strict, &book), Ok(()));
    assert!(refusal_law(&refusal, "another", &strict, &book).is_err());
    let silent = Refusal { defects: Vec::new(), ..refusal };
    assert!(refusal_law(&silent, "broken", &strict, &book).is_err());
    let cube = shapes::cube().soup.complex();
    assert!(refusal_law(&silent, "broken", &strict, &cube).is_err());
}

#[test]
fn the_heap_law_allows_a_twentieth() {
    let law = |said: usize, measured: usize| heap_law::<EdgeUse>(said, measured);
    assert_eq!((law(1000, 1000), law(950, 1000), law(1050, 1000)), (Ok(()), Ok(()), Ok(())));
    assert!(law(949, 1000).is_err() && law(1051, 1000).is_err());
}

proptest! {
    #[test]
    fn the_default_kernel_keeps_the_laws_on_any_table(soup in any_table(12)) {
        prop_assert_eq!(kernel_laws::<EdgeUse>(&soup.complex()), Ok(()));
    }

    /// What a kernel refuses is what the definitions say, for every choice of what it admits.
    #[test]
    fn admission_is_what_the_oracle_finds(soup in any_table(10)) {
        let (complex, defects) = (soup.complex(), oracle::defects(&soup.mesh()));
        for admits in 0..32u8 {
            let [non_simple_faces, non_manifold_edges, non_manifold_vertices, mixed_orientation, polygons] =
                [0, 1, 2, 3, 4].map(|bit| admits >> bit & 1 == 1);
            let capabilities = Capabilities {
                non_simple_faces,
                non_manifold_edges,
                non_manifold_vertices,
                mixed_orientation,
                polygons,
                ordered_vertex_stars: false,
            };
            let is_outside = |defect: &&Defect| match defect.kind() {
                DefectKind::NonSimpleFace => !non_simple_faces,
                DefectKind::PolygonFace => !polygons,
                DefectKind::NonManifoldEdge => !non_manifold_edges,
                DefectKind::InconsistentEdge => !mixed_orientation,
                DefectKind::PinchedVertex | DefectKind::SingularVertex => !non_manifold_vertices,
                _ => false,
            };
            let expected: Vec<Defect> = defects.iter().filter(is_outside).cloned().collect();
            prop_assert_eq!(admission(&complex, &capabilities), expected, "{:?}", capabilities);
        }
    }
}
