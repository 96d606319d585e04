//! The names of faces by which a mesh is taken apart.

use meshmend_core::PolygonMesh;
use meshmend_io::{Document, Part, PartSource, PartStatus};
use meshmend_repair::NamedPart;

use super::FileError;

/// By which names of its faces a mesh is taken apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum FaceNames {
    /// The objects of OBJ, or the nodes that a mesh was placed by.
    Object,
    /// The groups of OBJ.
    Group,
    /// Materials.
    Material,
    /// The solids of a text STL.
    Solid,
}

impl FaceNames {
    /// The layer that has the names.
    pub fn layer(self) -> &'static str {
        match self {
            FaceNames::Object | FaceNames::Solid => "object",
            FaceNames::Group => "group",
            FaceNames::Material => "material",
        }
    }

    /// What each part is called: `object`, `group`, `material` or `solid`.
    pub fn name(self) -> &'static str {
        match self {
            FaceNames::Solid => "solid",
            _ => self.layer(),
        }
    }

    /// A file of one mesh with these parts of it in its place.
    pub fn document<'a>(self, document: Document, parts: impl Iterator<Item = &'a NamedPart>) -> Document {
        let part = |named: &NamedPart| Part {
            name: named.name.clone(),
            source: PartSource::Named { layer: self.name().to_owned() },
            mesh: named.mesh.clone(),
            status: PartStatus::Editable,
        };
        document.with_parts(parts.map(part).collect())
    }

    /// The error when faces have no names of this kind.
    pub fn missing(self, file: &str) -> FileError {
        FileError::Nameless { file: file.to_owned(), names: self }
    }

    /// The mesh of a file of one mesh.
    ///
    /// # Errors
    /// If the file has parts of its own.
    pub fn mesh(self, document: &Document, file: &str) -> Result<PolygonMesh, FileError> {
        match &document.parts[..] {
            [part] if document.is_whole() => Ok(part.mesh.clone()),
            _ => Err(FileError::HasParts { file: file.to_owned() }),
        }
    }
}
