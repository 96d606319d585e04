//! The threads that work: pools of meshmend's own, each leased by one call at a time.
//!
//! Rayon's global pool is never used. After `fork` its threads are not there in the child, and work given to it would wait for
//! ever. The pools here belong to the process that made them: in another process they are forgotten, not dropped, and new
//! ones are made. As a call has its pool for itself, two threads of Python never take each other's work.

use std::num::NonZeroUsize;
use std::process;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, TryLockError};
use std::thread;

use rayon::{ThreadPool, ThreadPoolBuildError, ThreadPoolBuilder};

/// The pools that no call has, and the process that made them.
struct Idle {
    process: u32,
    pools: Vec<Leased>,
}

/// A pool, with what tells its threads from those of others.
pub(crate) struct Leased {
    pub(crate) pool: ThreadPool,
    pub(crate) name: String,
    threads: usize,
}

static IDLE: Mutex<Idle> = Mutex::new(Idle { process: 0, pools: Vec::new() });
static MADE: AtomicUsize = AtomicUsize::new(0);
/// How many threads a call has that does not say it; 0 for as many as this process may use.
static DEFAULT: AtomicUsize = AtomicUsize::new(0);

/// How the names of the threads begin.
pub(crate) const PREFIX: &str = "meshmend ";
/// No more idle pools are kept than this.
const MOST_IDLE: usize = 16;

/// Sets how many threads calls have that do not say it.
pub(crate) fn set_default(threads: Option<NonZeroUsize>) {
    DEFAULT.store(threads.map_or(0, NonZeroUsize::get), Ordering::Relaxed);
}

/// A pool of so many threads that nobody else uses until it is given back.
pub(crate) fn lease(threads: Option<NonZeroUsize>) -> Result<Leased, ThreadPoolBuildError> {
    let threads = threads.map_or_else(usual, NonZeroUsize::get);
    let found = with_idle(|idle| {
        let at = idle.pools.iter().position(|leased| leased.threads == threads)?;
        Some(idle.pools.swap_remove(at))
    });
    found.flatten().map_or_else(|| made(threads), Ok)
}

/// Takes a pool back.
pub(crate) fn give_back(leased: Leased) {
    let mut leased = Some(leased);
    with_idle(|idle| {
        if idle.pools.len() < MOST_IDLE {
            idle.pools.extend(leased.take());
        }
    });
}

/// As many as were set, or as this process may use: what it may run on, and what its cgroup allows.
pub(crate) fn usual() -> usize {
    match DEFAULT.load(Ordering::Relaxed) {
        0 => thread::available_parallelism().map_or(1, NonZeroUsize::get),
        set => set,
    }
}

fn made(threads: usize) -> Result<Leased, ThreadPoolBuildError> {
    let name = format!("{PREFIX}{}", MADE.fetch_add(1, Ordering::Relaxed));
    let of_thread = name.clone();
    let pool =
        ThreadPoolBuilder::new().num_threads(threads).thread_name(move |_| of_thread.clone()).build()?;
    Ok(Leased { pool, name, threads })
}

/// Does something with the idle pools of this process. `None` if another thread has them at hand: in a child that was
/// forked at that moment, it would have them for ever.
fn with_idle<R>(work: impl FnOnce(&mut Idle) -> R) -> Option<R> {
    let mut idle = match IDLE.try_lock() {
        Ok(idle) => idle,
        Err(TryLockError::Poisoned(poisoned)) => poisoned.into_inner(),
        Err(TryLockError::WouldBlock) => return None,
    };
    let process = process::id();
    if idle.process != process {
        // Their threads are those of the parent: to wait for them would be to wait for ever.
        std::mem::forget(std::mem::take(&mut idle.pools));
        idle.process = process;
    }
    Some(work(&mut idle))
}
