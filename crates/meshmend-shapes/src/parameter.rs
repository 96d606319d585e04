//! The sizes that a shape may have.

use std::fmt;

/// A size of a shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Parameter {
    /// How finely it is divided: N in the summary.
    Resolution,
    /// How many pages, tubes, triangles or turns it has: N in the summary.
    Count,
    /// How many handles.
    Genus,
    /// How many cross-caps, in place of handles.
    CrossCaps,
    /// How many holes.
    Holes,
}

impl Parameter {
    /// What it is called, in lower case with hyphens.
    pub fn name(self) -> &'static str {
        match self {
            Parameter::Resolution => "resolution",
            Parameter::Count => "count",
            Parameter::Genus => "genus",
            Parameter::CrossCaps => "cross-caps",
            Parameter::Holes => "holes",
        }
    }
}

impl fmt::Display for Parameter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}
