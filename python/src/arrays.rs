//! Ids as numbers of 32 bits with a sign: fewer than 2³¹ elements of each kind are in a mesh, and −1 stands for none.

use meshmend::mesh::Id;

/// The number of an element.
pub(crate) fn id(index: usize) -> i32 {
    i32::try_from(index).unwrap_or(NONE)
}

/// Stands for no element.
pub(crate) const NONE: i32 = -1;

/// The numbers of some elements.
pub(crate) fn ids<I: Id>(elements: &[I]) -> Vec<i32> {
    elements.iter().map(|element| id(element.index())).collect()
}
