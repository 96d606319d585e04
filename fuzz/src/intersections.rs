//! Intersections: which faces cross or touch is what the definition says, in fractions.

use arbitrary::{Arbitrary, Unstructured};
use meshmend_core::PolygonMesh;
use meshmend_spatial::{Budget, IntersectionOptions, Surface};
use meshmend_testkit::oracle;

use crate::input::SmallMesh;

/// The oracle is slow.
const MOST_FACES: usize = 6;

/// The first triangles of a small mesh: each pair meets as the oracle says, however the search goes.
pub fn intersections(data: &[u8]) {
    let Ok(SmallMesh(mut soup)) = SmallMesh::arbitrary(&mut Unstructured::new(data)) else { return };
    soup.faces.retain(|face| face.len() == 3);
    soup.faces.truncate(MOST_FACES);
    let mesh = soup.mesh();
    let found = found(&mesh, Budget::Usual);
    assert_eq!(found, self::found(&mesh, Budget::Tests(0)), "{soup:?}");
    let triangles: Vec<[[f64; 3]; 3]> =
        soup.faces.iter().map(|face| [0, 1, 2].map(|at: usize| soup.positions[face[at] as usize])).collect();
    let mut expected = Vec::new();
    for (one, f) in triangles.iter().enumerate().filter(|(_, f)| takes_part(f)) {
        for (other, g) in triangles.iter().enumerate().skip(one + 1).filter(|(_, g)| takes_part(g)) {
            let met = oracle::contact(*f, *g);
            expected.extend(met.map(|(name, is_coplanar)| (one as u32, other as u32, name, is_coplanar)));
        }
    }
    assert_eq!(found, expected, "{soup:?}");
}

fn found(mesh: &PolygonMesh, budget: Budget) -> Vec<(u32, u32, &'static str, bool)> {
    let surface = Surface::of(mesh).expect("a small mesh has a surface");
    let options = IntersectionOptions { budget, ..IntersectionOptions::default() };
    let pairs = meshmend_spatial::intersections(&surface, options).expect("nobody stops it").pairs;
    pairs
        .iter()
        .map(|pair| (pair.faces[0].0, pair.faces[1].0, pair.contact.name(), pair.is_coplanar))
        .collect()
}

/// Whether a triangle is finite and has an area.
fn takes_part(triangle: &[[f64; 3]; 3]) -> bool {
    triangle.iter().flatten().all(|x| x.is_finite()) && !oracle::has_no_area(*triangle)
}
