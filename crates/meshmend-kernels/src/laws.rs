//! What is true of every kernel, tested for each one in the registry without naming any.
//!
//! The expected answers come from the plain face table and from a naive count that looks at every side for every
//! question; so a mistake that all kernels shared would show as well.

use std::collections::BTreeMap;
use std::sync::Arc;

use meshmend_core::{
    Complex, Connectivity, CornerId, EdgeId, FaceId, FaceTable, FaceTableBuilder, Id, VertexId, admission,
};
use proptest::prelude::*;

use crate::{KernelKind, KernelTask};

/// What the kernels should say, found the slow and plain way.
struct Oracle {
    complex: Complex,
    /// The corners on each edge, by (smaller vertex, larger vertex).
    edges: BTreeMap<[VertexId; 2], Vec<CornerId>>,
}

impl Oracle {
    fn of(faces: FaceTable) -> Self {
        let complex = Complex::of(&Arc::new(faces));
        let mut edges: BTreeMap<_, Vec<_>> = BTreeMap::new();
        for face in complex.faces().faces() {
            let vertices = complex.faces().face_vertices(face);
            for (place, corner) in complex.faces().face_corners(face).enumerate() {
                let (from, to) = (vertices[place], vertices[(place + 1) % vertices.len()]);
                edges.entry([from.min(to), from.max(to)]).or_default().push(corner);
            }
        }
        Oracle { complex, edges }
    }
}

/// Checks all that a kernel says against the oracle.
struct Laws<'a>(&'a Oracle);

impl KernelTask for Laws<'_> {
    type Output = ();

    fn run<K: Connectivity>(self, kernel: &K) {
        let Laws(oracle) = self;
        counts_are_the_tables(kernel, oracle);
        faces_are_the_tables(kernel, oracle);
        edges_are_numbered_by_their_ends(kernel, oracle);
        vertex_stars_partition_the_corners(kernel);
        corners_lead_round_their_face(kernel);
        across_is_the_other_of_two(kernel);
        if K::CAPABILITIES.ordered_vertex_stars {
            kernel.vertices().for_each(|v| the_star_is_walked_in_order(kernel, v));
        }
    }
}

fn counts_are_the_tables<K: Connectivity>(kernel: &K, oracle: &Oracle) {
    let faces = oracle.complex.faces();
    assert_eq!(kernel.vertex_count(), faces.vertex_count());
    assert_eq!(kernel.face_count(), faces.face_count());
    assert_eq!(kernel.corner_count(), faces.corner_count());
    assert_eq!(kernel.edge_count(), oracle.edges.len());
}

fn faces_are_the_tables<K: Connectivity>(kernel: &K, oracle: &Oracle) {
    let faces = oracle.complex.faces();
    for face in faces.faces() {
        let corners: Vec<_> = kernel.face_corners(face).collect();
        assert_eq!(corners, faces.face_corners(face).collect::<Vec<_>>(), "corners of {face}");
        assert!(kernel.face_vertices(face).eq(faces.face_vertices(face).iter().copied()));
        assert!(corners.iter().all(|&c| kernel.corner_face(c) == face));
        assert_eq!(
            kernel.is_proper_face(face),
            oracle.complex.degenerate_faces().binary_search(&face).is_err()
        );
    }
}

fn edges_are_numbered_by_their_ends<K: Connectivity>(kernel: &K, oracle: &Oracle) {
    for (edge, (ends, sides)) in kernel.edges().zip(&oracle.edges) {
        assert_eq!(kernel.edge_ends(edge), *ends, "ends of {edge}");
        assert_eq!(kernel.edge_corners(edge).collect::<Vec<_>>(), *sides, "sides of {edge}");
        for &side in sides {
            assert_eq!(kernel.corner_edge(side), edge, "edge of {side}");
            let (from, to) = (kernel.corner_vertex(side), kernel.corner_target(side));
            assert_eq!([from.min(to), from.max(to)], *ends);
            assert_eq!(kernel.is_forward(side), from == ends[0]);
        }
    }
}

fn vertex_stars_partition_the_corners<K: Connectivity>(kernel: &K) {
    let mut seen = vec![false; kernel.corner_count()];
    for vertex in kernel.vertices() {
        let star: Vec<_> = kernel.vertex_corners(vertex).collect();
        assert_eq!(kernel.is_referenced(vertex), !star.is_empty());
        if !K::CAPABILITIES.ordered_vertex_stars {
            assert!(star.is_sorted(), "{star:?} at {vertex}");
        }
        for corner in star {
            assert_eq!(kernel.corner_vertex(corner), vertex);
            assert!(!std::mem::replace(&mut seen[corner.index()], true), "{corner} twice");
        }
    }
    assert!(seen.into_iter().all(|seen| seen));
}

fn corners_lead_round_their_face<K: Connectivity>(kernel: &K) {
    for face in kernel.faces() {
        for (corner, next) in kernel.face_corners(face).zip(kernel.face_corners(face).cycle().skip(1)) {
            assert_eq!(kernel.next_corner(corner), next);
            assert_eq!(kernel.prev_corner(next), corner);
        }
    }
}

fn across_is_the_other_of_two<K: Connectivity>(kernel: &K) {
    for edge in kernel.edges() {
        let sides: Vec<_> = kernel.edge_corners(edge).collect();
        assert_eq!(kernel.edge_degree(edge), sides.len());
        for &side in &sides {
            let other = (sides.len() == 2).then(|| sides[usize::from(side == sides[0])]);
            assert_eq!(kernel.across(side), other, "across {side}");
        }
    }
}

/// The two edges at which a corner's umbrella goes on, clockwise one first as its own face runs.
fn edges_at<K: Connectivity>(kernel: &K, corner: CornerId) -> [EdgeId; 2] {
    [kernel.corner_edge(corner), kernel.corner_edge(kernel.prev_corner(corner))]
}

/// Walks from corner to corner over the edge between them, never over the one it came by, and checks that the star
/// begins on the boundary or at its lowest corner, and ends where it must.
fn the_star_is_walked_in_order<K: Connectivity>(kernel: &K, vertex: VertexId) {
    let star: Vec<_> = kernel.vertex_corners(vertex).collect();
    let Some((&first, &last)) = star.first().zip(star.last()) else { return };
    let lowest = (0..star.len()).min_by_key(|&place| star[place]).unwrap();
    // The direction in which the lowest corner is passed is counter-clockwise as its face runs. From there on and
    // back from there each corner is left by the edge by which it was not entered.
    let mut leaves = edges_at(kernel, star[lowest])[1];
    for &corner in &star[lowest + 1..] {
        leaves = passed(kernel, corner, leaves);
    }
    let mut enters = edges_at(kernel, star[lowest])[0];
    for &corner in star[..lowest].iter().rev() {
        enters = passed(kernel, corner, enters);
    }
    if kernel.edge_degree(enters) == 1 {
        assert_eq!(kernel.edge_degree(leaves), 1, "the fan from {first} to {last} ends on the boundary");
    } else {
        assert_eq!(lowest, 0, "a closed star begins at its lowest corner");
        assert_eq!(leaves, enters, "the star from {first} to {last} closes");
    }
}

/// The other edge of a corner that is come to over one edge.
fn passed<K: Connectivity>(kernel: &K, corner: CornerId, over: EdgeId) -> EdgeId {
    let [clockwise, counter] = edges_at(kernel, corner);
    assert!(over == clockwise || over == counter, "{corner} is not on {over}");
    if over == clockwise { counter } else { clockwise }
}

/// All laws for all kernels over a table; says how many kernels hold it.
fn obeyed(faces: FaceTable) -> usize {
    let oracle = Oracle::of(faces);
    let mut holding = 0;
    for &kind in KernelKind::ALL {
        let against = admission(&oracle.complex, &kind.capabilities());
        match kind.run(&oracle.complex, Laws(&oracle)) {
            Ok(()) => {
                assert!(against.is_empty(), "{kind} holds what it should refuse: {against:?}");
                holding += 1;
            }
            Err(refusal) => assert_eq!((refusal.kernel, refusal.defects), (kind.name(), against)),
        }
    }
    holding
}

fn permissive() -> usize {
    KernelKind::ALL.iter().filter(|kind| kind.capabilities().is_permissive()).count()
}

fn table(vertices: usize, faces: &[Vec<u32>]) -> FaceTable {
    let mut builder = FaceTableBuilder::default();
    faces.iter().for_each(|face| builder.push_face(face.iter().copied().map(VertexId)));
    builder.build(vertices).unwrap()
}

fn faces<const N: usize>(list: &[[u32; N]]) -> Vec<Vec<u32>> {
    list.iter().map(|face| face.to_vec()).collect()
}

/// Quads over a grid of columns × rows vertices whose opposite rims are glued, the columns' mirrored on request.
fn glued_grid(columns: u32, rows: u32, mirrored: Seam) -> Vec<Vec<u32>> {
    let vertex = |x: u32, y: u32| {
        let y = if x == columns && mirrored == Seam::Mirrored { rows - y % rows } else { y };
        y % rows * columns + x % columns
    };
    let cell = |x, y| vec![vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1), vertex(x, y + 1)];
    (0..rows).flat_map(|y| (0..columns).map(move |x| (x, y))).map(|(x, y)| cell(x, y)).collect()
}

#[derive(Clone, Copy, PartialEq)]
enum Seam {
    Plain,
    Mirrored,
}

const TETRAHEDRON: [[u32; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];

#[test]
fn every_set_of_triangles_on_four_vertices() {
    let both_ways: Vec<Vec<u32>> =
        faces(&TETRAHEDRON).into_iter().flat_map(|f| [f.clone(), vec![f[0], f[2], f[1]]]).collect();
    let mut all_hold = 0;
    for chosen in 0u32..1 << both_ways.len() {
        let set: Vec<_> =
            (0..both_ways.len()).filter(|i| chosen >> i & 1 == 1).map(|i| both_ways[i].clone()).collect();
        all_hold += usize::from(obeyed(table(4, &set)) == KernelKind::ALL.len());
    }
    // None; one, 8; two that agree, 4 doubled and 12 of the 24 pairs of different ones; three, 8; four, 2.
    assert_eq!(all_hold, 1 + 8 + (4 + 12) + 8 + 2);
}

#[test]
fn closed_surfaces_are_held_by_all_kernels_for_which_they_are_oriented() {
    let all = KernelKind::ALL.len();
    assert_eq!(obeyed(table(4, &faces(&TETRAHEDRON))), all);
    assert_eq!(obeyed(table(12, &glued_grid(3, 4, Seam::Plain))), all);
    let mixed = KernelKind::ALL.iter().filter(|kind| kind.capabilities().mixed_orientation).count();
    assert!(permissive() < mixed && mixed < all);
    assert_eq!(obeyed(table(20, &glued_grid(4, 5, Seam::Mirrored))), mixed, "a Klein bottle");
    let band: Vec<_> = (0..5).map(|i| vec![i, (i + 1) % 5, (i + 2) % 5]).collect();
    assert_eq!(obeyed(table(5, &band)), mixed, "a Moebius band");
    let projective_plane = [
        [0, 1, 2],
        [0, 2, 3],
        [0, 3, 4],
        [0, 4, 5],
        [0, 5, 1],
        [1, 2, 4],
        [2, 3, 5],
        [3, 4, 1],
        [4, 5, 2],
        [5, 1, 3],
    ];
    assert_eq!(obeyed(table(6, &faces(&projective_plane))), mixed, "the projective plane");
}

#[test]
fn solids_that_touch_are_held_by_permissive_kernels_alone() {
    let renamed = |names: [u32; 4]| faces(&TETRAHEDRON.map(|face| face.map(|v| names[v as usize])));
    let both = |names| [faces(&TETRAHEDRON), renamed(names)].concat();
    assert_eq!(obeyed(table(7, &both([0, 4, 5, 6]))), permissive(), "at a vertex");
    assert_eq!(obeyed(table(6, &both([0, 1, 4, 5]))), permissive(), "along an edge");
    assert_eq!(obeyed(table(8, &both([4, 5, 6, 7]))), KernelKind::ALL.len(), "nowhere");
}

#[test]
fn polygons_unreferenced_vertices_and_degenerate_faces() {
    let all = KernelKind::ALL.len();
    assert_eq!(obeyed(table(0, &[])), all);
    assert_eq!(obeyed(table(3, &[])), all);
    assert_eq!(obeyed(table(3, &[vec![], vec![1], vec![0, 1, 0]])), all);
    let prism = [vec![0, 2, 1], vec![3, 4, 5], vec![0, 1, 4, 3], vec![1, 2, 5, 4], vec![2, 0, 3, 5]];
    assert_eq!(obeyed(table(9, &prism)), all);
    assert_eq!(obeyed(table(9, &[vec![], vec![8, 1, 5, 3, 2], vec![7, 7, 7], vec![5, 1, 1, 0]])), all);
}

#[test]
fn faces_that_come_back_to_a_vertex_or_an_edge() {
    let all = KernelKind::ALL.len();
    let strict_about = |face: Vec<u32>| all - obeyed(table(6, &[face]));
    assert!(strict_about(vec![0, 1, 2, 3, 2]) > 0, "a spike");
    assert!(strict_about(vec![0, 1, 2, 0, 1, 3]) > 0, "glued to itself the same way");
    assert_eq!(strict_about(vec![0, 1, 2, 0, 3, 4]), all - permissive(), "two fans at v0");
    // The rim of an annulus with a slit, and a second face that fills the ring's inside.
    assert!(obeyed(table(6, &[vec![0, 1, 2, 0, 3, 4, 5, 3], vec![3, 5, 4]])) > permissive());
}

#[test]
fn crowded_elements_are_handled_in_near_linear_time() {
    let count = 100_000u32;
    let book: Vec<_> = (2..count).map(|v| vec![0, 1, v]).collect();
    assert_eq!(obeyed(table(count as usize, &book)), permissive());
    let cone: Vec<_> = (1..count).map(|v| vec![0, v, v % (count - 1) + 1]).collect();
    assert_eq!(obeyed(table(count as usize, &cone)), KernelKind::ALL.len());
    let rim: Vec<_> = (0..count).collect();
    assert_eq!(obeyed(table(count as usize, &[rim])), KernelKind::ALL.len());
}

/// A manifold with pieces turned over and corners rotated, so that strict kernels see more than tidy meshes.
pub(crate) fn damaged_grid() -> impl Strategy<Value = FaceTable> {
    let damage = || prop::collection::vec((any::<bool>(), prop::bool::weighted(0.85), 0usize..4), 30);
    (3u32..6, 3u32..6, any::<bool>(), any::<bool>(), damage()).prop_map(
        |(columns, rows, mirrored, turned, damage)| {
            let seam = if mirrored { Seam::Mirrored } else { Seam::Plain };
            let mut grid = glued_grid(columns, rows, seam);
            for (face, &(turn, _, rotation)) in grid.iter_mut().zip(&damage) {
                if turn && turned {
                    face.reverse();
                }
                face.rotate_left(rotation);
            }
            let kept: Vec<_> =
                grid.into_iter().zip(&damage).filter(|(_, keep)| keep.1).map(|(face, _)| face).collect();
            table((columns * rows) as usize, &kept)
        },
    )
}

fn soup() -> impl Strategy<Value = FaceTable> {
    let face = || prop::collection::vec(0u32..8, 0..8);
    prop::collection::vec(face(), 0..8).prop_map(|faces| table(8, &faces))
}

/// One or two faces with many corners on few vertices: strict kernels hold some of them.
pub(crate) fn self_touching() -> impl Strategy<Value = FaceTable> {
    prop::collection::vec(prop::collection::vec(0u32..6, 3..7), 1..3).prop_map(|faces| table(6, &faces))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, ..Default::default() })]

    #[test]
    fn soups(faces in soup()) {
        prop_assert!(obeyed(faces) >= permissive());
    }

    #[test]
    fn damaged_grids(faces in damaged_grid()) {
        prop_assert!(obeyed(faces) >= permissive());
    }

    #[test]
    fn faces_that_touch_themselves(faces in self_touching()) {
        prop_assert!(obeyed(faces) >= permissive());
    }
}

/// All that one kernel says, as text, with vertex stars sorted.
struct Answers;

impl KernelTask for Answers {
    type Output = Vec<String>;

    fn run<K: Connectivity>(self, kernel: &K) -> Vec<String> {
        let sorted = |mut corners: Vec<CornerId>| {
            corners.sort_unstable();
            corners
        };
        let corner = |c| format!("{c} {} {:?}", kernel.corner_vertex(c), kernel.across(c));
        let face = |f: FaceId| format!("{f} {:?}", kernel.face_corners(f).collect::<Vec<_>>());
        let edge =
            |e| format!("{e} {:?} {:?}", kernel.edge_ends(e), kernel.edge_faces(e).collect::<Vec<_>>());
        let vertex = |v| format!("{v} {:?}", sorted(kernel.vertex_corners(v).collect()));
        let elements = kernel.corners().map(corner).chain(kernel.faces().map(face));
        elements.chain(kernel.edges().map(edge)).chain(kernel.vertices().map(vertex)).collect()
    }
}

#[test]
fn all_kernels_give_the_same_answers() {
    let complex = Complex::of(&Arc::new(table(12, &glued_grid(3, 4, Seam::Plain))));
    let expected = KernelKind::default().run(&complex, Answers).unwrap();
    for kind in KernelKind::ALL {
        assert_eq!(kind.run(&complex, Answers).unwrap(), expected, "{kind}");
    }
}
