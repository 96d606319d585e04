//! What the OFF reader and writer promise.

use crate::common::{assert_kept, faces, layer, note, read as read_as, refused as refused_as, written};
use meshmend_core::{Domain, FaceTable, PolygonMesh, Values};
use meshmend_io::{Encoding, Format, LossKind, NoteKind, Place, ReadFile};

fn read(text: impl AsRef<[u8]>) -> ReadFile {
    read_as(Format::Off, text)
}

fn refused(text: impl AsRef<[u8]>) -> (Place, String) {
    refused_as(Format::Off, text)
}

#[test]
fn counts_comments_blank_lines_and_line_ends_are_read_anywhere() {
    let body = "0 0 0\n1 0 0 # inline\n\n0 1 0\n# between\n3 0 1 2\n2 0 1\n0\n";
    for head in ["OFF\n3 3 0\n", "OFF 3 3 0\n", "OFF 3 3\n", "# first\n\n  OFF # c\n # d\n3 3 9 # e\n"] {
        for end in ["\n", "\r\n", "\r"] {
            let file = read(format!("{head}{body}").replace('\n', end));
            assert_eq!(faces(&file.mesh), [&[0, 1, 2][..], &[0, 1], &[]], "{head:?} {end:?}");
            assert_eq!((file.variant, file.notes.len()), ("off", 0));
        }
    }
    let mesh = read(format!("# first\nOFF\n3 3 0\n{body}")).mesh;
    let comments: Vec<&[u8]> = mesh.metadata().iter().map(|m| &m.value[..]).collect();
    assert_eq!(comments, [&b"first"[..], b"between"]);
    assert_kept(&mesh, Format::Off, Encoding::Ascii);
}

#[test]
fn the_header_says_what_vertices_have() {
    for (head, row, layers) in [
        ("OFF", "", &[][..]),
        ("NOFF", "0 0 1", &[("normal", 3)]),
        ("COFF", "10 20 30 255", &[("color", 4)]),
        ("COFF", "0.5 0.25 1.0", &[("color", 3)]),
        ("CNOFF", "0 0 1 10 20 30", &[("normal", 3), ("color", 3)]),
        ("NCOFF", "0 0 1 10 20 30", &[("normal", 3), ("color", 3)]),
        ("STOFF", "0.5 1", &[("texcoord", 2)]),
        ("STCNOFF", "0 0 1 10 20 30 255 0.5 1", &[("normal", 3), ("texcoord", 2), ("color", 4)]),
    ] {
        let mesh = read(format!("{head}\n2 0 0\n1 2 3 {row}\n4 5 6 {row}\n")).mesh;
        let found: Vec<(&str, usize)> = mesh.layers().iter().map(|l| (l.name(), l.width())).collect();
        assert_eq!(found, layers, "{head}");
        assert_eq!(mesh.positions(), [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]);
        if head != "STCNOFF" {
            assert_kept(&mesh, Format::Off, Encoding::Ascii);
        }
    }
}

#[test]
fn texture_coordinates_are_written_where_they_are_alone() {
    let mesh = read("STNOFF\n1 0 0\n1 2 3 0 0 1 0.5 1\n").mesh;
    let (bytes, losses) = written(&mesh, Format::Off, Encoding::Ascii);
    assert_eq!(bytes, b"NOFF\n1 0 0\n1 2 3 0 0 1\n");
    assert_eq!(losses[0].message, "vertex attribute `texcoord` of 1 vertices");
}

#[test]
fn colours_of_faces_are_kept_as_they_are_spelled() {
    let with = |colors: [&str; 3]| {
        let [a, b, c] = colors;
        read(format!("OFF\n3 3 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 {a}\n3 2 1 0 {b} # c\n3 0 0 1 {c}\n")).mesh
    };
    let bytes = with(["255 0 0", "0 255 0", "1 2 3"]);
    assert_eq!(
        layer(&bytes, "color", Domain::Face).values(),
        &Values::U8(vec![255, 0, 0, 0, 255, 0, 1, 2, 3])
    );
    let fractions = with(["1.0 0.5 0.0 1.0", "", "0. 0. 0. 1."]);
    let color = layer(&fractions, "color", Domain::Face);
    assert_eq!((color.width(), color.value_of(1)), (4, None));
    let mixed = with(["255 0 0", "17", "0.5 0.5 0.5 1"]);
    let texts = ["255 0 0", "17", "0.5 0.5 0.5 1"].map(|text| text.as_bytes().to_vec());
    assert_eq!(layer(&mixed, "color", Domain::Face).values(), &Values::Text(texts.to_vec()));
    for mesh in [bytes, fractions, mixed] {
        assert_kept(&mesh, Format::Off, Encoding::Ascii);
    }
}

#[test]
fn other_headers_are_refused() {
    for (text, reason) in [
        ("", "the file ends where the word `OFF` belongs"),
        ("3 1 0\n", "`3` where the word `OFF` belongs"),
        ("4OFF\n1 0 0\n0 0 0 0\n", "`4OFF` is a variant that is not read"),
        ("nOFF\n3 1 0\n", "`nOFF` is a variant that is not read"),
        ("CCOFF\n1 0 0\n", "`CCOFF` is a variant that is not read"),
        ("OFF BINARY\n", "binary OFF is not read"),
        ("OFF\n", "the file ends where a line of counts belongs"),
        ("OFF\n-1 0 0\n", "`-1` where the number of vertices belongs"),
        ("OFF\n1\n", "the line ends where the number of faces belongs"),
    ] {
        assert_eq!(refused(text).1, reason, "{text}");
    }
}

#[test]
fn counts_beyond_the_content_are_refused_before_memory_is_taken() {
    let body = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    for counts in ["4000000000 1", "3 4000000000", "18446744073709551615 18446744073709551615", "30 30"] {
        let (place, reason) = refused(format!("OFF\n{counts} 0\n{body}"));
        assert_eq!(place, Place::Line(2));
        assert!(reason.contains("are announced"), "{reason}");
    }
    assert_eq!(refused(format!("OFF\n3 2 0\n{body}")).1, "the file ends where a face belongs");
}

#[test]
fn wrong_rows_are_refused_with_their_line() {
    for (rows, line, reason) in [
        ("0 0\n1 0 0\n0 1 0\n3 0 1 2\n", 3, "the line ends where a number belongs"),
        ("0 0 0\n1 x 0\n0 1 0\n3 0 1 2\n", 4, "`x` where a number belongs"),
        ("0 0 0\n1 0,5 0\n0 1 0\n3 0 1 2\n", 4, "`0,5` where a number belongs"),
        ("0 0 0\n1 0 0\n0 1 0\n3 0 1\n", 6, "a face of 3 corners does not fit its line"),
        ("0 0 0\n1 0 0\n0 1 0\n3 0 1 # two\n", 6, "the line ends where the index of a vertex belongs"),
        ("0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", 6, "vertex 3 does not exist: the file has 3 vertices"),
        ("0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", 6, "-1 is no index of a vertex"),
        ("0 0 0\n1 0 0\n0 1 0\n3 0 1 4294967297\n", 6, "4294967297 is no index of a vertex"),
        ("0 0 0\n1 0 0\n0 1 0\n3 0 1 2.5\n", 6, "`2.5` where the index of a vertex belongs"),
        ("0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n", 6, "a face of 4000000000 corners does not fit its line"),
    ] {
        assert_eq!(refused(format!("OFF\n3 1 0\n{rows}")), (Place::Line(line), reason.to_owned()));
    }
    assert_eq!(refused("NOFF\n1 0 0\n0 0 0 1 0\n").1, "the line ends where a number belongs");
}

#[test]
fn surplus_is_noted() {
    let file = read("OFF\n2 1 0\n0 0 0 7\n1 0 0\n2 0 1\n3 0 0 1\nend\n");
    let lines = note(&file, NoteKind::SurplusData);
    assert_eq!((lines.count, lines.first), (2, Place::Line(6)));
    assert_eq!(note(&file, NoteKind::SurplusColumns).first, Place::Line(3));
}

#[test]
fn every_bit_of_a_position_is_kept() {
    let positions = vec![[0.1, -0.0, 1e-320], [1e308, f64::INFINITY, 1.0 / 3.0]];
    let mesh = PolygonMesh::new(positions, FaceTable::empty(2)).unwrap();
    let (bytes, _) = written(&mesh, Format::Off, Encoding::Ascii);
    let bits =
        |mesh: &PolygonMesh| mesh.positions().iter().flatten().map(|x| x.to_bits()).collect::<Vec<_>>();
    assert_eq!(bits(&read(bytes).mesh), bits(&mesh));
}

#[test]
fn what_off_can_not_carry_is_named() {
    let text = "mtllib m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\ng a\nf 1//1 2//1 3\nl 1 2\np 3\n";
    let (_, losses) = written(&read_as(Format::Obj, text).mesh, Format::Off, Encoding::Ascii);
    let found: Vec<(LossKind, u64, &str)> =
        losses.iter().map(|l| (l.kind, l.count, &l.message[..])).collect();
    let expected = [
        (LossKind::Layer, 2, "corner attribute `normal` of 2 corners"),
        (LossKind::Layer, 1, "face attribute `group` of 1 faces"),
        (LossKind::LooseEdges, 1, "1 loose edges"),
        (LossKind::LoosePoints, 1, "1 loose points"),
        (LossKind::Metadata, 1, "1 statements `mtllib` about the file"),
    ];
    assert_eq!(found, expected);
}
