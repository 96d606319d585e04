//! How does a surface look as a combinatorial map: three permutations of its half-edges?
//!
//! A half-edge is a side of a face, or runs along the boundary. σ goes on to the next one out of the same vertex,
//! counter-clockwise; α to the other one of the same edge; φ to the next one of the same face or hole. Going along an edge
//! back and then on round the vertex is going round the face, so two of them say all: σ = α after the inverse of φ.
//!
//! *Source*: J. Edmonds, *A combinatorial representation for polyhedral surfaces*, 1960; the σ, α, φ of combinatorial maps.

use meshmend_core::{Capabilities, Complex, Connectivity, CornerId, EdgeUse, Id, Refusal, admission};

/// The half-edges of an oriented surface with three permutations of them, each as its cycles.
///
/// The half-edges of faces have the numbers of their corners; those along the boundary follow in the order of their edges.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Permutations {
    /// How many half-edges are sides of faces.
    pub corner_count: usize,
    /// How many there are.
    pub dart_count: usize,
    /// The cycles of σ: one for each vertex in a face.
    pub around_vertices: Vec<Vec<u32>>,
    /// The cycles of α: one for each edge.
    pub along_edges: Vec<Vec<u32>>,
    /// The cycles of φ: one for each face, and one for each hole.
    pub around_faces: Vec<Vec<u32>>,
}

/// What half-edges ask of a mesh.
const ORIENTED: Capabilities = Capabilities::ORIENTED_SURFACES;

/// The permutations of a complex.
///
/// ```
/// use meshmend_core::PolygonMesh;
/// use meshmend_topology::permutations;
///
/// let mesh = PolygonMesh::from_triangles(&[[0.0; 3]; 3], &[[0, 1, 2]])?;
/// let found = permutations(mesh.complex())?;
/// assert_eq!(found.around_faces, [vec![0, 1, 2], vec![3, 4, 5]]);
/// assert_eq!(found.along_edges, [[0, 3], [1, 5], [2, 4]]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// When the complex is not an oriented surface of simple faces: every reason why.
///
/// *Cost*: near-linear.
pub fn permutations(complex: &Complex) -> Result<Permutations, Refusal> {
    let defects = admission(complex, &ORIENTED);
    if !defects.is_empty() {
        return Err(Refusal { kernel: "half-edge", defects });
    }
    let kernel = EdgeUse::assemble(complex);
    let corner_count = kernel.corner_count();
    let lone: Vec<CornerId> = kernel.edges().filter_map(|edge| lone_side(&kernel, edge)).collect();
    let dart_count = corner_count + lone.len();
    let mut twin: Vec<u32> = vec![0; dart_count];
    for corner in kernel.corners() {
        twin[corner.index()] = kernel.across(corner).map_or(u32::MAX, |other| other.0);
    }
    for (place, side) in lone.iter().enumerate() {
        let dart = (corner_count + place) as u32;
        (twin[side.index()], twin[dart as usize]) = (dart, side.0);
    }
    let mut next: Vec<u32> = kernel.corners().map(|corner| kernel.next_corner(corner).0).collect();
    next.extend(lone.iter().map(|&side| {
        // A half-edge along the boundary ends where its side begins, and goes on along the edge after the fan there.
        let at = kernel.corner_vertex(side);
        let edge = kernel.next_boundary_edge(kernel.corner_edge(side), at);
        edge.and_then(|edge| lone_side(&kernel, edge)).map_or(twin[side.index()], |side| twin[side.index()])
    }));
    let mut turned = vec![0; dart_count];
    for (dart, &after) in next.iter().enumerate() {
        turned[after as usize] = twin[dart];
    }
    Ok(Permutations {
        corner_count,
        dart_count,
        around_vertices: cycles(&turned),
        along_edges: cycles(&twin),
        around_faces: cycles(&next),
    })
}

/// The side of an edge that has one alone.
fn lone_side(kernel: &EdgeUse, edge: meshmend_core::EdgeId) -> Option<CornerId> {
    let mut sides = kernel.edge_corners(edge);
    sides.next().filter(|_| sides.next().is_none())
}

/// A permutation in cycles, each from its lowest element, by those.
fn cycles(permutation: &[u32]) -> Vec<Vec<u32>> {
    let mut is_seen = vec![false; permutation.len()];
    let mut found = Vec::new();
    for first in 0..permutation.len() as u32 {
        let mut cycle = Vec::new();
        let mut element = first;
        while !std::mem::replace(&mut is_seen[element as usize], true) {
            cycle.push(element);
            element = permutation[element as usize];
        }
        if !cycle.is_empty() {
            found.push(cycle);
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use meshmend_testkit::worlds::oriented_triangle_sets;
    use meshmend_testkit::{Soup, shapes};

    use super::*;
    use crate::{boundary_loops, components};

    #[test]
    fn cycles_are_the_vertices_edges_faces_and_holes_and_the_last_is_the_first_two() {
        let mut seen = 0;
        let shapes =
            shapes::catalogue().into_iter().map(|shape| shape.soup).filter(|soup| soup.faces.len() < 200);
        let worlds = oriented_triangle_sets(4).map(|faces| Soup::generic(5, &faces));
        for soup in shapes.chain(worlds) {
            let complex = soup.complex();
            let Ok(found) = permutations(&complex) else { continue };
            seen += 1;
            let kernel = EdgeUse::assemble(&complex);
            let counts = [&found.around_vertices, &found.along_edges, &found.around_faces].map(Vec::len);
            let faces = kernel.faces().filter(|&face| kernel.is_proper_face(face)).count();
            let holes = boundary_loops(&kernel).count();
            let vertices = components(&kernel).referenced_vertices();
            assert_eq!(counts, [vertices, kernel.edge_count(), faces + holes]);
            assert!(found.along_edges.iter().all(|cycle| cycle.len() == 2));
            let map = |cycles: &[Vec<u32>]| {
                let mut to = vec![0; found.dart_count];
                for cycle in cycles {
                    cycle
                        .iter()
                        .zip(cycle.iter().cycle().skip(1))
                        .for_each(|(&from, &next)| to[from as usize] = next);
                }
                to
            };
            let [turn, twin, next] =
                [&found.around_vertices, &found.along_edges, &found.around_faces].map(|cycles| map(cycles));
            for dart in 0..found.dart_count {
                assert_eq!(turn[next[dart] as usize], twin[dart]);
            }
        }
        assert!(seen > 20, "{seen}");
    }

    #[test]
    fn what_is_not_an_oriented_surface_is_refused() {
        let book = Soup::generic(5, [[0, 1, 2], [1, 0, 3], [0, 1, 4]]);
        assert!(permutations(&book.complex()).is_err());
    }
}
