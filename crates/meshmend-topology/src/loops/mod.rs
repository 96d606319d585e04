//! Along which closed paths can a surface not be shrunk, and along which edges does it open into a disc?
//!
//! For each component that is a surface:
//!
//! 1. a tree of shortest paths from a root to every vertex (`forest`);
//! 2. a tree across the other edges to every face, boundary loops counting as faces (`co_tree`);
//! 3. what is left over are 2g edges, or μ: each with its two ways to the root, from where they meet, is a closed
//!    path. Together with all boundary loops but the one with the lowest vertex these are the [`Generators`]: as many
//!    as β₁ over ℤ/2, and independent, since the way that an edge closes across the tree of the faces crosses its own
//!    path once and no other.
//!
//! The [`cut_graph`] are the edges that a tree of the faces alone does not cross, less what ends blindly.
//!
//! Only ids decide, so every kernel gives the same answer. A component that is not a surface gets no generators, and the
//! reason.
//!
//! *Source*: D. Eppstein, *Dynamic generators of topologically embedded graphs*, 2003; J. Erickson, K. Whittlesey,
//! *Greedy optimal homotopy and homology generators*, 2005.

/// What the work is called to whoever watches it.
const STEP: &str = "loops";

mod ancestors;
mod co_tree;
mod collect;
mod cut_graph;
mod error;
mod forest;
mod generator;
mod generators;
mod options;
mod roots;
mod surfaces;
mod transport;
mod trees;
mod weights;

pub use co_tree::CoTree;
pub use cut_graph::{CutGraph, cut_graph};
pub use error::GeneratorError;
pub use generator::{ComponentGenerators, Generator, GeneratorKind, LoopSystem};
pub use generators::{Generators, generators};
pub use options::GeneratorOptions;
pub use roots::Roots;
pub use weights::Measure;
