//! Generators and cut graphs of shapes with known answers, judged by what proves them: paths, ranks, and trees of
//! faces that cross no path.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "these are tests")]

use std::collections::{BTreeMap, BTreeSet};

use meshmend_core::{Build, Column, Connectivity, EdgeId, EdgeUse, FaceId, PolygonMesh, VertexId};
use meshmend_kernels::{KernelKind, KernelTask};
use meshmend_testkit::Soup;
use meshmend_testkit::shapes::{self, Closed, Shape, Tiles};
use meshmend_topology::{
    CoTree, CutGraph, GeneratorError, GeneratorKind, GeneratorOptions, Generators, Measure, Roots, Surface,
    boundary_loops, cut_graph, generators,
};

const GREEDY: GeneratorOptions<'static> =
    GeneratorOptions { lengths: None, co_tree: CoTree::Greedy, roots: Roots::Lowest };
const BOTH: [GeneratorOptions<'static>; 2] =
    [GeneratorOptions { lengths: None, co_tree: CoTree::Lowest, roots: Roots::Lowest }, GREEDY];

fn kernel(mesh: &PolygonMesh) -> EdgeUse {
    EdgeUse::build(mesh.complex()).unwrap()
}

/// Each pair of neighbours on a closed path, as the edge that joins them.
fn edges_of(ends: &BTreeMap<[VertexId; 2], EdgeId>, path: &[VertexId]) -> BTreeSet<EdgeId> {
    let sides = path.iter().zip(path.iter().cycle().skip(1));
    sides.map(|(&from, &to)| ends[&[from.min(to), from.max(to)]]).collect()
}

fn edge_by_ends(kernel: &EdgeUse) -> BTreeMap<[VertexId; 2], EdgeId> {
    kernel.edges().map(|edge| (kernel.edge_ends(edge), edge)).collect()
}

/// All paths of handles and cross-caps, and all boundary loops, as sets of edges, after a look at what is said of
/// them.
fn paths(kernel: &EdgeUse, found: &Generators) -> (Vec<BTreeSet<EdgeId>>, Vec<BTreeSet<EdgeId>>) {
    let ends = edge_by_ends(kernel);
    let (mut closed, mut boundary) = (Vec::new(), Vec::new());
    for component in found.components() {
        for generator in &component.generators {
            let vertices = found.vertices(generator);
            let path = edges_of(&ends, &vertices);
            assert_eq!(vertices.iter().collect::<BTreeSet<_>>().len(), vertices.len());
            assert_eq!((vertices.len(), path.len()), (generator.vertex_count, generator.vertex_count));
            match generator.kind {
                GeneratorKind::Boundary => {
                    assert!(path.iter().all(|&edge| kernel.edge_degree(edge) == 1) && generator.is_two_sided);
                    boundary.push(path);
                }
                _ => closed.push(path),
            }
        }
    }
    (closed, boundary)
}

/// Sets of faces and boundary loops that hang together without crossing some edges.
fn parts_beside(kernel: &EdgeUse, walls: &BTreeSet<EdgeId>, with_loops: bool) -> usize {
    let ends = edge_by_ends(kernel);
    let mut nodes: Vec<u32> = (0..kernel.face_count() as u32).collect();
    let mut other_side = BTreeMap::new();
    for path in boundary_loops(kernel).iter().filter(|_| with_loops) {
        let node = nodes.len() as u32;
        nodes.push(node);
        other_side.extend(edges_of(&ends, path).into_iter().map(|edge| (edge, node)));
    }
    fn root(nodes: &mut [u32], mut at: u32) -> u32 {
        while nodes[at as usize] != at {
            nodes[at as usize] = nodes[nodes[at as usize] as usize];
            at = nodes[at as usize];
        }
        at
    }
    for edge in kernel.edges().filter(|edge| !walls.contains(edge)) {
        let beside: Vec<u32> =
            kernel.edge_faces(edge).map(|f| f.0).chain(other_side.get(&edge).copied()).collect();
        for pair in beside.windows(2) {
            let (one, other) = (root(&mut nodes, pair[0]), root(&mut nodes, pair[1]));
            nodes[one as usize] = other;
        }
    }
    let degenerate = kernel.faces().filter(|&f| !kernel.is_proper_face(f)).count();
    (0..nodes.len() as u32).filter(|&n| root(&mut nodes, n) == n).count() - degenerate
}

/// The proof that paths are independent modulo faces and boundary loops: each has an edge of its own, and a way from
/// one side of that edge to the other which crosses no path. It crosses just its own path, once.
fn assert_independent(kernel: &EdgeUse, closed: &[BTreeSet<EdgeId>], components: usize) {
    let mut times: BTreeMap<EdgeId, u32> = BTreeMap::new();
    closed.iter().flatten().for_each(|&edge| *times.entry(edge).or_default() += 1);
    assert!(closed.iter().all(|path| path.iter().any(|edge| times[edge] == 1)));
    assert_eq!(parts_beside(kernel, &times.keys().copied().collect(), true), components);
}

/// Tree, co-tree and left-over edges are all edges, each once, and each path has one left-over edge, another each.
fn assert_pairing(kernel: &EdgeUse, found: &Generators, closed: &[BTreeSet<EdgeId>]) {
    let (tree, co_tree) = (found.tree_edges(), found.co_tree_edges());
    let mut in_trees: BTreeSet<EdgeId> = tree.iter().chain(co_tree).copied().collect();
    assert_eq!(in_trees.len(), tree.len() + co_tree.len());
    for path in closed {
        let left: Vec<EdgeId> = path.iter().copied().filter(|edge| !in_trees.contains(edge)).collect();
        assert!(left.len() == 1 && path.iter().all(|edge| co_tree.binary_search(edge).is_err()));
        in_trees.extend(left);
    }
    assert_eq!(in_trees.len(), kernel.edge_count());
}

/// The rank of vectors over ℤ/2.
fn rank(vectors: impl IntoIterator<Item = BTreeSet<EdgeId>>) -> usize {
    let mut rows: BTreeMap<EdgeId, BTreeSet<EdgeId>> = BTreeMap::new();
    for mut vector in vectors {
        while let Some(&pivot) = vector.first() {
            match rows.get(&pivot) {
                Some(row) => vector = vector.symmetric_difference(row).copied().collect(),
                None => {
                    rows.insert(pivot, vector);
                    break;
                }
            }
        }
    }
    rows.len()
}

/// The edges that a face's sides run along once, or three times.
fn face_boundary(kernel: &EdgeUse, face: FaceId) -> BTreeSet<EdgeId> {
    kernel.face_corners(face).fold(BTreeSet::new(), |mut edges, corner| {
        let edge = kernel.corner_edge(corner);
        if !edges.remove(&edge) {
            edges.insert(edge);
        }
        edges
    })
}

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

/// Numbers that look random.
fn number(seed: u64) -> u64 {
    let z = seed.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z ^ (z >> 27)
}

fn random_lengths(kernel: &EdgeUse, seed: u64) -> Column<EdgeId, f64> {
    kernel.edges().map(|edge| (number(seed << 32 | u64::from(edge.0)) % 7) as f64).collect()
}

/// Small surfaces of all kinds.
fn small_surfaces() -> Vec<Shape> {
    vec![
        shapes::torus(3, 3, Tiles::Triangles),
        shapes::klein_bottle(4, 3, Tiles::Quads),
        shapes::projective_plane(),
        shapes::dycks_surface(),
        shapes::seven_vertex_torus(),
        shapes::moebius_band(4, 2, Tiles::Triangles),
        shapes::surface(Closed::Handles(2), 0, 0),
        shapes::surface(Closed::Handles(1), 1, 0),
        shapes::surface(Closed::CrossCaps(1), 0, 0),
        opened(shapes::klein_bottle(4, 3, Tiles::Triangles), &[5]),
        opened(shapes::torus(5, 4, Tiles::Quads), &[0, 10, 12]),
    ]
}

/// A closed surface without some of its faces, which have no vertex in common.
fn opened(mut shape: Shape, faces: &[usize]) -> Shape {
    faces.iter().rev().for_each(|&face| drop(shape.soup.faces.remove(face)));
    shape
}

/// The least length that loops through a vertex can have together which generate the homology of the surface with
/// its holes closed: by shortest paths in its homology cover, and then the best basis.
fn least_system(kernel: &EdgeUse, lengths: &Column<EdgeId, f64>, root: VertexId) -> f64 {
    assert!(kernel.edge_count() <= 128, "{} edges", kernel.edge_count());
    let ends = edge_by_ends(kernel);
    let loops = boundary_loops(kernel);
    let relations: Vec<u128> = kernel
        .faces()
        .map(|face| face_boundary(kernel, face))
        .chain(loops.iter().map(|path| edges_of(&ends, path)))
        .map(|edges| edges.iter().fold(0, |bits, edge| bits | 1 << edge.0))
        .collect();
    let classes = cohomology(kernel, &relations);
    let states = 1usize << classes.len();
    let bits = |edge: EdgeId| {
        classes.iter().enumerate().fold(0, |sum, (i, class)| sum | ((class >> edge.0 & 1) as usize) << i)
    };
    let mut distance = vec![f64::INFINITY; kernel.vertex_count() * states];
    distance[root.0 as usize * states] = 0.0;
    let mut changed = true;
    while std::mem::take(&mut changed) {
        for (edge, &length) in lengths.iter() {
            for (from, to) in [(0, 1), (1, 0)] {
                let [from, to] = [from, to].map(|i: usize| kernel.edge_ends(edge)[i].0 as usize * states);
                for class in 0..states {
                    let through = distance[from + class] + length;
                    let there = &mut distance[to + (class ^ bits(edge))];
                    if through < *there {
                        (*there, changed) = (through, true);
                    }
                }
            }
        }
    }
    let mut loops: Vec<(f64, usize)> =
        (1..states).map(|class| (distance[root.0 as usize * states + class], class)).collect();
    loops.sort_by(|one, other| one.0.total_cmp(&other.0));
    let mut basis: Vec<usize> = Vec::new();
    let mut total = 0.0;
    for (length, class) in loops {
        let rest = basis.iter().fold(class, |rest, &row| rest.min(rest ^ row));
        if rest != 0 {
            basis.push(rest);
            basis.sort_unstable_by(|one, other| other.cmp(one));
            total += length;
        }
    }
    assert_eq!(basis.len(), classes.len());
    total
}

/// Cocycles that no coboundaries are, a basis modulo those, as sets of edges: by elimination on bits.
fn cohomology(kernel: &EdgeUse, relations: &[u128]) -> Vec<u128> {
    // The null space of the relations: each row reduced, and one vector for each column without a pivot.
    let mut rows: Vec<(u32, u128)> = Vec::new();
    for &relation in relations {
        let mut row = relation;
        for &(pivot, other) in &rows {
            if row >> pivot & 1 == 1 {
                row ^= other;
            }
        }
        if row != 0 {
            let pivot = row.trailing_zeros();
            for (_, other) in &mut rows {
                if *other >> pivot & 1 == 1 {
                    *other ^= row;
                }
            }
            rows.push((pivot, row));
        }
    }
    let free = (0..kernel.edge_count() as u32).filter(|&column| rows.iter().all(|row| row.0 != column));
    let cocycles = free.map(|column| {
        rows.iter().filter(|row| row.1 >> column & 1 == 1).fold(1u128 << column, |set, row| set | 1 << row.0)
    });
    let mut basis: Vec<u128> = Vec::new();
    let reduced = |basis: &[u128], vector: u128| {
        basis.iter().fold(vector, |rest, row| if rest >> row.ilog2() & 1 == 1 { rest ^ row } else { rest })
    };
    for vertex in kernel.vertices() {
        let star = kernel.edges().filter(|&edge| kernel.edge_ends(edge).contains(&vertex));
        let star = reduced(&basis, star.fold(0, |bits, edge| bits | 1 << edge.0));
        if star != 0 {
            basis.push(star);
        }
    }
    let mut found = Vec::new();
    for cocycle in cocycles {
        let rest = reduced(&basis, cocycle);
        if rest != 0 {
            basis.push(rest);
            found.push(cocycle);
        }
    }
    found
}

#[test]
fn the_greedy_system_is_the_shortest_at_its_root() {
    for (seed, shape) in small_surfaces().iter().enumerate() {
        let kernel = kernel(&shape.soup.mesh());
        for round in 0..4 {
            let lengths = random_lengths(&kernel, (seed * 4 + round) as u64);
            let root = VertexId((round * 5 % shape.truth.vertices) as u32);
            let options = GeneratorOptions { lengths: Some(&lengths), roots: Roots::At(root), ..GREEDY };
            let found = generators(&kernel, &options).unwrap();
            let system = found.components()[0].system.unwrap();
            assert_eq!((system.root, system.measure), (root, Measure::Length));
            assert_eq!(system.length, least_system(&kernel, &lengths, root), "{}", shape.name);
            let any = generators(&kernel, &GeneratorOptions { co_tree: CoTree::Lowest, ..options }).unwrap();
            assert!(any.components()[0].system.unwrap().length >= system.length);
        }
    }
}

#[test]
fn lengths_are_those_of_the_paths() {
    for (seed, shape) in small_surfaces().iter().enumerate() {
        let kernel = kernel(&shape.soup.mesh());
        let (lengths, ends) = (random_lengths(&kernel, seed as u64), edge_by_ends(&kernel));
        let options = GeneratorOptions { lengths: Some(&lengths), ..GREEDY };
        let found = generators(&kernel, &options).unwrap();
        for generator in &found.components()[0].generators {
            let path = edges_of(&ends, &found.vertices(generator));
            assert_eq!(generator.length, path.iter().map(|&edge| lengths[edge]).sum::<f64>());
        }
    }
}

#[test]
fn the_best_of_all_roots_has_the_shortest_system_there_is() {
    for shape in [shapes::seven_vertex_torus(), shapes::klein_bottle(4, 3, Tiles::Quads)] {
        let kernel = kernel(&shape.soup.mesh());
        let lengths = random_lengths(&kernel, 99);
        let with = |roots| {
            let options = GeneratorOptions { lengths: Some(&lengths), roots, ..GREEDY };
            generators(&kernel, &options).unwrap().components()[0].system.unwrap()
        };
        let systems: Vec<_> = kernel.vertices().map(|root| with(Roots::At(root))).collect();
        let least = systems.iter().map(|system| system.length).fold(f64::INFINITY, f64::min);
        let first = systems.iter().find(|system| system.length == least).unwrap();
        for count in [shape.truth.vertices as u32, 1000] {
            assert_eq!(with(Roots::Best(count.try_into().unwrap())), *first);
        }
        let few = with(Roots::Best(3.try_into().unwrap()));
        let tried = [0, 1, 2].map(|i| systems[i * shape.truth.vertices / 3]);
        assert!(tried.contains(&few) && tried.iter().all(|system| system.length >= few.length));
        assert_eq!(with(Roots::Best(1.try_into().unwrap())), with(Roots::Lowest));
    }
}

#[test]
fn lengths_that_are_no_numbers_are_counted_in_edges_in_their_component() {
    let parts = [shapes::torus(3, 4, Tiles::Quads), shapes::torus(4, 3, Tiles::Quads)];
    let kernel = kernel(&Soup::beside(&parts.map(|shape| shape.soup), 10.0).mesh());
    let in_edges = generators(&kernel, &GREEDY).unwrap();
    for wrong in [f64::NAN, f64::INFINITY, -1.0, f64::MAX] {
        let mut lengths = Column::filled(0.25, kernel.edge_count());
        lengths[EdgeId(3)] = wrong;
        let options = GeneratorOptions { lengths: Some(&lengths), ..GREEDY };
        let found = generators(&kernel, &options).unwrap();
        let measures: Vec<_> = found.components().iter().map(|c| c.system.unwrap().measure).collect();
        assert_eq!(measures, [Measure::Hops, Measure::Length]);
        assert_eq!(found.components()[0], in_edges.components()[0]);
        assert_eq!(
            found.components()[1].generators[0].length,
            in_edges.components()[1].generators[0].length / 4.0
        );
    }
    let short = Column::filled(1.0, 3);
    let wrong = generators(&kernel, &GeneratorOptions { lengths: Some(&short), ..GREEDY });
    assert_eq!(wrong.unwrap_err(), GeneratorError::Lengths { found: 3, expected: kernel.edge_count() });
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
