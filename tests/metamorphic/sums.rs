//! Meshes beside one another add up; a handle, a cross-cap and a hole count as one.

use meshmend_testkit::{Soup, Surgery, shapes, worlds};
use meshmend_topology::TopologyReport;
use proptest::prelude::*;
use proptest::sample::{Index, select};

use crate::figures::report;
use crate::names::any_mesh;

/// What is let into a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Feature {
    Handle,
    CrossCap,
    Hole,
}

/// A surface, by what was let into a sphere.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Surface {
    handles: u64,
    cross_caps: u64,
    holes: u64,
}

impl Surface {
    fn with(mut self, feature: Feature) -> Self {
        match feature {
            Feature::Handle => self.handles += 1,
            Feature::CrossCap => self.cross_caps += 1,
            Feature::Hole => self.holes += 1,
        }
        self
    }

    /// A handle beside a cross-cap is worth two cross-caps.
    fn cross_caps_in_all(self) -> u64 {
        if self.cross_caps > 0 { 2 * self.handles + self.cross_caps } else { 0 }
    }

    fn euler_characteristic(self) -> i64 {
        2 - 2 * self.handles as i64 - self.cross_caps as i64 - self.holes as i64
    }

    fn betti(self) -> [[u64; 3]; 2] {
        let loops = 2 * self.handles + self.cross_caps + self.holes.saturating_sub(1);
        let (is_closed, is_twisted) = (u64::from(self.holes == 0), u64::from(self.cross_caps > 0));
        [[1, loops, is_closed], [1, loops - is_closed * is_twisted, is_closed * (1 - is_twisted)]]
    }

    /// The figures of section 3, and what of section 2 is certain.
    fn assert_is(self, report: &TopologyReport) {
        assert!(report.manifold && report.components == 1 && report.patches == 1);
        assert_eq!(report.orientable, self.cross_caps == 0);
        assert_eq!(report.closed, self.holes == 0);
        assert_eq!(report.euler_characteristic, self.euler_characteristic());
        assert_eq!(report.boundary_loops, Some(self.holes));
        assert_eq!(report.genus, (self.cross_caps == 0).then_some(self.handles));
        assert_eq!(report.cross_caps, (self.cross_caps > 0).then_some(self.cross_caps_in_all()));
        assert_eq!([report.betti.z2, report.betti.q], self.betti().map(Some));
    }
}

fn let_in(soup: &Soup, face: usize, feature: Feature) -> Soup {
    match feature {
        Feature::Handle => soup.with_handle(face),
        Feature::CrossCap => soup.with_cross_cap(face),
        Feature::Hole => soup.inset(face).without_face(face),
    }
}

fn features() -> impl Strategy<Value = Vec<(Feature, Index)>> {
    let feature = select(vec![Feature::Handle, Feature::CrossCap, Feature::Hole]);
    proptest::collection::vec((feature, any::<Index>()), 0..7)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    /// Whatever is let into a sphere, in whatever order, the figures are those of the classification.
    #[test]
    fn a_sphere_with_features(features in features(), turned in any::<Vec<Index>>()) {
        let (mut soup, mut surface) = (shapes::cube().soup, Surface::default());
        for (feature, face) in features {
            let face = face.index(soup.faces.len());
            (soup, surface) = (let_in(&soup, face, feature), surface.with(feature));
            surface.assert_is(&report(&soup));
        }
        // Turning faces over is no matter of topology.
        for face in turned {
            let face = face.index(soup.faces.len());
            soup.faces[face].reverse();
        }
        surface.assert_is(&report(&soup));
    }

    /// In the midst of a face of any complex, manifold or not, a handle adds two loops, and a cross-cap one over Z/2.
    #[test]
    fn any_complex_with_a_feature(soup in worlds::generic_table(12), at in any::<Index>()) {
        let is_simple = |face: &Vec<u32>| face.len() > 2 && (0..face.len()).all(|i| !face[..i].contains(&face[i]));
        let simple: Vec<usize> = (0..soup.faces.len()).filter(|&f| is_simple(&soup.faces[f])).collect();
        if simple.is_empty() {
            return Ok(());
        }
        let face = simple[at.index(simple.len())];
        let figures = |soup: &Soup| {
            let report = report(soup);
            let [z2, q] = [report.betti.z2, report.betti.q].map(Option::unwrap);
            (report.euler_characteristic, report.components, z2, q)
        };
        let (euler, components, [z0, z1, z2], [q0, q1, q2]) = figures(&soup);
        let cut = figures(&soup.inset(face));
        prop_assert_eq!(cut, (euler, components, [z0, z1, z2], [q0, q1, q2]), "cutting a face up changes nothing");
        let handle = figures(&soup.with_handle(face));
        prop_assert_eq!(handle, (euler - 2, components, [z0, z1 + 2, z2], [q0, q1 + 2, q2]));
        let (cap_euler, cap_components, cap_z2, _) = figures(&soup.with_cross_cap(face));
        prop_assert_eq!((cap_euler, cap_components, cap_z2), (euler - 1, components, [z0, z1 + 1, z2]));
    }

    #[test]
    fn meshes_beside_one_another(one in any_mesh(), other in any_mesh()) {
        let both = report(&Soup::beside(&[one.clone(), other.clone()], 0.0));
        assert_add_up([&report(&one), &report(&other)], &both);
    }
}

/// Two meshes that share no vertex have the sums of their figures.
fn assert_add_up(parts: [&TopologyReport; 2], both: &TopologyReport) {
    let sum =
        |figure: fn(&TopologyReport) -> u64| assert_eq!(figure(both), parts.map(figure).iter().sum::<u64>());
    let counts: [fn(&TopologyReport) -> u64; 22] = [
        |r| r.vertices,
        |r| r.edges,
        |r| r.faces,
        |r| r.unreferenced_vertices,
        |r| r.non_finite_vertices,
        |r| r.degenerate_faces,
        |r| r.non_simple_faces,
        |r| r.repeated_corner_faces,
        |r| r.duplicate_faces.same,
        |r| r.duplicate_faces.opposite,
        |r| r.boundary_edges,
        |r| r.interior_edges,
        |r| r.non_manifold_edges,
        |r| r.inconsistent_edges,
        |r| r.non_manifold_vertices.pinched,
        |r| r.non_manifold_vertices.singular,
        |r| r.components,
        |r| r.patches,
        |r| r.non_orientable_patches,
        |r| r.instigators.v_c,
        |r| r.instigators.e_n,
        |r| r.instigators.e_c,
    ];
    counts.into_iter().for_each(sum);
    assert_eq!(both.euler_characteristic, parts.map(|r| r.euler_characteristic).iter().sum::<i64>());
    for field in [|r: &TopologyReport| r.betti.z2.unwrap(), |r: &TopologyReport| r.betti.q.unwrap()] {
        let [one, other] = parts.map(field);
        assert_eq!(field(both), [0, 1, 2].map(|i| one[i] + other[i]));
    }
    let all = |holds: fn(&TopologyReport) -> bool| assert_eq!(holds(both), parts.iter().all(|r| holds(r)));
    let questions: [fn(&TopologyReport) -> bool; 3] =
        [|r| r.manifold, |r| r.orientable, |r| r.consistently_oriented];
    questions.into_iter().for_each(all);
    assert_eq!(both.closed, both.faces > 0 && both.boundary_edges == 0);
    // A total is absent where a part is no surface, and where no part has the figure.
    let total = |figure: fn(&TopologyReport) -> Option<u64>| {
        let known: Vec<u64> = parts.iter().filter_map(|r| figure(r)).collect();
        let expected = (both.manifold && !known.is_empty()).then(|| known.iter().sum());
        assert_eq!(figure(both), expected);
    };
    let totals: [fn(&TopologyReport) -> Option<u64>; 3] =
        [|r| r.boundary_loops, |r| r.genus, |r| r.cross_caps];
    totals.into_iter().for_each(total);
    assert_eq!(kinds(both), sorted(parts.map(kinds).concat()));
}

/// What the components are, one text each.
fn kinds(report: &TopologyReport) -> Vec<String> {
    let row = |kind| {
        let mut row = serde_json::to_value(kind).unwrap();
        row["first_vertex"] = serde_json::Value::Null;
        let count = row["count"].take().as_u64().unwrap();
        vec![row.to_string(); count as usize]
    };
    sorted(report.component_kinds.iter().flat_map(row).collect())
}

fn sorted(mut words: Vec<String>) -> Vec<String> {
    words.sort();
    words
}
