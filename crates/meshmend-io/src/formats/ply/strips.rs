//! Triangle strips: each vertex after the first two makes a triangle with the two vertices before it. Every second
//! triangle is reversed. −1 begins a new strip.
//!
//! Encoders lead a strip to the start of the next one through triangles that name a vertex twice. These *stitches*
//! belong to the encoding and are not faces, but they count when every second triangle is reversed.

use meshmend_core::VertexId;

use crate::Limits;
use crate::ReadError;
use crate::formats::ply::columns::skip_property;
use crate::formats::ply::data::{Data, RowReader};
use crate::formats::ply::header::{Element, Property};
use crate::formats::ply::rows::no_index;
use crate::input::assemble::Parts;
use crate::input::source::Source;

/// Reads strips.
pub(super) struct StripReader<'r, 'a> {
    pub(super) source: &'r Source<'a>,
    pub(super) limits: &'r Limits,
    pub(super) element: &'r Element,
    /// The place of the list of indices among the properties.
    pub(super) list: usize,
    pub(super) parts: &'r mut Parts,
    pub(super) stitches: Stitches,
}

/// Triangles of strips that name a vertex twice.
#[derive(Default)]
pub(super) struct Stitches {
    pub(super) count: u64,
    /// Where the first one ends.
    pub(super) first: usize,
}

impl RowReader for StripReader<'_, '_> {
    fn row(&mut self, data: &mut impl Data) -> Result<(), ReadError> {
        for (column, property) in self.element.properties.iter().enumerate() {
            if column == self.list {
                self.strip(property, data)?;
            } else {
                skip_property(property, data)?;
            }
        }
        Ok(())
    }
}

impl StripReader<'_, '_> {
    fn strip(&mut self, property: &Property, data: &mut impl Data) -> Result<(), ReadError> {
        let length = property.length.unwrap_or(property.item);
        let count = data.length(length, property.item)?;
        let (faces, max_index) = (&mut self.parts.faces, &mut self.parts.max_index);
        let (mut before, mut seen, mut wrong) = ([VertexId(0); 2], 0_usize, None);
        data.indices(property.item, count, |index, at| {
            let Ok(index) = u32::try_from(index) else {
                if index != -1 {
                    wrong = wrong.or(Some((index, at)));
                }
                seen = 0;
                return;
            };
            max_index.see(index, at);
            let ([a, b], c) = (before, VertexId(index));
            if seen >= 2 {
                if a == b || b == c || a == c {
                    self.stitches.add(at);
                } else {
                    faces.push_face(if seen % 2 == 0 { [a, b, c] } else { [b, a, c] });
                }
            }
            (before, seen) = ([b, c], seen + 1);
        })?;
        let (faces, corners) = (faces.face_count() as u64, faces.corner_count() as u64);
        self.source.limited("faces", faces, self.limits.max_faces)?;
        self.source.limited("corners", corners, self.limits.max_corners)?;
        wrong.map_or(Ok(()), |(index, at)| Err(no_index(data, index, at)))
    }
}

impl Stitches {
    fn add(&mut self, at: usize) {
        if self.count == 0 {
            self.first = at;
        }
        self.count += 1;
    }
}
