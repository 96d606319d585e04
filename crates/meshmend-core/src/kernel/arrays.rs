//! Of which arrays a kernel consists.

use crate::Column;

/// An array of a kernel, as it is in memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Array {
    /// The field's name, such as `next`.
    pub name: &'static str,
    /// What has a place in it.
    pub per: Per,
    /// Bytes a place.
    pub each: usize,
    /// How many places are allocated.
    pub count: usize,
    /// Whether the mesh or its complex keeps it alive too.
    pub shared: bool,
}

/// What has a place in an array.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "kebab-case"))]
pub enum Per {
    /// Each corner.
    Corner,
    /// Each edge.
    Edge,
    /// Each face.
    Face,
    /// Each vertex.
    Vertex,
    /// Each dart: one of several for a side, or a side that is not a face's.
    Dart,
}

impl Array {
    /// An array of the kernel's own.
    pub const fn new(name: &'static str, per: Per, each: usize, count: usize) -> Self {
        Array { name, per, each, count, shared: false }
    }

    /// A column of the kernel's own.
    pub fn of_column<I: crate::Id, T>(name: &'static str, per: Per, column: &Column<I, T>) -> Self {
        Self::new(name, per, size_of::<T>(), column.capacity())
    }

    /// The array as one that the mesh or its complex keeps alive too.
    #[must_use]
    pub const fn shared(self) -> Self {
        Array { shared: true, ..self }
    }

    /// Bytes on the heap.
    pub const fn bytes(&self) -> usize {
        self.each * self.count
    }
}

impl Per {
    /// What it is called in reports, such as `corner`.
    pub fn name(self) -> &'static str {
        match self {
            Per::Corner => "corner",
            Per::Edge => "edge",
            Per::Face => "face",
            Per::Vertex => "vertex",
            Per::Dart => "dart",
        }
    }
}
