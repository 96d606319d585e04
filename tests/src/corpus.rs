//! The corpus of mesh files, and what its manifest says of each.

use std::path::{Path, PathBuf};

use meshmend_core::PolygonMesh;
use meshmend_io::{Format, Placing, ReadOptions, read_document};
use serde_json::Value;

use crate::shared::shared;

/// One file of the corpus with its manifest entry.
#[derive(Clone, Debug)]
pub struct Entry {
    /// The path within the corpus.
    pub name: String,
    /// The path on this system.
    pub path: PathBuf,
    /// The manifest entry.
    pub facts: Value,
}

impl Entry {
    /// Whether the file is in a format that meshmend reads.
    pub fn is_read_here(&self) -> bool {
        Format::from_path(Path::new(&self.name)).is_some()
    }

    /// Whether the file has to be read: all but the malformed ones.
    pub fn is_well_formed(&self) -> bool {
        self.facts.get("malformed").is_none()
    }

    /// What must become of a malformed file: `reject` or `either`.
    pub fn verdict(&self) -> Option<&str> {
        self.facts["malformed"]["verdict"].as_str()
    }

    /// The figures of a view, following `same as …`; nothing where the manifest has no such view.
    pub fn view(&self, name: &str) -> Option<&Value> {
        match self.facts["expected"].get(name)? {
            Value::String(other) => self.view(other.strip_prefix("same as ")?),
            figures => Some(figures),
        }
    }

    /// The mesh in the file; of a file of several meshes each once, in its own space, as the manifest has them.
    ///
    /// # Panics
    /// When it can't be read.
    pub fn mesh(&self) -> PolygonMesh {
        let read = read_document(&self.path, &ReadOptions::default());
        let document = read.unwrap_or_else(|error| panic!("{error}"));
        document.into_mesh(Placing::Parts).unwrap_or_else(|error| panic!("{error}")).mesh
    }
}

/// Every file of the corpus; nothing, and a message, where there is no corpus.
pub fn corpus() -> Option<Vec<Entry>> {
    let folder = shared("corpus")?;
    let text = std::fs::read_to_string(folder.join("manifest.json")).expect("the corpus has a manifest");
    let manifest: Value = serde_json::from_str(&text).expect("the manifest is JSON");
    let entry = |facts: &Value| {
        let name = facts["path"].as_str().expect("an entry has a path").to_owned();
        Entry { path: folder.join(&name), name, facts: facts.clone() }
    };
    Some(manifest["files"].as_array().expect("the manifest lists files").iter().map(entry).collect())
}
