//! What fuzzing checks, apart from the engine that makes up the inputs.
//!
//! A target is a function from bytes that panics where a promise is broken. Reader targets take the bytes as a file;
//! the others make a small mesh, and what to do with it, out of them ([`input`]). The programs in `fuzz_targets`
//! hand these functions to libFuzzer; `cargo test` calls the same functions with every input that ever broke one
//! (`fuzz/regressions`).

#![forbid(unsafe_code)]
#![warn(missing_docs)]

mod arguments;
mod assets;
mod compare;
mod edits;
mod external;
pub mod input;
mod intersections;
mod kernels;
mod matrices;
mod mending;
mod packages;
mod readers;
mod repairs;
mod room;
mod round_trip;
mod splice;
mod zip;

pub use arguments::arguments;
pub use assets::gltf;
pub use edits::edit;
pub use external::external;
pub use intersections::intersections;
pub use kernels::{analysis, kernels};
pub use matrices::matrices;
pub use mending::mending;
pub use packages::threemf;
pub use readers::{formats, obj, off, ply, sniff, stl};
pub use repairs::{passes, plan, repair};
pub use round_trip::round_trip;
pub use splice::splice;

/// A fuzz target.
#[derive(Clone, Copy, Debug)]
pub struct Target {
    /// Its name, which is that of its program and of its folders.
    pub name: &'static str,
    /// Panics where the bytes break a promise.
    pub check: fn(&[u8]),
}

macro_rules! targets {
    ($($name:ident)*) => {
        /// Every target.
        pub const TARGETS: &[Target] = &[$(Target { name: stringify!($name), check: $name },)*];
    };
}

targets!(obj ply stl off gltf formats sniff round_trip kernels analysis matrices repair passes plan arguments edit threemf splice intersections mending external);
