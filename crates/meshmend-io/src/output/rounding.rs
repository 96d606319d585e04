//! The losses of rounding to single precision.

use meshmend_geometry::rounding::Rounding;

use crate::{Loss, LossKind};

/// The losses when a mesh of so many vertices is rounded to single precision.
pub fn rounding_losses(rounding: Rounding, vertices: usize) -> Vec<Loss> {
    let Rounding { moved, joined, emptied } = rounding;
    let losses = [
        Loss::if_any(LossKind::Precision, moved, |n| {
            format!("positions rounded to single precision: {n} of {vertices}")
        }),
        Loss::if_any(LossKind::EmptiedFaces, emptied, |n| match n {
            1 => "1 face loses its area by that rounding".to_owned(),
            n => format!("{n} faces lose their area by that rounding"),
        }),
        Loss::if_any(LossKind::JoinedVertices, joined, |n| match n {
            1 => "1 vertex becomes one with another by that rounding".to_owned(),
            n => format!("{n} vertices become one with others by that rounding"),
        }),
    ];
    losses.into_iter().flatten().collect()
}
