//! An archive with other content in some of its entries, and a new one.
//!
//! What stays is copied as bytes: local header, packed content, what stands behind it, and its record in the directory
//! but for the place that it names. So names, dates, attributes, extra fields, comments and the order stay.

use std::io::{self, Write};
use std::ops::Range;

use super::directory::{Directory, Entry};
use super::zip::{
    Content, Label, Origin, Packed, Packer, push_end, push_entry, push_record, short, without_64,
};

/// A new archive with these names and contents.
pub(in crate::formats::threemf) fn archive_of(contents: &[(&str, Packed)]) -> Vec<u8> {
    let (mut out, mut records) = (Vec::new(), Vec::new());
    for (name, packed) in contents {
        let (label, at) = (Label::new(name), out.len() as u64);
        push_entry(&mut out, &label, packed);
        push_record(&mut records, &label, &Origin::NEW, &packed.content, at);
    }
    let directory = out.len() as u64;
    out.extend_from_slice(&records);
    push_end(&mut out, contents.len(), directory, &[]);
    out
}

/// An archive in which the entries at these places of its directory, ascending, have new contents.
///
/// *Cost*: linear in the archive and the new contents.
pub(in crate::formats::threemf) fn with_contents(
    archive: &[u8],
    directory: &Directory,
    contents: &[(usize, Vec<u8>)],
) -> io::Result<Vec<u8>> {
    let entries = &directory.entries;
    let mut order: Vec<usize> = (0..entries.len()).collect();
    order.sort_by_key(|&at| entries[at].whole.start);
    let first = order.first().map_or(0, |&at| entries[at].whole.start);
    let mut out = archive[..first].to_vec();
    let mut records: Vec<Vec<u8>> = vec![Vec::new(); entries.len()];
    for at in order {
        let (entry, place) = (&entries[at], out.len() as u64);
        let new = contents.binary_search_by_key(&at, |(entry, _)| *entry);
        if let Some((_, content)) = new.ok().and_then(|found| contents.get(found)) {
            records[at] = replace(&mut out, archive, entry, content)?;
        } else {
            out.extend_from_slice(&archive[entry.whole.clone()]);
            records[at] = moved(&archive[entry.record.clone()], entry, place);
        }
    }
    let start = out.len() as u64;
    records.iter().for_each(|record| out.extend_from_slice(record));
    push_end(&mut out, entries.len(), start, &directory.comment);
    Ok(out)
}

/// Appends an entry with new content, and returns its record.
fn replace(out: &mut Vec<u8>, archive: &[u8], entry: &Entry, content: &[u8]) -> io::Result<Vec<u8>> {
    let mut packer = if entry.is_deflated { Packer::deflating() } else { Packer::storing() };
    packer.write_all(content)?;
    let packed = packer.finish()?;
    let local = &archive[entry.whole.start..entry.data.start];
    let record = &archive[entry.record.clone()];
    let place = out.len() as u64;
    push_entry(out, &label_of(local, LOCAL_FIELDS), &packed);
    let mut written = Vec::new();
    push_record(&mut written, &label_of(record, RECORD_FIELDS), &origin_of(record), &packed.content, place);
    Ok(written)
}

/// Where a header has its fields: the first that it shares with the other kind, and its name.
struct Fields {
    shared: usize,
    name: usize,
}

const LOCAL_FIELDS: Fields = Fields { shared: 6, name: 30 };
const RECORD_FIELDS: Fields = Fields { shared: 8, name: 46 };
/// The bit that says that sizes stand behind the content.
const SIZES_BEHIND: u16 = 1 << 3;

fn label_of(header: &[u8], Fields { shared, name }: Fields) -> Label<'_> {
    let name_end = name + usize::from(number(header, shared + 20));
    let extra_end = name_end + usize::from(number(header, shared + 22));
    Label {
        name: &header[name..name_end],
        flags: number(header, shared) & !SIZES_BEHIND,
        date: std::array::from_fn(|i| header[shared + 4 + i]),
        extra: without_64(&header[name_end..extra_end]),
    }
}

/// A record for an entry that stands at another place now.
fn moved(record: &[u8], entry: &Entry, place: u64) -> Vec<u8> {
    const PLACE: Range<usize> = 42..46;
    let mut moved = record.to_vec();
    if short(place) != u32::MAX && record[PLACE] != [0xff; 4] {
        moved[PLACE].copy_from_slice(&short(place).to_le_bytes());
        return moved;
    }
    let label = Label { flags: number(record, RECORD_FIELDS.shared), ..label_of(record, RECORD_FIELDS) };
    let Entry { is_deflated, checksum, length, .. } = *entry;
    let content = Content { is_deflated, checksum, packed: entry.data.len() as u64, length };
    moved.clear();
    push_record(&mut moved, &label, &origin_of(record), &content, place);
    moved
}

fn origin_of(record: &[u8]) -> Origin<'_> {
    Origin {
        made_by: [record[4], record[5]],
        attributes: std::array::from_fn(|i| record[34 + i]),
        comment: &record[record.len() - usize::from(number(record, 32))..],
    }
}

fn number(bytes: &[u8], at: usize) -> u16 {
    u16::from_le_bytes([bytes[at], bytes[at + 1]])
}
