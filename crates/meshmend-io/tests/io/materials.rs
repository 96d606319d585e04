//! Materials on their way from the library of an OBJ to glTF and back, with their pictures.

use std::fs;
use std::path::{Path, PathBuf};

use crate::common::Folder;
use meshmend_core::{Carry, Domain, FaceTable, Layer, PolygonMesh, Values, VertexId};
use meshmend_io::{
    Companions, LossKind, Material, Picture, ReadOptions, WriteOptions, read, read_document, write,
    write_document,
};

/// A picture of one pixel.
const PIXEL: &[u8] = &[
    0x89, b'P', b'N', b'G', b'\r', b'\n', 0x1a, b'\n', 0, 0, 0, 13, b'I', b'H', b'D', b'R', 0, 0, 0, 1, 0, 0,
    0, 1, 8, 2, 0, 0, 0, 0x90, 0x77, 0x53, 0xde, 0, 0, 0, 12, b'I', b'D', b'A', b'T', 8, 0xd7, 0x63, 0xf8,
    0xcf, 0xc0, 0, 0, 3, 1, 1, 0, 0x18, 0xdd, 0x8d, 0xb0, 0, 0, 0, 0, b'I', b'E', b'N', b'D', 0xae, b'B',
    0x60, 0x82,
];

const LIBRARY: &str = "newmtl red\nKd 1 0.5 0.25\nKs 1 1 1\nd 0.5\nPr 0.75\nmap_Kd maps\\my red.png\nmap_Ks shine.png\n\
    newmtl blue\nKe 0 0 1\nPm 1\n";

/// An OBJ with a library and pictures.
fn textured(name: &str) -> (Folder, PathBuf) {
    let folder = Folder::new(name);
    fs::create_dir(folder.0.join("maps")).unwrap();
    fs::write(folder.0.join("maps/my red.png"), PIXEL).unwrap();
    fs::write(folder.0.join("shine.png"), PIXEL).unwrap();
    fs::write(folder.0.join("a.mtl"), LIBRARY).unwrap();
    let text = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0.25\nvt 1 0.5\n\
        usemtl red\nf 1/1 2/2 3/1\nusemtl blue\nf 3/1 2/2 4/1\n";
    let path = folder.0.join("a.obj");
    fs::write(&path, text).unwrap();
    (folder, path)
}

/// Reads a file and writes it to another one; the kinds of loss with their messages.
fn converted(from: &Path, to: &Path) -> Vec<(LossKind, String)> {
    let document = read_document(from, &ReadOptions::default()).unwrap();
    let losses = write_document(to, &document, &WriteOptions::default()).unwrap();
    losses.into_iter().map(|loss| (loss.kind, loss.message)).collect()
}

/// The JSON of a text or a GLB.
fn json(path: &Path) -> serde_json::Value {
    let bytes = fs::read(path).unwrap();
    if !bytes.starts_with(b"glTF") {
        return serde_json::from_slice(&bytes).unwrap();
    }
    let length = u32::from_le_bytes(bytes[12..16].try_into().unwrap()) as usize;
    serde_json::from_slice(&bytes[20..20 + length]).unwrap()
}

#[test]
fn a_library_becomes_materials_and_its_pictures_stand_beside_the_output() {
    let (_given, path) = textured("to-gltf");
    for name in ["b.glb", "b.gltf"] {
        let other = Folder::new("to-gltf-output");
        let losses = converted(&path, &other.0.join(name));
        let materials: Vec<&str> =
            losses.iter().filter(|(kind, _)| *kind == LossKind::Material).map(|(_, m)| &m[..]).collect();
        assert_eq!(materials, ["2 statements about materials that glTF has no word for: `Ks`, `map_Ks`"]);
        let left =
            (LossKind::Companion, "`shine.png`, which the input names and the output does not".to_owned());
        assert!(losses.contains(&left), "{losses:?}");
        let json = json(&other.0.join(name));
        assert_eq!(json["images"], serde_json::json!([{"uri": "maps/my%20red.png"}]));
        let surface = &json["materials"][0]["pbrMetallicRoughness"];
        assert_eq!(surface["baseColorFactor"], serde_json::json!([1.0, 0.5, 0.25, 0.5]));
        assert_eq!(
            (&json["materials"][0]["alphaMode"], &surface["metallicFactor"]),
            (&"BLEND".into(), &0.0.into())
        );
        assert_eq!(json["materials"][1]["emissiveFactor"], serde_json::json!([0.0, 0.0, 1.0]));
        assert_eq!(fs::read(other.0.join("maps/my red.png")).unwrap(), PIXEL);
        assert!(!other.0.join("shine.png").exists() && !other.0.join("a.mtl").exists());
    }
}

#[test]
fn materials_and_places_in_pictures_come_back_from_gltf() {
    let (_given, path) = textured("and-back");
    let (middle, end) = (Folder::new("and-back-middle"), Folder::new("and-back-end"));
    converted(&path, &middle.0.join("b.glb"));
    let losses = converted(&middle.0.join("b.glb"), &end.0.join("c.obj"));
    assert!(
        losses.iter().all(|(kind, _)| *kind != LossKind::Material && *kind != LossKind::Companion),
        "{losses:?}"
    );
    let library = "newmtl red\nKd 1 0.5 0.25\nd 0.5\nPm 0\nPr 0.75\nmap_Kd maps/my red.png\n\
        newmtl blue\nKd 1 1 1\nKe 0 0 1\nPm 1\nPr 1\n";
    assert_eq!(fs::read_to_string(end.0.join("c.mtl")).unwrap(), library);
    assert_eq!(fs::read(end.0.join("maps/my red.png")).unwrap(), PIXEL);
    let text = fs::read_to_string(end.0.join("c.obj")).unwrap();
    assert!(text.starts_with("mtllib c.mtl\n"), "{text}");
    let coordinates: Vec<&str> = text.lines().filter(|line| line.starts_with("vt ")).collect();
    assert!(coordinates.contains(&"vt 0 0.25") && coordinates.contains(&"vt 1 0.5"), "{coordinates:?}");
    assert_eq!(text.lines().filter(|line| line.starts_with("usemtl ")).count(), 2);
    // To a format without materials, the picture is left and said to be.
    let left = converted(&middle.0.join("b.glb"), &end.0.join("c.ply"));
    let expected = "`maps/my red.png`, which the input names and the output does not";
    assert!(left.contains(&(LossKind::Companion, expected.to_owned())), "{left:?}");
}

/// A triangle of one material.
fn triangle() -> PolygonMesh {
    let faces = FaceTable::triangles(3, [0, 1, 2].map(VertexId).to_vec()).unwrap();
    let mesh = PolygonMesh::new(vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], faces).unwrap();
    let names = Layer::direct("material", Domain::Face, 1, Carry::Copy, Values::Text(vec![b"red".to_vec()]));
    mesh.with_layers(vec![names]).unwrap()
}

#[test]
fn pictures_within_a_glb_become_files_beside_an_obj() {
    let folder = Folder::new("embedded");
    let mut red = Material::named("red");
    red.base_map = Some(Picture::Embedded { name: "wood".to_owned(), bytes: PIXEL.into() });
    for name in ["a.glb", "a.gltf"] {
        let options = WriteOptions::default().with_materials(vec![red.clone()]);
        assert_eq!(write(&folder.0.join(name), &triangle(), &options).unwrap(), []);
        assert_eq!(json(&folder.0.join(name))["images"][0]["mimeType"], "image/png");
        let output = Folder::new("embedded-output");
        converted(&folder.0.join(name), &output.0.join("b.obj"));
        assert_eq!(fs::read(output.0.join("b_wood.png")).unwrap(), PIXEL);
        let library = fs::read_to_string(output.0.join("b.mtl")).unwrap();
        assert_eq!(library, "newmtl red\nKd 1 1 1\nPm 0\nPr 1\nmap_Kd b_wood.png\n");
        // Without companions there is no library, and that is said.
        let file = read(&folder.0.join(name), &ReadOptions::default()).unwrap();
        let options = WriteOptions::default().as_read(&file).with_companions(Companions::Skip);
        let losses = write(&output.0.join("c.obj"), &file.mesh, &options).unwrap();
        assert_eq!(losses.iter().filter(|loss| loss.kind == LossKind::Material).count(), 1);
        assert!(!output.0.join("c.mtl").exists());
    }
}

#[test]
fn materials_of_one_name_stay_two() {
    let json = r#"{"asset": {"version": "2.0"}, "meshes": [{"primitives": [
        {"attributes": {"POSITION": 0}, "material": 0}, {"attributes": {"POSITION": 0}, "material": 1}]}],
        "materials": [{"name": "red", "pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1]}}, {"name": "red"}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [0, 0, 0]}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "buffers": [{"byteLength": 36, "uri": "data:;base64,AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA"}]}"#;
    let folder = Folder::new("one-name");
    let (path, output) = (folder.0.join("a.gltf"), folder.0.join("b.obj"));
    fs::write(&path, json).unwrap();
    let losses = converted(&path, &output);
    let told = "1 material shares its name with another and is called `red_1`".to_owned();
    assert!(losses.contains(&(LossKind::Names, told)), "{losses:?}");
    let text = fs::read_to_string(&output).unwrap();
    assert!(text.contains("usemtl red\n") && text.contains("usemtl red_1\n"), "{text}");
    let library = fs::read_to_string(folder.0.join("b.mtl")).unwrap();
    assert!(library.contains("newmtl red_1\n"), "{library}");
}
