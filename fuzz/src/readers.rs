//! Readers: any bytes end in a mesh that is well formed or in an error, and what was read is written so that it
//! reads back the same.

use meshmend_core::{Metadata, PolygonMesh};
use meshmend_io::{
    Format, Limits, LossKind, NoteKind, ReadError, ReadErrorKind, ReadFile, ReadOptions, WriteOptions,
};
use meshmend_io::{encode, read_bytes};

use crate::assets::gltf;
use crate::compare::{assert_located, assert_well_formed, position_keys, same_layer};
use crate::packages::package;

/// The bytes as an OBJ file.
pub fn obj(data: &[u8]) {
    read_and_write(Format::Obj, data);
}

/// The bytes as a PLY file.
pub fn ply(data: &[u8]) {
    read_and_write(Format::Ply, data);
}

/// The bytes as an STL file.
pub fn stl(data: &[u8]) {
    read_and_write(Format::Stl, data);
}

/// The bytes as an OFF file.
pub fn off(data: &[u8]) {
    read_and_write(Format::Off, data);
}

/// A byte that chooses a format of the registry, and the other bytes as a file of it. So each format is fuzzed from its
/// first day; those that have a target of their own have seeds and a dictionary there.
pub fn formats(data: &[u8]) {
    if let [choice, file @ ..] = data {
        match Format::ALL[usize::from(*choice) % Format::ALL.len()] {
            Format::Glb | Format::Gltf => gltf(file),
            format => read_and_write(format, file),
        }
    }
}

/// The bytes as a file whose name tells nothing: what the content tells is what is read. A name that tells a format is
/// believed, unless the content surely is another one, and then a note says so.
pub fn sniff(data: &[u8]) {
    let told = Format::from_content(data);
    match read_bytes(data, "mesh", &ReadOptions::default()) {
        Ok(file) => {
            assert_eq!(Some(file.format), told);
            assert_well_formed(&file.mesh);
        }
        Err(error) => {
            assert_eq!(matches!(error.kind, ReadErrorKind::UnknownFormat { .. }), told.is_none(), "{error}");
        }
    }
    for &format in Format::ALL {
        let name = format!("mesh.{}", format.extensions()[0]);
        match read_bytes(data, &name, &ReadOptions::default()) {
            Ok(file) if file.format == format => {}
            Ok(file) => {
                assert_eq!(Some(file.format), told, "{name}");
                assert!(file.notes.iter().any(|note| note.kind == NoteKind::WrongSuffix), "{name}");
            }
            Err(error) => assert_located(&error, data),
        }
    }
}

/// Reads bytes as a format.
pub(crate) fn read_as(format: Format, data: &[u8]) -> Result<ReadFile, ReadError> {
    read_bytes(data, "mesh", &ReadOptions::default().with_format(format))
}

fn read_and_write(format: Format, data: &[u8]) {
    if format == Format::ThreeMf {
        return package(data);
    }
    match read_as(format, data) {
        Ok(file) => {
            assert_eq!(file.format, format);
            assert_well_formed(&file.mesh);
            assert_within_limits(format, data, &file.mesh);
            assert_kept(format, &file.mesh);
        }
        Err(error) => assert_located(&error, data),
    }
}

/// A limit of one less than there is refuses the file, and one of just that much takes it.
fn assert_within_limits(format: Format, data: &[u8], mesh: &PolygonMesh) {
    let counts = mesh.counts();
    let read =
        |limits| read_bytes(data, "mesh", &ReadOptions::default().with_format(format).with_limits(limits));
    let faces = counts.faces as u64;
    if faces > 0 {
        let error = read(Limits::default().with_max_faces(faces - 1)).expect_err("a limit is exceeded");
        assert!(matches!(error.kind, ReadErrorKind::LimitExceeded { .. }), "{error}");
    }
    let least = Limits::default().with_max_faces(faces).with_max_corners(counts.corners as u64);
    assert!(read(least).is_ok(), "refused within its limits");
}

/// The statements of a mesh by their keys: a comment that stands before an element goes with it, and a file that is
/// written has all vertices before all faces.
fn by_key(mesh: &PolygonMesh) -> Vec<&Metadata> {
    let mut statements: Vec<&Metadata> = mesh.metadata().iter().collect();
    statements.sort_by_key(|statement| &statement.key);
    statements
}

/// Writes a mesh in the format from which it was read, and reads it again: the same mesh, unless a loss is named.
fn assert_kept(format: Format, mesh: &PolygonMesh) {
    for &encoding in format.encodings() {
        let options = WriteOptions::of(format).with_encoding(encoding);
        let mut bytes = Vec::new();
        let losses = encode(mesh, &options, &mut bytes).expect("what was read can be written");
        let again = read_as(format, &bytes).expect("what was written can be read").mesh;
        let loses = |kinds: &[LossKind]| losses.iter().any(|loss| kinds.contains(&loss.kind));
        let of_vertices = [LossKind::SharedVertices, LossKind::UnusedVertices, LossKind::Precision];
        if !loses(&of_vertices) && !loses(&[LossKind::Polygons, LossKind::ShortFaces]) {
            assert_eq!(position_keys(&again), position_keys(mesh), "{format} {encoding}");
            assert_eq!(again.faces(), mesh.faces(), "{format} {encoding}");
        }
        if losses.is_empty() {
            for layer in mesh.layers() {
                assert!(
                    same_layer(layer, &again),
                    "{format} {encoding}: {layer:?} became {:?}",
                    again.layers()
                );
            }
            assert_eq!(again.loose_edges(), mesh.loose_edges(), "{format} {encoding}");
            assert_eq!(again.loose_points(), mesh.loose_points(), "{format} {encoding}");
            // A file without a vertex has a comment that says so.
            let says_nothing = mesh.counts().vertices == 0 && mesh.metadata().is_empty();
            assert!(
                says_nothing || by_key(&again) == by_key(mesh),
                "{format} {encoding}: {:?}",
                mesh.metadata()
            );
        }
    }
}
