//! The boundary of a set of cells, and of a boundary.

use meshmend_core::{FaceId, Id, Incidence, VertexId};

use super::cell_sets::{closure, pure_dimension};
use super::{CellSet, IncidenceMatrices};

impl IncidenceMatrices {
    /// Whether ∂₁∂₂ = 0: the boundary of a boundary is nothing. It is so for every complex.
    ///
    /// *Cost*: linear, and d log d for a face of d corners.
    pub fn boundary_of_boundary_is_zero(&self) -> bool {
        let mut terms: Vec<(VertexId, i64)> = Vec::new();
        (0..self.cell_counts()[2]).all(|face| {
            terms.clear();
            for (edge, times) in self.boundary_of_face(FaceId::new(face)) {
                terms.extend(self.boundary_of_edge(edge).map(|(vertex, sign)| (vertex, times * sign)));
            }
            terms.sort_unstable_by_key(|term| term.0);
            terms
                .chunk_by(|one, other| one.0 == other.0)
                .all(|run| run.iter().map(|term| term.1).sum::<i64>() == 0)
        })
    }

    /// The boundary of a set of cells that is a complex of one dimension: of faces the edges with one side of theirs, of
    /// edges the vertices with one of them, with all that these contain. `None` if it is no such set.
    ///
    /// ```
    /// use meshmend_core::{FaceId, FaceTable, PolygonMesh, VertexId};
    /// use meshmend_topology::matrices::{CellSet, IncidenceMatrices, closure};
    ///
    /// let faces = [0, 1, 2, 2, 1, 3].map(VertexId).to_vec();
    /// let mesh = PolygonMesh::new(vec![[0.0; 3]; 4], FaceTable::triangles(4, faces)?)?;
    /// let matrices = IncidenceMatrices::of(mesh.complex());
    /// let both = closure(&matrices, &CellSet::of([FaceId(0).into(), FaceId(1).into()]));
    /// assert_eq!(matrices.boundary(&both).map(|rim| rim.counts()), Some([4, 4, 0]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// *Cost*: n log n for n cells in the set.
    pub fn boundary(&self, cells: &CellSet) -> Option<CellSet> {
        let rim = match pure_dimension(self, cells)? {
            0 => CellSet::default(),
            1 => {
                let ends = cells.edges().iter().flat_map(|&edge| self.ends(edge));
                CellSet::from_parts(once(ends), Vec::new(), Vec::new())
            }
            _ => {
                let sides = cells.faces().iter().flat_map(|&face| self.sides_of(face));
                CellSet::from_parts(Vec::new(), once(sides), Vec::new())
            }
        };
        Some(closure(self, &rim))
    }
}

/// What occurs once, ascending.
fn once<T: Ord + Copy>(items: impl Iterator<Item = T>) -> Vec<T> {
    let mut items: Vec<T> = items.collect();
    items.sort_unstable();
    let runs = items.chunk_by(|one, other| one == other);
    runs.filter(|run| run.len() == 1).map(|run| run[0]).collect()
}

#[cfg(test)]
mod tests {
    use meshmend_core::{Cell, Connectivity, EdgeClass, EdgeId, edge_class};

    use super::*;
    use crate::shapes::{self, Shape};

    fn matrices(shape: &Shape) -> IncidenceMatrices {
        IncidenceMatrices::of(shape.mesh().complex())
    }

    #[test]
    fn the_boundary_of_all_faces_is_what_has_one_side() {
        for shape in [shapes::annulus(6), shapes::moebius_band(5), shapes::torus(3, 4), shapes::bow_tie()] {
            let (matrices, kernel) = (matrices(&shape), shape.kernel());
            let all = CellSet::of(kernel_cells(&shape));
            let rim = matrices.boundary(&all).unwrap();
            let expected: Vec<_> =
                kernel.edges().filter(|&e| edge_class(&kernel, e) == EdgeClass::Boundary).collect();
            assert_eq!(rim.edges(), expected);
            // A rim has no rim.
            if !rim.is_empty() {
                assert_eq!(matrices.boundary(&rim), Some(CellSet::default()));
            }
        }
    }

    #[test]
    fn a_set_without_one_dimension_has_no_boundary() {
        let matrices = matrices(&shapes::tetrahedron());
        assert_eq!(matrices.boundary(&CellSet::default()), None);
        assert_eq!(matrices.boundary(&CellSet::of([FaceId(0).into()])), None);
        let edge = closure(&matrices, &CellSet::of([EdgeId(0).into()]));
        assert_eq!(
            matrices.boundary(&edge).map(|ends| ends.vertices().to_vec()),
            Some(vec![VertexId(0), VertexId(1)])
        );
        let vertex = CellSet::of([VertexId(2).into()]);
        assert_eq!(matrices.boundary(&vertex), Some(CellSet::default()));
    }

    /// Every cell of a shape whose vertices are all referenced.
    fn kernel_cells(shape: &Shape) -> Vec<Cell> {
        let [vertices, edges, faces] = matrices(shape).cell_counts();
        let vertices = (0..vertices).map(|v| VertexId::new(v).into());
        let edges = (0..edges).map(|e| EdgeId::new(e).into());
        vertices.chain(edges).chain((0..faces).map(|f| FaceId::new(f).into())).collect()
    }
}
