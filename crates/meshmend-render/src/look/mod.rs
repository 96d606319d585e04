//! How things look, and what the legend says of them.

pub(crate) mod appearance;
pub(crate) mod legend;
pub(crate) mod shade;
