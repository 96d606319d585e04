//! PLY files that other programs understand, and that keep what a file declared.

use meshmend_core::{Domain, Values, VertexId};
use meshmend_io::{
    AttributePrecision, Encoding, Format, Loss, LossKind, Prepared, ReadFile, Seams, WriteErrorKind,
    WriteOptions, encode,
};

use crate::common::{layer, read, with_mesh};

const ENCODINGS: [Encoding; 3] = [Encoding::Ascii, Encoding::LittleEndian, Encoding::BigEndian];

fn as_text(file: &ReadFile, options: WriteOptions) -> (String, Vec<Loss>) {
    let mut bytes = Vec::new();
    let losses = encode(&file.mesh, &options.as_read(file), &mut bytes).unwrap();
    (String::from_utf8(bytes).unwrap(), losses)
}

/// An OBJ as a text PLY.
fn from_obj(text: &str) -> (String, Vec<Loss>) {
    as_text(&read(Format::Obj, text), WriteOptions::of(Format::Ply).with_encoding(Encoding::Ascii))
}

fn properties(text: &str) -> Vec<&str> {
    text.lines().filter_map(|line| line.strip_prefix("property ")).collect()
}

fn kinds(losses: &[Loss]) -> Vec<(LossKind, u64)> {
    losses.iter().map(|loss| (loss.kind, loss.count)).collect()
}

#[test]
fn attributes_of_an_obj_are_where_other_programs_look() {
    let obj = "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nvt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\nf 1/1/1 2/2/1 3/3/1\n";
    let (text, losses) = from_obj(obj);
    assert_eq!(losses, []);
    let expected = [
        "float x",
        "float y",
        "float z",
        "uchar red",
        "uchar green",
        "uchar blue",
        "float s",
        "float t",
        "float nx",
        "float ny",
        "float nz",
        "list uchar int vertex_indices",
    ];
    assert_eq!(properties(&text), expected);
    assert!(text.ends_with("0 1 0 0 0 255 0 1 0 0 1\n3 0 1 2\n"), "{text}");
}

#[test]
fn what_is_rounded_for_other_programs_is_named() {
    let colors = |c: &str| format!("v 0 0 0 {c}\nv 1 0 0 {c}\nv 0 1 0 {c}\nf 1 2 3\n");
    // n / 255 as printed with six digits, and n / 256.
    for (color, byte) in [("0.501961 0 1", "128 0 255"), ("0.5 0.25 0", "128 64 0")] {
        let (text, losses) = from_obj(&colors(color));
        assert!(text.contains(&format!("0 0 0 {byte}\n")), "{text}");
        assert_eq!(kinds(&losses), [(LossKind::Converted, 3)]);
    }
    let (text, losses) = from_obj(&colors("0.3 0.123 0.9"));
    assert!(text.contains("property float red\n"), "{text}");
    assert_eq!(kinds(&losses), [(LossKind::Converted, 9)]);
    let (text, losses) = from_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.1 0.5 0\nvt 1 0 0\nf 1/1 2/2 3/1\n");
    assert!(text.contains("property float s\nproperty float t\n"), "{text}");
    assert_eq!(kinds(&losses), [(LossKind::Converted, 2), (LossKind::Converted, 1)]);
    // Beyond single precision nothing is rounded.
    let (text, _) = from_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 1e39 0.5\nf 1/1 2/1 3/1\n");
    assert!(text.contains("property double s\n"), "{text}");
}

#[test]
fn doubles_are_kept_if_that_is_asked_for() {
    let file =
        read(Format::Obj, "v 0 0 0 0.5 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\nvt 0.1 0.5\nf 1/1 2/1 3/1\n");
    let options = WriteOptions::of(Format::Ply).with_precision(AttributePrecision::Double);
    let (text, losses) = as_text(&file, options.with_encoding(Encoding::Ascii));
    assert_eq!(losses, []);
    assert!(text.contains("property double red\n") && text.contains("property double s\n"), "{text}");
}

/// Two triangles on one edge whose texture coordinates differ there.
const SEAM: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvt 0.5 0.5\n";

#[test]
fn texture_coordinates_that_differ_are_lists_for_triangles_and_split_vertices_for_polygons() {
    let (text, losses) = from_obj(&format!("{SEAM}f 1/1 2/2 3/3\nf 3/4 2/4 4/4\n"));
    assert!(text.contains("property list uchar float texcoord\n") && losses.is_empty(), "{text}");
    let (text, losses) = from_obj(&format!("{SEAM}v 2 0 0\nf 1/1 2/2 3/3\nf 3/4 2/4 5/4 4/4\n"));
    assert!(text.contains("element vertex 7\n") && text.contains("property float s\n"), "{text}");
    assert_eq!(kinds(&losses), [(LossKind::SeamVertices, 2)]);
    let message = "2 vertices are written 4 times, as their attributes differ from face to face";
    assert!(losses[0].message.starts_with(message), "{}", losses[0]);
    assert!(text.ends_with("3 0 1 2\n4 5 6 4 3\n"), "{text}");
}

#[test]
fn normals_go_to_the_vertices_and_the_options_can_say_otherwise() {
    let obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvn 0 0 1\nvn 1 0 0\nf 1//1 2//1 3//1\nf 3//2 2//2 4//2\n";
    let file = read(Format::Obj, obj);
    let options = |seams| WriteOptions::of(Format::Ply).with_seams(seams).with_encoding(Encoding::Ascii);
    let (text, losses) = as_text(&file, options(Seams::Split));
    assert!(text.contains("element vertex 6\n") && text.contains("property float nx\n"), "{text}");
    assert_eq!(kinds(&losses), [(LossKind::SeamVertices, 2)]);
    let (text, losses) = as_text(&file, options(Seams::Corners));
    assert!(text.contains("property list uchar float corner_normal\n") && losses.is_empty(), "{text}");
    let refused = Prepared::new(&file.mesh, &options(Seams::Fail).as_read(&file)).unwrap_err();
    assert!(matches!(refused, WriteErrorKind::Seams { vertices: 2 }), "{refused}");
}

/// Names, types, lists, orders, edges with properties and elements of unknown meaning.
const DECLARED: &str = "ply
format ascii 1.0
comment made by hand
element camera 2
property double yaw
property list uchar short hits
element face 2
property uchar flags
property list ushort uint vertex_index
element edge 1
property uchar red
property ushort vertex2
property int vertex1
property float weight
element vertex 4
property uchar quality
property double z
property int x
property float y
element empty 0
property int id
end_header
0.5 2 -1 7
0.25 0
7 3 0 1 2
9 3 2 1 3
255 1 0 0.5
1 0.1 0 0.5
2 0 1 0
3 0 0 1
4 0 1 1
";

#[test]
fn what_a_file_declares_stays_as_it_is() {
    let file = read(Format::Ply, DECLARED);
    let (text, losses) = as_text(&file, WriteOptions::of(Format::Ply));
    assert_eq!((text.as_str(), losses), (DECLARED, vec![]));
    for encoding in ENCODINGS {
        let mut bytes = Vec::new();
        let options = WriteOptions::of(Format::Ply).with_encoding(encoding);
        assert_eq!(encode(&file.mesh, &options.as_read(&file), &mut bytes).unwrap(), []);
        let again = read(Format::Ply, &bytes);
        let (text, _) = as_text(&again, WriteOptions::of(Format::Ply).with_encoding(Encoding::Ascii));
        assert_eq!(text, DECLARED, "{encoding}");
    }
}

#[test]
fn types_that_are_too_small_for_what_is_there_now_give_way() {
    let file = read(Format::Ply, DECLARED);
    let mut positions = file.mesh.positions().to_vec();
    positions[0] = [0.5, 0.1, 0.1];
    let mesh = file.mesh.clone().with_positions(positions).unwrap();
    let (text, _) = as_text(&with_mesh(file, mesh), WriteOptions::of(Format::Ply));
    assert!(text.contains("property double z\nproperty double x\nproperty double y\n"), "{text}");
}

#[test]
fn elements_that_only_a_ply_carries_are_named_elsewhere() {
    let file = read(Format::Ply, DECLARED);
    let (_, losses) = as_text(&file, WriteOptions::of(Format::Obj));
    let elements: Vec<_> = losses.iter().filter(|loss| loss.kind == LossKind::Elements).collect();
    assert_eq!(elements.len(), 1);
    assert_eq!(elements[0].message, "element `camera` of 2 rows");
}

#[test]
fn a_table_that_names_other_vertices_than_there_are_now_is_said_to_be_stale() {
    let table = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
                 element face 1\nproperty list uchar int vertex_indices\nelement mark 1\nproperty int NAME\nend_header\n\
                 0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n2\n";
    for (name, is_stale) in
        [("vertex_index", true), ("face", true), ("Face_Id", true), ("vertex", false), ("id", false)]
    {
        let file = read(Format::Ply, table.replace("NAME", name));
        assert_eq!(as_text(&file, WriteOptions::of(Format::Ply)).1, []);
        let mut positions = file.mesh.positions().to_vec();
        positions.swap(1, 2);
        let mesh = file.mesh.clone().with_positions(positions).unwrap();
        let losses = as_text(&with_mesh(file, mesh), WriteOptions::of(Format::Ply)).1;
        assert_eq!(kinds(&losses), if is_stale { vec![(LossKind::StaleData, 1)] } else { vec![] }, "{name}");
    }
}

#[test]
fn a_cloud_declares_no_faces() {
    let cloud = "ply\nformat ascii 1.0\nelement vertex 2\nproperty double x\nproperty double y\nproperty double z\n\
                 property float intensity\nend_header\n0 0 0 0.5\n1 2 3 0.25\n";
    assert_eq!(as_text(&read(Format::Ply, cloud), WriteOptions::of(Format::Ply)), (cloud.to_owned(), vec![]));
    assert!(!from_obj("v 0 0 0\nv 1 2 3\np 1 2\n").0.contains("element face"));
}

#[test]
fn properties_of_edges_follow_their_edge() {
    let file = read(Format::Ply, DECLARED);
    assert_eq!(file.mesh.loose_edges(), [[VertexId(0), VertexId(1)]]);
    assert_eq!(layer(&file.mesh, "red", Domain::LooseEdge).values(), &Values::U8(vec![255]));
    assert_eq!(layer(&file.mesh, "weight", Domain::LooseEdge).values(), &Values::F32(vec![0.5]));
    assert!(file.notes.iter().all(|note| !note.message.contains("loose edges")));
}

#[test]
fn texture_numbers_are_materials_in_an_obj_and_come_back() {
    let ply = "ply\nformat ascii 1.0\ncomment TextureFile a.png\ncomment TextureFile b.png\nelement vertex 3\n\
               property float x\nproperty float y\nproperty float z\nelement face 3\n\
               property list uchar int vertex_indices\nproperty int texnumber\nend_header\n\
               0 0 0\n1 0 0\n0 1 0\n3 0 1 2 1\n3 1 2 0 0\n3 2 0 1 -1\n";
    let (obj, losses) = as_text(&read(Format::Ply, ply), WriteOptions::of(Format::Obj));
    let expected = "usemtl texture_1\nf 1 2 3\nusemtl texture_0\nf 2 3 1\n";
    assert!(obj.contains(expected) && obj.contains("TextureFile a.png"), "{obj}");
    assert_eq!(kinds(&losses), [(LossKind::Converted, 2)]);
    let (again, losses) = from_obj(&obj);
    assert!(
        again.contains("property int texnumber\n") && again.contains("comment TextureFile b.png\n"),
        "{again}"
    );
    assert!(again.ends_with("3 0 1 2 1\n3 1 2 0 0\n3 2 0 1 -1\n") && losses.is_empty(), "{again} {losses:?}");
    let (other, losses) = from_obj(&obj.replace("texture_1", "wood"));
    assert!(!other.contains("texnumber"));
    assert_eq!(kinds(&losses), [(LossKind::Layer, 2)]);
}
