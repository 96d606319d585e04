//! A repair on which nobody asks for a report does the same as one with a report, whose passes all look for themselves.

#![allow(clippy::unwrap_used, reason = "a test stops where it fails")]

use std::fs;
use std::path::{Path, PathBuf};

use meshmend::files::{FileRepair, FileTarget, Judged};
use meshmend::formats::{encode, read_document_bytes};
use meshmend::mesh::{PolygonMesh, Watch};
use meshmend::passes::Session;
use meshmend::{Encoding, Format, KernelKind, Pipeline, Plan, ReadOptions, WriteOptions};
use meshmend_testkit::shapes::catalogue;
use meshmend_testkit::worlds::{any_table, damaged_shape, triangle_soup};
use proptest::prelude::*;

/// What a repair makes of the bytes of a file, and all that it says but for what a report judges.
fn made(bytes: &[u8], name: &str, plan: &str, format: Format, judged: Judged) -> String {
    let options = ReadOptions::default().with_shared_places();
    let Ok(document) = read_document_bytes(bytes, name, &options) else { return "unread".to_owned() };
    let target = FileTarget::new("out", WriteOptions::of(format).with_shell(document.shell.clone()));
    let mut repair = FileRepair::of(Plan::from_toml(plan).unwrap());
    repair.judged = judged;
    let repaired = match repair.run(name, document, Some(&target), &Watch::NOBODY) {
        Ok(repaired) => repaired,
        Err(error) => return error.to_string(),
    };
    let mut written = Vec::new();
    let encoded = repaired.prepared().unwrap().encode(&mut written).map_err(|error| error.to_string());
    let mut document: serde_json::Value = serde_json::from_str(&repaired.report_json().unwrap()).unwrap();
    let report = document.as_object_mut().unwrap();
    for judged in ["before", "after", "geometry_changes"] {
        report.remove(judged);
    }
    // The report on a file of parts has those of each part, which is judged.
    for pass in report.get_mut("passes").and_then(|passes| passes.as_array_mut()).into_iter().flatten() {
        // How `verify` looked is asked for with the report.
        pass.as_object_mut().unwrap().remove("looked");
    }
    format!("{encoded:?} {document}\n{written:?}")
}

#[track_caller]
fn assert_same(bytes: &[u8], name: &str, plan: &str, format: Format) {
    let [spared, whole] =
        [Judged::Neither, Judged::After].map(|judged| made(bytes, name, plan, format, judged));
    assert_eq!(spared, whole, "{name}, {plan}, {format}");
}

/// The default, and policies of each pass that may be spared.
const PLANS: [&str; 6] = [
    "",
    "[weld]\ndistance = \"single\"",
    "[orient]\nside = \"outward\"",
    "[orient]\nduplicates = \"remove-pair\"\n[split]\nedges = \"cut\"",
    "[triangulate]\nfaces = \"all\"\n[clean]\nnon-finite = \"keep\"",
    "passes = [\"clean\", \"orient\", \"split\", \"compact\"]",
];

fn bytes_of(mesh: &PolygonMesh, format: Format) -> Vec<u8> {
    let mut bytes = Vec::new();
    encode(mesh, &WriteOptions::of(format).with_encoding(Encoding::LittleEndian), &mut bytes).unwrap();
    bytes
}

/// As a soup, and by index.
fn assert_same_of(mesh: &PolygonMesh, plan: &str) {
    assert_same(&bytes_of(mesh, Format::Stl), "mesh.stl", plan, Format::Stl);
    assert_same(&bytes_of(mesh, Format::Stl), "mesh.stl", plan, Format::Ply);
    assert_same(&bytes_of(mesh, Format::Ply), "mesh.ply", plan, Format::Ply);
}

#[test]
fn shapes_with_known_answers_come_out_the_same() {
    for shape in catalogue() {
        PLANS.iter().for_each(|plan| assert_same_of(&shape.soup.mesh(), plan));
    }
}

#[test]
fn every_file_of_the_corpus_comes_out_the_same() {
    for name in ["corpus", "field"] {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared").join(name);
        if !folder.exists() {
            println!("skipped: there is no {}", folder.display());
            return;
        }
        for path in files(&folder) {
            let bytes = fs::read(&path).unwrap();
            let is_mesh = Format::from_path(&path).is_some_and(|format| !matches!(format, Format::Gltf));
            if is_mesh && bytes.len() < 2_000_000 {
                let name = path.display().to_string();
                assert_same(&bytes, &name, "", Format::Ply);
                assert_same(&bytes, &name, "", Format::Stl);
            }
        }
    }
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let (folders, files): (Vec<_>, Vec<_>) = entries.partition(|path| path.is_dir());
    files.into_iter().chain(folders.iter().flat_map(|folder| self::files(folder))).collect()
}

/// A surface is spared its passes, and any other mesh is not: the record tells, as `verify` looks at a mesh that it is begun on.
#[test]
fn passes_are_spared_on_a_surface_alone() {
    let looked = |mesh: &PolygonMesh, kernel| {
        let session = Session::begin(mesh).sparing_topology().with_kernel(kernel);
        let repaired = Pipeline::default().run_in(session).unwrap();
        repaired.passes.last().unwrap().looked.is_some()
    };
    let torus = meshmend::shapes::torus(6, 5).unwrap().triangulated().unwrap().mesh;
    assert!(!looked(&torus, KernelKind::default()));
    assert!(looked(&torus, KernelKind::HalfEdge));
    assert!(looked(&meshmend::shapes::book(3).unwrap().mesh, KernelKind::default()));
    assert!(looked(&meshmend::shapes::torus(6, 5).unwrap().mesh, KernelKind::default()), "quads");
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(300) })]

    #[test]
    fn random_meshes_come_out_the_same(
        soup in prop_oneof![any_table(9), triangle_soup(14), damaged_shape().prop_map(|(_, _, soup)| soup)],
        plan in 0..PLANS.len(),
    ) {
        assert_same_of(&soup.mesh(), PLANS[plan]);
    }
}
