//! The reader of binary STL.

use meshmend_core::{Carry, Domain, Layer, Metadata, Values, VertexId};
use meshmend_geometry::coincident::SharedFinder;

use std::io::Read;

use crate::binary::block_reader::BlockReader;
use crate::formats::stl::colors::Colored;
use crate::formats::stl::form::{ATTRIBUTE, FACET, HEAD, HEADER, claimed_length, little_endian};
use crate::formats::stl::normals::Recomputed;
use crate::input::assemble::{Parts, VertexNotes};
use crate::input::notes::Notes;
use crate::input::source::{Parsed, Source};
use crate::input::streamed::{Announced, MeshSink, Rows};
use crate::shell::NoChoices;
use crate::text::one_or_many;
use crate::{Encoding, Format, Limits, NoteKind, Place, ReadError, Shell};

pub(super) fn read(source: &Source<'_>, rest: &mut dyn Read, limits: &Limits) -> Result<Parsed, ReadError> {
    let count = checked_count(source, limits)?;
    let (mut parts, mut attributes) = (Parts::default(), Attributes::default());
    let mut vertices = Vertices::of(source.shared_places, 3 * count);
    parts.faces.reserve(3 * count);
    parts.notes = each_facet(source, rest, count, |face, corners, attribute| {
        let first = 3 * face as u32;
        vertices.take(corners, 3 * count);
        parts.faces.push_face([first, first + 1, first + 2].map(VertexId));
        attributes.see(face, attribute);
        Ok(())
    })?;
    match vertices {
        Vertices::Each(positions) => parts.positions = positions,
        Vertices::Shared(finder) => parts.places = Some(finder.finish()),
    }
    parts.layers.extend(attributes.layer(count));
    let header = &source.bytes[..HEAD - 4];
    let length = header.iter().rposition(|&b| b != 0).map_or(0, |last| last + 1);
    if length > 0 {
        parts.metadata.push(Metadata { key: HEADER.to_owned(), value: header[..length].to_vec() });
    }
    let (mesh, notes) = parts.assemble(source, 0, |at| Place::Byte(at as u64))?;
    let shell = Shell::of_file(Format::Stl, Encoding::LittleEndian, NoChoices);
    Ok(Parsed::whole(mesh, notes, shell))
}

/// Hands over the facets of a file without keeping any.
pub(super) fn stream(
    source: &Source<'_>,
    rest: &mut dyn Read,
    limits: &Limits,
    sink: &mut dyn MeshSink,
) -> Result<Rows, ReadError> {
    let count = checked_count(source, limits)?;
    let cancelled = |stopped| source.cancelled(stopped);
    let (faces, vertices) = (count as u64, 3 * count as u64);
    let announced =
        Announced { format: Format::Stl, vertices, faces, corners: vertices, is_single: true, is_soup: true };
    sink.begin(&announced).map_err(cancelled)?;
    let mut counted = VertexNotes::default();
    let mut notes = each_facet(source, rest, count, |face, corners, _| {
        let first = 3 * face as u32;
        let positions = corners.map(in_doubles);
        counted.see(&positions);
        sink.vertices(&positions).map_err(cancelled)?;
        sink.face(&[first, first + 1, first + 2].map(VertexId)).map_err(cancelled)
    })?;
    counted.note(&mut notes);
    Ok(Rows { encoding: Encoding::LittleEndian, notes, loose_edges: Vec::new() })
}

/// Hands over each facet: its number, corners and attribute. Returns what there is to say about the file.
fn each_facet(
    source: &Source<'_>,
    rest: &mut dyn Read,
    count: usize,
    mut take: impl FnMut(usize, [[f32; 3]; 3], u16) -> Result<(), ReadError>,
) -> Result<Notes, ReadError> {
    let mut facets = BlockReader::new(source, HEAD, rest);
    let (mut recomputed, mut colored) = (Recomputed::default(), Colored::default());
    let mut read = 0;
    while read < count {
        let block = facets.take_rows(FACET, count - read).map_err(|error| source.failed(error))?;
        for (facet, face) in block.chunks_exact(FACET).zip(read..) {
            let corners = [12, 24, 36].map(|at| point(&facet[at..at + 12]));
            let normal = in_doubles(point(&facet[..12]));
            recomputed.see(normal, corners.map(in_doubles), HEAD + face * FACET);
            let attribute = little_endian(&facet[FACET - 2..]) as u16;
            colored.see(face, attribute);
            take(face, corners, attribute)?;
        }
        read += block.len() / FACET;
    }
    let mut notes = Notes::default();
    colored.note(&source.bytes[..HEAD - 4], &mut notes);
    recomputed.note(&mut notes, |at| Place::Byte(at as u64));
    let message = "bytes after the last facet were skipped";
    let (surplus, end) = (facets.left() as u64, facets.at() as u64);
    notes.add_many(NoteKind::SurplusData, message, surplus, || Place::Byte(end));
    Ok(notes)
}

/// The number of facets, or an error if the length of the file does not fit it, or it is beyond a limit.
fn checked_count(source: &Source<'_>, limits: &Limits) -> Result<usize, ReadError> {
    let end = Place::Byte(source.length as u64);
    let Some(claimed) = claimed_length(source.bytes) else {
        return Err(source.malformed(end, "shorter than the header of a binary file"));
    };
    let (count, room) = ((claimed as usize - HEAD) / FACET, (source.length - HEAD) / FACET);
    if room < count {
        let announced = one_or_many(count, "facet is", "facets are");
        return Err(source.malformed(end, format!("{announced} announced, there is room for {room}")));
    }
    if room > count {
        let place = Place::Byte(HEAD as u64 - 4);
        let announced = one_or_many(count, "facet is", "facets are");
        let there = one_or_many(room, "is", "are");
        return Err(source.malformed(place, format!("{announced} announced, but {there} there")));
    }
    source.limited("faces", count as u64, limits.max_faces)?;
    source.limited("vertices", 3 * count as u64, limits.max_vertices.min(limits.max_corners))?;
    Ok(count)
}

/// The two bytes that end each facet, up to the last facet where they are not 0.
#[derive(Default)]
struct Attributes(Vec<u16>);

impl Attributes {
    #[inline]
    fn see(&mut self, face: usize, value: u16) {
        if value != 0 {
            self.0.resize(face, 0);
            self.0.push(value);
        }
    }

    /// The attributes of all faces, if one of them is not 0.
    fn layer(mut self, faces: usize) -> Option<Layer> {
        if self.0.is_empty() {
            return None;
        }
        self.0.resize(faces, 0);
        Some(Layer::direct(ATTRIBUTE, Domain::Face, 1, Carry::Copy, Values::U16(self.0)))
    }
}

/// The vertices, three a facet.
enum Vertices {
    Each(Vec<[f64; 3]>),
    Shared(SharedFinder),
}

impl Vertices {
    fn of(are_shared: bool, count: usize) -> Self {
        if are_shared {
            Vertices::Shared(SharedFinder::for_points(count))
        } else {
            Vertices::Each(Vec::with_capacity(count))
        }
    }

    /// Takes the corners of a facet, of so many vertices in all.
    #[inline]
    fn take(&mut self, corners: [[f32; 3]; 3], count: usize) {
        match self {
            Vertices::Each(positions) => positions.extend(corners.map(in_doubles)),
            Vertices::Shared(finder) => {
                if !finder.take(&corners) {
                    let mut positions = Vec::with_capacity(count);
                    positions.extend(std::mem::take(finder).into_points());
                    *self = Vertices::Each(positions);
                }
            }
        }
    }
}

#[inline]
fn point(bytes: &[u8]) -> [f32; 3] {
    [0, 4, 8].map(|at| f32::from_bits(little_endian(&bytes[at..at + 4])))
}

#[inline]
fn in_doubles(point: [f32; 3]) -> [f64; 3] {
    point.map(f64::from)
}
