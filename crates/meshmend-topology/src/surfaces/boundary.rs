//! Along which closed paths is the surface open?
//!
//! A *boundary loop* is a cycle of boundary edges through vertices each of which has exactly two boundary edges.
//! In a manifold component every boundary edge is in exactly one loop. Where boundary edges meet in threes or
//! more, which follows which is not defined: those chains are in no loop, and
//! [`is_complete`](BoundaryLoops::is_complete) says so.

use meshmend_core::{Column, Connectivity, EdgeId, VertexId};

/// The boundary loops of a complex, ordered by lowest vertex.
///
/// Each begins at its lowest vertex and goes to the lower of that vertex's two neighbours, so that neither the
/// faces' order nor their orientation matters.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BoundaryLoops {
    starts: Vec<u32>,
    vertices: Vec<VertexId>,
    boundary_edges: usize,
}

impl BoundaryLoops {
    /// How many loops there are.
    pub fn count(&self) -> usize {
        self.starts.len() - 1
    }

    /// The vertices of each loop, the first one not repeated at the end.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &[VertexId]> + Clone {
        self.starts.windows(2).map(|range| &self.vertices[range[0] as usize..range[1] as usize])
    }

    /// The vertices of one loop, by its place in the order.
    pub fn vertices(&self, place: usize) -> &[VertexId] {
        &self.vertices[self.starts[place] as usize..self.starts[place + 1] as usize]
    }

    /// Whether every boundary edge is in a loop.
    pub fn is_complete(&self) -> bool {
        self.vertices.len() == self.boundary_edges
    }
}

/// The boundary loops of a complex.
///
/// ```
/// # use meshmend_core::{Build, EdgeUse, FaceTable, PolygonMesh, VertexId};
/// # use meshmend_topology::boundary_loops;
/// let two_triangles = [0, 1, 2, 2, 1, 3].map(VertexId).to_vec();
/// let mesh = PolygonMesh::new(vec![[0.0; 3]; 4], FaceTable::triangles(4, two_triangles)?)?;
/// let loops = boundary_loops(&EdgeUse::build(mesh.complex())?);
/// assert_eq!(loops.iter().next(), Some(&[0, 1, 3, 2].map(VertexId)[..]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// *Cost*: linear; 8 bytes a vertex where there is a boundary, and 13 a boundary edge.
pub fn boundary_loops<K: Connectivity>(kernel: &K) -> BoundaryLoops {
    let is_boundary = |edge: &EdgeId| kernel.edge_corners(*edge).nth(1).is_none();
    let boundary = kernel.edges().filter(is_boundary);
    if K::CAPABILITIES.is_manifold() {
        return walked(kernel, boundary.collect());
    }
    let edges: Vec<_> = boundary.map(|edge| kernel.edge_ends(edge)).collect();
    if edges.is_empty() {
        return BoundaryLoops { starts: vec![0], vertices: Vec::new(), boundary_edges: 0 };
    }
    BoundaryWalk::new(kernel.vertex_count(), edges).loops()
}

/// The loops of a kernel all of whose vertices have one umbrella, so that each boundary edge has a next one: walked as the
/// kernel walks.
fn walked<K: Connectivity>(kernel: &K, boundary: Vec<EdgeId>) -> BoundaryLoops {
    let mut found = BoundaryLoops { starts: vec![0], vertices: Vec::new(), boundary_edges: boundary.len() };
    let mut is_walked = Column::<EdgeId, bool>::filled(false, kernel.edge_count());
    // The lowest edge of a loop leads from its lowest vertex to the lower one of that vertex's neighbours.
    for first in boundary {
        let (mut edge, mut from) = (first, kernel.edge_ends(first)[0]);
        let before = found.vertices.len();
        while !std::mem::replace(&mut is_walked[edge], true) {
            found.vertices.push(from);
            let [low, high] = kernel.edge_ends(edge);
            from = if from == low { high } else { low };
            edge = kernel.next_boundary_edge(edge, from).unwrap_or(edge);
        }
        if found.vertices.len() > before {
            found.starts.push(found.vertices.len() as u32);
        }
    }
    found
}

/// The boundary edges and, for each vertex, which of them meet there.
struct BoundaryWalk {
    /// The ends of each boundary edge, ascending.
    edges: Vec<[VertexId; 2]>,
    /// The two boundary edges of a vertex, by their places; `NONE` for all that have not exactly two.
    at_vertex: Column<VertexId, [u32; 2]>,
}

const NONE: u32 = u32::MAX;
const TOO_MANY: [u32; 2] = [NONE, 0];

impl BoundaryWalk {
    fn new(vertex_count: usize, edges: Vec<[VertexId; 2]>) -> Self {
        let mut at_vertex = Column::filled([NONE; 2], vertex_count);
        for (place, &ends) in (0u32..).zip(&edges) {
            for end in ends {
                at_vertex[end] = match at_vertex[end] {
                    [NONE, NONE] => [place, NONE],
                    [first, NONE] => [first, place],
                    _ => TOO_MANY,
                };
            }
        }
        BoundaryWalk { edges, at_vertex }
    }

    /// The boundary edge after another at a vertex that has exactly two.
    fn next(&self, vertex: VertexId, edge: u32) -> Option<u32> {
        match self.at_vertex[vertex] {
            [NONE, _] | [_, NONE] => None,
            [first, second] => Some(if first == edge { second } else { first }),
        }
    }

    fn loops(&self) -> BoundaryLoops {
        let mut found =
            BoundaryLoops { starts: vec![0], vertices: Vec::new(), boundary_edges: self.edges.len() };
        let mut is_walked = vec![false; self.edges.len()];
        // The lowest edge of a loop leads from its lowest vertex to the lower one of that vertex's neighbours.
        for (first, &[start, _]) in (0u32..).zip(&self.edges) {
            let (mut edge, mut from) = (first, start);
            let before = found.vertices.len();
            while !is_walked[edge as usize] {
                is_walked[edge as usize] = true;
                found.vertices.push(from);
                let [a, b] = self.edges[edge as usize];
                from = if from == a { b } else { a };
                edge = self.next(from, edge).unwrap_or(edge);
            }
            let closes = edge == first && from == start && self.next(start, first).is_some();
            if closes && found.vertices.len() > before {
                found.starts.push(found.vertices.len() as u32);
            } else {
                found.vertices.truncate(before);
            }
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use meshmend_core::{VertexClass, vertex_classes};

    use super::*;
    use crate::shapes::{Random, kernel, moebius_band, torus};

    fn lists(loops: &BoundaryLoops) -> Vec<Vec<u32>> {
        loops.iter().map(|l| l.iter().map(|v| v.0).collect()).collect()
    }

    #[test]
    fn each_loop_begins_at_its_lowest_vertex() {
        let found = boundary_loops(&kernel(9, &[&[8, 7, 6], &[5, 3, 4, 2]]));
        assert_eq!(lists(&found), [vec![2, 4, 3, 5], vec![6, 7, 8]]);
        assert!(found.is_complete());
    }

    #[test]
    fn the_known_bands_have_one_and_two_loops() {
        assert_eq!(boundary_loops(&moebius_band(5).kernel()).count(), 1);
        assert_eq!(boundary_loops(&torus(3, 3).kernel()).count(), 0);
    }

    #[test]
    fn what_meets_in_fours_is_in_no_loop() {
        // A bow tie, listed so that walks begin on both sides of the knot, and a triangle of its own.
        let found = boundary_loops(&kernel(9, &[&[0, 2, 1], &[2, 3, 4], &[6, 7, 8]]));
        assert_eq!(lists(&found), [vec![6, 7, 8]]);
        assert!(!found.is_complete());
    }

    #[test]
    fn on_manifold_soups_loops_are_the_pieces_of_the_boundary() {
        let mut random = Random(41);
        let mut seen = 0;
        for _ in 0..3000 {
            let soup = random.soup(9, 6, 7);
            let faces: Vec<&[u32]> = soup.iter().map(Vec::as_slice).collect();
            let kernel = kernel(9, &faces);
            let found = boundary_loops(&kernel);
            if !vertex_classes(&kernel)
                .values()
                .iter()
                .all(|c| c.is_manifold() || *c == VertexClass::Unreferenced)
            {
                continue;
            }
            let mut pieces = petgraph::unionfind::UnionFind::<u32>::new(9);
            let boundary =
                kernel.edges().filter(|&e| kernel.edge_degree(e) == 1).map(|e| kernel.edge_ends(e));
            let at_boundary: BTreeSet<VertexId> = boundary.clone().flatten().collect();
            boundary.for_each(|[a, b]| {
                pieces.union(a.0, b.0);
            });
            let count = at_boundary.iter().map(|v| pieces.find(v.0)).collect::<BTreeSet<_>>().len();
            assert_eq!((found.count(), found.is_complete()), (count, true), "{soup:?}");
            for path in found.iter() {
                seen += 1;
                let n = path.len();
                let is_boundary = |i: usize| {
                    let mut ends = [path[i], path[(i + 1) % n]];
                    ends.sort_unstable();
                    kernel.edges().any(|e| kernel.edge_ends(e) == ends && kernel.edge_degree(e) == 1)
                };
                assert!((0..n).all(is_boundary));
                assert!(path[0] == *path.iter().min().unwrap() && path[1] < path[n - 1]);
            }
        }
        assert!(seen > 300, "{seen}");
    }
}
