//! Systems of loops are the shortest there are: judged by all cohomology classes of small surfaces.

use meshmend_core::{Column, Connectivity, EdgeId, EdgeUse, VertexId};
use meshmend_testkit::Soup;
use meshmend_testkit::shapes::{self, Closed, Shape, Tiles};
use meshmend_topology::{
    CoTree, GeneratorError, GeneratorOptions, Measure, Roots, boundary_loops, generators,
};

use crate::paths::{GREEDY, edge_by_ends, edges_of, face_boundary, kernel};

/// Numbers that look random.
pub(crate) fn number(seed: u64) -> u64 {
    let z = seed.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z ^ (z >> 27)
}

pub(crate) fn random_lengths(kernel: &EdgeUse, seed: u64) -> Column<EdgeId, f64> {
    kernel.edges().map(|edge| (number(seed << 32 | u64::from(edge.0)) % 7) as f64).collect()
}

/// Small surfaces of all kinds.
pub(crate) fn small_surfaces() -> Vec<Shape> {
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
pub(crate) fn opened(mut shape: Shape, faces: &[usize]) -> Shape {
    faces.iter().rev().for_each(|&face| drop(shape.soup.faces.remove(face)));
    shape
}

/// The least length that loops through a vertex can have together which generate the homology of the surface with
/// its holes closed: by shortest paths in its homology cover, and then the best basis.
pub(crate) fn least_system(kernel: &EdgeUse, lengths: &Column<EdgeId, f64>, root: VertexId) -> f64 {
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
pub(crate) fn cohomology(kernel: &EdgeUse, relations: &[u128]) -> Vec<u128> {
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
pub(crate) fn the_greedy_system_is_the_shortest_at_its_root() {
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
pub(crate) fn lengths_are_those_of_the_paths() {
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
pub(crate) fn the_best_of_all_roots_has_the_shortest_system_there_is() {
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
pub(crate) fn lengths_that_are_no_numbers_are_counted_in_edges_in_their_component() {
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
