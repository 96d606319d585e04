//! The incidence matrices ∂₁ and ∂₂, by columns and by rows.
//!
//! ```text
//! ∂₁ columns    e0: v0 v1 | e1: v0 v2 | ...       the ends of each edge: −1 at the smaller one, +1 at the larger one
//! ∂₁ rows       v0: −e0 −e1 | v1: +e0 ...         the edges at each vertex
//! ∂₂ columns    f0: +e0 −e1 +e2 | ...             the edges of each face; + where its side runs as the edge does
//! ∂₂ rows       e0: +f0 −f3 | ...                 the faces along each edge
//! ```
//!
//! An entry is an index with its sign in the lowest bit. Zeros are not stored, and an entry of ±2 is stored as two of
//! ±1. Bytes a triangle of a closed mesh: ∂₁ 12 + 14, ∂₂ 12 + 18, together 56.
//!
//! A face that runs along an edge both ways has these two sides *lost*: they add up to nothing, though the face touches
//! the edge. They are listed beside the matrices, so that what touches what stays known.
//!
//! *Source*: H. Poincaré, *Second complément à l'Analysis Situs*, 1900.

use meshmend_core::{Adjacency, Array, Column, Complex, EdgeId, FaceId, Id, Incidence, Lists, Per, VertexId};

use super::entries::{Entry, FaceColumns, LostSide, added_up, range};

/// The boundary matrices of a complex: ∂₁ from edges to vertices, ∂₂ from faces to edges.
#[derive(Clone, Debug)]
pub struct IncidenceMatrices {
    edge_ends: Column<EdgeId, [VertexId; 2]>,
    vertex_edges: Lists<VertexId, Entry>,
    /// Where the entries of each face begin; absent if each face has three.
    face_starts: Option<Column<FaceId, u32>>,
    face_edges: Vec<Entry>,
    edge_faces: Lists<EdgeId, Entry>,
    /// By face and edge.
    lost_sides: Vec<LostSide>,
    /// By edge and face.
    lost_sides_by_edge: Vec<LostSide>,
    face_count: usize,
}

impl IncidenceMatrices {
    /// The matrices of a complex.
    ///
    /// *Cost*: linear, and d log d for a face of d corners.
    pub fn of(complex: &Complex) -> Self {
        let (faces, edges) = (complex.faces(), complex.edges());
        let ends = edges.all_ends();
        let of_vertices = (0..ends.len()).flat_map(|e| {
            let edge = EdgeId::new(e);
            [(ends[e][0], Entry::minus(edge)), (ends[e][1], Entry::plus(edge))]
        });
        let columns = FaceColumns::of(faces, edges);
        let of_edges = faces.faces().flat_map(|face| {
            let entries = columns.range(face).map(|at| columns.entries[at]);
            entries.map(move |entry| (entry.index(), Entry::signed(face, entry.sign() > 0)))
        });
        let mut lost_sides_by_edge = columns.lost_sides.clone();
        lost_sides_by_edge.sort_unstable_by_key(|lost| (lost.edge, lost.face));
        IncidenceMatrices {
            vertex_edges: Lists::group(faces.vertex_count(), of_vertices),
            edge_faces: Lists::group(ends.len(), of_edges),
            edge_ends: ends.to_vec().into(),
            face_starts: columns.starts.map(Column::from),
            face_edges: columns.entries,
            lost_sides: columns.lost_sides,
            lost_sides_by_edge,
            face_count: faces.face_count(),
        }
    }

    /// The sides that cancel, by face and edge.
    pub fn lost_sides(&self) -> &[LostSide] {
        &self.lost_sides
    }

    /// How many entries ∂₁ and ∂₂ have that are not 0; ±2 counts as one.
    pub fn entry_counts(&self) -> [usize; 2] {
        let of_faces = (0..self.face_count).map(|face| self.boundary_of_face(FaceId::new(face)).count());
        [2 * self.edge_ends.len(), of_faces.sum()]
    }

    /// A row of ∂₁: the edges at a vertex, ascending, with −1 where they begin and +1 where they end.
    pub fn coboundary_of_vertex(&self, vertex: VertexId) -> impl Iterator<Item = (EdgeId, i64)> {
        self.vertex_edges.of(vertex).iter().map(|entry| (entry.index(), entry.sign()))
    }

    /// A column of ∂₁: the ends of an edge, with −1 at the smaller one and +1 at the larger one.
    pub fn boundary_of_edge(&self, edge: EdgeId) -> [(VertexId, i64); 2] {
        let [low, high] = self.edge_ends[edge];
        [(low, -1), (high, 1)]
    }

    /// A row of ∂₂: the faces along an edge, ascending, each with its sides along it that run as the edge does, less
    /// those that run against it. A face is absent where these are equally many.
    pub fn coboundary_of_edge(&self, edge: EdgeId) -> impl Iterator<Item = (FaceId, i64)> {
        added_up(self.edge_faces.of(edge))
    }

    /// A column of ∂₂: the edges of a face, ascending, each as in [`coboundary_of_edge`](Self::coboundary_of_edge).
    pub fn boundary_of_face(&self, face: FaceId) -> impl Iterator<Item = (EdgeId, i64)> {
        added_up(self.face_entries(face))
    }

    /// Bytes on the heap.
    pub fn heap_bytes(&self) -> usize {
        self.arrays().iter().map(Array::bytes).sum()
    }

    /// The arrays of which the matrices consist.
    pub fn arrays(&self) -> Vec<Array> {
        let starts = |per| ("row starts", per);
        let [row_starts_1, rows_1] = self.vertex_edges.arrays(starts(Per::Vertex), ("rows of ∂₁", Per::Dart));
        let [row_starts_2, rows_2] = self.edge_faces.arrays(starts(Per::Edge), ("rows of ∂₂", Per::Corner));
        let lost = self.lost_sides.capacity() + self.lost_sides_by_edge.capacity();
        let mut arrays = vec![
            Array::of_column("columns of ∂₁", Per::Edge, &self.edge_ends),
            Array { name: "row starts of ∂₁", ..row_starts_1 },
            rows_1,
            Array::new("columns of ∂₂", Per::Corner, size_of::<Entry>(), self.face_edges.capacity()),
            Array { name: "row starts of ∂₂", ..row_starts_2 },
            rows_2,
        ];
        if let Some(starts) = &self.face_starts {
            arrays.push(Array::of_column("column starts of ∂₂", Per::Face, starts));
        }
        if lost > 0 {
            arrays.push(Array::new("lost sides", Per::Corner, size_of::<LostSide>(), lost));
        }
        arrays
    }

    /// How many vertices are in an edge, and how many faces have a side: the vertices and faces of the complex.
    pub(super) fn proper_counts(&self) -> [usize; 2] {
        let vertices =
            (0..self.vertex_edges.len()).filter(|&v| !self.vertex_edges.of(VertexId::new(v)).is_empty());
        let faces = (0..self.face_count).filter(|&face| self.is_proper(FaceId::new(face)));
        [vertices.count(), faces.count()]
    }

    /// Whether a face has a side, that is, takes part in the complex.
    pub fn is_proper(&self, face: FaceId) -> bool {
        !self.face_entries(face).is_empty() || !self.lost_of(face).is_empty()
    }

    fn face_entries(&self, face: FaceId) -> &[Entry] {
        &self.face_edges[range(self.face_starts.as_ref().map(Column::values), face)]
    }

    fn lost_of(&self, face: FaceId) -> &[LostSide] {
        run_of(&self.lost_sides, |lost| lost.face, face)
    }

    fn lost_along(&self, edge: EdgeId) -> &[LostSide] {
        run_of(&self.lost_sides_by_edge, |lost| lost.edge, edge)
    }

    /// The edge of each side of a face, cancelled ones too.
    pub(super) fn sides_of(&self, face: FaceId) -> impl Iterator<Item = EdgeId> {
        let lost = self.lost_of(face).iter();
        let lost = lost.flat_map(|lost| std::iter::repeat_n(lost.edge, 2 * lost.pairs as usize));
        self.face_entries(face).iter().map(|entry| entry.index()).chain(lost)
    }
}

impl Adjacency for IncidenceMatrices {
    const VIEW: &'static str = "incidence-matrices";

    fn graph_counts(&self) -> [usize; 2] {
        [self.vertex_edges.len(), self.edge_ends.len()]
    }

    fn neighbours(&self, vertex: VertexId) -> impl Iterator<Item = VertexId> {
        // Edges are numbered by their ends, so at a vertex they ascend as their other ends do.
        self.vertex_edges.of(vertex).iter().map(|entry| {
            let [low, high] = self.edge_ends[entry.index()];
            if entry.sign() > 0 { low } else { high }
        })
    }
}

impl Incidence for IncidenceMatrices {
    fn cell_counts(&self) -> [usize; 3] {
        [self.vertex_edges.len(), self.edge_ends.len(), self.face_count]
    }

    fn ends(&self, edge: EdgeId) -> [VertexId; 2] {
        self.edge_ends[edge]
    }

    fn edges_at(&self, vertex: VertexId) -> impl Iterator<Item = EdgeId> {
        self.vertex_edges.of(vertex).iter().map(|entry| entry.index())
    }

    fn faces_along(&self, edge: EdgeId) -> impl Iterator<Item = FaceId> {
        merged(
            self.coboundary_of_edge(edge).map(|entry| entry.0),
            self.lost_along(edge).iter().map(|lost| lost.face),
        )
    }

    fn edges_of(&self, face: FaceId) -> impl Iterator<Item = EdgeId> {
        merged(
            self.boundary_of_face(face).map(|entry| entry.0),
            self.lost_of(face).iter().map(|lost| lost.edge),
        )
    }
}

/// The items whose key is this one, of items that are sorted by it.
fn run_of<T, Key: Ord>(items: &[T], key: impl Fn(&T) -> Key, wanted: Key) -> &[T] {
    let start = items.partition_point(|item| key(item) < wanted);
    let rest = &items[start..];
    &rest[..rest.partition_point(|item| key(item) <= wanted)]
}

/// The union of two ascending sequences, ascending, each item once.
fn merged<T: Ord>(one: impl Iterator<Item = T>, other: impl Iterator<Item = T>) -> impl Iterator<Item = T> {
    let (mut one, mut other) = (one.peekable(), other.peekable());
    std::iter::from_fn(move || match (one.peek(), other.peek()) {
        (Some(first), Some(second)) if first == second => {
            other.next();
            one.next()
        }
        (Some(first), Some(second)) if second < first => other.next(),
        (None, _) => other.next(),
        _ => one.next(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::{self, Shape};

    fn matrices(shape: &Shape) -> IncidenceMatrices {
        IncidenceMatrices::of(shape.mesh().complex())
    }

    #[test]
    fn a_triangle_has_the_matrices_of_the_text() {
        let matrices = matrices(&Shape::of(&[&[0, 1, 2]]));
        let row =
            |v| matrices.coboundary_of_vertex(VertexId(v)).map(|(e, sign)| (e.0, sign)).collect::<Vec<_>>();
        assert_eq!([row(0), row(1), row(2)], [[(0, -1), (1, -1)], [(0, 1), (2, -1)], [(1, 1), (2, 1)]]);
        let column: Vec<_> = matrices.boundary_of_face(FaceId(0)).map(|(e, sign)| (e.0, sign)).collect();
        assert_eq!(column, [(0, 1), (1, -1), (2, 1)]);
        assert_eq!(matrices.coboundary_of_edge(EdgeId(1)).collect::<Vec<_>>(), [(FaceId(0), -1)]);
    }

    #[test]
    fn a_closed_triangle_mesh_takes_56_bytes_a_triangle() {
        let grid = shapes::torus(20, 20);
        let cut = grid.0.iter().flat_map(|q| [vec![q[0], q[1], q[2]], vec![q[2], q[3], q[0]]]);
        let found = matrices(&Shape(cut.collect()));
        assert_eq!(found.heap_bytes(), 56 * 800 + 2 * size_of::<u32>());
        assert_eq!(found.arrays().len(), 6);
    }

    #[test]
    fn sides_along_one_edge_add_up_or_are_lost() {
        // A spike (there and back along v2 v3), a strip round a Möbius core (twice along v0 v1), and both at once.
        let found = matrices(&Shape::of(&[&[0, 1, 2, 3, 2], &[0, 1, 4, 0, 1, 5], &[6, 7, 8, 6, 7, 6, 7]]));
        let entries = |f| found.boundary_of_face(FaceId(f)).map(|entry| entry.1).collect::<Vec<_>>();
        assert_eq!(entries(0), [1, -1, 1]);
        assert_eq!(entries(1), [2, -1, -1, 1, 1], "{:?}", found.ends(EdgeId(0)));
        let lost: Vec<_> = found.lost_sides().iter().map(|lost| (lost.face.0, lost.pairs)).collect();
        assert_eq!(lost, [(0, 1), (2, 2)]);
        let edges = found.edges_of(FaceId(0)).map(|edge| found.ends(edge).map(|v| v.0)).collect::<Vec<_>>();
        assert_eq!(edges, [[0, 1], [0, 2], [1, 2], [2, 3]]);
        let spike = found.lost_sides()[0].edge;
        assert_eq!(found.faces_along(spike).collect::<Vec<_>>(), [FaceId(0)]);
        assert_eq!(found.coboundary_of_edge(spike).count(), 0);
        assert!(found.boundary_of_boundary_is_zero());
        assert_eq!(found.entry_counts()[1], 3 + 5 + entries(2).len());
    }
}
