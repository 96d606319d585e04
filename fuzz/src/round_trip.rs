//! Writers: a mesh with everything reads back from every format, and what is not the same is named as a loss.

use arbitrary::{Arbitrary, Unstructured};
use meshmend_core::PolygonMesh;
use meshmend_io::{Encoding, Format, LossKind, WriteOptions, encode, losses};

use crate::compare::{assert_well_formed, number_key, position_keys, same_layer};
use crate::input::DressedMesh;
use crate::readers::read_as;

/// A small mesh with loose elements, attributes and statements, through every format in every encoding.
pub fn round_trip(data: &[u8]) {
    let Ok(DressedMesh(mesh)) = DressedMesh::arbitrary(&mut Unstructured::new(data)) else { return };
    for &format in Format::ALL {
        for &encoding in format.encodings() {
            through(&mesh, format, encoding);
        }
    }
}

fn through(mesh: &PolygonMesh, format: Format, encoding: Encoding) {
    let options = WriteOptions::of(format).with_encoding(encoding);
    let write = |mesh: &PolygonMesh| {
        let mut bytes = Vec::new();
        let named = encode(mesh, &options, &mut bytes).expect("a small mesh can be written");
        (bytes, named)
    };
    let (bytes, named) = write(mesh);
    assert_eq!(named, losses(mesh, &options), "losses without writing");
    let text = || String::from_utf8_lossy(&bytes);
    let again = match read_as(format, &bytes) {
        Ok(file) => file.mesh,
        Err(error) => panic!("{format} {encoding}: {error} in\n{}", text()),
    };
    assert_well_formed(&again);
    for (what, excuses) in differences(mesh, &again, format) {
        let is_named = named.iter().any(|loss| excuses.contains(&loss.kind));
        assert!(is_named, "{format} {encoding}: {what} changed, but named are {named:?}\n{}", text());
    }
    let second = write(&again).0;
    assert!(
        second == bytes,
        "{format} {encoding} is written otherwise:\n{}\n{}",
        text(),
        String::from_utf8_lossy(&second)
    );
}

/// What differs, with the kinds of loss that say so.
fn differences(old: &PolygonMesh, new: &PolygonMesh, format: Format) -> Vec<(String, Vec<LossKind>)> {
    use LossKind::{
        AbsentValue, Converted, Layer, LooseEdges, LoosePoints, Metadata, Names, Polygons, Precision,
        SharedVertices, ShortFaces, UnusedVertices,
    };
    let mut found = Vec::new();
    let mut note = |differs: bool, what: &str, excuses: &[LossKind]| {
        if differs {
            found.push((what.to_owned(), excuses.to_vec()));
        }
    };
    let of_shape = [Precision, SharedVertices, UnusedVertices, Polygons, ShortFaces];
    if format == Format::Stl {
        note(corner_points(old) != corner_points(new), "the corners' points", &of_shape);
        note(old.counts() != new.counts(), "the counts", &of_shape);
    } else {
        note(position_keys(old) != position_keys(new), "positions", &[]);
        note(old.faces() != new.faces(), "faces", &[]);
    }
    note(old.loose_edges() != new.loose_edges(), "loose edges", &[LooseEdges]);
    note(old.loose_points() != new.loose_points(), "loose points", &[LoosePoints]);
    // A file without a vertex has a comment that says so.
    let says_nothing = old.counts().vertices == 0 && old.metadata().is_empty();
    note(!says_nothing && old.metadata() != new.metadata(), "metadata", &[Metadata, Names, Converted]);
    for layer in old.layers() {
        let excuses = [Layer, AbsentValue, Converted, Names, Polygons, ShortFaces];
        note(!same_layer(layer, new), &format!("layer {:?}", layer.name()), &excuses);
    }
    for layer in new.layers() {
        let is_old = old.layer(layer.name(), layer.domain()).is_some();
        note(!is_old, &format!("new layer {:?}", layer.name()), &[Converted, Names, Metadata]);
    }
    found
}

/// The points of each face's corners.
fn corner_points(mesh: &PolygonMesh) -> Vec<Vec<[u64; 3]>> {
    let points =
        |face| mesh.faces().face_vertices(face).iter().map(|&v| mesh.position(v).map(number_key)).collect();
    mesh.faces().faces().map(points).collect()
}
