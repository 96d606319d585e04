//! Scenes whose meshes change: what changed is read again as it was, and all else stays.

use arbitrary::{Arbitrary, Unstructured};
use meshmend_core::{CornerId, Draft, FaceId, FaceTable, PolygonMesh, Sources, VertexId};
use meshmend_io::{
    Document, Format, LossKind, PreparedDocument, ReadOptions, WriteOptions, encode, read_document_bytes,
};

use crate::input::DressedMesh;

/// A small mesh as a file of several meshes, of which one changes: faces go, turn, come in another order, and vertices
/// come apart.
pub fn splice(data: &[u8]) {
    let mut data = Unstructured::new(data);
    let Ok(DressedMesh(mesh)) = DressedMesh::arbitrary(&mut data) else { return };
    let mut bytes = Vec::new();
    encode(&mesh, &WriteOptions::of(Format::Glb), &mut bytes).expect("a small mesh can be written");
    let document = read(&bytes);
    assert!(written(&document, Format::Glb).0 == bytes, "what is not changed is not the same");
    let Some(at) = document.parts.iter().position(|part| part.mesh.counts().faces > 0) else { return };
    let Ok(change) = changed(&document.parts[at].mesh, &mut data) else { return };
    let format = if data.arbitrary().unwrap_or(false) { Format::Glb } else { Format::Gltf };
    let changed = document.clone().with_mesh(at, change.clone());
    let (once, losses) = written(&changed, format);
    let again = read(&once);
    for (other, part) in document.parts.iter().enumerate().filter(|&(other, _)| other != at) {
        assert_eq!(format!("{:?}", again.parts[other].mesh), format!("{:?}", part.mesh));
    }
    let is_kept = losses.contains(&LossKind::EmptiedName) || losses.contains(&LossKind::AbsentValue);
    if !is_kept {
        assert_eq!(corners(&again.parts[at].mesh), corners(&change));
    }
    assert!(written(&again, format).0 == once, "a second time it is written otherwise");
}

fn read(bytes: &[u8]) -> Document {
    read_document_bytes(bytes, "scene", &ReadOptions::default()).expect("what was written can be read")
}

fn written(document: &Document, format: Format) -> (Vec<u8>, Vec<LossKind>) {
    let prepared = PreparedDocument::new(document, &WriteOptions::of(format)).expect("it is small");
    let mut bytes = Vec::new();
    prepared.encode(&mut bytes).expect("bytes take all that is written");
    (bytes, prepared.losses().iter().map(|loss| loss.kind).collect())
}

/// The mesh with some of its faces, some of them turned, and some corners at vertices of their own.
fn changed(mesh: &PolygonMesh, data: &mut Unstructured<'_>) -> arbitrary::Result<PolygonMesh> {
    let old = mesh.faces();
    let (mut corners, mut faces, mut turned) = (Vec::new(), Vec::new(), Vec::new());
    for _ in 0..data.int_in_range(0..=old.face_count() + 1)? {
        let face = FaceId(data.int_in_range(0..=old.face_count() as u32 - 1)?);
        let mut own: Vec<CornerId> = old.face_corners(face).collect();
        if data.ratio(1, 4)? {
            own.reverse();
            turned.push(FaceId(faces.len() as u32));
        }
        faces.push(face);
        corners.extend(own);
    }
    let mut sources: Vec<VertexId> = (0..old.vertex_count() as u32).map(VertexId).collect();
    let mut vertices = Vec::new();
    for &corner in &corners {
        let vertex = old.corner_vertex(corner);
        if data.ratio(1, 8)? {
            vertices.push(VertexId(sources.len() as u32));
            sources.push(vertex);
        } else {
            vertices.push(vertex);
        }
    }
    let table = FaceTable::triangles(sources.len(), vertices).expect("it is small");
    let draft = Draft {
        vertex_sources: Sources::listed(sources.into_iter().map(Some)),
        flipped: turned,
        ..Draft::of_faces(
            mesh,
            table,
            Sources::listed(faces.into_iter().map(Some)),
            Sources::listed(corners.into_iter().map(Some)),
        )
    };
    Ok(mesh.rebuild(draft).expect("the draft fits").0)
}

/// What is at each corner, face by face in any order.
fn corners(mesh: &PolygonMesh) -> Vec<Vec<String>> {
    let identity = ["render-vertex", "primitive", "face"];
    let layers = mesh.layers().iter().filter(|layer| !identity.contains(&layer.name()));
    let layers: Vec<_> =
        layers.map(|layer| (layer, layer.corner_values(mesh.faces()).collect::<Vec<_>>())).collect();
    let corner = |at: CornerId| {
        let place = mesh.position(mesh.faces().corner_vertex(at)).map(|x| (x + 0.0).to_bits());
        let values = layers.iter().map(|(layer, values)| {
            let numbers = values[at.0 as usize].map(|value| {
                let range = value * layer.width()..(value + 1) * layer.width();
                range.map(|place| layer.values().number(place).map(f64::to_bits)).collect::<Vec<_>>()
            });
            format!("{} {numbers:?}", layer.name())
        });
        format!("{place:?} {}", values.collect::<String>())
    };
    let corners: Vec<String> = mesh.faces().corners().map(corner).collect();
    let mut faces: Vec<Vec<String>> = corners.chunks(3).map(<[String]>::to_vec).collect();
    faces.sort();
    faces
}
