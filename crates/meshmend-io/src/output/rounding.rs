//! Rounding to single precision, and its losses.

use meshmend_geometry::rounding::{Rounding, in_single_precision};

use crate::{Loss, LossKind, Prepared};

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

impl Prepared {
    /// Rounds positions to single precision, and names the losses.
    ///
    /// *Cost*: linear where nothing moves; else n log n.
    pub(crate) fn round_positions(&mut self) {
        if let Some((mesh, rounding)) = in_single_precision(&self.mesh) {
            self.losses.extend(rounding_losses(rounding, mesh.counts().vertices));
            self.mesh = mesh;
        }
    }
}
