//! What keeps a kernel's mistakes from doing harm: endless stars are cut, panics are caught, and it is known at any moment
//! what the kernel is asked.

mod guarded;
mod limits;
mod panics;
mod place;
mod query;

pub(crate) use guarded::Guarded;
pub(crate) use limits::limit_memory;
pub(crate) use panics::{Stopped, caught};
pub(crate) use place::{At, Place};
pub(crate) use query::Query;
