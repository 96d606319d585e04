//! Which holes are small enough to be filled.

use serde::{Deserialize, Serialize};

/// Which holes are filled.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum FillLoops {
    /// All.
    #[default]
    All,
    /// Those within limits.
    Within(FillLimits),
}

/// How large a hole may be that is filled; all limits have to hold.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
pub struct FillLimits {
    /// So many edges at most.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub edges: Option<u32>,
    /// No longer than this.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub length: Option<Reach>,
    /// No larger area than this: that of the loop's area vector.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub area: Option<Reach>,
}

/// A limit of length or of area.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Reach {
    /// In units of the coordinates, or of their squares.
    Absolute(f64),
    /// In parts of the diagonal of the component's bounding box; an area in squares of such parts, so that 0.01 is a square
    /// whose side is a hundredth of the diagonal.
    Relative(f64),
}

impl Reach {
    /// The greatest length where the diagonal is this.
    pub(super) fn length(self, diagonal: f64) -> f64 {
        match self {
            Reach::Absolute(length) => length,
            Reach::Relative(part) => part * diagonal,
        }
    }

    /// The greatest area where the diagonal is this.
    pub(super) fn area(self, diagonal: f64) -> f64 {
        match self {
            Reach::Absolute(area) => area,
            Reach::Relative(part) => (part * diagonal) * (part * diagonal),
        }
    }
}
