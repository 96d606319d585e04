//! The rows of vertices, faces and edges, one by one or many at a time if they are usual.

use meshmend_core::VertexId;

use crate::formats::ply::columns::Columns;
use crate::formats::ply::data::{Data, RowReader};
use crate::formats::ply::header::{Element, Property};
use crate::formats::ply::usual_rows::ParsedRows;
use crate::input::assemble::Parts;
use crate::input::indices::MaxIndex;
use crate::input::source::Source;
use crate::{Limits, ReadError};

/// Reads vertices.
pub(super) struct VertexRowReader<'r> {
    pub(super) element: &'r Element,
    /// The places of the coordinates among the properties.
    pub(super) axes: [usize; 3],
    pub(super) columns: &'r mut Columns,
    pub(super) positions: &'r mut Vec<[f64; 3]>,
}

impl RowReader for VertexRowReader<'_> {
    fn row(&mut self, data: &mut impl Data) -> Result<(), ReadError> {
        let mut point = [0.0; 3];
        for (column, property) in self.element.properties.iter().enumerate() {
            match self.axes.iter().position(|&axis| axis == column) {
                Some(axis) => point[axis] = data.number(property.item)?,
                None => self.columns.read(self.element, column, data)?,
            }
        }
        self.positions.push(point);
        Ok(())
    }

    fn take(&mut self, rows: &ParsedRows) -> bool {
        self.positions.extend_from_slice(&rows.positions);
        let others = (0..self.element.properties.len()).filter(|column| !self.axes.contains(column));
        self.columns.append(others, &rows.others);
        true
    }
}

/// Reads faces.
pub(super) struct FaceRowReader<'r, 'a> {
    pub(super) source: &'r Source<'a>,
    pub(super) limits: &'r Limits,
    pub(super) element: &'r Element,
    /// The place of the list of indices among the properties.
    pub(super) list: usize,
    pub(super) columns: &'r mut Columns,
    pub(super) parts: &'r mut Parts,
    /// The first corner of each face, if a corner layer may need it.
    pub(super) corner_starts: Option<Vec<u32>>,
}

impl RowReader for FaceRowReader<'_, '_> {
    #[inline]
    fn row(&mut self, data: &mut impl Data) -> Result<(), ReadError> {
        if let Some(starts) = &mut self.corner_starts {
            starts.push(self.parts.faces.corner_count() as u32);
        }
        let element = self.element;
        for (column, property) in element.properties.iter().enumerate() {
            if column == self.list {
                self.face(property, data)?;
            } else {
                self.columns.read(element, column, data)?;
            }
        }
        Ok(())
    }

    fn take(&mut self, rows: &ParsedRows) -> bool {
        let corners = (self.parts.faces.corner_count() + rows.faces.corner_count()) as u64;
        if corners > self.limits.max_corners {
            return false;
        }
        self.parts.take_faces(&rows.faces, rows.max_index);
        let others = (0..self.element.properties.len()).filter(|&column| column != self.list);
        self.columns.append(others, &rows.others);
        true
    }
}

/// Reads loose edges.
pub(super) struct EdgeRowReader<'r> {
    pub(super) element: &'r Element,
    /// The places of the ends among the properties.
    pub(super) ends: [usize; 2],
    pub(super) columns: &'r mut Columns,
    pub(super) parts: &'r mut Parts,
}

impl RowReader for EdgeRowReader<'_> {
    fn row(&mut self, data: &mut impl Data) -> Result<(), ReadError> {
        let mut ends = [VertexId(0); 2];
        for (column, property) in self.element.properties.iter().enumerate() {
            match self.ends.iter().position(|&end| end == column) {
                Some(place) => ends[place] = self.parts.max_index.read(property, data)?,
                None => self.columns.read(self.element, column, data)?,
            }
        }
        self.parts.loose_edges.push(ends);
        Ok(())
    }
}

impl MaxIndex {
    /// The next value, which is the index of a vertex.
    pub(super) fn read(&mut self, property: &Property, data: &mut impl Data) -> Result<VertexId, ReadError> {
        let mut found = (0, 0);
        data.indices(property.item, 1, |index, at| found = (index, at))?;
        let (index, at) = found;
        let known = u32::try_from(index).map_err(|_| no_index(data, index, at))?;
        self.see(known, at);
        Ok(VertexId(known))
    }
}

/// The error of a number that is the index of no vertex.
#[cold]
pub(super) fn no_index(data: &impl Data, index: i64, at: usize) -> ReadError {
    data.wrong(at, &format!("{index} is not the index of a vertex"))
}

impl FaceRowReader<'_, '_> {
    #[inline]
    fn face(&mut self, property: &Property, data: &mut impl Data) -> Result<(), ReadError> {
        let length = property.length.unwrap_or(property.item);
        let count = data.length(length, property.item)?;
        let corners = self.parts.faces.corner_count() as u64 + count as u64;
        self.source.limited("corners", corners, self.limits.max_corners)?;
        let (faces, max_index) = (&mut self.parts.faces, &mut self.parts.max_index);
        let mut wrong = None;
        data.indices(property.item, count, |index, at| match u32::try_from(index) {
            Ok(index) => {
                max_index.see(index, at);
                faces.push_corner(VertexId(index));
            }
            Err(_) => wrong = wrong.or(Some((index, at))),
        })?;
        faces.end_face();
        wrong.map_or(Ok(()), |(index, at)| Err(no_index(data, index, at)))
    }
}
