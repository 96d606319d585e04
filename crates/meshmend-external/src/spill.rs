//! Numbers on disk, in parts: one file without a name, which is gone when its process is, however that ends.
//!
//! Numbers are appended to any part in any order, gathered in a block a part, and read again part by part. Blocks of all
//! parts lie in the file in the order in which they became full.

use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::Path;

use crate::error::ExternalError;

/// How many bytes a block has at most, and at least.
const BLOCK: std::ops::RangeInclusive<usize> = 1 << 12..=1 << 18;

/// Numbers of 32 bits in parts.
#[derive(Debug)]
pub(crate) struct Spill {
    file: File,
    parts: Vec<Part>,
    block: usize,
    /// How many bytes the file has.
    length: u64,
    folder: String,
}

#[derive(Clone, Debug, Default)]
struct Part {
    /// What is not yet in the file.
    pending: Vec<u8>,
    /// Where its blocks are. All are full but the last one.
    blocks: Vec<u64>,
    /// How many bytes are in the blocks.
    spilled: u64,
}

impl Spill {
    /// So many empty parts, whose blocks together take about `memory` bytes.
    pub(crate) fn new(folder: &Path, parts: usize, memory: u64) -> Result<Self, ExternalError> {
        let name = folder.display().to_string();
        let file = tempfile::tempfile_in(folder).map_err(|error| ExternalError::spilling(&name, error))?;
        let block = (memory as usize / parts.max(1)).clamp(*BLOCK.start(), *BLOCK.end()) & !15;
        Ok(Spill { file, parts: vec![Part::default(); parts], block, length: 0, folder: name })
    }

    pub(crate) fn part_count(&self) -> usize {
        self.parts.len()
    }

    /// How many numbers a part has.
    pub(crate) fn len(&self, part: usize) -> usize {
        let Part { pending, spilled, .. } = &self.parts[part];
        (*spilled as usize + pending.len()) / 4
    }

    /// How many bytes were written to the file.
    pub(crate) fn written(&self) -> u64 {
        self.length
    }

    /// Appends numbers to a part.
    #[inline]
    pub(crate) fn push(&mut self, part: usize, numbers: &[u32]) -> Result<(), ExternalError> {
        for &number in numbers {
            let pending = &mut self.parts[part].pending;
            pending.extend_from_slice(&number.to_le_bytes());
            if pending.len() >= self.block {
                self.write(part)?;
            }
        }
        Ok(())
    }

    /// Writes the block of a part.
    #[cold]
    fn write(&mut self, part: usize) -> Result<(), ExternalError> {
        let Part { pending, blocks, spilled } = &mut self.parts[part];
        let written = self.file.seek(SeekFrom::Start(self.length)).and_then(|_| self.file.write_all(pending));
        written.map_err(|error| ExternalError::spilling(&self.folder, error))?;
        blocks.push(self.length);
        self.length += pending.len() as u64;
        *spilled += pending.len() as u64;
        pending.clear();
        Ok(())
    }

    /// Hands over the numbers of a part, in order and some at a time.
    pub(crate) fn read(
        &self,
        part: usize,
        mut take: impl FnMut(&[u32]) -> Result<(), ExternalError>,
    ) -> Result<(), ExternalError> {
        let Part { pending, blocks, .. } = &self.parts[part];
        let (mut bytes, mut numbers) = (vec![0; self.block], Vec::new());
        for &at in blocks {
            self.block_at(at, &mut bytes)?;
            in_numbers(&bytes, &mut numbers);
            take(&numbers)?;
        }
        in_numbers(pending, &mut numbers);
        if numbers.is_empty() { Ok(()) } else { take(&numbers) }
    }

    fn block_at(&self, at: u64, bytes: &mut [u8]) -> Result<(), ExternalError> {
        let mut file = &self.file;
        let read: io::Result<()> = file.seek(SeekFrom::Start(at)).and_then(|_| file.read_exact(bytes));
        read.map_err(|error| ExternalError::spilling(&self.folder, error))
    }

    /// All numbers of a part.
    pub(crate) fn load(&self, part: usize) -> Result<Vec<u32>, ExternalError> {
        let mut all = Vec::with_capacity(self.len(part));
        self.read(part, |numbers| {
            all.extend_from_slice(numbers);
            Ok(())
        })?;
        Ok(all)
    }
}

fn in_numbers(bytes: &[u8], numbers: &mut Vec<u32>) {
    numbers.clear();
    numbers.extend(bytes.chunks_exact(4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]])));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_part_has_its_numbers_in_order() {
        let mut spill = Spill::new(&std::env::temp_dir(), 3, 0).unwrap();
        let mut expected = vec![Vec::new(); 3];
        for n in 0..20_000u32 {
            let part = (n * n % 7 % 3) as usize;
            spill.push(part, &[n, !n]).unwrap();
            expected[part].extend([n, !n]);
        }
        assert!(spill.written() > 3 * 4096);
        for (part, expected) in expected.iter().enumerate() {
            assert_eq!((spill.len(part), &spill.load(part).unwrap()), (expected.len(), expected));
        }
    }

    #[test]
    fn a_part_without_numbers_and_one_with_few_take_no_room_on_disk() {
        let mut spill = Spill::new(&std::env::temp_dir(), 2, 1 << 20).unwrap();
        spill.push(1, &[7]).unwrap();
        assert_eq!((spill.load(0).unwrap(), spill.load(1).unwrap(), spill.written()), (vec![], vec![7], 0));
    }

    #[test]
    fn a_folder_that_is_not_there_is_named() {
        let error = Spill::new(Path::new("no/such/folder"), 1, 0).unwrap_err().to_string();
        assert!(error.starts_with("no/such/folder: "), "{error}");
    }
}
