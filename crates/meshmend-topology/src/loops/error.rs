//! Why there are no generators.

use meshmend_core::VertexId;
use thiserror::Error;

use crate::ComponentId;

/// Why there are no generators.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum GeneratorError {
    /// The root that was asked for is in no face.
    #[error("{0} is in no face, so no path begins there")]
    NoSuchRoot(VertexId),
    /// There is not one length for each edge.
    #[error("there are {found} lengths for {expected} edges")]
    Lengths {
        /// How many lengths there are.
        found: usize,
        /// How many are needed.
        expected: usize,
    },
    /// The number of generators is not β₁: a mistake of this program.
    #[error("{component} has {found} generators in place of {expected}, which is a mistake of this program")]
    Count {
        /// The component.
        component: ComponentId,
        /// How many generators were found.
        found: usize,
        /// Its Betti number β₁ over ℤ/2.
        expected: i64,
    },
}
