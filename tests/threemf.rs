//! Every 3MF file of the corpus that is whole, damaged and mended part by part: the topology comes back, each row keeps
//! what other programs say in it, and an independent checker finds nothing else changed.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use meshmend_core::{
    CornerId, Domain, Draft, FaceId, FaceTable, Layer, PolygonMesh, Sources, Values, VertexId,
};
use meshmend_io::{
    Document, Format, PreparedDocument, ReadOptions, WriteOptions, read_document, read_document_bytes,
};
use meshmend_repair::Pipeline;
use meshmend_tests::corpus::{Entry, corpus};
use meshmend_tests::judge::{assert_attributes_kept, python};
use meshmend_tests::program;
use meshmend_tests::scratch::Scratch;

/// The files whose meshes are closed, oriented and without doubles.
fn whole(entries: &[Entry]) -> Vec<&Entry> {
    let is_whole = |entry: &&Entry| {
        let tags = entry.facts["tags"].as_array().unwrap();
        let is_of = |tag: &str| tags.iter().any(|known| known == tag);
        entry.facts["format"] == "3mf" && is_of("clean-solid") && !is_of("weld-makes-degenerate")
    };
    entries.iter().filter(is_whole).collect()
}

fn read(bytes: &[u8]) -> Document {
    read_document_bytes(bytes, "test.3mf", &ReadOptions::default()).unwrap()
}

fn written(document: &Document) -> Vec<u8> {
    let prepared = PreparedDocument::new(document, &WriteOptions::of(Format::ThreeMf)).unwrap();
    let mut bytes = Vec::new();
    prepared.encode(&mut bytes).unwrap();
    bytes
}

/// The document with another mesh in each part that can be edited.
fn changed(document: &Document, change: impl Fn(&PolygonMesh) -> PolygonMesh) -> Document {
    let editable = (0..document.parts.len()).filter(|&at| document.parts[at].seal().is_none());
    let change = |new: Document, at: usize| {
        let mesh = change(&document.parts[at].mesh);
        new.with_mesh(at, mesh)
    };
    editable.fold(document.clone(), change)
}

fn repaired(document: &Document) -> Document {
    changed(document, |mesh| match mesh.counts().faces {
        0 => mesh.clone(),
        _ => Pipeline::default().run(mesh).unwrap().mesh,
    })
}

/// Every seventh face turned, every eleventh one twice, and at every thirteenth one three vertices of its own.
fn damaged(mesh: &PolygonMesh) -> PolygonMesh {
    let (old, count) = (mesh.faces(), mesh.counts());
    let mut sources: Vec<Option<VertexId>> =
        (0..count.vertices as u32).map(|at| Some(VertexId(at))).collect();
    let (mut corners, mut vertices) = (Vec::new(), Vec::new());
    let (mut faces, mut flipped) = (Vec::new(), Vec::new());
    let repeated = old.faces().filter(|face| face.0 % 11 == 5);
    for face in old.faces().chain(repeated) {
        let [a, b, c] = [0, 1, 2].map(|place| CornerId(face.0 * 3 + place));
        let is_turned = face.0 % 7 == 3;
        if is_turned {
            flipped.push(FaceId(faces.len() as u32));
        }
        for corner in if is_turned { [a, c, b] } else { [a, b, c] } {
            let vertex = old.corner_vertex(corner);
            let is_own = face.0 % 13 == 2;
            vertices.push(if is_own { VertexId(sources.len() as u32) } else { vertex });
            if is_own {
                sources.push(Some(vertex));
            }
            corners.push(Some(corner));
        }
        faces.push(Some(face));
    }
    let table = FaceTable::triangles(sources.len(), vertices).unwrap();
    let draft = Draft {
        vertex_sources: Sources::listed(sources),
        flipped,
        ..Draft::of_faces(mesh, table, Sources::listed(faces), Sources::listed(corners))
    };
    mesh.rebuild(draft).unwrap().0
}

#[test]
fn a_boundary_fails_a_check_of_an_object_that_must_be_closed() {
    let scratch = Scratch::new();
    let open = scratch.path().join("open.off");
    fs::write(&open, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").unwrap();
    let package = scratch.path().join("open.3mf");
    assert!(program::run([Path::new("convert"), &open, &package]).status.success());
    let status = |path: &Path| program::run([Path::new("check"), path]).status.code();
    assert_eq!((status(&open), status(&package)), (Some(0), Some(1)));
}

type Triangle = Vec<([u64; 3], Option<u32>)>;

/// Each triangle as its corners, with points and properties, from the least one on, and its property group.
fn triangles(mesh: &PolygonMesh) -> BTreeMap<Triangle, Option<u32>> {
    let number = |layer: Option<&Layer>, element: usize| {
        let layer = layer?;
        let Values::U32(values) = layer.values() else { return None };
        layer.value_of(element).map(|value| values[value])
    };
    let (groups, members) = (mesh.layer("pid", Domain::Face), mesh.layer("property", Domain::Corner));
    let triangle = |face: FaceId| {
        let corner = |corner: CornerId| {
            let vertex = mesh.faces().corner_vertex(corner);
            (mesh.position(vertex).map(f64::to_bits), number(members, corner.0 as usize))
        };
        let mut corners: Triangle = mesh.faces().face_corners(face).map(corner).collect();
        let least = (0..3).min_by_key(|&at| corners[at]).unwrap();
        corners.rotate_left(least);
        (corners, number(groups, face.0 as usize))
    };
    mesh.faces().faces().map(triangle).collect()
}

#[test]
fn damaged_copies_come_back_with_all_that_they_had() {
    let Some(entries) = corpus() else { return };
    let (files, scratch) = (whole(&entries), Scratch::new());
    assert!(files.len() >= 6, "{} files", files.len());
    for (number, entry) in files.into_iter().enumerate() {
        let original = read_document(&entry.path, &ReadOptions::default()).unwrap();
        let expected = written(&repaired(&original));
        let broken = read(&written(&changed(&original, damaged)));
        let mended = written(&repaired(&broken));
        // Once more changes nothing.
        assert_eq!(written(&repaired(&read(&mended))), mended, "{}", entry.name);
        for (one, other) in read(&expected).parts.iter().zip(&read(&mended).parts) {
            assert_eq!(one.mesh.counts(), other.mesh.counts(), "{}", entry.name);
            assert!(triangles(&one.mesh) == triangles(&other.mesh), "{}", entry.name);
        }
        let before = scratch.path().join(format!("{number}-before.3mf"));
        let after = scratch.path().join(format!("{number}-after.3mf"));
        fs::write(&before, &expected).unwrap();
        fs::write(&after, &mended).unwrap();
        let nothing = ["--allow-created", "0", "--allow-removed", "0"];
        assert_attributes_kept(&before, &after, &nothing, &entry.name);
    }
}

/// Reads each archive with the zip reader of Python, and prints the names of its entries.
const ZIP: &str = "import sys, zipfile
for name in sys.argv[1:]:
    archive = zipfile.ZipFile(name)
    assert archive.testzip() is None, name
    print([(i.filename, i.date_time, i.external_attr, i.comment) for i in archive.infolist()])";

#[test]
fn what_is_written_is_an_archive_in_the_eyes_of_others() {
    let (Some(entries), Some(python)) = (corpus(), python()) else { return };
    let scratch = Scratch::new();
    let (mut before, mut after) = (Vec::new(), Vec::new());
    let files = entries.iter().filter(|entry| entry.facts["format"] == "3mf" && entry.is_well_formed());
    for entry in files {
        let original = read_document(&entry.path, &ReadOptions::default()).unwrap();
        let broken = changed(&original, damaged);
        let path = scratch.path().join(format!("{}.3mf", after.len()));
        fs::write(&path, written(&broken)).unwrap();
        let again = read(&fs::read(&path).unwrap());
        for (one, other) in broken.parts.iter().zip(&again.parts) {
            assert_eq!(one.mesh.counts(), other.mesh.counts(), "{}", entry.name);
        }
        before.push(entry.path.clone());
        after.push(path);
    }
    assert!(after.len() >= 12, "{} files", after.len());
    let listed = |paths: &[PathBuf]| {
        let output = Command::new(python).args(["-c", ZIP]).args(paths).output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8_lossy(&output.stdout).into_owned()
    };
    for (one, other) in listed(&before).lines().zip(listed(&after).lines()) {
        assert_eq!(one, other);
    }
}
