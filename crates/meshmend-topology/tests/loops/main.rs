//! Generators and cut graphs of shapes with known answers, judged by what proves them: paths, ranks, and trees of
//! faces that cross no path.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "these are tests")]

use std::collections::{BTreeMap, BTreeSet};

use meshmend_core::{Connectivity, EdgeId, EdgeUse, VertexId};
use meshmend_kernels::{KernelKind, KernelTask};
use meshmend_testkit::Soup;
use meshmend_testkit::shapes::{self, Closed, Shape, Tiles};
use meshmend_topology::{
    CoTree, CutGraph, GeneratorError, GeneratorKind, GeneratorOptions, Roots, Surface, cut_graph, generators,
};

mod paths;
mod shortest;

use paths::{GREEDY, assert_independent, assert_pairing, face_boundary, kernel, parts_beside, paths, rank};
use shortest::{random_lengths, small_surfaces};

const BOTH: [GeneratorOptions<'static>; 2] =
    [GeneratorOptions { lengths: None, co_tree: CoTree::Lowest, roots: Roots::Lowest, watch: None }, GREEDY];

/// Everything that holds of the generators and the cut graph of a shape that is a surface.
fn assert_surface(shape: &Shape, options: &GeneratorOptions<'_>) {
    let (mesh, truth) = (shape.soup.mesh(), &shape.truth);
    let kernel = kernel(&mesh);
    let found = generators(&kernel, options).unwrap();
    let [component] = found.components() else { panic!("{}", shape.name) };
    let (closed, boundary) = paths(&kernel, &found);
    let holes = truth.boundary_loops.unwrap();
    let (genus, cross_caps) = (truth.genus.unwrap_or(0), truth.cross_caps.unwrap_or(0));
    assert_eq!(closed.len(), 2 * genus + cross_caps, "{}", shape.name);
    assert_eq!(boundary.len(), holes.saturating_sub(1), "{}", shape.name);
    assert_eq!(closed.len() + boundary.len(), truth.betti_z2[1], "{}", shape.name);
    let kind = if truth.orientable { GeneratorKind::Handle } else { GeneratorKind::CrossCap };
    assert!(component.generators[..closed.len()].iter().all(|generator| generator.kind == kind));
    let one_sided = component.generators.iter().filter(|generator| !generator.is_two_sided).count();
    assert!(if truth.orientable { one_sided == 0 } else { one_sided > 0 }, "{}", shape.name);
    assert_eq!((component.obstacle.is_none(), component.system.is_some()), (true, true));
    assert_independent(&kernel, &closed, 1);
    assert_pairing(&kernel, &found, &closed);
    assert!(found.loop_edges().into_iter().eq(closed.iter().flatten().copied().collect::<BTreeSet<_>>()));
    if truth.faces < 200 {
        let faces: Vec<_> = kernel.faces().map(|face| face_boundary(&kernel, face)).collect();
        let with_paths = rank(faces.iter().cloned().chain(closed).chain(boundary));
        assert_eq!(with_paths, rank(faces) + truth.betti_z2[1], "{}", shape.name);
    }
    assert_cut_graph(shape, &kernel, &cut_graph(&kernel, options).unwrap());
}

/// A cut graph has what makes its complement a disc: χ less by one, all faces together beside it, and no blind end
/// but a sphere's two.
fn assert_cut_graph(shape: &Shape, kernel: &EdgeUse, found: &CutGraph) {
    assert!(found.obstacles.is_empty() && found.edges.is_sorted());
    let mut degrees: BTreeMap<VertexId, u32> = BTreeMap::new();
    found.edges.iter().flat_map(|&e| kernel.edge_ends(e)).for_each(|v| *degrees.entry(v).or_default() += 1);
    let blind = degrees.values().filter(|&&degree| degree == 1).count();
    let is_sphere = shape.truth.genus == Some(0) && shape.truth.boundary_loops == Some(0);
    assert_eq!(blind, if is_sphere { 2 } else { 0 }, "{}", shape.name);
    let euler_characteristic = degrees.len() as i64 - found.edges.len() as i64;
    assert_eq!(euler_characteristic, shape.truth.euler_characteristic() - 1, "{}", shape.name);
    let walls: BTreeSet<EdgeId> = found.edges.iter().copied().collect();
    assert_eq!(parts_beside(kernel, &walls, false), 1, "{}", shape.name);
    assert!(kernel.edges().all(|edge| kernel.edge_degree(edge) == 2 || walls.contains(&edge)));
}

#[test]
fn every_surface_of_the_catalogue_has_its_generators_and_opens_into_a_disc() {
    let surfaces: Vec<Shape> = shapes::catalogue().into_iter().filter(|s| s.truth.manifold).collect();
    assert!(surfaces.len() > 60);
    for shape in &surfaces {
        BOTH.iter().for_each(|options| assert_surface(shape, options));
    }
}

#[test]
fn names_and_rotations_change_no_count() {
    let shape = shapes::surface(Closed::CrossCaps(3), 2, 1);
    let count = shape.soup.vertex_count() as u32;
    for step in [1, 5, 77] {
        let mut names: Vec<u32> = (0..count).collect();
        (0..count as usize).for_each(|i| names.swap(i, (i * step + step) % count as usize));
        let soup = shape.soup.renamed(&names).rotated(step);
        let renamed = Shape { soup, ..shape.clone() };
        BOTH.iter().for_each(|options| assert_surface(&renamed, options));
    }
}

#[test]
fn a_surface_of_genus_four_has_eight_loops() {
    let shape = shapes::surface(Closed::Handles(4), 0, 4);
    assert!(shape.truth.faces > 20_000);
    let kernel = kernel(&shape.soup.mesh());
    for options in BOTH {
        let found = generators(&kernel, &options).unwrap();
        let (closed, boundary) = paths(&kernel, &found);
        assert_eq!((closed.len(), boundary.len()), (8, 0));
        assert_independent(&kernel, &closed, 1);
    }
}

#[test]
fn what_is_no_surface_says_why() {
    for shape in shapes::catalogue().iter().filter(|shape| !shape.truth.manifold) {
        let kernel = kernel(&shape.soup.mesh());
        let found = generators(&kernel, &GREEDY).unwrap();
        let [component] = found.components() else { panic!("{}", shape.name) };
        assert!(component.system.is_none() && component.generators.is_empty(), "{}", shape.name);
        assert!(component.obstacle.is_some(), "{}", shape.name);
        let cut = cut_graph(&kernel, &GREEDY).unwrap();
        assert_eq!((cut.edges.len(), cut.obstacles.len()), (0, 1), "{}", shape.name);
    }
    let fan = shapes::three_triangles_on_an_edge();
    let found = generators(&kernel(&fan.soup.mesh()), &GREEDY).unwrap();
    let why = found.components()[0].obstacle.as_ref().map(ToString::to_string);
    assert!(why.unwrap().contains("v0"));
}

#[test]
fn components_are_answered_one_by_one() {
    let parts = [
        shapes::torus(4, 5, Tiles::Quads),
        shapes::bow_tie(),
        shapes::klein_bottle(3, 4, Tiles::Triangles),
        shapes::surface(Closed::Handles(1), 3, 0),
        shapes::tetrahedron(),
    ];
    let soups: Vec<Soup> = parts.iter().map(|shape| shape.soup.clone()).collect();
    let kernel = kernel(&Soup::beside(&soups, 10.0).mesh());
    let found = generators(&kernel, &GREEDY).unwrap();
    let counts: Vec<usize> = found.components().iter().map(|c| c.generators.len()).collect();
    assert_eq!(counts, [2, 0, 2, 4, 0]);
    let kinds: Vec<bool> = found.components().iter().map(|c| c.system.is_some()).collect();
    assert_eq!(kinds, [true, false, true, true, true]);
    // As alone, but for the names.
    let alone = generators(&self::kernel(&soups[3].mesh()), &GREEDY).unwrap();
    let offset: u32 = soups[..3].iter().map(|soup| soup.vertex_count() as u32).sum();
    let third = &found.components()[3];
    for (one, other) in alone.components()[0].generators.iter().zip(&third.generators) {
        let moved: Vec<VertexId> = alone.vertices(one).iter().map(|v| VertexId(v.0 + offset)).collect();
        assert_eq!(moved, found.vertices(other));
    }
}

#[test]
fn a_root_is_in_some_face() {
    let soup = Soup::generic(4, [[0, 1, 2]]);
    let kernel = kernel(&soup.mesh());
    for root in [VertexId(3), VertexId(4), VertexId(u32::MAX)] {
        let options = GeneratorOptions { roots: Roots::At(root), ..GREEDY };
        assert_eq!(generators(&kernel, &options).unwrap_err(), GeneratorError::NoSuchRoot(root));
        assert_eq!(cut_graph(&kernel, &options).unwrap_err(), GeneratorError::NoSuchRoot(root));
    }
}

#[test]
fn a_sphere_opens_along_the_lowest_edges_of_its_lowest_vertex_with_two() {
    let cut = |faces: &[&[u32]]| {
        let kernel = kernel(&Soup::generic(5, faces).mesh());
        let found = cut_graph(&kernel, &GREEDY).unwrap().edges;
        found.iter().map(|&edge| kernel.edge_ends(edge).map(|v| v.0)).collect::<Vec<_>>()
    };
    // Two triangles back to back, and a face that goes out and back.
    assert_eq!(cut(&[&[0, 1, 2], &[2, 1, 0]]), [[0, 1], [0, 2]]);
    assert_eq!(cut(&[&[0, 1, 2, 1]]), [[0, 1], [1, 2]]);
}

struct Both<'a>(&'a GeneratorOptions<'a>);

impl KernelTask for Both<'_> {
    type Output = (Vec<Vec<VertexId>>, String, Vec<EdgeId>);
    fn run<K: Connectivity>(self, kernel: &K) -> Self::Output {
        let found = generators(kernel, self.0).unwrap();
        let all = found.components().iter().flat_map(|component| &component.generators);
        let paths = all.map(|generator| found.vertices(generator)).collect();
        (paths, format!("{:?}", found.components()), cut_graph(kernel, self.0).unwrap().edges)
    }
}

#[test]
fn every_kernel_gives_the_same_answer() {
    for (seed, shape) in small_surfaces().iter().enumerate() {
        let mesh = shape.soup.mesh();
        let lengths = random_lengths(&kernel(&mesh), seed as u64);
        for co_tree in [CoTree::Lowest, CoTree::Greedy] {
            let options = GeneratorOptions { lengths: Some(&lengths), co_tree, ..GREEDY };
            let expected = Both(&options).run(&kernel(&mesh));
            for kind in KernelKind::ALL {
                if let Ok(found) = kind.run(mesh.complex(), Both(&options)) {
                    assert_eq!(found, expected, "{kind} {}", shape.name);
                }
            }
        }
    }
}

#[test]
fn the_surface_is_named() {
    let kernel = kernel(&shapes::dycks_surface().soup.mesh());
    let system = generators(&kernel, &GREEDY).unwrap().components()[0].system.unwrap();
    assert_eq!(system.surface, Surface::NonOrientable { cross_caps: 3, holes: 0 });
}
