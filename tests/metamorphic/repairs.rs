//! What a repair makes of a mesh does not depend on names, places in lists or units.

use std::collections::{BTreeMap, BTreeSet};

use meshmend_repair::{Emptying, PassKind, Pipeline, Plan};
use meshmend_testkit::{Soup, worlds};
use proptest::prelude::*;
use serde_json::Value;

use crate::figures::figures;
use crate::names::{any_mesh, scaled, with_names};

fn repaired_by(pipeline: &Pipeline, soup: &Soup) -> Soup {
    Soup::of_mesh(&pipeline.clone().on_emptying(Emptying::Allow).run(&soup.mesh()).unwrap().mesh)
}

fn repaired(soup: &Soup) -> Soup {
    repaired_by(&Pipeline::default(), soup)
}

/// The figures of the repaired mesh.
fn mended(soup: &Soup) -> Value {
    figures(&repaired(soup))
}

/// Triangles in general position, no two over the same three vertices and no more than three at an edge: about an edge no
/// two of them have the same angle, and it does not matter where a round about it begins.
fn triangles() -> impl Strategy<Value = Soup> {
    worlds::triangle_soup(16).prop_map(|soup| {
        let mut triples = BTreeSet::new();
        let mut degrees: BTreeMap<[u32; 2], usize> = BTreeMap::new();
        let is_taken = |face: &Vec<u32>| {
            let [a, b, c] = [face[0], face[1], face[2]];
            let sides = [[a, b], [b, c], [c, a]].map(|[a, b]| [a.min(b), a.max(b)]);
            let is_crowded = sides.iter().any(|side| degrees.get(side) == Some(&3));
            let is_taken = !is_crowded && triples.insert(BTreeSet::from([a, b, c]));
            if is_taken {
                sides.into_iter().for_each(|side| *degrees.entry(side).or_default() += 1);
            }
            is_taken
        };
        Soup::generic(soup.vertex_count(), soup.faces.into_iter().filter(is_taken))
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn renaming_vertices((soup, names) in with_names(triangles())) {
        prop_assert_eq!(mended(&soup.renamed(&names)), mended(&soup));
    }

    #[test]
    fn beginning_faces_at_other_corners(soup in triangles(), by in 1..5usize) {
        prop_assert_eq!(mended(&soup.rotated(by)), mended(&soup));
    }

    /// Not only the figures: the faces are the same, and the positions but for the units.
    #[test]
    fn measuring_in_other_units(soup in any_mesh(), exponent in -60..60i32) {
        let (one, other) = (scaled(&repaired(&soup), exponent), repaired(&scaled(&soup, exponent)));
        prop_assert_eq!(one.faces, other.faces);
        let bits = |p: &[f64; 3]| p.map(f64::to_bits);
        prop_assert!(one.positions.iter().map(bits).eq(other.positions.iter().map(bits)));
    }

    /// Meshes that don't touch are repaired as if each were alone; but whether faces are cut into triangles is asked of a
    /// file as a whole, and so is whether there is a face, or all of it stays as it is.
    #[test]
    fn meshes_beside_one_another(one in worlds::any_table(10), other in worlds::any_table(10)) {
        prop_assume!(!one.faces.is_empty() && !other.faces.is_empty());
        let both = Soup::beside(&[one.clone(), other.clone()], 64.0);
        let uncut = Plan::default().without(PassKind::Triangulate).pipeline();
        let [one, other, both] = [one, other, both].map(|soup| repaired_by(&uncut, &soup));
        prop_assert_eq!(figures(&both), figures(&Soup::beside(&[one, other], 64.0)));
    }
}
