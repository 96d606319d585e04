//! Meshes with known answers: each generator says its figures in closed form, and gives them as a [`Truth`].
//!
//! What any tool says of these meshes can be held against what is known of them: surfaces of every kind, with and
//! without boundary, and complexes that branch along edges or touch in vertices.
//!
//! ```
//! use meshmend_shapes::{Closed, surface};
//!
//! let shape = surface(Closed::Handles(8), 0, 4)?;
//! assert_eq!(shape.truth.genus, Some(8));
//! assert_eq!(shape.mesh.complex().edges().edge_count(), shape.truth.edges);
//! # Ok::<(), meshmend_shapes::ShapeError>(())
//! ```
//!
//! A generator takes time linear in what it makes. Any shape comes in any resolution by
//! [`refined`](Shape::refined), and in triangles by [`triangulated`](Shape::triangulated). The shapes that a user
//! may ask for by name are the list [`NAMED_SHAPES`].
//!
//! Surfaces that embed in space are embedded, with their faces looking outward where they are closed; the others have
//! some place for each vertex, no two the same. The exceptions say so.

mod branching;
mod error;
mod extreme;
mod grid;
mod mesh_builder;
mod named_shapes;
mod parameter;
mod platonic;
mod refine;
mod schemes;
mod shape;
mod surface;
mod truth;

pub use branching::{
    book, bow_tie, foam, nested_pages, pinched_torus, sphere_with_membrane, three_hemispheres,
    three_triangles_on_an_edge, two_boxes_on_an_edge, two_tetrahedra_on_a_vertex, two_tetrahedra_on_an_edge,
    umbrellas,
};
pub use error::ShapeError;
pub use extreme::{fan, out_and_back, polygon, strip};
pub use grid::{annulus, disc, klein_bottle, moebius_band, torus};
pub use named_shapes::{NAMED_SHAPES, NamedShape, Sizes};
pub use parameter::Parameter;
pub use platonic::{cube, dodecahedron, icosahedron, octahedron, tetrahedron};
pub use schemes::{
    disc_with_rim, dunce_hat, dycks_surface, projective_plane, seven_vertex_torus, wrapped_disc,
};
pub use shape::Shape;
pub use surface::surface;
pub use truth::{Closed, Truth};
