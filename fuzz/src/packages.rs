//! Packages: any text of a model, in an archive made round it, ends in meshes that are well formed or in an error; what
//! was read is written to the byte, and with another mesh only that changes.

use meshmend_core::{CornerId, Draft, FaceId, FaceTable, PolygonMesh, Sources, VertexId};
use meshmend_io::{
    Document, Format, LossKind, PreparedDocument, ReadOptions, WriteOptions, read_document_bytes,
};

use crate::compare::{assert_located, assert_well_formed};
use crate::zip::stored_archive;

const RELATIONS: &[u8] = b"<Relationships><Relationship Target=\"/3D/3dmodel.model\" \
    Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>";

/// The bytes as a package; those that are no archive, as the model of one.
pub fn threemf(data: &[u8]) {
    if data.starts_with(b"PK") {
        package(data);
        return;
    }
    let other = data.iter().position(|&byte| byte == 0).unwrap_or(data.len());
    let (root, other) = data.split_at(other);
    package(&stored_archive(&[
        ("_rels/.rels", RELATIONS),
        ("3D/3dmodel.model", root),
        ("3D/other.model", other.get(1..).unwrap_or_default()),
        ("Metadata/settings.config", b"layer = 1"),
    ]));
}

/// What holds for any bytes as a package.
pub(crate) fn package(bytes: &[u8]) {
    let document = match read(bytes) {
        Ok(document) => document,
        Err(error) => return assert_located(&error, bytes),
    };
    for part in &document.parts {
        assert_well_formed(&part.mesh);
        assert!(part.mesh.faces().is_all_triangles());
    }
    let (written, losses) = written(&document);
    assert!(written == bytes, "a package is not written as it was read");
    assert_eq!(losses, [], "nothing changed");
    for at in 0..document.parts.len().min(3) {
        if document.parts[at].seal().is_none() && document.parts[at].mesh.counts().faces > 0 {
            assert_spliced(&document, at);
        }
    }
}

fn read(bytes: &[u8]) -> Result<Document, meshmend_io::ReadError> {
    read_document_bytes(bytes, "mesh", &ReadOptions::default().with_format(Format::ThreeMf))
}

fn written(document: &Document) -> (Vec<u8>, Vec<meshmend_io::Loss>) {
    let prepared =
        PreparedDocument::new(document, &WriteOptions::of(Format::ThreeMf)).expect("it can be written");
    let mut bytes = Vec::new();
    prepared.encode(&mut bytes).expect("memory takes all bytes");
    (bytes, prepared.losses())
}

/// Another mesh in one part is read again as it was written, and all other parts are the same.
fn assert_spliced(document: &Document, at: usize) {
    let mesh = changed(&document.parts[at].mesh);
    let new = document.clone().with_mesh(at, mesh.clone());
    let (bytes, losses) = written(&new);
    let again = read(&bytes).expect("what was written can be read");
    assert_eq!(again.parts.len(), document.parts.len());
    for (number, (old, new)) in document.parts.iter().zip(&again.parts).enumerate() {
        assert_eq!((&old.name, &old.source, &old.status), (&new.name, &new.source, &new.status));
        let is_as_it_was = losses.iter().any(|loss| loss.kind == LossKind::ScenePart);
        let expected = if number == at && !is_as_it_was { &mesh } else { &old.mesh };
        assert_eq!(points(&new.mesh), points(expected), "part {number}");
    }
    assert!(written(&again).0 == bytes, "what was spliced is not written as it was read");
}

/// The mesh without its first face and the vertices that no face uses then, its last face turned, and one of the others
/// in two parts.
fn changed(mesh: &PolygonMesh) -> PolygonMesh {
    let old = mesh.faces();
    let last = old.face_count() - 1;
    let (mut corners, mut faces) = (Vec::new(), Vec::new());
    for face in old.faces().skip(1) {
        let [a, b, c] = [0, 1, 2].map(|place| CornerId(face.0 * 3 + place));
        let is_last = face.0 as usize == last;
        corners.extend(if is_last { [a, c, b] } else { [a, b, c] });
        faces.push(Some(face));
    }
    let mut used: Vec<VertexId> = corners.iter().map(|&corner| old.corner_vertex(corner)).collect();
    used.sort_unstable();
    used.dedup();
    let number = |corner: &CornerId| {
        let vertex = old.corner_vertex(*corner);
        VertexId(used.binary_search(&vertex).expect("it is used") as u32)
    };
    let table = FaceTable::triangles(used.len(), corners.iter().map(number).collect()).expect("triangles");
    let flipped = if faces.is_empty() { Vec::new() } else { vec![FaceId(faces.len() as u32 - 1)] };
    let sources = Sources::listed(corners.into_iter().map(Some));
    let draft = Draft {
        vertex_sources: Sources::listed(used.into_iter().map(Some)),
        flipped,
        ..Draft::of_faces(mesh, table, Sources::listed(faces), sources)
    };
    mesh.rebuild(draft).expect("the draft fits").0
}

/// The points of all corners.
fn points(mesh: &PolygonMesh) -> Vec<[u64; 3]> {
    let corners = mesh.faces().corner_vertices().iter();
    corners.map(|&vertex| mesh.position(vertex).map(f64::to_bits)).collect()
}
