//! What the tests of meshmend are made of.
//!
//! * [`Soup`]: a mesh as plain lists, from which everything here is made and on which everything here works.
//! * [`Surgery`]: changes to a mesh whose effect on every figure is known.
//! * [`shapes`]: generators of meshes whose every figure is known in closed form, as a [`Truth`](shapes::Truth).
//! * [`damage`]: harm done to a mesh, with what it must change.
//! * [`oracle`]: the definitions of sections 1 to 3 of the semantics, transcribed naively: slow, plain, and sharing
//!   nothing with what it judges.
//! * [`mod@reference`]: the default repair pipeline in exact arithmetic, slow and plain.
//! * [`worlds`]: proptest strategies, and every small mesh there is.
//! * [`laws`]: what must be true of any kernel, and of any change to a mesh.
//! * [`edits`]: the editor by vertex numbers, as the laws of editors ask it.
//! * [`assert_every_variant`]: that each variant of an error is raised by a case.
//! * [`miscounted`]: where a message counts one of something as several.
//!
//! A test may panic, and so may this crate, which only tests use.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

pub mod damage;
pub mod edits;
pub mod laws;
mod miscounts;
pub mod oracle;
pub mod reference;
pub mod shapes;
mod surgery;
mod variants;
pub mod worlds;

pub use meshmend_conformance::Soup;
pub use miscounts::miscounted;
pub use surgery::Surgery;
