//! A file as a whole: its meshes, and what is round them.
//!
//! A file of OBJ, PLY, STL or OFF is one mesh. One of glTF or 3MF has several, and much that is not a mesh. A document
//! holds each mesh as a part, in its own space; its [shell](crate::Shell) holds the rest.

mod distinct_names;
mod material;
mod merged_layers;
mod placed;
mod placement;
mod prepared;

use std::sync::Arc;

use meshmend_core::PolygonMesh;

pub(crate) use self::distinct_names::DistinctNames;
pub(crate) use self::material::extension;
pub use self::material::{Material, Picture};
pub use self::placed::TooMuchPlaced;
pub use self::placement::{Placement, Placing};
pub use self::prepared::PreparedDocument;
use crate::{Format, Note, ReadFile, Shell};

/// A file as a whole.
///
/// ```
/// use meshmend_io::{ReadOptions, read_document_bytes};
///
/// let text = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
/// let document = read_document_bytes(text, "triangle.obj", &ReadOptions::default())?;
/// assert_eq!(document.parts.len(), 1);
/// assert_eq!(document.parts[0].mesh.counts().faces, 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Document {
    /// Its meshes, in file order.
    pub parts: Vec<Part>,
    /// The format of the file.
    pub format: Format,
    /// The format together with the encoding, such as `ply-le` (see [`Format::variant`]).
    pub variant: &'static str,
    /// What of the file the parts lack, or hold in another way; sorted by kind.
    pub notes: Vec<Note>,
    /// How the file was written, and what is in it beside its meshes.
    pub shell: Shell,
}

/// One mesh of a file.
#[derive(Clone, Debug)]
pub struct Part {
    /// Its name in the file; empty if it has none.
    pub name: Vec<u8>,
    /// What of the file it is.
    pub source: PartSource,
    /// The mesh, in its own space.
    pub mesh: PolygonMesh,
    /// Whether it can be edited.
    pub status: PartStatus,
}

/// What of a file a part is.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum PartSource {
    /// All of it.
    Whole,
    /// The faces that have one name in a layer of the only mesh.
    Named {
        /// The layer.
        layer: String,
    },
    /// A mesh of a glTF file.
    GltfMesh {
        /// The index.
        index: u32,
        /// Whether the file says which of its vertices are one (`EXT_mesh_manifold`).
        tells_vertices: bool,
    },
    /// An object of a 3MF file, by the model part that it is in and its id there.
    ThreeMfObject {
        /// The name of the model part in the package.
        entry: Arc<str>,
        /// The id.
        id: u32,
        /// What it is for.
        kind: ObjectKind,
    },
}

/// What an object of a 3MF file is for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum ObjectKind {
    /// It is to be made, and encloses a solid.
    #[default]
    Model,
    /// It supports others while they are made, and encloses a solid.
    SolidSupport,
    /// It supports others, and need not be closed.
    Support,
    /// It is a surface, which need not be closed.
    Surface,
    /// It is for something else, and need not be closed.
    Other,
}

/// Whether a part can be edited.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PartStatus {
    /// It can.
    Editable,
    /// It is passed through as it is, for this reason.
    Sealed(String),
}

impl Part {
    /// Whether its format says that its surface encloses a solid, so that a boundary is a defect.
    pub fn must_be_closed(&self) -> bool {
        let PartSource::ThreeMfObject { kind, .. } = &self.source else { return false };
        matches!(kind, ObjectKind::Model | ObjectKind::SolidSupport)
    }

    /// What reports call it: its name, and what it is in the file, such as `Body (mesh 3)`.
    pub fn title(&self) -> String {
        let what = match &self.source {
            PartSource::Whole => "whole file".to_owned(),
            PartSource::Named { layer } if self.name.is_empty() => return format!("no {layer}"),
            PartSource::Named { layer } => layer.clone(),
            PartSource::GltfMesh { index, .. } => format!("mesh {index}"),
            PartSource::ThreeMfObject { id, .. } => format!("object {id}"),
        };
        match String::from_utf8_lossy(&self.name) {
            name if name.is_empty() => what,
            name => format!("{name} ({what})"),
        }
    }

    /// Whether the file itself says which of the part's vertices are one, so that their places say nothing.
    pub fn tells_vertices(&self) -> bool {
        matches!(self.source, PartSource::GltfMesh { tells_vertices: true, .. })
    }

    /// Why it can't be edited, if it can't.
    pub fn seal(&self) -> Option<&str> {
        match &self.status {
            PartStatus::Editable => None,
            PartStatus::Sealed(reason) => Some(reason),
        }
    }
}

impl From<ReadFile> for Document {
    /// A document of one mesh.
    fn from(file: ReadFile) -> Self {
        let ReadFile { mesh, format, variant, notes, shell } = file;
        let part = Part { name: Vec::new(), source: PartSource::Whole, mesh, status: PartStatus::Editable };
        Document { parts: vec![part], format, variant, notes, shell }
    }
}

impl Document {
    /// This document with other parts.
    pub fn with_parts(self, parts: Vec<Part>) -> Self {
        Document { parts, ..self }
    }

    /// Whether the file is one mesh, as all files of formats without parts are.
    pub fn is_whole(&self) -> bool {
        matches!(&self.parts[..], [Part { source: PartSource::Whole, .. }])
    }

    /// This document with another mesh in a part. A part that does not exist is left out.
    pub fn with_mesh(mut self, part: usize, mesh: PolygonMesh) -> Self {
        if let Some(part) = self.parts.get_mut(part) {
            part.mesh = mesh;
        }
        self
    }

    /// One mesh of all parts that could be read, with the attributes that make sense there: joints, weights, morph
    /// targets and the names of the file's rows are left out.
    ///
    /// # Errors
    /// If the file places its parts so often that the mesh would be out of proportion to it.
    ///
    /// *Cost*: constant for a file of one mesh, else linear in the result.
    pub fn into_mesh(self, placing: Placing) -> Result<ReadFile, TooMuchPlaced> {
        placed::file_of(self, placing)
    }
}
