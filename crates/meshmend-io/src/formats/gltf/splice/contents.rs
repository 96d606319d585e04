//! What the file is written of: its JSON with what changed, and the bytes of its buffers.

use crate::formats::gltf::asset::Asset;
use crate::formats::gltf::buffers::Held;
use crate::formats::gltf::container::{glb, too_large};
use crate::formats::gltf::file::File;
use crate::formats::gltf::json::{Edits, ListEdit, quoted};
use crate::formats::gltf::splice::layout::Layout;
use crate::formats::gltf::uri::data_uri;
use crate::text::one_or_many;
use crate::{Format, Loss, LossKind, WriteErrorKind};

/// What a file is written of.
pub(super) struct Contents {
    edits: Edits,
    /// The buffer that has other bytes, with all of them; beyond those of the file if it is new.
    changed: Option<(usize, Vec<u8>)>,
}

impl Contents {
    /// The file as it was read.
    pub(super) fn unchanged() -> Self {
        Contents { edits: Edits::default(), changed: None }
    }

    /// The file with other bytes in a buffer, and what of its JSON changed by that.
    pub(super) fn changed(file: &File, layout: Layout, edits: Edits) -> Self {
        let old = file.held.get(layout.buffer).and_then(|held| held.bytes(&file.bytes)).unwrap_or_default();
        let mut bytes = Vec::with_capacity(old.len() + layout.added.len() + 4);
        let mut start = 0;
        for removed in &layout.removed {
            bytes.extend_from_slice(old.get(start..removed.start).unwrap_or_default());
            start = removed.end;
        }
        bytes.extend_from_slice(old.get(start..).unwrap_or_default());
        bytes.resize(bytes.len().next_multiple_of(4), 0);
        bytes.extend_from_slice(&layout.added);
        Contents { edits, changed: Some((layout.buffer, bytes)) }
    }

    /// The bytes of the file in a format.
    ///
    /// # Errors
    /// If a GLB file would have more bytes than its header can say.
    pub(super) fn written(
        mut self,
        file: &File,
        asset: &Asset<'_>,
        format: Format,
        losses: &mut Vec<Loss>,
    ) -> Result<Vec<u8>, WriteErrorKind> {
        let chunk = self.place_buffers(file, asset, format);
        let text = std::str::from_utf8(file.json()).unwrap_or_default();
        let json = self.edits.applied(text);
        let others = file.chunks.as_ref().map(|chunks| &chunks.others[..]).unwrap_or_default();
        if format == Format::Gltf {
            losses.extend(Loss::if_any(LossKind::Elements, others.len(), |count| {
                one_or_many(count, "chunk of another kind is left out", "chunks of other kinds are left out")
            }));
            return Ok(json.into_bytes());
        }
        let others: Vec<(u32, &[u8])> = others
            .iter()
            .map(|(kind, range)| (*kind, file.bytes.get(range.clone()).unwrap_or_default()))
            .collect();
        glb(&json, chunk.as_deref(), &others).ok_or_else(too_large)
    }

    /// Says in the JSON where the bytes of each buffer are, and returns those of the chunk.
    fn place_buffers(&mut self, file: &File, asset: &Asset<'_>, format: Format) -> Option<Vec<u8>> {
        let is_converted = format != file.format();
        let bin = file.chunks.as_ref().and_then(|chunks| chunks.bin.clone());
        let mut chunk = bin.and_then(|range| file.bytes.get(range)).map(<[u8]>::to_vec);
        for (index, held) in file.held.iter().enumerate() {
            let changed = self.changed.take_if(|(changed, _)| *changed == index).map(|(_, bytes)| bytes);
            let is_changed = changed.is_some();
            let mut edit = ListEdit::of(asset.buffers[index]);
            let bytes = || changed.clone().or_else(|| held.bytes(&file.bytes).map(<[u8]>::to_vec));
            if let Some(changed) = &changed {
                edit.set("byteLength", changed.len().to_string());
            }
            match (held, format) {
                (Held::Absent, _) => {}
                (Held::Chunk(_), Format::Glb) => chunk = bytes(),
                (Held::Chunk(_), _) => edit.set("uri", quoted(&data_uri(&bytes().unwrap_or_default()))),
                (Held::Data(_) | Held::File(..), Format::Glb) if is_converted && index == 0 => {
                    edit.remove("uri");
                    chunk = bytes();
                }
                (Held::Data(_), _) if is_changed => {
                    edit.set("uri", quoted(&data_uri(&bytes().unwrap_or_default())))
                }
                (Held::File(..), Format::Glb) if is_converted => {
                    edit.set("uri", quoted(&data_uri(&bytes().unwrap_or_default())));
                }
                (Held::Data(_) | Held::File(..), _) => {}
            }
            edit.into_edits(&mut self.edits);
        }
        if let Some((_, bytes)) = self.changed.take() {
            let is_chunk = format == Format::Glb && file.held.is_empty();
            let uri =
                if is_chunk { String::new() } else { format!(",\"uri\":{}", quoted(&data_uri(&bytes))) };
            add_to_root(
                asset,
                "buffers",
                format!("{{\"byteLength\":{}{uri}}}", bytes.len()),
                &mut self.edits,
            );
            chunk = if is_chunk { Some(bytes) } else { chunk };
        }
        if format == Format::Glb { chunk } else { None }
    }
}

/// Adds an item to an array of the root, which is made if it is not there.
fn add_to_root(asset: &Asset<'_>, name: &str, item: String, edits: &mut Edits) {
    match asset.root.get(name) {
        Some(array) => {
            let mut list = ListEdit::of(array);
            list.push(item);
            list.into_edits(edits);
        }
        None => {
            let mut root = ListEdit::of(asset.root.value);
            root.set(name, format!("[{item}]"));
            root.into_edits(edits);
        }
    }
}

/// The files that must stand beside a file that is written in a format.
pub(super) fn companions(file: &File, format: Format) -> Vec<(Vec<u8>, Vec<u8>)> {
    if format == Format::Glb && format != file.format() {
        return Vec::new();
    }
    let named = |held: &Held| match held {
        Held::File(name, bytes) => Some((name.clone(), bytes.to_vec())),
        _ => None,
    };
    file.held.iter().filter_map(named).collect()
}
