//! What readers of all formats share.

pub(crate) mod assemble;
pub(crate) mod folder;
pub(crate) mod indices;
pub(crate) mod notes;
pub(crate) mod options;
pub(crate) mod read_file;
pub(crate) mod source;
pub(crate) mod streamed;
