//! Archives at the limits of the format.

use std::io::Write;

use super::zip::{Content, Origin};
use super::zip::{Label, Packer, push_end, push_entry, push_record, without_64};
use super::{Budget, Directory, archive_of, with_contents};

fn packed(text: &[u8]) -> super::zip::Packed {
    let mut packer = Packer::deflating();
    packer.write_all(text).unwrap();
    packer.finish().unwrap()
}

#[test]
fn more_entries_than_two_bytes_count_are_written_and_read() {
    let names: Vec<String> = (0..70_000).map(|number| format!("{number}")).collect();
    let contents: Vec<(&str, _)> = names.iter().map(|name| (&name[..], packed(b"x"))).collect();
    let archive = archive_of(&contents);
    let directory = Directory::of(&archive).unwrap();
    assert_eq!(directory.entries.len(), 70_000);
    let changed = with_contents(&archive, &directory, &[(69_999, b"changed".to_vec())]).unwrap();
    let directory = Directory::of(&changed).unwrap();
    let (_, entry) = directory.entry("69999").unwrap();
    assert_eq!(Budget::of(100).content(&changed, entry).unwrap(), b"changed");
    let (_, entry) = directory.entry("41").unwrap();
    assert_eq!(Budget::of(100).content(&changed, entry).unwrap(), b"x");
}

#[test]
fn numbers_beyond_four_bytes_stand_in_an_extra_field() {
    let content = Content { is_deflated: true, checksum: 1, packed: 5, length: 1 << 40 };
    let label = Label { extra: vec![9, 0, 1, 0, 7], ..Label::new("a") };
    let mut record = Vec::new();
    push_record(&mut record, &label, &Origin::NEW, &content, 1 << 33);
    // The packed size fits, the other two do not.
    assert_eq!(record[20..28], [5, 0, 0, 0, 0xff, 0xff, 0xff, 0xff]);
    assert_eq!(record[42..46], [0xff; 4]);
    let extra = &record[47..];
    assert_eq!(extra[..4], [1, 0, 16, 0]);
    assert_eq!(extra[4..12], (1_u64 << 40).to_le_bytes());
    assert_eq!(extra[12..20], (1_u64 << 33).to_le_bytes());
    assert_eq!(without_64(extra), [9, 0, 1, 0, 7]);
    // A local header has both sizes there or none.
    let mut local = Vec::new();
    push_entry(&mut local, &label, &super::zip::Packed { content, bytes: b"12345".to_vec() });
    assert_eq!(local[18..26], [0xff; 8]);
    assert_eq!(local[31..35], [1, 0, 16, 0]);
    assert!(local.ends_with(b"12345"));
}

#[test]
fn extra_fields_that_are_cut_off_stay_as_they_are() {
    for extra in [&[1_u8, 0, 9, 0, 1][..], &[1], &[]] {
        assert_eq!(without_64(extra), extra);
    }
    assert_eq!(without_64(&[1, 0, 0, 0, 5, 5]), [5, 5]);
}

#[test]
fn a_directory_far_back_is_named_in_eight_bytes() {
    // Where the directory lies is all that the end says of what is before it.
    let mut end = Vec::new();
    push_end(&mut end, 65_535, 0, b"note");
    assert!(end.starts_with(b"PK\x06\x06"));
    assert!(end.ends_with(b"\x04\0note"));
    let mut end = Vec::new();
    push_end(&mut end, 65_534, 0, b"");
    assert_eq!(end.len(), 22);
}
