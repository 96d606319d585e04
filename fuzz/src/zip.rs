//! The smallest archive: entries that are stored, so that what an engine changes is what a reader sees.

/// An archive of these entries.
pub(crate) fn stored_archive(entries: &[(&str, &[u8])]) -> Vec<u8> {
    let (mut archive, mut records) = (Vec::new(), Vec::new());
    for (name, content) in entries {
        let place = archive.len() as u32;
        let mut common = [20_u16, 0, 0, 0, 0x21].map(u16::to_le_bytes).concat();
        let length = content.len() as u32;
        common.extend([checksum(content), length, length].map(u32::to_le_bytes).concat());
        common.extend([name.len() as u16, 0].map(u16::to_le_bytes).concat());
        archive.extend_from_slice(b"PK\x03\x04");
        archive.extend_from_slice(&common);
        archive.extend_from_slice(name.as_bytes());
        archive.extend_from_slice(content);
        records.extend_from_slice(b"PK\x01\x02\x14\0");
        records.extend_from_slice(&common);
        records.extend_from_slice(&[0; 10]);
        records.extend_from_slice(&place.to_le_bytes());
        records.extend_from_slice(name.as_bytes());
    }
    let (start, count) = (archive.len() as u32, entries.len() as u16);
    archive.extend_from_slice(&records);
    archive.extend_from_slice(b"PK\x05\x06\0\0\0\0");
    archive.extend([count, count].map(u16::to_le_bytes).concat());
    archive.extend([records.len() as u32, start].map(u32::to_le_bytes).concat());
    archive.extend_from_slice(&[0; 2]);
    archive
}

/// The cyclic redundancy check of zip archives.
fn checksum(bytes: &[u8]) -> u32 {
    let step = |sum: u32, _| if sum & 1 == 1 { (sum >> 1) ^ 0xedb8_8320 } else { sum >> 1 };
    !bytes.iter().fold(!0, |sum, &byte| (0..8).fold(sum ^ u32::from(byte), step))
}
