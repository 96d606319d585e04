//! What an OFF file's writer chose.

use crate::Loss;
use crate::shell::{Output, Shape};

/// What an OFF file's writer chose.
#[derive(Debug, Default, PartialEq)]
pub(super) struct OffShape {
    /// The letters before the word `OFF`.
    pub(super) letters: Vec<u8>,
}

impl Shape for OffShape {
    fn is_same(&self, other: &dyn Shape) -> bool {
        other.downcast() == Some(self)
    }

    fn losses_in(&self, _: Output) -> Vec<Loss> {
        Vec::new()
    }
}
