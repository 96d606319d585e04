//! A batch that is asked to end: what runs may finish, and nothing new begins.

use std::collections::BTreeSet;
use std::sync::atomic::{AtomicBool, AtomicI32, Ordering};
use std::sync::{Mutex, PoisonError};

/// How long workers have for the files that they are at.
#[cfg(unix)]
const GRACE: std::time::Duration = std::time::Duration::from_secs(10);

/// Whether the batch was asked to end, and which workers there are.
#[derive(Debug, Default)]
pub(crate) struct Stop {
    /// The signal that asked for it; 0 if none did.
    signal: AtomicI32,
    /// Whether workers were killed for it.
    has_killed: AtomicBool,
    /// The groups of the processes of workers.
    groups: Mutex<BTreeSet<u32>>,
}

impl Stop {
    /// The signal that asked for the end, if one did.
    pub(crate) fn signal(&self) -> Option<i32> {
        Some(self.signal.load(Ordering::Relaxed)).filter(|&signal| signal != 0)
    }

    /// Whether workers were killed: what they were at is not done, and no row says so.
    pub(super) fn has_killed(&self) -> bool {
        self.has_killed.load(Ordering::Relaxed)
    }

    pub(super) fn add(&self, group: u32) {
        self.groups.lock().unwrap_or_else(PoisonError::into_inner).insert(group);
    }

    pub(super) fn remove(&self, group: u32) {
        self.groups.lock().unwrap_or_else(PoisonError::into_inner).remove(&group);
    }

    /// Kills all workers, and what they may have started.
    #[cfg(unix)]
    fn kill(&self) {
        self.has_killed.store(true, Ordering::Relaxed);
        let groups = self.groups.lock().unwrap_or_else(PoisonError::into_inner);
        groups.iter().for_each(|&group| super::child::kill_group(group));
    }

    /// From now on a signal that asks the program to end lets workers finish what they are at, for ten seconds; another one ends
    /// all at once.
    #[cfg(unix)]
    pub(crate) fn on_signals(self: &std::sync::Arc<Self>) {
        let stop = std::sync::Arc::clone(self);
        crate::signals::hear_first(move |signal| {
            if stop.signal.swap(signal, Ordering::Relaxed) != 0 {
                stop.kill();
                return false;
            }
            let late = std::sync::Arc::clone(&stop);
            std::thread::spawn(move || {
                std::thread::sleep(GRACE);
                late.kill();
            });
            true
        });
    }

    /// Signals end the program at once.
    #[cfg(not(unix))]
    pub(crate) fn on_signals(self: &std::sync::Arc<Self>) {}
}
