//! Many files: which they are, where their results go, who mends them, and what became of each.
//!
//! Workers do the work, each in a process of its own; here is decided on time, memory and another try. `docs/batch.md` has the
//! rules, and the form of the ledger.

mod child;
mod ledger;
mod listing;
mod outputs;
mod queue;
mod stop;
mod supervisor;

pub(crate) use self::ledger::Ledger;
pub(crate) use self::listing::{Listed, listed, of_line};
pub(crate) use self::outputs::Tree;
pub(crate) use self::stop::Stop;
pub(crate) use self::supervisor::{Limits, Supervisor, Task};
