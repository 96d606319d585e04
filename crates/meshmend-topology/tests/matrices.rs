//! Matrices say what kernels and reports say, over every small mesh, shapes with known answers, and random tables.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test stops where it fails")]

use meshmend_core::{
    Adjacency, Build, Cell, Column, Complex, Connectivity, EdgeClass, EdgeUse, FaceId, Id, Incidence,
    PolygonMesh, VertexClass, VertexId, edge_class, vertex_classes,
};
use meshmend_kernels::{AdjacencyLists, KernelKind, KernelTask};
use meshmend_testkit::shapes::{self, Shape};
use meshmend_testkit::{Soup, worlds};
use meshmend_topology::matrices::{
    CellSet, Field, Graph, IncidenceMatrices, Prime, closure, component_count, distances, link,
    triangle_count, walks,
};
use meshmend_topology::{betti, components, patches};
use proptest::prelude::*;

/// All that a structure says about what touches what.
#[derive(Debug, PartialEq, Eq)]
struct Sets {
    counts: [usize; 3],
    ends: Vec<[u32; 2]>,
    edges_at: Vec<Vec<u32>>,
    neighbours: Vec<Vec<u32>>,
    faces_along: Vec<Vec<u32>>,
    edges_of: Vec<Vec<u32>>,
}

fn sets(view: &impl Incidence) -> Sets {
    let counts @ [vertices, edges, faces] = view.cell_counts();
    assert_eq!(view.graph_counts(), [vertices, edges]);
    Sets {
        counts,
        ends: (0..edges).map(|e| view.ends(Id::new(e)).map(|v| v.0)).collect(),
        edges_at: (0..vertices).map(|v| view.edges_at(Id::new(v)).map(|e| e.0).collect()).collect(),
        neighbours: neighbours(view),
        faces_along: (0..edges).map(|e| view.faces_along(Id::new(e)).map(|f| f.0).collect()).collect(),
        edges_of: (0..faces).map(|f| view.edges_of(Id::new(f)).map(|e| e.0).collect()).collect(),
    }
}

fn neighbours(view: &impl Adjacency) -> Vec<Vec<u32>> {
    (0..view.graph_counts()[0]).map(|v| view.neighbours(Id::new(v)).map(|n| n.0).collect()).collect()
}

struct SetsOfKernel;

impl KernelTask for SetsOfKernel {
    type Output = Sets;
    fn run<K: Connectivity>(self, kernel: &K) -> Sets {
        sets(kernel)
    }
}

/// The matrices touch what each kernel that holds the mesh says, and so does the graph.
fn assert_sets(complex: &Complex, kernels: &[KernelKind]) {
    let (matrices, graph) = (IncidenceMatrices::of(complex), Graph::of(complex));
    let found = sets(&matrices);
    assert_eq!(neighbours(&graph), found.neighbours);
    for kernel in kernels {
        if let Ok(expected) = kernel.run(complex, SetsOfKernel) {
            assert_eq!(found, expected, "{kernel}");
        }
    }
    for v in 0..found.counts[0] {
        assert_eq!(graph.degree(VertexId::new(v)), found.edges_at[v].len());
    }
    assert!(matrices.boundary_of_boundary_is_zero());
    assert_eq!(matrices.heap_bytes(), matrices.arrays().iter().map(|array| array.bytes()).sum::<usize>());
}

/// The ranks give the numbers that the report has, and the graph as many parts.
fn assert_homology(complex: &Complex) {
    let kernel = EdgeUse::assemble(complex);
    let (parts, matrices) = (components(&kernel), IncidenceMatrices::of(complex));
    let expected = betti(&kernel, &parts, &patches(&kernel));
    let over = |field| Some(matrices.betti(field).unwrap().map(|number| number as u64));
    assert_eq!(over(Field::Modulo(Prime::TWO)), expected.z2);
    assert_eq!(over(Field::Rationals), expected.q);
    assert_eq!(component_count(&Graph::of(complex)), parts.count());
}

/// The boundary of all faces are the edges with one side.
fn assert_boundary(complex: &Complex) {
    let (kernel, matrices) = (EdgeUse::assemble(complex), IncidenceMatrices::of(complex));
    let faces = kernel.faces().filter(|&face| matrices.is_proper(face)).map(Cell::from);
    let all = closure(&matrices, &CellSet::of(faces));
    if all.is_empty() {
        assert_eq!(matrices.boundary(&all), None);
        return;
    }
    let expected: Vec<_> =
        kernel.edges().filter(|&e| edge_class(&kernel, e) == EdgeClass::Boundary).collect();
    assert_eq!(matrices.boundary(&all).unwrap().edges(), expected);
}

/// In a mesh of different triangles a vertex is a disc or half-disc just when its link is one cycle or one path.
fn assert_links(complex: &Complex) {
    let (kernel, matrices) = (EdgeUse::assemble(complex), IncidenceMatrices::of(complex));
    for (vertex, class) in vertex_classes(&kernel).iter() {
        let link = link(&matrices, &CellSet::of([vertex.into()]));
        assert_eq!(link, self::link(&kernel, &CellSet::of([vertex.into()])));
        let expected = match class {
            VertexClass::Disc => Some(true),
            VertexClass::HalfDisc => Some(false),
            _ => None,
        };
        assert_eq!(is_one_cycle(&matrices, &link), expected, "{vertex}");
    }
}

/// Whether edges are one cycle; `None` if they are neither one cycle nor one path.
fn is_one_cycle(matrices: &IncidenceMatrices, link: &CellSet) -> Option<bool> {
    let degree = |vertex: VertexId| {
        let edges = link.edges().iter().filter(|&&edge| matrices.ends(edge).contains(&vertex));
        edges.count()
    };
    let degrees: Vec<usize> = link.vertices().iter().map(|&vertex| degree(vertex)).collect();
    let ends = degrees.iter().filter(|&&degree| degree == 1).count();
    if link.edges().is_empty() || degrees.iter().any(|degree| !(1..=2).contains(degree)) {
        return None;
    }
    // Paths and cycles: a path has one vertex more than edges.
    let mut reached = vec![link.vertices()[0]];
    let mut at = 0;
    while at < reached.len() {
        let here =
            link.edges().iter().map(|&edge| matrices.ends(edge)).filter(|ends| ends.contains(&reached[at]));
        let others: Vec<VertexId> = here.flatten().filter(|other| !reached.contains(other)).collect();
        reached.extend(others);
        at += 1;
    }
    (reached.len() == link.vertices().len()).then_some(ends == 0)
}

/// Distances, walks and cycles of three edges agree with one another.
fn assert_walks(complex: &Complex) {
    let graph = Graph::of(complex);
    let [vertex_count, _] = graph.graph_counts();
    let mut closed = 0;
    for v in (0..vertex_count).map(VertexId::new) {
        let powers: Vec<Column<VertexId, u128>> = (0..6).map(|n| walks(&graph, n, v).unwrap()).collect();
        closed += powers[3][v];
        for (other, &distance) in distances(&graph, v).iter() {
            let first = powers.iter().position(|power| power[other] > 0).map(|n| n as u32);
            assert_eq!(first, distance.filter(|&distance| distance < 6));
        }
    }
    assert_eq!(closed, 6 * u128::from(triangle_count(&graph)));
}

#[test]
fn every_small_mesh() {
    for faces in worlds::oriented_triangle_sets(4) {
        assert_sets(&Soup::generic(4, faces).complex(), KernelKind::ALL);
    }
    for faces in worlds::oriented_triangle_sets(5) {
        let complex = Soup::generic(5, faces).complex();
        let lists = AdjacencyLists::assemble(&complex);
        let matrices = IncidenceMatrices::of(&complex);
        assert_eq!(sets(&matrices), sets(&lists));
        assert!(matrices.boundary_of_boundary_is_zero());
        assert_homology(&complex);
    }
}

/// Which way a triangle runs changes no set.
#[test]
fn every_small_mesh_without_directions() {
    for faces in worlds::triangle_sets(5) {
        let complex = Soup::generic(5, faces).complex();
        assert_links(&complex);
        assert_boundary(&complex);
        assert_walks(&complex);
    }
}

#[test]
fn shapes_with_known_answers() {
    for Shape { soup, truth, name, .. } in shapes::catalogue() {
        let complex = soup.complex();
        assert_sets(&complex, KernelKind::ALL);
        assert_boundary(&complex);
        let matrices = IncidenceMatrices::of(&complex);
        assert_eq!(matrices.betti(Field::Modulo(Prime::TWO)), Ok(truth.betti_z2), "{name}");
        if let Ok(found) = matrices.betti(Field::Rationals) {
            assert_eq!(found, truth.betti_q, "{name}");
        }
    }
}

#[test]
fn the_seven_vertex_torus_has_35_cycles_of_three_edges_and_14_faces() {
    let shape = seven_vertex_torus();
    let complex = shape.complex();
    assert_eq!(triangle_count(&Graph::of(&complex)), 35);
    assert_eq!(IncidenceMatrices::of(&complex).cell_counts(), [7, 21, 14]);
}

/// Möbius's torus: the faces {i, i+1, i+3} and {i, i+3, i+2} modulo 7.
fn seven_vertex_torus() -> Soup {
    let faces = (0..7u32).flat_map(|i| [[i, i + 1, i + 3], [i, i + 3, i + 2]]);
    Soup::generic(7, faces.map(|face| face.map(|v| v % 7).to_vec()))
}

/// A degenerate face has a number, no side, and is not in the complex.
#[test]
fn degenerate_faces_and_lone_vertices_are_not_in_the_complex() {
    let soup = Soup::generic(6, [vec![0, 1, 2], vec![3, 3, 4], vec![], vec![0, 0, 2, 1]]);
    let matrices = IncidenceMatrices::of(&soup.complex());
    assert_eq!(matrices.cell_counts(), [6, 3, 4]);
    let proper: Vec<bool> = (0..4).map(|f| matrices.is_proper(FaceId(f))).collect();
    assert_eq!(proper, [true, false, false, true]);
    assert_eq!(matrices.betti(Field::Rationals), Ok([1, 0, 1]));
}

/// A face all of whose sides cancel has no entry, and is a face all the same: a sphere, folded flat.
#[test]
fn a_face_that_cancels_is_a_cycle() {
    let complex = Soup::generic(3, [vec![0, 1, 2, 1]]).complex();
    let matrices = IncidenceMatrices::of(&complex);
    assert_eq!((matrices.entry_counts(), matrices.lost_sides().len()), ([4, 0], 2));
    assert_homology(&complex);
    assert_sets(&complex, KernelKind::ALL);
}

fn on_mesh(mesh: &PolygonMesh) {
    assert_sets(mesh.complex(), KernelKind::ALL);
    assert_homology(mesh.complex());
    assert_boundary(mesh.complex());
    assert!(EdgeUse::build(mesh.complex()).is_ok());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    #[test]
    fn random_tables(soup in worlds::any_table(12)) {
        on_mesh(&soup.mesh());
        assert_walks(&soup.complex());
    }

    #[test]
    fn faces_that_touch_themselves(soup in worlds::self_touching()) {
        on_mesh(&soup.mesh());
    }

    #[test]
    fn damaged_shapes((_, _, soup) in worlds::damaged_shape()) {
        assert_sets(&soup.complex(), KernelKind::ALL);
        assert_boundary(&soup.complex());
    }
}
