//! What a mesh is called and where it lies is no part of its topology.

use meshmend_testkit::damage::reversed;
use meshmend_testkit::{Soup, worlds};
use proptest::prelude::*;

use crate::figures::{figures, report};

/// A mesh of any kind.
pub(crate) fn any_mesh() -> impl Strategy<Value = Soup> {
    prop_oneof![
        worlds::any_table(14),
        worlds::generic_table(14),
        worlds::damaged_grid(),
        worlds::damaged_shape().prop_map(|(_, _, soup)| soup),
    ]
}

/// A mesh, and other names for its vertices.
pub(crate) fn with_names(meshes: impl Strategy<Value = Soup>) -> impl Strategy<Value = (Soup, Vec<u32>)> {
    meshes.prop_flat_map(|soup| {
        let names = worlds::names(soup.vertex_count());
        (Just(soup), names)
    })
}

/// A mesh, and another order of its faces.
fn with_order(meshes: impl Strategy<Value = Soup>) -> impl Strategy<Value = (Soup, Soup)> {
    meshes.prop_flat_map(|soup| {
        let faces = Just(soup.faces.clone()).prop_shuffle();
        (Just(soup), faces).prop_map(|(soup, faces)| (soup.clone(), Soup { faces, ..soup }))
    })
}

/// The mesh as seen from the other side: every face reversed.
pub(crate) fn inside_out(soup: &Soup) -> Soup {
    Soup { positions: soup.positions.clone(), faces: soup.faces.iter().map(|face| reversed(face)).collect() }
}

/// The mesh in other units.
pub(crate) fn scaled(soup: &Soup, exponent: i32) -> Soup {
    let factor = f64::from(exponent).exp2();
    Soup {
        positions: soup.positions.iter().map(|p| p.map(|x| x * factor)).collect(),
        faces: soup.faces.clone(),
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn renaming_vertices((soup, names) in with_names(any_mesh())) {
        prop_assert_eq!(figures(&soup.renamed(&names)), figures(&soup));
    }

    #[test]
    fn listing_faces_in_another_order((soup, shuffled) in with_order(any_mesh())) {
        prop_assert_eq!(figures(&shuffled), figures(&soup));
    }

    #[test]
    fn beginning_faces_at_other_corners(soup in any_mesh(), by in 1..5usize) {
        prop_assert_eq!(figures(&soup.rotated(by)), figures(&soup));
    }

    #[test]
    fn looking_from_the_other_side(soup in any_mesh()) {
        prop_assert_eq!(figures(&inside_out(&soup)), figures(&soup));
    }

    /// Not only the figures: every defect is the same, with its place.
    #[test]
    fn measuring_in_other_units(soup in any_mesh(), exponent in -60..60i32) {
        let (one, other) = (report(&soup), report(&scaled(&soup, exponent)));
        prop_assert!(one.defects.iter().eq(other.defects.iter()));
        prop_assert_eq!(serde_json::to_value(one).unwrap(), serde_json::to_value(other).unwrap());
    }
}
