//! The package: a zip archive whose entries are read within limits, and written so that those that stay keep their bytes.

mod directory;
mod fault;
mod inflate;
#[cfg(test)]
mod tests;
mod write;
mod zip;

pub(super) use self::directory::Directory;
pub(super) use self::fault::Fault;
pub(super) use self::inflate::Budget;
pub(super) use self::write::{archive_of, with_contents};
pub(super) use self::zip::Packer;
