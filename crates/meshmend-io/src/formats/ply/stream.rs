//! A binary PLY row by row, without keeping its mesh.

use std::io::Read;

use meshmend_core::VertexId;

use crate::formats::ply::binary_values::BinaryValues;
use crate::formats::ply::carried::skip;
use crate::formats::ply::columns::skip_property;
use crate::formats::ply::data::{Data, RowReader};
use crate::formats::ply::header::{self, Element, Form, Header, Property};
use crate::formats::ply::read::{
    axes, edge_ends, index_list, missing, note_edges_without_ends, note_surplus, note_unknown, offsets,
};
use crate::formats::ply::rows::no_index;
use crate::formats::ply::scalar::Scalar;
use crate::input::assemble::{Parts, VertexNotes, no_such_vertex};
use crate::input::indices::MaxIndex;
use crate::input::notes::Notes;
use crate::input::source::Source;
use crate::input::streamed::{Announced, MeshSink, Rows};
use crate::{Encoding, Format, Limits, Place, ReadError};

/// Hands over the vertices and faces of a file. `None`, having read nothing, if its values are text, it has strips, or its header is
/// longer than what is in memory.
pub(super) fn stream(
    source: &Source<'_>,
    rest: &mut dyn Read,
    limits: &Limits,
    sink: &mut dyn MeshSink,
) -> Option<Result<Rows, ReadError>> {
    let (mut parts, is_all) = (Parts::default(), source.bytes.len() == source.length);
    let header = match header::read(source, &mut parts, limits) {
        Ok(header) => header,
        Err(error) => return is_all.then_some(Err(error)),
    };
    let has_strips = header.elements.iter().any(|element| element.name == "tristrips");
    if header.form == Form::Ascii || has_strips || !(is_all || header.end < source.bytes.len()) {
        return None;
    }
    let at = header.end;
    let reader = Streamer {
        source,
        limits,
        sink,
        vertex_count: 0,
        counted: VertexNotes::default(),
        max_index: MaxIndex::default(),
        notes: parts.notes,
        loose_edges: Vec::new(),
    };
    Some(match header.form {
        Form::BigEndian => {
            reader.rows(&header, BinaryValues::<true>::new(source, at, rest), Encoding::BigEndian)
        }
        _ => reader.rows(&header, BinaryValues::<false>::new(source, at, rest), Encoding::LittleEndian),
    })
}

struct Streamer<'r> {
    source: &'r Source<'r>,
    limits: &'r Limits,
    sink: &'r mut dyn MeshSink,
    vertex_count: u64,
    counted: VertexNotes,
    max_index: MaxIndex,
    notes: Notes,
    loose_edges: Vec<[VertexId; 2]>,
}

impl Streamer<'_> {
    fn rows(mut self, header: &Header, mut data: impl Data, encoding: Encoding) -> Result<Rows, ReadError> {
        let source = self.source;
        self.begin(header)?;
        for element in &header.elements {
            data.begin_element(element)?;
            match element.name.as_str() {
                "vertex" => self.vertices(element, &mut data)?,
                "face" => self.faces(element, &mut data)?,
                "edge" => self.edges(element, &mut data)?,
                _ => {
                    note_unknown(&mut self.notes, source, element);
                    skip(element, &mut data)?;
                }
            }
            data.end_element(element)?;
        }
        note_surplus(&mut self.notes, data.surplus(), |at| Place::Byte(at as u64));
        if let Some((index, at)) = self.max_index.beyond(self.vertex_count as usize) {
            let reason = no_such_vertex(index.into(), self.vertex_count as usize);
            return Err(source.malformed(Place::Byte(at as u64), reason));
        }
        self.counted.note(&mut self.notes);
        Ok(Rows { encoding, notes: self.notes, loose_edges: self.loose_edges })
    }

    /// Tells the sink what the header announces, as far as the file has room and limits allow: beyond, its rows are an error.
    fn begin(&mut self, header: &Header) -> Result<(), ReadError> {
        let (source, limits) = (self.source, self.limits);
        let left = (source.length - header.end) as u64;
        let element = |name: &str| header.elements.iter().find(|element| element.name == name);
        let rows = |name: &str, limit: u64| element(name).map_or(0, |rows| rows.count.min(left).min(limit));
        self.vertex_count = rows("vertex", limits.max_vertices);
        let faces = rows("face", limits.max_faces);
        let item = element("face").and_then(|face| Some(face.properties[index_list(face)?].item));
        let corners = item.map_or(0, |item| left / item.size() as u64);
        let is_wide = |property: &Property| {
            let is_axis = ["x", "y", "z"].contains(&property.name.as_str());
            is_axis && matches!(property.item, Scalar::F64 | Scalar::I32 | Scalar::U32)
        };
        let is_single = element("vertex").is_none_or(|vertex| !vertex.properties.iter().any(is_wide));
        let announced = Announced {
            format: Format::Ply,
            vertices: self.vertex_count,
            faces,
            corners,
            is_single,
            is_soup: false,
        };
        self.sink.begin(&announced).map_err(|stopped| source.cancelled(stopped))
    }

    fn vertices(&mut self, element: &Element, data: &mut impl Data) -> Result<(), ReadError> {
        self.source.limited("vertices", element.count, self.limits.max_vertices)?;
        let axes = axes(self.source, element)?;
        let offsets = offsets(element);
        let columns = axes.map(|column| (element.properties[column].item, offsets[column]));
        let mut positions = Vec::new();
        let is_read = data.fixed_rows(element, |rows| {
            positions.clear();
            rows.extend_points(&mut positions, columns);
            self.take(&positions)
        })?;
        if !is_read {
            data.each_row(element, None, &mut VertexRows { streamer: self, element, axes })?;
        }
        Ok(())
    }

    fn take(&mut self, positions: &[[f64; 3]]) -> Result<(), ReadError> {
        self.counted.see(positions);
        self.sink.vertices(positions).map_err(|stopped| self.source.cancelled(stopped))
    }

    fn faces(&mut self, element: &Element, data: &mut impl Data) -> Result<(), ReadError> {
        self.source.limited("faces", element.count, self.limits.max_faces)?;
        let Some(list) = index_list(element) else {
            let reason = "faces without a list `vertex_indices` or `vertex_index`";
            return if element.count == 0 { Ok(()) } else { Err(missing(self.source, element, reason)) };
        };
        let mut rows = FaceRows { streamer: self, element, list, face: Vec::new(), corners: 0 };
        data.each_row(element, None, &mut rows)
    }

    fn edges(&mut self, element: &Element, data: &mut impl Data) -> Result<(), ReadError> {
        let Some(ends) = edge_ends(element) else {
            note_edges_without_ends(&mut self.notes, self.source, element);
            return skip(element, data);
        };
        data.each_row(element, None, &mut EdgeRows { streamer: self, element, ends })
    }
}

/// Vertices whose rows have lists.
struct VertexRows<'s, 'r> {
    streamer: &'s mut Streamer<'r>,
    element: &'s Element,
    axes: [usize; 3],
}

impl RowReader for VertexRows<'_, '_> {
    fn row(&mut self, data: &mut impl Data) -> Result<(), ReadError> {
        let mut point = [0.0; 3];
        for (column, property) in self.element.properties.iter().enumerate() {
            match self.axes.iter().position(|&axis| axis == column) {
                Some(axis) => point[axis] = data.number(property.item)?,
                None => skip_property(property, data)?,
            }
        }
        self.streamer.take(&[point])
    }
}

struct FaceRows<'s, 'r> {
    streamer: &'s mut Streamer<'r>,
    element: &'s Element,
    /// The place of the list of indices among the properties.
    list: usize,
    /// The vertices of the face that is being read.
    face: Vec<VertexId>,
    corners: u64,
}

impl RowReader for FaceRows<'_, '_> {
    #[inline]
    fn row(&mut self, data: &mut impl Data) -> Result<(), ReadError> {
        for (column, property) in self.element.properties.iter().enumerate() {
            if column == self.list {
                self.indices(property, data)?;
            } else {
                skip_property(property, data)?;
            }
        }
        let streamer = &mut *self.streamer;
        let source = streamer.source;
        // A face that names a vertex that is not there is an error at the end of the file, where the highest one is known.
        if streamer.max_index.beyond(streamer.vertex_count as usize).is_some() {
            return Ok(());
        }
        streamer.sink.face(&self.face).map_err(|stopped| source.cancelled(stopped))
    }
}

impl FaceRows<'_, '_> {
    #[inline]
    fn indices(&mut self, property: &Property, data: &mut impl Data) -> Result<(), ReadError> {
        let length = property.length.unwrap_or(property.item);
        let count = data.length(length, property.item)?;
        self.corners += count as u64;
        self.streamer.source.limited("corners", self.corners, self.streamer.limits.max_corners)?;
        let (face, max_index) = (&mut self.face, &mut self.streamer.max_index);
        face.clear();
        let mut wrong = None;
        data.indices(property.item, count, |index, at| match u32::try_from(index) {
            Ok(index) => {
                max_index.see(index, at);
                face.push(VertexId(index));
            }
            Err(_) => wrong = wrong.or(Some((index, at))),
        })?;
        wrong.map_or(Ok(()), |(index, at)| Err(no_index(data, index, at)))
    }
}

struct EdgeRows<'s, 'r> {
    streamer: &'s mut Streamer<'r>,
    element: &'s Element,
    /// The places of the ends among the properties.
    ends: [usize; 2],
}

impl RowReader for EdgeRows<'_, '_> {
    fn row(&mut self, data: &mut impl Data) -> Result<(), ReadError> {
        let mut ends = [VertexId(0); 2];
        for (column, property) in self.element.properties.iter().enumerate() {
            match self.ends.iter().position(|&end| end == column) {
                Some(place) => ends[place] = self.streamer.max_index.read(property, data)?,
                None => skip_property(property, data)?,
            }
        }
        self.streamer.loose_edges.push(ends);
        Ok(())
    }
}
