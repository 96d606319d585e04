//! What the record of an element refers to, as a kernel stores it.

use std::fmt;
use std::str::FromStr;

use crate::{Connectivity, CornerId, EdgeId, FaceId, Id, VertexId, printable};

/// A cell of a complex, or a corner of one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "kebab-case"))]
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
    /// To a hole of the surface: the field would lead across the boundary.
    Hole,
    /// The field says that there is nothing: a vertex in no face has no first corner.
    Nothing,
}

impl Cell {
    /// Whether a kernel's complex has it.
    pub fn is_in<K: Connectivity>(self, kernel: &K) -> bool {
        match self {
            Cell::Vertex(vertex) => vertex.index() < kernel.vertex_count(),
            Cell::Edge(edge) => edge.index() < kernel.edge_count(),
            Cell::Face(face) => face.index() < kernel.face_count(),
            Cell::Corner(corner) => corner.index() < kernel.corner_count(),
        }
    }
}

impl Pointer {
    /// A field that leads to an element.
    pub fn new(field: &'static str, to: impl Into<Cell>) -> Self {
        Pointer { field, to: Target::Cell(to.into()) }
    }
}

/// A text that does not name an element.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CellError(String);

impl fmt::Display for CellError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "`{}` is not an element: v, e, f or c and a number, such as e3", printable(&self.0))
    }
}

impl std::error::Error for CellError {}

macro_rules! cells {
    ($($variant:ident($id:ident) = $letter:literal,)*) => {
        /// An element as it is written in reports: `v0`, `e3`, `f2` or `c7`.
        impl FromStr for Cell {
            type Err = CellError;
            fn from_str(text: &str) -> Result<Self, CellError> {
                $(if let Some(digits) = text.strip_prefix($letter)
                    && digits.bytes().all(|byte| byte.is_ascii_digit())
                    && let Ok(number) = digits.parse()
                {
                    return Ok(Cell::$variant($id(number)));
                })*
                Err(CellError(text.to_owned()))
            }
        }

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
    Vertex(VertexId) = 'v',
    Edge(EdgeId) = 'e',
    Face(FaceId) = 'f',
    Corner(CornerId) = 'c',
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn elements_are_read_as_they_are_written() {
        for text in ["v0", "e3", "f12", "c4294967295"] {
            assert_eq!(text.parse::<Cell>().map(|cell| cell.to_string()).as_deref(), Ok(text));
        }
        for text in ["", "v", "x1", "3", "e-1", "e+1", "e 1", "v4294967296", "V1", "e1x"] {
            assert!(text.parse::<Cell>().is_err(), "{text}");
        }
    }
}
