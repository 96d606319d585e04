//! Paths as sets of edges, and what is true of independent ones.

use std::collections::{BTreeMap, BTreeSet};

use meshmend_core::{Build, Connectivity, EdgeId, EdgeUse, FaceId, PolygonMesh, VertexId};
use meshmend_topology::{CoTree, GeneratorKind, GeneratorOptions, Generators, Roots, boundary_loops};

pub(crate) const GREEDY: GeneratorOptions<'static> =
    GeneratorOptions { lengths: None, co_tree: CoTree::Greedy, roots: Roots::Lowest, watch: None };

pub(crate) fn kernel(mesh: &PolygonMesh) -> EdgeUse {
    EdgeUse::build(mesh.complex()).unwrap()
}

/// Each pair of neighbours on a closed path, as the edge that joins them.
pub(crate) fn edges_of(ends: &BTreeMap<[VertexId; 2], EdgeId>, path: &[VertexId]) -> BTreeSet<EdgeId> {
    let sides = path.iter().zip(path.iter().cycle().skip(1));
    sides.map(|(&from, &to)| ends[&[from.min(to), from.max(to)]]).collect()
}

pub(crate) fn edge_by_ends(kernel: &EdgeUse) -> BTreeMap<[VertexId; 2], EdgeId> {
    kernel.edges().map(|edge| (kernel.edge_ends(edge), edge)).collect()
}

/// All paths of handles and cross-caps, and all boundary loops, as sets of edges, after a look at what is said of
/// them.
pub(crate) fn paths(kernel: &EdgeUse, found: &Generators) -> (Vec<BTreeSet<EdgeId>>, Vec<BTreeSet<EdgeId>>) {
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
pub(crate) fn parts_beside(kernel: &EdgeUse, walls: &BTreeSet<EdgeId>, with_loops: bool) -> usize {
    let ends = edge_by_ends(kernel);
    let mut nodes: Vec<u32> = (0..kernel.face_count() as u32).collect();
    let mut other_side = BTreeMap::new();
    for path in boundary_loops(kernel).iter().filter(|_| with_loops) {
        let node = nodes.len() as u32;
        nodes.push(node);
        other_side.extend(edges_of(&ends, path).into_iter().map(|edge| (edge, node)));
    }
    pub(crate) fn root(nodes: &mut [u32], mut at: u32) -> u32 {
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
pub(crate) fn assert_independent(kernel: &EdgeUse, closed: &[BTreeSet<EdgeId>], components: usize) {
    let mut times: BTreeMap<EdgeId, u32> = BTreeMap::new();
    closed.iter().flatten().for_each(|&edge| *times.entry(edge).or_default() += 1);
    assert!(closed.iter().all(|path| path.iter().any(|edge| times[edge] == 1)));
    assert_eq!(parts_beside(kernel, &times.keys().copied().collect(), true), components);
}

/// Tree, co-tree and left-over edges are all edges, each once, and each path has one left-over edge, another each.
pub(crate) fn assert_pairing(kernel: &EdgeUse, found: &Generators, closed: &[BTreeSet<EdgeId>]) {
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
pub(crate) fn rank(vectors: impl IntoIterator<Item = BTreeSet<EdgeId>>) -> usize {
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
pub(crate) fn face_boundary(kernel: &EdgeUse, face: FaceId) -> BTreeSet<EdgeId> {
    kernel.face_corners(face).fold(BTreeSet::new(), |mut edges, corner| {
        let edge = kernel.corner_edge(corner);
        if !edges.remove(&edge) {
            edges.insert(edge);
        }
        edges
    })
}
