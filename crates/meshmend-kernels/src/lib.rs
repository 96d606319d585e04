//! The ways in which connectivity can be stored, one file each, and the registry from which one is chosen.
//!
//! A *kernel* is a disposable index over a [`Complex`](meshmend_core::Complex). All kernels answer the same
//! questions with the same ids ([`Connectivity`](meshmend_core::Connectivity)), each from its own arrays in its
//! own classical way; so a student can compare them line by line, and they check one another. A *permissive*
//! kernel holds any complex. A *strict* one says in its capabilities what it requires, and refuses the rest with
//! every reason.
//!
//! The kernel is chosen once a task, by name if need be:
//!
//! ```
//! use meshmend_core::{Complex, Connectivity, FaceTable, VertexId};
//! use meshmend_kernels::{KernelKind, KernelTask};
//!
//! struct EulerNumber;
//! impl KernelTask for EulerNumber {
//!     type Output = isize;
//!     fn run<K: Connectivity>(self, kernel: &K) -> isize {
//!         kernel.vertex_count() as isize - kernel.edge_count() as isize + kernel.face_count() as isize
//!     }
//! }
//!
//! let tetrahedron = [0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2].map(VertexId).to_vec();
//! let complex = Complex::of(&FaceTable::triangles(4, tetrahedron)?.into());
//! for &kind in KernelKind::ALL {
//!     assert_eq!(kind.run(&complex, EulerNumber)?, 2);
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! To add a kernel: one file with the type and its [`Connectivity`](meshmend_core::Connectivity); beside it its
//! text, which is the page of the module and what `explain` prints ([`Lesson`](meshmend_core::Lesson)); its
//! `mod` line below; and its entry in the registry. The laws that every kernel obeys then run
//! for it without another edit.

mod adjacency_lists;
mod corner_table;
mod face_vertex;
mod generalised_map;
mod half_edge;
mod quad_edge;
mod registry;
mod rotation_system;
mod simple_record;
mod triangles;
mod winged_edge;

pub use registry::*;
