//! What a row of the registry brings about, asked of every row, also of the example's.

use std::path::Path;

use meshmend_core::{FaceTable, PolygonMesh, VertexId};

use super::foreign;
use crate::{Format, Limits, NoteKind, ReadErrorKind, ReadOptions, WriteOptions, encode, losses, read_bytes};

fn triangle() -> PolygonMesh {
    let faces = FaceTable::triangles(3, [0, 1, 2].map(VertexId).to_vec()).unwrap();
    PolygonMesh::new(vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.5]], faces).unwrap()
}

/// Every format in every encoding, with the triangle written so.
fn written() -> impl Iterator<Item = (Format, &'static str, Vec<u8>)> {
    let forms = Format::ALL.iter().flat_map(|&format| format.encodings().iter().map(move |&e| (format, e)));
    forms.map(|(format, encoding)| {
        let mut bytes = Vec::new();
        let options = WriteOptions::of(format).with_encoding(encoding);
        assert!(encode(&triangle(), &options, &mut bytes).unwrap().is_empty(), "{format} {encoding}");
        (format, format.variant(encoding), bytes)
    })
}

#[test]
fn it_is_told_by_its_content_and_reads_back() {
    for (format, variant, bytes) in written() {
        assert_eq!(Format::from_content(&bytes), Some(format), "{variant}");
        let file = read_bytes(&bytes, "no-extension", &ReadOptions::default()).unwrap();
        assert_eq!((file.format, file.variant, file.notes.len()), (format, variant, 0));
        assert_eq!((file.mesh.positions(), file.mesh.faces()), (triangle().positions(), triangle().faces()));
        assert_eq!(file.shell.format(), Some(format));
    }
}

#[test]
fn it_has_its_extensions_alone() {
    let mut extensions: Vec<&str> =
        Format::ALL.iter().flat_map(|format| format.extensions()).copied().collect();
    assert!(extensions.iter().all(|extension| !foreign::is_extension(extension.as_ref())));
    extensions.sort_unstable();
    assert!(extensions.windows(2).all(|pair| pair[0] != pair[1]));
    for (format, variant, bytes) in written() {
        for extension in format.extensions() {
            assert_eq!(Format::from_path(Path::new(&format!("a.{extension}"))), Some(format));
            let file = read_bytes(&bytes, &format!("a.{extension}"), &ReadOptions::default()).unwrap();
            assert!(file.notes.is_empty(), "{variant}");
        }
        let file = read_bytes(&bytes, "a.fbx", &ReadOptions::default()).unwrap();
        assert_eq!(file.notes[0].kind, NoteKind::WrongSuffix, "{variant}");
    }
}

#[test]
fn it_is_named_where_the_formats_are_listed() {
    let unknown = read_bytes(b"hello", "a.txt", &ReadOptions::default()).unwrap_err().to_string();
    let unwritten = encode(&triangle(), &WriteOptions::default(), &mut Vec::new()).unwrap_err().to_string();
    for format in Format::ALL {
        assert!(unknown.contains(format.name()) && unwritten.contains(format.name()), "{format}");
    }
}

#[test]
fn it_keeps_the_limits() {
    for (format, variant, bytes) in written() {
        let least = Limits::default();
        for limits in [least.with_max_vertices(2), least.with_max_faces(0), least.with_max_corners(2)] {
            let options = ReadOptions::default().with_format(format).with_limits(limits);
            let error = read_bytes(&bytes, "a", &options).unwrap_err();
            assert!(matches!(error.kind, ReadErrorKind::LimitExceeded { .. }), "{variant}: {error}");
        }
    }
}

#[test]
fn it_names_what_it_does_not_hold() {
    let square = FaceTable::polygons(4, vec![0, 4], [0, 1, 3, 2].map(VertexId).to_vec()).unwrap();
    let points = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]];
    let square = PolygonMesh::new(points, square).unwrap();
    let loose = triangle().with_loose(vec![[VertexId(0), VertexId(1)]], vec![VertexId(2)]).unwrap();
    for &format in Format::ALL {
        let options = WriteOptions::of(format);
        assert_eq!(losses(&square, &options).is_empty(), format.holds_polygons(), "{format}");
        let mut bytes = Vec::new();
        let lost = encode(&loose, &options, &mut bytes).unwrap();
        let again = read_bytes(&bytes, "a", &ReadOptions::default().with_format(format)).unwrap();
        let kept = again.mesh.loose_edges() == loose.loose_edges()
            && again.mesh.loose_points() == loose.loose_points();
        // What stays in a file of its format alone is noted.
        let kept = kept || again.notes.iter().any(|note| note.kind == NoteKind::SkippedElement);
        assert_eq!(lost.is_empty(), kept, "{format}");
    }
}
