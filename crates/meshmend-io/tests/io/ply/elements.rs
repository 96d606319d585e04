//! What elements and properties become.

use super::{LIST, XYZ, ascii, assert_kept_in_all, read, refused, triangle};
use crate::common::{faces, layer, note, written};
use meshmend_core::{Domain, Layer, Values, VertexId};
use meshmend_io::{Encoding, Format, NoteKind, Place};

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
