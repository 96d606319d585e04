//! Why a mesh was not cut.

use meshmend_core::{Defect, DraftError, EdgeId, FaceTableError};
use meshmend_topology::{ComponentId, GeneratorError};
use thiserror::Error;

/// Why a mesh was not cut.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum CutError {
    /// The mesh has no such edge.
    #[error("{0} is not an edge of the mesh")]
    NoSuchEdge(EdgeId),
    /// What was to be cut is not a surface.
    #[error("only a surface can be cut: {0}")]
    NotManifold(Defect),
    /// Only closed surfaces can be cut along generators.
    #[error("only a closed surface is cut along its generators: {0} has a boundary")]
    HasBoundary(ComponentId),
    /// The generators can't be found.
    #[error(transparent)]
    Generators(#[from] GeneratorError),
    /// A component did not become a disc: a mistake of this program.
    #[error("{0} was cut but is not a disc, which is a mistake of this program")]
    NoDisc(ComponentId),
    /// The result would have more elements than a mesh holds.
    #[error(transparent)]
    Table(#[from] FaceTableError),
    /// The cut described a mesh that can't be: a mistake of this program.
    #[error(transparent)]
    Draft(#[from] DraftError),
}
