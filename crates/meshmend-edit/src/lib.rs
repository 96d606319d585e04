//! An editable half-edge mesh.
//!
//! A mesh of meshmend is a value that is never changed, and kernels are indices over it. An [`Editor`] is the other way: it
//! takes a manifold mesh apart into records, thirteen operators change them, and [`Editor::finish`] gives a mesh again, with
//! all attributes carried along and the record of where each element came from.
//!
//! ```
//! use meshmend_core::{FaceTable, PolygonMesh, VertexId};
//! use meshmend_edit::Editor;
//!
//! // Two triangles that make a square, with the diagonal from v0 to v2.
//! let faces = FaceTable::triangles(4, [0, 1, 2, 0, 2, 3].map(VertexId).to_vec())?;
//! let points = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
//! let mut editor = Editor::new(&PolygonMesh::new(points, faces)?)?;
//!
//! let [v0, v2] = [0, 2].map(|v| editor.vertex_of(VertexId(v)));
//! let diagonal = editor.half_between(v0.ok_or("v0")?, v2.ok_or("v2")?)?.ok_or("they are joined")?;
//! let edge = editor.edge(diagonal)?;
//! editor.flip(edge)?;
//!
//! // The boundary is no place for a flip, and nothing happens.
//! let side = editor.edge(editor.next(diagonal)?)?;
//! let refused = editor.flip(side).unwrap_err();
//! assert_eq!(refused.reasons[0].code(), "boundary");
//!
//! let (mesh, provenance) = editor.finish()?;
//! assert_eq!(mesh.triangles(), Some(vec![[1, 2, 3], [0, 1, 3]]));
//! assert_eq!(provenance.faces.of(meshmend_core::FaceId(1)), Some(meshmend_core::FaceId(1)));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # The operators
//!
//! Each `x` has a question `can_x`, which lists everything that stands against it; a refused call changes nothing. [`Done`]
//! holds what was made and the call that undoes it. What an operator does to the numbers of vertices, edges and faces:
//!
//! | operator | undone by | vertices, edges, faces | holes, components, handles |
//! |---|---|---|---|
//! | [`split_edge`](Editor::split_edge) | `join_edges` | +1 +1 0 | |
//! | [`split_face`](Editor::split_face) | `join_faces` | 0 +1 +1 | |
//! | [`poke`](Editor::poke) | `remove_vertex` | +1 +n n − 1 | |
//! | [`flip`](Editor::flip) | `flip` | 0 0 0 | |
//! | [`split_vertex`](Editor::split_vertex) | `collapse` | +1 1 + t +t, for t edges opened | |
//! | [`close_hole`](Editor::close_hole) | `open_face` | 0 0 +1 | a hole less |
//! | [`cut_loop`](Editor::cut_loop) | `zip_holes` | +n +n 0 | two holes more, and a handle less or a component more |
//!
//! With [`Edit`] the same calls are values, for those who record, draw or undo them.

mod edit;
mod editor;
mod finish;
mod keys;
mod operators;
mod place;
mod records;
mod refusal;
mod surgery;

pub use edit::{Done, Edit, Opening};
pub use editor::Editor;
pub use keys::{EdgeKey, FaceKey, HalfKey, Key, StaleKey, VertexKey};
pub use refusal::{EditRefusal, Refused};
