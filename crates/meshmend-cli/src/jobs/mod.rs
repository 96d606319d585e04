//! One file after another in one process: what a worker is asked, what it does, and what it answers.
//!
//! `docs/batch.md` has the protocol. A worker has one policy, and never decides on time, memory or another try: that is for
//! whoever started it.

mod cost;
mod job;
mod limit;
mod meter;
mod sizes;
mod work;

pub(crate) use self::cost::cost;
pub(crate) use self::job::{Answer, Job, JobInput, JobOutput};
pub(crate) use self::limit::{bind_to, limit_address_space};
pub(crate) use self::meter::host;
pub(crate) use self::sizes::size;
pub(crate) use self::work::{Reports, Work};
