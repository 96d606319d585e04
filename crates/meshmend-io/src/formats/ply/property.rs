//! The properties of a file to be written, and the sources of their values.

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

/// The source of the values of a property.
#[derive(Clone, Copy)]
pub(super) enum Source<'a> {
    /// A coordinate of the vertex, by its axis.
    Coordinate(usize),
    /// The vertices of the face, with their number in this type.
    Indices(Scalar),
    /// The first or the second vertex of the loose edge.
    End(usize),
    /// One number of the value of the element in a layer.
    Component(&'a Layer, usize),
    /// The list that the element has in a layer, with its length in this type.
    List(&'a Layer, Scalar),
    /// The values of the corners of the face in a layer, with their number in this type.
    Corners(&'a Layer, Scalar),
}

impl<'a> Source<'a> {
    /// The layer of the values, if they come from one.
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

/// How many numbers the corners of a face have in a layer: 0 if no corner has a value.
pub(super) fn corner_values(layer: &Layer, corners: Range<usize>) -> usize {
    let has_any = corners.clone().any(|corner| layer.value_of(corner).is_some());
    if has_any { corners.len() * layer.width() } else { 0 }
}
