//! What must be true of any kernel and of any change to a mesh, whatever made it.
//!
//! Each law is written once, here, in the words of the core alone; the crates that register kernels and passes hold
//! every one of them against it.
//!
//! * [`kernel_laws`], [`refusal_law`], [`heap_law`]: a kernel.
//! * [`Change`]: what a repair made of a mesh, with the laws of its record.
//! * [`Promise`]: what must be gone afterwards, and what may be new.

mod change;
mod promise;
mod values;

use std::fmt::Debug;

pub use change::Change;
pub use meshmend_conformance::{heap_law, kernel_laws, refusal_law};
pub use promise::{DefectCounts, Promise};
pub use values::{Entry, layer_entries, number_key};

fn same<T: PartialEq + Debug>(what: &str, place: impl Debug, found: T, expected: T) -> Result<(), String> {
    if found == expected {
        Ok(())
    } else {
        Err(format!("{what} of {place:?} is {found:?} and should be {expected:?}"))
    }
}
