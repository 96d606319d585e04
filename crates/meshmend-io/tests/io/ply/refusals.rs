//! What the PLY reader refuses, and where it says so.

use super::{LIST, XYZ, ascii, read, refused, triangle};
use crate::common::{note, written};
use meshmend_io::{Encoding, Format, NoteKind, Place};

#[test]
fn a_negative_index_is_refused_in_strips_too_unless_it_restarts_them() {
    let header = format!("element vertex 1\n{XYZ}element tristrips 1\n{LIST}");
    let wrong = refused(ascii(&header, "0 0 0\n4 0 0 -2 -3\n"));
    assert_eq!(wrong, (Place::Line(11), "-2 is not the index of a vertex".to_owned()));
}

#[test]
fn surplus_is_noted() {
    let file = read(ascii(&format!("element vertex 1\n{XYZ}"), "1 2 3\n 4 5\n"));
    let surplus = note(&file, NoteKind::SurplusData);
    assert_eq!((surplus.count, surplus.first.clone()), (3, Place::Line(9)));
    let (whole, _) = written(&file.mesh, Format::Ply, Encoding::BigEndian);
    assert_eq!(read(&whole).notes, []);
    let file = read([&whole[..], &[0; 5]].concat());
    let surplus = note(&file, NoteKind::SurplusData);
    assert_eq!((surplus.count, surplus.first.clone()), (5, Place::Byte(whole.len() as u64)));
}

#[test]
fn a_length_that_is_none_is_refused_with_its_line() {
    let header = format!("element vertex 1\n{XYZ}element face 1\nproperty list int int vertex_indices\n");
    let wrong = refused(ascii(&header, "0 0 0\n-1 0\n"));
    assert_eq!(wrong, (Place::Line(10), "-1 is not the length of a list".to_owned()));
    let header = format!("element vertex 3\n{XYZ}element face 1\n{LIST}");
    let wrong = refused(ascii(&header, "0 0 0\n0 0 0\n0 0 0\n256 0 1\n"));
    assert_eq!(
        wrong,
        (Place::Line(13), "row 1 of 1 of element `face` announces 257 values, its line has 3".to_owned(),)
    );
}

#[test]
fn wrong_values_are_refused_with_their_line() {
    for (index, reason) in [
        ("-1", "-1 is not the index of a vertex"),
        ("3", "vertex 3 does not exist: the file has 3 vertices"),
        ("2147483648", "2147483648 is not a number of type `int`"),
        ("x", "`x` where a whole number belongs"),
        ("", "row 1 of 1 of element `face` announces 4 values, its line has 3"),
    ] {
        let text = ascii(
            &format!("element vertex 3\n{XYZ}element face 1\n{LIST}"),
            &format!("0 0 0\n0 0 0\n0 0 0\n3 0 1 {index}\n"),
        );
        let (place, found) = refused(text);
        assert_eq!(found, reason);
        assert!(matches!(place, Place::Line(13 | 14)), "{place:?}");
    }
}

#[test]
fn wrong_headers_are_refused() {
    let vertex = format!("element vertex 1\n{XYZ}");
    for (header, reason) in [
        (format!("{vertex}element vertex 1\n"), "a second element `vertex`"),
        (format!("{vertex}property float x\n"), "element `vertex` has two properties `x`"),
        ("element vertex -1\n".to_owned(), "`-1` is not a number of elements"),
        (
            "element vertex 99999999999999999999\n".to_owned(),
            "`99999999999999999999` is not a number of elements",
        ),
        ("property float x\n".to_owned(), "a property before the first element"),
        ("element vertex 1\nproperty half x\n".to_owned(), "`half` is not a type"),
        ("format ascii 1.0\n".to_owned(), "a second format"),
        ("nonsense\n".to_owned(), "`nonsense` is not a statement of a header"),
        (
            "element vertex 1\nproperty float x\nproperty float y\n".to_owned(),
            "vertices without a number `z`",
        ),
        (
            format!("{vertex}element face 1\nproperty int a\n"),
            "faces without a list `vertex_indices` or `vertex_index`",
        ),
    ] {
        assert_eq!(refused(ascii(&header, "0 0 0\n0\n")).1, reason);
    }
    assert_eq!(refused("ply\nelement vertex 0\nend_header\n").1, "the header does not say the format");
    assert_eq!(refused("ply\nformat ascii 1.0\n").1, "the header has no end");
}

#[test]
fn counts_beyond_the_bytes_are_refused_before_memory_is_taken() {
    let huge = 2_000_000_000_u64;
    for form in ["ascii", "binary_little_endian", "binary_big_endian"] {
        for elements in [
            format!("element vertex {huge}\n{XYZ}"),
            format!("element vertex 0\n{XYZ}element face {huge}\n{LIST}"),
            format!("element junk {huge}\nproperty uchar a\nelement vertex 0\n{XYZ}"),
        ] {
            let (_, reason) = refused(format!("ply\nformat {form} 1.0\n{elements}end_header\n1 2 3 4 5 6\n"));
            assert!(reason.contains("the file ends early"), "{form}: {reason}");
        }
    }
    let list = format!(
        "ply\nformat binary_big_endian 1.0\nelement vertex 0\n{XYZ}element face 1\nproperty list uint int vertex_indices\nend_header\n"
    );
    let bytes: Vec<u8> = list.bytes().chain([0xff; 8]).collect();
    let expected =
        (Place::Byte(list.len() as u64 + 4), "the file ends early: 4 bytes are left for a list".to_owned());
    assert_eq!(refused(bytes), expected);
}

#[test]
fn cut_files_are_refused_wherever_they_are_cut() {
    let mesh =
        read(triangle("property list uchar int near\n", "property uchar a\n", ["1 2", "0", "2 3 4", "5"]))
            .mesh;
    for &encoding in Format::Ply.encodings() {
        let (bytes, _) = written(&mesh, Format::Ply, encoding);
        // The last byte of a text is a line end, which may be missing.
        let shortest = bytes.len() - usize::from(encoding == Encoding::Ascii);
        for length in 0..shortest {
            let options = meshmend_io::ReadOptions::default().with_format(Format::Ply);
            let result = meshmend_io::read_bytes(&bytes[..length], "cut", &options);
            assert!(result.is_err(), "{encoding}: {length} of {}", bytes.len());
        }
    }
}
