//! What the PLY writer promises.

use super::{LIST, XYZ, ascii, assert_kept_in_all, read, triangle};
use crate::common::{layer, written};
use meshmend_core::{Carry, Domain, FaceTable, Layer, PolygonMesh, Values, VertexId};
use meshmend_io::{Encoding, Format, LossKind, WriteOptions, encode};
use ply_rs::{parser::Parser, ply::DefaultElement, ply::Property};

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
    let message = "vertex attribute `flow` is spread over 2 properties: `flow_0` to `flow_1`";
    assert_eq!(losses.iter().map(|loss| &loss.message[..]).collect::<Vec<_>>(), [message]);
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
fn comments_are_kept() {
    let mesh =
        read(ascii(&format!("comment one\nobj_info  two \ncomment\nelement vertex 0\n{XYZ}"), "")).mesh;
    let statements: Vec<(&str, &[u8])> = mesh.metadata().iter().map(|m| (&m.key[..], &m.value[..])).collect();
    assert_eq!(statements, [("comment", &b"one"[..]), ("obj_info", b" two"), ("comment", b"")]);
    assert_kept_in_all(&mesh);
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
