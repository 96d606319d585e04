//! What the OBJ reader and writer promise.

use crate::common::{
    assert_kept, faces, layer, names, note, read as read_as, refused as refused_as, written,
};
use meshmend_core::{Carry, Domain, FaceTable, Layer, Metadata, PolygonMesh, Values, VertexId};
use meshmend_io::{
    Encoding, Format, Limits, LossKind, NoteKind, Place, ReadErrorKind, ReadFile, ReadOptions, read_bytes,
};

fn read(text: impl AsRef<[u8]>) -> ReadFile {
    read_as(Format::Obj, text)
}

fn refused(text: impl AsRef<[u8]>) -> (Place, String) {
    refused_as(Format::Obj, text)
}

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

#[test]
fn faces_of_any_size_are_kept_even_degenerate_ones() {
    let file = read("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf 1 2 3\nf 1 2\nf 3\nf\nf 1 1 1\n");
    let expected: [&[u32]; 6] = [&[0, 1, 2, 3], &[0, 1, 2], &[0, 1], &[2], &[], &[0, 0, 0]];
    assert_eq!(faces(&file.mesh), expected);
    assert_eq!((file.format, file.variant), (Format::Obj, "obj"));
    assert_kept(&file.mesh, Format::Obj, Encoding::Ascii);
}

#[test]
fn negative_indices_count_back_and_forward_references_are_looked_up_later() {
    let file = read("f 1 2 3\nv 0 0 0\nv 1 0 0\nf -1 -2 4\nv 0 1 0\nv 0 0 1\n");
    assert_eq!(faces(&file.mesh), [[0, 1, 2], [1, 0, 3]]);
}

#[test]
fn every_line_end_continuation_and_a_byte_order_mark_are_read() {
    let lines = ["v 0 0 0", "v 1 0 0", "v 0 1 0", "f 1 2 3"];
    for end in ["\n", "\r\n", "\r"] {
        assert_eq!(faces(&read(lines.join(end)).mesh), [[0, 1, 2]], "{end:?}");
        let continued =
            format!("\u{feff}v 0 0 \\{end}0{end}v 1 0 0{end}v 0 1 0{end}f 1 \\{end} 2 \\{end}3{end}");
        assert_eq!(faces(&read(continued).mesh), [[0, 1, 2]], "{end:?}");
    }
}

#[test]
fn lines_and_points_become_loose_elements() {
    let file = read(format!("{TRIANGLE}l 1 2 3\nl 1/1 3/2\np 2 -1\n"));
    let edges: Vec<[u32; 2]> = file.mesh.loose_edges().iter().map(|ends| ends.map(|v| v.0)).collect();
    assert_eq!(edges, [[0, 1], [1, 2], [0, 2]]);
    assert_eq!(file.mesh.loose_points(), [VertexId(1), VertexId(2)]);
    assert_eq!(note(&file, NoteKind::AttributeOutOfRange).count, 2);
    assert_kept(&file.mesh, Format::Obj, Encoding::Ascii);
}

#[test]
fn colours_and_weights_become_vertex_layers() {
    let mesh = read("v 0 0 0 1\nv 1 0 0 2.5\nv 0 1 0\n").mesh;
    assert_eq!(layer(&mesh, "weight", Domain::Vertex).values(), &Values::F64(vec![1.0, 2.5, 1.0]));
    assert_kept(&mesh, Format::Obj, Encoding::Ascii);
    assert_eq!(read("v 0 0 0 1\nv 1 1 1 1\n").mesh.layers(), []);

    let mesh = read("v 0 0 0\nv 1 0 0 0.25 0.5 1\nv 0 1 0 1 0 0\n").mesh;
    let color = layer(&mesh, "color", Domain::Vertex);
    assert_eq!((color.width(), color.carry()), (3, Carry::Interpolate));
    assert_eq!(color.values(), &Values::F64(vec![0.25, 0.5, 1.0, 1.0, 0.0, 0.0]));
    assert_eq!([0, 1, 2].map(|v| color.value_of(v)), [None, Some(0), Some(1)]);
    assert_kept(&mesh, Format::Obj, Encoding::Ascii);
    let mesh = read("v 0 0 0 1 1 1 0.5\n").mesh;
    assert_eq!(layer(&mesh, "color", Domain::Vertex).width(), 4);
}

#[test]
fn texture_coordinates_and_normals_are_pools_that_corners_use() {
    let text = format!("{TRIANGLE}vt 0 0\nvt 0.5 1\nvn 0 0 1\nf 1/2/1 2//1 3/1\nf 3 2 1\nf 1/-1 2/ 3//\n");
    let mesh = read(text).mesh;
    let texcoord = layer(&mesh, "texcoord", Domain::Corner);
    assert_eq!((texcoord.width(), texcoord.values()), (2, &Values::F64(vec![0.0, 0.0, 0.5, 1.0])));
    let uses: Vec<Option<usize>> = (0..9).map(|corner| texcoord.value_of(corner)).collect();
    assert_eq!(uses, [Some(1), None, Some(0), None, None, None, Some(1), None, None]);
    let normal = layer(&mesh, "normal", Domain::Corner);
    assert_eq!([0, 1, 2, 3].map(|corner| normal.value_of(corner)), [Some(0), Some(0), None, None]);
    assert_kept(&mesh, Format::Obj, Encoding::Ascii);
}

#[test]
fn texture_coordinates_have_one_to_three_numbers() {
    for (width, text) in [(1, "vt 0.5"), (2, "vt 0.5 1"), (3, "vt 0.5 1 2")] {
        let mesh = read(format!("{TRIANGLE}{text}\nf 1/1 2/1 3/1\n")).mesh;
        assert_eq!(layer(&mesh, "texcoord", Domain::Corner).width(), width);
        assert_kept(&mesh, Format::Obj, Encoding::Ascii);
    }
    let file = read(format!("{TRIANGLE}vt 1\nvt 2 3 4\nvt 5 6\n"));
    let padded = Values::F64(vec![1.0, 0.0, 0.0, 2.0, 3.0, 4.0, 5.0, 6.0, 0.0]);
    assert_eq!(layer(&file.mesh, "texcoord", Domain::Corner).values(), &padded);
    assert_eq!(note(&file, NoteKind::MixedWidths).count, 2);
}

#[test]
fn a_texture_or_normal_index_that_does_not_exist_is_noted_and_the_face_is_whole() {
    let file = read(format!("{TRIANGLE}vt 0 0\nf 1/1/1 2/2 3/0\nf 1/-2 2/99999999999999999999 3\n"));
    assert_eq!(faces(&file.mesh).len(), 2);
    let out_of_range = note(&file, NoteKind::AttributeOutOfRange);
    assert_eq!((out_of_range.count, out_of_range.first.clone()), (5, Place::Line(5)));
    let texcoord = layer(&file.mesh, "texcoord", Domain::Corner);
    let uses: Vec<Option<usize>> = (0..6).map(|corner| texcoord.value_of(corner)).collect();
    assert_eq!(uses, [Some(0), None, None, None, None, None]);
}

#[test]
fn names_hold_until_the_next_and_no_name_is_no_value() {
    let text = "mtllib a b.mtl\no body # the\ng a b\nusemtl red\ns 1\nf 1 2 3\ng a\ns off\nf 1 2 3\ng\nusemtl red\nf 1 2 3\n";
    let file = read(format!("{TRIANGLE}f 3 2 1\n{text}o unused\n"));
    let of = |name| names(layer(&file.mesh, name, Domain::Face));
    let list = |names: [&str; 4]| names.map(|name| (name != "-").then(|| name.to_owned())).to_vec();
    assert_eq!(of("object"), list(["-", "body", "body", "body"]));
    assert_eq!(of("group"), list(["-", "a b", "a", "-"]));
    assert_eq!(of("material"), list(["-", "red", "red", "red"]));
    assert_eq!(of("smoothing"), list(["-", "1", "-", "-"]));
    // The second `usemtl red` is a statement of its own, and no element follows `o unused`.
    assert_eq!(layer(&file.mesh, "material", Domain::Face).value_count(), 2);
    assert_eq!(note(&file, NoteKind::UnusedName).first, Place::Line(17));
    let statement = |key: &str, value: &[u8]| Metadata { key: key.to_owned(), value: value.to_vec() };
    let expected = [statement("mtllib", b"a b.mtl"), statement("comment@f2", b"the")];
    assert_eq!(file.mesh.metadata(), expected);
    assert_kept(&file.mesh, Format::Obj, Encoding::Ascii);
}

#[test]
fn a_comment_behind_a_name_begins_after_a_blank() {
    let named = |statement: &str| {
        let mesh = read(format!("{TRIANGLE}{statement}\nf 1 2 3\n")).mesh;
        mesh.layer("object", Domain::Face).map(|layer| names(layer)[0].clone().unwrap_or_default())
    };
    assert_eq!(named("o a#b #c").as_deref(), Some("a#b"));
    assert_eq!(named("o a\t#b").as_deref(), Some("a"));
    assert_eq!(named("o #a"), None);
    assert_eq!(named("o#a"), None);
}

/// Blanks at the end of a line are not kept by every editor.
#[test]
fn a_statement_without_a_name_is_one_word() {
    let text = format!("{TRIANGLE}g a\ns 1\nf 1 2 3\ng\ns off\nf 1 2 3\n");
    assert_eq!(written(&read(&text).mesh, Format::Obj, Encoding::Ascii).0, text.as_bytes());
}

#[test]
fn a_name_that_no_face_has_is_noted() {
    let file = read(format!("{TRIANGLE}g one\ng two\nf 1 2 3\n"));
    assert_eq!(note(&file, NoteKind::UnusedName).count, 1);
    assert_eq!(names(layer(&file.mesh, "group", Domain::Face)), [Some("two".to_owned())]);
}

#[test]
fn names_and_comments_may_be_any_bytes() {
    let mesh = read(b"# caf\xe9\n#\n#  two\nv 0 0 0\no \xff\xfe\nf 1 1 1\n").mesh;
    let comments: Vec<&[u8]> = mesh.metadata().iter().map(|m| &m.value[..]).collect();
    assert_eq!(comments, [&b"caf\xe9"[..], b"", b" two"]);
    assert_eq!(layer(&mesh, "object", Domain::Face).values(), &Values::Text(vec![b"\xff\xfe".to_vec()]));
    assert_kept(&mesh, Format::Obj, Encoding::Ascii);
}

#[test]
fn names_that_can_not_be_spelled_are_named_as_losses() {
    let mesh = read(format!("{TRIANGLE}{}", "f 1 2 3\n".repeat(7))).mesh;
    let pool =
        [&b"fine"[..], b"line\nend", b"a #b", b" a", b"a ", b"#a", b"a\\"].map(<[u8]>::to_vec).to_vec();
    let layers = vec![Layer::direct("object", Domain::Face, 1, Carry::Copy, Values::Text(pool))];
    let mesh = mesh.with_layers(layers).unwrap();
    let (bytes, losses) = written(&mesh, Format::Obj, Encoding::Ascii);
    assert_eq!(losses.iter().map(|l| (l.kind, l.count)).collect::<Vec<_>>(), [(LossKind::Names, 6)]);
    let again = names(layer(&read(bytes).mesh, "object", Domain::Face));
    let expected = ["fine", "line_end", "a__b", "_a", "a_", "_a", "a_"];
    assert_eq!(again, expected.map(|name| Some(name.to_owned())));
}

#[test]
fn comments_that_one_line_can_not_spell_are_named_as_losses() {
    let mesh = read(b"#a\0b\nv 0 0 0\nf 1 1 1\n").mesh;
    for format in [Format::Obj, Format::Off] {
        let losses = written(&mesh, format, Encoding::Ascii).1;
        assert_eq!(losses.iter().map(|l| (l.kind, l.count)).collect::<Vec<_>>(), [(LossKind::Names, 1)]);
    }
}

#[test]
fn a_missing_weight_is_named_as_a_loss() {
    let mesh = read(format!("{TRIANGLE}f 1 2 3\n")).mesh;
    let uses = vec![0, meshmend_core::NO_VALUE, 0];
    let layer = Layer::indexed("weight", Domain::Vertex, 1, Carry::Copy, Values::F64(vec![2.0]), uses);
    let mesh = mesh.with_layers(vec![layer]).unwrap();
    let losses = written(&mesh, Format::Obj, Encoding::Ascii).1;
    assert_eq!(losses.iter().map(|l| (l.kind, l.count)).collect::<Vec<_>>(), [(LossKind::AbsentValue, 1)]);
}

#[test]
fn values_that_no_corner_uses_are_named_as_losses() {
    let mesh = read(format!("{TRIANGLE}vn 0 0 1\nvn 0 1 0\n")).mesh;
    assert!(written(&mesh, Format::Obj, Encoding::Ascii).1.is_empty());
    let losses = written(&mesh, Format::Ply, Encoding::Ascii).1;
    assert_eq!(losses.iter().map(|l| (l.kind, l.count)).collect::<Vec<_>>(), [(LossKind::Layer, 2)]);
}

#[test]
fn unknown_statements_are_skipped_and_counted() {
    let file = read(format!("{TRIANGLE}curv 1 2\ncsh touch x\ncsh touch y\nf 1 2 3\n"));
    let skipped: Vec<(u64, Place)> = file.notes.iter().map(|note| (note.count, note.first.clone())).collect();
    assert_eq!(skipped, [(2, Place::Line(5)), (1, Place::Line(4))]);
    assert!(file.notes[0].to_string().contains("`csh`"), "{}", file.notes[0]);
}

#[test]
fn many_different_unknown_statements_make_few_notes() {
    let text: String = (0..10_000).map(|i| format!("x{i} 1\n")).collect();
    let file = read(format!("{TRIANGLE}{text}"));
    assert_eq!(file.notes.len(), 17);
    assert_eq!(file.notes.iter().map(|note| note.count).sum::<u64>(), 10_000);
}

#[test]
fn wrong_vertex_indices_are_refused_with_their_line() {
    for (index, reason) in [
        ("0", "vertex index 0: the first vertex is 1"),
        ("-0", "vertex index 0: the first vertex is 1"),
        ("4", "vertex 4 does not exist: the file has 3 vertices"),
        ("-4", "vertex -4 does not exist: the file has 3 vertices"),
        ("4294967297", "vertex 4294967297 does not exist: the file has 3 vertices"),
        ("18446744073709551617", "a vertex index beyond 64 bits"),
        ("1.0", "`.0` after a corner"),
        ("x", "`x` where a vertex index belongs"),
        ("/1", "`/1` where a vertex index belongs"),
        ("1/2/3/4", "`/4` after a corner"),
    ] {
        let expected = (Place::Line(4), reason.to_owned());
        assert_eq!(refused(format!("{TRIANGLE}f 1 2 {index}\n")), expected);
    }
}

#[test]
fn of_several_wrong_vertex_indices_the_highest_is_named_where_it_stands_first() {
    let place = refused(format!("{TRIANGLE}f 1 2 8\nf 1 2 9\nf 1 2 9\nf 1 2 8\n")).0;
    assert_eq!(place, Place::Line(5));
}

#[test]
fn numbers_beyond_those_that_are_understood_are_noted() {
    let file = read("v 0 0 0 1 1\nv 1 0 0\nv 0 1 0\nvt 0.5 0.25 0.125 9\nvn 0 0 1 9\nf 1/1/1 2/1/1 3/1/1\n");
    let places: Vec<(Place, &str)> =
        file.notes.iter().map(|note| (note.first.clone(), &note.message[..])).collect();
    assert_eq!(
        places,
        [
            (Place::Line(5), "normals with more than three numbers"),
            (Place::Line(4), "texture coordinates with more than three numbers"),
            (Place::Line(1), "vertices with more numbers than are understood"),
        ]
    );
    assert_eq!(file.mesh.position(VertexId(0)), [0.0; 3]);
    let texcoords = layer(&file.mesh, "texcoord", Domain::Corner).values().clone();
    assert_eq!(texcoords, Values::F64(vec![0.5, 0.25, 0.125]));
}

#[test]
fn wrong_coordinates_are_refused_with_their_line() {
    for (text, reason) in [
        ("v 0 0\n", "a vertex with fewer than three coordinates"),
        ("v 0 0 x\n", "`x` where a number belongs"),
        ("v 0,5 0 0\n", "`0,5` where a number belongs"),
        ("v 0 0 0x1\n", "`0x1` where a number belongs"),
        ("v 0 0 0\0\n", "`0\u{fffd}` where a number belongs"),
        ("o a\0b\n", "a NUL byte in a statement"),
        ("vt x\n", "`x` where a number belongs"),
        ("vn 0 0\n", "a normal with fewer than three numbers"),
    ] {
        assert_eq!(refused(format!("# first line\n{text}")), (Place::Line(2), reason.to_owned()));
    }
}

#[test]
fn coordinates_beyond_all_numbers_are_read_and_noted() {
    let file = read("v nan inf -1e400\nv 1 2 3\n");
    let [x, y, z] = file.mesh.positions()[0];
    assert!(x.is_nan() && y == f64::INFINITY && z == f64::NEG_INFINITY);
    assert_eq!(note(&file, NoteKind::NonFinite).count, 1);
    let (bytes, _) = written(&file.mesh, Format::Obj, Encoding::Ascii);
    assert_eq!(bytes, b"v nan inf -inf\nv 1 2 3\n");
}

#[test]
fn positions_are_written_in_the_fewest_digits_that_keep_every_bit() {
    let positions = vec![[0.1, -0.0, 1e-320], [1e308, 1.0 / 3.0, 123_456_789.0]];
    let mesh = PolygonMesh::new(positions, FaceTable::empty(2)).unwrap();
    let (bytes, _) = written(&mesh, Format::Obj, Encoding::Ascii);
    let again = read(&bytes).mesh;
    let bits =
        |mesh: &PolygonMesh| mesh.positions().iter().flatten().map(|x| x.to_bits()).collect::<Vec<_>>();
    assert_eq!(bits(&again), bits(&mesh));
    assert!(bytes.starts_with(b"v 0.1 -0 "));
}

#[test]
fn what_is_no_obj_is_refused() {
    assert_eq!(refused("").1, "no statement of an OBJ file");
    assert_eq!(refused("hello world\n").1, "no statement of an OBJ file");
    assert_eq!(note(&read("# nothing\n"), NoteKind::Empty).count, 1);
}

#[test]
fn limits_are_kept() {
    let text = format!("{TRIANGLE}f 1 2 3\nf 1 2 3\n");
    let with = |limits| {
        read_bytes(text.as_bytes(), "t.obj", &ReadOptions::default().with_limits(limits)).unwrap_err()
    };
    let limits = [
        ("bytes", Limits::default().with_max_file_bytes(10)),
        ("vertices", Limits::default().with_max_vertices(2)),
        ("faces", Limits::default().with_max_faces(1)),
        ("corners", Limits::default().with_max_corners(5)),
    ];
    for (name, limits) in limits {
        assert!(
            matches!(with(limits).kind, ReadErrorKind::LimitExceeded { what, .. } if what == name),
            "{name}"
        );
    }
    let limits = Limits::default().with_max_comments(1);
    let file =
        read_bytes(b"#a\n#b\n#c\nv 0 0 0\n", "t.obj", &ReadOptions::default().with_limits(limits)).unwrap();
    assert_eq!((file.mesh.metadata().len(), note(&file, NoteKind::SkippedComment).count), (1, 2));
}

#[test]
fn what_obj_can_not_carry_is_named() {
    let mesh = read(format!("{TRIANGLE}f 1 2 3\n")).mesh;
    let quality = Layer::direct("quality", Domain::Vertex, 1, Carry::Copy, Values::F32(vec![0.0; 3]));
    let color = Layer::direct(
        "color",
        Domain::Vertex,
        3,
        Carry::Copy,
        Values::U8(vec![0, 51, 255, 0, 0, 0, 0, 0, 0]),
    );
    let mesh = mesh.with_layers(vec![quality, color]).unwrap();
    let (bytes, losses) = written(&mesh, Format::Obj, Encoding::Ascii);
    let messages: Vec<&str> = losses.iter().map(|loss| &loss.message[..]).collect();
    assert_eq!(
        messages,
        ["vertex attribute `quality` of 3 vertices", "colours of 3 vertices become fractions of 255"]
    );
    assert!(bytes.starts_with(b"v 0 0 0 0 0.2 1\n"));
}

#[test]
fn a_million_groups_are_as_many_names() {
    let groups: String = (0..1_000_000).map(|i| format!("g group{i}\nf 1 2 3\n")).collect();
    let text = format!("{TRIANGLE}{groups}");
    let mesh = read(text).mesh;
    assert_eq!(layer(&mesh, "group", Domain::Face).value_count(), 1_000_000);
}

#[test]
fn tobj_reads_what_is_written() {
    let text = format!(
        "{TRIANGLE}v 1 1 0\nvt 0 0\nvt 1 0.5\nvn 0 0 1\nf 1/1/1 2/2/1 4/1/1 3/2/1\nf 1/1/1 3/1/1 2/1/1\n"
    );
    let (bytes, _) = written(&read(text).mesh, Format::Obj, Encoding::Ascii);
    let no_materials = |_: &std::path::Path| Err(tobj::LoadError::OpenFileFailed);
    let (models, _) =
        tobj::load_obj_buf(&mut &bytes[..], &tobj::LoadOptions::default(), no_materials).unwrap();
    let mesh = &models[0].mesh;
    assert_eq!(mesh.face_arities, [4, 3]);
    assert_eq!(mesh.indices, [0, 1, 2, 3, 0, 3, 1]);
    assert_eq!(mesh.positions, [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0]);
    assert_eq!(mesh.texcoords.len() / 2, 2);
}
