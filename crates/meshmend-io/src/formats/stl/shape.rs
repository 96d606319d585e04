//! What an STL file's writer chose.

use crate::Loss;
use crate::shell::{Output, Shape};

/// What an STL file's writer chose: nothing beside the encoding.
#[derive(Debug, PartialEq)]
pub(super) struct StlShape;

impl Shape for StlShape {
    fn is_same(&self, other: &dyn Shape) -> bool {
        other.downcast() == Some(self)
    }

    fn losses_in(&self, _: Output<'_>) -> Vec<Loss> {
        Vec::new()
    }
}
