//! Why there is no such shape.

use meshmend_core::{FaceTableError, MeshError};
use thiserror::Error;

use crate::parameter::Parameter;

/// Why there is no such shape.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ShapeError {
    /// A size is below the least for which the shape is what its name says.
    #[error("{size} has to be at least {least}, but is {given}")]
    TooSmall {
        /// Which size.
        size: &'static str,
        /// What was asked for.
        given: usize,
        /// The least that there is.
        least: usize,
    },
    /// The mesh would have more corners than a table holds.
    #[error("there are no meshes so large: {0}")]
    TooLarge(#[from] FaceTableError),
    /// The memory that the mesh would take can't be had.
    #[error("there is no memory for a mesh so large: {corners} corners take some {} MB", bytes / 1_000_000)]
    NoMemory {
        /// How many corners its faces would have.
        corners: usize,
        /// What it would take while it is made.
        bytes: usize,
    },
    /// The shape has no such size.
    #[error("`{shape}` has no {parameter}")]
    NoSuchParameter {
        /// The shape's name.
        shape: &'static str,
        /// What was given.
        parameter: Parameter,
    },
    /// Handles and cross-caps were asked for at once.
    #[error("a surface has a genus or cross-caps, not both")]
    TwoKinds,
    /// The parts don't fit together.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}
