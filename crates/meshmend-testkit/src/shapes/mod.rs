//! Meshes with known answers: each generator says its figures in closed form, and gives them as a [`Truth`].

mod branching;
mod chain;
mod extreme;
mod grid;
mod platonic;
mod schemes;
mod surface;
mod truth;

pub use branching::{
    book, bow_tie, foam, nested_pages, pinched_torus, sphere_with_membrane, three_hemispheres,
    three_triangles_on_an_edge, two_boxes_on_an_edge, two_tetrahedra_on_a_vertex, two_tetrahedra_on_an_edge,
    umbrellas,
};
pub use chain::{DuplicateChain, duplicate_chain};
pub use extreme::{fan, out_and_back, polygon, strip};
pub use grid::{Tiles, annulus, disc, klein_bottle, moebius_band, torus};
pub use platonic::{cube, dodecahedron, icosahedron, octahedron, platonic_solids, tetrahedron};
pub use schemes::{
    disc_with_rim, dunce_hat, dycks_surface, projective_plane, seven_vertex_torus, wrapped_disc,
};
pub use surface::surface;
pub use truth::{Closed, Shape, Truth};

/// Every shape, in small sizes.
pub fn catalogue() -> Vec<Shape> {
    let mut shapes = Vec::from(platonic_solids());
    for tiles in [Tiles::Quads, Tiles::Triangles] {
        shapes.extend([torus(3, 3, tiles), torus(5, 4, tiles), klein_bottle(3, 3, tiles)]);
        shapes.extend([klein_bottle(4, 5, tiles), moebius_band(3, 1, tiles), moebius_band(4, 2, tiles)]);
        shapes.extend([annulus(3, 1, tiles), annulus(5, 3, tiles), disc(1, 1, tiles), disc(3, 4, tiles)]);
    }
    shapes.extend([projective_plane(), seven_vertex_torus(), dycks_surface(), dunce_hat(), bow_tie()]);
    shapes.extend((1..=5).map(wrapped_disc));
    for holes in 0..=3 {
        shapes.extend((0..=3).map(|genus| surface(Closed::Handles(genus), holes, 0)));
        shapes.extend((1..=4).map(|caps| surface(Closed::CrossCaps(caps), holes, 0)));
    }
    shapes.extend([surface(Closed::Handles(2), 1, 1), surface(Closed::CrossCaps(3), 2, 1)]);
    shapes.extend([three_triangles_on_an_edge(), two_tetrahedra_on_a_vertex(), two_tetrahedra_on_an_edge()]);
    shapes.extend([two_boxes_on_an_edge(), sphere_with_membrane(5), three_hemispheres(4)]);
    shapes.extend([pinched_torus(2, 3), pinched_torus(4, 5), foam(1, 1, 1), foam(2, 1, 1), foam(2, 3, 2)]);
    for n in 1..=4 {
        shapes.extend([book(n), nested_pages(n), umbrellas(n), fan(n), strip(n)]);
        shapes.extend([polygon(n + 2), out_and_back(n + 2)]);
    }
    shapes
}
