//! The shapes of [`meshmend_shapes`] as soups, and a chain of duplicates.
//!
//! Sizes that no shape has stop the test.

mod chain;

pub use chain::{DuplicateChain, duplicate_chain};
pub use meshmend_shapes::{Closed, Truth};

use crate::Soup;

/// A soup and what is true of it.
#[derive(Clone, Debug)]
pub struct Shape {
    /// What it is called, in a test's message.
    pub name: String,
    /// The mesh.
    pub soup: Soup,
    /// Its figures.
    pub truth: Truth,
}

/// What the cells of a grid are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tiles {
    /// One quad a cell.
    Quads,
    /// Two triangles a cell.
    Triangles,
}

/// Generators of the same name that give soups.
macro_rules! soups {
    ($($name:ident($($size:ident),*);)*) => {$(
        #[doc = concat!("As [`meshmend_shapes::", stringify!($name), "`].")]
        pub fn $name($($size: usize),*) -> Shape {
            Shape::of(meshmend_shapes::$name($($size),*))
        }
    )*};
}

/// The same for grids, which may be cut into triangles.
macro_rules! grids {
    ($($name:ident;)*) => {$(
        #[doc = concat!("As [`meshmend_shapes::", stringify!($name), "`], of quads or triangles.")]
        pub fn $name(n: usize, m: usize, tiles: Tiles) -> Shape {
            let quads = meshmend_shapes::$name(n, m);
            Shape::of(match tiles {
                Tiles::Quads => quads,
                Tiles::Triangles => quads.and_then(|quads| quads.triangulated()),
            })
        }
    )*};
}

soups! {
    tetrahedron();
    cube();
    octahedron();
    dodecahedron();
    icosahedron();
    projective_plane();
    seven_vertex_torus();
    dycks_surface();
    dunce_hat();
    wrapped_disc(turns);
    three_triangles_on_an_edge();
    two_tetrahedra_on_a_vertex();
    two_tetrahedra_on_an_edge();
    two_boxes_on_an_edge();
    bow_tie();
    book(pages);
    nested_pages(tubes);
    umbrellas(tetrahedra);
    pinched_torus(rings, vertices);
    sphere_with_membrane(edges);
    three_hemispheres(edges);
    foam(a, b, c);
    fan(triangles);
    strip(triangles);
    polygon(corners);
    out_and_back(vertices);
}

grids! {
    torus;
    klein_bottle;
    moebius_band;
    annulus;
    disc;
}

/// As [`meshmend_shapes::disc_with_rim`].
pub fn disc_with_rim(word: &[u32]) -> Soup {
    Soup::of_mesh(&meshmend_shapes::disc_with_rim(word).unwrap())
}

/// As [`meshmend_shapes::surface`], of quads at a resolution that is doubled so many times.
pub fn surface(kind: Closed, holes: usize, refinements: usize) -> Shape {
    Shape::of(meshmend_shapes::surface(kind, holes, 1 << refinements))
}

/// All five.
pub fn platonic_solids() -> [Shape; 5] {
    [tetrahedron(), cube(), octahedron(), dodecahedron(), icosahedron()]
}

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

impl Shape {
    fn of(shape: Result<meshmend_shapes::Shape, meshmend_shapes::ShapeError>) -> Self {
        let meshmend_shapes::Shape { name, mesh, truth } = shape.unwrap();
        Shape { name, soup: Soup::of_mesh(&mesh), truth }
    }
}
