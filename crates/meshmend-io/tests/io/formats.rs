//! What holds for all formats: how they are found, and that writing is all or nothing.

use std::path::Path;
use std::{fs, io};

use crate::common::{Folder, written};
use meshmend_core::{FaceTable, PolygonMesh, VertexId};
use meshmend_io::{
    Encoding, Format, Limits, Loss, LossKind, NoteKind, Place, ReadErrorKind, ReadOptions, WriteErrorKind,
    WriteOptions, encode, losses, read, read_bytes, read_stream, write,
};

fn triangle() -> PolygonMesh {
    let faces = FaceTable::triangles(3, [0, 1, 2].map(VertexId).to_vec()).unwrap();
    PolygonMesh::new(vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.5]], faces).unwrap()
}

/// The names of all formats, as messages list them.
fn known() -> String {
    Format::ALL.iter().map(|format| format.name()).collect::<Vec<&str>>().join(", ")
}

#[test]
fn extensions_stand_for_formats_in_any_case() {
    for &format in Format::ALL {
        for extension in format.extensions() {
            assert_eq!(Format::from_extension(&extension.to_uppercase()), Some(format));
        }
        assert_eq!(Format::from_path(Path::new(&format!("a.b/c.{}", format.extensions()[0]))), Some(format));
    }
    assert_eq!(Format::from_path(Path::new("obj")), None);
}

#[test]
fn only_formats_that_hold_polygons_carry_them_without_a_loss() {
    let square = FaceTable::polygons(4, vec![0, 4], [0, 1, 3, 2].map(VertexId).to_vec()).unwrap();
    let positions = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]];
    let square = PolygonMesh::new(positions, square).unwrap();
    for &format in Format::ALL {
        let is_cut = |loss: &Loss| loss.kind == LossKind::Polygons;
        let keeps = !losses(&square, &WriteOptions::of(format)).iter().any(is_cut);
        assert_eq!(format.holds_polygons(), keeps, "{format}");
    }
}

#[test]
fn content_tells_the_format_where_the_name_does_not() {
    let mesh = triangle();
    for &format in Format::ALL {
        for &encoding in format.encodings() {
            let (bytes, _) = written(&mesh, format, encoding);
            assert_eq!(Format::from_content(&bytes), Some(format), "{format} {encoding}");
            let file = read_bytes(&bytes, "no-extension", &ReadOptions::default()).unwrap();
            assert_eq!((file.format, file.mesh.counts().faces), (format, 1));
            assert_eq!(read_bytes(&bytes, "mesh.txt", &ReadOptions::default()).unwrap().format, format);
        }
    }
}

#[test]
fn content_that_may_be_anything_tells_no_format() {
    let empty_binary_stl = [0; 84];
    for bytes in
        [&b""[..], b"solid ground\n", b"a facet normal\n", &empty_binary_stl, b"v", b"ply1\n", b"# c\n"]
    {
        assert_eq!(Format::from_content(bytes), None, "{}", String::from_utf8_lossy(bytes));
    }
}

#[test]
fn unknown_formats_are_an_error_of_their_own() {
    for (bytes, name) in [(&b"hello"[..], "a.txt"), (b"o hello", "a"), (b"hello", "a.fbx")] {
        let error = read_bytes(bytes, name, &ReadOptions::default()).unwrap_err();
        assert!(matches!(error.kind, ReadErrorKind::UnknownFormat { looks_like: None }), "{error}");
        let expected = format!("{name}: the format is not known; known are {}", known());
        assert_eq!(error.to_string(), expected);
    }
}

#[test]
fn what_is_surely_something_else_is_named_whatever_its_name() {
    for (bytes, name) in [
        (&b"\x1f\x8b\x08"[..], "gzip-compressed data"),
        (b"<!DOCTYPE html><html>", "HTML, a web page, perhaps in place of a download"),
        (
            b"version https://git-lfs.github.com/spec/v1\noid",
            "a Git LFS pointer (`git lfs pull` fetches the file itself)",
        ),
        (b"\xff\xfev\0 \0", "text in UTF-16 (ASCII and UTF-8 are read)"),
    ] {
        for file in ["a.obj", "a.ply", "a.stl", "a.off", "a.glb", "a", "a.txt"] {
            let error = read_bytes(bytes, file, &ReadOptions::default()).unwrap_err();
            let expected = format!("{file}: looks like {name}; the formats that are read are {}", known());
            assert_eq!(error.to_string(), expected);
        }
        // Who says what it is gets it read so.
        let options = ReadOptions::default().with_format(Format::Ply);
        let error = read_bytes(bytes, "a.ply", &options).unwrap_err();
        assert!(matches!(error.kind, ReadErrorKind::Malformed(_)), "{error}");
    }
}

#[test]
fn a_wrong_suffix_is_noted_and_the_content_read() {
    let folder = Folder::new("suffix");
    for &format in Format::ALL {
        for &encoding in format.encodings() {
            let (bytes, _) = written(&triangle(), format, encoding);
            for suffix in ["obj", "PLY", "stl", "off", "gltf", "3mf"] {
                let name = format!("mesh.{suffix}");
                let of_bytes = read_bytes(&bytes, &name, &ReadOptions::default()).unwrap();
                let path = folder.0.join(&name);
                fs::write(&path, &bytes).unwrap();
                let of_file = read(&path, &ReadOptions::default()).unwrap();
                for file in [of_bytes, of_file] {
                    assert_eq!((file.format, file.mesh.counts().faces), (format, 1), "{name}");
                    let messages: Vec<&str> = file.notes.iter().map(|note| &note.message[..]).collect();
                    let expected = format!("the name ends in `{suffix}`, but the content is {format}");
                    let is_wrong = Format::from_extension(suffix) != Some(format);
                    assert_eq!(messages, if is_wrong { vec![&expected[..]] } else { Vec::new() });
                }
            }
        }
    }
    // Large binary files are told by their start.
    let faces = FaceTable::triangles(3, [0, 1, 2].map(VertexId).repeat(4000)).unwrap();
    let mesh = PolygonMesh::new(triangle().positions().to_vec(), faces).unwrap();
    for (format, suffix) in [(Format::Stl, "ply"), (Format::Ply, "stl"), (Format::Stl, "obj")] {
        let path = folder.0.join(format!("large.{suffix}"));
        fs::write(&path, written(&mesh, format, Encoding::LittleEndian).0).unwrap();
        let file = read(&path, &ReadOptions::default()).unwrap();
        assert_eq!((file.format, file.mesh.counts().faces), (format, 4000));
        assert_eq!(file.notes.len(), 1);
    }
}

#[test]
fn an_error_in_a_file_with_a_wrong_suffix_says_what_it_was_read_as() {
    let error = read_bytes(b"OFF\n3 1 0\n0 0 0\n", "a.stl", &ReadOptions::default()).unwrap_err();
    let told = "(the name ends in `stl`, but the content is OFF)";
    assert!(error.to_string().ends_with(told), "{error}");
    assert_eq!(error.place, Place::Line(2));
}

#[test]
fn what_may_be_anything_is_read_as_its_name_says() {
    for (bytes, name, format) in [
        (&b"# c\n"[..], "a.obj", Format::Obj),
        (b"f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n", "a.obj", Format::Obj),
        (b"3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "a.off", Format::Off),
        (b"solid v\nendsolid\n", "a.stl", Format::Stl),
    ] {
        let file = read_bytes(bytes, name, &ReadOptions::default()).unwrap();
        assert_eq!(file.format, format, "{name}");
        assert!(file.notes.iter().all(|note| note.kind != NoteKind::WrongSuffix), "{name}");
    }
}

#[test]
fn streams_are_told_by_their_content() {
    for &format in Format::ALL {
        let (bytes, _) = written(&triangle(), format, format.encodings()[0]);
        let file = read_stream(&bytes[..], "a stream", &ReadOptions::default()).unwrap();
        assert_eq!((file.format, file.mesh.counts().faces), (format, 1));
    }
    let limits = Limits::default().with_max_stream_bytes(1000);
    let error =
        read_stream(io::repeat(b'v'), "a stream", &ReadOptions::default().with_limits(limits)).unwrap_err();
    assert!(matches!(error.kind, ReadErrorKind::LimitExceeded { limit: 1000, .. }), "{error}");
    assert!(error.to_string().starts_with("a stream: "), "{error}");
}

#[test]
fn errors_show_file_place_and_reason() {
    let error = read_bytes(b"v 0 0 0\nf 2\n", "mesh.obj", &ReadOptions::default()).unwrap_err();
    assert_eq!(error.place, Place::Line(2));
    assert_eq!(error.to_string(), "mesh.obj: line 2: vertex 2 does not exist: the file has 1 vertex");
    let error = read(Path::new("/no/such/mesh.obj"), &ReadOptions::default()).unwrap_err();
    assert!(matches!(error.kind, ReadErrorKind::Io(_)));
    assert!(error.to_string().starts_with("/no/such/mesh.obj: "), "{error}");
    let error = read(&std::env::temp_dir(), &ReadOptions::default().with_format(Format::Obj));
    assert!(matches!(error.unwrap_err().kind, ReadErrorKind::Io(_)));
}

#[test]
fn a_file_is_written_and_read_and_may_be_its_own_target() {
    let folder = Folder::new("own");
    for &format in Format::ALL {
        let path = folder.0.join(format!("mesh.{}", format.extensions()[0]));
        assert!(write(&path, &triangle(), &WriteOptions::default()).unwrap().is_empty());
        let first = fs::read(&path).unwrap();
        let file = read(&path, &ReadOptions::default()).unwrap();
        let _ = write(&path, &file.mesh, &WriteOptions::default()).unwrap();
        assert_eq!(fs::read(&path).unwrap(), first, "{format}");
    }
    assert_eq!(fs::read_dir(&folder.0).unwrap().count(), Format::ALL.len());
}

#[test]
fn wishes_that_can_not_be_met_are_errors_and_touch_nothing() {
    let folder = Folder::new("wishes");
    let path = folder.0.join("mesh.xyz");
    let error = write(&path, &triangle(), &WriteOptions::default()).unwrap_err();
    assert!(matches!(error.kind, WriteErrorKind::UnknownFormat), "{error}");
    let big = WriteOptions::of(Format::Obj).with_encoding(Encoding::BigEndian);
    let error = write(&path, &triangle(), &big).unwrap_err();
    assert_eq!(error.to_string(), format!("{}: OBJ has no encoding `big-endian`", path.display()));
    assert_eq!(fs::read_dir(&folder.0).unwrap().count(), 0);
}

#[test]
fn losses_are_the_same_with_and_without_writing() {
    let mesh = triangle().with_loose(vec![[VertexId(0), VertexId(1)]], vec![VertexId(2)]).unwrap();
    for &format in Format::ALL {
        for &encoding in format.encodings() {
            let options = WriteOptions::of(format).with_encoding(encoding);
            let found = encode(&mesh, &options, &mut std::io::sink()).unwrap();
            assert_eq!(found, losses(&mesh, &options));
        }
    }
    assert!(losses(&mesh, &WriteOptions::of(Format::Obj)).is_empty());
}

#[test]
fn random_bytes_and_random_changes_end_in_a_result() {
    let mut state = 0x2545_f491_4f6c_dd1d_u64;
    let mut random = move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        state
    };
    let mesh = triangle();
    for &format in Format::ALL {
        for &encoding in format.encodings() {
            let (bytes, _) = written(&mesh, format, encoding);
            for _ in 0..4000 {
                let mut changed = bytes.clone();
                for _ in 0..1 + random() % 4 {
                    let at = random() as usize % changed.len();
                    changed[at] = random() as u8;
                }
                changed.truncate(changed.len() - random() as usize % 3);
                let options = ReadOptions::default().with_format(format);
                if let Ok(file) = read_bytes(&changed, "changed", &options) {
                    let again = written(&file.mesh, format, encoding).0;
                    assert!(
                        read_bytes(&again, "again", &options).is_ok(),
                        "{}",
                        String::from_utf8_lossy(&changed)
                    );
                }
            }
        }
    }
}
