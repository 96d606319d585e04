//! The laws of an editor: a mesh that operators change.
//!
//! An editor is asked by vertex numbers alone, through [`Editing`], so that it may store what it likes. Beside it stand the
//! faces as plain lists, on which each operator is done without a question (`surface`, `model`).

mod drawn;
mod inverse;
mod laws;
mod model;
mod operator;
mod surface;
#[cfg(test)]
mod tests;

pub use drawn::Draw;
pub use laws::{EditLaw, edit_law, edit_laws};
pub use operator::{Kind, Opening, Operator, Side};

/// What an operator did, by vertex numbers.
#[derive(Clone, Debug)]
pub struct Edited {
    /// The vertices that it made; of a loop in the order of the walk.
    pub vertices: Vec<u32>,
    /// The call that undoes it.
    pub undo: Operator,
}

/// An editor, as the laws see it.
pub trait Editing: Sized {
    /// What it is called in verdicts.
    const NAME: &'static str;

    /// Begins with faces that a half-edge structure holds, over so many vertices.
    fn begin(vertices: usize, faces: &[Vec<u32>]) -> Self;

    /// Applies an operator. Vertices that it makes get numbers that were never used before.
    ///
    /// # Errors
    /// The reasons why it is refused; then nothing has changed.
    fn apply(&mut self, operator: &Operator) -> Result<Edited, Vec<String>>;

    /// The faces as they are now, each from any corner on, in any order.
    fn faces(&self) -> Vec<Vec<u32>>;

    /// Whether it has an operator.
    fn offers(_: Kind) -> bool {
        true
    }
}

/// A module with a test for each law of editors: `editor!(my_editor: MyEditor)`.
#[macro_export]
macro_rules! editor {
    ($module:ident: $editor:ty) => {
        mod $module {
            use super::*;

            $crate::editor!(@laws $editor, valid Valid, euler Euler, unchanged Unchanged, inverse Inverse, cause Cause,
                stale Stale);
        }
    };
    (@laws $editor:ty, $($name:ident $law:ident),*) => {
        $(#[test]
        fn $name() {
            if let Err(verdict) = $crate::editing::edit_law::<$editor>($crate::editing::EditLaw::$law) {
                ::std::panic!("{verdict}");
            }
        })*
    };
}
