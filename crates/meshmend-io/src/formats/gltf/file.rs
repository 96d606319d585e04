//! A file as it was read: its bytes, and where in them what is.

use std::ops::Range;

use crate::formats::gltf::asset::Asset;
use crate::formats::gltf::buffers::{Beside, Bytes, Held, held};
use crate::formats::gltf::container::{self, Chunks};
use crate::formats::gltf::fault::Fault;
use crate::formats::gltf::json;
use crate::input::notes::Notes;
use crate::text::{line_number, without_mark};
use crate::{Format, Limits, Place};

/// A file with the bytes of all its buffers.
#[derive(Debug)]
pub(super) struct File {
    pub(super) bytes: Vec<u8>,
    /// Where its JSON is.
    pub(super) json: Range<usize>,
    /// Its chunks, if it is a GLB file.
    pub(super) chunks: Option<Chunks>,
    pub(super) held: Vec<Held>,
    limits: Limits,
}

impl File {
    /// Opens a file of these bytes.
    ///
    /// # Errors
    /// If its container or its JSON is malformed, or the bytes of a buffer are not there.
    pub(super) fn open(bytes: Vec<u8>, beside: Beside<'_>, notes: &mut Notes) -> Result<Self, Fault> {
        let limits = *beside.limits;
        let is_glb = bytes.starts_with(container::MAGIC);
        let chunks = if is_glb { Some(container::chunks(&bytes, notes)?) } else { None };
        let mark = bytes.len() - without_mark(&bytes).len();
        let json = chunks.as_ref().map_or(mark..bytes.len(), |chunks| chunks.json.clone());
        let mut file = File { bytes, json, chunks, held: Vec::new(), limits };
        let asset = file.asset()?;
        let bin = file.chunks.as_ref().and_then(|chunks| chunks.bin.as_ref());
        let held = held(&asset, bin, beside)?;
        file.held = held;
        Ok(file)
    }

    /// The text of its JSON.
    pub(super) fn json(&self) -> &[u8] {
        self.bytes.get(self.json.clone()).unwrap_or_default()
    }

    /// Its JSON, opened.
    ///
    /// # Errors
    /// If it is malformed. That of a file that was opened is not.
    pub(super) fn asset(&self) -> Result<Asset<'_>, Fault> {
        let in_file = |fault: Fault| Fault { place: self.place(fault.place), ..fault };
        Asset::of(json::parse(self.json(), &self.limits).map_err(in_file)?, &self.limits)
    }

    /// Where in the file something is that is in its JSON: the line of a text, the byte of a GLB file.
    fn place(&self, place: Place) -> Place {
        match place {
            Place::Byte(byte) if self.chunks.is_some() => Place::Byte(byte + self.json.start as u64),
            Place::Byte(byte) => Place::Line(line_number(&self.bytes, self.json.start + byte as usize)),
            other => other,
        }
    }

    /// The bytes of its buffers.
    pub(super) fn buffers(&self) -> Bytes<'_> {
        Bytes::of(&self.bytes, &self.held)
    }

    /// Its format.
    pub(super) fn format(&self) -> Format {
        if self.chunks.is_some() { Format::Glb } else { Format::Gltf }
    }
}
