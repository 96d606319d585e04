//! The questions that every kernel answers.

use crate::{
    Array, Capabilities, Cell, Complex, CornerId, Costs, EdgeId, FaceId, Id, KernelTask, Per, Pointer,
    VertexId,
};

/// A way of storing which corners meet where, with the same answers from every implementation.
///
/// A corner stands at one vertex and owns the *side* from there to the next corner's vertex. Faces, edges and
/// vertices are three ways of grouping corners, and the three star queries give those groups. Ids are dense and
/// the same in every kernel: vertices and faces keep the mesh's index, edges are numbered by (smaller vertex,
/// larger vertex), and corners by face and place. A degenerate face has an id but no corner.
///
/// The order of answers is fixed: a face's corners in its own order; an edge's ascending; a vertex's ascending,
/// or in rotational order where [`Capabilities::ordered_vertex_stars`] says so.
///
/// The iterators are `impl Iterator`: as fast as callbacks, and three times as fast as boxed ones. So there is no
/// `dyn Connectivity`; the kernel is chosen once a task.
///
/// # An implementer's guide
///
/// A kernel of another crate is one file, and one line that tests it:
///
/// ```text
/// meshmend_conformance::kernel!(my_kernel: MyKernel);      // in tests/laws.rs: a test for each law
/// ```
///
/// `examples/my-kernel` is a whole one to copy. With a [`Lesson`](crate::Lesson) the program lists, times and explains it.
///
/// **What is declared.** [`CAPABILITIES`](Self::CAPABILITIES) is one of the sets that [`Capabilities`] names, or such a set with another
/// field: `Capabilities { ordered_vertex_stars: true, ..Capabilities::TRIANGLES }`. A kernel that holds manifold meshes alone also
/// says `impl ManifoldConnectivity for MyKernel {}`.
///
/// **What is given.** [`assemble`](Self::assemble) gets a [`Complex`]: the faces as a [`FaceTable`](crate::FaceTable), and the edges as an
/// [`EdgeTable`](crate::EdgeTable). It is called only for complexes that have none of the defects which [`CAPABILITIES`](Self::CAPABILITIES)
/// leaves out, so it needs no error. It may be called for a mesh without faces, and for one whose vertices are in no face.
///
/// **Which ids.** Vertices, faces and corners are those of the face table. Edge ids come from
/// [`complex.edges()`](Complex::edges): edges are numbered by their ends, the smaller vertex first, and
/// [`corner_edge`](crate::EdgeTable::corner_edge) and [`all_ends`](crate::EdgeTable::all_ends) give the numbers. Its `edge_corners` and
/// `edge_sides` are stars, which a kernel finds for itself: else its own structure is never tested.
///
/// **A structure without corners** still answers in corners: a corner is the side that begins there. A structure of edges stores a
/// side as its edge and one bit, left or right of the edge, and for each edge the corners of both sides. That is 24 of the 78 bytes a
/// triangle of a winged edge.
///
/// **Where stars begin.** A face begins at its first corner in the table; "any edge of the face" is not enough. An edge lists its
/// corners ascending. A vertex lists its corners ascending, or, with [`Capabilities::ordered_vertex_stars`], in one walk,
/// counter-clockwise as the face of its lowest corner runs: from the boundary on, or else from the lowest corner. Where all faces
/// agree, the walk goes from a corner to `across(prev_corner(c))`, and on the boundary it begins at the corner with nothing across.
///
/// **Degenerate faces** have an id and no corners. They are counted by [`face_count`](Self::face_count), also in a kernel that holds triangles
/// alone: so the face of corner `c` is not always `c / 3`. [`FaceIndex`](crate::FaceIndex) is the face table with the face of each corner in
/// constant time, and takes no memory beside it where every face is a triangle.
///
/// **Boundaries.** An edge with one side has no opposite: [`across`](Self::across) is `None` there. Structures that link everything need a
/// record for the hole, or a mark.
///
/// **What it costs.** [`COSTS`](Self::COSTS) says what the first answer takes where that is not constant. A kernel that
/// searches the whole mesh for the corners of a vertex says [`Linear`](crate::Cost::Linear); it is then not held to more, and
/// overrides [`ask_of_all_vertices`](Self::ask_of_all_vertices) in one line, so that checks of large meshes stay near-linear.
///
/// **What it takes.** [`heap_bytes`](Self::heap_bytes) counts what the kernel keeps alive on the heap beside the face table: capacity, not
/// length. [`Lists`](crate::Lists) groups items by their owners, which is what most of `assemble` does, and [`Column`](crate::Column) is a vector
/// that is indexed by ids; both know their bytes and name themselves for [`arrays`](Self::arrays). The bytes are held against the
/// allocator by `meshmend_conformance::kernel_size!(MyKernel)`, in a test file of its own.
///
/// **What it shows.** [`pointers`](Self::pointers) gives the fields as they are stored: what arithmetic finds is not a field. A field that
/// would cross the boundary says [`Hole`](crate::Target::Hole); one that is empty says [`Nothing`](crate::Target::Nothing).
///
/// **What it is good at.** Every provided method may be overridden by a faster one that gives the same answer in the same order;
/// algorithms ask it.
pub trait Connectivity: Sized + Send + Sync {
    /// What the kernel is called in commands and reports.
    const NAME: &'static str;
    /// What it holds and what it offers.
    const CAPABILITIES: Capabilities;

    /// What its answers cost.
    const COSTS: Costs = Costs::CONSTANT;

    /// Builds the index. Only for a complex that [`admission`](crate::admission()) has nothing against: there it
    /// can't fail. [`Build::build`](crate::Build::build) asks first.
    fn assemble(complex: &Complex) -> Self;

    /// How many vertices the mesh has, unreferenced ones included.
    fn vertex_count(&self) -> usize;
    /// How many edges the complex has.
    fn edge_count(&self) -> usize;
    /// How many faces the mesh has, degenerate ones included.
    fn face_count(&self) -> usize;
    /// How many corners the complex has.
    fn corner_count(&self) -> usize;

    /// The vertex at which a corner stands.
    fn corner_vertex(&self, corner: CornerId) -> VertexId;
    /// The edge along which its side runs.
    fn corner_edge(&self, corner: CornerId) -> EdgeId;
    /// The face that it belongs to.
    fn corner_face(&self, corner: CornerId) -> FaceId;
    /// The following corner of its face.
    fn next_corner(&self, corner: CornerId) -> CornerId;
    /// The preceding corner of its face.
    fn prev_corner(&self, corner: CornerId) -> CornerId;
    /// The two vertices of an edge, the smaller one first.
    fn edge_ends(&self, edge: EdgeId) -> [VertexId; 2];

    /// The corners of a face, in its order.
    fn face_corners(&self, face: FaceId) -> impl Iterator<Item = CornerId> + Clone;
    /// The corners whose sides run along an edge, ascending.
    fn edge_corners(&self, edge: EdgeId) -> impl Iterator<Item = CornerId> + Clone;
    /// The corners that stand at a vertex.
    fn vertex_corners(&self, vertex: VertexId) -> impl Iterator<Item = CornerId> + Clone;

    /// Bytes on the heap that the kernel keeps alive beside the face table itself.
    fn heap_bytes(&self) -> usize;

    /// The arrays that it consists of. Together they are [`heap_bytes`](Connectivity::heap_bytes): arrays of the face
    /// table itself are not among them. A kernel that does not name them is one array.
    fn arrays(&self) -> Vec<Array> {
        vec![Array::new("everything", Per::Corner, 1, self.heap_bytes())]
    }

    /// The fields of the record that stands for an element, with what they lead to; none where the kernel has no such
    /// record, or does not name its fields. Fields of a corner that are called `next`, `prev` and `twin` must agree with
    /// [`next_corner`](Connectivity::next_corner), [`prev_corner`](Connectivity::prev_corner) and [`across`](Connectivity::across).
    fn pointers(&self, of: Cell) -> Vec<Pointer> {
        let _ = of;
        Vec::new()
    }

    /// Every vertex, ascending.
    fn vertices(&self) -> impl ExactSizeIterator<Item = VertexId> + DoubleEndedIterator + Clone + use<Self> {
        (0..self.vertex_count()).map(VertexId::new)
    }

    /// Every edge, ascending.
    fn edges(&self) -> impl ExactSizeIterator<Item = EdgeId> + DoubleEndedIterator + Clone + use<Self> {
        (0..self.edge_count()).map(EdgeId::new)
    }

    /// Every face, ascending.
    fn faces(&self) -> impl ExactSizeIterator<Item = FaceId> + DoubleEndedIterator + Clone + use<Self> {
        (0..self.face_count()).map(FaceId::new)
    }

    /// Every corner, ascending.
    fn corners(&self) -> impl ExactSizeIterator<Item = CornerId> + DoubleEndedIterator + Clone + use<Self> {
        (0..self.corner_count()).map(CornerId::new)
    }

    /// The vertices of a face, in its order.
    fn face_vertices(&self, face: FaceId) -> impl Iterator<Item = VertexId> + Clone {
        self.face_corners(face).map(|c| self.corner_vertex(c))
    }

    /// Whether a face has corners, that is, takes part in the complex.
    fn is_proper_face(&self, face: FaceId) -> bool {
        self.face_corners(face).next().is_some()
    }

    /// Whether a vertex is in some face of the complex.
    fn is_referenced(&self, vertex: VertexId) -> bool {
        self.vertex_corners(vertex).next().is_some()
    }

    /// How many sides run along an edge.
    fn edge_degree(&self, edge: EdgeId) -> usize {
        self.edge_corners(edge).count()
    }

    /// The faces along an edge, one for each of its uses.
    fn edge_faces(&self, edge: EdgeId) -> impl Iterator<Item = FaceId> + Clone {
        self.edge_corners(edge).map(|c| self.corner_face(c))
    }

    /// The faces at a vertex, one for each of its corners.
    fn vertex_faces(&self, vertex: VertexId) -> impl Iterator<Item = FaceId> + Clone {
        self.vertex_corners(vertex).map(|c| self.corner_face(c))
    }

    /// The corners whose sides run along an edge, ascending, each with whether its side runs from the smaller to the
    /// larger vertex.
    fn edge_sides(&self, edge: EdgeId) -> impl Iterator<Item = (CornerId, bool)> + Clone {
        let low = self.edge_ends(edge)[0];
        self.edge_corners(edge).map(move |corner| (corner, self.corner_vertex(corner) == low))
    }

    /// The vertex to which a corner's side runs.
    fn corner_target(&self, corner: CornerId) -> VertexId {
        self.corner_vertex(self.next_corner(corner))
    }

    /// Whether a corner's side runs from the smaller to the larger vertex of its edge.
    fn is_forward(&self, corner: CornerId) -> bool {
        self.corner_vertex(corner) == self.edge_ends(self.corner_edge(corner))[0]
    }

    /// The other side along the same edge, where there are exactly two.
    fn across(&self, corner: CornerId) -> Option<CornerId> {
        let mut sides = self.edge_corners(self.corner_edge(corner));
        let (one, other) = (sides.next()?, sides.next()?);
        if sides.next().is_some() {
            None
        } else if one == corner {
            Some(other)
        } else {
            Some(one)
        }
    }

    /// The edges at a vertex, each once, ascending.
    fn vertex_edges(&self, vertex: VertexId) -> impl Iterator<Item = EdgeId> + Clone {
        let both = |corner| [self.corner_edge(corner), self.corner_edge(self.prev_corner(corner))];
        let mut edges: Vec<EdgeId> = self.vertex_corners(vertex).flat_map(both).collect();
        edges.sort_unstable();
        edges.dedup();
        edges.into_iter()
    }

    /// The vertices that an edge joins to a vertex, each once, ascending: the order of the edges is theirs.
    fn vertex_neighbours(&self, vertex: VertexId) -> impl Iterator<Item = VertexId> + Clone {
        self.vertex_edges(vertex).map(move |edge| {
            let [low, high] = self.edge_ends(edge);
            if low == vertex { high } else { low }
        })
    }

    /// The vertices to which the sides run that begin at a vertex: one for each of its corners, in their order.
    fn vertex_ring(&self, vertex: VertexId) -> impl Iterator<Item = VertexId> + Clone {
        self.vertex_corners(vertex).map(|corner| self.corner_target(corner))
    }

    /// Asks a question that looks at the corners of all vertices.
    ///
    /// A kernel that takes [linear](crate::Cost::Linear) time for one vertex overrides this, and has the question asked of itself
    /// [`Grouped`](crate::Grouped), so that it stays near-linear.
    fn ask_of_all_vertices<T: KernelTask>(&self, task: T) -> T::Output {
        task.run(self)
    }

    /// The boundary edge at the other end of a fan of corners: from a boundary edge round one of its vertices, from face
    /// to face over edges of two sides, whichever way these run.
    ///
    /// `None` where the edge is not on the boundary or the vertex is not its end, and where the fan ends at an edge of
    /// three sides or more.
    fn next_boundary_edge(&self, edge: EdgeId, at: VertexId) -> Option<EdgeId> {
        let mut sides = self.edge_corners(edge);
        let (mut side, None) = (sides.next()?, sides.next()) else { return None };
        if !self.edge_ends(edge).contains(&at) {
            return None;
        }
        loop {
            // The side comes to the vertex or leaves it; the face's other side there is the next or the previous one.
            let leaves = self.corner_vertex(side) == at;
            side = if leaves { self.prev_corner(side) } else { self.next_corner(side) };
            let edge = self.corner_edge(side);
            let mut sides = self.edge_corners(edge);
            match (sides.next()?, sides.next(), sides.next()) {
                (_, None, _) => return Some(edge),
                (one, Some(other), None) => side = if one == side { other } else { one },
                _ => return None,
            }
        }
    }
}

/// A kernel whose every edge has one side or two, so that a side has at most one opposite.
pub trait ManifoldConnectivity: Connectivity {
    /// The other side along the same edge; `None` on the boundary. It is [`across`](Connectivity::across), which
    /// has nothing else to leave out here.
    #[inline]
    fn opposite(&self, corner: CornerId) -> Option<CornerId> {
        self.across(corner)
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::{EdgeUse, FaceTable};

    fn kernel(faces: &[[u32; 3]]) -> EdgeUse {
        let corners = faces.iter().flatten().copied().map(VertexId).collect();
        EdgeUse::assemble(&Complex::of(&Arc::new(FaceTable::triangles(9, corners).unwrap())))
    }

    fn next(kernel: &EdgeUse, ends: [u32; 2], at: u32) -> Option<[u32; 2]> {
        let edge = kernel.edges().find(|&edge| kernel.edge_ends(edge) == ends.map(VertexId)).unwrap();
        let next = kernel.next_boundary_edge(edge, VertexId(at))?;
        Some(kernel.edge_ends(next).map(|end| end.0))
    }

    #[test]
    fn the_boundary_goes_on_where_the_fan_ends_whichever_way_its_faces_run() {
        for faces in [[[0, 1, 2], [0, 2, 3], [0, 3, 4]], [[0, 1, 2], [3, 2, 0], [0, 3, 4]]] {
            let kernel = kernel(&faces);
            assert_eq!(next(&kernel, [0, 1], 0), Some([0, 4]));
            assert_eq!(next(&kernel, [0, 4], 0), Some([0, 1]));
            assert_eq!(next(&kernel, [0, 1], 1), Some([1, 2]));
            assert_eq!(next(&kernel, [1, 2], 2), Some([2, 3]));
            assert_eq!(next(&kernel, [0, 2], 0), None, "an edge inside");
            assert_eq!(next(&kernel, [0, 1], 4), None, "a vertex elsewhere");
        }
    }

    #[test]
    fn each_fan_of_a_pinched_vertex_has_its_own_two_edges_and_a_book_ends_at_its_spine() {
        let bow_tie = kernel(&[[0, 1, 2], [0, 3, 4]]);
        assert_eq!([next(&bow_tie, [0, 1], 0), next(&bow_tie, [0, 3], 0)], [Some([0, 2]), Some([0, 4])]);
        let book = kernel(&[[0, 1, 2], [0, 1, 3], [0, 1, 4]]);
        assert_eq!(next(&book, [0, 2], 0), None);
        assert_eq!(next(&book, [0, 2], 2), Some([1, 2]));
    }

    #[test]
    fn neighbours_come_once_and_ascending_the_ring_as_the_corners_do() {
        let kernel = kernel(&[[5, 1, 2], [5, 2, 1], [5, 8, 0]]);
        assert!(kernel.vertex_neighbours(VertexId(5)).eq([0, 1, 2, 8].map(VertexId)));
        assert!(kernel.vertex_ring(VertexId(5)).eq([1, 2, 8].map(VertexId)));
        assert!(kernel.vertex_edges(VertexId(5)).is_sorted());
        assert_eq!(kernel.vertex_edges(VertexId(3)).count(), 0);
    }
}
