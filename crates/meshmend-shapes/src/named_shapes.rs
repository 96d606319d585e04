//! The shapes that a user may ask for by name.

use crate::parameter::Parameter;
use crate::{
    Closed, Shape, ShapeError, annulus, book, bow_tie, cube, disc, dodecahedron, dunce_hat, dycks_surface,
    fan, foam, icosahedron, klein_bottle, moebius_band, nested_pages, octahedron, pinched_torus, polygon,
    projective_plane, seven_vertex_torus, sphere_with_membrane, strip, surface, tetrahedron,
    three_hemispheres, three_triangles_on_an_edge, torus, two_boxes_on_an_edge, two_tetrahedra_on_a_vertex,
    two_tetrahedra_on_an_edge, umbrellas, wrapped_disc,
};

/// A shape by name, with the sizes that it may be given.
#[derive(Clone, Copy, Debug)]
pub struct NamedShape {
    /// What it is called, in lower case with hyphens.
    pub name: &'static str,
    /// What it is, in a line, with its figures where no size changes them.
    pub summary: &'static str,
    recipe: Recipe,
}

/// The sizes that are asked for; one that is absent is the shape's own.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Sizes {
    /// How finely it is divided.
    pub resolution: Option<usize>,
    /// How many pages, tubes, triangles or turns it has.
    pub count: Option<usize>,
    /// How many handles.
    pub genus: Option<usize>,
    /// How many cross-caps, in place of handles.
    pub cross_caps: Option<usize>,
    /// How many holes.
    pub holes: Option<usize>,
}

/// How a shape is made, and of which size when none is given.
#[derive(Clone, Copy, Debug)]
enum Recipe {
    Fixed(fn() -> Result<Shape, ShapeError>),
    OfResolution(usize, fn(usize) -> Result<Shape, ShapeError>),
    OfCount(usize, fn(usize) -> Result<Shape, ShapeError>),
    Surface,
}

use Recipe::{Fixed, OfCount, OfResolution};

const SURFACE_GENUS: usize = 1;
const SURFACE_RESOLUTION: usize = 2;

/// Every shape that has a name.
pub static NAMED_SHAPES: &[NamedShape] = &[
    named("tetrahedron", "V 4, E 6, F 4", Fixed(tetrahedron)),
    named("cube", "V 8, E 12, F 6", Fixed(cube)),
    named("octahedron", "V 6, E 12, F 8", Fixed(octahedron)),
    named("dodecahedron", "V 20, E 30, F 12", Fixed(dodecahedron)),
    named("icosahedron", "V 12, E 30, F 20", Fixed(icosahedron)),
    named("hexagon", "one face: V 6, E 6, F 1", Fixed(|| polygon(6))),
    named("annulus", "a flat ring of 6N × N quads", OfResolution(1, |n| annulus(n.saturating_mul(6), n))),
    named("torus", "a ring of N × N quads", OfResolution(3, |n| torus(n, n))),
    named("disc", "a flat square of N × N quads", OfResolution(4, |n| disc(n, n))),
    named("surface", "any connected surface, on a slab of cubes of N × N quads a side", Recipe::Surface),
    named(
        "moebius-band",
        "one cross-cap, one hole: 6N × N quads",
        OfResolution(1, |n| moebius_band(n.saturating_mul(6), n)),
    ),
    named("klein-bottle", "two cross-caps: N × N quads", OfResolution(8, |n| klein_bottle(n, n))),
    named("projective-plane", "one cross-cap: V 6, E 15, F 10", Fixed(projective_plane)),
    named("dycks-surface", "three cross-caps: V 10, E 33, F 22", Fixed(dycks_surface)),
    named("seven-vertex-torus", "V 7, E 21, F 14; passes through itself", Fixed(seven_vertex_torus)),
    named("dunce-hat", "contractible, with three faces an edge: V 13, E 30, F 18", Fixed(dunce_hat)),
    named("wrapped-disc", "a disc wrapped N times round a triangle", OfCount(3, wrapped_disc)),
    named("three-triangles-on-an-edge", "V 5, E 7, F 3", Fixed(three_triangles_on_an_edge)),
    named("two-tetrahedra-on-a-vertex", "V 7, E 12, F 8", Fixed(two_tetrahedra_on_a_vertex)),
    named("two-tetrahedra-on-an-edge", "V 6, E 11, F 8", Fixed(two_tetrahedra_on_an_edge)),
    named("two-boxes-on-an-edge", "V 14, E 23, F 12", Fixed(two_boxes_on_an_edge)),
    named("book", "N triangles on one edge", OfCount(5, book)),
    named("nested-pages", "N tubes on one edge, one inside the other", OfCount(3, nested_pages)),
    named("bow-tie", "two triangles on a vertex: V 5, E 6, F 2", Fixed(bow_tie)),
    named("umbrellas", "N tetrahedra on one vertex", OfCount(3, umbrellas)),
    named("pinched-torus", "N rings of N vertices, and one point", OfResolution(6, |n| pinched_torus(n, n))),
    named(
        "sphere-with-membrane",
        "a bipyramid whose equator of N edges is a face",
        OfResolution(6, sphere_with_membrane),
    ),
    named("three-hemispheres", "three cones on a circle of N edges", OfResolution(6, three_hemispheres)),
    named("foam", "N × N × N cells with all walls", OfResolution(3, |n| foam(n, n, n))),
    named("fan", "N triangles round one vertex, open", OfCount(8, fan)),
    named("strip", "N triangles in one row", OfCount(8, strip)),
];

const fn named(name: &'static str, summary: &'static str, recipe: Recipe) -> NamedShape {
    NamedShape { name, summary, recipe }
}

impl NamedShape {
    /// The shape of a name.
    pub fn from_name(name: &str) -> Option<&'static NamedShape> {
        NAMED_SHAPES.iter().find(|shape| shape.name == name)
    }

    /// The sizes that it may be given, each with what it is otherwise.
    pub fn parameters(&self) -> Vec<(Parameter, usize)> {
        match self.recipe {
            Fixed(_) => Vec::new(),
            OfResolution(usual, _) => vec![(Parameter::Resolution, usual)],
            OfCount(usual, _) => vec![(Parameter::Count, usual)],
            Recipe::Surface => vec![
                (Parameter::Genus, SURFACE_GENUS),
                (Parameter::CrossCaps, 0),
                (Parameter::Holes, 0),
                (Parameter::Resolution, SURFACE_RESOLUTION),
            ],
        }
    }

    /// The shape in the sizes that are asked for.
    ///
    /// # Errors
    /// When it has no such size, or can't be made in it.
    ///
    /// *Cost*: linear in what it makes.
    pub fn make(&self, sizes: &Sizes) -> Result<Shape, ShapeError> {
        let known = self.parameters();
        let foreign = |&(parameter, _): &(Parameter, usize)| known.iter().all(|&(own, _)| own != parameter);
        if let Some((parameter, _)) = sizes.given().find(foreign) {
            return Err(ShapeError::NoSuchParameter { shape: self.name, parameter });
        }
        match self.recipe {
            Fixed(make) => make(),
            OfResolution(usual, make) => make(sizes.resolution.unwrap_or(usual)),
            OfCount(usual, make) => make(sizes.count.unwrap_or(usual)),
            Recipe::Surface => sizes.surface(),
        }
    }
}

impl Sizes {
    fn given(&self) -> impl Iterator<Item = (Parameter, usize)> {
        let all = [
            (Parameter::Resolution, self.resolution),
            (Parameter::Count, self.count),
            (Parameter::Genus, self.genus),
            (Parameter::CrossCaps, self.cross_caps),
            (Parameter::Holes, self.holes),
        ];
        all.into_iter().filter_map(|(parameter, value)| Some((parameter, value?)))
    }

    fn surface(&self) -> Result<Shape, ShapeError> {
        let kind = match (self.genus, self.cross_caps) {
            (Some(_), Some(_)) => return Err(ShapeError::TwoKinds),
            (None, Some(caps)) => Closed::CrossCaps(caps),
            (genus, None) => Closed::Handles(genus.unwrap_or(SURFACE_GENUS)),
        };
        surface(kind, self.holes.unwrap_or(0), self.resolution.unwrap_or(SURFACE_RESOLUTION))
    }
}
