//! What readers of all formats share.

pub(crate) mod assemble;
