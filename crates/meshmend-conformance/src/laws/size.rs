//! `size`: what a kernel says it keeps on the heap is what the allocator gave it.

use meshmend_core::{Complex, Connectivity};

use super::law::{Breach, Law};

pub(super) const SIZE: Law = Law {
    id: "size",
    sentence: "heap_bytes is within 5 % of what the allocator gave, beside the face table itself",
    why: "structures are compared by their bytes",
    often: Some("a forgotten array, or the length where the capacity counts"),
};

/// Whether what a kernel says of its `heap_bytes` is within a twentieth of what an allocator counted for it.
///
/// # Errors
/// Both figures, when they differ by more.
pub fn heap_law<K: Connectivity>(said: usize, measured: usize) -> Result<(), String> {
    breach(said, measured).map_err(|breach| format!("{}: {breach}", K::NAME))
}

/// As [`heap_law`], measured by what is free again when a kernel goes: nothing else holds what it shares with the complex
/// but the face table.
pub(crate) fn size<K: Connectivity>(complex: Complex, allocated: fn() -> usize) -> Result<(), Breach> {
    let _faces = complex.shared_faces();
    let kernel = K::assemble(&complex);
    drop(complex);
    let with = allocated();
    let said = kernel.heap_bytes();
    drop(kernel);
    breach(said, with.saturating_sub(allocated()))
}

fn breach(said: usize, measured: usize) -> Result<(), Breach> {
    if said.abs_diff(measured).saturating_mul(20) <= measured {
        return Ok(());
    }
    let expected = format!("{measured}, which is what the allocator gave, within 5 %");
    Err(Breach { question: "heap_bytes()".to_owned(), found: said.to_string(), expected })
}
