//! The two forms of a file: a GLB, and a text with the buffer in a data URI.

use std::io::Write;

use super::accessors::File;
use super::buffer;
use super::root::text_of;
use crate::formats::gltf::base64::Base64;
use crate::formats::gltf::container::{BIN, CHUNK_HEADER, HEADER, JSON, MAGIC, VERSION, too_large};
use crate::formats::gltf::uri::DATA_URI;
use crate::{Prepared, WriteErrorKind};

/// Writes a GLB.
pub(in crate::formats::gltf) fn encode_glb(
    prepared: &Prepared,
    out: &mut dyn Write,
) -> Result<(), WriteErrorKind> {
    let file = File::of(prepared);
    let mut text = text_of(prepared, &file, None)?;
    text.resize(text.len().next_multiple_of(4), b' ');
    let chunks = if file.length == 0 { 1 } else { 2 };
    let head = (HEADER + chunks * CHUNK_HEADER) as u64;
    let length = u32::try_from(head + text.len() as u64 + file.length).map_err(|_| too_large())?;
    let mut start = Vec::with_capacity(text.len() + head as usize);
    start.extend_from_slice(MAGIC);
    // Each of these is less than the length.
    for number in [VERSION, length, text.len() as u32, JSON] {
        start.extend_from_slice(&number.to_le_bytes());
    }
    start.append(&mut text);
    if file.length > 0 {
        start.extend_from_slice(&(file.length as u32).to_le_bytes());
        start.extend_from_slice(&BIN.to_le_bytes());
    }
    out.write_all(&start)?;
    // This flushes the sink at its end.
    Ok(buffer::write(&file, out)?)
}

/// Writes a text with the buffer in a data URI.
pub(in crate::formats::gltf) fn encode_gltf(
    prepared: &Prepared,
    out: &mut dyn Write,
) -> Result<(), WriteErrorKind> {
    let file = File::of(prepared);
    let text = text_of(prepared, &file, Some(DATA_URI))?;
    // The buffer is the last member, and the URI its last one.
    let place = text.windows(DATA_URI.len()).rposition(|bytes| bytes == DATA_URI.as_bytes());
    let (head, tail) = text.split_at(place.map_or(text.len(), |at| at + DATA_URI.len()));
    out.write_all(head)?;
    let mut encoder = Base64::new(&mut *out);
    buffer::write(&file, &mut encoder)?;
    encoder.finish()?;
    out.write_all(tail)?;
    out.write_all(b"\n")?;
    Ok(out.flush()?)
}
