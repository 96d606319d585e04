//! The adjacency matrix of a mesh, and what a graph knows of it.
//!
//! ```text
//! starts        0     2         5 ...
//! neighbours    v1 v2 | v0 v2 v3 | ...        the columns of the ones in each row, ascending
//! ```
//!
//! Bytes a triangle of a closed mesh: 4 (V + 1) for the starts and 8 E for the neighbours, together 14.

use std::collections::VecDeque;

use meshmend_core::{Adjacency, Array, Classes, Column, Complex, Id, Lists, Per, VertexId};

/// The adjacency matrix A of the edges of a complex: a symmetric matrix of zeros and ones, kept by rows.
#[derive(Clone, Debug)]
pub struct Graph {
    neighbours: Lists<VertexId, VertexId>,
    edge_count: usize,
}

impl Graph {
    /// The graph of a complex.
    ///
    /// *Cost*: linear.
    pub fn of(complex: &Complex) -> Self {
        let ends = complex.edges().all_ends();
        // Edges are numbered by their ends, so each list gets its smaller neighbours first, and ascends.
        let both_ways = ends.iter().flat_map(|&[low, high]| [(low, high), (high, low)]);
        Graph { neighbours: Lists::group(complex.faces().vertex_count(), both_ways), edge_count: ends.len() }
    }

    /// How many edges are at a vertex: the sum of its row.
    pub fn degree(&self, vertex: VertexId) -> usize {
        self.neighbours.of(vertex).len()
    }

    /// Bytes on the heap.
    pub fn heap_bytes(&self) -> usize {
        self.neighbours.heap_bytes()
    }

    /// The arrays of which the matrix consists.
    pub fn arrays(&self) -> Vec<Array> {
        self.neighbours.arrays(("row starts", Per::Vertex), ("neighbours", Per::Dart)).to_vec()
    }
}

impl PartialEq for Graph {
    fn eq(&self, other: &Self) -> bool {
        let vertices = 0..self.neighbours.len();
        let row = |graph: &'_ Self, v| graph.neighbours.of(VertexId::new(v)).to_vec();
        vertices.end == other.neighbours.len() && vertices.into_iter().all(|v| row(self, v) == row(other, v))
    }
}

impl Eq for Graph {}

impl Adjacency for Graph {
    const VIEW: &'static str = "adjacency-matrix";

    fn graph_counts(&self) -> [usize; 2] {
        [self.neighbours.len(), self.edge_count]
    }

    fn neighbours(&self, vertex: VertexId) -> impl Iterator<Item = VertexId> {
        self.neighbours.of(vertex).iter().copied()
    }
}

/// Over how few edges each vertex is reached from one; `None` for what is not reached.
///
/// *Panics* if there is no such vertex.
///
/// *Cost*: linear.
pub fn distances(graph: &impl Adjacency, from: VertexId) -> Column<VertexId, Option<u32>> {
    let mut distances = Column::filled(None, graph.graph_counts()[0]);
    distances[from] = Some(0);
    let mut queue = VecDeque::from([(from, 0)]);
    while let Some((vertex, distance)) = queue.pop_front() {
        for neighbour in graph.neighbours(vertex) {
            if distances[neighbour].is_none() {
                distances[neighbour] = Some(distance + 1);
                queue.push_back((neighbour, distance + 1));
            }
        }
    }
    distances
}

/// In how many parts the vertices that have a neighbour are. A connected graph has one.
///
/// *Cost*: linear.
pub fn component_count(graph: &impl Adjacency) -> usize {
    let vertices = (0..graph.graph_counts()[0]).map(VertexId::new);
    let mut classes = Classes::new(vertices.len());
    let mut count = vertices.clone().filter(|&vertex| graph.neighbours(vertex).next().is_some()).count();
    for vertex in vertices {
        for neighbour in graph.neighbours(vertex) {
            count -= usize::from(classes.join(vertex.0, neighbour.0));
        }
    }
    count
}

/// How many cycles of three edges there are: tr A³ / 6. Beside the number of triangular faces it shows that not every such
/// cycle is a face.
///
/// *Cost*: m √m for m edges, and linear for the graphs of most meshes.
pub fn triangle_count(graph: &impl Adjacency) -> u64 {
    let vertex_count = graph.graph_counts()[0];
    let vertices = (0..vertex_count).map(VertexId::new);
    let degrees: Column<VertexId, usize> = vertices.clone().map(|v| graph.neighbours(v).count()).collect();
    // Each edge leads to its end of higher degree, so no vertex has many edges that lead on.
    let rank = |vertex: VertexId| (degrees[vertex], vertex);
    let onward = |vertex: VertexId| graph.neighbours(vertex).filter(move |&other| rank(other) > rank(vertex));
    let pairs = vertices.clone().flat_map(|vertex| onward(vertex).map(move |other| (vertex, other)));
    let pairs: Vec<(VertexId, VertexId)> = pairs.collect();
    let lists = Lists::group(vertex_count, pairs.iter().copied());
    let mut marked_by = Column::filled(None, vertex_count);
    let mut count = 0;
    for vertex in vertices {
        lists.of(vertex).iter().for_each(|&other| marked_by[other] = Some(vertex));
        let thirds = lists.of(vertex).iter().flat_map(|&other| lists.of(other));
        count += thirds.filter(|&&third| marked_by[third] == Some(vertex)).count() as u64;
    }
    count
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::components;
    use crate::shapes::{self, Shape};

    fn graph(shape: &Shape) -> Graph {
        Graph::of(shape.mesh().complex())
    }

    /// Every two of `n` vertices joined, by a fan from a vertex to each triple.
    pub(crate) fn complete(n: u32) -> Graph {
        let pairs = (0..n).flat_map(|a| (a + 1..n).map(move |b| (a, b)));
        graph(&Shape(pairs.flat_map(|(a, b)| (b + 1..n).map(move |c| vec![a, b, c])).collect()))
    }

    #[test]
    fn a_triangle_mesh_takes_14_bytes_a_triangle() {
        let grid = shapes::torus(20, 20);
        let cut = grid.0.iter().flat_map(|q| [vec![q[0], q[1], q[2]], vec![q[2], q[3], q[0]]]);
        let graph = graph(&Shape(cut.collect()));
        assert_eq!(graph.heap_bytes(), 14 * 800 + 4);
        assert_eq!(graph.arrays().iter().map(Array::bytes).sum::<usize>(), graph.heap_bytes());
        assert_eq!(graph.degree(VertexId(7)), 6);
    }

    #[test]
    fn distances_go_over_edges() {
        let found = distances(&graph(&shapes::torus(5, 7)), VertexId(0));
        assert_eq!(found[VertexId(3)], Some(3));
        assert_eq!(found.values().iter().max(), Some(&Some(2 + 3)));
        let apart = Shape::side_by_side(&[shapes::tetrahedron(), shapes::tetrahedron()]);
        assert_eq!(distances(&graph(&apart), VertexId(1))[VertexId(5)], None);
    }

    #[test]
    fn parts_of_the_graph_are_components() {
        let mut apart = Shape::side_by_side(&[shapes::tetrahedron(), shapes::bow_tie(), shapes::torus(3, 3)]);
        // A vertex in no face.
        apart.0.push(vec![30, 31, 32]);
        assert_eq!(component_count(&graph(&apart)), components(&apart.kernel()).count());
        assert_eq!(component_count(&graph(&Shape::of(&[]))), 0);
    }

    #[test]
    fn three_cycles_are_counted_once_each() {
        for n in 3..9u64 {
            assert_eq!(triangle_count(&complete(n as u32)), n * (n - 1) * (n - 2) / 6);
        }
        // A quad has none; a torus of 3 × 3 quads has them round its waist and its tube.
        assert_eq!(triangle_count(&graph(&Shape::of(&[&[0, 1, 2, 3]]))), 0);
        assert_eq!(triangle_count(&graph(&shapes::torus(3, 3))), 6);
        assert_eq!(triangle_count(&graph(&shapes::bow_tie())), 2);
    }
}
