//! Sizes in bytes, as the command line says them.

use bytesize::ByteSize;

/// Reads a size such as `4GiB`, `500MB` or `1000000`.
pub(crate) fn size(word: &str) -> Result<u64, String> {
    let size: Result<ByteSize, _> = word.parse();
    size.map(|size| size.as_u64()).map_err(|_| "expected a size such as 4GiB, 500MB or 1000000".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_have_units_of_a_thousand_and_of_1024() {
        assert_eq!((size("4GiB"), size("500MB"), size("7")), (Ok(4 << 30), Ok(500_000_000), Ok(7)));
        assert!(size("much").is_err() && size("-1").is_err());
    }
}
