//! Connectivity as matrices: what can be said without corners.
//!
//! The *incidence matrices* ∂₁ and ∂₂ know which vertices, edges and faces touch, and which way; the *adjacency matrix*
//! knows which vertices are joined. Both are views: each stands on its rung of the ladder and has no method for what it
//! can't say.
//!
//! ```text
//!            e0  e1  e2                 f0
//!       v0   −1  −1   0           e0    +1
//! ∂₁ =  v1   +1   0  −1     ∂₂ =  e1    −1     of the triangle v0 v1 v2, and ∂₁∂₂ = 0
//!       v2    0  +1  +1           e2    +1
//! ```
//!
//! | structure | rung | bytes a triangle |
//! |---|---|--:|
//! | [`IncidenceMatrices`] | [`Incidence`](meshmend_core::Incidence) | 56 |
//! | [`Graph`] | [`Adjacency`](meshmend_core::Adjacency) | 14 |
//!
//! What a view lacks: ∂₁ and ∂₂ have no corners, no order round a face that comes back to a vertex, and no first corner;
//! the graph has no faces, so no boundary, no Euler characteristic and no sides. Two surfaces can have one graph.
//!
//! ```
//! use meshmend_core::{FaceTable, PolygonMesh, VertexId};
//! use meshmend_topology::matrices::{Field, Graph, IncidenceMatrices, triangle_count};
//!
//! let points = vec![[0.0; 3]; 4];
//! let faces = [0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0].map(VertexId).to_vec();
//! let closed = PolygonMesh::new(points.clone(), FaceTable::triangles(4, faces.clone())?)?;
//! let open = PolygonMesh::new(points, FaceTable::triangles(4, faces[..9].to_vec())?)?;
//!
//! // A sphere and a disc have the graph K₄, with its four cycles of three edges.
//! assert_eq!(Graph::of(closed.complex()), Graph::of(open.complex()));
//! assert_eq!(triangle_count(&Graph::of(open.complex())), 4);
//! // The boundary matrices tell them apart.
//! assert_eq!(IncidenceMatrices::of(closed.complex()).betti(Field::Rationals), Ok([1, 0, 1]));
//! assert_eq!(IncidenceMatrices::of(open.complex()).betti(Field::Rationals), Ok([1, 0, 0]));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A question that needs more than a view knows does not compile. The link of a vertex needs faces:
//!
//! ```compile_fail,E0277
//! # use meshmend_core::{FaceTable, PolygonMesh};
//! use meshmend_topology::matrices::{CellSet, Graph, link};
//!
//! # let mesh = PolygonMesh::new(Vec::new(), FaceTable::empty(0))?;
//! let graph = Graph::of(mesh.complex());
//! let link = link(&graph, &CellSet::default()); // `Graph` does not implement `Incidence`
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! And the patches of a surface need corners:
//!
//! ```compile_fail,E0277
//! # use meshmend_core::{FaceTable, PolygonMesh};
//! use meshmend_topology::{matrices::IncidenceMatrices, patches};
//!
//! # let mesh = PolygonMesh::new(Vec::new(), FaceTable::empty(0))?;
//! let matrices = IncidenceMatrices::of(mesh.complex());
//! let patches = patches(&matrices); // `IncidenceMatrices` does not implement `Connectivity`
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! *Source*: A. Bærentzen, *On the Topology of Polygonal Meshes*, 2025, §4; for star, closure and link: K. Crane,
//! *Discrete Differential Geometry: An Applied Introduction*, §2.

mod boundary;
mod cell_sets;
mod contraction;
mod eigen;
mod entries;
mod fields;
mod graph;
mod incidence;
mod krylov;
mod market;
mod ranks;
mod spectrum;
mod walks;

pub use cell_sets::{CellSet, closure, is_complex, link, pure_dimension, star};
pub use entries::LostSide;
pub use fields::{Field, Prime};
pub use graph::{Graph, component_count, distances, triangle_count};
pub use incidence::IncidenceMatrices;
pub use market::MatrixMarket;
pub use ranks::{MOST_RATIONAL_CELLS, RANK_BUDGET, RankError};
pub use spectrum::{Eigenvalue, MOST_EIGENVALUES, Operator, SpectrumError, spectrum};
pub use walks::walks;
