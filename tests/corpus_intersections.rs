//! The faces of the corpus that cross or touch are as many as an exact reference and CGAL count.

use std::collections::{BTreeMap, BTreeSet};

use meshmend_core::{FaceId, PolygonMesh};
use meshmend_io::{Format, ReadOptions, WriteOptions, held_layers, read};
use meshmend_repair::{Clean, Distance, Pipeline, Triangulate, TriangulateFaces, Weld};
use meshmend_spatial::{Contact, FacePair, IntersectionOptions, Surface, intersections};
use meshmend_tests::corpus::{Entry, corpus};
use meshmend_tests::each::assert_each;
use meshmend_tests::shared::shared;
use serde_json::{Map, Value, json};

/// Their larger faces are cut in another way today than when they were counted, so that other triangles cross. Of the
/// triangles of today the exact reference has the same counts as the search.
const CUT_OTHERWISE: [&str; 5] = [
    "real/assimp/space_in_material_name.obj",
    "synthetic/faces/annulus_by_bridge.obj",
    "synthetic/faces/annulus_by_bridge.off",
    "synthetic/faces/same_corners_other_order.obj",
    "synthetic/nonorientable/hemicube.obj",
];

#[test]
fn as_many_faces_cross_and_touch_as_others_count() {
    let (Some(entries), Some(path)) = (corpus(), shared("geometry/corpus_intersections.json")) else {
        return;
    };
    let text = std::fs::read_to_string(path).unwrap();
    let counted: Value = serde_json::from_str(&text).unwrap();
    let counted: BTreeMap<&str, &Value> = counted["files"]
        .as_array()
        .unwrap()
        .iter()
        .map(|facts| (facts["path"].as_str().unwrap(), facts))
        .collect();
    let known: Vec<(&Entry, &Value)> = entries
        .iter()
        .filter(|entry| !CUT_OTHERWISE.contains(&entry.name.as_str()))
        .filter_map(|entry| Some((entry, *counted.get(entry.name.as_str())?)))
        .collect();
    assert!(known.len() > 400, "only {} files", known.len());
    assert_each(&known, |&(entry, facts)| {
        let mesh = read(&entry.path, &ReadOptions::default()).unwrap().mesh;
        let figures = figures(&judged(&mesh));
        figures
            .keys()
            .filter(|name| figures[*name] != facts[name.as_str()])
            .map(|name| format!("{}: {name} {}, not {}", entry.name, figures[name], facts[name.as_str()]))
            .collect()
    });
}

/// The mesh as it was counted: welded, cleaned and cut into triangles, faces with other colours at the same place being the same.
fn judged(mesh: &PolygonMesh) -> PolygonMesh {
    let passes = [
        Weld::within(Distance::Exact).into(),
        Clean::default().into(),
        Triangulate { faces: TriangulateFaces::All }.into(),
    ];
    let held = held_layers(mesh, &WriteOptions::of(Format::Off));
    Pipeline::new(passes).for_layers(held).run(mesh).unwrap().mesh
}

/// The figures of a mesh without the faces that coincide with a lower one.
fn figures(mesh: &PolygonMesh) -> Map<String, Value> {
    let found = intersections(&Surface::of(mesh).unwrap(), IntersectionOptions::default()).unwrap();
    let coincident = |pair: &&FacePair| pair.contact == Contact::Coincident;
    let left_out: BTreeSet<FaceId> =
        found.pairs.iter().filter(coincident).map(|pair| pair.faces[1]).collect();
    let pairs: Vec<&FacePair> =
        found.pairs.iter().filter(|pair| !pair.faces.iter().any(|face| left_out.contains(face))).collect();
    let mut contacts: BTreeMap<&str, u64> = BTreeMap::new();
    pairs.iter().for_each(|pair| *contacts.entry(pair.contact.name()).or_default() += 1);
    let crossing: Vec<&&FacePair> = pairs.iter().filter(|pair| pair.contact == Contact::FaceFace).collect();
    let flat = crossing.iter().filter(|pair| pair.is_coplanar).count();
    let faces: BTreeSet<FaceId> = crossing.iter().flat_map(|pair| pair.faces).collect();
    let named = [
        ("pairs", json!(pairs.len())),
        ("contacts", json!(contacts)),
        ("crossing", json!(crossing.len() - flat)),
        ("overlapping", json!(flat)),
        ("crossing_faces", json!(faces.len())),
    ];
    named.into_iter().map(|(name, value)| (name.to_owned(), value)).collect()
}
