//! The reader of binary STL.

use meshmend_core::{Carry, Domain, Layer, Metadata, Values, VertexId};

use crate::assemble::Parts;
use crate::read::{Parsed, Source};
use crate::stl::{FACET, HEAD, HEADER};
use crate::text::is_space;
use crate::{Limits, NoteKind, Place, ReadError};

/// How long the file would be if its count were right; nothing when it is too short to have a count.
pub(super) fn claimed_length(bytes: &[u8]) -> Option<u64> {
    bytes.get(HEAD - 4..HEAD).map(|count| HEAD as u64 + FACET as u64 * u64::from(little_endian(count)))
}

fn little_endian(bytes: &[u8]) -> u32 {
    bytes.iter().rev().fold(0, |value, &byte| value << 8 | u32::from(byte))
}

pub(super) fn read(source: &Source<'_>, limits: &Limits) -> Result<Parsed, ReadError> {
    let facets = checked_facets(source)?;
    let count = (facets.len() / FACET) as u64;
    source.limited("faces", count, limits.max_faces)?;
    source.limited("vertices", 3 * count, limits.max_vertices.min(limits.max_corners))?;
    let mut parts = Parts::default();
    parts.positions.reserve_exact(3 * count as usize);
    for (facet, first) in facets.chunks_exact(FACET).zip((0_u32..).step_by(3)) {
        parts.positions.extend([12, 24, 36].map(|at| point(&facet[at..at + 12])));
        parts.faces.push_face([first, first + 1, first + 2].map(VertexId));
    }
    parts.layers.extend(attributes(facets));
    let end = HEAD + facets.len();
    let surplus = source.bytes.len() - end;
    let message = "bytes after the last facet were skipped";
    parts.notes.add_many(NoteKind::SurplusData, message, surplus as u64, || Place::Byte(end as u64));
    let header = &source.bytes[..HEAD - 4];
    let length = header.iter().rposition(|&b| !is_space(b) && b != 0).map_or(0, |last| last + 1);
    if length > 0 {
        parts.metadata.push(Metadata { key: HEADER.to_owned(), value: header[..length].to_vec() });
    }
    let (mesh, notes) = parts.assemble(source, 0, |at| Place::Byte(at as u64))?;
    Ok(Parsed { mesh, variant: "stl-binary", notes })
}

/// The bytes of all facets, if they fit the count.
fn checked_facets<'a>(source: &Source<'a>) -> Result<&'a [u8], ReadError> {
    let bytes = source.bytes;
    let end = Place::Byte(bytes.len() as u64);
    let Some(claimed) = claimed_length(bytes) else {
        return Err(source.malformed(end, "shorter than the header of a binary file"));
    };
    let (count, room) = ((claimed as usize - HEAD) / FACET, (bytes.len() - HEAD) / FACET);
    if room < count {
        return Err(source.malformed(end, format!("{count} facets are announced, there is room for {room}")));
    }
    if room > count {
        let place = Place::Byte(HEAD as u64 - 4);
        return Err(source.malformed(place, format!("{count} facets are announced, but {room} are there")));
    }
    Ok(&bytes[HEAD..HEAD + count * FACET])
}

#[inline]
fn point(bytes: &[u8]) -> [f64; 3] {
    [0, 4, 8].map(|at| f64::from(f32::from_bits(little_endian(&bytes[at..at + 4]))))
}

/// The two bytes that end each facet, if any of them is not 0.
fn attributes(facets: &[u8]) -> Option<Layer> {
    let of_facet = |facet: &[u8]| little_endian(&facet[FACET - 2..]) as u16;
    let values = || facets.chunks_exact(FACET).map(of_facet);
    let is_used = values().any(|value| value != 0);
    let layer = || Layer::direct("attribute", Domain::Face, 1, Carry::Copy, Values::U16(values().collect()));
    is_used.then(layer)
}
