//! A kernel whose stars all end.

use std::sync::Arc;

use meshmend_core::{
    Array, Capabilities, Cell, Complex, Connectivity, CornerId, Costs, EdgeId, FaceId, Pointer, VertexId,
};

use super::place::Place;
use super::query::Query;

/// A kernel of which every star ends after as many answers as there can be and one more, and which notes what it is asked.
pub(crate) struct Guarded<K> {
    kernel: K,
    most: usize,
    place: Arc<Place>,
}

impl<K: Connectivity> Guarded<K> {
    /// The kernel over a complex; what it is asked is noted in the place.
    pub(crate) fn new(kernel: K, complex: &Complex, place: &Arc<Place>) -> Self {
        let faces = complex.faces();
        let most = faces.corner_count().max(faces.vertex_count()).max(faces.face_count()) + 1;
        Guarded { kernel, most, place: Arc::clone(place) }
    }

    /// Asks a question that is answered at once.
    pub(crate) fn ask<T>(&self, query: Query, element: u32, answer: impl FnOnce(&K) -> T) -> T {
        self.place.ask(query, element);
        answer(&self.kernel)
    }

    /// Asks for a star.
    fn star<'a, I>(&'a self, query: Query, element: u32, answers: impl FnOnce(&'a K) -> I) -> Star<'a, I> {
        self.place.ask(query, element);
        Star { answers: answers(&self.kernel), left: self.most, place: &self.place, query, element }
    }
}

/// A star that ends, and notes that it is asked for each of its answers.
#[derive(Clone)]
struct Star<'a, I> {
    answers: I,
    left: usize,
    place: &'a Place,
    query: Query,
    element: u32,
}

impl<I: Iterator> Iterator for Star<'_, I> {
    type Item = I::Item;

    fn next(&mut self) -> Option<I::Item> {
        self.left = self.left.checked_sub(1)?;
        self.place.ask(self.query, self.element);
        self.answers.next()
    }
}

/// Number of a cell, for what is shown of a question.
fn number(cell: Cell) -> u32 {
    match cell {
        Cell::Vertex(id) => id.0,
        Cell::Edge(id) => id.0,
        Cell::Face(id) => id.0,
        Cell::Corner(id) => id.0,
    }
}

macro_rules! counts {
    ($($method:ident $query:ident,)*) => {
        $(fn $method(&self) -> usize {
            self.ask(Query::$query, 0, K::$method)
        })*
    };
}

macro_rules! answers {
    ($($method:ident($id:ident) -> $answer:ty, $query:ident;)*) => {
        $(fn $method(&self, of: $id) -> $answer {
            self.ask(Query::$query, of.0, |kernel| kernel.$method(of))
        })*
    };
}

macro_rules! stars {
    ($($method:ident($id:ident) -> $answer:ty, $query:ident;)*) => {
        $(fn $method(&self, of: $id) -> impl Iterator<Item = $answer> + Clone {
            self.star(Query::$query, of.0, |kernel| kernel.$method(of))
        })*
    };
}

macro_rules! ranges {
    ($($method:ident -> $answer:ty, $query:ident;)*) => {
        $(fn $method(&self) -> impl ExactSizeIterator<Item = $answer> + DoubleEndedIterator + Clone + use<K> {
            self.ask(Query::$query, 0, |kernel| kernel.$method().take(self.most))
        })*
    };
}

impl<K: Connectivity> Connectivity for Guarded<K> {
    const NAME: &'static str = K::NAME;
    const CAPABILITIES: Capabilities = K::CAPABILITIES;
    const COSTS: Costs = K::COSTS;

    fn assemble(complex: &Complex) -> Self {
        Guarded::new(K::assemble(complex), complex, &Arc::default())
    }

    counts! {
        vertex_count VERTEX_COUNT,
        edge_count EDGE_COUNT,
        face_count FACE_COUNT,
        corner_count CORNER_COUNT,
        heap_bytes HEAP_BYTES,
    }

    answers! {
        corner_vertex(CornerId) -> VertexId, CORNER_VERTEX;
        corner_edge(CornerId) -> EdgeId, CORNER_EDGE;
        corner_face(CornerId) -> FaceId, CORNER_FACE;
        next_corner(CornerId) -> CornerId, NEXT_CORNER;
        prev_corner(CornerId) -> CornerId, PREV_CORNER;
        edge_ends(EdgeId) -> [VertexId; 2], EDGE_ENDS;
        is_proper_face(FaceId) -> bool, IS_PROPER_FACE;
        is_referenced(VertexId) -> bool, IS_REFERENCED;
        edge_degree(EdgeId) -> usize, EDGE_DEGREE;
        corner_target(CornerId) -> VertexId, CORNER_TARGET;
        is_forward(CornerId) -> bool, IS_FORWARD;
        across(CornerId) -> Option<CornerId>, ACROSS;
    }

    stars! {
        face_corners(FaceId) -> CornerId, FACE_CORNERS;
        edge_corners(EdgeId) -> CornerId, EDGE_CORNERS;
        vertex_corners(VertexId) -> CornerId, VERTEX_CORNERS;
        face_vertices(FaceId) -> VertexId, FACE_VERTICES;
        edge_faces(EdgeId) -> FaceId, EDGE_FACES;
        vertex_faces(VertexId) -> FaceId, VERTEX_FACES;
        edge_sides(EdgeId) -> (CornerId, bool), EDGE_SIDES;
        vertex_edges(VertexId) -> EdgeId, VERTEX_EDGES;
        vertex_neighbours(VertexId) -> VertexId, VERTEX_NEIGHBOURS;
        vertex_ring(VertexId) -> VertexId, VERTEX_RING;
    }

    ranges! {
        vertices -> VertexId, VERTICES;
        edges -> EdgeId, EDGES;
        faces -> FaceId, FACES;
        corners -> CornerId, CORNERS;
    }

    fn arrays(&self) -> Vec<Array> {
        self.ask(Query::ARRAYS, 0, K::arrays)
    }

    fn pointers(&self, of: Cell) -> Vec<Pointer> {
        self.ask(Query::POINTERS, number(of), |kernel| kernel.pointers(of))
    }

    fn next_boundary_edge(&self, edge: EdgeId, at: VertexId) -> Option<EdgeId> {
        self.ask(Query::NEXT_BOUNDARY_EDGE, edge.0, |kernel| kernel.next_boundary_edge(edge, at))
    }
}
