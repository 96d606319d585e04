//! What writers of all formats share.

pub(crate) mod atomic;
pub(crate) mod companions;
pub(crate) mod held;
pub(crate) mod layer_losses;
pub(crate) mod material_losses;
pub(crate) mod options;
pub(crate) mod prepare;
pub(crate) mod prepared;
pub(crate) mod rounding;
pub(crate) mod seams;
pub(crate) mod sink;
pub(crate) mod statements;
pub(crate) mod texture_numbers;
pub(crate) mod texture_origin;
pub(crate) mod triangles;
