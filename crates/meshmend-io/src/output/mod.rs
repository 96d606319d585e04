//! What writers of all formats share.

pub(crate) mod atomic;
pub(crate) mod held;
pub(crate) mod layers;
pub(crate) mod prepare;
pub(crate) mod rounding;
pub(crate) mod seams;
pub(crate) mod sink;
pub(crate) mod texture_numbers;
