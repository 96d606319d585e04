//! Arrays as numpy stores them: NPY 1.0, one after another in an uncompressed zip archive.

use std::io::{self, Write};

use rawzip::{CompressionMethod, ZipArchiveWriter};

use super::array::{Array, Values};

/// Headers end at a multiple of this.
const ALIGNMENT: usize = 64;

/// Writes arrays as an NPZ file.
pub(super) fn npz(arrays: &[Array], out: &mut dyn Write) -> io::Result<()> {
    let mut archive = ZipArchiveWriter::new(out);
    for array in arrays {
        let name = format!("{}.npy", array.name);
        let file = archive.new_file(name.as_str()).compression_method(CompressionMethod::STORE);
        let (mut entry, config) = file.start().map_err(failed)?;
        let mut writer = config.wrap(&mut entry);
        npy(array, &mut writer)?;
        let (_, descriptor) = writer.finish().map_err(failed)?;
        entry.finish(descriptor).map_err(failed)?;
    }
    archive.finish().map_err(failed)?;
    Ok(())
}

fn failed(error: rawzip::Error) -> io::Error {
    io::Error::other(error)
}

/// Writes one array.
fn npy(array: &Array, out: &mut dyn Write) -> io::Result<()> {
    let (kind, count) = match &array.values {
        Values::Integers(values) => ("<i8".to_owned(), values.len()),
        Values::Bytes(values) => ("|u1".to_owned(), values.len()),
        Values::Words(words) => (format!("<U{}", longest(words)), words.len()),
    };
    let shape = match array.width {
        1 => format!("({count},)"),
        width => format!("({}, {width})", count / width),
    };
    let described = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': {shape}, }}");
    let before = b"\x93NUMPY\x01\x00".len() + size_of::<u16>();
    let length = (before + described.len() + 1).next_multiple_of(ALIGNMENT) - before;
    let header = format!("{described:<width$}\n", width = length - 1);
    out.write_all(b"\x93NUMPY\x01\x00")?;
    out.write_all(&(length as u16).to_le_bytes())?;
    out.write_all(header.as_bytes())?;
    match &array.values {
        Values::Integers(values) => {
            let mut bytes = Vec::with_capacity(values.len() * size_of::<i64>());
            values.iter().for_each(|value| bytes.extend(value.to_le_bytes()));
            out.write_all(&bytes)
        }
        Values::Bytes(values) => out.write_all(values),
        Values::Words(words) => {
            let longest = longest(words);
            for word in *words {
                let letters = word.chars().chain(std::iter::repeat('\0')).take(longest);
                letters
                    .map(|letter| u32::from(letter).to_le_bytes())
                    .try_for_each(|code| out.write_all(&code))?;
            }
            Ok(())
        }
    }
}

fn longest(words: &[&str]) -> usize {
    words.iter().map(|word| word.chars().count()).max().unwrap_or(1)
}
