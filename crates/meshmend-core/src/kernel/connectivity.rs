//! The questions that every kernel answers.

use crate::{Capabilities, Complex, CornerId, EdgeId, FaceId, Id, VertexId};

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
pub trait Connectivity: Sized + Send + Sync {
    /// What the kernel is called in commands and reports.
    const NAME: &'static str;
    /// What it holds and what it offers.
    const CAPABILITIES: Capabilities;

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
