//! A glTF file is written as it was read, but for what of its meshes changed.

use meshmend_core::{Draft, FaceId, FaceTable, PolygonMesh, Sources, VertexId};
use meshmend_io::{
    Document, Format, PreparedDocument, ReadOptions, WriteOptions, read_document, read_document_bytes,
};

use crate::common::shared;
use crate::gltf_corpus::entries;

pub(crate) fn read(bytes: &[u8], name: &str) -> Document {
    read_document_bytes(bytes, name, &ReadOptions::default()).unwrap_or_else(|error| panic!("{error}"))
}

pub(crate) fn written(document: &Document, format: Format) -> Vec<u8> {
    let prepared = PreparedDocument::new(document, &WriteOptions::of(format)).unwrap();
    let mut bytes = Vec::new();
    prepared.encode(&mut bytes).unwrap();
    bytes
}

/// A mesh with some of its faces, in this order; those that are flipped begin with their last corner.
fn with_faces(mesh: &PolygonMesh, faces: &[(FaceId, bool)]) -> PolygonMesh {
    let old = mesh.faces();
    let corners: Vec<_> = faces
        .iter()
        .flat_map(|&(face, is_flipped)| {
            let mut corners: Vec<_> = old.face_corners(face).collect();
            if is_flipped {
                corners.reverse();
            }
            corners
        })
        .collect();
    let vertices: Vec<VertexId> = corners.iter().map(|&corner| old.corner_vertex(corner)).collect();
    let table = FaceTable::triangles(old.vertex_count(), vertices).unwrap();
    let sources = Sources::listed(faces.iter().map(|&(face, _)| Some(face)));
    let draft = Draft {
        flipped: faces
            .iter()
            .enumerate()
            .filter(|(_, (_, flipped))| *flipped)
            .map(|(at, _)| FaceId(at as u32))
            .collect(),
        ..Draft::of_faces(mesh, table, sources, Sources::listed(corners.into_iter().map(Some)))
    };
    mesh.rebuild(draft).unwrap().0
}

#[test]
fn what_is_not_changed_is_written_to_the_byte() {
    let Some(corpus) = shared("corpus") else { return };
    for (path, _) in entries(&corpus) {
        let Ok(document) = read_document(&path, &ReadOptions::default()) else { continue };
        let bytes = std::fs::read(&path).unwrap();
        assert!(written(&document, document.format) == bytes, "{}", path.display());
        // The other container holds the same.
        let other = if document.format == Format::Glb { Format::Gltf } else { Format::Glb };
        let converted = read(&written(&document, other), "other");
        assert_eq!(converted.format, other, "{}", path.display());
        assert_same(&document, &converted);
    }
}

/// The same parts, to the bit.
fn assert_same(one: &Document, other: &Document) {
    assert_eq!(one.parts.len(), other.parts.len());
    for (one, other) in one.parts.iter().zip(&other.parts) {
        assert_eq!((&one.name, &one.source, &one.status), (&other.name, &other.source, &other.status));
        assert_eq!(one.mesh.faces(), other.mesh.faces());
        assert_eq!(format!("{:?}", one.mesh.positions()), format!("{:?}", other.mesh.positions()));
        assert_eq!(format!("{:?}", one.mesh.layers()), format!("{:?}", other.mesh.layers()));
    }
}

/// What a part says of each face's corners: places, and the values of all attributes of the file.
fn corners(mesh: &PolygonMesh) -> Vec<String> {
    let layers: Vec<_> = mesh
        .layers()
        .iter()
        .filter(|layer| !["render-vertex", "primitive", "face"].contains(&layer.name()))
        .map(|layer| (layer, layer.corner_values(mesh.faces()).collect::<Vec<_>>()))
        .collect();
    let corner = |at: meshmend_core::CornerId| {
        let mut text = format!("{:?}", mesh.position(mesh.faces().corner_vertex(at)));
        for (layer, values) in &layers {
            let value = values[at.0 as usize];
            let numbers = value.map(|value| {
                let range = value * layer.width()..(value + 1) * layer.width();
                range.map(|place| layer.values().number(place).map(f64::to_bits)).collect::<Vec<_>>()
            });
            text += &format!(" {} {numbers:?}", layer.name());
        }
        text
    };
    mesh.faces().corners().map(corner).collect()
}

#[test]
fn one_changed_part_is_read_again_as_it_was_written_and_the_others_stay() {
    let Some(corpus) = shared("corpus") else { return };
    for (path, _) in entries(&corpus) {
        if std::fs::metadata(&path).unwrap().len() > 100_000 {
            continue;
        }
        let Ok(document) = read_document(&path, &ReadOptions::default()) else { continue };
        for (at, part) in document.parts.iter().enumerate() {
            let faces: Vec<FaceId> = part.mesh.faces().faces().collect();
            if faces.len() < 3 {
                continue;
            }
            let all = |face: &FaceId| (*face, false);
            let changes: [Vec<(FaceId, bool)>; 3] = [
                // A face goes, another is turned round, the faces stand in another order.
                faces.iter().skip(1).map(all).collect(),
                faces.iter().map(|&face| (face, face.0 == 1)).collect(),
                faces.iter().rev().map(all).collect(),
            ];
            for (kind, change) in changes.iter().enumerate() {
                let mesh = with_faces(&part.mesh, change);
                let expected = corners(&mesh);
                let changed = document.clone().with_mesh(at, mesh);
                for format in [Format::Glb, Format::Gltf] {
                    let again = read(&written(&changed, format), "again");
                    let name = format!("{} part {at} change {kind} as {format}", path.display());
                    let found = &again.parts[at].mesh;
                    // Faces stand primitive by primitive.
                    let sorted = |mut corners: Vec<String>| {
                        corners.sort();
                        corners
                    };
                    assert_eq!(sorted(corners(found)), sorted(expected.clone()), "{name}");
                    for (other, part) in document.parts.iter().enumerate().filter(|&(other, _)| other != at) {
                        let found = &again.parts[other].mesh;
                        assert_eq!(
                            format!("{:?}", found.layers()),
                            format!("{:?}", part.mesh.layers()),
                            "{name}"
                        );
                        assert_eq!(found.faces(), part.mesh.faces(), "{name}");
                    }
                    let twice = read(&written(&again, format), "twice");
                    assert!(written(&twice, format) == written(&again, format), "{name}");
                }
            }
            if document.parts.len() > 6 && at > 2 {
                break;
            }
        }
    }
}
