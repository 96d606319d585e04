//! Shapes of the textbook, in small sizes.

use meshmend_shapes::{
    Closed, Shape, ShapeError, annulus, book, bow_tie, cube, disc, dodecahedron, dunce_hat, dycks_surface,
    fan, foam, icosahedron, klein_bottle, moebius_band, nested_pages, octahedron, out_and_back,
    pinched_torus, polygon, projective_plane, seven_vertex_torus, sphere_with_membrane, strip, surface,
    tetrahedron, three_hemispheres, three_triangles_on_an_edge, torus, two_boxes_on_an_edge,
    two_tetrahedra_on_a_vertex, two_tetrahedra_on_an_edge, umbrellas, wrapped_disc,
};

/// Surfaces of up to fifty faces, from which random meshes are made.
pub(super) fn surfaces() -> Vec<Shape> {
    let quads = [torus(3, 3), torus(5, 4), klein_bottle(3, 3), klein_bottle(4, 5), moebius_band(4, 2)];
    let with_boundary = [annulus(3, 1), annulus(5, 3), disc(1, 1), disc(3, 4), moebius_band(3, 1)];
    let triangulated = |shape: &Result<Shape, ShapeError>| shape.as_ref().ok()?.triangulated().ok();
    let grids: Vec<_> = quads.into_iter().chain(with_boundary).collect();
    let solids = [tetrahedron(), cube(), octahedron(), dodecahedron(), icosahedron()];
    let words =
        [projective_plane(), seven_vertex_torus(), dycks_surface(), surface(Closed::Handles(2), 1, 1)];
    let rows = [fan(1), fan(4), strip(5), polygon(5), surface(Closed::CrossCaps(2), 2, 1)];
    let triangles: Vec<Shape> = grids.iter().filter_map(triangulated).collect();
    solids.into_iter().chain(words).chain(rows).chain(grids).flatten().chain(triangles).collect()
}

/// Surfaces, and complexes that branch or touch.
pub(super) fn shapes() -> Vec<Shape> {
    let branching = [book(3), book(4), nested_pages(2), umbrellas(3), bow_tie(), dunce_hat(), foam(2, 1, 1)];
    let touching = [two_tetrahedra_on_a_vertex(), two_tetrahedra_on_an_edge(), two_boxes_on_an_edge()];
    let more =
        [three_triangles_on_an_edge(), sphere_with_membrane(5), three_hemispheres(4), pinched_torus(4, 5)];
    let faces = [out_and_back(5), wrapped_disc(2), wrapped_disc(3), polygon(6)];
    let others = branching.into_iter().chain(touching).chain(more).chain(faces).flatten();
    surfaces().into_iter().chain(others).collect()
}
