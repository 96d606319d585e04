//! GLB: a header, a chunk of JSON, perhaps a chunk of bytes, and chunks of other kinds, which are kept.

use std::io;
use std::ops::Range;

use crate::formats::gltf::fault::Fault;
use crate::input::notes::Notes;
use crate::{NoteKind, Place, WriteErrorKind};

/// The first bytes of every GLB file.
pub(super) const MAGIC: &[u8; 4] = b"glTF";
/// Of the format as a whole.
pub(super) const VERSION: u32 = 2;
pub(super) const HEADER: usize = 12;
pub(super) const CHUNK_HEADER: usize = 8;
pub(super) const JSON: u32 = u32::from_le_bytes(*b"JSON");
pub(super) const BIN: u32 = u32::from_le_bytes(*b"BIN\0");

/// Where the chunks of a GLB file are.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Chunks {
    pub(super) json: Range<usize>,
    /// The bytes of the first buffer.
    pub(super) bin: Option<Range<usize>>,
    /// Chunks of other kinds, in order.
    pub(super) others: Vec<(u32, Range<usize>)>,
}

/// Finds the chunks of a GLB file.
///
/// # Errors
/// If the file is cut off, has another version, or does not begin with JSON.
pub(super) fn chunks(bytes: &[u8], notes: &mut Notes) -> Result<Chunks, Fault> {
    check_header(bytes)?;
    let at = |place: usize| Place::Byte(place as u64);
    let (version, length) = (word(bytes, 4), word(bytes, 8));
    if version != Some(VERSION) {
        let found = version.unwrap_or_default();
        return Err(Fault::new(at(4), format!("version {found} of GLB is not read, only version {VERSION}")));
    }
    let length = length.unwrap_or_default() as usize;
    if length > bytes.len() {
        let reason =
            format!("the file is cut off: it says that it has {length} bytes, and has {}", bytes.len());
        return Err(Fault::new(at(8), reason));
    }
    if length < bytes.len() {
        notes.add(NoteKind::SurplusData, "bytes after the end of the file", || at(length));
    }
    let mut found: Vec<(u32, Range<usize>)> = Vec::new();
    let mut next = HEADER;
    while next < length {
        let chunk = chunk_at(&bytes[..length], next)?;
        if chunk.1.len() % 4 != 0 {
            notes.add(NoteKind::Misaligned, "chunks whose length is not a multiple of 4", || at(next));
        }
        next = chunk.1.end;
        found.push(chunk);
    }
    sorted_by_kind(found)
}

/// Whether a file begins as GLB files do.
///
/// # Errors
/// If it does not.
pub(super) fn check_header(bytes: &[u8]) -> Result<(), Fault> {
    if bytes.len() >= HEADER && bytes.starts_with(MAGIC) {
        return Ok(());
    }
    Err(Fault::new(Place::Byte(0), "the header of a GLB file is not there"))
}

fn chunk_at(bytes: &[u8], start: usize) -> Result<(u32, Range<usize>), Fault> {
    let (Some(length), Some(kind)) = (word(bytes, start), word(bytes, start + 4)) else {
        return Err(Fault::new(Place::Byte(start as u64), "the header of a chunk is cut off"));
    };
    let data = start + CHUNK_HEADER;
    match data.checked_add(length as usize).filter(|&end| end <= bytes.len()) {
        Some(end) => Ok((kind, data..end)),
        None => {
            let reason = format!(
                "the chunk is cut off: it says that it has {length} bytes, and {} follow",
                bytes.len() - data
            );
            Err(Fault::new(Place::Byte(start as u64), reason))
        }
    }
}

/// The chunk of JSON comes first, and that of bytes second if there is one.
fn sorted_by_kind(found: Vec<(u32, Range<usize>)>) -> Result<Chunks, Fault> {
    let mut chunks = found.into_iter();
    let json = match chunks.next() {
        Some((JSON, json)) => json,
        _ => return Err(Fault::new(Place::Byte(HEADER as u64), "the first chunk is not JSON")),
    };
    let mut others: Vec<_> = chunks.collect();
    let bin = match others.first() {
        Some((BIN, _)) => Some(others.remove(0).1),
        _ => None,
    };
    if let Some((_, second)) = others.iter().find(|(kind, _)| [JSON, BIN].contains(kind)) {
        let place = Place::Byte((second.start - CHUNK_HEADER) as u64);
        return Err(Fault::new(place, "a chunk of JSON or bytes is not in its place"));
    }
    Ok(Chunks { json, bin, others })
}

fn word(bytes: &[u8], at: usize) -> Option<u32> {
    let bytes = bytes.get(at..)?.get(..4)?.try_into().ok()?;
    Some(u32::from_le_bytes(bytes))
}

/// The error when a GLB would have more bytes than its header can say.
pub(super) fn too_large() -> WriteErrorKind {
    io::Error::new(io::ErrorKind::FileTooLarge, "a GLB has at most 4 GiB; a glTF has no such limit").into()
}

/// A GLB file with these chunks; `None` if it would have more bytes than its header can say.
///
/// *Cost*: linear in the bytes.
pub(super) fn glb(json: &str, bin: Option<&[u8]>, others: &[(u32, &[u8])]) -> Option<Vec<u8>> {
    let chunks = [(JSON, json.as_bytes())].into_iter().chain(bin.map(|bin| (BIN, bin)));
    let chunks: Vec<(u32, &[u8])> = chunks.chain(others.iter().copied()).collect();
    let length = chunks.iter().map(|(_, data)| CHUNK_HEADER + data.len().next_multiple_of(4)).sum::<usize>();
    let length = u32::try_from(HEADER + length).ok()?;
    let mut out = Vec::with_capacity(length as usize);
    out.extend_from_slice(MAGIC);
    out.extend_from_slice(&VERSION.to_le_bytes());
    out.extend_from_slice(&length.to_le_bytes());
    for (kind, data) in chunks {
        let padded = data.len().next_multiple_of(4);
        out.extend_from_slice(&(padded as u32).to_le_bytes());
        out.extend_from_slice(&kind.to_le_bytes());
        out.extend_from_slice(data);
        let padding = if kind == JSON { b' ' } else { 0 };
        out.resize(out.len() + padded - data.len(), padding);
    }
    Some(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(bytes: &[u8]) -> Result<Chunks, String> {
        chunks(bytes, &mut Notes::default()).map_err(|fault| format!("{}: {}", fault.place, fault.kind))
    }

    #[test]
    fn what_is_written_is_found_again() {
        let other = (u32::from_le_bytes(*b"XYZ1"), &b"12345678"[..]);
        let file = glb("{}", Some(&[1, 2, 3]), &[other]).unwrap();
        let chunks = found(&file).unwrap();
        assert_eq!(&file[chunks.json], b"{}  ");
        assert_eq!(&file[chunks.bin.unwrap()], [1, 2, 3, 0]);
        assert_eq!((chunks.others[0].0, &file[chunks.others[0].1.clone()]), other);
        let file = glb("{ }", None, &[]).unwrap();
        assert_eq!((file.len(), found(&file).unwrap().bin), (24, None));
    }

    #[test]
    fn every_cut_is_an_error_and_surplus_bytes_are_noted() {
        let file = glb("{}", Some(&[1, 2, 3, 4]), &[]).unwrap();
        for length in 0..file.len() {
            assert!(found(&file[..length]).is_err(), "{length}");
            // A header that tells the length of what is there.
            let mut cut = file[..length].to_vec();
            if length >= HEADER {
                cut[8..12].copy_from_slice(&(length as u32).to_le_bytes());
                let whole = [20 + 4, file.len()];
                assert_eq!(found(&cut).is_ok(), whole.contains(&length), "{length}");
            }
        }
        let mut notes = Notes::default();
        let longer = [&file[..], b"xx"].concat();
        assert_eq!(chunks(&longer, &mut notes).unwrap(), found(&file).unwrap());
        assert_eq!(notes.into_list()[0].kind, NoteKind::SurplusData);
    }

    #[test]
    fn chunks_in_other_places_and_other_versions_are_errors() {
        let file = glb("{}", Some(&[1, 2, 3, 4]), &[]).unwrap();
        let with = |at: usize, word: u32| {
            let mut bytes = file.clone();
            bytes[at..at + 4].copy_from_slice(&word.to_le_bytes());
            found(&bytes)
        };
        assert_eq!(with(4, 1).unwrap_err(), "byte 4: version 1 of GLB is not read, only version 2");
        assert_eq!(with(16, BIN).unwrap_err(), "byte 12: the first chunk is not JSON");
        assert_eq!(with(28, JSON).unwrap_err(), "byte 24: a chunk of JSON or bytes is not in its place");
        assert!(with(12, u32::MAX).unwrap_err().contains("says that it has 4294967295 bytes, and 16 follow"));
        assert!(with(8, u32::MAX).unwrap_err().starts_with("byte 8: the file is cut off"));
        // A length that is not a multiple of 4 is read as it is.
        let mut odd = glb("{ }", None, &[]).unwrap();
        odd.pop();
        odd[8..12].copy_from_slice(&23_u32.to_le_bytes());
        odd[12..16].copy_from_slice(&3_u32.to_le_bytes());
        let mut notes = Notes::default();
        assert_eq!(chunks(&odd, &mut notes).unwrap().json, 20..23);
        assert_eq!(notes.into_list()[0].kind, NoteKind::Misaligned);
    }
}
