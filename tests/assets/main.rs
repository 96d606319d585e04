//! Files of several meshes, repaired: what no repair touches stays to the byte, attributes survive, and other programs
//! take what is written.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod damaged;
mod documents;
mod new_files;
mod skinned;
mod unchanged;
