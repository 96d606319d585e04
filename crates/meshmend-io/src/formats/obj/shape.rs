//! What an OBJ file's writer chose, and which other files the file names.

use std::path::Path;

use crate::formats::obj::companions;
use crate::shell::{NamedFile, Output, Shape};
use crate::{Document, Loss, Material, Prepared, Shell};

/// What an OBJ file's writer chose, and which other files the file names.
#[derive(Debug, Default, PartialEq)]
pub(super) struct ObjShape {
    /// Whether colours have a fourth number. Most other programs misread a vertex of seven numbers, so the number is
    /// written only where it was there.
    pub(super) has_alpha: bool,
    /// The files that it names and that exist.
    pub(super) companions: Vec<NamedFile>,
    /// What their materials look like.
    pub(super) materials: Vec<Material>,
}

impl ObjShape {
    /// How many numbers of a colour are written: four if the mesh comes from an OBJ file with four.
    pub(super) fn color_width(prepared: &Prepared) -> usize {
        match prepared.shape() {
            Some(ObjShape { has_alpha: true, .. }) => 4,
            _ => 3,
        }
    }
}

impl Shape for ObjShape {
    fn is_same(&self, other: &dyn Shape) -> bool {
        other.downcast() == Some(self)
    }

    fn losses_in(&self, _: Output) -> Vec<Loss> {
        Vec::new()
    }

    fn materials(&self) -> Vec<Material> {
        self.materials.clone()
    }

    fn companions(&self) -> Vec<NamedFile> {
        self.companions.clone()
    }
}

/// A document that was read from a path, with notes about the files that it names.
///
/// *Cost*: constant for a file that names none; else that of reading its libraries.
pub(super) fn look_beside(mut document: Document, path: &Path) -> Document {
    let statements = document.parts.iter().flat_map(|part| part.mesh.metadata());
    let statements = statements.filter(|statement| statement.key == "mtllib");
    let libraries: Vec<&[u8]> = statements.map(|statement| &statement.value[..]).collect();
    let found = companions::look_for(&libraries, path);
    document.notes.extend(found.notes);
    document.notes.sort_by_key(|note| note.kind);
    if let (false, Some(encoding)) = (found.companions.is_empty(), document.shell.encoding()) {
        let has_alpha = document.shell.shape().is_some_and(|shape: &ObjShape| shape.has_alpha);
        let shape = ObjShape { has_alpha, companions: found.companions, materials: found.materials };
        document.shell = Shell::of_file(document.format, encoding, shape);
    }
    document
}
