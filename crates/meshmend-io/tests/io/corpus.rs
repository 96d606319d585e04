//! Every file of the shared corpus in a format that is read here, against what its manifest says is stored in it.

use std::collections::BTreeMap;
use std::path::Path;

use meshmend_core::{Domain, PolygonMesh};
use meshmend_io::{
    Document, Format, LossKind, PreparedDocument, ReadFile, ReadOptions, Seams, WriteOptions, encode, losses,
    read, read_bytes, read_document,
};
use serde_json::Value;

use crate::common::shared;

/// The manifest's entries of files in formats that are read here.
fn entries(corpus: &Path) -> Vec<Value> {
    let text = std::fs::read_to_string(corpus.join("manifest.json")).unwrap();
    let manifest: Value = serde_json::from_str(&text).unwrap();
    let files = manifest["files"].as_array().unwrap().iter();
    files.filter(|entry| is_read_here(entry["path"].as_str().unwrap())).cloned().collect()
}

fn is_read_here(path: &str) -> bool {
    Format::from_path(Path::new(path)).is_some()
}

fn stored(document: &Document) -> BTreeMap<String, u64> {
    let totals = ["vertices", "faces", "line_segments", "points"];
    let mut counts = BTreeMap::from(totals.map(|what| (what.to_owned(), 0)));
    let mut add = |what: &str, count: usize| *counts.entry(what.to_owned()).or_default() += count as u64;
    for mesh in document.parts.iter().map(|part| &part.mesh) {
        add("vertices", mesh.counts().vertices);
        add("faces", mesh.counts().faces);
        add("line_segments", mesh.loose_edges().len());
        add("points", mesh.loose_points().len());
        for face in mesh.faces().faces() {
            add(&mesh.faces().corner_range(face).len().to_string(), 1);
        }
    }
    counts
}

/// Whether a file of a format is one mesh, so that the mesh is all that is written of it.
fn is_one_mesh(format: Format) -> bool {
    !matches!(format, Format::Glb | Format::Gltf | Format::ThreeMf)
}

fn expected(entry: &Value) -> BTreeMap<String, u64> {
    let of = |value: &Value| value.as_u64().unwrap();
    let stored = &entry["stored"];
    let totals = ["vertices", "faces", "line_segments", "points"];
    let mut counts: BTreeMap<String, u64> = totals.iter().map(|&k| (k.to_owned(), of(&stored[k]))).collect();
    counts.extend(stored["face_sizes"].as_object().unwrap().iter().map(|(k, v)| (k.clone(), of(v))));
    counts
}

#[test]
fn well_formed_files_hold_what_the_manifest_says() {
    let Some(corpus) = shared("corpus") else { return };
    let mut wrong = Vec::new();
    for entry in entries(&corpus).iter().filter(|entry| entry.get("malformed").is_none()) {
        let path = entry["path"].as_str().unwrap();
        match read_document(&corpus.join(path), &ReadOptions::default()) {
            Err(error) => wrong.push(error.to_string()),
            Ok(file) => {
                let (mut stored, expected) = (stored(&file), expected(entry));
                // The manifest counts the vertices of each primitive, also of those that share them.
                if !is_one_mesh(file.format) && stored["vertices"] < expected["vertices"] {
                    stored.insert("vertices".to_owned(), expected["vertices"]);
                }
                if stored != expected || file.variant != entry["format"].as_str().unwrap() {
                    wrong.push(format!("{path}: {} {stored:?}, not {expected:?}", file.variant));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn malformed_files_are_refused_with_a_place() {
    let Some(corpus) = shared("corpus") else { return };
    let mut wrong = Vec::new();
    for entry in entries(&corpus).iter().filter(|entry| entry.get("malformed").is_some()) {
        let path = entry["path"].as_str().unwrap();
        let result = read(&corpus.join(path), &ReadOptions::default());
        match (&result, entry["malformed"]["verdict"].as_str().unwrap()) {
            (Ok(_), "reject") => wrong.push(format!("{path} was read: {}", entry["malformed"]["why"])),
            (Err(error), _) => println!("{error}"),
            (Ok(file), _) => println!("{path}: {:?}", file.notes),
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn hostile_files_end_as_they_have_to() {
    let Some(torture) = shared("torture") else { return };
    let text = std::fs::read_to_string(torture.join("manifest.json")).unwrap();
    let cases: Value = serde_json::from_str(&text).unwrap();
    let mut wrong = Vec::new();
    for case in cases.as_array().unwrap() {
        let name = case["file"].as_str().unwrap();
        let path = torture.join("files").join(name);
        if !path.exists() {
            continue;
        }
        let result = read(&path, &ReadOptions::default());
        match (&result, case["expect"].as_str().unwrap()) {
            (Ok(_), "error") => wrong.push(format!("{name} was read: {}", case["note"])),
            (Err(error), "accept") if is_read_here(name) => wrong.push(format!("{error}: {}", case["note"])),
            (Err(error), _) => println!("{error}"),
            (Ok(file), _) => println!("{name}: {:?}", file.notes),
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Whether two meshes are the same to the bit, apart from the payload of NaNs.
fn same(one: &PolygonMesh, other: &PolygonMesh) -> Result<(), String> {
    let bits = |mesh: &PolygonMesh| -> Vec<u64> {
        mesh.positions().iter().flatten().map(|x| if x.is_nan() { u64::MAX } else { x.to_bits() }).collect()
    };
    let differs = |what: &str| Err(format!("{what} differ"));
    if bits(one) != bits(other) {
        return differs("positions");
    }
    if one.faces() != other.faces() {
        return differs("faces");
    }
    if one.loose_edges() != other.loose_edges() || one.loose_points() != other.loose_points() {
        return differs("loose elements");
    }
    if one.metadata() != other.metadata() {
        return Err(format!("metadata differ: {:?} {:?}", one.metadata(), other.metadata()));
    }
    // Debug shows bits of numbers, and NaN as equal to itself.
    for (a, b) in one.layers().iter().zip(other.layers()) {
        if format!("{a:?}") != format!("{b:?}") {
            return Err(format!("layers `{}` and `{}` differ", a.name(), b.name()));
        }
    }
    if one.layers().len() == other.layers().len() { Ok(()) } else { differs("numbers of layers") }
}

fn rewritten(mesh: &PolygonMesh, options: &WriteOptions) -> ReadFile {
    let mut bytes = Vec::new();
    encode(mesh, options, &mut bytes).unwrap();
    let name = format!("rewritten.{}", options.format.unwrap().extensions()[0]);
    read_bytes(&bytes, &name, &ReadOptions::default()).unwrap()
}

#[test]
fn what_is_read_and_written_in_the_same_format_is_read_again_to_the_bit() {
    let Some(corpus) = shared("corpus") else { return };
    let mut wrong = Vec::new();
    for entry in entries(&corpus) {
        let path = entry["path"].as_str().unwrap();
        let Ok(file) = read(&corpus.join(path), &ReadOptions::default()) else { continue };
        if !is_one_mesh(file.format) {
            continue;
        }
        for &encoding in file.format.encodings() {
            // What the format can't carry is named; that equal points of a soup become one again is no change.
            let options = WriteOptions::of(file.format).with_encoding(encoding).as_read(&file);
            let losses = losses(&file.mesh, &options);
            if losses.iter().any(|loss| loss.kind != LossKind::SharedVertices) {
                assert_eq!(file.format, Format::Stl, "{path} as {encoding}: {losses:?}");
                continue;
            }
            let again = rewritten(&file.mesh, &options);
            if let Err(reason) = same(&file.mesh, &again.mesh) {
                wrong.push(format!("{path} as {encoding}: {reason}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Whether files of a format hold more than one mesh. They are written from what was read.
fn is_of_parts(format: Format) -> bool {
    matches!(format, Format::ThreeMf)
}

#[test]
fn files_of_parts_come_out_to_the_byte() {
    let Some(corpus) = shared("corpus") else { return };
    let mut count = 0;
    for entry in entries(&corpus) {
        let path = corpus.join(entry["path"].as_str().unwrap());
        let Ok(document) = read_document(&path, &ReadOptions::default()) else { continue };
        if is_of_parts(document.format) {
            let prepared = PreparedDocument::new(&document, &WriteOptions::of(document.format)).unwrap();
            let mut bytes = Vec::new();
            prepared.encode(&mut bytes).unwrap();
            assert_eq!(
                (bytes, prepared.losses()),
                (std::fs::read(&path).unwrap(), Vec::new()),
                "{}",
                path.display()
            );
            count += 1;
        }
    }
    assert!(count > 15, "{count} files");
}

#[test]
fn every_format_carries_faces_and_positions_of_every_file() {
    let Some(corpus) = shared("corpus") else { return };
    for entry in entries(&corpus) {
        let path = entry["path"].as_str().unwrap();
        let Ok(file) = read(&corpus.join(path), &ReadOptions::default()) else { continue };
        let is_whole =
            file.mesh.faces().is_all_triangles() && file.mesh.layer("object", Domain::Face).is_none();
        let is_fit = |format: Format| format.holds_polygons() || (format.has_indices() && is_whole);
        for &format in Format::ALL.iter().filter(|&&format| is_fit(format)) {
            for &encoding in format.encodings() {
                // Split vertices have other faces and positions; what they are is asked elsewhere.
                let options = WriteOptions::of(format).with_seams(Seams::Corners);
                let again = rewritten(&file.mesh, &options.with_encoding(encoding));
                assert_eq!(again.mesh.faces(), file.mesh.faces(), "{path} as {format} {encoding}");
                let bits = |mesh: &PolygonMesh| -> Vec<u64> {
                    mesh.positions()
                        .iter()
                        .flatten()
                        .map(|x| if x.is_nan() { 1 } else { x.to_bits() })
                        .collect()
                };
                assert_eq!(bits(&again.mesh), bits(&file.mesh), "{path} as {format} {encoding}");
            }
        }
    }
}
