//! How many walks of a length lead from a vertex to each other one?
//!
//! The entry (Aⁿ)ᵢⱼ of a power of the adjacency matrix. It counts *walks*, which may come back to an edge or a vertex as
//! often as they like, and not paths, which may not. The row i of Aⁿ is found without the rest: n times, each vertex gets
//! the sum of its neighbours.
//!
//! *Source*: N. Biggs, *Algebraic Graph Theory*, 1974, lemma 2.5.

use meshmend_core::{Adjacency, Column, Id, VertexId};

/// The number of walks of a length from a vertex to each vertex; `None` where one of the numbers is 2¹²⁸ or more.
///
/// ```
/// use meshmend_core::{FaceTable, PolygonMesh, VertexId};
/// use meshmend_topology::matrices::{Graph, walks};
///
/// // Round a triangle: back after two steps in two ways, to each other vertex in one.
/// let faces = FaceTable::triangles(3, [0, 1, 2].map(VertexId).to_vec())?;
/// let mesh = PolygonMesh::new(vec![[0.0; 3]; 3], faces)?;
/// let found = walks(&Graph::of(mesh.complex()), 2, VertexId(0)).ok_or("too many")?;
/// assert_eq!(found.values(), [2, 1, 1]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// *Panics* if there is no such vertex.
///
/// *Cost*: linear, for each step.
pub fn walks(graph: &impl Adjacency, length: u32, from: VertexId) -> Option<Column<VertexId, u128>> {
    let vertices = (0..graph.graph_counts()[0]).map(VertexId::new);
    let mut counts = Column::filled(0u128, vertices.len());
    counts[from] = 1;
    for _ in 0..length {
        let sum =
            |v| graph.neighbours(v).try_fold(0u128, |sum, neighbour| sum.checked_add(counts[neighbour]));
        let next: Column<VertexId, u128> = vertices.clone().map(sum).collect::<Option<Vec<u128>>>()?.into();
        // From a vertex without neighbours no walk leads on, however long.
        if next.values().iter().all(|&count| count == 0) {
            return Some(next);
        }
        counts = next;
    }
    Some(counts)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::matrices::Graph;
    use crate::shapes::{self, Shape};

    #[test]
    fn walks_on_complete_graphs_in_closed_form() {
        // On K₄ there are (3ⁿ + 3 (−1)ⁿ) / 4 walks back and (3ⁿ − (−1)ⁿ) / 4 to each other vertex.
        let graph = Graph::of(shapes::tetrahedron().mesh().complex());
        for length in 0..60u32 {
            let (all, sign) = (3i128.pow(length), if length % 2 == 0 { 1 } else { -1 });
            let found = walks(&graph, length, VertexId(0)).unwrap();
            let expected = [all + 3 * sign, all - sign, all - sign, all - sign].map(|n| (n / 4) as u128);
            assert_eq!(found.values(), expected);
        }
    }

    #[test]
    fn too_many_walks_are_not_counted_wrongly() {
        let graph = Graph::of(shapes::tetrahedron().mesh().complex());
        // 3⁸² / 4 is below 2¹²⁸, 3⁸³ / 4 is not.
        assert!(walks(&graph, 82, VertexId(0)).is_some());
        assert_eq!(walks(&graph, 83, VertexId(0)), None);
        assert_eq!(walks(&graph, u32::MAX, VertexId(0)), None);
    }

    #[test]
    fn a_vertex_in_no_face_has_the_walk_of_no_step() {
        let graph = Graph::of(Shape::of(&[&[1, 2, 3]]).mesh().complex());
        assert_eq!(walks(&graph, 0, VertexId(0)).unwrap().values(), [1, 0, 0, 0]);
        assert_eq!(walks(&graph, u32::MAX, VertexId(0)).unwrap().values(), [0; 4]);
    }
}
