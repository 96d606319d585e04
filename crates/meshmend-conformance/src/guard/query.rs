//! The questions that a kernel can be asked, by name.

use std::fmt;

use meshmend_core::{CornerId, EdgeId, FaceId, VertexId};

/// A question of [`Connectivity`](meshmend_core::Connectivity).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Query(u8);

/// About what a question is.
#[derive(Clone, Copy)]
enum Of {
    Mesh,
    Vertex,
    Edge,
    Face,
    Corner,
    Cell,
}

macro_rules! queries {
    ($($constant:ident $name:literal $of:ident,)*) => {
        /// The places of the questions in the table.
        #[allow(non_camel_case_types, clippy::upper_case_acronyms, reason = "one name for each constant")]
        enum Place { $($constant,)* }

        impl Query {
            $(pub(crate) const $constant: Query = Query(Place::$constant as u8);)*
        }

        const TABLE: &[(&str, Of)] = &[$(($name, Of::$of),)*];
    };
}

queries! {
    NONE "nothing" Mesh,
    ASSEMBLE "assemble" Mesh,
    VERTEX_COUNT "vertex_count" Mesh,
    EDGE_COUNT "edge_count" Mesh,
    FACE_COUNT "face_count" Mesh,
    CORNER_COUNT "corner_count" Mesh,
    CORNER_VERTEX "corner_vertex" Corner,
    CORNER_EDGE "corner_edge" Corner,
    CORNER_FACE "corner_face" Corner,
    NEXT_CORNER "next_corner" Corner,
    PREV_CORNER "prev_corner" Corner,
    EDGE_ENDS "edge_ends" Edge,
    FACE_CORNERS "face_corners" Face,
    EDGE_CORNERS "edge_corners" Edge,
    VERTEX_CORNERS "vertex_corners" Vertex,
    HEAP_BYTES "heap_bytes" Mesh,
    ARRAYS "arrays" Mesh,
    POINTERS "pointers" Cell,
    VERTICES "vertices" Mesh,
    EDGES "edges" Mesh,
    FACES "faces" Mesh,
    CORNERS "corners" Mesh,
    FACE_VERTICES "face_vertices" Face,
    IS_PROPER_FACE "is_proper_face" Face,
    IS_REFERENCED "is_referenced" Vertex,
    EDGE_DEGREE "edge_degree" Edge,
    EDGE_FACES "edge_faces" Edge,
    VERTEX_FACES "vertex_faces" Vertex,
    EDGE_SIDES "edge_sides" Edge,
    CORNER_TARGET "corner_target" Corner,
    IS_FORWARD "is_forward" Corner,
    ACROSS "across" Corner,
    VERTEX_EDGES "vertex_edges" Vertex,
    VERTEX_NEIGHBOURS "vertex_neighbours" Vertex,
    VERTEX_RING "vertex_ring" Vertex,
    NEXT_BOUNDARY_EDGE "next_boundary_edge" Edge,
    OPPOSITE "opposite" Corner,
}

impl Query {
    pub(crate) fn number(self) -> u8 {
        self.0
    }

    /// The question of a number; the last one of all for a number that has none.
    pub(crate) fn of_number(number: u8) -> Self {
        Query(number.min(TABLE.len() as u8 - 1))
    }

    /// The question about one element, such as `vertex_corners(v0)`.
    pub(crate) fn about(self, element: u32) -> impl fmt::Display {
        let (name, of) = TABLE[usize::from(self.0)];
        match of {
            Of::Mesh => format!("{name}()"),
            Of::Vertex => format!("{name}({})", VertexId(element)),
            Of::Edge => format!("{name}({})", EdgeId(element)),
            Of::Face => format!("{name}({})", FaceId(element)),
            Of::Corner => format!("{name}({})", CornerId(element)),
            Of::Cell => format!("{name}(…)"),
        }
    }
}
