//! The laws of meshmend's kernels, for anybody's kernel.

#![allow(clippy::expect_used, reason = "this crate is for tests, which stop where they fail")]

pub mod editing;
mod grade;
mod guard;
mod laws;
mod macros;
mod run;
mod settings;
mod soup;
mod subject;
mod verdict;
pub mod worlds;

use meshmend_core::Capabilities;

#[doc(hidden)]
pub use cap::Cap;
#[doc(hidden)]
pub use grade::grade;
pub use laws::{Breach, LAWS, Law, heap_law, kernel_laws, law, refusal_law};
#[doc(hidden)]
pub use run::{NotManifold, Opposite, OppositeOf};
pub use settings::{Effort, Settings};
pub use soup::Soup;
pub use subject::Subject;
pub use verdict::{Outcome, Verdict, Verdicts};

/// Any mesh.
pub const PERMISSIVE: Capabilities = Capabilities::PERMISSIVE;
/// Manifold meshes of simple faces, directed as they please.
pub const SURFACES: Capabilities = Capabilities::SURFACES;
/// Manifold meshes of simple faces, each of which agrees with its neighbours.
pub const ORIENTED_SURFACES: Capabilities = Capabilities::ORIENTED_SURFACES;
/// Manifold triangle meshes, each of whose faces agrees with its neighbours.
pub const TRIANGLES: Capabilities = Capabilities::TRIANGLES;
