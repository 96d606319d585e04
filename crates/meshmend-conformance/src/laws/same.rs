//! An answer beside the right one.

use std::fmt::Debug;

/// Whether what was found is what should be.
///
/// # Errors
/// A sentence with both.
pub(crate) fn same<T: PartialEq + Debug>(
    what: &str,
    place: impl Debug,
    found: T,
    expected: T,
) -> Result<(), String> {
    if found == expected {
        Ok(())
    } else {
        Err(format!("{what} of {place:?} is {found:?} and should be {expected:?}"))
    }
}
