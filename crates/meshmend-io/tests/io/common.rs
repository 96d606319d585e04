//! What the tests of all formats share.

use std::fs;
use std::path::{Path, PathBuf};

use meshmend_core::{Domain, Layer, PolygonMesh, Values};
use meshmend_io::{
    Encoding, Format, Loss, Note, NoteKind, Place, ReadError, ReadErrorKind, ReadFile, ReadOptions,
    WriteOptions, encode, read_bytes,
};

/// An empty folder that is removed again.
pub(crate) struct Folder(pub(crate) PathBuf);

impl Folder {
    pub(crate) fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("meshmend-io-{name}-{}", std::process::id()));
        fs::remove_dir_all(&path).ok();
        fs::create_dir_all(&path).unwrap();
        Folder(path)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        fs::remove_dir_all(&self.0).ok();
    }
}

/// A path in the folder of references and test files beside the workspace, if it exists.
pub(crate) fn shared(name: &str) -> Option<PathBuf> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared").join(name);
    if path.exists() {
        return Some(path);
    }
    println!("skipped: there is no {}", path.display());
    None
}

/// Reads bytes as a format.
pub(crate) fn try_read(format: Format, bytes: impl AsRef<[u8]>) -> Result<ReadFile, ReadError> {
    let options = ReadOptions::default().with_format(format);
    read_bytes(bytes.as_ref(), "test", &options)
}

/// Reads bytes that have to be well formed.
#[track_caller]
pub(crate) fn read(format: Format, bytes: impl AsRef<[u8]>) -> ReadFile {
    try_read(format, bytes).unwrap()
}

/// The place and the reason of malformed bytes.
#[track_caller]
pub(crate) fn refused(format: Format, bytes: impl AsRef<[u8]>) -> (Place, String) {
    let error = try_read(format, bytes).unwrap_err();
    match error.kind {
        ReadErrorKind::Malformed(reason) => (error.place, reason),
        other => panic!("refused for another reason: {other}"),
    }
}

/// What is written, and what is lost.
#[track_caller]
pub(crate) fn written(mesh: &PolygonMesh, format: Format, encoding: Encoding) -> (Vec<u8>, Vec<Loss>) {
    let mut bytes = Vec::new();
    let losses = encode(mesh, &WriteOptions::of(format).with_encoding(encoding), &mut bytes).unwrap();
    (bytes, losses)
}

/// Writes and reads again, and asserts that nothing is lost or changed.
#[track_caller]
pub(crate) fn assert_kept(mesh: &PolygonMesh, format: Format, encoding: Encoding) {
    let (bytes, losses) = written(mesh, format, encoding);
    assert_eq!(losses, [], "{}", String::from_utf8_lossy(&bytes));
    let again = read(format, &bytes).mesh;
    assert_eq!(again.positions(), mesh.positions());
    assert_eq!(again.faces(), mesh.faces());
    assert_eq!(again.layers(), mesh.layers(), "{}", String::from_utf8_lossy(&bytes));
    assert_eq!(again.metadata(), mesh.metadata());
    assert_eq!(again.loose_edges(), mesh.loose_edges());
    assert_eq!(again.loose_points(), mesh.loose_points());
}

/// The faces as lists of vertex numbers.
pub(crate) fn faces(mesh: &PolygonMesh) -> Vec<Vec<u32>> {
    let table = mesh.faces();
    table.faces().map(|face| table.face_vertices(face).iter().map(|v| v.0).collect()).collect()
}

/// The layer of a name.
#[track_caller]
pub(crate) fn layer<'a>(mesh: &'a PolygonMesh, name: &str, domain: Domain) -> &'a Layer {
    mesh.layer(name, domain).unwrap_or_else(|| panic!("no layer `{name}`"))
}

/// The names that a layer of names gives to its elements.
pub(crate) fn names(layer: &Layer) -> Vec<Option<String>> {
    let Values::Text(pool) = layer.values() else { panic!("no names") };
    let name = |value: usize| String::from_utf8_lossy(&pool[value]).into_owned();
    (0..layer.element_count()).map(|element| layer.value_of(element).map(name)).collect()
}

/// The only note of a kind.
#[track_caller]
pub(crate) fn note(file: &ReadFile, kind: NoteKind) -> &Note {
    let mut of_kind = file.notes.iter().filter(|note| note.kind == kind);
    let note = of_kind.next().unwrap_or_else(|| panic!("no note {kind:?} in {:?}", file.notes));
    assert_eq!(of_kind.next(), None);
    note
}

/// A file with another mesh in its place.
pub(crate) fn with_mesh(mut file: ReadFile, mesh: PolygonMesh) -> ReadFile {
    file.mesh = mesh;
    file
}
