//! What a reader remarks about a file that it accepts.

use std::fmt;

use serde::Serialize;

use crate::Place;

/// Something in an accepted file that the mesh lacks, or holds in another way.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[non_exhaustive]
pub struct Note {
    /// What kind of remark it is.
    pub kind: NoteKind,
    /// How often it applies.
    pub count: u64,
    /// The first place where it applies.
    pub first: Place,
    /// The remark for people, without count and place.
    pub message: String,
}

/// The kinds of remark, with stable names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum NoteKind {
    /// A statement of unknown meaning was skipped.
    SkippedStatement,
    /// An element or property of unknown meaning was skipped, or is carried to files of the same format only.
    SkippedElement,
    /// Content after the end of the data was skipped.
    SurplusData,
    /// Columns that the format does not have were skipped.
    SurplusColumns,
    /// A corner names a texture coordinate or normal that does not exist. The corner has none.
    AttributeOutOfRange,
    /// Values of several widths were padded with zeros, or with an opaque alpha.
    MixedWidths,
    /// Attributes of loose edges and points were skipped.
    LooseAttribute,
    /// A group, object or material that no face has was skipped.
    UnusedName,
    /// A file that this one names does not exist.
    CompanionMissing,
    /// A file that this one names lies outside its folder, and was not opened.
    CompanionOutside,
    /// Comments beyond the limit were skipped.
    SkippedComment,
    /// The end mark that the format requires is missing, though no data is cut off.
    MissingEnd,
    /// The extension stands for another format than that of the content.
    WrongSuffix,
    /// Several rows of a text share a line, or a row spans lines; all values were accounted for.
    WrappedRows,
    /// A header departs from its format, but can be understood.
    OddHeader,
    /// The values show that columns stand in another order than the format says.
    ColumnOrder,
    /// Triangles that only lead from one strip to the next are not faces.
    Stitches,
    /// Stored normals of facets point elsewhere than the facets. A writer computes them from the corners.
    NormalsRecomputed,
    /// Attribute bytes of facets are colours, or may be colours.
    PerhapsColors,
    /// A part can't be edited: it is passed through as it is.
    SealedPart,
    /// A part's stated bounds are not those of its positions.
    BoundsWrong,
    /// Numbers lie at other places than their format asks for.
    Misaligned,
    /// A coordinate is not a finite number.
    NonFinite,
    /// The file has no vertex.
    Empty,
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.message)?;
        if self.count > 1 {
            write!(f, " ({} times)", self.count)?;
        }
        match &self.first {
            Place::File => Ok(()),
            place if self.count > 1 => write!(f, ", first at {place}"),
            place => write!(f, ", at {place}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_note_says_how_often_and_where_first() {
        let shown = |count, first| {
            Note { kind: NoteKind::NonFinite, count, first, message: "odd".to_owned() }.to_string()
        };
        assert_eq!(shown(1, Place::File), "odd");
        assert_eq!(shown(1, Place::Line(4)), "odd, at line 4");
        assert_eq!(shown(2, Place::File), "odd (2 times)");
        assert_eq!(shown(2, Place::Byte(9)), "odd (2 times), first at byte 9");
    }
}
