//! Why T-junctions stay.

/// Why a T-junction is not healed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum LeftOpen {
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

impl LeftOpen {
    /// The reason in a word, as reports have it.
    pub fn name(self) -> &'static str {
        match self {
            LeftOpen::Foreign => "foreign",
            LeftOpen::Thin => "thin",
            LeftOpen::Repeated => "repeated",
            LeftOpen::Crowded => "crowded",
            LeftOpen::Unmatched => "unmatched",
        }
    }
}
