//! New packages from meshes of other formats, and what of a package other formats carry.

use super::*;
use crate::common::{faces, layer, names, read, written};
use meshmend_core::Domain;
use meshmend_io::{Encoding, LossKind, Material, encode};

fn to_package(mesh: &PolygonMesh) -> (Vec<u8>, Vec<Loss>) {
    written(mesh, Format::ThreeMf, Encoding::Ascii)
}

fn obj(text: &str) -> PolygonMesh {
    read(Format::Obj, text).mesh
}

const TWO: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0.1\nv 7 7 7\n";

#[test]
fn a_mesh_without_names_is_one_object_with_all_its_vertices() {
    let (bytes, losses) = to_package(&obj(&format!("{TWO}f 1 2 3\nf 1 2 4\n")));
    assert_eq!(losses, []);
    let text = model_text(&bytes);
    assert!(text.contains("<model unit=\"millimeter\""), "{text}");
    assert!(text.contains("<vertex x=\"0\" y=\"0\" z=\"0.1\"/>\n"), "{text}");
    let read = document(&bytes);
    assert_eq!((read.parts.len(), read.parts[0].mesh.counts().vertices), (1, 5));
    assert_eq!(faces(&read.parts[0].mesh), [[0, 1, 2], [0, 1, 3]]);
    assert_eq!(spliced(&read), (bytes, Vec::new()));
}

#[test]
fn each_object_has_its_own_vertices() {
    let (bytes, losses) = to_package(&obj(&format!("{TWO}o left <&>\nf 1 2 3\no right\nf 2 1 4\n")));
    let kinds: Vec<(LossKind, u64)> = losses.iter().map(|loss| (loss.kind, loss.count)).collect();
    assert_eq!(kinds, [(LossKind::UnusedVertices, 1), (LossKind::SharedVertices, 2)]);
    let read = document(&bytes);
    let parts: Vec<(&[u8], usize)> =
        read.parts.iter().map(|part| (&part.name[..], part.mesh.counts().vertices)).collect();
    assert_eq!(parts, [(&b"left <&>"[..], 3), (b"right", 3)]);
    assert_eq!(faces(&read.parts[1].mesh), [[1, 0, 2]]);
    let file = read.into_mesh(meshmend_io::Placing::Scene).unwrap();
    let objects = names(layer(&file.mesh, "object", Domain::Face));
    assert_eq!(objects, [Some("left <&>".to_owned()), Some("right".to_owned())]);
}

#[test]
fn names_of_materials_are_base_materials() {
    let text = format!(
        "{TWO}f 1 2 3\nusemtl steel\nf 1 2 4\nusemtl \"gl\u{e4}ss\"\nf 1 3 4\nusemtl steel\nf 2 3 4\n"
    );
    let (bytes, losses) = to_package(&obj(&text));
    assert_eq!(losses, []);
    assert!(model_text(&bytes).contains("<base name=\"&quot;gl\u{e4}ss&quot;\" displaycolor=\"#808080\"/>"));
    let mesh = &document(&bytes).parts[0].mesh;
    let steel = Some("steel".to_owned());
    let materials = names(layer(mesh, "material", Domain::Face));
    assert_eq!(materials, [None, steel.clone(), Some("\"gl\u{e4}ss\"".to_owned()), steel]);
}

#[test]
fn colours_of_materials_come_along() {
    let mesh = obj(&format!("{TWO}usemtl red\nf 1 2 3\nusemtl green\nf 1 2 4\n"));
    let mut red = Material::named("red");
    (red.base_color, red.opacity) = (Some([1.0, 0.0, 0.2]), Some(0.5));
    let mut green = Material::named("green");
    (green.base_color, green.roughness) = (Some([0.0, 2.0, 0.0]), Some(0.5));
    let options = WriteOptions::of(Format::ThreeMf).with_materials([red, green]);
    let mut bytes = Vec::new();
    let losses = encode(&mesh, &options, &mut bytes).unwrap();
    let text = model_text(&bytes);
    assert!(text.contains("<base name=\"red\" displaycolor=\"#FF003380\"/>"), "{text}");
    assert!(text.contains("<base name=\"green\" displaycolor=\"#00FF00\"/>"), "{text}");
    let messages: Vec<String> = losses.iter().map(Loss::to_string).collect();
    assert_eq!(messages, ["1 material is more than a name and a colour, which 3MF shows it in"]);
    // And go into formats that have them.
    let prepared = PreparedDocument::new(&document(&bytes), &WriteOptions::of(Format::Obj)).unwrap();
    let kinds: Vec<LossKind> = prepared.losses().iter().map(|loss| loss.kind).collect();
    assert_eq!(kinds, [LossKind::Material]);
    assert_eq!(prepared.losses()[0].message, "what 2 materials look like: no library is written");
}

#[test]
fn what_a_package_does_not_carry_is_named() {
    let text = format!("mtllib a.mtl\n{TWO}vt 0 0\ng wing\nf 1/1 2/1 3/1 4/1\nl 1 2\np 3\n");
    let (bytes, losses) = to_package(&obj(&text));
    let kinds: Vec<LossKind> = losses.iter().map(|loss| loss.kind).collect();
    use LossKind::{Layer, LooseEdges, LoosePoints, Metadata, Polygons};
    assert_eq!(kinds, [Polygons, Layer, Layer, LooseEdges, LoosePoints, Metadata], "{losses:?}");
    assert_eq!(document(&bytes).parts[0].mesh.counts().faces, 2);
    // Names that XML can't spell, and faces of two corners.
    let mut odd = format!("{TWO}f 1 2\no a").into_bytes();
    odd.extend_from_slice(b"\x01\xff\nf 1 2 3\n");
    let (bytes, losses) = to_package(&read(Format::Obj, odd).mesh);
    let kinds: Vec<LossKind> = losses.iter().map(|loss| loss.kind).collect();
    assert_eq!(kinds, [LossKind::ShortFaces, LossKind::Names], "{losses:?}");
    assert_eq!(document(&bytes).parts[0].name, "a\u{fffd}\u{fffd}".as_bytes());
}

#[test]
fn nothing_makes_an_empty_package() {
    let (bytes, losses) = to_package(&PolygonMesh::new(Vec::new(), FaceTable::empty(0)).unwrap());
    assert_eq!((document(&bytes).parts.len(), losses), (0, Vec::new()));
    let (bytes, _) = to_package(&obj("v 1 2 3\n"));
    assert_eq!(document(&bytes).parts[0].mesh.positions(), [[1.0, 2.0, 3.0]]);
}

#[test]
fn other_formats_name_what_only_a_package_has() {
    let beside = "<t:trianglesets/><b:beamlattice/>";
    let resources = format!(
        "<m:colorgroup id=\"6\"/><m:texture2d id=\"7\"/>{}",
        tetrahedron("s:slicestackid=\"9\"", beside)
    );
    let text = model(&resources, "<item objectid=\"1\"/>").replacen(
        "<resources>",
        "<metadata name=\"a\">b</metadata><resources>",
        1,
    );
    let read = document(&package_of(text.as_bytes()));
    let prepared = PreparedDocument::new(&read, &WriteOptions::of(Format::Obj)).unwrap();
    let messages: Vec<String> = prepared.losses().iter().map(Loss::to_string).collect();
    let expected = [
        "1 statement about the model",
        "2 resources with properties of surfaces",
        "1 beam lattice",
        "1 stack of slices of an object",
        "1 list of sets of triangles",
    ];
    assert_eq!(messages, expected);
}
