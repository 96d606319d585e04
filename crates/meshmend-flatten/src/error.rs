//! Why there is no layout.

use meshmend_core::{FaceId, VertexId};
use thiserror::Error;

/// Why there is no layout.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum FlattenError {
    /// A component is not a disc, and only discs can be laid out.
    #[error("the component of {vertex} is {}: only a disc can be laid out, so cut it open first", name.as_deref().unwrap_or("not a surface"))]
    NotADisc {
        /// Its lowest vertex.
        vertex: VertexId,
        /// What the surface is called, if it is one.
        name: Option<String>,
    },
    /// A face comes back to a vertex.
    #[error("{face} comes back to a vertex, so it can't be laid out; clean the mesh first")]
    NonSimpleFace {
        /// The face.
        face: FaceId,
    },
    /// A boundary is too short for a square, or does not have the corners that were asked for.
    #[error("the boundary at {vertex} has not the four vertices that a square needs")]
    NoSquare {
        /// Its lowest vertex.
        vertex: VertexId,
    },
    /// A face has an angle without a cotangent.
    #[error("{face} has no area in space, or a point that is not finite, so there are no cotangents")]
    NoCotangent {
        /// The face.
        face: FaceId,
    },
    /// The equations have no solution in doubles.
    #[error("the equations of the layout have no solution in doubles")]
    NoRest,
    /// There is not enough memory.
    #[error("there is not enough memory for the equations")]
    OutOfMemory,
}
