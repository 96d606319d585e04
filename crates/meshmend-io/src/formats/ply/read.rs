//! The PLY reader: one element after the other, in the order of the header.

use std::io::{self, Read};

use crate::formats::ply::binary_values::BinaryValues;
use crate::formats::ply::carried::{of_rows, skip};
use crate::formats::ply::columns::Columns;
use crate::formats::ply::data::Data;
use crate::formats::ply::header::{self, Element, Form, Header};
use crate::formats::ply::interpret::{ElementRows, edge_layers, face_layers, vertex_layers};
use crate::formats::ply::rows::{EdgeRowReader, FaceRowReader, VertexRowReader};
use crate::formats::ply::shape::PlyShape;
use crate::formats::ply::strips::{Stitches, StripReader};
use crate::formats::ply::text_values::TextValues;
use crate::formats::ply::usual_rows::ParsedRows;
use crate::input::assemble::Parts;
use crate::input::notes::Notes;
use crate::input::source::{Parsed, Source};
use crate::{Encoding, Format, Limits, NoteKind, Place, ReadError, Shell};

pub(super) fn read(source: &Source<'_>, limits: &Limits) -> Result<Parsed, ReadError> {
    let mut parts = Parts::default();
    let header = header::read(source, &mut parts, limits)?;
    match header.form {
        Form::Ascii => read_body(source, limits, &header, parts, TextValues::new(source, header.end)),
        _ => read_binary(source, &mut io::empty(), limits, &header, parts),
    }
}

/// Reads binary values block by block, if the head has the whole header.
pub(super) fn read_blocks(
    head: &Source<'_>,
    rest: &mut dyn Read,
    limits: &Limits,
) -> Option<Result<Parsed, ReadError>> {
    let mut parts = Parts::default();
    let header = header::read(head, &mut parts, limits).ok()?;
    let is_whole = header.end < head.bytes.len();
    (is_whole && header.form != Form::Ascii).then(|| read_binary(head, rest, limits, &header, parts))
}

fn read_binary(
    source: &Source<'_>,
    rest: &mut dyn Read,
    limits: &Limits,
    header: &Header,
    parts: Parts,
) -> Result<Parsed, ReadError> {
    let at = header.end;
    match header.form {
        Form::BigEndian => {
            read_body(source, limits, header, parts, BinaryValues::<true>::new(source, at, rest))
        }
        _ => read_body(source, limits, header, parts, BinaryValues::<false>::new(source, at, rest)),
    }
}

fn read_body(
    source: &Source<'_>,
    limits: &Limits,
    header: &Header,
    parts: Parts,
    mut data: impl Data,
) -> Result<Parsed, ReadError> {
    let mut reader = Reader {
        source,
        form: header.form,
        limits,
        parts,
        vertices: None,
        faces: None,
        edges: None,
        element: 0,
        tables: Vec::new(),
    };
    for (at, element) in header.elements.iter().enumerate() {
        reader.element = at;
        data.begin_element(element)?;
        reader.read_element(element, &mut data)?;
        data.end_element(element)?;
    }
    let odd_rows = data.end_file()?;
    note_surplus(&mut reader.parts.notes, data.surplus(), |at| place_of(source, header.form, at));
    if let Some((first, count)) = odd_rows {
        let message = "rows that do not stand on a line each were read across lines";
        let place = || place_of(source, header.form, first);
        reader.parts.notes.add_many(NoteKind::WrappedRows, message, count, place);
    }
    reader.finish(header)
}

fn place_of(source: &Source<'_>, form: Form, at: usize) -> Place {
    match form {
        Form::Ascii => source.line(at),
        _ => Place::Byte(at as u64),
    }
}

struct Reader<'a> {
    source: &'a Source<'a>,
    form: Form,
    limits: &'a Limits,
    parts: Parts,
    vertices: Option<ElementRows<'a>>,
    faces: Option<ElementRows<'a>>,
    edges: Option<ElementRows<'a>>,
    /// The place in the header of the current element.
    element: usize,
    /// The rows of elements that are carried unchanged, with their places in the header.
    tables: Vec<(usize, Columns)>,
}

impl<'a> Reader<'a> {
    fn read_element(&mut self, element: &'a Element, data: &mut impl Data) -> Result<(), ReadError> {
        match element.name.as_str() {
            "vertex" => self.vertices(element, data),
            "face" => self.faces(element, data),
            "tristrips" => self.strips(element, data),
            "edge" => self.edges(element, data),
            _ => {
                note_unknown(&mut self.parts.notes, self.source, element);
                self.table(element, data)
            }
        }
    }

    /// Keeps the rows of an element that is carried unchanged.
    fn table(&mut self, element: &'a Element, data: &mut impl Data) -> Result<(), ReadError> {
        self.tables.push((self.element, of_rows(element, data)?));
        Ok(())
    }

    fn note_skipped(&mut self, message: &str, count: u64, element: &Element) {
        note_skipped(&mut self.parts.notes, self.source, (message, count), element);
    }

    fn vertices(&mut self, element: &'a Element, data: &mut impl Data) -> Result<(), ReadError> {
        self.source.limited("vertices", element.count, self.limits.max_vertices)?;
        let axes = axes(self.source, element)?;
        let mut columns = Columns::new(element);
        let offsets = offsets(element);
        let others = (0..element.properties.len()).filter(|column| !axes.contains(column));
        let of_axes = axes.map(|column| (element.properties[column].item, offsets[column]));
        let positions = &mut self.parts.positions;
        let is_read = data.fixed_rows(element, |rows| {
            rows.extend_points(positions, of_axes);
            for column in others.clone() {
                rows.extend(&mut columns.values[column], offsets[column]);
            }
            Ok(())
        })?;
        if !is_read {
            let mut reader = VertexRowReader { element, axes, columns: &mut columns, positions };
            data.each_row(element, ParsedRows::of_vertices(element, axes), &mut reader)?;
        }
        let is_taken = (0..element.properties.len()).map(|column| axes.contains(&column)).collect();
        self.vertices = Some(ElementRows { element, columns, is_taken, first: 0, corner_starts: Vec::new() });
        Ok(())
    }

    fn faces(&mut self, element: &'a Element, data: &mut impl Data) -> Result<(), ReadError> {
        self.source.limited("faces", element.count, self.limits.max_faces)?;
        let Some(list) = index_list(element) else {
            if element.count == 0 {
                return Ok(());
            }
            let reason = "faces without a list `vertex_indices` or `vertex_index`";
            return Err(missing(self.source, element, reason));
        };
        let mut columns = Columns::new(element);
        if let Some(left) = data.left() {
            // Room for triangles, but no more than the file can hold.
            let most = left / element.properties[list].item.size();
            self.parts.faces.reserve(most.min(3 * element.count as usize));
        }
        let first = self.parts.faces.face_count();
        // Only another list than the indices can be a corner layer, which needs to know the corners of each face.
        let has_lists = element.properties.iter().filter(|property| property.length.is_some()).count() > 1;
        let (source, limits, parts) = (self.source, self.limits, &mut self.parts);
        let corner_starts = has_lists.then(Vec::new);
        let mut reader =
            FaceRowReader { source, limits, element, list, columns: &mut columns, parts, corner_starts };
        data.each_row(element, ParsedRows::of_faces(element, list), &mut reader)?;
        let mut corner_starts = reader.corner_starts.unwrap_or_default();
        corner_starts.push(self.parts.faces.corner_count() as u32);
        let is_taken = (0..element.properties.len()).map(|column| column == list).collect();
        self.faces = Some(ElementRows { element, columns, is_taken, first, corner_starts });
        Ok(())
    }

    fn strips(&mut self, element: &Element, data: &mut impl Data) -> Result<(), ReadError> {
        let Some(list) = index_list(element) else {
            self.note_skipped("element `tristrips` has no indices and was skipped", element.count, element);
            return skip(element, data);
        };
        let other = element.properties.len() as u64 - 1;
        self.note_skipped("properties of triangle strips were skipped", other, element);
        let (source, form, limits, parts) = (self.source, self.form, self.limits, &mut self.parts);
        let stitches = Stitches::default();
        let mut reader = StripReader { source, limits, element, list, parts, stitches };
        data.each_row(element, None, &mut reader)?;
        let Stitches { count, first } = reader.stitches;
        let message = "triangles that name a vertex twice, which lead from strip to strip, are not faces";
        self.parts.notes.add_many(NoteKind::Stitches, message, count, || place_of(source, form, first));
        Ok(())
    }

    fn edges(&mut self, element: &'a Element, data: &mut impl Data) -> Result<(), ReadError> {
        let Some(ends) = edge_ends(element) else {
            note_edges_without_ends(&mut self.parts.notes, self.source, element);
            return self.table(element, data);
        };
        let mut columns = Columns::new(element);
        let mut reader = EdgeRowReader { element, ends, columns: &mut columns, parts: &mut self.parts };
        data.each_row(element, None, &mut reader)?;
        let is_taken = (0..element.properties.len()).map(|column| ends.contains(&column)).collect();
        self.edges = Some(ElementRows { element, columns, is_taken, first: 0, corner_starts: Vec::new() });
        Ok(())
    }

    fn finish(mut self, header: &Header) -> Result<Parsed, ReadError> {
        if let Some(vertices) = self.vertices.take() {
            vertex_layers(vertices, &mut self.parts);
        }
        if let Some(faces) = self.faces.take() {
            face_layers(faces, &mut self.parts);
        }
        if let Some(edges) = self.edges.take() {
            edge_layers(edges, &mut self.parts);
        }
        let tables = std::mem::take(&mut self.tables);
        let (mesh, notes) =
            self.parts.assemble(self.source, 0, |at| place_of(self.source, header.form, at))?;
        let encoding = match header.form {
            Form::Ascii => Encoding::Ascii,
            Form::LittleEndian => Encoding::LittleEndian,
            Form::BigEndian => Encoding::BigEndian,
        };
        let shell = Shell::of_file(Format::Ply, encoding, PlyShape::new(header, tables, &mesh));
        Ok(Parsed::whole(mesh, notes, shell))
    }
}

/// Notes rows of an element that no mesh holds.
fn note_skipped(notes: &mut Notes, source: &Source<'_>, (message, count): (&str, u64), element: &Element) {
    notes.add_many(NoteKind::SkippedElement, message, count, || source.line(element.at));
}

/// Notes an element of unknown meaning.
pub(super) fn note_unknown(notes: &mut Notes, source: &Source<'_>, element: &Element) {
    let message = format!("element `{}` is not understood: only a PLY output carries it", element.name);
    note_skipped(notes, source, (&message, element.count), element);
}

/// Notes edges that don't say what they join.
pub(super) fn note_edges_without_ends(notes: &mut Notes, source: &Source<'_>, element: &Element) {
    let message = "element `edge` has no `vertex1` and `vertex2`: only a PLY output carries it";
    note_skipped(notes, source, (message, element.count), element);
}

/// Notes what is left behind the last row: so many bytes from a place on.
pub(super) fn note_surplus(
    notes: &mut Notes,
    (surplus, at): (usize, usize),
    place: impl FnOnce(usize) -> Place,
) {
    let message = "bytes after the data were skipped";
    notes.add_many(NoteKind::SurplusData, message, surplus as u64, || place(at));
}

/// The error of an element that lacks what it needs.
pub(super) fn missing(source: &Source<'_>, element: &Element, reason: &str) -> ReadError {
    source.malformed(source.line(element.at), reason)
}

/// The places of the coordinates among the properties of vertices.
pub(super) fn axes(source: &Source<'_>, element: &Element) -> Result<[usize; 3], ReadError> {
    let axis = |name: &str| {
        let is_axis = |property: &header::Property| property.name == name && property.length.is_none();
        let missing = || missing(source, element, &format!("vertices without a number `{name}`"));
        element.properties.iter().position(is_axis).ok_or_else(missing)
    };
    Ok([axis("x")?, axis("y")?, axis("z")?])
}

/// Where each property begins in a row of bytes, if none is a list.
pub(super) fn offsets(element: &Element) -> Vec<usize> {
    let sizes = element.properties.iter().map(|property| property.item.size());
    sizes.scan(0, |end, size| Some(std::mem::replace(end, *end + size))).collect()
}

/// The places of the ends among the properties of edges.
pub(super) fn edge_ends(element: &Element) -> Option<[usize; 2]> {
    let end = |name: &str| element.properties.iter().position(|p| p.name == name && p.length.is_none());
    Some([end("vertex1")?, end("vertex2")?])
}

/// The list of vertex indices among an element's properties.
pub(super) fn index_list(element: &Element) -> Option<usize> {
    let is_named = |p: &header::Property| p.name == "vertex_indices" || p.name == "vertex_index";
    element.properties.iter().position(|property| is_named(property) && property.length.is_some())
}
