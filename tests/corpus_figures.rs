//! Every readable file of the corpus has the figures that its manifest gives, in the views `indexed` (as stored) and
//! `welded` (vertices with equal coordinates made one), through every kernel that holds it.
//!
//! The manifest's figures come from another program and partly from formulas. Its keys, and where the report has
//! them:
//!
//! | manifest | report | difference |
//! | --- | --- | --- |
//! | `V_total`, `F_total` | V and unreferenced, F and degenerate | the report counts the parts |
//! | `V`, `E`, `F`, `chi` | the same | |
//! | `V_unused` | `unreferenced_vertices` | both count vertices that only degenerate faces use |
//! | `degenerate_faces`, `pinched_faces` | `degenerate_faces`, `non_simple_faces` | the name |
//! | `edges_1`, `edges_2`, `edges_3plus` | `boundary_`, `interior_`, `non_manifold_edges` | the name |
//! | `edge_incidence` | the degrees of the listed `NonManifoldEdge`s | the report lists, the manifest counts |
//! | `edges_2_inconsistent` | `inconsistent_edges` | the name |
//! | `duplicate_faces` | `duplicate_faces.same` + `.opposite` | the manifest asks for either orientation |
//! | `duplicate_groups` | first faces that others repeat | a group is the faces that are alike either way |
//! | `duplicate_groups_opposite` | `duplicate_faces.opposite` | a group has one first face the other way round |
//! | `nonmanifold_vertices` | `.pinched` + `.singular` | the report tells the kinds apart |
//! | `nonmanifold_vertices_off_nm_edges` | `.pinched` | the name |
//! | `components`, `patches`, `nonorientable_patches` | the same | |
//! | `nonorientable_components` | counts of kinds that are not orientable | |
//! | `orientable`, `consistently_oriented`, `closed`, `manifold` | the same | |
//! | `edge_manifold`, `watertight`, `watertight_manifold_oriented` | of edges 3+, closed, manifold, oriented | derived |
//! | `betti` | `betti.z2` | |
//! | `boundary_loops` | the same | both absent where a component is no surface |
//! | `genus_total`, `nonorientable_genus_total` | `genus`, `cross_caps` | 0 in the manifest where no component has it |
//! | `components_detail` | `component_kinds` | other order; the manifest lists twelve kinds at most |
//! | `cut` | of the mesh after `split` alone with `cut` | χ for V and E: edges that would coincide are subdivided |
//! | `min_flips_to_orient` | what `orient` alone flips | compared where no face is doubled |
//!
//! No part of the report, and so not compared: `faces_repeating_a_vertex`, `edges_2_same_face`,
//! `edges_directed_twice`, `faces_sharing_a_vertex_set`, `nonmanifold_vertices_multifan`, `edge_components`,
//! `full_complex`.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Mutex;

use meshmend_core::{Connectivity, Defect, DefectKind, FaceId, PolygonMesh};
use meshmend_kernels::{KernelKind, KernelTask};
use meshmend_repair::{Context, Distance, Orient, Pass, Pipeline, Split, SplitEdges, Weld};
use meshmend_tests::corpus::{Entry, corpus};
use meshmend_tests::each::assert_each;
use meshmend_topology::{ComponentKind, TopologyReport, topology};
use serde_json::{Value, json};

/// A key of the manifest, and the same figure of a report; `null` where both may leave it out.
type Figure = (&'static str, fn(&TopologyReport) -> Value);

/// Every key that both sides define.
const FIGURES: [Figure; 32] = [
    ("V_total", |r| json!(r.vertices + r.unreferenced_vertices)),
    ("F_total", |r| json!(r.faces + r.degenerate_faces)),
    ("V", |r| json!(r.vertices)),
    ("E", |r| json!(r.edges)),
    ("F", |r| json!(r.faces)),
    ("chi", |r| json!(r.euler_characteristic)),
    ("V_unused", |r| json!(r.unreferenced_vertices)),
    ("degenerate_faces", |r| json!(r.degenerate_faces)),
    ("pinched_faces", |r| json!(r.non_simple_faces)),
    ("edges_1", |r| json!(r.boundary_edges)),
    ("edges_2", |r| json!(r.interior_edges)),
    ("edges_3plus", |r| json!(r.non_manifold_edges)),
    ("edge_incidence", edge_incidence),
    ("edges_2_inconsistent", |r| json!(r.inconsistent_edges)),
    ("duplicate_faces", |r| json!(r.duplicate_faces.same + r.duplicate_faces.opposite)),
    ("duplicate_groups", duplicate_groups),
    ("duplicate_groups_opposite", |r| json!(r.duplicate_faces.opposite)),
    ("nonmanifold_vertices", |r| json!(r.non_manifold_vertices.pinched + r.non_manifold_vertices.singular)),
    ("nonmanifold_vertices_off_nm_edges", |r| json!(r.non_manifold_vertices.pinched)),
    ("components", |r| json!(r.components)),
    ("patches", |r| json!(r.patches)),
    ("nonorientable_patches", |r| json!(r.non_orientable_patches)),
    ("nonorientable_components", non_orientable_components),
    ("orientable", |r| json!(r.orientable)),
    ("consistently_oriented", |r| json!(r.consistently_oriented)),
    ("closed", |r| json!(r.closed)),
    ("manifold", |r| json!(r.manifold)),
    ("edge_manifold", |r| json!(r.non_manifold_edges == 0)),
    ("watertight", |r| json!(is_watertight(r))),
    ("watertight_manifold_oriented", |r| json!(is_watertight(r) && r.manifold && r.consistently_oriented)),
    ("betti", |r| json!(r.betti.z2)),
    ("boundary_loops", |r| json!(r.boundary_loops)),
];

/// Keys that the manifest has for manifold views alone, with 0 where no component has the figure.
const SURFACE_FIGURES: [Figure; 2] = [
    ("genus_total", |r| json!(r.genus.unwrap_or(0))),
    ("nonorientable_genus_total", |r| json!(r.cross_caps.unwrap_or(0))),
];

fn is_watertight(report: &TopologyReport) -> bool {
    report.closed && report.non_manifold_edges == 0
}

fn edge_incidence(report: &TopologyReport) -> Value {
    let mut counts: BTreeMap<String, u64> = BTreeMap::new();
    for (degree, count) in [(1, report.boundary_edges), (2, report.interior_edges)] {
        if count > 0 {
            counts.insert(degree.to_string(), count);
        }
    }
    for defect in report.defects.of_kind(DefectKind::NonManifoldEdge) {
        *counts.entry(defect.count.to_string()).or_default() += 1;
    }
    json!(counts)
}

/// The groups of faces that are alike either way: each has one first face that repeats no other.
fn duplicate_groups(report: &TopologyReport) -> Value {
    let kinds = [DefectKind::DuplicateFace, DefectKind::OppositeFace];
    let repeats = kinds.iter().flat_map(|&kind| report.defects.of_kind(kind));
    let pairs = repeats.filter_map(|defect| Some((defect.at.face()?, defect.beside?.face()?)));
    let pairs: Vec<(FaceId, FaceId)> = pairs.collect();
    let repeating: BTreeSet<FaceId> = pairs.iter().map(|pair| pair.0).collect();
    let firsts: BTreeSet<FaceId> =
        pairs.iter().map(|pair| pair.1).filter(|first| !repeating.contains(first)).collect();
    json!(firsts.len())
}

fn non_orientable_components(report: &TopologyReport) -> Value {
    let twisted = report.component_kinds.iter().filter(|kind| !kind.orientable);
    json!(twisted.map(|kind| kind.count).sum::<u64>())
}

/// One kind of component in the manifest's words, as text that sorts.
fn kind_in_manifest_words(kind: &ComponentKind) -> String {
    let mut row = json!({
        "V": kind.vertices,
        "E": kind.edges,
        "F": kind.faces,
        "chi": kind.euler_characteristic,
        "closed": kind.closed,
        "manifold": kind.manifold,
        "orientable": kind.orientable,
    });
    let optional = [
        ("boundary_loops", kind.boundary_loops),
        ("genus", kind.genus),
        ("nonorientable_genus", kind.cross_caps),
    ];
    for (key, value) in optional.into_iter().filter(|(_, value)| value.is_some()) {
        row[key] = json!(value);
    }
    row.to_string()
}

/// What differs between the components of a report and those of the manifest.
fn compare_components(report: &TopologyReport, expected: &Value) -> Option<String> {
    let mut ours: BTreeMap<String, u64> = BTreeMap::new();
    for kind in &report.component_kinds {
        *ours.entry(kind_in_manifest_words(kind)).or_default() += kind.count;
    }
    let mut theirs = BTreeMap::new();
    for row in expected["components_detail"].as_array().unwrap() {
        let mut row = row.clone();
        let count = row.as_object_mut().unwrap().remove("count").unwrap().as_u64().unwrap();
        theirs.insert(row.to_string(), count);
    }
    let is_complete = expected["components_detail_complete"] == json!(true);
    let missing = theirs.iter().find(|(row, count)| ours.get(*row) != Some(count));
    if let Some((row, count)) = missing {
        return Some(format!("components_detail: {count} × {row} expected, found {ours:?}"));
    }
    (is_complete && ours.len() != theirs.len())
        .then(|| format!("components_detail: {theirs:?} expected, found {ours:?}"))
}

struct Report<'a>(&'a PolygonMesh);

impl KernelTask for Report<'_> {
    type Output = TopologyReport;
    fn run<K: Connectivity>(self, kernel: &K) -> TopologyReport {
        topology(kernel, self.0)
    }
}

fn report(mesh: &PolygonMesh) -> TopologyReport {
    KernelKind::default().run(mesh.complex(), Report(mesh)).unwrap()
}

fn welded(mesh: &PolygonMesh, distance: Distance) -> PolygonMesh {
    // The pass by itself: a repair would leave a mesh without faces as it is.
    Weld::within(distance).apply(mesh, &Context::default()).unwrap().mesh
}

/// Files of which the manifest counts something else: it joins infinite coordinates, and counts vertices that several
/// primitives share once for each of them.
const COUNTED_OTHERWISE: [&str; 2] = ["real/assimp/BoxWithInfinites.glb", "real/trimesh/mode5.gltf"];

/// Every readable file in a view that the manifest has.
fn views(entries: &[Entry]) -> Vec<(&Entry, &'static str)> {
    let is_counted_alike = |entry: &&Entry| !COUNTED_OTHERWISE.contains(&entry.name.as_str());
    let well_formed = entries.iter().filter(|entry| entry.is_read_here() && entry.is_well_formed());
    let well_formed = well_formed.filter(is_counted_alike);
    let in_views = well_formed.flat_map(|entry| ["indexed", "welded"].map(|view| (entry, view)));
    in_views.filter(|(entry, view)| entry.view(view).is_some()).collect()
}

fn mesh_of(entry: &Entry, view: &str) -> PolygonMesh {
    match view {
        "welded" => welded(&entry.mesh(), Distance::Exact),
        _ => entry.mesh(),
    }
}

#[test]
fn every_figure_is_that_of_the_manifest() {
    let Some(entries) = corpus() else { return };
    let views = views(&entries);
    assert!(views.len() > 800, "only {} views", views.len());
    assert_each(&views, |&(entry, view)| {
        let expected = entry.view(view).unwrap();
        let report = report(&mesh_of(entry, view));
        let surface = SURFACE_FIGURES.iter().filter(|(key, _)| expected.get(*key).is_some());
        let mut wrong: Vec<String> = FIGURES
            .iter()
            .chain(surface)
            .filter(|(key, figure)| figure(&report) != expected[*key])
            .map(|(key, figure)| format!("{key}: {} expected, found {}", expected[*key], figure(&report)))
            .chain(compare_components(&report, expected))
            .collect();
        wrong.iter_mut().for_each(|line| *line = format!("{} {view}: {line}", entry.name));
        wrong
    });
}

#[test]
fn every_kernel_that_holds_a_mesh_gives_the_same_report() {
    let Some(entries) = corpus() else { return };
    let held: Mutex<BTreeMap<KernelKind, u64>> = Mutex::default();
    assert_each(&views(&entries), |&(entry, view)| {
        let mesh = mesh_of(entry, view);
        let first = told_in_full(&report(&mesh));
        let differs = |&kind: &KernelKind| {
            let told = kind.run(mesh.complex(), Report(&mesh)).ok().map(|other| told_in_full(&other))?;
            *held.lock().unwrap().entry(kind).or_default() += 1;
            (told != first).then(|| format!("{} {view}: {kind} says otherwise", entry.name))
        };
        KernelKind::ALL.iter().filter_map(differs).collect()
    });
    let held = held.into_inner().unwrap();
    println!("meshes held: {held:?}");
    assert!(KernelKind::ALL.iter().all(|kind| held.get(kind).is_some_and(|&count| count > 100)), "{held:?}");
}

/// A report with its figures and with every defect.
fn told_in_full(report: &TopologyReport) -> (String, Vec<Defect>) {
    (serde_json::to_string(report).unwrap(), report.defects.iter().collect())
}

#[test]
fn strict_kernels_refuse_what_the_manifest_says_is_no_oriented_manifold() {
    let Some(entries) = corpus() else { return };
    assert_each(&views(&entries), |&(entry, view)| {
        let expected = entry.view(view).unwrap();
        let mesh = mesh_of(entry, view);
        let is = |key: &str| expected[key] == json!(true);
        let simple = expected["pinched_faces"] == json!(0);
        let triangles = mesh.complex().faces().is_all_triangles() || expected["F"] == json!(0);
        let wrong = |&kind: &KernelKind| {
            let admits = kind.capabilities();
            let holds = (admits.non_manifold_edges || is("edge_manifold"))
                && (admits.non_manifold_vertices || is("manifold"))
                && (admits.mixed_orientation || is("consistently_oriented"))
                && (admits.non_simple_faces || simple);
            let is_held = kind.run(mesh.complex(), Report(&mesh)).is_ok();
            (is_held != holds && (admits.polygons || triangles))
                .then(|| format!("{} {view}: {kind} holds it: {is_held}, not {holds}", entry.name))
        };
        KernelKind::ALL.iter().filter_map(wrong).collect()
    });
}

#[test]
fn welding_gives_the_manifests_number_of_vertices() {
    let Some(entries) = corpus() else { return };
    let is_counted_alike = |entry: &&Entry| !COUNTED_OTHERWISE.contains(&entry.name.as_str());
    let well_formed: Vec<&Entry> = entries
        .iter()
        .filter(|entry| entry.is_read_here() && entry.is_well_formed())
        .filter(is_counted_alike)
        .collect();
    assert_each(&well_formed, |entry| {
        let mesh = welded(&entry.mesh(), Distance::Exact);
        let geometry = &entry.facts["geometry"];
        let found = [
            ("V_after_exact_weld", mesh.counts().vertices as u64),
            ("nonfinite_vertices", report(&mesh).non_finite_vertices),
        ];
        let differs = found.into_iter().filter(|(key, value)| geometry[*key] != json!(value));
        differs
            .map(|(key, value)| format!("{}: {key}: {} expected, found {value}", entry.name, geometry[key]))
            .collect()
    });
}

#[test]
fn loose_elements_are_those_that_are_stored() {
    let Some(entries) = corpus() else { return };
    let well_formed: Vec<&Entry> =
        entries.iter().filter(|entry| entry.is_read_here() && entry.is_well_formed()).collect();
    assert_each(&well_formed, |entry| {
        let report = report(&entry.mesh());
        let stored = &entry.facts["stored"];
        let found = [("line_segments", report.loose_edges), ("points", report.loose_points)];
        let differs = found.into_iter().filter(|(key, value)| stored[*key] != json!(value));
        differs
            .map(|(key, value)| format!("{}: {key}: {} expected, found {value}", entry.name, stored[key]))
            .collect()
    });
}

#[test]
fn cracks_close_within_the_manifests_tolerance() {
    let Some(entries) = corpus() else { return };
    let cracked: Vec<&Entry> = entries
        .iter()
        .filter(|entry| entry.is_read_here() && entry.facts.get("tolerance_weld").is_some())
        .collect();
    assert!(!cracked.is_empty());
    assert_each(&cracked, |entry| {
        let expected = &entry.facts["tolerance_weld"];
        let tolerance = expected["tolerance"].as_f64().unwrap();
        let report = report(&welded(&entry.mesh(), Distance::Absolute(tolerance)));
        let found = json!({
            "tolerance": tolerance,
            "V": report.vertices,
            "E": report.edges,
            "F": report.faces,
            "watertight": is_watertight(&report),
        });
        (found != *expected)
            .then(|| format!("{}: {expected} expected, found {found}", entry.name))
            .into_iter()
            .collect()
    });
}

#[test]
fn orienting_flips_no_more_faces_than_it_has_to() {
    let Some(entries) = corpus() else { return };
    let is_plain = |(entry, view): &(&Entry, &str)| {
        let expected = entry.view(view).unwrap();
        expected["duplicate_faces"] == json!(0) && expected["min_flips_to_orient"].is_u64()
    };
    let views: Vec<_> = views(&entries).into_iter().filter(is_plain).collect();
    assert_each(&views, |&(entry, view)| {
        let expected = &entry.view(view).unwrap()["min_flips_to_orient"];
        let repaired = Pipeline::new([Orient::default().into()]).run(&mesh_of(entry, view)).unwrap();
        let flips = repaired.provenance.flipped.len();
        (*expected != json!(flips))
            .then(|| format!("{} {view}: {expected} flips expected, {flips} made", entry.name))
            .into_iter()
            .collect()
    });
}

#[test]
fn cutting_at_all_that_is_not_manifold_gives_the_manifests_pieces() {
    let Some(entries) = corpus() else { return };
    let is_simple = |(entry, view): &(&Entry, &str)| {
        let expected = entry.view(view).unwrap();
        expected["pinched_faces"] == json!(0) && expected["degenerate_faces"] == json!(0)
    };
    let views: Vec<_> = views(&entries).into_iter().filter(is_simple).collect();
    let split = Split { edges: SplitEdges::Cut, ..Split::default() };
    let pipeline = Pipeline::new([split.into()]);
    assert_each(&views, |&(entry, view)| {
        let expected = cut_in_manifest(&entry.view(view).unwrap()["cut"]);
        // Without its names, by which faces over the same vertices would be told apart: the manifest knows none.
        let mesh = mesh_of(entry, view).with_layers(Vec::new()).unwrap();
        let found = cut_in_report(&report(&pipeline.run(&mesh).unwrap().mesh), &expected);
        (found != expected)
            .then(|| format!("{} {view}: {expected} expected, found {found}", entry.name))
            .into_iter()
            .collect()
    });
}

/// What the manifest says of the surface cut open, its pieces counted by kind where all kinds are listed.
fn cut_in_manifest(cut: &Value) -> Value {
    let number = |key: &str| cut[key].as_i64().unwrap();
    let mut pieces: BTreeMap<String, u64> = BTreeMap::new();
    for piece in cut["pieces"].as_array().unwrap() {
        let mut kind = piece.clone();
        let count = kind.as_object_mut().unwrap().remove("count").unwrap();
        *pieces.entry(kind.to_string()).or_default() += count.as_u64().unwrap();
    }
    json!({
        "chi": number("V") - number("E") + number("F"),
        "F": number("F"),
        "components": number("components"),
        "boundary_loops": number("boundary_loops"),
        "pieces": if cut["pieces_complete"] == json!(true) { json!(pieces) } else { Value::Null },
    })
}

fn cut_in_report(report: &TopologyReport, expected: &Value) -> Value {
    let mut pieces: BTreeMap<String, u64> = BTreeMap::new();
    for kind in &report.component_kinds {
        let mut piece = json!({ "orientable": kind.orientable, "boundary_loops": kind.boundary_loops });
        let genus = if kind.orientable { "genus" } else { "nonorientable_genus" };
        piece[genus] = json!(kind.genus.or(kind.cross_caps));
        *pieces.entry(piece.to_string()).or_default() += kind.count;
    }
    json!({
        "chi": report.euler_characteristic,
        "F": report.faces,
        "components": report.components,
        "boundary_loops": report.boundary_loops,
        "pieces": if expected["pieces"].is_null() { Value::Null } else { json!(pieces) },
    })
}
