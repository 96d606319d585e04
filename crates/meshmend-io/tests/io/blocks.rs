//! Files that are read block by block say what their bytes say when they are all at hand.

use std::fs;

use crate::common::{Folder, written};
use meshmend_core::{Carry, Domain, FaceTable, Layer, Metadata, PolygonMesh, Values, VertexId};
use meshmend_io::{Encoding, Format, ReadError, ReadFile, ReadOptions, read, read_bytes};

/// More triangles and quads than a few blocks hold, with attributes.
pub(crate) fn large() -> PolygonMesh {
    let vertices = 40_000_u32;
    let positions = (0..vertices).map(|v| [v, v * 7 % 1013, v * v % 4099].map(f64::from)).collect();
    let corners = (0..vertices - 3).flat_map(|v| (v..v + 3 + u32::from(v % 5 == 0)).map(VertexId));
    let sizes = (0..vertices - 3).map(|v| 3 + u32::from(v % 5 == 0));
    let starts = [0].into_iter().chain(sizes.scan(0, |end, size| {
        *end += size;
        Some(*end)
    }));
    let faces = FaceTable::polygons(vertices as usize, starts.collect(), corners.collect()).unwrap();
    let heat: Vec<f64> = (0..vertices).map(|v| f64::from(v) / 3.0).collect();
    let count = faces.face_count();
    let layers = vec![
        Layer::direct("heat", Domain::Vertex, 1, Carry::Copy, Values::F64(heat)),
        Layer::direct(
            "kind",
            Domain::Face,
            1,
            Carry::Copy,
            Values::U8((0..count).map(|f| f as u8).collect()),
        ),
    ];
    PolygonMesh::new(positions, faces).unwrap().with_layers(layers).unwrap()
}

/// What a file says, and what its bytes say.
fn both(folder: &Folder, name: &str, bytes: &[u8]) -> [Result<ReadFile, ReadError>; 2] {
    let path = folder.0.join(name);
    fs::write(&path, bytes).unwrap();
    let name = path.display().to_string();
    [read(&path, &ReadOptions::default()), read_bytes(bytes, &name, &ReadOptions::default())]
}

#[track_caller]
fn assert_alike(folder: &Folder, name: &str, bytes: &[u8]) -> Option<ReadFile> {
    match both(folder, name, bytes) {
        [Ok(file), Ok(whole)] => {
            assert_eq!((file.format, file.variant, &file.notes), (whole.format, whole.variant, &whole.notes));
            assert_eq!(file.mesh.positions(), whole.mesh.positions());
            assert_eq!(file.mesh.faces(), whole.mesh.faces());
            assert_eq!(file.mesh.layers(), whole.mesh.layers());
            assert_eq!(file.mesh.metadata(), whole.mesh.metadata());
            Some(file)
        }
        [Err(file), Err(whole)] => {
            assert_eq!(file.to_string(), whole.to_string());
            None
        }
        [file, whole] => panic!("{file:?}, {whole:?}"),
    }
}

#[test]
fn large_files_of_every_form_say_what_their_bytes_say() {
    let folder = Folder::new("blocks");
    let mesh = large();
    for &format in Format::ALL {
        for &encoding in format.encodings() {
            let name = format!("large.{}", format.extensions()[0]);
            let (bytes, losses) = written(&mesh, format, encoding);
            let read = assert_alike(&folder, &name, &bytes).unwrap().mesh;
            if format == Format::Ply {
                let values =
                    |mesh: &PolygonMesh| mesh.layers().iter().map(|layer| layer.values().clone()).collect();
                let [read_values, stored]: [Vec<Values>; 2] = [values(&read), values(&mesh)];
                assert!(losses.is_empty() && read_values == stored && read.faces() == mesh.faces());
            }
        }
    }
}

#[test]
fn files_that_are_cut_or_have_more_say_what_their_bytes_say() {
    let folder = Folder::new("blocks-cut");
    let mesh = large();
    let forms = [
        (Format::Ply, Encoding::LittleEndian),
        (Format::Ply, Encoding::BigEndian),
        (Format::Stl, Encoding::LittleEndian),
    ];
    for (format, encoding) in forms {
        let name = format!("cut.{}", format.extensions()[0]);
        let (mut bytes, _) = written(&mesh, format, encoding);
        for part in 1..40 {
            let cut = &bytes[..bytes.len() * part / 40 + part % 3];
            assert!(assert_alike(&folder, &name, cut).is_none());
        }
        // Vertices that do not exist, and lengths of lists that are none.
        let places: Vec<usize> = (1..40).map(|part| bytes.len() * part / 40 + part % 13).collect();
        for place in places {
            let kept = std::mem::replace(&mut bytes[place], 0xEE);
            assert_alike(&folder, &name, &bytes);
            bytes[place] = kept;
        }
        bytes.extend([7; 49]);
        let file = assert_alike(&folder, &name, &bytes).unwrap();
        assert_eq!(file.notes.last().unwrap().count, 49);
    }
}

#[test]
fn facets_with_attributes_after_many_without_keep_them() {
    let folder = Folder::new("blocks-attributes");
    let (mut bytes, _) = written(&large(), Format::Stl, Encoding::LittleEndian);
    let last = bytes.len() - 2;
    bytes[last] = 9;
    let file = assert_alike(&folder, "attributes.stl", &bytes).unwrap();
    let Values::U16(values) = file.mesh.layer("attribute", Domain::Face).unwrap().values() else { panic!() };
    assert_eq!((values.len(), values[0], values.last()), (file.mesh.counts().faces, 0, Some(&9)));
}

#[test]
fn a_list_may_be_longer_than_a_block() {
    let folder = Folder::new("blocks-list");
    let vertices = 300_000;
    let corners = (0..vertices).map(VertexId).collect();
    let faces = FaceTable::polygons(vertices as usize, vec![0, vertices], corners).unwrap();
    let positions = (0..vertices).map(|v| [f64::from(v); 3]).collect();
    let mesh = PolygonMesh::new(positions, faces).unwrap();
    let (bytes, _) = written(&mesh, Format::Ply, Encoding::LittleEndian);
    let file = assert_alike(&folder, "long.ply", &bytes).unwrap();
    assert_eq!(file.mesh.faces(), mesh.faces());
}

#[test]
fn a_header_may_be_longer_than_what_is_read_first() {
    let folder = Folder::new("blocks-header");
    for length in [(1 << 16) - 3000, (1 << 16) - 200, 1 << 16, 1 << 18] {
        for more in 0..120 {
            let comment = Metadata { key: "comment".to_owned(), value: vec![b'c'; length + more] };
            let faces = FaceTable::triangles(3, [0, 1, 2].map(VertexId).to_vec()).unwrap();
            let mesh = PolygonMesh::new(vec![[0.5; 3], [1.0; 3], [2.0; 3]], faces).unwrap();
            let (mut bytes, _) =
                written(&mesh.with_metadata(vec![comment]), Format::Ply, Encoding::LittleEndian);
            // Long enough to be read in blocks.
            bytes.extend([1; 5000]);
            let file = assert_alike(&folder, "header.ply", &bytes).unwrap();
            assert_eq!(file.mesh.positions()[0], [0.5; 3]);
            assert_eq!(file.mesh.metadata()[0].value.len(), length + more);
        }
    }
}
