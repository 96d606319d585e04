//! Betti numbers: of the whole complex by elimination, and cell by cell as a file lists them.

mod betti;
mod elimination;
mod incremental;

pub(crate) use elimination::{PrimeField, SparseRows};

pub use betti::{
    Betti, ELIMINATION_BUDGET, Instigators, PatchEnds, PatchUse, TwoCycles, betti, betti_of, betti_within,
    instigators,
};
pub use incremental::{Effect, Incremental, REDUCTION_BUDGET, Step, incremental, incremental_within};
