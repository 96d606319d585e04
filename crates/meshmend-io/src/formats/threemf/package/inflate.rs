//! The content of an entry, within limits: a small archive can hold an endless text.

use std::io::Read;

use flate2::Crc;
use flate2::read::DeflateDecoder;

use meshmend_core::Watch;

use super::directory::Entry;
use super::fault::Fault;
use crate::limits::INFLATED_BYTES;
use crate::watched::{WatchedRead, cancelled_by};

/// How many bytes may still come of the entries of a package.
pub(in crate::formats::threemf) struct Budget<'w> {
    watch: &'w Watch,
    limit: u64,
    spent: u64,
}

/// An entry up to this size may inflate to any multiple of what it takes in the archive.
const FREE: u64 = 64 << 20;
/// A larger one may inflate to this multiple.
const MOST_RATIO: u64 = 1000;

impl<'w> Budget<'w> {
    pub(in crate::formats::threemf) fn of(limit: u64) -> Budget<'static> {
        Budget { watch: &Watch::NOBODY, limit, spent: 0 }
    }

    /// The same, watched by somebody.
    pub(in crate::formats::threemf) fn watched(self, watch: &'w Watch) -> Self {
        Budget { watch, ..self }
    }

    /// The content of an entry of an archive.
    ///
    /// # Errors
    /// If it is damaged, or larger than the limits allow.
    ///
    /// *Cost*: linear in the content; memory grows with what is there, not with the size that is declared.
    pub(in crate::formats::threemf) fn content(
        &mut self,
        archive: &[u8],
        entry: &Entry,
    ) -> Result<Vec<u8>, Fault> {
        let stored = &archive[entry.data.clone()];
        self.spend(stored.len() as u64, entry)?;
        let content = if entry.is_deflated { inflated(stored, entry, self.watch)? } else { stored.to_vec() };
        let mut checksum = Crc::new();
        checksum.update(&content);
        if content.len() as u64 != entry.length || checksum.sum() != entry.checksum {
            return Err(Fault::of_entry(&entry.name, "the entry is damaged: its checksum is another one"));
        }
        Ok(content)
    }

    /// Takes what an entry says that it has. It is checked before it is inflated, and may not be more then.
    fn spend(&mut self, packed: u64, entry: &Entry) -> Result<(), Fault> {
        let length = entry.length;
        self.spent = self.spent.saturating_add(length);
        if self.spent > self.limit {
            return Err(Fault::limit(&entry.name, INFLATED_BYTES, self.spent, self.limit));
        }
        if length > FREE && length > packed.saturating_mul(MOST_RATIO) {
            return Err(Fault::of_entry(
                &entry.name,
                format!("inflates to more than {MOST_RATIO} times its size"),
            ));
        }
        Ok(())
    }
}

/// The content of a deflated entry: at most one byte more than it says that it has.
fn inflated(stored: &[u8], entry: &Entry, watch: &Watch) -> Result<Vec<u8>, Fault> {
    let packed = stored.len() as u64;
    let mut content = Vec::with_capacity(entry.length.min(packed.saturating_mul(8)) as usize);
    let inflating = DeflateDecoder::new(stored).take(entry.length.saturating_add(1));
    let read = WatchedRead::new(inflating, watch, entry.length as usize).read_to_end(&mut content);
    read.map_err(|error| match cancelled_by(&error) {
        Some(stopped) => Fault::stopped(stopped),
        None => Fault::of_entry(&entry.name, "the entry is damaged: it can't be inflated"),
    })?;
    Ok(content)
}
