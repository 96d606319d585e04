//! The records of a zip archive as they are written.
//!
//! A number that its field can't hold is all ones there, and stands in an extra field (zip 64).

use std::io::{self, Write};

use flate2::write::DeflateEncoder;
use flate2::{Compression, Crc};

const LOCAL: [u8; 4] = *b"PK\x03\x04";
const RECORD: [u8; 4] = *b"PK\x01\x02";
const END: [u8; 4] = *b"PK\x05\x06";
const END_64: [u8; 4] = *b"PK\x06\x06";
const LOCATOR_64: [u8; 4] = *b"PK\x06\x07";
/// The version that a reader needs for deflated entries and folders, and for zip 64.
const VERSION: u16 = 20;
const VERSION_64: u16 = 45;
const EXTRA_64: u16 = 1;
/// The first of January 1980: no clock shows in the bytes.
const DATE: [u8; 4] = [0, 0, 0x21, 0];

/// What a header says of the content of an entry.
pub(super) struct Content {
    pub(super) is_deflated: bool,
    pub(super) checksum: u32,
    /// How many bytes it takes in the archive.
    pub(super) packed: u64,
    /// How many bytes it has.
    pub(super) length: u64,
}

/// The content of an entry as it is stored, with what a header says of it.
pub(in crate::formats::threemf) struct Packed {
    pub(super) content: Content,
    pub(super) bytes: Vec<u8>,
}

/// Takes in the content of an entry, and packs it.
pub(in crate::formats::threemf) struct Packer {
    sink: PackerSink,
    checksum: Crc,
    length: u64,
}

enum PackerSink {
    Deflated(DeflateEncoder<Vec<u8>>),
    Stored(Vec<u8>),
}

impl Packer {
    pub(in crate::formats::threemf) fn deflating() -> Self {
        let encoder = DeflateEncoder::new(Vec::new(), Compression::default());
        Packer { sink: PackerSink::Deflated(encoder), checksum: Crc::new(), length: 0 }
    }

    pub(super) fn storing() -> Self {
        Packer { sink: PackerSink::Stored(Vec::new()), checksum: Crc::new(), length: 0 }
    }

    /// What was taken in.
    pub(in crate::formats::threemf) fn finish(self) -> io::Result<Packed> {
        let (is_deflated, bytes) = match self.sink {
            PackerSink::Deflated(encoder) => (true, encoder.finish()?),
            PackerSink::Stored(bytes) => (false, bytes),
        };
        let (checksum, length) = (self.checksum.sum(), self.length);
        let content = Content { is_deflated, checksum, packed: bytes.len() as u64, length };
        Ok(Packed { content, bytes })
    }
}

impl Write for Packer {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match &mut self.sink {
            PackerSink::Deflated(encoder) => encoder.write_all(bytes)?,
            PackerSink::Stored(stored) => stored.extend_from_slice(bytes),
        }
        self.checksum.update(bytes);
        self.length += bytes.len() as u64;
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// What a local header and a record say of an entry beside its content.
pub(super) struct Label<'a> {
    pub(super) name: &'a [u8],
    /// Whether the name is UTF-8 that is no ASCII, and other bits that say how bytes are to be read.
    pub(super) flags: u16,
    pub(super) date: [u8; 4],
    /// Extra fields, without those of zip 64.
    pub(super) extra: Vec<u8>,
}

impl<'a> Label<'a> {
    pub(super) fn new(name: &'a str) -> Self {
        let flags = if name.is_ascii() { 0 } else { 1 << 11 };
        Label { name: name.as_bytes(), flags, date: DATE, extra: Vec::new() }
    }
}

/// What only a record in the directory says.
pub(super) struct Origin<'a> {
    pub(super) made_by: [u8; 2],
    /// The disk, and the attributes within and outside of the archive.
    pub(super) attributes: [u8; 8],
    pub(super) comment: &'a [u8],
}

impl Origin<'_> {
    pub(super) const NEW: Origin<'static> =
        Origin { made_by: [VERSION as u8, 0], attributes: [0; 8], comment: &[] };
}

/// Appends a local header and the content behind it.
pub(super) fn push_entry(out: &mut Vec<u8>, label: &Label<'_>, Packed { content, bytes }: &Packed) {
    let sizes = [content.length, content.packed];
    let is_large = sizes.iter().any(|&size| short(size) == u32::MAX);
    // A local header has both sizes in the extra field or none.
    let wide = if is_large { &sizes[..] } else { &[] };
    out.extend_from_slice(&LOCAL);
    push_common(out, label, content, wide);
    if is_large {
        let sizes = out.len() - 12;
        out[sizes..sizes + 8].fill(0xff);
    }
    out.extend_from_slice(label.name);
    push_extra(out, label, wide);
    out.extend_from_slice(bytes);
}

/// Appends a record of the directory.
pub(super) fn push_record(
    out: &mut Vec<u8>,
    label: &Label<'_>,
    origin: &Origin<'_>,
    content: &Content,
    at: u64,
) {
    let sizes = [content.length, content.packed, at];
    let wide: Vec<u64> = sizes.into_iter().filter(|&number| short(number) == u32::MAX).collect();
    out.extend_from_slice(&RECORD);
    out.extend_from_slice(&origin.made_by);
    push_common(out, label, content, &wide);
    out.extend_from_slice(&(origin.comment.len() as u16).to_le_bytes());
    out.extend_from_slice(&origin.attributes);
    out.extend_from_slice(&short(at).to_le_bytes());
    out.extend_from_slice(label.name);
    push_extra(out, label, &wide);
    out.extend_from_slice(origin.comment);
}

/// What a local header and a record have in common: from the version to the length of the extra fields.
fn push_common(out: &mut Vec<u8>, label: &Label<'_>, content: &Content, wide: &[u64]) {
    let version = if wide.is_empty() { VERSION } else { VERSION_64 };
    let method: u16 = if content.is_deflated { 8 } else { 0 };
    let extra = label.extra.len() + if wide.is_empty() { 0 } else { 4 + 8 * wide.len() };
    for number in [version, label.flags, method] {
        out.extend_from_slice(&number.to_le_bytes());
    }
    out.extend_from_slice(&label.date);
    for number in [content.checksum, short(content.packed), short(content.length)] {
        out.extend_from_slice(&number.to_le_bytes());
    }
    for number in [label.name.len(), extra] {
        out.extend_from_slice(&(number as u16).to_le_bytes());
    }
}

fn push_extra(out: &mut Vec<u8>, label: &Label<'_>, wide: &[u64]) {
    if !wide.is_empty() {
        out.extend_from_slice(&EXTRA_64.to_le_bytes());
        out.extend_from_slice(&(8 * wide.len() as u16).to_le_bytes());
        wide.iter().for_each(|number| out.extend_from_slice(&number.to_le_bytes()));
    }
    out.extend_from_slice(&label.extra);
}

/// Extra fields without those of zip 64. Bytes that are no field stay.
pub(super) fn without_64(mut extra: &[u8]) -> Vec<u8> {
    let mut kept = Vec::with_capacity(extra.len());
    while let [a, b, c, d, rest @ ..] = extra {
        let length = usize::from(u16::from_le_bytes([*c, *d]));
        let Some((_, after)) = rest.split_at_checked(length) else { break };
        if u16::from_le_bytes([*a, *b]) != EXTRA_64 {
            kept.extend_from_slice(&extra[..4 + length]);
        }
        extra = after;
    }
    kept.extend_from_slice(extra);
    kept
}

/// Appends the end of an archive whose directory begins and ends at these bytes.
pub(super) fn push_end(out: &mut Vec<u8>, entries: usize, directory: u64, comment: &[u8]) {
    let end = out.len() as u64;
    let length = end - directory;
    let count = u16::try_from(entries).unwrap_or(u16::MAX);
    if count == u16::MAX || short(length) == u32::MAX || short(directory) == u32::MAX {
        out.extend_from_slice(&END_64);
        out.extend_from_slice(&44_u64.to_le_bytes());
        out.extend_from_slice(&[VERSION_64 as u8, 0, VERSION_64 as u8, 0, 0, 0, 0, 0, 0, 0, 0, 0]);
        for number in [entries as u64, entries as u64, length, directory] {
            out.extend_from_slice(&number.to_le_bytes());
        }
        out.extend_from_slice(&LOCATOR_64);
        out.extend_from_slice(&[0; 4]);
        out.extend_from_slice(&end.to_le_bytes());
        out.extend_from_slice(&1_u32.to_le_bytes());
    }
    out.extend_from_slice(&END);
    out.extend_from_slice(&[0; 4]);
    out.extend_from_slice(&count.to_le_bytes());
    out.extend_from_slice(&count.to_le_bytes());
    out.extend_from_slice(&short(length).to_le_bytes());
    out.extend_from_slice(&short(directory).to_le_bytes());
    out.extend_from_slice(&(comment.len() as u16).to_le_bytes());
    out.extend_from_slice(comment);
}

/// A number as a field of 32 bits holds it; all ones where it does not.
pub(super) fn short(number: u64) -> u32 {
    u32::try_from(number).unwrap_or(u32::MAX)
}
