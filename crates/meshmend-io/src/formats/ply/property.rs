//! The properties of a file to be written: where each gets its values from.

use std::ops::Range;

use meshmend_core::Layer;

use crate::formats::ply::scalar::Scalar;

/// A property to be written.
pub(super) struct Property<'a> {
    pub(super) name: String,
    /// The type of its numbers.
    pub(super) item: Scalar,
    pub(super) source: Source<'a>,
}

/// Where a property gets its values from.
#[derive(Clone, Copy)]
pub(super) enum Source<'a> {
    /// A coordinate of the vertex, by its axis.
    Coordinate(usize),
    /// The vertices of the face, with their number in this type.
    Indices(Scalar),
    /// An end of the loose edge: its first or second vertex.
    End(usize),
    /// One of the numbers of the element's value in a layer.
    Component(&'a Layer, usize),
    /// The element's value in a layer is a list, with its length in this type.
    List(&'a Layer, Scalar),
    /// The values of a face's corners in a layer, one after the other, with their number in this type.
    Corners(&'a Layer, Scalar),
}

impl<'a> Source<'a> {
    /// The layer that the values are from, if they are from one.
    pub(super) fn layer(&self) -> Option<&'a Layer> {
        match *self {
            Source::Coordinate(_) | Source::Indices(_) | Source::End(_) => None,
            Source::Component(layer, _) | Source::List(layer, _) | Source::Corners(layer, _) => Some(layer),
        }
    }
}

impl Property<'_> {
    /// Its line in the header.
    pub(super) fn declaration(&self) -> String {
        let (item, name) = (self.item.name(), &self.name);
        match self.source {
            Source::Coordinate(_) | Source::End(_) | Source::Component(..) => {
                format!("property {item} {name}\n")
            }
            Source::Indices(length) | Source::List(_, length) | Source::Corners(_, length) => {
                format!("property list {} {item} {name}\n", length.name())
            }
        }
    }
}

/// How many numbers a face's list of its corners' values has: none when no corner has a value.
pub(super) fn corner_values(layer: &Layer, corners: Range<usize>) -> usize {
    let has_any = corners.clone().any(|corner| layer.value_of(corner).is_some());
    if has_any { corners.len() * layer.width() } else { 0 }
}
