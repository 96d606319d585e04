//! One scene in its rectangle.

pub(crate) mod edge_chains;
pub(crate) mod frame;
pub(crate) mod layers;
pub(crate) mod panel;
