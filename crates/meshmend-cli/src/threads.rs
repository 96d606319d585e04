//! The threads of a command.

use std::fs;
use std::path::PathBuf;

use rayon::{ThreadPool, ThreadPoolBuildError, ThreadPoolBuilder};

use crate::failure::Failure;
use crate::streams::is_stream;

/// The work for smaller files is done before many threads have started.
const LARGE: u64 = 1 << 20;

/// The threads that work: a pool of its own, or those of the caller.
pub(crate) struct Pool(Option<ThreadPool>);

impl Pool {
    /// Starts so many threads; without a number, as many as the largest of the inputs is worth.
    ///
    /// For small inputs, and where none can be started, as in a full address space, the thread that calls does
    /// everything, unless a number was asked for.
    pub(crate) fn start(threads: Option<u16>, inputs: &[PathBuf]) -> Result<Self, Failure> {
        if let Some(threads) = threads {
            return match started(threads.into()) {
                Ok(pool) => Ok(Pool(Some(pool))),
                Err(error) => Err(Failure::usage(format!("--threads {threads}: {error}"))),
            };
        }
        const AS_MANY_AS_PROCESSORS: usize = 0;
        // How long a stream is can't be known.
        let is_large =
            |input: &PathBuf| is_stream(input) || fs::metadata(input).is_ok_and(|file| file.len() >= LARGE);
        let many = inputs.iter().any(is_large).then(|| started(AS_MANY_AS_PROCESSORS));
        Ok(Pool(many.and_then(Result::ok).or_else(alone)))
    }

    /// Does some work on these threads.
    pub(crate) fn install<R: Send>(&self, work: impl FnOnce() -> R + Send) -> R {
        match &self.0 {
            Some(pool) => pool.install(work),
            None => work(),
        }
    }
}

fn started(count: usize) -> Result<ThreadPool, ThreadPoolBuildError> {
    ThreadPoolBuilder::new().num_threads(count).build()
}

/// The calling thread as a pool. `None` if it belongs to another pool already: work then runs there.
fn alone() -> Option<ThreadPool> {
    ThreadPoolBuilder::new().num_threads(1).use_current_thread().build().ok()
}
