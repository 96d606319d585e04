//! What is in a package: the entries of a zip archive, each with the place of its bytes.

use std::collections::BTreeMap;
use std::ops::Range;

use rawzip::{CompressionMethod, ZipArchive, ZipFileHeaderRecord, ZipSliceArchive};

use super::fault::Fault;

/// The entries of a package in the order of its directory.
#[derive(Clone, Debug)]
pub(in crate::formats::threemf) struct Directory {
    pub(super) entries: Vec<Entry>,
    /// The place of each entry by its name in lower case.
    names: BTreeMap<String, usize>,
    /// What the archive says of itself.
    pub(super) comment: Vec<u8>,
}

/// One file in a package. The ranges are bytes of the archive.
#[derive(Clone, Debug)]
pub(in crate::formats::threemf) struct Entry {
    /// Its name, with `/` between folders and without one at the start.
    pub(in crate::formats::threemf) name: String,
    /// From its local header to that of the next entry.
    pub(super) whole: Range<usize>,
    /// Its bytes as stored.
    pub(super) data: Range<usize>,
    /// Its record in the directory.
    pub(super) record: Range<usize>,
    pub(super) is_deflated: bool,
    pub(super) checksum: u32,
    pub(super) length: u64,
}

impl Directory {
    /// The entries of an archive.
    ///
    /// # Errors
    /// If it is no archive, two entries overlap or have the same name, or one is encrypted, packed in another way than
    /// by deflating, or named with `..`.
    ///
    /// *Cost*: O(n log n) in the number of entries.
    pub(in crate::formats::threemf) fn of(bytes: &[u8]) -> Result<Self, Fault> {
        let no_archive = |error: rawzip::Error| {
            let at = if bytes.starts_with(b"PK") { bytes.len() as u64 } else { 0 };
            let reason = error.to_string();
            Fault::at_byte(at, format!("no zip archive, or a damaged one: {}", lowered(&reason)))
        };
        let archive = ZipArchive::from_slice(bytes).map_err(no_archive)?;
        let mut entries = Vec::new();
        let mut records = archive.entries();
        while let Some(record) = records.next_entry().map_err(no_archive)? {
            entries.push(entry(&archive, &record)?);
        }
        if entries.len() as u64 != archive.entries_hint() {
            let (found, said) = (entries.len(), archive.entries_hint());
            let reason = format!("the archive says that it has {said} entries, but has {found}");
            return Err(Fault::at_byte(archive.eocd_offset(), reason));
        }
        bound(&mut entries, archive.directory_offset())?;
        let names = names_of(&entries)?;
        Ok(Directory { entries, names, comment: archive.comment().as_bytes().to_vec() })
    }

    /// The entry of a name, in any case and with or without `/` at its start, and its place in the directory.
    pub(in crate::formats::threemf) fn entry(&self, name: &str) -> Option<(usize, &Entry)> {
        let name = name.trim_start_matches('/').to_ascii_lowercase();
        let place = *self.names.get(&name)?;
        self.entries.get(place).map(|entry| (place, entry))
    }
}

fn entry(archive: &ZipSliceArchive<&[u8]>, record: &ZipFileHeaderRecord<'_>) -> Result<Entry, Fault> {
    let raw = record.file_path().as_bytes().to_vec();
    let name = String::from_utf8_lossy(&raw).replace('\\', "/").trim_start_matches('/').to_owned();
    let wrong = |reason: &str| Fault::of_entry(&name, reason);
    if name.split('/').any(|folder| folder == "..") {
        return Err(wrong("the name leads out of the package"));
    }
    let flags = record.flags();
    if flags.is_encrypted() || flags.has_strong_encryption() || flags.is_masked() {
        return Err(wrong("the entry is encrypted"));
    }
    let is_deflated = match record.compression_method() {
        CompressionMethod::STORE => false,
        CompressionMethod::DEFLATE => true,
        other => {
            return Err(wrong(&format!(
                "the entry is packed with {other}: a 3MF package is stored or deflated"
            )));
        }
    };
    let found = archive.get_entry(record.wayfinder()).map_err(|error| {
        wrong(&format!("the entry is damaged or cut off: {}", lowered(&error.to_string())))
    })?;
    let (start, end) = found.compressed_data_range();
    let at = record.central_directory_offset() as usize;
    let length = RECORD
        + raw.len()
        + record.extra_fields().remaining_bytes().len()
        + record.comment().as_bytes().len();
    Ok(Entry {
        name,
        whole: record.local_header_offset() as usize..end as usize,
        data: start as usize..end as usize,
        record: at..at + length,
        is_deflated,
        checksum: record.crc32(),
        length: record.uncompressed_size_hint(),
    })
}

/// The bytes of a record in the directory before its name.
const RECORD: usize = 46;

/// Lets each entry reach to the next one, so that what stands behind its data is copied with it.
fn bound(entries: &mut [Entry], directory: u64) -> Result<(), Fault> {
    let mut order: Vec<usize> = (0..entries.len()).collect();
    order.sort_by_key(|&at| entries[at].whole.start);
    let mut next = directory as usize;
    for &at in order.iter().rev() {
        let entry = &mut entries[at];
        if entry.whole.end > next {
            return Err(Fault::of_entry(&entry.name, "the entry overlaps with what follows it"));
        }
        entry.whole.end = next;
        next = entry.whole.start;
    }
    Ok(())
}

/// The place of each entry by its name in lower case, which no two may share.
fn names_of(entries: &[Entry]) -> Result<BTreeMap<String, usize>, Fault> {
    let mut names = BTreeMap::new();
    for (place, entry) in entries.iter().enumerate() {
        let name = entry.name.to_ascii_lowercase();
        if names.contains_key(&name) {
            return Err(Fault::of_entry(&name, "two entries have this name"));
        }
        names.insert(name, place);
    }
    Ok(names)
}

/// A message as the end of a sentence.
fn lowered(message: &str) -> String {
    let mut letters = message.chars();
    letters.next().map_or_else(String::new, |first| first.to_lowercase().chain(letters).collect())
}
