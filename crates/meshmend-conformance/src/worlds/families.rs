//! Families of meshes of any size.

use meshmend_core::PolygonMesh;
use meshmend_shapes::{
    Closed, Shape, ShapeError, book, fan, foam, klein_bottle, polygon, strip, surface, torus,
};

use crate::Soup;

/// A family of meshes.
pub(crate) struct Family {
    /// What it is called, such as `a fan`.
    pub(crate) name: &'static str,
    /// What its size counts, such as `triangles`.
    pub(crate) parts: &'static str,
    /// Whether many corners are at one element.
    pub(crate) is_crowded: bool,
    make: fn(usize) -> Result<Shape, ShapeError>,
}

impl Family {
    /// The large mesh of the family in words.
    pub(crate) fn said(&self) -> String {
        format!("{} of 20 000 {}", self.name, self.parts)
    }

    /// A mesh of about so many faces, or of one face with so many corners.
    pub(crate) fn of_size(&self, size: usize) -> Option<PolygonMesh> {
        Some((self.make)(size).ok()?.mesh)
    }
}

/// The families on which the cost of answers is watched.
pub(crate) const FAMILIES: [Family; 5] = [
    Family { name: "a fan", parts: "triangles", is_crowded: true, make: fan },
    Family { name: "a strip", parts: "triangles", is_crowded: false, make: strip },
    Family { name: "a polygon", parts: "corners", is_crowded: true, make: polygon },
    Family { name: "a book", parts: "triangles", is_crowded: true, make: book },
    Family {
        name: "a torus",
        parts: "triangles",
        is_crowded: false,
        make: |faces| triangles((faces / 2).isqrt(), torus),
    },
];

fn triangles(side: usize, grid: fn(usize, usize) -> Result<Shape, ShapeError>) -> Result<Shape, ShapeError> {
    grid(side, side)?.triangulated()
}

/// Meshes of a few thousand faces each, of triangles and others, tidy and not, on which the size of a kernel is measured.
pub(crate) fn sized_meshes() -> Vec<(&'static str, Soup)> {
    let made = [
        ("triangles", triangles(65, torus)),
        ("quads", torus(70, 60)),
        ("a Klein bottle", triangles(65, klein_bottle)),
        ("an open strip", strip(5_000)),
        ("a fan", fan(5_000)),
        ("one face", polygon(5_000)),
        ("a book", book(5_000)),
        ("foam", foam(12, 12, 12)),
        ("handles", surface(Closed::Handles(20), 5, 4)),
    ];
    let of = |(name, shape): (_, Result<Shape, ShapeError>)| Some((name, Soup::of_mesh(&shape.ok()?.mesh)));
    let mut meshes: Vec<(&'static str, Soup)> = made.into_iter().filter_map(of).collect();
    let tidy: Vec<Soup> = meshes[..2].iter().map(|(_, soup)| soup.clone()).collect();
    if let [triangles, quads] = tidy.as_slice() {
        meshes.push(("quads and degenerate faces", with_degenerate(quads)));
        meshes.push(("triangles and degenerate faces", with_degenerate(triangles)));
        meshes.push(("faces that share nothing", apart(triangles)));
        let vertices = triangles.vertex_count() + 5_000;
        meshes.push(("vertices in no face", Soup::generic(vertices, &triangles.faces)));
    }
    meshes
}

fn with_degenerate(soup: &Soup) -> Soup {
    let mut faces = soup.faces.clone();
    faces.extend((0..900).map(|v| vec![v, v, v + 1]));
    Soup::generic(soup.vertex_count(), faces)
}

/// The faces with vertices of their own each.
fn apart(soup: &Soup) -> Soup {
    let mut fresh = 0..;
    let own = |face: &Vec<u32>| fresh.by_ref().take(face.len()).collect::<Vec<u32>>();
    let faces: Vec<Vec<u32>> = soup.faces.iter().map(own).collect();
    Soup::generic(faces.iter().map(Vec::len).sum(), faces)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn families_have_the_size_that_is_asked_for() {
        for family in &FAMILIES {
            let corners = |size| family.of_size(size).map_or(0, |mesh| mesh.faces().corner_count());
            let times = corners(20_000) as f64 / corners(2_500) as f64;
            assert!((7.5..8.5).contains(&times), "{} {times}", family.name);
        }
        assert_eq!(sized_meshes().len(), 13);
    }
}
