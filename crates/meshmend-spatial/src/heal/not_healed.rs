//! Why T-junctions stay.

use serde::Serialize;

/// Why a T-junction is not healed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum NotHealed {
    /// No boundary edge of the vertex runs along the edge.
    Foreign,
    /// Another corner of the face is near the edge's line, so that the face could turn over.
    Thin,
    /// The vertex would be a corner of the face twice.
    Repeated,
    /// Two sides or more of other edges would run along a part of the edge.
    Crowded,
    /// No two sides of different faces, which don't lie on each other, would run along a part of the edge.
    Unmatched,
}

impl NotHealed {
    /// The reason in words, as it follows “left: ”.
    pub fn reason(self) -> &'static str {
        match self {
            NotHealed::Foreign => "no open edge of the vertex runs along the edge",
            NotHealed::Thin => "the face is as thin there as the distance, and could turn over",
            NotHealed::Repeated => "the vertex would be a corner of the face twice",
            NotHealed::Crowded => "two or more other sides run along a part of the edge",
            NotHealed::Unmatched => {
                "no part of the edge would have two sides of different faces that do not lie on each other"
            }
        }
    }
}
