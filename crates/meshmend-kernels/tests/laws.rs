//! Every kernel keeps every law of kernels, over meshes of all kinds, and holds just the meshes that it says it holds.
//!
//! No kernel is named here: what is in the registry is tested.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test stops where it fails")]

use std::collections::BTreeMap;

use meshmend_core::{Capabilities, Complex, Connectivity, Cost, Refusal};
use meshmend_kernels::*;
use meshmend_testkit::oracle::{self, OracleReport};
use meshmend_testkit::shapes::{self, Tiles};
use meshmend_testkit::{Soup, laws, worlds};
use proptest::prelude::*;

macro_rules! kept_by {
    ($($module:ident::$kernel:ident,)*) => {
        meshmend_conformance::kernel!(edge_use: EdgeUse, at_least = PERMISSIVE);
        $(meshmend_conformance::kernel!($module: $kernel, at_least = TRIANGLES);)*
    };
}

// A test for each law of each kernel, over every small mesh.
meshmend_kernels::every_kernel!(kept_by);

/// How many random meshes each law is asked about.
const CASES: u32 = if cfg!(miri) { 2 } else { 1500 };

/// The laws of the kernel that was chosen.
struct Laws<'a>(&'a Complex);

impl KernelTask for Laws<'_> {
    type Output = Result<(), String>;
    fn run<K: Connectivity>(self, _: &K) -> Self::Output {
        laws::kernel_laws::<K>(self.0)
    }
}

/// The kernels that hold a complex; each of them keeps all laws, and each other one refuses as it should.
fn holders(complex: &Complex) -> Vec<KernelKind> {
    holders_among(KernelKind::ALL, complex)
}

fn holders_among(kinds: &[KernelKind], complex: &Complex) -> Vec<KernelKind> {
    let holds = |kind: &KernelKind| match kind.run(complex, Laws(complex)) {
        Ok(kept) => {
            assert_eq!(kept, Ok(()), "{kind}");
            true
        }
        Err(refusal) => {
            assert_eq!(lawful(&refusal, *kind, complex), Ok(()));
            false
        }
    };
    kinds.iter().copied().filter(holds).collect()
}

fn lawful(refusal: &Refusal, kind: KernelKind, complex: &Complex) -> Result<(), String> {
    laws::refusal_law(refusal, kind.name(), &kind.capabilities(), complex)
}

/// Checks the laws, and that those kernels hold the mesh that admit all that the oracle finds in it.
fn assert_lawful(soup: &Soup) -> Vec<KernelKind> {
    let (found, complex) = (oracle::report(soup), soup.complex());
    let has_polygons = complex.faces().faces().any(|face| complex.faces().corner_range(face).len() > 3);
    let holders = holders(&complex);
    assert_eq!(holders, admitting(|capabilities| is_within(&found, has_polygons, capabilities)), "{soup:?}");
    holders
}

fn is_within(found: &OracleReport, has_polygons: bool, capabilities: &Capabilities) -> bool {
    let vertices = found.non_manifold_vertices.pinched + found.non_manifold_vertices.singular;
    (found.non_simple_faces == 0 || capabilities.non_simple_faces)
        && (found.non_manifold_edges == 0 || capabilities.non_manifold_edges)
        && (vertices == 0 || capabilities.non_manifold_vertices)
        && (found.consistently_oriented || capabilities.mixed_orientation)
        && (!has_polygons || capabilities.polygons)
}

fn admitting(admits: impl Fn(&Capabilities) -> bool) -> Vec<KernelKind> {
    KernelKind::ALL.iter().copied().filter(|kind| admits(&kind.capabilities())).collect()
}

#[test]
fn every_shape() {
    let mut held: BTreeMap<KernelKind, usize> = BTreeMap::new();
    let mut catalogue = shapes::catalogue();
    if cfg!(miri) {
        catalogue.retain(|shape| shape.soup.faces.len() <= 8);
    }
    for shape in &catalogue {
        for kind in assert_lawful(&shape.soup) {
            *held.entry(kind).or_default() += 1;
        }
    }
    for (kind, count) in &held {
        assert_eq!(*count == catalogue.len(), kind.capabilities().is_permissive(), "{kind} holds {count}");
    }
    assert_eq!(held.len(), KernelKind::ALL.len(), "every kernel holds something: {held:?}");
}

/// Each of the four triangles over four vertices absent, one way round, the other, or both.
#[test]
#[cfg_attr(miri, ignore = "all 256 take an interpreter an hour; the other cases run the same code")]
fn every_set_of_triangles_over_four_vertices() {
    let triangles = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
    let both_ways: Vec<[u32; 3]> =
        triangles.into_iter().flat_map(|[a, b, c]| [[a, b, c], [a, c, b]]).collect();
    let mut held_by_all = 0;
    for chosen in 0u32..1 << both_ways.len() {
        let set = (0..both_ways.len()).filter(|i| chosen >> i & 1 == 1).map(|i| both_ways[i]);
        held_by_all += usize::from(assert_lawful(&Soup::generic(4, set)).len() == KernelKind::ALL.len());
    }
    // None; one, 8; two that agree, 4 doubled and 12 of the 24 pairs of different ones; three, 8; four, 2.
    assert_eq!(held_by_all, 1 + 8 + (4 + 12) + 8 + 2);
}

#[test]
fn what_is_no_face_and_no_vertex_of_the_complex() {
    let all = KernelKind::ALL;
    assert_eq!(assert_lawful(&Soup::generic(0, [[0; 0]; 0])), all);
    assert_eq!(assert_lawful(&Soup::generic(3, [[0; 0]; 0])), all);
    assert_eq!(assert_lawful(&Soup::generic(3, [&[][..], &[1], &[0, 1, 0]])), all);
    let between = [&[][..], &[8, 1, 5, 3, 2], &[7, 7, 7], &[5, 1, 1, 0]];
    assert_eq!(assert_lawful(&Soup::generic(9, between)), admitting(|c| c.polygons));
}

#[test]
fn faces_that_touch_themselves() {
    let holders = |face: &[u32]| assert_lawful(&Soup::generic(6, [face]));
    assert_eq!(holders(&[0, 1, 2, 3, 2]), admitting(|c| c.non_simple_faces && c.polygons), "a spike");
    let glued = admitting(|c| c.non_simple_faces && c.polygons && c.mixed_orientation);
    assert_eq!(holders(&[0, 1, 2, 0, 1, 3]), glued, "glued to itself the same way");
    let touching = admitting(|c| c.non_simple_faces && c.polygons && c.non_manifold_vertices);
    assert_eq!(holders(&[0, 1, 2, 0, 3, 4]), touching, "two fans at one vertex");
    // The rim of an annulus with a slit, and a second face that fills the ring's inside.
    let ring = [&[0, 1, 2, 0, 3, 4, 5, 3][..], &[3, 5, 4]];
    assert_eq!(assert_lawful(&Soup::generic(6, ring)), admitting(|c| c.non_simple_faces && c.polygons));
}

/// Crowded edges, vertices and faces: a quadratic step shows by never ending. Kernels that say that a star is a search
/// are asked about fewer.
#[test]
fn crowded_elements() {
    let size = if cfg!(miri) { 12 } else { 100_000 };
    let (searched, all): (Vec<KernelKind>, Vec<KernelKind>) =
        KernelKind::ALL.iter().partition(|kind| kind.costs().vertex_star == Cost::Linear);
    crowded(size, if cfg!(miri) { 3 } else { 300 }, &all);
    crowded(size.min(1000), if cfg!(miri) { 3 } else { 20 }, &searched);
}

fn crowded(size: usize, around: usize, all: &[KernelKind]) {
    let holders = |complex: &Complex| holders_among(all, complex);
    let admitting = |admits: fn(&Capabilities) -> bool| {
        all.iter().copied().filter(|kind| admits(&kind.capabilities())).collect::<Vec<_>>()
    };
    let triangles = |soup: &Soup| holders(&soup.complex());
    assert_eq!(triangles(&shapes::book(size).soup), admitting(Capabilities::is_permissive));
    assert_eq!(triangles(&shapes::fan(size).soup), all);
    assert_eq!(triangles(&shapes::strip(size).soup), all);
    assert_eq!(holders(&shapes::polygon(size).soup.complex()), admitting(|c| c.polygons));
    assert_eq!(holders(&shapes::torus(around, around, Tiles::Triangles).soup.complex()), all);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: CASES, ..ProptestConfig::default() })]

    #[test]
    fn soups(soup in worlds::any_table(10)) {
        assert_lawful(&soup);
    }

    #[test]
    fn damaged_grids(soup in worlds::damaged_grid()) {
        assert_lawful(&soup);
    }

    #[test]
    fn touching_faces(soup in worlds::self_touching()) {
        assert_lawful(&soup);
    }

    #[test]
    fn damaged_shapes((_, _, soup) in worlds::damaged_shape()) {
        assert_lawful(&soup);
    }
}
