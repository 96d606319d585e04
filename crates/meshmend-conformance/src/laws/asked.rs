//! A kernel under the law: what is asked, and where the right answers are.

use meshmend_core::{CornerId, PolygonMesh};

use super::expected::Expected;

/// A kernel over a mesh, with the right answers.
pub(crate) struct Asked<'a, K> {
    /// The kernel.
    pub(crate) kernel: &'a K,
    /// What is right.
    pub(crate) expected: &'a Expected,
    /// The mesh, where it is at hand.
    pub(crate) mesh: Option<&'a PolygonMesh>,
    /// What a manifold kernel says is opposite; `None` for another kernel.
    pub(crate) opposite: Option<&'a dyn Fn(CornerId) -> Option<CornerId>>,
}
