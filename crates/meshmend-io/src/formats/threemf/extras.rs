//! What only 3MF has, counted.

use meshmend_core::counted;

use crate::text::one_or_many;
use crate::{Loss, LossKind};

/// How many of what only 3MF has are in a package.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Extras {
    /// Statements about a model.
    pub(super) metadata: usize,
    /// Groups of colours, places in pictures and other properties, and what they need.
    pub(super) properties: usize,
    /// Objects with beams or balls.
    pub(super) lattices: usize,
    /// Objects with slices.
    pub(super) sliced: usize,
    /// Objects with sets of triangles.
    pub(super) sets: usize,
}

impl Extras {
    /// What another format does not carry.
    pub(super) fn losses(self) -> Vec<Loss> {
        let Extras { metadata, properties, lattices, sliced, sets } = self;
        let of = |count, one: &'static str, many: &'static str| {
            Loss::if_any(LossKind::ScenePart, count, |n| one_or_many(n, one, many))
        };
        let statements = Loss::if_any(LossKind::Metadata, metadata, |n| {
            format!("{} about the model", counted(n, "statement"))
        });
        let others = [
            of(properties, "resource with properties of surfaces", "resources with properties of surfaces"),
            of(lattices, "beam lattice", "beam lattices"),
            of(sliced, "stack of slices of an object", "stacks of slices of objects"),
            of(sets, "list of sets of triangles", "lists of sets of triangles"),
        ];
        statements.into_iter().chain(others.into_iter().flatten()).collect()
    }
}
