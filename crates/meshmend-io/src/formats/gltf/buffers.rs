//! The bytes of buffers: a chunk of the file, a data URI, or a file beside it.

use std::ops::Range;
use std::sync::Arc;

use crate::Limits;
use crate::formats::gltf::accessor::Place;
use crate::formats::gltf::asset::Asset;
use crate::formats::gltf::fault::{Fault, Pointer};
use crate::formats::gltf::json::Object;
use crate::formats::gltf::uri::{self, Named};
use crate::input::folder::{Folder, NotOpened};

/// The bytes of one buffer.
#[derive(Clone, Debug)]
pub(super) enum Held {
    /// Those of the chunk of a GLB file.
    Chunk(Range<usize>),
    /// Those of a data URI.
    Data(Arc<Vec<u8>>),
    /// Those of a file, with its name.
    File(Vec<u8>, Arc<Vec<u8>>),
    /// None: an extension says where they are.
    Absent,
}

impl Held {
    /// The bytes, given those of the file.
    pub(super) fn bytes<'a>(&'a self, file: &'a [u8]) -> Option<&'a [u8]> {
        match self {
            Held::Chunk(range) => file.get(range.clone()),
            Held::Data(bytes) | Held::File(_, bytes) => Some(bytes),
            Held::Absent => None,
        }
    }
}

/// Finds the bytes of all buffers.
///
/// # Errors
/// If a buffer has fewer bytes than it says, or its file is missing or outside the folder.
pub(super) fn held(
    asset: &Asset<'_>,
    chunk: Option<&Range<usize>>,
    beside: Beside<'_>,
) -> Result<Vec<Held>, Fault> {
    (0..asset.buffers.len()).map(|index| held_by(asset, index, chunk, beside)).collect()
}

/// Where the files are that a file names, and how much of them may be opened.
#[derive(Clone, Copy)]
pub(super) struct Beside<'a> {
    pub(super) folder: Option<&'a Folder>,
    pub(super) limits: &'a Limits,
}

fn held_by(
    asset: &Asset<'_>,
    index: usize,
    chunk: Option<&Range<usize>>,
    beside: Beside<'_>,
) -> Result<Held, Fault> {
    let pointer = Pointer::item("buffers", index);
    let buffer = Object::of(asset.buffers[index], pointer.clone())?;
    let length = buffer.count_or("byteLength", 0)?;
    let held = match (buffer.text("uri")?, chunk) {
        (Some(uri), _) => named_by(&uri, beside).map_err(|reason| buffer.fault_in("uri", reason))?,
        (None, Some(chunk)) if index == 0 => Held::Chunk(chunk.clone()),
        (None, _) => Held::Absent,
    };
    let found = match &held {
        Held::Chunk(range) => range.len(),
        Held::Data(bytes) | Held::File(_, bytes) => bytes.len(),
        Held::Absent => return Ok(held),
    };
    if (found as u64) < length {
        return Err(pointer.fault(format!("says that it has {length} bytes, and has {found}")));
    }
    Ok(held)
}

fn named_by(uri: &str, beside: Beside<'_>) -> Result<Held, String> {
    match uri::named(uri)? {
        Named::Data(data) => Ok(Held::Data(Arc::new(uri::decoded(data)?))),
        Named::File(name) => {
            let shown = String::from_utf8_lossy(&name).into_owned();
            let folder = beside.folder.ok_or_else(|| {
                format!("names the file `{shown}`, which is not opened: the folder of the input is not known")
            })?;
            let bytes = folder.open(&name, beside.limits).map_err(|why| reason(&shown, &why))?;
            Ok(Held::File(name, Arc::new(bytes)))
        }
    }
}

fn reason(name: &str, why: &NotOpened) -> String {
    match why {
        NotOpened::Missing => format!("`{name}` is missing"),
        NotOpened::Outside => format!("`{name}` is outside the folder of the file and was not opened"),
        NotOpened::TooManyFiles => format!("`{name}` is one file too many (max_companion_files)"),
        NotOpened::TooManyBytes => {
            format!("`{name}` has more bytes than the limit allows (max_companion_bytes)")
        }
        NotOpened::Io(error) => format!("`{name}`: {error}"),
    }
}

/// The bytes of all buffers, as they are looked at.
pub(super) struct Bytes<'a> {
    buffers: Vec<Option<&'a [u8]>>,
    /// How many bytes there are in all.
    pub(super) total: usize,
}

impl<'a> Bytes<'a> {
    pub(super) fn of(file: &'a [u8], held: &'a [Held]) -> Self {
        let buffers: Vec<Option<&[u8]>> = held.iter().map(|held| held.bytes(file)).collect();
        let beside = |held: &&Held| !matches!(held, Held::Chunk(_));
        let beside: usize =
            held.iter().filter(beside).filter_map(|held| held.bytes(file)).map(<[u8]>::len).sum();
        Bytes { buffers, total: file.len() + beside }
    }

    /// All bytes of a buffer.
    pub(super) fn buffer(&self, index: usize) -> Option<&'a [u8]> {
        self.buffers.get(index).copied().flatten()
    }

    /// The bytes of so many rows of so many bytes each.
    ///
    /// # Errors
    /// If the buffer has no bytes.
    pub(super) fn rows(&self, place: &Place, count: usize, size: usize) -> Result<&'a [u8], Fault> {
        let length = count.saturating_sub(1) * place.stride + size;
        let bytes = self.buffer(place.buffer).and_then(|bytes| bytes.get(place.start..)?.get(..length));
        bytes.ok_or_else(|| Pointer::item("buffers", place.buffer).fault("has no bytes in this file"))
    }
}
