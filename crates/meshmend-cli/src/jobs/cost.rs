//! How much memory a file takes, as far as its size and format tell.

use meshmend::Format;

/// What any file takes.
const BASE: u64 = 64 << 20;

/// The memory to set aside for the repair of a file: an estimate from above for usual files. A file that needs more is
/// stopped by the limit of its worker, and is a row all the same.
pub(crate) fn cost(size: u64, format: Format) -> u64 {
    BASE.saturating_add(size.saturating_mul(times(format)))
}

/// How many times its own size a file takes. `bench/README.md` has what was measured.
fn times(format: Format) -> u64 {
    match format {
        // Three corners a facet, welded.
        Format::Stl => 6,
        // Compressed.
        Format::ThreeMf => 60,
        _ => 12,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_grows_with_the_size_and_never_wraps() {
        assert_eq!(cost(0, Format::Stl), 64 << 20);
        assert_eq!(cost(1 << 20, Format::Stl), 70 << 20);
        assert_eq!(cost(u64::MAX, Format::Obj), u64::MAX);
    }
}
