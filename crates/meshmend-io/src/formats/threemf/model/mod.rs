//! A model: the objects of one entry of a package, and how they are put together.

mod colors;
mod mesh;
mod objects;
mod rows;

use std::ops::Range;
use std::sync::Arc;

use meshmend_core::VertexId;

use crate::document::{Material, ObjectKind};

pub(super) use self::colors::color_text;
pub(super) use self::objects::read;

/// What is read of one model.
#[derive(Debug)]
pub(super) struct Model {
    /// The name of its entry.
    pub(super) entry: Arc<str>,
    /// The place of its entry in the directory.
    pub(super) place: usize,
    /// Whether its text is in UTF-16.
    pub(super) was_utf16: bool,
    /// Whether it can't be read.
    pub(super) is_encrypted: bool,
    pub(super) objects: Vec<Object>,
    /// What is to be built, in order.
    pub(super) items: Vec<Use>,
    pub(super) materials: Vec<BaseMaterials>,
}

/// One object.
#[derive(Debug)]
pub(super) struct Object {
    pub(super) id: u32,
    pub(super) name: String,
    pub(super) kind: ObjectKind,
    pub(super) content: Content,
    /// Whether it has slices, which were made of its mesh.
    pub(super) has_slices: bool,
}

/// What an object is made of.
#[derive(Debug)]
pub(super) enum Content {
    /// Triangles.
    Mesh(Box<MeshText>),
    /// Other objects.
    Components(Vec<Use>),
    /// Something that is not read: why, as what follows the object's name in a sentence.
    Other(String),
}

/// A mesh as it stands in the text of a model.
#[derive(Debug, Default)]
pub(super) struct MeshText {
    pub(super) positions: Vec<[f64; 3]>,
    /// Three a triangle.
    pub(super) corners: Vec<VertexId>,
    /// For each triangle its property group, if some triangle has one.
    pub(super) groups: Vec<u32>,
    /// For each corner its member of that group.
    pub(super) members: Vec<u32>,
    /// Where its parts are in the text.
    pub(super) places: Places,
    /// The name of something in it that numbers its vertices or triangles in a way not known here.
    pub(super) unknown: Option<String>,
}

/// Where the parts of a mesh are in the text of its model, each without its own tags.
#[derive(Clone, Debug, Default)]
pub(super) struct Places {
    pub(super) vertices: Option<Range<usize>>,
    pub(super) triangles: Option<Range<usize>>,
    /// Sets of triangles.
    pub(super) sets: Vec<Range<usize>>,
    /// Beams and balls.
    pub(super) lattices: Vec<Range<usize>>,
}

/// No property group, and no member of one.
pub(super) const NONE: u32 = u32::MAX;

/// An object used by another one, or to be built.
#[derive(Clone, Debug)]
pub(super) struct Use {
    /// The entry of the model that has it, if it is another one.
    pub(super) path: Option<String>,
    pub(super) object: u32,
    /// Rows: each coordinate as three factors and a summand.
    pub(super) matrix: [[f64; 4]; 3],
    /// The number by which its maker knows it.
    pub(super) part_number: String,
}

/// The materials of a group.
#[derive(Debug)]
pub(super) struct BaseMaterials {
    pub(super) id: u32,
    pub(super) members: Vec<Material>,
}
