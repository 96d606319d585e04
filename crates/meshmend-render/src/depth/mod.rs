//! What is nearest to the eye, and what is hidden behind it.

pub(crate) mod buffer;
pub(crate) mod occlusion;
pub(crate) mod painting;
pub(crate) mod visibility;
