//! What a change of a mesh does to the file: the rules, each on a small file made here.

use meshmend_core::{Draft, FaceId, FaceTable, PolygonMesh, Sources, VertexId};
use meshmend_io::{Document, Format, Loss, LossKind, NoteKind, PreparedDocument, WriteOptions};
use serde_json::{Value, json};

use crate::gltf_splice::read;

/// A file that is put together.
#[derive(Default)]
struct File {
    bytes: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
}

impl File {
    fn view(&mut self, bytes: &[u8], more: Value) -> usize {
        let mut view = json!({"buffer": 0, "byteOffset": self.bytes.len(), "byteLength": bytes.len()});
        view.as_object_mut().unwrap().extend(more.as_object().unwrap().clone());
        self.bytes.extend(bytes);
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        self.views.push(view);
        self.views.len() - 1
    }

    fn accessor(&mut self, view: usize, component: u32, kind: &str, count: usize, more: Value) -> usize {
        let mut accessor =
            json!({"bufferView": view, "componentType": component, "type": kind, "count": count});
        accessor.as_object_mut().unwrap().extend(more.as_object().unwrap().clone());
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }

    fn floats(&mut self, numbers: &[f32], kind: &str, width: usize) -> usize {
        let bytes: Vec<u8> = numbers.iter().flat_map(|x| x.to_le_bytes()).collect();
        let view = self.view(&bytes, json!({}));
        self.accessor(view, 5126, kind, numbers.len() / width, json!({}))
    }

    fn indices(&mut self, indices: &[u8]) -> usize {
        let view = self.view(indices, json!({}));
        self.accessor(view, 5121, "SCALAR", indices.len(), json!({}))
    }

    /// The file with these meshes and further members.
    fn text(&self, meshes: Value, more: Value) -> Vec<u8> {
        let uri = format!("data:application/octet-stream;base64,{}", base64(&self.bytes));
        let mut json = json!({
            "asset": {"version": "2.0"}, "meshes": meshes, "accessors": self.accessors,
            "bufferViews": self.views, "buffers": [{"byteLength": self.bytes.len(), "uri": uri}],
        });
        json.as_object_mut().unwrap().extend(more.as_object().unwrap().clone());
        serde_json::to_vec_pretty(&json).unwrap()
    }
}

fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let three = |three: &[u8]| {
        let bits =
            three.iter().chain([&0, &0]).take(3).fold(0_u32, |bits, &byte| bits << 8 | u32::from(byte));
        let digit = |place: u32| char::from(DIGITS[(bits >> (18 - 6 * place)) as usize & 63]);
        (0..4).map(|place| if place as usize > three.len() { '=' } else { digit(place) }).collect::<String>()
    };
    bytes.chunks(3).map(three).collect()
}

/// The points of a strip of squares: two rows of so many.
fn strip_points(count: usize) -> Vec<f32> {
    (0..count * 2).flat_map(|at| [(at / 2) as f32, (at % 2) as f32, 0.0]).collect()
}

/// Two triangles for each square of a strip.
fn strip_indices(count: usize) -> Vec<u8> {
    (0..count as u8 - 1).flat_map(|at| [0, 2, 1, 1, 2, 3].map(|corner| at * 2 + corner)).collect()
}

/// A mesh with these of its faces.
fn with_faces(mesh: &PolygonMesh, faces: impl IntoIterator<Item = u32>) -> PolygonMesh {
    let old = mesh.faces();
    let faces: Vec<FaceId> = faces.into_iter().map(FaceId).collect();
    let corners: Vec<_> = faces.iter().flat_map(|&face| old.face_corners(face)).collect();
    let vertices = corners.iter().map(|&corner| old.corner_vertex(corner)).collect();
    let draft = Draft::of_faces(
        mesh,
        FaceTable::triangles(old.vertex_count(), vertices).unwrap(),
        Sources::listed(faces.into_iter().map(Some)),
        Sources::listed(corners.into_iter().map(Some)),
    );
    without_unused(&mesh.rebuild(draft).unwrap().0)
}

/// A mesh without vertices that no face uses.
fn without_unused(mesh: &PolygonMesh) -> PolygonMesh {
    let faces = mesh.faces();
    let mut is_used = vec![false; faces.vertex_count()];
    faces.corner_vertices().iter().for_each(|vertex| is_used[vertex.0 as usize] = true);
    let kept: Vec<VertexId> =
        (0..is_used.len() as u32).map(VertexId).filter(|vertex| is_used[vertex.0 as usize]).collect();
    let number = |vertex: &VertexId| VertexId(kept.binary_search(vertex).unwrap() as u32);
    let vertices = faces.corner_vertices().iter().map(number).collect();
    let draft = Draft {
        vertex_sources: Sources::listed(kept.iter().map(|&vertex| Some(vertex))),
        ..Draft::of_faces(
            mesh,
            FaceTable::triangles(kept.len(), vertices).unwrap(),
            Sources::same(faces.face_count()),
            Sources::same(faces.corner_count()),
        )
    };
    mesh.rebuild(draft).unwrap().0
}

/// The JSON that is written, and what is said.
fn written(document: &Document) -> (Value, Vec<Loss>) {
    let prepared = PreparedDocument::new(document, &WriteOptions::of(Format::Gltf)).unwrap();
    let mut bytes = Vec::new();
    prepared.encode(&mut bytes).unwrap();
    // What is written can be read.
    read(&bytes, "again");
    (serde_json::from_slice(&bytes).unwrap(), prepared.losses())
}

/// What the file becomes when the first mesh has these of its faces.
fn cut(file: &[u8], faces: impl IntoIterator<Item = u32>) -> (Value, Vec<Loss>) {
    let document = read(file, "file");
    let mesh = with_faces(&document.parts[0].mesh, faces);
    written(&document.with_mesh(0, mesh))
}

fn kinds(losses: &[Loss]) -> Vec<LossKind> {
    losses.iter().map(|loss| loss.kind).collect()
}

#[test]
fn rows_that_no_face_uses_go_and_their_bytes_with_them() {
    let mut file = File::default();
    let position = file.floats(&strip_points(4), "VEC3", 3);
    let kept = file.view(b"for a picture", json!({"name": "kept"}));
    let indices = file.indices(&strip_indices(4));
    let meshes = json!([{"primitives": [{"attributes": {"POSITION": position}, "indices": indices}]}]);
    let text = file.text(meshes, json!({"images": [{"bufferView": kept, "mimeType": "image/png"}]}));
    let (json, losses) = cut(&text, 2..6);
    assert_eq!(losses, []);
    assert_eq!(json["meshes"], serde_json::from_slice::<Value>(&text).unwrap()["meshes"]);
    assert_eq!(json["accessors"][0]["count"], 6);
    assert_eq!(json["accessors"][0]["min"], json!([1, 0, 0]));
    assert_eq!(
        (&json["accessors"][1]["count"], &json["accessors"][1]["componentType"]),
        (&json!(12), &json!(5121))
    );
    assert_eq!(json["bufferViews"].as_array().unwrap().len(), 3);
    assert_eq!(
        (&json["bufferViews"][1]["byteOffset"], &json["bufferViews"][1]["name"]),
        (&json!(0), &json!("kept"))
    );
    // The picture, padded, the positions and the indices.
    assert_eq!(json["buffers"][0]["byteLength"], 16 + 6 * 12 + 12);
}

#[test]
fn accessors_that_others_name_stay_and_new_ones_follow_at_the_end() {
    let mut file = File::default();
    let position = file.floats(&strip_points(4), "VEC3", 3);
    let indices = file.indices(&strip_indices(4));
    let primitive = json!({"attributes": {"POSITION": position}, "indices": indices});
    let one = json!({"primitives": [primitive]});
    let text = file.text(json!([one, one]), json!({}));
    let (json, losses) = cut(&text, 2..6);
    assert_eq!(losses, []);
    assert_eq!(json["accessors"].as_array().unwrap().len(), 4);
    assert_eq!(json["meshes"][1], one);
    let changed = &json["meshes"][0]["primitives"][0];
    assert_eq!((&changed["attributes"]["POSITION"], &changed["indices"]), (&json!(2), &json!(3)));
    // So do they where an extension that nobody knows may name them.
    let text = file.text(json!([one]), json!({"extensionsUsed": ["ACME_unknown"]}));
    let (json, _) = cut(&text, 2..6);
    let old: Value = serde_json::from_slice(&text).unwrap();
    assert_eq!(json["accessors"].as_array().unwrap()[..2], old["accessors"].as_array().unwrap()[..]);
    assert_eq!(json["bufferViews"].as_array().unwrap()[..2], old["bufferViews"].as_array().unwrap()[..]);
    assert_eq!(json["meshes"][0]["primitives"][0]["attributes"]["POSITION"], 2);
}

#[test]
fn interleaved_rows_stay_interleaved() {
    let mut file = File::default();
    let rows: Vec<u8> = strip_points(4)
        .chunks(3)
        .enumerate()
        .flat_map(|(at, point)| {
            point.iter().copied().chain([at as f32, 0.5]).flat_map(f32::to_le_bytes).collect::<Vec<_>>()
        })
        .collect();
    let view = file.view(&rows, json!({"byteStride": 20}));
    let position = file.accessor(view, 5126, "VEC3", 8, json!({}));
    let uv = file.accessor(view, 5126, "VEC2", 8, json!({"byteOffset": 12}));
    let indices = file.indices(&strip_indices(4));
    let attributes = json!({"POSITION": position, "TEXCOORD_0": uv});
    let text =
        file.text(json!([{"primitives": [{"attributes": attributes, "indices": indices}]}]), json!({}));
    let (json, losses) = cut(&text, 2..6);
    assert_eq!(losses, []);
    assert_eq!(
        (&json["bufferViews"][0]["byteStride"], &json["bufferViews"][0]["byteLength"]),
        (&json!(20), &json!(120))
    );
    assert_eq!(
        (&json["accessors"][1]["byteOffset"], &json["accessors"][1]["bufferView"]),
        (&json!(12), &json!(0))
    );
}

#[test]
fn strips_fans_and_rows_without_indices_become_lists() {
    let mut file = File::default();
    let position = file.floats(&strip_points(3), "VEC3", 3);
    let indices = file.indices(&[0, 1, 2, 3, 4, 5]);
    for (mode, more) in
        [(5, json!({"indices": indices})), (6, json!({"indices": indices})), (5, json!({})), (4, json!({}))]
    {
        let mut primitive = json!({"attributes": {"POSITION": position}, "mode": mode});
        primitive.as_object_mut().unwrap().extend(more.as_object().unwrap().clone());
        let text = file.text(json!([{"primitives": [primitive]}]), json!({}));
        let (json, losses) = cut(&text, [1]);
        assert_eq!(kinds(&losses), [LossKind::Converted], "{mode}");
        let primitive = &json["meshes"][0]["primitives"][0];
        assert_eq!(primitive["mode"], 4);
        let indices = primitive["indices"].as_u64().unwrap() as usize;
        assert_eq!(json["accessors"][indices]["count"], 3);
    }
}

#[test]
fn the_type_of_indices_grows_where_it_must() {
    let mut file = File::default();
    let points: Vec<f32> = (0..255).flat_map(|at| [at as f32, (at % 7) as f32, (at % 11) as f32]).collect();
    let position = file.floats(&points, "VEC3", 3);
    let corners: Vec<u8> = (0..253).flat_map(|at| [at, at + 1, at + 2]).collect();
    let indices = file.indices(&corners);
    let text = file.text(
        json!([{"primitives": [{"attributes": {"POSITION": position}, "indices": indices}]}]),
        json!({}),
    );
    let document = read(&text, "file");
    // A vertex comes apart: there are 256 rows, and 255 is no index.
    let mesh = &document.parts[0].mesh;
    let mut vertices = mesh.faces().corner_vertices().to_vec();
    vertices[3] = VertexId(255);
    let sources = (0..255).map(|vertex| Some(VertexId(vertex))).chain([Some(VertexId(1))]);
    let draft = Draft {
        vertex_sources: Sources::listed(sources),
        ..Draft::of_faces(
            mesh,
            FaceTable::triangles(256, vertices).unwrap(),
            Sources::same(253),
            Sources::same(759),
        )
    };
    let split = mesh.rebuild(draft).unwrap().0;
    let (json, losses) = written(&document.clone().with_mesh(0, split));
    assert_eq!(kinds(&losses), [LossKind::SharedVertices]);
    assert_eq!(json["accessors"][1]["componentType"], 5123);
    assert_eq!(json["accessors"][0]["count"], 256);
}

#[test]
fn points_and_lines_keep_their_rows() {
    let mut file = File::default();
    let position = file.floats(&strip_points(4), "VEC3", 3);
    let indices = file.indices(&strip_indices(3));
    let lines = file.indices(&[0, 7]);
    let attributes = json!({"POSITION": position});
    let primitives = json!([
        {"attributes": attributes, "indices": indices},
        {"attributes": attributes, "indices": lines, "mode": 1},
    ]);
    let text = file.text(json!([{"primitives": primitives}]), json!({}));
    let document = read(&text, "file");
    assert!(document.notes.iter().any(|note| note.kind == NoteKind::SkippedElement));
    // Row 7 is used by the line alone, row 6 by nothing.
    assert_eq!(document.parts[0].mesh.counts().vertices, 7);
    let (json, _) = cut(&text, 2..4);
    assert_eq!(json["accessors"][0]["count"], 6);
    assert_eq!(json["meshes"][0]["primitives"][1]["indices"], 2);
    assert_eq!(json["accessors"][2]["count"], 2);
}

#[test]
fn a_primitive_without_faces_goes_and_a_mesh_does_not() {
    let mut file = File::default();
    let position = file.floats(&strip_points(4), "VEC3", 3);
    let [one, other] = [&[0, 2, 1][..], &[1, 2, 3]].map(|indices| file.indices(indices));
    let of =
        |indices: usize| json!({"attributes": {"POSITION": position}, "indices": indices, "material": 0});
    let meshes = json!([{"name": "Body", "primitives": [of(one), of(other)]}]);
    let text = file.text(meshes, json!({"materials": [{"name": "Steel"}]}));
    let (json, losses) = cut(&text, [1]);
    assert_eq!(kinds(&losses), [LossKind::EmptiedName]);
    let said = "primitive 0 of mesh 0 `Body`, of material `Steel`, has no face left and is left out";
    assert_eq!(losses[0].message, said);
    assert_eq!(json["meshes"][0]["primitives"].as_array().unwrap().len(), 1);
    let (same, losses) = cut(&text, []);
    assert_eq!(same, serde_json::from_slice::<Value>(&text).unwrap());
    assert_eq!(losses[0].message, "mesh 0 `Body` stays as it was, as no face of it would be left");
}

#[test]
fn triangles_of_polygons_are_no_polygons_any_more_where_they_changed() {
    let mut file = File::default();
    let position = file.floats(&strip_points(4), "VEC3", 3);
    let indices = file.indices(&strip_indices(4));
    let primitive = json!({
        "attributes": {"POSITION": position}, "indices": indices, "extensions": {"FB_ngon_encoding": {}},
    });
    let text =
        file.text(json!([{"primitives": [primitive]}]), json!({"extensionsUsed": ["FB_ngon_encoding"]}));
    let (json, _) = cut(&text, 1..6);
    assert!(
        json.get("extensionsUsed").is_none()
            && json["meshes"][0]["primitives"][0].get("extensions").is_none()
    );
}

#[test]
fn sparse_and_quantised_rows_are_read_and_written_as_plain_ones() {
    let mut file = File::default();
    let bytes: Vec<u8> = strip_points(4).iter().flat_map(|x| (*x as i16).to_le_bytes()).collect();
    let padded: Vec<u8> = bytes.chunks(6).flat_map(|row| [row, &[0, 0]].concat()).collect();
    let view = file.view(&padded, json!({"byteStride": 8}));
    let [rows, values] = [file.view(&[7], json!({})), file.view(&[9, 0, 1, 0, 5, 0], json!({}))];
    let sparse = json!({
        "count": 1, "indices": {"bufferView": rows, "componentType": 5121}, "values": {"bufferView": values},
    });
    let position = file.accessor(view, 5122, "VEC3", 8, json!({"sparse": sparse}));
    let indices = file.indices(&strip_indices(4));
    let text = file.text(
        json!([{"primitives": [{"attributes": {"POSITION": position}, "indices": indices}]}]),
        json!({"extensionsUsed": ["KHR_mesh_quantization"]}),
    );
    assert_eq!(read(&text, "file").parts[0].mesh.positions()[7], [9.0, 1.0, 5.0]);
    let (json, losses) = cut(&text, 2..6);
    assert_eq!(losses, []);
    let accessor = &json["accessors"][0];
    assert!(accessor.get("sparse").is_none());
    assert_eq!((&accessor["count"], &accessor["max"]), (&json!(6), &json!([9, 1, 5])));
    assert_eq!(json["bufferViews"][0]["byteStride"], 8);
}

#[test]
fn compressed_meshes_are_sealed_and_all_others_served() {
    let mut file = File::default();
    let position = file.floats(&strip_points(4), "VEC3", 3);
    let indices = file.indices(&strip_indices(4));
    let plain = json!({"primitives": [{"attributes": {"POSITION": position}, "indices": indices}]});
    for extension in ["KHR_draco_mesh_compression", "ACME_faces", "KHR_gaussian_splatting"] {
        let mut sealed = plain.clone();
        sealed["primitives"][0]["extensions"] = json!({extension: {"bufferView": 0}});
        let text = file.text(json!([plain, sealed]), json!({"extensionsUsed": [extension]}));
        let document = read(&text, "file");
        assert!(document.parts[0].seal().is_none());
        assert!(document.parts[1].seal().unwrap().contains(extension), "{:?}", document.parts[1].status);
        let (json, _) = cut(&text, 2..6);
        assert_eq!(json["meshes"][1], sealed);
        let alone = file.text(json!([sealed]), json!({}));
        let refused = meshmend_io::read_document_bytes(&alone, "a.gltf", &Default::default()).unwrap_err();
        assert!(refused.to_string().contains(extension), "{refused}");
    }
}
