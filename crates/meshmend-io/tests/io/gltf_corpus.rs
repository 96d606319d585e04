//! glTF and GLB files of the shared folder: what is read, and what comes out when nothing or something changed.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use meshmend_io::{Place, ReadOptions, read_document};
use serde_json::Value;

use crate::common::shared;

fn is_gltf(path: &Path) -> bool {
    path.extension().is_some_and(|suffix| suffix == "glb" || suffix == "gltf")
}

pub(crate) fn entries(corpus: &Path) -> Vec<(PathBuf, Value)> {
    let text = std::fs::read_to_string(corpus.join("manifest.json")).unwrap();
    let manifest: Value = serde_json::from_str(&text).unwrap();
    let files = manifest["files"].as_array().unwrap().iter().cloned();
    let files = files.map(|entry| (corpus.join(entry["path"].as_str().unwrap()), entry));
    files.filter(|(path, _)| is_gltf(path)).collect()
}

#[test]
fn the_first_mistake_is_named_with_its_place() {
    let Some(corpus) = shared("corpus") else { return };
    let mut found = BTreeMap::new();
    for (path, _) in entries(&corpus) {
        if let Err(error) = read_document(&path, &ReadOptions::default()) {
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            assert_ne!(error.place, Place::File, "{error}");
            found.insert(name, error.to_string().rsplit_once(&*path.to_string_lossy()).unwrap().1.to_owned());
        }
    }
    for (name, expected) in [
        ("accessor_past_view.glb", ": /accessors/0: ends at byte 12144 of a view of 144"),
        ("index_past_end.glb", ": /accessors/1: index 59 is 12, but the primitive has 12 vertices"),
        ("node_cycle.glb", ": /nodes/0: is below itself: the nodes form a cycle"),
        ("bad_base64.gltf", ": /buffers/0/uri: is not base64 from its byte 0 on"),
        (
            "deep_json.gltf",
            ": line 1: 129 levels of JSON values are more than the limit of 128 (max_json_depth)",
        ),
        ("bad_magic.glb", ": byte 0: the header of a GLB file is not there"),
        ("no_such_buffer.glb", ": /bufferViews/0/buffer: buffer 7 does not exist: the last one is 0"),
    ] {
        assert_eq!(found.get(name).map(String::as_str), Some(expected), "{name}");
    }
}
