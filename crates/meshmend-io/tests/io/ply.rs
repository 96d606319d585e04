//! What the PLY reader and writer promise.

use crate::common::{assert_kept, faces, layer, note, read as read_as, refused as refused_as, written};
use meshmend_core::{Carry, Domain, FaceTable, Layer, PolygonMesh, Values, VertexId};
use meshmend_io::{Encoding, Format, LossKind, NoteKind, Place, ReadFile, WriteOptions, encode};
use ply_rs::{parser::Parser, ply::DefaultElement, ply::Property};

fn read(bytes: impl AsRef<[u8]>) -> ReadFile {
    read_as(Format::Ply, bytes)
}

fn refused(bytes: impl AsRef<[u8]>) -> (Place, String) {
    refused_as(Format::Ply, bytes)
}

fn ascii(header: &str, body: &str) -> String {
    format!("ply\nformat ascii 1.0\n{header}end_header\n{body}")
}

const XYZ: &str = "property float x\nproperty float y\nproperty float z\n";
const LIST: &str = "property list uchar int vertex_indices\n";

/// Three vertices and one triangle with more properties of each.
fn triangle(vertex: &str, face: &str, rows: [&str; 4]) -> String {
    let header = format!("element vertex 3\n{XYZ}{vertex}element face 1\n{LIST}{face}");
    let [a, b, c, f] = rows;
    ascii(&header, &format!("0 0 0 {a}\n1 0 0 {b}\n0 1 0 {c}\n3 0 1 2 {f}\n"))
}

fn assert_kept_in_all(mesh: &PolygonMesh) {
    for &encoding in Format::Ply.encodings() {
        assert_kept(mesh, Format::Ply, encoding);
    }
}

#[test]
fn elements_and_properties_come_in_any_order() {
    let header = "element face 2\nproperty int flag\nproperty list int uint vertex_index\nelement vertex 4\nproperty double z\nproperty uchar red\nproperty int8 x\nproperty short y\n";
    let file = read(ascii(header, "7 3 0 1 2\n8 4 3 2 1 0\n0.5 9 1 2\n0 8 -128 0\n0 7 0 300\n1e400 6 0 0"));
    assert_eq!(file.variant, "ply-ascii");
    assert_eq!(file.mesh.positions()[..3], [[1.0, 2.0, 0.5], [-128.0, 0.0, 0.0], [0.0, 300.0, 0.0]]);
    assert_eq!(faces(&file.mesh), [&[0, 1, 2][..], &[3, 2, 1, 0]]);
    assert_eq!(layer(&file.mesh, "red", Domain::Vertex).values(), &Values::U8(vec![9, 8, 7, 6]));
    assert_eq!(layer(&file.mesh, "flag", Domain::Face).values(), &Values::I32(vec![7, 8]));
    assert_eq!(note(&file, NoteKind::NonFinite).count, 1);
}

#[test]
fn every_type_is_read_under_both_names_in_all_encodings() {
    for names in [
        "char uchar short ushort int uint float double",
        "int8 uint8 int16 uint16 int32 uint32 float32 float64",
    ] {
        let declared = names.split(' ').enumerate().map(|(i, name)| format!("property {name} p{i}\n"));
        let rows = [
            "-128 255 -32768 65535 -2147483648 4294967295 0.1 0.1",
            "0 0 0 0 0 0 -0 5e-324",
            "1 1 1 1 1 1 1 1",
        ];
        let text = triangle(&declared.collect::<String>(), "", [rows[0], rows[1], rows[2], ""]);
        let mesh = read(text).mesh;
        assert_eq!(layer(&mesh, "p0", Domain::Vertex).values(), &Values::I8(vec![-128, 0, 1]));
        assert_eq!(layer(&mesh, "p5", Domain::Vertex).values(), &Values::U32(vec![u32::MAX, 0, 1]));
        assert_eq!(layer(&mesh, "p6", Domain::Vertex).values(), &Values::F32(vec![0.1, -0.0, 1.0]));
        assert_eq!(layer(&mesh, "p7", Domain::Vertex).values(), &Values::F64(vec![0.1, 5e-324, 1.0]));
        assert_kept_in_all(&mesh);
    }
}

#[test]
fn single_precision_is_rounded_once_also_in_text() {
    let text = ascii(&format!("element vertex 1\n{XYZ}"), "0.1 1.00000005960464477540 -0\n");
    let [x, y, z] = read(text).mesh.positions()[0];
    assert_eq!((x, y), (f64::from(0.1_f32), f64::from(1.000_000_1_f32)));
    assert!(z == 0.0 && z.is_sign_negative());
}

#[test]
fn well_known_names_become_one_layer_and_come_back() {
    let vertex = "property float nx\nproperty float ny\nproperty float nz\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\nproperty double quality\nproperty float texture_u\nproperty float texture_v\n";
    let row = "0 0 1 1 2 3 4 0.5 0.25 0.75";
    let mesh = read(triangle(
        vertex,
        "property uchar red\nproperty uchar green\nproperty uchar blue\n",
        [row, row, row, "7 8 9"],
    ))
    .mesh;
    let summary: Vec<(&str, Domain, usize)> =
        mesh.layers().iter().map(|l| (l.name(), l.domain(), l.width())).collect();
    let expected = [
        ("normal", Domain::Vertex, 3),
        ("color", Domain::Vertex, 4),
        ("quality", Domain::Vertex, 1),
        ("texcoord", Domain::Vertex, 2),
        ("color", Domain::Face, 3),
    ];
    assert_eq!(summary, expected);
    assert_eq!(layer(&mesh, "color", Domain::Face).values(), &Values::U8(vec![7, 8, 9]));
    assert_kept_in_all(&mesh);
    let (bytes, _) = written(&mesh, Format::Ply, Encoding::Ascii);
    let text = String::from_utf8(bytes).unwrap();
    assert!(text.contains("property float texture_u\nproperty float texture_v\n"), "{text}");
}

#[test]
fn names_of_several_types_or_incomplete_ones_stay_single() {
    let vertex = "property float nx\nproperty double ny\nproperty float nz\nproperty uchar red\n";
    let mesh = read(triangle(vertex, "", ["0 0 1 5", "0 0 1 5", "0 0 1 5", ""])).mesh;
    let names: Vec<&str> = mesh.layers().iter().map(Layer::name).collect();
    assert_eq!(names, ["nx", "ny", "nz", "red"]);
    assert_kept_in_all(&mesh);
}

#[test]
fn lists_stay_lists() {
    let vertex = "property list uchar short near\n";
    let mesh =
        read(triangle(vertex, "property list int float f\n", ["2 1 -2", "0", "1 7", "4 1 2 3 0.5"])).mesh;
    let lists = Values::Lists { starts: vec![0, 2, 2, 3], items: Box::new(Values::I16(vec![1, -2, 7])) };
    assert_eq!(layer(&mesh, "near", Domain::Vertex).values(), &lists);
    assert_kept_in_all(&mesh);
}

#[test]
fn corner_values_are_lists_of_the_faces() {
    let face = "property list uchar float texcoord\nproperty list uchar uchar corner_color\n";
    let mesh = read(triangle("", face, ["", "", "", "6 0 0 1 0 0 1 9 1 2 3 4 5 6 7 8 9"])).mesh;
    let texcoord = layer(&mesh, "texcoord", Domain::Corner);
    assert_eq!((texcoord.width(), texcoord.is_direct()), (2, true));
    assert_eq!(layer(&mesh, "color", Domain::Corner).width(), 3);
    assert_kept_in_all(&mesh);
}

#[test]
fn lists_that_do_not_fit_the_corners_stay_lists_of_the_face() {
    let mesh = read(triangle("", "property list uchar float texcoord\n", ["", "", "", "3 0 0 1"])).mesh;
    assert_eq!(mesh.layers()[0].domain(), Domain::Face);
    assert_kept_in_all(&mesh);
}

#[test]
fn lists_are_of_the_corners_when_each_face_has_as_many_a_corner() {
    let header = format!("element vertex 4\n{XYZ}element face 2\n{LIST}property list uchar int corner_ids\n");
    for (ids, domain) in [("4 5 6 7 8", Domain::Corner), ("3 5 6 7", Domain::Face)] {
        let rows = format!("0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 3 1 2 3\n4 0 1 2 3 {ids}\n");
        let mesh = read(ascii(&header, &rows)).mesh;
        assert_eq!(mesh.layers()[0].domain(), domain, "{ids}");
        assert_kept_in_all(&mesh);
    }
}

#[test]
fn lengths_of_lists_have_the_smallest_type_that_holds_them() {
    let list = |count: usize| format!("{count}{}", " 1".repeat(count));
    for (count, name) in [(200, "uchar"), (300, "ushort")] {
        let rows = [list(count), list(count), list(0)];
        let mesh =
            read(triangle("property list int uchar near\n", "", [&rows[0], &rows[1], &rows[2], ""])).mesh;
        let (bytes, _) = written(&mesh, Format::Ply, Encoding::LittleEndian);
        let text = String::from_utf8_lossy(&bytes);
        assert!(text.contains(&format!("property list {name} uchar near\n")), "{text}");
        assert_kept_in_all(&mesh);
    }
}

#[test]
fn a_layer_of_several_numbers_is_as_many_properties() {
    let mesh = read(triangle("", "", [""; 4])).mesh;
    let flow = Layer::direct("flow", Domain::Vertex, 2, Carry::Copy, Values::I32(vec![1, 2, 3, 4, 5, 6]));
    let (bytes, losses) = written(&mesh.with_layers(vec![flow]).unwrap(), Format::Ply, Encoding::Ascii);
    assert_eq!(losses, []);
    let again = read(bytes).mesh;
    assert_eq!(layer(&again, "flow_0", Domain::Vertex).values(), &Values::I32(vec![1, 3, 5]));
    assert_eq!(layer(&again, "flow_1", Domain::Vertex).values(), &Values::I32(vec![2, 4, 6]));
}

#[test]
fn faces_without_corner_values_have_empty_lists() {
    let header = format!("element vertex 3\n{XYZ}element face 2\n{LIST}property list uchar float texcoord\n");
    let text = ascii(&header, "0 0 0\n1 0 0\n0 1 0\n3 0 1 2 0\n3 2 1 0 6 1 2 3 4 5 6\n");
    let mesh = read(text).mesh;
    let texcoord = layer(&mesh, "texcoord", Domain::Corner);
    assert_eq!([0, 2, 3, 5].map(|corner| texcoord.value_of(corner)), [None, None, Some(0), Some(2)]);
    assert_kept_in_all(&mesh);
}

#[test]
fn triangle_strips_turn_every_second_triangle_and_restart() {
    let header = format!("element vertex 5\n{XYZ}element tristrips 1\n{LIST}");
    let rows: String = (0..5).map(|i| format!("{i} 0 0\n")).collect();
    let mesh = read(ascii(&header, &format!("{rows}9 0 1 2 3 4 -1 2 1 0\n"))).mesh;
    assert_eq!(faces(&mesh), [[0, 1, 2], [2, 1, 3], [2, 3, 4], [2, 1, 0]]);
}

#[test]
fn faces_of_strips_have_no_values_of_face_rows() {
    let header =
        format!("element vertex 3\n{XYZ}element tristrips 1\n{LIST}element face 1\n{LIST}property int id\n");
    let mesh = read(ascii(&header, "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 2 1 0 7\n")).mesh;
    let id = layer(&mesh, "id", Domain::Face);
    assert_eq!([id.value_of(0), id.value_of(1)], [None, Some(0)]);
}

#[test]
fn edges_become_loose_edges() {
    let header = format!(
        "element vertex 3\n{XYZ}element edge 2\nproperty uchar red\nproperty int vertex2\nproperty uint vertex1\n"
    );
    let file = read(ascii(&header, "0 0 0\n1 0 0\n0 1 0\n5 1 0\n6 2 1\n"));
    assert_eq!(file.mesh.loose_edges(), [[VertexId(0), VertexId(1)], [VertexId(1), VertexId(2)]]);
    let red = layer(&file.mesh, "red", Domain::LooseEdge);
    assert_eq!((red.values(), file.notes.len()), (&Values::U8(vec![5, 6]), 0));
    assert_kept_in_all(&file.mesh);
}

#[test]
fn strips_and_edges_without_indices_are_skipped_and_counted() {
    let header = format!("element vertex 1\n{XYZ}element tristrips 2\nproperty int id\n");
    let file = read(ascii(&header, "0 0 0\n7\n8\n"));
    let skipped = note(&file, NoteKind::SkippedElement);
    assert_eq!((skipped.count, file.mesh.counts().faces), (2, 0));
    assert!(skipped.message.contains("`tristrips` has no indices"), "{skipped}");
    let header = format!("element edge 1\nproperty int vertex1\nelement vertex 1\n{XYZ}");
    let file = read(ascii(&header, "0\n1 2 3\n"));
    assert!(note(&file, NoteKind::SkippedElement).message.contains("`edge` has no `vertex1` and `vertex2`"));
    assert_eq!((file.mesh.loose_edges().len(), file.mesh.positions()), (0, &[[1.0, 2.0, 3.0]][..]));
}

#[test]
fn what_stands_beside_the_indices_of_strips_and_edges_is_passed_over() {
    let header = format!(
        "element vertex 3\n{XYZ}element tristrips 1\nproperty list uchar short flags\n{LIST}\
         element edge 1\nproperty int vertex1\nproperty list uchar short flags\nproperty int vertex2\n"
    );
    let file = read(ascii(&header, "0 0 0\n1 0 0\n0 1 0\n2 9 9 3 0 1 2\n1 3 7 7 7 2\n"));
    assert_eq!(faces(&file.mesh), [[0, 1, 2]]);
    assert_eq!(file.mesh.loose_edges(), [[VertexId(1), VertexId(2)]]);
}

#[test]
fn a_negative_index_is_refused_in_strips_too_unless_it_restarts_them() {
    let header = format!("element vertex 1\n{XYZ}element tristrips 1\n{LIST}");
    let wrong = refused(ascii(&header, "0 0 0\n4 0 0 -2 -3\n"));
    assert_eq!(wrong, (Place::Line(11), "-2 is no index of a vertex".to_owned()));
}

#[test]
fn no_face_needs_no_list_of_indices() {
    let file = read(ascii(&format!("element vertex 1\n{XYZ}element face 0\n"), "1 2 3\n"));
    assert_eq!(file.mesh.counts().faces, 0);
}

#[test]
fn unknown_elements_are_skipped_and_counted() {
    for (count, row) in [(2, "1 2 7 8\n0.5 0\n"), (0, "")] {
        let header = format!(
            "element camera {count}\nproperty float fov\nproperty list uchar int ids\nelement vertex 1\n{XYZ}"
        );
        let file = read(ascii(&header, &format!("{row}1 2 3\n")));
        assert_eq!(file.mesh.positions(), [[1.0, 2.0, 3.0]]);
        assert_eq!(file.notes.iter().map(|note| note.count).sum::<u64>(), count);
    }
    let nothing = ascii(&format!("element nothing 4000000000\nelement vertex 1\n{XYZ}"), "1 2 3\n");
    assert_eq!(note(&read(nothing), NoteKind::SkippedElement).count, 4_000_000_000);
}

#[test]
fn comments_are_kept() {
    let mesh =
        read(ascii(&format!("comment one\nobj_info  two \ncomment\nelement vertex 0\n{XYZ}"), "")).mesh;
    let statements: Vec<(&str, &[u8])> = mesh.metadata().iter().map(|m| (&m.key[..], &m.value[..])).collect();
    assert_eq!(statements, [("comment", &b"one"[..]), ("obj_info", b" two"), ("comment", b"")]);
    assert_kept_in_all(&mesh);
}

#[test]
fn binary_values_begin_right_after_the_header_however_its_lines_end() {
    for end in ["\n", "\r\n", "\r"] {
        let header = format!("ply\nformat binary_little_endian 1.0\nelement vertex 1\n{XYZ}end_header\n")
            .replace('\n', end);
        // The first byte is that of a line feed.
        let values = [f32::from_le_bytes([10, 0, 0, 0x40]), 1.0, 2.0];
        let bytes: Vec<u8> = header.bytes().chain(values.iter().flat_map(|x| x.to_le_bytes())).collect();
        assert_eq!(read(&bytes).mesh.positions(), [values.map(f64::from)], "{end:?}");
    }
}

#[test]
fn indices_of_fraction_types_are_read_when_whole() {
    let header = format!("element vertex 3\n{XYZ}element face 1\nproperty list uchar float vertex_indices\n");
    assert_eq!(faces(&read(ascii(&header, "0 0 0\n0 0 0\n0 0 0\n3 0 1.0 2\n")).mesh), [[0, 1, 2]]);
    let wrong = refused(ascii(&header, "0 0 0\n0 0 0\n0 0 0\n3 0 1.5 2\n"));
    assert_eq!(wrong, (Place::Line(13), "`1.5` where a whole number belongs".to_owned()));
}

#[test]
fn surplus_is_noted() {
    let file = read(ascii(&format!("element vertex 1\n{XYZ}"), "1 2 3\n 4 5\n"));
    let surplus = note(&file, NoteKind::SurplusData);
    assert_eq!((surplus.count, surplus.first), (3, Place::Line(9)));
    let (whole, _) = written(&file.mesh, Format::Ply, Encoding::BigEndian);
    assert_eq!(read(&whole).notes, []);
    let file = read([&whole[..], &[0; 5]].concat());
    let surplus = note(&file, NoteKind::SurplusData);
    assert_eq!((surplus.count, surplus.first), (5, Place::Byte(whole.len() as u64)));
}

#[test]
fn a_length_that_is_none_is_refused_with_its_line() {
    let header = format!("element vertex 1\n{XYZ}element face 1\nproperty list int int vertex_indices\n");
    let wrong = refused(ascii(&header, "0 0 0\n-1 0\n"));
    assert_eq!(wrong, (Place::Line(10), "-1 is no length of a list".to_owned()));
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
        ("-1", "-1 is no index of a vertex"),
        ("3", "vertex 3 does not exist: the file has 3 vertices"),
        ("2147483648", "2147483648 is no number of type `int`"),
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
        ("element vertex -1\n".to_owned(), "`-1` is no number of elements"),
        (
            "element vertex 99999999999999999999\n".to_owned(),
            "`99999999999999999999` is no number of elements",
        ),
        ("property float x\n".to_owned(), "a property before the first element"),
        ("element vertex 1\nproperty half x\n".to_owned(), "`half` is no type"),
        ("format ascii 1.0\n".to_owned(), "a second format"),
        ("nonsense\n".to_owned(), "`nonsense` is no statement of a header"),
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

#[test]
fn positions_are_single_where_that_is_exact() {
    for (x, name) in
        [(0.5, "float"), (0.1, "double"), (f64::INFINITY, "float"), (1e300, "double"), (-0.0, "float")]
    {
        let mesh = PolygonMesh::new(vec![[x, 0.0, 0.0]], FaceTable::empty(1)).unwrap();
        let (bytes, losses) = written(&mesh, Format::Ply, Encoding::LittleEndian);
        assert_eq!(losses, []);
        let text = String::from_utf8_lossy(&bytes);
        assert!(text.contains(&format!("property {name} x\n")), "{x}: {text}");
        assert_eq!(read(bytes).mesh.positions()[0][0].to_bits(), x.to_bits());
    }
}

#[test]
fn what_ply_can_not_carry_is_named() {
    let mesh = read(triangle("", "", [""; 4])).mesh;
    let names = Values::Text(vec![b"a".to_vec()]);
    let some = Layer::indexed(
        "q r",
        Domain::Vertex,
        1,
        Carry::Copy,
        Values::F32(vec![1.0]),
        vec![0, u32::MAX, u32::MAX],
    );
    let layers = vec![Layer::direct("group", Domain::Face, 1, Carry::Copy, names), some];
    let mesh = mesh.with_layers(layers).unwrap().with_loose(vec![], vec![VertexId(0)]).unwrap();
    let (bytes, losses) = written(&mesh, Format::Ply, Encoding::Ascii);
    let found: Vec<(LossKind, u64)> = losses.iter().map(|loss| (loss.kind, loss.count)).collect();
    let expected =
        [(LossKind::Layer, 1), (LossKind::Names, 1), (LossKind::AbsentValue, 2), (LossKind::LoosePoints, 1)];
    assert_eq!(found, expected);
    assert!(String::from_utf8_lossy(&bytes).contains("\n1 0 0 nan\n"));
    assert_eq!(losses[0].message, "face attribute `group` of 1 face");
}

#[test]
fn pairs_of_lists_are_left_out_and_named() {
    let mesh = read(triangle("", "", [""; 4])).mesh;
    let lists = Values::Lists { starts: vec![0, 1, 2], items: Box::new(Values::U8(vec![1, 2])) };
    let pairs = Layer::direct("pairs", Domain::Face, 2, Carry::Copy, lists);
    let (bytes, losses) = written(&mesh.with_layers(vec![pairs]).unwrap(), Format::Ply, Encoding::Ascii);
    assert_eq!(losses.iter().map(|l| (l.kind, l.count)).collect::<Vec<_>>(), [(LossKind::Layer, 1)]);
    assert!(read(bytes).mesh.layers().is_empty());
}

/// A face's list has a value for each corner or for none.
#[test]
fn a_corner_without_a_value_beside_one_with_a_value_is_named() {
    let corners = [0, 1, 2, 2, 1, 0].map(VertexId).to_vec();
    let mesh = PolygonMesh::new(vec![[0.0; 3]; 3], FaceTable::triangles(3, corners).unwrap()).unwrap();
    let none = meshmend_core::NO_VALUE;
    let uses = vec![0, none, 0, none, none, none];
    let layer = Layer::indexed("heat", Domain::Corner, 1, Carry::Copy, Values::F32(vec![0.5]), uses);
    let losses = written(&mesh.with_layers(vec![layer]).unwrap(), Format::Ply, Encoding::Ascii).1;
    assert_eq!(losses.iter().map(|l| (l.kind, l.count)).collect::<Vec<_>>(), [(LossKind::AbsentValue, 1)]);
    assert_eq!(losses[0].message, "that 1 corner has no corner attribute `heat`");
}

#[test]
fn ply_rs_reads_what_is_written() {
    let vertex = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    let mesh = read(triangle(vertex, "property double area\n", ["1 2 3", "4 5 6", "7 8 9", "0.5"])).mesh;
    for &encoding in Format::Ply.encodings() {
        let (bytes, _) = written(&mesh, Format::Ply, encoding);
        let ply = Parser::<DefaultElement>::new().read_ply(&mut &bytes[..]).unwrap();
        let (vertices, faces) = (&ply.payload["vertex"], &ply.payload["face"]);
        assert_eq!(vertices[1]["x"], Property::Float(1.0));
        assert_eq!(vertices[2]["blue"], Property::UChar(9));
        assert_eq!(faces[0]["vertex_indices"], Property::ListInt(vec![0, 1, 2]));
        assert_eq!(faces[0]["area"], Property::Double(0.5));
    }
}

/// As is left when the only faces with values were removed.
#[test]
fn a_corner_layer_without_any_value_is_left_out() {
    let faces = FaceTable::triangles(3, [0, 1, 2].map(VertexId).to_vec()).unwrap();
    let uses = vec![meshmend_core::NO_VALUE; 3];
    let layer = Layer::indexed("texcoord", Domain::Corner, 2, Carry::Copy, Values::F32(Vec::new()), uses);
    let mesh = PolygonMesh::new(vec![[0.0; 3]; 3], faces).unwrap().with_layers(vec![layer]).unwrap();
    let (bytes, losses) = written(&mesh, Format::Ply, Encoding::Ascii);
    assert_eq!(losses, []);
    assert!(read(bytes).mesh.layers().is_empty());
}

/// Names are how layers are told apart, so what would be a second layer of one name stays single numbers.
#[test]
fn no_two_layers_of_an_element_have_one_name() {
    let normals = "property float nx\nproperty float ny\nproperty float nz\nproperty float normal\n";
    let coordinates = "property float u\nproperty float v\nproperty float s\nproperty float t\n";
    let lists = "property list uchar float texcoord\nproperty list uchar float corner_texcoord\n";
    let row = "1 2 3 4 5 6 7 8";
    let file = triangle(&format!("{normals}{coordinates}"), lists, [row, row, row, "6 1 2 3 4 5 6 3 7 8 9"]);
    let mesh = read(file).mesh;
    let names: Vec<_> = mesh.layers().iter().map(|layer| (layer.domain(), layer.name())).collect();
    let vertex = ["nx", "ny", "nz", "normal", "texcoord", "s", "t"].map(|name| (Domain::Vertex, name));
    let others = [(Domain::Corner, "texcoord"), (Domain::Face, "corner_texcoord")];
    assert_eq!(names, [&vertex[..], &others].concat());
    assert_kept_in_all(&mesh);
    // Those of corners are no property of faces, whatever the file calls them.
    let both = "property list uchar float texcoord\nproperty float s\nproperty float t\n";
    let mesh = read(triangle("", both, ["", "", "", "6 1 2 3 4 5 6 7 8"])).mesh;
    assert_eq!(layer(&mesh, "texcoord", Domain::Corner).width(), 2);
    assert_eq!(layer(&mesh, "texcoord", Domain::Face).width(), 2);
    assert_kept_in_all(&mesh);
}

#[test]
fn elements_of_one_name_keep_the_order_of_their_own_columns() {
    let text = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n\
                element thing 1\nproperty int a\nproperty uchar b\nelement thing 1\nproperty uchar b\nproperty int a\n\
                end_header\n0 0 0\n300 4\n5 600\n";
    let file = read(text);
    let mut bytes = Vec::new();
    encode(&file.mesh, &WriteOptions::of(Format::Ply).as_read(&file), &mut bytes).unwrap();
    assert_eq!(String::from_utf8_lossy(&bytes), text);
}
