//! A run of a kernel's laws: guarded in a child of this process, or in this process.

mod child;
mod event;
mod findings;
mod folder;
mod needs;
mod opposite;
mod parent;
mod tally;
mod visit;
mod watch;

pub(crate) use child::{Ask, asked_here, folder as folder_of_child, run as run_child};
pub(crate) use event::{Example, Finding, Job, Manner};
pub(crate) use folder::{file_name, output, shown};
pub(crate) use needs::claimed;
pub(crate) use parent::guarded;
pub(crate) use tally::Results;
pub(crate) use visit::Visit;

pub use opposite::{NotManifold, Opposite, OppositeOf};
