//! Documents through a repair, and what their corners have.

use std::path::PathBuf;

use meshmend_core::{CornerId, PolygonMesh};
use meshmend_io::{Document, Format, PreparedDocument, ReadOptions, WriteOptions, read_document_bytes};
use meshmend_repair::{Pipeline, Repaired};
use meshmend_tests::corpus::{Entry, corpus};

/// The glTF and GLB files of the corpus that can be read.
pub(crate) fn scenes() -> Option<Vec<(Entry, Vec<u8>, Document)>> {
    let is_scene = |entry: &Entry| entry.name.ends_with(".glb") || entry.name.ends_with(".gltf");
    let entries = corpus()?.into_iter().filter(is_scene).filter(Entry::is_well_formed);
    let read = entries.map(|entry| {
        let bytes = std::fs::read(&entry.path).unwrap();
        let document = document(&bytes);
        (entry, bytes, document)
    });
    Some(read.collect())
}

pub(crate) fn document(bytes: &[u8]) -> Document {
    read_document_bytes(bytes, "scene", &ReadOptions::default()).unwrap_or_else(|error| panic!("{error}"))
}

pub(crate) fn written(document: &Document, format: Format) -> Vec<u8> {
    let prepared = PreparedDocument::new(document, &WriteOptions::of(format)).unwrap();
    let mut bytes = Vec::new();
    prepared.encode(&mut bytes).unwrap();
    bytes
}

/// A document with each part repaired that a repair leaves something of, and what was done to each.
pub(crate) fn repaired(document: &Document) -> (Document, Vec<Option<Repaired>>) {
    let (mut result, mut records) = (document.clone(), Vec::new());
    for (at, part) in document.parts.iter().enumerate() {
        let repaired = Pipeline::default().run(&part.mesh).ok();
        if let Some(repaired) = &repaired {
            result = result.with_mesh(at, repaired.mesh.clone());
        }
        records.push(repaired);
    }
    (result, records)
}

/// What is at each corner: the place, and the values of all attributes that the file has, to the bit.
pub(crate) fn corners(mesh: &PolygonMesh) -> Vec<String> {
    let identity = ["render-vertex", "primitive", "face"];
    let layers = mesh.layers().iter().filter(|layer| !identity.contains(&layer.name()));
    let layers: Vec<_> =
        layers.map(|layer| (layer, layer.corner_values(mesh.faces()).collect::<Vec<_>>())).collect();
    let corner = |at: CornerId| {
        let position = mesh.position(mesh.faces().corner_vertex(at));
        let mut text = format!("{:?}", position.map(|x| x + 0.0));
        for (layer, values) in &layers {
            let numbers = values[at.0 as usize].map(|value| {
                let range = value * layer.width()..(value + 1) * layer.width();
                range.map(|place| layer.values().number(place).map(f64::to_bits)).collect::<Vec<_>>()
            });
            text += &format!(" {} {numbers:?}", layer.name());
        }
        text
    };
    mesh.faces().corners().map(corner).collect()
}

/// The triangles by their corners, each begun with its least one, in order.
pub(crate) fn triangles(mesh: &PolygonMesh) -> Vec<Vec<String>> {
    let corners = corners(mesh);
    let mut triangles: Vec<Vec<String>> = corners
        .chunks(3)
        .map(|triangle| {
            let least = (0..3).min_by_key(|&at| &triangle[at]).unwrap();
            (0..3).map(|at| triangle[(least + at) % 3].clone()).collect()
        })
        .collect();
    triangles.sort();
    triangles
}

/// Files in a folder, for programs that judge them.
pub(crate) fn stored(folder: &std::path::Path, name: &str, bytes: &[u8]) -> PathBuf {
    let path = folder.join(name);
    std::fs::write(&path, bytes).unwrap();
    path
}
