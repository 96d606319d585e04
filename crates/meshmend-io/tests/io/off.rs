//! What the OFF reader and writer promise.

use crate::common::{assert_kept, faces, layer, note, read as read_as, refused as refused_as, written};
use meshmend_core::{Domain, FaceTable, PolygonMesh, Values};
use meshmend_io::{Encoding, Format, LossKind, NoteKind, Place, ReadFile, WriteOptions, encode};

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
    assert_eq!(comments, [&b"first"[..], b"inline", b"between"]);
    assert_kept(&mesh, Format::Off, Encoding::Ascii);
}

#[test]
fn comments_at_the_ends_of_lines_are_kept() {
    for (text, expected) in [
        ("OFF # a\n3 1 0 # b\n0 0 0\n1 0 0 #c\n0 1 0#d\n3 0 1 2 # e", "a|b|c|d|e"),
        ("COFF\n3 1 0\n0 0 0 1 0 0 1 # a\n1 0 0 1 0 0 1\n0 1 0 1 0 0 1 # b # c\n3 0 1 2\n", "a|b # c"),
        ("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0 # red\n3 2 1 0 # none\n", "red|none"),
        ("OFF\n3 1 0\n0 0 0 9 # more\n1 0 0\n0 1 0\n3 0 1 2\n7 # after\n# last\n", "more|after|last"),
        ("NOFF\n3 1 0\n0 0 0 0 0 1 # a\n1 0 0 0 0 1\n0 1 0 0 0 1 #\n3 0 1 2\n", "a|"),
    ] {
        let mesh = read(text).mesh;
        let comments: Vec<&str> =
            mesh.metadata().iter().map(|m| std::str::from_utf8(&m.value).unwrap()).collect();
        assert_eq!(comments.join("|"), expected, "{text}");
        assert_kept(&mesh, Format::Off, Encoding::Ascii);
    }
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
        let has_alpha = mesh.layers().iter().all(|l| l.name() != "color" || l.width() == 4);
        if head != "STCNOFF" && has_alpha {
            assert_kept(&mesh, Format::Off, Encoding::Ascii);
        }
    }
}

#[test]
fn texture_coordinates_are_written_where_they_are_alone() {
    let mesh = read("STNOFF\n1 0 0\n1 2 3 0 0 1 0.5 1\n").mesh;
    let (bytes, losses) = written(&mesh, Format::Off, Encoding::Ascii);
    assert_eq!(bytes, b"NOFF\n1 0 0\n1 2 3 0 0 1\n");
    assert_eq!(losses[0].message, "vertex attribute `texcoord` of 1 vertex");
}

/// Many programs do not read such letters, but the one that wrote them does.
#[test]
fn letters_are_written_again_as_they_were_read() {
    for text in [
        "STNOFF\n1 0 0\n1 2 3 0 0 1 0.5 1\n",
        "STCOFF\n1 0 0\n1 2 3 9 8 7 6 0.5 1\n",
        "CSTOFF\n1 0 0\n1 2 3 9 8 7 6 0.5 1\n",
        "STCNOFF\n1 0 0\n1 2 3 0 0 1 9 8 7 6 0.5 1\n",
        "NCOFF\n1 0 0\n1 2 3 0 0 1 9 8 7 6\n",
        "CNOFF\n1 0 0\n1 2 3 0 0 1 9 8 7 6\n",
    ] {
        let file = read(text);
        let mut bytes = Vec::new();
        let losses = encode(&file.mesh, &WriteOptions::of(Format::Off).as_read(&file), &mut bytes).unwrap();
        assert_eq!((String::from_utf8(bytes).unwrap().as_str(), losses), (text, Vec::new()));
    }
    // Letters for which there are no values any more are left out.
    let file = read("STCNOFF\n1 0 0\n1 2 3 0 0 1 9 8 7 6 0.5 1\n");
    let layers: Vec<_> = file.mesh.layers().iter().filter(|l| l.name() != "color").cloned().collect();
    let mesh = PolygonMesh::new(file.mesh.positions().to_vec(), FaceTable::empty(1)).unwrap();
    let mesh = mesh.with_layers(layers).unwrap();
    let mut bytes = Vec::new();
    encode(&mesh, &WriteOptions::of(Format::Off).as_read(&file), &mut bytes).unwrap();
    assert_eq!(String::from_utf8(bytes).unwrap(), "STNOFF\n1 0 0\n1 2 3 0 0 1 0.5 1\n");
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
        ("hello\n", "`hello` where the word `OFF` belongs"),
        ("OFFset 1 0\n", "`OFFset` where the word `OFF` belongs"),
        ("3x 1 0\n", "`3x` where the word `OFF` belongs"),
        ("4OFF\n1 0 0\n0 0 0 0\n", "`4OFF` is a variant that is not read"),
        ("nOFF\n3 1 0\n", "`nOFF` is a variant that is not read"),
        ("4nOFF\n5 3 1 0\n", "`4nOFF` is a variant that is not read"),
        ("4OFF3 1 0\n", "`4OFF` is a variant that is not read"),
        ("CN4OFF\n3 1 0\n", "`CN4OFF` is a variant that is not read"),
        ("STnOFF\n3 1 0\n", "`STnOFF` is a variant that is not read"),
        ("CCOFF\n1 0 0\n", "`CCOFF` is a variant that is not read"),
        ("OFF BINARY\n", "binary OFF is not read"),
        ("COFF  BINARY # really\n", "binary OFF is not read"),
        ("OFF\n", "the file ends where the number of vertices belongs"),
        ("OFF\n-1 0 0\n", "`-1` where the number of vertices belongs"),
        ("OFF\n1\n", "the file ends where the number of faces belongs"),
        ("OFF\n1 # faces\n", "the file ends where the number of faces belongs"),
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
        ("0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", 6, "-1 is not the index of a vertex"),
        ("0 0 0\n1 0 0\n0 1 0\n3 0 1 4294967297\n", 6, "4294967297 is not the index of a vertex"),
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
    assert_eq!((lines.count, lines.first.clone()), (2, Place::Line(6)));
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
        (LossKind::Layer, 1, "face attribute `group` of 1 face"),
        (LossKind::LooseEdges, 1, "1 loose edge"),
        (LossKind::LoosePoints, 1, "1 loose point"),
        (LossKind::Metadata, 1, "1 statement `mtllib` about the file"),
    ];
    assert_eq!(found, expected);
}

#[test]
fn headers_are_read_as_they_are_written() {
    let body = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    for (head, message) in [
        ("OFF3 1 0\n", "the number of vertices is glued to the word `OFF`"),
        ("OFF3\n1\n0\n", "the number of vertices is glued to the word `OFF`"),
        ("# c\nOFF3 1\n", "the number of vertices is glued to the word `OFF`"),
        ("3 1 0\n", "the word `OFF` is missing"),
        ("\u{feff}3 1\n", "the word `OFF` is missing"),
        ("off\n3 1 0\n", "the word `OFF` is in small letters"),
        ("OFF\n3 # vertices\n1 # faces\n0 # edges\n", ""),
        ("OFF 3\n\n1\n", ""),
        ("OFF\n3 1\n\n# edges\n0\n", ""),
        ("OFF # 9 9 9\n#\n3 1 0\n", ""),
    ] {
        for end in ["\n", "\r\n", "\r"] {
            let file = read(format!("{head}{body}").replace('\n', end));
            assert_eq!(faces(&file.mesh), [[0, 1, 2]], "{head:?} {end:?}");
            assert_eq!(file.mesh.positions()[1], [1.0, 0.0, 0.0], "{head:?} {end:?}");
            let messages: Vec<&str> = file.notes.iter().map(|note| &note.message[..]).collect();
            assert_eq!(messages.concat(), message, "{head:?} {end:?}");
        }
    }
    let glued = read("COFF1 0 0\n0 0 0 1 2 3 4\n");
    assert_eq!(layer(&glued.mesh, "color", Domain::Vertex).width(), 4);
    assert_eq!(note(&glued, NoteKind::OddHeader).first, Place::Line(1));
}

#[test]
fn vertices_and_faces_stand_on_lines_in_any_way_that_comes_out_even() {
    for text in [
        "OFF\n3 1 0 0 0 0 1 0 0 0 1 0 3 0 1 2",
        "OFF 3 1 0 0 0 0 1 0 0 0 1 0 3 0 1 2\n",
        "OFF3 1 0 0 0 0 1 0 0 0 1 0 3 0 1 2\n",
        "OFF 3 1\n0 0 0 1 0 0 0 1 0 3 0 1 2\n",
        "3 1 0 0 0 0 1 0 0 0 1 0 3 0 1 2\n",
        "OFF\n3 1 0\n0 0 0 1 0 0 0 1 0\n3 0 1 2\n",
        "OFF\n3 1 0\n0 0 0 1 0 0\n0 1 0\n3 0 1 2 # last\n",
        "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3\n0 1\n2\n",
        "OFF\n3 1 0\n0\n0\n0\n1\n0\n0 # two\n0\n1\n# between\n0\n3\n0\n1\n2\n",
        "OFF\n3\n1 0 0\n0 0 1 0 0 0 1 0 3\n0 1 2",
    ] {
        for end in ["\n", "\r\n", "\r"] {
            let file = read(text.replace('\n', end));
            assert_eq!(faces(&file.mesh), [[0, 1, 2]], "{text:?}");
            assert_eq!(file.mesh.positions(), [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], "{text:?}");
            assert_eq!(note(&file, NoteKind::WrappedRows).count, 1, "{text:?}");
        }
    }
    // Several faces in a line have no colours; on lines of their own they do.
    let square = "OFF\n4 2 0\n0 0 0 1 0 0 1 1 0 0 1 0\n";
    assert_eq!(faces(&read(format!("{square}3 0 1 2 3 0 2 3\n")).mesh), [[0, 1, 2], [0, 2, 3]]);
    let colored = read(format!("{square}3 0 1 2 255 0 0\n3 0 2 3 0 255 0\n")).mesh;
    assert_eq!(layer(&colored, "color", Domain::Face).width(), 3);
    // Colours of vertices have three or four numbers.
    for (color, width) in [("1 2 3", 3), ("1 2 3 4", 4)] {
        let text = format!("COFF\n3 1 0\n0 0 0 {color} 1 0 0 {color}\n0 1 0 {color} 3 0 1 2\n");
        let mesh = read(text).mesh;
        assert_eq!(layer(&mesh, "color", Domain::Vertex).width(), width);
        assert_eq!(faces(&mesh), [[0, 1, 2]]);
    }
    let all = read("STCNOFF\n1 0 0 1 2 3\n0 0 1\n9 8 7 6\n0.5 1").mesh;
    assert_eq!(layer(&all, "texcoord", Domain::Vertex).values(), &Values::F64(vec![0.5, 1.0]));
    assert_eq!(layer(&all, "color", Domain::Vertex).values(), &Values::U8(vec![9, 8, 7, 6]));
}

/// What does not come out even either way is refused as it is by lines.
#[test]
fn what_does_not_come_out_even_is_refused_with_its_line() {
    for (text, line, reason) in [
        ("OFF\n3 1 0\n0 0 0 1 0 0\n0 1\n3 0 1 2\n", 4, "the line ends where a number belongs"),
        ("OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n", 4, "the line ends where a number belongs"),
        ("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3\n0 1\n", 6, "a face of 3 corners does not fit its line"),
    ] {
        let (place, found) = refused(text);
        assert_eq!((place, found.as_str()), (Place::Line(line), reason), "{text:?}");
    }
}

#[test]
fn colours_are_fractions_in_the_whole_file_if_one_number_has_a_point() {
    let text = "COFF\n3 1 0\n0 0 0 1 0 0 1\n1 0 0 0 1 0 1\n0 1 0 0.5 0 1 1\n3 0 1 2";
    let vertices = |mesh: &PolygonMesh| layer(mesh, "color", Domain::Vertex).values().clone();
    let fractions = Values::F64(vec![1.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 0.5, 0.0, 1.0, 1.0]);
    let mesh = read(format!("{text} 1 1 0\n")).mesh;
    assert_eq!(vertices(&mesh), fractions);
    assert_eq!(layer(&mesh, "color", Domain::Face).values(), &Values::F64(vec![1.0, 1.0, 0.0]));
    assert_kept(&mesh, Format::Off, Encoding::Ascii);
    let mesh = read(format!("{text} 255 1 0\n")).mesh;
    assert_eq!(vertices(&mesh), fractions);
    assert_eq!(layer(&mesh, "color", Domain::Face).values(), &Values::U8(vec![255, 1, 0]));
    assert_kept(&mesh, Format::Off, Encoding::Ascii);
    // The point may stand in a colour of a face.
    let mesh = read(format!("{} 0.25 1 0\n", text.replace("0.5", "1"))).mesh;
    assert!(matches!(vertices(&mesh), Values::F64(_)));
    let mesh = read(format!("{} 17\n", text.replace("0.5", "1"))).mesh;
    assert!(matches!(vertices(&mesh), Values::U8(_)));
    assert_eq!(layer(&mesh, "color_index", Domain::Face).values(), &Values::I32(vec![17]));
    assert_kept(&mesh, Format::Off, Encoding::Ascii);
}

#[test]
fn colours_of_several_widths_are_padded_and_noted() {
    let file = read("COFF\n2 0 0\n0 0 0 1 2 3\n1 0 0 4 5 6 7\n");
    assert_eq!(
        layer(&file.mesh, "color", Domain::Vertex).values(),
        &Values::U8(vec![1, 2, 3, 255, 4, 5, 6, 7])
    );
    assert_eq!(note(&file, NoteKind::MixedWidths).count, 1);
}

/// Some programs read no colours of three numbers.
#[test]
fn colours_of_vertices_are_written_with_four_numbers() {
    for (row, expected) in [
        ("1 2 3", "COFF\n1 0 0\n0 0 0 1 2 3 255\n"),
        ("0.5 0 1", "COFF\n1 0 0\n0 0 0 0.5 0.0 1.0 1.0\n"),
        ("1 2 3 4", "COFF\n1 0 0\n0 0 0 1 2 3 4\n"),
    ] {
        let mesh = read(format!("COFF\n1 0 0\n0 0 0 {row}\n")).mesh;
        let (bytes, losses) = written(&mesh, Format::Off, Encoding::Ascii);
        assert_eq!(String::from_utf8(bytes.clone()).unwrap(), expected);
        let again = read(&bytes).mesh;
        assert_eq!(written(&again, Format::Off, Encoding::Ascii), (bytes, Vec::new()));
        let is_padded = row.split(' ').count() == 3;
        assert_eq!(
            losses.iter().map(|l| l.kind).collect::<Vec<_>>(),
            vec![LossKind::Converted; usize::from(is_padded)]
        );
    }
}

#[test]
fn colours_before_normals_are_told_by_their_values_and_noted() {
    for (rows, color) in [
        ("0 0 0 255 0 0 255 0 0 1\n1 0 0 0 0 0 255 1 0 0\n", vec![255, 0, 0, 255, 0, 0, 0, 255]),
        ("0 0 0 255 0 0 0 0 1\n1 0 0 0 0 0 0.6 -0.8 0\n", vec![255, 0, 0, 0, 0, 0]),
    ] {
        for letters in ["NC", "CN"] {
            let file = read(format!("{letters}OFF\n2 0 0\n{rows}"));
            assert_eq!(layer(&file.mesh, "color", Domain::Vertex).values(), &Values::U8(color.clone()));
            let Values::F64(normals) = layer(&file.mesh, "normal", Domain::Vertex).values() else { panic!() };
            assert_eq!(normals[..3], [0.0, 0.0, 1.0]);
            assert_eq!(note(&file, NoteKind::ColumnOrder).count, 1);
        }
    }
    let usual = read("NCOFF\n1 0 0\n0 0 0 0 0 1 255 0 0 255\n");
    assert_eq!(layer(&usual.mesh, "normal", Domain::Vertex).values(), &Values::F64(vec![0.0, 0.0, 1.0]));
    assert_eq!(usual.notes, []);
    let textured = read("STNCOFF\n1 0 0\n0 0 0 255 0 0 255 0 0 1 0.5 0.25\n");
    assert_eq!(layer(&textured.mesh, "texcoord", Domain::Vertex).values(), &Values::F64(vec![0.5, 0.25]));
    assert_eq!(layer(&textured.mesh, "color", Domain::Vertex).width(), 4);
}
