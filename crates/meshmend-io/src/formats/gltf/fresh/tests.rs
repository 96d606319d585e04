//! New files, looked at as JSON and bytes.

use meshmend_core::{Carry, Domain, FaceTable, Layer, Metadata, PolygonMesh, Role, Values, VertexId};
use serde_json::{Value, json};

use super::*;
use crate::{Encoding, Format, Loss, LossKind, Material, Picture, Prepared, WriteOptions};

/// Some triangles over points on a parabola.
fn mesh(vertices: usize, triangles: &[[u32; 3]]) -> PolygonMesh {
    let corners = triangles.as_flattened().iter().map(|&vertex| VertexId(vertex)).collect();
    let points = (0..vertices).map(|x| [x as f64, (x * x) as f64, 0.0]).collect();
    PolygonMesh::new(points, FaceTable::triangles(vertices, corners).unwrap()).unwrap()
}

fn layer(name: &str, domain: Domain, width: usize, values: Values, uses: &[u32]) -> Layer {
    Layer::indexed(name, domain, width, Carry::Copy, values, uses.to_vec())
}

fn names(name: &str, pool: &[&str], uses: &[u32]) -> Layer {
    let pool = pool.iter().map(|name| name.as_bytes().to_vec()).collect();
    layer(name, Domain::Face, 1, Values::Text(pool), uses)
}

fn direct(name: &str, role: Role, width: usize, values: Values) -> Layer {
    Layer::direct(name, Domain::Vertex, width, Carry::Copy, values).with_role(role)
}

/// What is written of a mesh.
struct Written {
    json: Value,
    bytes: Vec<u8>,
    losses: Vec<Loss>,
    mesh: PolygonMesh,
}

impl Written {
    fn of(mesh: &PolygonMesh) -> Self {
        Written::with(mesh, WriteOptions::of(Format::Toy))
    }

    fn with(mesh: &PolygonMesh, options: WriteOptions) -> Self {
        let mut prepared = Prepared::as_given(mesh, Format::Toy, Encoding::LittleEndian, options);
        prepare(&mut prepared).unwrap();
        let mut glb = Vec::new();
        encode_glb(&prepared, &mut glb).unwrap();
        let number = |at: usize| u32::from_le_bytes(glb[at..at + 4].try_into().unwrap()) as usize;
        assert_eq!((&glb[..4], number(4), number(8)), (&b"glTF"[..], 2, glb.len()));
        let end = 20 + number(12);
        let json = serde_json::from_slice(&glb[20..end]).unwrap();
        let bytes = glb.get(end + 8..).unwrap_or_default().to_vec();
        assert!(end.is_multiple_of(4) && bytes.len().is_multiple_of(4));
        let mut losses = prepared.losses.clone();
        losses.extend(super::losses(&prepared));
        let written = Written { json, bytes, losses, mesh: prepared.mesh.clone() };
        written.check_text(&prepared);
        written
    }

    /// The text has the same JSON but for the URI, which has the same bytes.
    fn check_text(&self, prepared: &Prepared) {
        let mut text = Vec::new();
        encode_gltf(prepared, &mut text).unwrap();
        let mut json: Value = serde_json::from_slice(&text).unwrap();
        if let Some(buffer) = json.pointer_mut("/buffers/0") {
            let uri = buffer.as_object_mut().unwrap().remove("uri").unwrap();
            let digits = uri.as_str().unwrap().strip_prefix("data:application/octet-stream;base64,").unwrap();
            assert_eq!(digits.len(), self.bytes.len().div_ceil(3) * 4);
        }
        assert_eq!(json, self.json);
    }

    /// The bytes of an accessor.
    fn accessor(&self, at: usize) -> &[u8] {
        let view = &self.json["bufferViews"][at];
        let [offset, length] = ["byteOffset", "byteLength"].map(|key| view[key].as_u64().unwrap() as usize);
        &self.bytes[offset..offset + length]
    }

    /// The single-precision numbers of an attribute of the first primitive.
    fn singles(&self, semantic: &str) -> Vec<f32> {
        let at = self.json["meshes"][0]["primitives"][0]["attributes"][semantic].as_u64().unwrap();
        let bytes = self.accessor(at as usize).chunks_exact(4);
        bytes.map(|bytes| f32::from_le_bytes(bytes.try_into().unwrap())).collect()
    }

    fn lost(&self) -> Vec<LossKind> {
        self.losses.iter().map(|loss| loss.kind).collect()
    }

    fn messages(&self) -> Vec<&str> {
        self.losses.iter().map(|loss| &loss.message[..]).collect()
    }
}

#[test]
fn a_triangle_is_one_node_with_one_mesh() {
    let written = Written::of(&mesh(3, &[[0, 1, 2]]));
    let expected = json!({
        "asset": {"version": "2.0", "generator": "meshmend"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0.0, 0.0, 0.0],
                "max": [2.0, 4.0, 0.0]},
            {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": 36, "target": 34962},
            {"buffer": 0, "byteOffset": 36, "byteLength": 6, "target": 34963},
        ],
        "buffers": [{"byteLength": 44}],
    });
    assert_eq!((written.json.clone(), written.losses.len()), (expected, 0));
    assert_eq!(written.singles("POSITION"), [0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 2.0, 4.0, 0.0]);
    assert_eq!(written.accessor(1), [0, 0, 1, 0, 2, 0]);
}

#[test]
fn a_file_without_vertices_has_no_mesh_as_nothing_in_it_may_be_empty() {
    let written = Written::of(&mesh(0, &[]));
    assert_eq!(written.json, json!({"asset": {"version": "2.0", "generator": "meshmend"}}));
    assert_eq!(written.losses, []);
}

#[test]
fn vertices_alone_are_points_and_loose_elements_are_lines_and_points() {
    let cloud = Written::of(&mesh(2, &[]));
    assert_eq!(cloud.json["meshes"][0]["primitives"], json!([{"attributes": {"POSITION": 0}, "mode": 0}]));
    let loose =
        mesh(5, &[[0, 1, 2]]).with_loose(vec![[VertexId(3), VertexId(0)]], vec![VertexId(4)]).unwrap();
    let loose = Written::of(&loose);
    let modes: Vec<Option<u64>> = loose.json["meshes"][0]["primitives"]
        .as_array()
        .unwrap()
        .iter()
        .map(|p| p["mode"].as_u64())
        .collect();
    assert_eq!((modes, loose.losses.len()), (vec![None, Some(1), Some(0)], 0));
    assert_eq!((loose.accessor(2), loose.accessor(3)), (&[3, 0, 0, 0][..], &[4, 0][..]));
}

#[test]
fn objects_are_nodes_with_vertices_of_their_own_and_materials_are_primitives() {
    let mesh = mesh(5, &[[0, 1, 2], [2, 1, 3], [0, 2, 1], [1, 2, 4]]);
    let objects = names("object", &["one", "two", "two"], &[0, 1, 0, 2]);
    let materials = names("material", &["red", "blue", "red"], &[0, u32::MAX, 1, 2]);
    let written = Written::of(&mesh.with_layers(vec![objects, materials]).unwrap());
    let named: Vec<&Value> =
        written.json["nodes"].as_array().unwrap().iter().map(|node| &node["name"]).collect();
    assert_eq!(named, ["one", "two", "two"]);
    assert_eq!(written.json["materials"], json!([{"name": "red"}, {"name": "blue"}]));
    let meshes = &written.json["meshes"];
    let materials: Vec<Vec<&Value>> = meshes
        .as_array()
        .unwrap()
        .iter()
        .map(|mesh| {
            mesh["primitives"].as_array().unwrap().iter().map(|primitive| &primitive["material"]).collect()
        })
        .collect();
    assert_eq!(materials, [vec![&json!(0), &json!(1)], vec![&Value::Null], vec![&json!(0)]]);
    let shared = meshes[0]["primitives"].as_array().unwrap();
    assert_eq!(shared[0]["attributes"], shared[1]["attributes"]);
    let corners: Vec<u32> = written.mesh.faces().corner_vertices().iter().map(|vertex| vertex.0).collect();
    assert_eq!(corners, [0, 1, 2, 0, 2, 1, 4, 3, 5, 6, 7, 8]);
    assert_eq!(written.lost(), [LossKind::SeamVertices, LossKind::Material]);
    assert_eq!(written.losses[1].message, "what 2 materials look like: no file describes them");
    assert!(
        written.losses[0].message.starts_with("2 vertices are written 6 times, as several objects use them")
    );
}

#[test]
fn loose_elements_beside_several_objects_are_a_mesh_of_their_own() {
    let mesh =
        mesh(6, &[[0, 1, 2], [3, 4, 5]]).with_loose(vec![[VertexId(5), VertexId(2)]], Vec::new()).unwrap();
    let written = Written::of(&mesh.with_layers(vec![names("object", &["a", "b"], &[0, 1])]).unwrap());
    assert_eq!(
        written.json["nodes"],
        json!([{"mesh": 0}, {"name": "a", "mesh": 1}, {"name": "b", "mesh": 2}])
    );
    assert_eq!(written.json["meshes"][0]["primitives"][0]["mode"], 1);
    let edges = written.json["meshes"][0]["primitives"][0]["indices"].as_u64().unwrap();
    assert_eq!(written.accessor(edges as usize), [1, 0, 0, 0]);
}

#[test]
fn what_the_format_can_not_hold_is_left_out_and_named() {
    let polygons =
        FaceTable::polygons(5, vec![0, 2, 5, 8], [0, 1, 0, 1, 2, 0, 1, 3].map(VertexId).to_vec()).unwrap();
    let points = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, f64::NAN, 0.0], [1e300, 0.0, 0.0]];
    let written = Written::of(&PolygonMesh::new(points, polygons).unwrap());
    assert_eq!(written.mesh.counts().faces, 1);
    let lost = written.lost();
    for kind in [LossKind::ShortFaces, LossKind::NonFiniteFaces, LossKind::UnusedVertices] {
        assert!(lost.contains(&kind), "{kind:?} {lost:?}");
    }
}

#[test]
fn attributes_have_the_names_and_types_of_the_format() {
    let mesh = mesh(3, &[[0, 1, 2]]).with_layers(vec![
        direct("normal", Role::Normal, 3, Values::F64([0.0, 0.0, 1.0].repeat(3))),
        direct("texcoord", Role::TexCoord, 2, Values::F32(vec![0.5; 6])),
        direct("texcoord_1", Role::TexCoord, 3, Values::F64([0.25, 0.5, 0.0].repeat(3))),
        direct("color", Role::Color, 3, Values::U8(vec![1, 2, 3, 4, 5, 6, 7, 8, 9])),
        direct("quality", Role::Plain, 1, Values::F64(vec![0.0, 0.5, 1.0])),
        direct("label", Role::Plain, 1, Values::I32(vec![1, 2, 3])),
        direct("_FEATURE_ID_0", Role::Plain, 1, Values::U16(vec![1, 2, 3])),
        direct("wide", Role::Plain, 5, Values::F32(vec![0.0; 15])),
        direct("weights", Role::Weights(0), 4, Values::F32(vec![0.25; 12])),
    ]);
    let written = Written::of(&mesh.unwrap());
    let attributes = &written.json["meshes"][0]["primitives"][0]["attributes"];
    let expected = json!({"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2, "TEXCOORD_1": 3, "COLOR_0": 4, "_quality": 5,
        "_label": 6, "_FEATURE_ID_0": 7});
    assert_eq!(attributes, &expected);
    let types: Vec<u64> = written.json["accessors"]
        .as_array()
        .unwrap()
        .iter()
        .map(|a| a["componentType"].as_u64().unwrap())
        .collect();
    assert_eq!(types, [5126, 5126, 5126, 5126, 5121, 5126, 5126, 5123, 5123]);
    assert_eq!(
        (&written.json["accessors"][4]["normalized"], &written.json["bufferViews"][4]["byteStride"]),
        (&json!(true), &json!(4))
    );
    assert_eq!(written.accessor(4), [1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 9, 0]);
    assert_eq!(written.accessor(7), [1, 0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0]);
    assert_eq!(
        written.messages(),
        [
            "the third number, 0, of 3 texture coordinates",
            "3 numbers of `label` kept in single precision, not as integers",
            "vertex attribute `wide` of 3 vertices",
            "vertex attribute `weights` of 3 vertices",
        ]
    );
}

#[test]
fn a_vertex_without_a_value_gets_one_and_values_are_those_that_the_format_allows() {
    let none = u32::MAX;
    let normals = vec![0.0, 0.0, 2.0, 0.0, 0.0, 0.0, f64::NAN, 0.0, 0.0];
    let mesh = mesh(4, &[[0, 1, 2], [0, 1, 3]]).with_layers(vec![
        layer("normal", Domain::Vertex, 3, Values::F64(normals), &[0, 1, 2, none]).with_role(Role::Normal),
        layer("texcoord", Domain::Vertex, 2, Values::F32(vec![0.5; 2]), &[0, 0, none, 0])
            .with_role(Role::TexCoord),
        layer("color", Domain::Vertex, 3, Values::F32(vec![0.5; 3]), &[none, 0, 0, 0]).with_role(Role::Color),
        direct("bright", Role::Color, 3, Values::F32([2.0, 0.5, f32::INFINITY].repeat(4))),
        direct("quality", Role::Plain, 1, Values::F32(vec![f32::NAN, 1.0, 2.0, 3.0])),
    ]);
    let written = Written::of(&mesh.unwrap());
    assert_eq!(written.singles("NORMAL"), [0.0, 0.0, 1.0].repeat(4));
    assert_eq!(written.singles("TEXCOORD_0"), [0.5, 0.5, 0.5, 0.5, 0.0, 0.0, 0.5, 0.5]);
    assert_eq!(written.singles("COLOR_0")[..6], [1.0, 1.0, 1.0, 0.5, 0.5, 0.5]);
    assert_eq!(written.singles("_bright")[..3], [2.0, 0.5, 0.0]);
    assert_eq!(written.singles("_quality"), [0.0, 1.0, 2.0, 3.0]);
    assert_eq!(
        written.messages(),
        [
            "1 value of `normal` is given unit length",
            "2 values of `normal` have no direction: those of faces are written",
            "4 numbers of `bright` that are not finite: written as 0",
            "1 number of `quality` that is not finite: written as 0",
            "that 1 vertex has no vertex attribute `normal`",
            "that 1 vertex has no vertex attribute `texcoord`",
            "that 1 vertex has no vertex attribute `color`",
        ]
    );
}

#[test]
fn a_vertex_whose_corners_differ_is_written_for_each() {
    let uv = layer("texcoord", Domain::Corner, 2, Values::F64(vec![0.0, 0.0, 1.0, 1.0]), &[0, 0, 0, 1, 0, 0]);
    let mesh = mesh(4, &[[0, 1, 2], [0, 2, 3]]).with_layers(vec![uv.with_role(Role::TexCoord)]).unwrap();
    let written = Written::of(&mesh);
    assert_eq!((written.mesh.counts().vertices, written.lost()), (5, vec![LossKind::SeamVertices]));
}

#[test]
fn indices_are_as_wide_as_the_vertices_need() {
    let triangle_over = |vertices: usize| {
        let written = Written::of(
            &mesh(vertices, &[[0, 1, 2]])
                .with_loose(Vec::new(), (0..vertices as u32).map(VertexId).collect())
                .unwrap(),
        );
        written.json["accessors"][1]["componentType"].as_u64().unwrap()
    };
    assert_eq!((triangle_over(65_535), triangle_over(65_536)), (5123, 5125));
}

#[test]
fn a_name_is_text_and_that_of_the_only_solid_is_the_nodes() {
    let statement = |value: &[u8]| vec![Metadata { key: "solid".to_owned(), value: value.to_vec() }];
    let solid = Written::of(&mesh(3, &[[0, 1, 2]]).with_metadata(statement(b"part \"a\"")));
    assert_eq!((&solid.json["nodes"][0]["name"], solid.losses.len()), (&json!("part \"a\""), 0));
    let other = Written::of(&mesh(3, &[[0, 1, 2]]).with_metadata(statement(b"\xff")));
    assert_eq!((&other.json["nodes"][0]["name"], other.lost()), (&json!("\u{fffd}"), vec![LossKind::Names]));
}

/// A picture that is a PNG as far as its first bytes tell.
fn picture(name: &str) -> Picture {
    Picture::Embedded { name: name.to_owned(), bytes: b"\x89PNG\r".as_slice().into() }
}

fn with_materials(materials: Vec<Material>) -> Written {
    let mesh = mesh(3, &[[0, 1, 2]]).with_layers(vec![names("material", &["red"], &[0])]).unwrap();
    Written::with(&mesh, WriteOptions::of(Format::Toy).with_materials(materials))
}

#[test]
fn a_material_says_what_its_description_says() {
    let red = Material {
        base_color: Some([1.0, 0.5, 2.0]),
        opacity: Some(0.25),
        base_map: Some(picture("map")),
        normal_map: Some(Picture::File(b"maps\\my n.png".to_vec())),
        emissive_map: Some(picture("map")),
        roughness: Some(0.5),
        others: ["Ks", "Ns", "Ks"].map(str::to_owned).to_vec(),
        ..Material::named("red")
    };
    let written = with_materials(vec![red, Material::named("red"), Material::named("blue")]);
    let expected = json!([{
        "name": "red",
        "pbrMetallicRoughness": {
            "baseColorFactor": [1.0, 0.5, 1.0, 0.25], "baseColorTexture": {"index": 0}, "metallicFactor": 0.0,
            "roughnessFactor": 0.5,
        },
        "normalTexture": {"index": 1},
        "emissiveTexture": {"index": 0},
        "emissiveFactor": [1.0, 1.0, 1.0],
        "alphaMode": "BLEND",
    }]);
    assert_eq!(written.json["materials"], expected);
    assert_eq!(written.json["textures"], json!([{"source": 0}, {"source": 1}]));
    let images =
        json!([{"name": "map", "bufferView": 2, "mimeType": "image/png"}, {"uri": "maps/my%20n.png"}]);
    assert_eq!(written.json["images"], images);
    assert_eq!(
        (written.accessor(2), written.json["accessors"].as_array().unwrap().len()),
        (&b"\x89PNG\r"[..], 2)
    );
    let expected = [
        "1 described material that no face uses",
        "1 factor of materials beyond 0 to 1: written as the nearest one within",
        "3 statements about materials that glTF has no word for: `Ks`, `Ns`",
    ];
    assert_eq!(written.messages(), expected);
}

#[test]
fn a_picture_that_is_neither_png_nor_jpeg_is_left_out() {
    let other = Picture::Embedded { name: "map".to_owned(), bytes: b"BM".as_slice().into() };
    let written = with_materials(vec![Material { base_map: Some(other), ..Material::named("red") }]);
    assert!(written.json.get("images").is_none() && written.json.get("textures").is_none());
    assert_eq!(written.messages(), ["the picture `map`, which is neither PNG nor JPEG"]);
}
