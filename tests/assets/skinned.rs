//! A model with a skin, morph targets and a picture, pinched at a vertex: it is mended, and all round it stays.

use meshmend_core::Role;
use meshmend_io::Format;
use meshmend_tests::gltf_judges::validated;
use meshmend_tests::scratch::Scratch;
use serde_json::{Value, json};

use crate::documents::{document, repaired, stored, written};

/// Two tetrahedra that share their first vertex.
const POSITIONS: [[f32; 3]; 7] = [
    [0.0, 0.0, 0.0],
    [1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, 0.0, 1.0],
    [-1.0, 0.0, 0.0],
    [0.0, -1.0, 0.0],
    [0.0, 0.0, -1.0],
];
const FACES: [[u16; 3]; 8] =
    [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3], [0, 4, 5], [0, 6, 4], [0, 5, 6], [4, 6, 5]];

/// A GLB file of JSON and bytes.
fn glb(json: &Value, bytes: &[u8]) -> Vec<u8> {
    let mut text = serde_json::to_vec_pretty(json).unwrap();
    text.resize(text.len().next_multiple_of(4), b' ');
    let mut file = b"glTF\x02\0\0\0".to_vec();
    file.extend(((28 + text.len() + bytes.len()) as u32).to_le_bytes());
    file.extend((text.len() as u32).to_le_bytes());
    file.extend(b"JSON");
    file.extend(&text);
    file.extend((bytes.len() as u32).to_le_bytes());
    file.extend(b"BIN\0");
    file.extend(bytes);
    file
}

struct Builder {
    bytes: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
}

impl Builder {
    fn add(&mut self, bytes: Vec<u8>, count: usize, component: u32, kind: &str, more: Value) -> usize {
        self.views.push(json!({"buffer": 0, "byteOffset": self.bytes.len(), "byteLength": bytes.len()}));
        self.bytes.extend(bytes);
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        let mut accessor = json!({"bufferView": self.views.len() - 1, "componentType": component, "count": count, "type": kind});
        accessor.as_object_mut().unwrap().extend(more.as_object().unwrap().clone());
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }

    fn floats(&mut self, rows: &[&[f32]], kind: &str, more: Value) -> usize {
        let bytes = rows.iter().flat_map(|row| row.iter().flat_map(|x| x.to_le_bytes())).collect();
        self.add(bytes, rows.len(), 5126, kind, more)
    }
}

/// The model, with its JSON.
fn model() -> (Vec<u8>, Value) {
    let mut file = Builder { bytes: Vec::new(), views: Vec::new(), accessors: Vec::new() };
    let rows: Vec<&[f32]> = POSITIONS.iter().map(|row| &row[..]).collect();
    let bounds = json!({"min": [-1.0, -1.0, -1.0], "max": [1.0, 1.0, 1.0]});
    let position = file.floats(&rows, "VEC3", bounds);
    let uvs: Vec<[f32; 2]> = (0..7).map(|v| [v as f32 / 8.0, 0.25]).collect();
    let uvs = file.floats(&uvs.iter().map(|row| &row[..]).collect::<Vec<_>>(), "VEC2", json!({}));
    let joints = (0..7_u8).flat_map(|v| [v % 2, 0, 0, 0]).collect();
    let joints = file.add(joints, 7, 5121, "VEC4", json!({}));
    let weights = file.floats(&[&[1.0, 0.0, 0.0, 0.0][..]; 7], "VEC4", json!({}));
    let moved: Vec<[f32; 3]> = (0..7).map(|v| [0.0, 0.0, v as f32 / 16.0]).collect();
    let target_bounds = json!({"min": [0.0, 0.0, 0.0], "max": [0.0, 0.0, 0.375]});
    let target = file.floats(&moved.iter().map(|row| &row[..]).collect::<Vec<_>>(), "VEC3", target_bounds);
    let indices = FACES.iter().flatten().flat_map(|index| index.to_le_bytes()).collect();
    let indices = file.add(indices, 24, 5123, "SCALAR", json!({}));
    let unit = [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];
    let inverse = file.floats(&[&unit, &unit], "MAT4", json!({}));
    let times = file.floats(&[&[0.0], &[1.0]], "SCALAR", json!({"min": [0.0], "max": [1.0]}));
    let values = file.floats(&[&[0.0], &[1.0]], "SCALAR", json!({}));
    let primitive = json!({
        "attributes": {"POSITION": position, "TEXCOORD_0": uvs, "JOINTS_0": joints, "WEIGHTS_0": weights},
        "indices": indices, "material": 0, "targets": [{"POSITION": target}],
        "extras": {"precise": 12345678901234567890_u64},
    });
    let pixel = "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==";
    let json = json!({
        "asset": {"version": "2.0", "generator": "by hand"},
        "scene": 0, "scenes": [{"nodes": [0, 1]}],
        "nodes": [{"mesh": 0, "skin": 0}, {"children": [2], "translation": [0.1, 0.2, 0.30000000000000004]}, {}],
        "skins": [{"joints": [1, 2], "inverseBindMatrices": inverse}],
        "animations": [{
            "channels": [{"sampler": 0, "target": {"node": 0, "path": "weights"}}],
            "samplers": [{"input": times, "output": values}],
        }],
        "meshes": [{"name": "Body", "primitives": [primitive], "weights": [0.5]}],
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
        "textures": [{"source": 0}], "images": [{"uri": pixel}],
        "accessors": file.accessors, "bufferViews": file.views, "buffers": [{"byteLength": file.bytes.len()}],
    });
    (glb(&json, &file.bytes), json)
}

/// The JSON of a GLB file, and the bytes of its buffer.
fn parts_of(file: &[u8]) -> (Value, &[u8]) {
    let length = u32::from_le_bytes(file[12..16].try_into().unwrap()) as usize;
    (serde_json::from_slice(&file[20..20 + length]).unwrap(), &file[28 + length..])
}

/// The bytes of an accessor that stands alone in its view.
fn bytes_of<'a>(json: &Value, buffer: &'a [u8], accessor: &Value) -> &'a [u8] {
    let accessor = &json["accessors"][accessor.as_u64().unwrap() as usize];
    let view = &json["bufferViews"][accessor["bufferView"].as_u64().unwrap() as usize];
    let at = |name: &str| view[name].as_u64().unwrap_or(0) as usize;
    &buffer[at("byteOffset")..][..at("byteLength")]
}

#[test]
fn a_pinched_model_comes_apart_and_its_skin_nodes_and_animations_stay() {
    let (file, json) = model();
    let read = document(&file);
    assert!(read.parts[0].mesh.layers().iter().any(|layer| layer.role() == Role::MorphPosition(0)));
    assert!(written(&read, Format::Glb) == file);
    let (mended, records) = repaired(&read);
    assert!(records[0].as_ref().unwrap().topology.as_ref().unwrap().manifold);
    let written = written(&mended, Format::Glb);
    let (after, buffer) = parts_of(&written);
    for name in
        ["asset", "scene", "scenes", "nodes", "skins", "animations", "materials", "textures", "images"]
    {
        assert_eq!(after[name], json[name], "{name}");
    }
    let (old, new) = (&json["meshes"][0]["primitives"][0], &after["meshes"][0]["primitives"][0]);
    assert_eq!(old, new, "all accessors keep their slots");
    // The vertex in the middle is there twice, each with all that it had.
    let (_, stored) = parts_of(&file);
    for name in ["POSITION", "TEXCOORD_0", "JOINTS_0", "WEIGHTS_0"] {
        let accessor = &old["attributes"][name];
        let [before, after] = [bytes_of(&json, stored, accessor), bytes_of(&after, buffer, accessor)];
        let size = before.len() / 7;
        assert_eq!((&after[..before.len()], &after[before.len()..]), (before, &before[..size]), "{name}");
    }
    for accessor in [&json["skins"][0]["inverseBindMatrices"], &json!(7), &json!(8)] {
        assert_eq!(bytes_of(&json, stored, accessor), bytes_of(&after, buffer, accessor));
    }
    assert_eq!(after["accessors"][0]["count"], 8);
    let again = document(&written);
    assert!(again.parts[0].mesh.layers().iter().any(|layer| layer.role() == Role::Weights(0)));
    let scratch = Scratch::new();
    let files = [stored_at(&scratch, "in.glb", &file), stored_at(&scratch, "out.glb", &written)];
    let Some(answers) = validated(&files) else { return };
    assert_eq!(answers[0].errors, answers[1].errors);
    assert_eq!(answers[1].triangles, Some(8));
}

fn stored_at(scratch: &Scratch, name: &str, bytes: &[u8]) -> std::path::PathBuf {
    stored(scratch.path(), name, bytes)
}
