//! What the lines, marks and colours of a picture mean.

use crate::look::appearance::{Colour, Ink};

/// One line of a legend.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Entry {
    pub(crate) swatch: Swatch,
    pub(crate) text: String,
}

/// A sample of what an entry is about.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Swatch {
    /// A line.
    Line(Ink),
    /// A line with an arrow.
    Arrow(Ink),
    /// A mark alone.
    Mark(Shape, Colour),
    /// A coloured face.
    Face(Colour),
    /// The hatched back of a face.
    Back,
    /// Nothing but the text.
    None,
}

/// The shape of a mark.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Shape {
    Disc,
    Square,
    /// An arrowhead that points along a direction of length one.
    Arrow([f64; 2]),
}

impl Entry {
    pub(crate) fn new(swatch: Swatch, text: impl Into<String>) -> Self {
        Entry { swatch, text: text.into() }
    }
}

/// The entries of several pictures, each once, in order.
pub(crate) fn merged<'a>(entries: impl Iterator<Item = &'a Entry>) -> Vec<Entry> {
    let mut legend: Vec<Entry> = Vec::new();
    for entry in entries {
        if !legend.contains(entry) {
            legend.push(entry.clone());
        }
    }
    legend
}
