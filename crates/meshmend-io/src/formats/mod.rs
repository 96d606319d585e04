//! The formats, a folder each, and their registry.

pub(crate) mod foreign;
pub(crate) mod format;
pub(crate) mod obj;
pub(crate) mod off;
pub(crate) mod ply;
pub(crate) mod stl;
