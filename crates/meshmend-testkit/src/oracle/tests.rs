//! The oracle against figures that are known in closed form.

use meshmend_core::{Defect, DefectKind, VertexId};
use proptest::prelude::*;

use super::*;
use crate::damage::reversed;
use crate::shapes::{Tiles, bow_tie, catalogue, disc_with_rim, moebius_band, projective_plane, wrapped_disc};
use crate::worlds::{any_shape, any_table, names, oriented_triangle_sets, triangle_sets};

#[test]
fn every_shape_is_what_it_says() {
    for shape in catalogue() {
        let (report, truth) = (report(&shape.soup), &shape.truth);
        let counts = (report.vertices, report.edges, report.faces, report.components);
        assert_eq!(counts, (truth.vertices, truth.edges, truth.faces, truth.components), "{}", shape.name);
        assert_eq!(report.euler_characteristic, truth.euler_characteristic(), "{}", shape.name);
        let kinds = (report.manifold, report.orientable);
        assert_eq!(kinds, (truth.manifold, truth.orientable), "{}", shape.name);
        let surface = (report.boundary_loops, report.genus, report.cross_caps);
        assert_eq!(surface, (truth.boundary_loops, truth.genus, truth.cross_caps), "{}", shape.name);
        let betti = (report.betti.z2, report.betti.q);
        assert_eq!(betti, (truth.betti_z2, truth.betti_q), "{}", shape.name);
        assert_eq!(report.unreferenced_vertices + report.degenerate_faces, 0, "{}", shape.name);
    }
}

#[test]
fn no_two_vertices_of_a_shape_coincide() {
    for shape in catalogue() {
        let places: std::collections::BTreeSet<_> =
            shape.soup.positions.iter().map(|p| p.map(|x| (x + 0.0).to_bits())).collect();
        assert_eq!(places.len(), shape.soup.vertex_count(), "{}", shape.name);
    }
}

#[test]
fn the_tables_of_the_paper() {
    let instigators = |soup: &Soup| {
        let Instigators { v_c, e_n, e_c, f_n, f_c, .. } = report(soup).instigators;
        [v_c, e_n, e_c, f_n, f_c]
    };
    let hexagon = Soup::generic(6, [[0, 1, 2, 3, 4, 5]]);
    assert_eq!(instigators(&hexagon), [6, 5, 1, 1, 0]);
    assert_eq!(report(&hexagon).betti.z2, [1, 0, 0]);
    let tetrahedron = crate::shapes::tetrahedron().soup;
    assert_eq!(instigators(&tetrahedron), [4, 3, 3, 3, 1]);
}

#[test]
fn names_are_those_of_the_classification() {
    let name = |shape: crate::shapes::Shape| report(&shape.soup).component_kinds[0].name.clone();
    assert_eq!(name(moebius_band(3, 1, Tiles::Quads)).as_deref(), Some("Möbius band"));
    assert_eq!(name(projective_plane()).as_deref(), Some("projective plane"));
    assert_eq!(name(bow_tie()), None);
    assert_eq!(surface_name(3, 0, 0), "genus-3 surface");
    assert_eq!(surface_name(0, 4, 2), "sphere with 4 cross-caps with 2 holes");
    assert_eq!(surface_name(1, 0, 1), "torus with 1 hole");
}

#[test]
fn a_vertex_is_pinched_or_singular() {
    let found = findings(&bow_tie().soup);
    assert_eq!(found.vertex_kinds[&0], VertexKind::Pinched { umbrellas: 2, boundary_only: true });
    assert_eq!(found.vertex_kinds[&1], VertexKind::HalfDisc);
    let found = findings(&crate::shapes::two_tetrahedra_on_a_vertex().soup);
    assert_eq!(found.vertex_kinds[&0], VertexKind::Pinched { umbrellas: 2, boundary_only: false });
    let found = findings(&crate::shapes::book(3).soup);
    assert_eq!(found.vertex_kinds[&0], VertexKind::Singular);
    assert_eq!(found.vertex_kinds[&2], VertexKind::HalfDisc);
    assert_eq!(found.non_manifold_edges, [(0, 3)]);
}

#[test]
fn degenerate_and_non_simple_faces_and_duplicates() {
    let soup = Soup::generic(
        7,
        [&[0, 0, 1, 2][..], &[0, 1, 0, 1], &[], &[2, 0, 1], &[1, 0, 2], &[3, 4, 3, 5], &[3, 5, 3, 4]],
    );
    let found = findings(&soup);
    assert_eq!(found.degenerate_faces, [1, 2]);
    assert_eq!(found.non_simple_faces, [5, 6]);
    assert_eq!((found.same_duplicates, found.opposite_duplicates), (vec![3, 6], vec![4]));
    assert_eq!(found.unreferenced_vertices, [6]);
}

#[test]
fn a_strip_of_one_face_and_one_of_two() {
    // The face runs along 0-1 twice the same way: glued to itself with a twist.
    let itself = Soup::generic(4, [[0, 1, 2, 0, 1, 3]]);
    assert_eq!(findings(&itself).witnesses, [Witness { faces: vec![0], edges: vec![0] }]);
    // Two quads glued along two opposite sides, once consistently and once not: a Möbius band of two faces.
    let two = Soup::generic(4, [[0, 1, 2, 3], [2, 3, 1, 0]]);
    let found = findings(&two);
    assert_eq!(found.witnesses.len(), 1);
    assert_eq!(found.witnesses[0].faces, [0, 1]);
    assert_eq!(check_witness(&two, &found.witnesses[0].faces, &found.witnesses[0].edges), Ok(()));
}

#[test]
fn a_witness_is_found_exactly_where_it_should_be_and_a_wrong_one_is_not_believed() {
    for shape in catalogue() {
        let found = findings(&shape.soup);
        assert_eq!(found.witnesses.is_empty(), shape.truth.orientable, "{}", shape.name);
        for Witness { faces, edges } in found.witnesses {
            assert_eq!(check_witness(&shape.soup, &faces, &edges), Ok(()), "{}", shape.name);
            assert!(faces.len() < 3 || check_witness(&shape.soup, &faces[1..], &edges[1..]).is_err());
            let mut turned = edges.clone();
            turned.rotate_left(1);
            assert!(faces.len() < 3 || check_witness(&shape.soup, &faces, &turned).is_err());
        }
    }
    let annulus = crate::shapes::annulus(3, 1, Tiles::Quads).soup;
    let ring: Vec<u32> = vec![0, 1, 2];
    let between = |f: u32, g: u32| {
        let shared: Vec<u32> = annulus.faces[f as usize]
            .iter()
            .filter(|v| annulus.faces[g as usize].contains(v))
            .copied()
            .collect();
        let ends = [shared[0].min(shared[1]), shared[0].max(shared[1])];
        findings(&annulus).edges.iter().position(|e| *e == ends).unwrap() as u32
    };
    let edges = [between(0, 1), between(1, 2), between(2, 0)];
    assert_eq!(check_witness(&annulus, &ring, &edges), Err("[0, 1, 2] comes back as it went".into()));
}

#[test]
fn the_shortest_cycle_of_the_tree_on_a_short_moebius_band() {
    let band = moebius_band(5, 1, Tiles::Quads).soup;
    let found = findings(&band);
    assert_eq!(found.witnesses[0].faces.len(), 5);
    assert_eq!(found.witnesses[0].faces[0], 0);
    assert!(found.witnesses[0].edges[0] < found.witnesses[0].edges[4]);
}

/// Whether some choice of flips leaves no edge of degree two inconsistent: every choice is tried.
fn can_be_flipped_consistent(soup: &Soup) -> bool {
    (0..1u32 << soup.faces.len()).any(|choice| {
        let turned =
            |(f, face): (usize, &Vec<u32>)| if choice >> f & 1 == 1 { reversed(face) } else { face.clone() };
        let faces = soup.faces.iter().enumerate().map(turned).collect::<Vec<_>>();
        findings(&Soup::generic(soup.vertex_count(), faces)).inconsistent_edges.is_empty()
    })
}

#[test]
fn orientability_is_that_of_every_choice_of_flips() {
    for faces in triangle_sets(5).filter(|faces| faces.len() <= 5).step_by(7) {
        let soup = Soup::generic(5, &faces);
        assert_eq!(report(&soup).orientable, can_be_flipped_consistent(&soup), "{faces:?}");
    }
    let short = moebius_band(3, 1, Tiles::Triangles).soup;
    assert!(!can_be_flipped_consistent(&short));
    assert!(can_be_flipped_consistent(&disc_with_rim(&[0, 1, 2])));
}

#[test]
fn torsion_tells_the_fields_apart() {
    assert_eq!(report(&wrapped_disc(4).soup).betti, BettiTriples { z2: [1, 1, 1], q: [1, 0, 0] });
}

#[test]
fn every_small_mesh_obeys_euler_and_poincare() {
    for faces in oriented_triangle_sets(4).chain(oriented_triangle_sets(5).step_by(37)) {
        let soup = Soup::generic(5, &faces);
        assert_euler_poincare(&report(&soup), &format!("{faces:?}"));
    }
}

fn assert_euler_poincare(report: &OracleReport, name: &str) {
    for betti in [report.betti.z2, report.betti.q] {
        let [b0, b1, b2] = betti.map(|b| b as i64);
        assert_eq!(b0 - b1 + b2, report.euler_characteristic, "{name}");
        assert_eq!(b0, report.components as i64, "{name}");
    }
    let Instigators { v_n, v_c, e_n, e_c, f_n, f_c } = report.instigators;
    assert_eq!((v_n + v_c, e_n + e_c, f_n + f_c), (report.vertices, report.edges, report.faces), "{name}");
}

/// The report without the vertices that it names.
fn without_names(mut report: OracleReport) -> OracleReport {
    report.component_kinds.iter_mut().for_each(|kind| kind.first_vertex = 0);
    report.component_kinds.sort_by_key(|kind| format!("{kind:?}"));
    report
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    #[test]
    fn any_table_obeys_euler_and_poincare_and_its_witnesses_hold(soup in any_table(12)) {
        assert_euler_poincare(&report(&soup), "table");
        for Witness { faces, edges } in findings(&soup).witnesses {
            prop_assert_eq!(check_witness(&soup, &faces, &edges), Ok(()));
        }
    }

    #[test]
    fn renaming_and_rotating_leave_every_figure(
        (soup, names) in any_table(10).prop_flat_map(|soup| { let n = soup.vertex_count(); (Just(soup), names(n)) }),
        by in 0..5usize,
    ) {
        prop_assert_eq!(without_names(report(&soup.renamed(&names).rotated(by))), without_names(report(&soup)));
    }

    #[test]
    fn a_renamed_shape_is_what_it_says(
        (shape, names) in any_shape().prop_flat_map(|s| { let n = s.soup.vertex_count(); (Just(s), names(n)) }),
        by in 0..5usize,
    ) {
        let found = report(&shape.soup.renamed(&names).rotated(by));
        prop_assert_eq!(found.betti.z2, shape.truth.betti_z2);
        prop_assert_eq!(found.betti.q, shape.truth.betti_q);
        prop_assert_eq!(found.genus, shape.truth.genus);
        prop_assert_eq!(found.cross_caps, shape.truth.cross_caps);
        prop_assert_eq!(found.boundary_loops, shape.truth.boundary_loops);
        prop_assert_eq!(found.edges, shape.truth.edges);
    }

    #[test]
    fn parts_beside_one_another_add_up(one in any_shape(), other in any_shape()) {
        let sum = report(&Soup::beside(&[one.soup, other.soup], 100.0));
        prop_assert_eq!(sum.components, 2);
        let chi = one.truth.euler_characteristic() + other.truth.euler_characteristic();
        prop_assert_eq!(sum.euler_characteristic, chi);
        let manifold = one.truth.manifold && other.truth.manifold;
        let figures = [one.truth.genus, other.truth.genus].into_iter().flatten();
        let some = (one.truth.genus.is_some() || other.truth.genus.is_some()) && manifold;
        prop_assert_eq!(sum.genus, some.then(|| figures.sum()));
    }
}

#[test]
fn components_that_are_alike_are_one_row() {
    let parts = [bow_tie(), crate::shapes::cube(), bow_tie(), moebius_band(3, 1, Tiles::Quads)];
    let kinds = report(&Soup::beside(&parts.map(|shape| shape.soup), 50.0)).component_kinds;
    let rows: Vec<_> = kinds.iter().map(|k| (k.count, k.name.as_deref(), k.first_vertex)).collect();
    assert_eq!(rows, [(2, None, 0), (1, Some("sphere"), 5), (1, Some("Möbius band"), 18)]);
    let figures: Vec<_> = kinds.iter().map(|k| (k.genus, k.cross_caps, k.closed)).collect();
    assert_eq!(figures, [(None, None, false), (Some(0), None, true), (None, Some(1), false)]);
}

#[test]
fn a_mesh_without_a_face_has_no_loops_and_no_genus() {
    let nothing = report(&Soup::generic(3, [[1, 1]]));
    assert_eq!((nothing.manifold, nothing.closed, nothing.orientable), (true, false, true));
    assert_eq!((nothing.boundary_loops, nothing.genus, nothing.cross_caps), (Some(0), None, None));
    assert_eq!((nothing.unreferenced_vertices, nothing.degenerate_faces), (3, 1));
}

#[test]
fn the_report_has_the_names_of_the_semantics() {
    let json = serde_json::to_value(report(&bow_tie().soup)).unwrap();
    assert_eq!(json["non_manifold_vertices"], serde_json::json!({"pinched": 1, "singular": 0}));
    assert_eq!(json["duplicate_faces"], serde_json::json!({"same": 0, "opposite": 0}));
    assert_eq!(json["betti"], serde_json::json!({"z2": [1, 0, 0], "q": [1, 0, 0]}));
    assert_eq!(json["genus"], serde_json::Value::Null);
    assert_eq!(json["euler_characteristic"], 1);
}

#[test]
fn each_defect_is_named_with_its_place() {
    let faces: [&[u32]; 10] = [
        &[0, 1, 2],
        &[1, 2, 0],
        &[0, 2, 1],
        &[0, 1, 3],
        &[4, 5, 4],
        &[4, 5, 5, 6],
        &[3, 4, 1, 4, 7],
        &[8, 9, 10],
        &[8, 9, 11],
        &[10, 12, 13],
    ];
    let mut soup = Soup::generic(15, faces);
    (soup.positions[9], soup.positions[11]) = ([f64::NAN; 3], soup.positions[0]);
    let mesh = soup.mesh().with_loose(vec![[VertexId(0), VertexId(14)]], vec![VertexId(14)]).unwrap();
    let found = defects(&mesh);
    let texts = |kind: DefectKind| -> Vec<String> {
        found.iter().filter(|defect| defect.kind() == kind).map(Defect::to_string).collect()
    };
    assert_eq!(texts(DefectKind::DegenerateFace), ["f4 has fewer than three different vertices"]);
    assert_eq!(texts(DefectKind::NonSimpleFace), ["f6 comes back to v4"]);
    assert_eq!(texts(DefectKind::RepeatedCorner), ["f5 repeats v5", "f6 repeats v4"]);
    assert_eq!(texts(DefectKind::DuplicateFace), ["f1 is f0 again"]);
    assert_eq!(texts(DefectKind::OppositeFace), ["f2 is f0 the other way round"]);
    assert_eq!(texts(DefectKind::PolygonFace), ["f6 has 5 corners"]);
    assert_eq!(
        texts(DefectKind::NonFiniteFace),
        ["f7 uses v9, which is not finite", "f8 uses v9, which is not finite"]
    );
    assert_eq!(texts(DefectKind::NonManifoldEdge)[0], "e0 v0-v1 has 4 sides");
    assert_eq!(
        texts(DefectKind::InconsistentEdge).last().unwrap(),
        "e12 v8-v9 has both sides running the same way"
    );
    assert_eq!(texts(DefectKind::PinchedVertex).last().unwrap(), "v10 joins 2 umbrellas, all open");
    assert_eq!(texts(DefectKind::SingularVertex).len(), 3);
    assert_eq!(texts(DefectKind::NonFiniteVertex), ["v9 is not finite"]);
    assert_eq!(texts(DefectKind::UnreferencedVertex), ["v14 is in no face"]);
    assert_eq!(texts(DefectKind::CoincidentVertex), ["v11 is where v0 is"]);
    assert_eq!(texts(DefectKind::LooseEdge), ["loose edge 0 joins v0-v14"]);
    assert_eq!(texts(DefectKind::LoosePoint), ["loose point 0 at v14"]);
}

proptest! {
    #[test]
    fn defects_are_as_many_as_the_report_says(soup in any_table(12)) {
        let (found, report) = (defects(&soup.mesh()), report(&soup));
        let count = |kind: DefectKind| found.iter().filter(|defect| defect.kind() == kind).count();
        prop_assert!(found.is_sorted_by_key(Defect::kind));
        prop_assert_eq!(count(DefectKind::DegenerateFace), report.degenerate_faces);
        prop_assert_eq!(count(DefectKind::NonSimpleFace), report.non_simple_faces);
        prop_assert_eq!(count(DefectKind::DuplicateFace), report.duplicate_faces.same);
        prop_assert_eq!(count(DefectKind::OppositeFace), report.duplicate_faces.opposite);
        prop_assert_eq!(count(DefectKind::BoundaryEdge), report.boundary_edges);
        prop_assert_eq!(count(DefectKind::NonManifoldEdge), report.non_manifold_edges);
        prop_assert_eq!(count(DefectKind::InconsistentEdge), report.inconsistent_edges);
        prop_assert_eq!(count(DefectKind::PinchedVertex), report.non_manifold_vertices.pinched);
        prop_assert_eq!(count(DefectKind::SingularVertex), report.non_manifold_vertices.singular);
        prop_assert_eq!(count(DefectKind::NonFiniteVertex), report.non_finite_vertices);
        prop_assert_eq!(count(DefectKind::UnreferencedVertex), report.unreferenced_vertices);
        prop_assert_eq!(count(DefectKind::NonOrientablePatch) == 0, report.orientable);
        let mendable = mendable_clashes(&soup.mesh()).len();
        prop_assert!(mendable <= report.inconsistent_edges);
        prop_assert!(!report.orientable || mendable == report.inconsistent_edges);
    }
}
