//! A disc laid out in the plane: one point of the unit square for each vertex, no face flipped.
//!
//! The boundary is put on a convex polygon by its length, and every other vertex in the weighted mean of its
//! neighbours. With positive weights that is one-to-one, by Tutte's theorem, and
//! what rounding does to it is not left to trust: the orientation of each triangle is found exactly, and a layout
//! names the faces that are [flipped](Layout::flipped) or [collapsed](Layout::collapsed).
//!
//! ```
//! use meshmend_core::{FaceTable, PolygonMesh, VertexId};
//! use meshmend_flatten::{Flatten, flatten};
//!
//! let fan = [0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1].map(VertexId).to_vec();
//! let places = vec![[0.0, 0.0, 3.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]];
//! let mesh = PolygonMesh::new(places, FaceTable::triangles(5, fan)?)?;
//! let layout = flatten(&mesh, &Flatten::default())?;
//! assert_eq!(layout.points[0], [0.5, 0.5]);
//! assert!(layout.is_one_to_one());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A face of more than three corners gets a vertex of its own inside it, joined to all its corners, so that there are
//! triangles; that vertex is not part of the answer.
//!
//! *Sources*: W. T. Tutte, *How to draw a graph*, 1963. M. S. Floater, *One-to-one piecewise linear mappings over
//! triangulations*, 2003. S. Yoshizawa, A. Belyaev, H.-P. Seidel, *A fast and simple stretch-minimizing mesh
//! parameterization*, 2004.

mod boundary_placement;
mod cotangents;
mod discs;
mod error;
mod flat;
mod laplacian;
mod layout;
mod orientation;
mod reweighting;
mod svg;
mod untangle;

pub use error::FlattenError;
pub use layout::{Boundary, Flatten, Layout, Weights, flatten};
pub use svg::svg;
