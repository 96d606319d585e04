//! What a reader has to say about a file that it accepts.

use std::fmt;

use serde::Serialize;

use crate::Place;

/// Something in an accepted file that is not in the mesh, or not as the file has it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[non_exhaustive]
pub struct Note {
    /// What kind of remark it is.
    pub kind: NoteKind,
    /// How often it applies.
    pub count: u64,
    /// Where it applies first.
    pub first: Place,
    /// What it says, for people; without count and place.
    pub message: String,
}

/// The kinds of remark, with stable names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum NoteKind {
    /// A statement that is not understood was skipped.
    SkippedStatement,
    /// An element or property that is not understood was skipped, or is carried to files of the same format alone.
    SkippedElement,
    /// Content after the end of the data was skipped.
    SurplusData,
    /// Columns beyond those that the format has were skipped.
    SurplusColumns,
    /// A corner names a texture coordinate or normal that does not exist, and has none instead.
    AttributeOutOfRange,
    /// Values of several widths were padded: with zeros, alphas as opaque.
    MixedWidths,
    /// Attributes of loose edges and points were skipped.
    LooseAttribute,
    /// A group, object or material that no face has was skipped.
    UnusedName,
    /// A file that this one names is not there.
    CompanionMissing,
    /// A file that this one names is outside its folder, or is no plain file, and was not opened.
    CompanionOutside,
    /// Comments beyond the limit were skipped.
    SkippedComment,
    /// An end that the format asks for is missing, with nothing cut off.
    MissingEnd,
    /// The name says another format than the content has.
    WrongSuffix,
    /// Rows of a text do not stand on a line each, but come out even.
    WrappedRows,
    /// A header that is not written as its format says, but can be understood.
    OddHeader,
    /// Columns stand in another order than the format says, as their values tell.
    ColumnOrder,
    /// Triangles that lead a strip on to another one are no faces.
    Stitches,
    /// Stored normals of facets point elsewhere than the facets, and are computed afresh where they are written.
    NormalsRecomputed,
    /// Attribute bytes of facets are colours, or may be.
    PerhapsColors,
    /// A coordinate is not a finite number.
    NonFinite,
    /// There is no vertex.
    Empty,
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.message)?;
        if self.count > 1 {
            write!(f, " ({} times)", self.count)?;
        }
        match self.first {
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
