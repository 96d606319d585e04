//! Why there are no generators.

use meshmend_core::{Cancelled, VertexId};
use thiserror::Error;

use crate::ComponentId;

/// Why there are no generators.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum GeneratorError {
    /// No face has the root that was asked for.
    #[error("{0} is in no face, so no path begins there")]
    NoSuchRoot(VertexId),
    /// There are more or fewer lengths than edges.
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
    /// Whoever watches has stopped it.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}
