//! What the record of an element refers to, as a kernel stores it.

use std::fmt;

use crate::{CornerId, EdgeId, FaceId, VertexId};

/// An element of a complex.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Cell {
    /// A vertex.
    Vertex(VertexId),
    /// An edge.
    Edge(EdgeId),
    /// A face.
    Face(FaceId),
    /// A corner, with its side.
    Corner(CornerId),
}

/// A field of a record, with what it refers to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pointer {
    /// The field's name, such as `next`.
    pub field: &'static str,
    /// To what it leads.
    pub to: Target,
}

/// To what a field of a record leads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// To an element.
    Cell(Cell),
    /// To a record that is not an element's, such as a half-edge along the boundary, by its number.
    Dart(u32),
    /// To a hole of the surface.
    Hole,
    /// The field says that there is nothing.
    Nothing,
}

impl Pointer {
    /// A field that leads to an element.
    pub fn new(field: &'static str, to: impl Into<Cell>) -> Self {
        Pointer { field, to: Target::Cell(to.into()) }
    }
}

macro_rules! cells {
    ($($variant:ident($id:ident),)*) => {
        $(impl From<$id> for Cell {
            fn from(id: $id) -> Self {
                Cell::$variant(id)
            }
        })*

        impl fmt::Display for Cell {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                match self {
                    $(Cell::$variant(id) => id.fmt(f),)*
                }
            }
        }
    };
}

cells! {
    Vertex(VertexId),
    Edge(EdgeId),
    Face(FaceId),
    Corner(CornerId),
}

impl fmt::Display for Target {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Target::Cell(cell) => cell.fmt(f),
            Target::Dart(number) => write!(f, "dart {number}"),
            Target::Hole => f.pad("a hole"),
            Target::Nothing => f.pad("–"),
        }
    }
}
