//! What an OBJ file says beside its faces is there again when it is written: names, lines, points, comments.

use crate::common::{assert_kept, layer, names, note, read as read_as, written};
use meshmend_core::{Carry, Domain, Layer, PolygonMesh, Values, VertexId};
use meshmend_io::{Encoding, Format, Limits, NoteKind, Place, ReadFile};

fn read(text: impl AsRef<[u8]>) -> ReadFile {
    read_as(Format::Obj, text)
}

fn text_of(mesh: &PolygonMesh) -> String {
    String::from_utf8(written(mesh, Format::Obj, Encoding::Ascii).0).unwrap()
}

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

/// Files that are written as they were read, to the byte.
#[test]
fn what_is_in_the_order_of_the_writer_comes_back_to_the_byte() {
    let cases = [
        // Two objects of one name, one after the other, are two; so are groups and materials.
        "o A\nusemtl x\nf 1 2 3\no A\nusemtl x\nf 3 2 1\no B\nusemtl y\nl 1 2\n",
        "g a b\nf 1 2 3\ng a b\nf 3 2 1\ng a b\nf 1 3 2\n",
        "s 1\nf 1 2 3\ns 1\nf 3 2 1\ns off\nf 1 3 2\n",
        // Names that hold for lines and points alone, and names that end before them.
        "o A\nf 1 2 3\no B\nusemtl y\nl 1 2\n",
        "o A\nf 1 2 3\no A\nl 1 2\no A\np 1\n",
        "o A\nf 1 2 3\nl 1 2\np 3\n",
        "g a\nf 1 2 3\ng\nl 1 2\ng a\np 3\n",
        // Lines of several edges, closed ones, ones that meet, and points.
        "l 1 2 3\nl 3 1\nl 1 2 3 1\np 1\np 2\n",
        "l 1 2\nl 2 3\n",
        "l 1 1 2 2\n",
        // Comments anywhere.
        "# one\nf 1 2 3\n# two\n# three\no A\nf 3 2 1\n# four\nl 1 2 3\n# five\np 1\n# six\n",
    ];
    for case in cases {
        let text = format!("{TRIANGLE}{case}");
        let file = read(&text);
        assert_eq!((text_of(&file.mesh), &file.notes[..]), (text, &[][..]));
        assert_kept(&file.mesh, Format::Obj, Encoding::Ascii);
    }
    let whole = "# top\n#\nmtllib a.mtl my b.mtl\n# above\nv 0 0 0\n# second vertex\nv 1 0 0\nv 0 1 0\n# coordinates\nvt 0 0\n\
                 # again\nvt 0 1\n# normals\nvn 0 0 1\no A\n";
    let with_faces =
        format!("{}f 1/1/1 2/2/1 3/1/1\nl 1/1 2/2 3/1\np 3/2\n", whole.replace("o A\n", "# faces\no A\n"));
    assert_eq!(text_of(&read(&with_faces).mesh), with_faces);
}

#[test]
fn texture_coordinates_of_lines_and_points_are_those_of_the_file() {
    let file = read(format!("{TRIANGLE}vt 0 0\nvt 0.5 0\nf 1/2 2/2 3/2\nl 1/1 2/2 3\nl 1 2\np 1/2 2\n"));
    let uses = |name, domain, count| -> Vec<Option<usize>> {
        let layer = layer(&file.mesh, name, domain);
        (0..count).map(|element| layer.value_of(element)).collect()
    };
    assert_eq!(uses("texcoord", Domain::LooseEdge, 3), [Some(0), Some(1), None]);
    assert_eq!(uses("texcoord_end", Domain::LooseEdge, 3), [Some(1), None, None]);
    assert_eq!(uses("texcoord", Domain::LoosePoint, 2), [Some(1), None]);
    assert_kept(&file.mesh, Format::Obj, Encoding::Ascii);
    // Without a face that has any.
    assert_kept(&read(format!("{TRIANGLE}vt 0 0\nl 1/1 2/1\n")).mesh, Format::Obj, Encoding::Ascii);
}

#[test]
fn texture_coordinates_of_lines_alone_are_written_after_those_of_corners() {
    let layer = |domain, values: Vec<f64>, count: usize| {
        Layer::indexed("texcoord", domain, 1, Carry::Copy, Values::F64(values), vec![0; count])
    };
    let mesh = read(format!("{TRIANGLE}f 1 2 3\nl 1 2\n")).mesh;
    let layers = vec![layer(Domain::Corner, vec![0.25, 0.75], 3), layer(Domain::LooseEdge, vec![0.5], 1)];
    let text = text_of(&mesh.with_layers(layers).unwrap());
    assert_eq!(text, format!("{TRIANGLE}vt 0.25\nvt 0.75\nvt 0.5\nf 1/1 2/1 3/1\nl 1/3 2\n"));
}

/// Lines are written after all faces, so names are stated again.
#[test]
fn names_of_lines_between_faces_are_stated_for_them_again() {
    let file = read(format!("{TRIANGLE}g a\nl 1 2\nf 1 2 3\ng b\nf 3 2 1\nl 2 3\ng c\nl 3 1\ng b\np 1\n"));
    let expected =
        format!("{TRIANGLE}g a\nf 1 2 3\ng b\nf 3 2 1\ng a\nl 1 2\ng b\nl 2 3\ng c\nl 3 1\ng b\np 1\n");
    assert_eq!(text_of(&file.mesh), expected);
    assert_kept(&file.mesh, Format::Obj, Encoding::Ascii);
}

#[test]
fn names_that_no_element_has_are_noted_where_the_first_stands() {
    let cases = [
        ("o A\nf 1 2 3\no B\n", 1, 6),
        ("o A\no B\nf 1 2 3\no C\no D\n", 3, 4),
        ("f 1 2 3\nusemtl x\nusemtl x\n", 2, 5),
        ("g a\n", 1, 4),
    ];
    for (text, count, line) in cases {
        let file = read(format!("{TRIANGLE}{text}"));
        let unused = note(&file, NoteKind::UnusedName);
        assert_eq!((unused.count, unused.first.clone()), (count, Place::Line(line)), "{text}");
    }
    let file = read(format!("{TRIANGLE}o A\nf 1 2 3\no B\nl 1 2\no\ns off\n"));
    assert_eq!(file.notes, []);
    assert_eq!(names(layer(&file.mesh, "object", Domain::LooseEdge)), [Some("B".to_owned())]);
}

#[test]
fn lines_that_are_none_are_noted() {
    let file = read(format!("{TRIANGLE}l 1\nl\nl 1 2\n"));
    let skipped = note(&file, NoteKind::SkippedElement);
    assert_eq!((skipped.count, skipped.first.clone()), (2, Place::Line(4)));
    assert_eq!(file.mesh.loose_edges(), [[VertexId(0), VertexId(1)]]);
}

#[test]
fn comments_behind_statements_are_kept_before_the_next_element() {
    let file = read("v 0 0 0 # a\nv 1 0 0\nv 0 1 0\no A # b\nmtllib m.mtl # c\nf 1 2 3#d\nf 3 2 1\n");
    let comments: Vec<(&str, &[u8])> =
        file.mesh.metadata().iter().map(|m| (&m.key[..], &m.value[..])).collect();
    let expected: [(&str, &[u8]); 5] = [
        ("comment@v2", b"a"),
        ("comment@f1", b"b"),
        ("mtllib", b"m.mtl"),
        ("comment@f1", b"c"),
        ("comment@f2", b"d"),
    ];
    assert_eq!(comments, expected);
    let (one, two) = (text_of(&file.mesh), text_of(&read(text_of(&file.mesh)).mesh));
    assert_eq!(one, two);
}

#[test]
fn comments_of_a_file_in_sections_stay_with_their_sections() {
    let text = "# A\nv 0 0 0\nv 1 0 0\nv 0 1 0\n# 3 vertices\no A\nf 1 2 3\n# 1 face\n# B\nv 0 0 1\n# 1 vertex\no B\n\
                f 1 2 4\n# end\n";
    let file = read(text);
    let written = text_of(&file.mesh);
    let expected = "# A\nv 0 0 0\nv 1 0 0\nv 0 1 0\n# 1 face\n# B\nv 0 0 1\n# 3 vertices\no A\nf 1 2 3\n\
                    # 1 vertex\no B\nf 1 2 4\n# end\n";
    assert_eq!(written, expected);
    assert_eq!(text_of(&read(&written).mesh), written);
}

#[test]
fn comments_between_elements_are_comments_in_other_formats() {
    let mesh = read(format!("# a\n{TRIANGLE}# b\nf 1 2 3\n# c\n")).mesh;
    for format in [Format::Ply, Format::Off] {
        let (bytes, losses) = written(&mesh, format, Encoding::Ascii);
        let text = String::from_utf8(bytes).unwrap();
        assert_eq!(losses, [], "{format}");
        for comment in [" a\n", " b\n", " c\n"] {
            assert!(text.contains(comment), "{format}: {text}");
        }
    }
}

#[test]
fn many_comments_and_names_in_a_row_are_looked_at_once() {
    let rows: String = (0..200_000).map(|i| format!("# {i}\ng {i}\n")).collect();
    let file = read(format!("{TRIANGLE}{rows}f 1 2 3\n"));
    assert_eq!(file.mesh.metadata().len(), Limits::default().max_comments);
    assert_eq!(note(&file, NoteKind::SkippedComment).count, 190_000);
}
