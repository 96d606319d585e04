//! The laws of meshmend's kernels, for anybody's kernel: one line in a test file.
//!
//! A *kernel* is a way of storing which corners of a mesh meet where
//! ([`Connectivity`](meshmend_core::Connectivity)). All kernels give the same answers, and that is what the laws say.
//! This line makes a test for each of them:
//!
//! ```
//! # use meshmend_core::EdgeUse as WingedEdge;
//! # fn main() {}
//! meshmend_conformance::kernel!(winged_edge: WingedEdge);
//! ```
//!
//! `cargo test` then names the laws that are broken, each with the smallest mesh that breaks it:
//!
//! ```text
//! winged-edge breaks the law `next-and-prev`: next goes round the face as stored, prev undoes it.
//!
//!   smallest mesh that breaks it, of 64 150 tried (2 faces, 4 vertices):
//!     f0: v0 v2 v1     c0 c1 c2
//!     f1: v0 v1 v3     c3 c4 c5
//!
//!   next_corner(c1) is c4 and should be c2
//!
//!   often: turned the wrong way at the far end of a side
//!   the mesh: target/meshmend-conformance/winged_edge/next-and-prev.obj
//!   other laws: 13 kept, 2 broken; it holds 3794 of the 64 150 meshes
//! ```
//!
//! # A tour
//!
//! * **The laws** are [`LAWS`]: each has a stable id, a sentence, what rests on it, and the usual mistake. What is right is
//!   found from plain lists of the faces; no law trusts another answer of the kernel. `derived`, `arrays`, `pointers` and
//!   `report` are about answers that are made of others: they are asked where the others are kept, and of the many sets
//!   over five vertices on every eighth, the report on every sixty-fourth.
//! * **The meshes** are every set of oriented triangles over up to five vertices, every small table with faces of any length,
//!   degenerate ones among them, shapes of the textbook, and random tables that are the same in every run. They are visited
//!   by faces and vertices, so the first one that breaks a law is the smallest; a random one is made smaller.
//! * **Mistakes do no harm.** The laws are asked in a process of their own, with little memory. A star that does not end is
//!   cut; a panic, an answer that does not come and memory without end are verdicts, with the question and the mesh.
//!   A capability is to blame (`refusal`) when only meshes that need it break a law.
//! * **Costs** are judged by `growth`: where `COSTS` does not say that an answer is linear, eight times the mesh must not
//!   take much more than eight times as long.
//! * **What must be held** is said by `at_least`: `kernel!(winged_edge: WingedEdge, at_least = ORIENTED_SURFACES)`.
//! * **The size** is measured by [`kernel_size!`] in a test file of its own.
//! * **Graders** find a JSON file for each law in `target/meshmend-conformance/<kernel>`, or make a program of
//!   [`grade!`] that prints all of them. [`Subject`] gives the verdicts as values.
//! * **Editors** have laws of their own: [`editing`].
//!
//! | in the environment | says |
//! |---|---|
//! | `MESHMEND_EFFORT` | `quick` (sets over four vertices, 200 random tables), `usual` (over five, 2 000), `thorough` (20 000 random tables) |
//! | `MESHMEND_PATIENCE` | for how many seconds a law may be asked on one mesh: 10 |
//! | `MESHMEND_IN_PROCESS` | `1`: the laws are asked in the process of the test, for debuggers, and unguarded against what never ends |

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
