//! Which vertices moved.

use std::fmt;

use meshmend_core::VertexId;
use serde::Serialize;

/// A vertex at the place of a lower one, and what became of it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ApartRecord {
    /// The vertex.
    pub vertex: VertexId,
    /// The lowest vertex at its place.
    pub stays: VertexId,
    /// What became of it.
    #[serde(flatten)]
    pub fate: ApartFate,
}

/// What became of a vertex at the place of another.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum ApartFate {
    /// It has a place of its own.
    Moved {
        /// How far it moved.
        length: f64,
        /// By how many steps of single precision.
        steps: u32,
    },
    /// It is where it was.
    Left {
        /// Why.
        left: NotMoved,
    },
}

/// Why a vertex can't be kept apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum NotMoved {
    /// One of its faces is not a triangle.
    Polygon,
    /// At every place within a few steps a triangle turns over or loses its area, or another vertex is there.
    NoRoom,
    /// A face at it would cross another one.
    Crossing,
}

impl ApartRecord {
    /// Whether the vertex has a place of its own.
    pub fn is_moved(&self) -> bool {
        matches!(self.fate, ApartFate::Moved { .. })
    }
}

impl fmt::Display for ApartRecord {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ApartRecord { vertex, stays, fate } = self;
        write!(f, "{vertex} at the place of {stays}: ")?;
        match fate {
            ApartFate::Moved { length, steps } => {
                let steps = meshmend_core::counted(*steps as usize, "step");
                write!(f, "moved by {length:e}, {steps} of single precision")
            }
            ApartFate::Left { left: NotMoved::Polygon } => {
                write!(f, "left, as a face there is not a triangle")
            }
            ApartFate::Left { left: NotMoved::NoRoom } => {
                write!(f, "left, as it finds no place where no triangle turns over")
            }
            ApartFate::Left { left: NotMoved::Crossing } => {
                write!(f, "left, as a face there would cross another one")
            }
        }
    }
}
