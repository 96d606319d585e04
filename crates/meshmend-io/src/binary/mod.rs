//! What readers of binary values share.

pub(crate) mod block_reader;
