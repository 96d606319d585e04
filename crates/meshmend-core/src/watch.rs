//! Long work that can be watched and stopped.
//!
//! Whoever starts long work hands it a [`Watch`]. The work looks at it between its steps, and within long steps at least every
//! [`ITEMS_BETWEEN_LOOKS`] items: a look says how far the work is, and its answer says whether to go on. Work that is stopped
//! returns [`Cancelled`] and has changed nothing.

use std::fmt;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use thiserror::Error;

/// After how many vertices, faces or corners at most a long step looks at its watch.
pub const ITEMS_BETWEEN_LOOKS: usize = 1 << 16;

/// How far work is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// What is being done, such as `read`, `topology` or the name of a pass.
    pub step: &'static str,
    /// How much of the step is done.
    pub done: u64,
    /// How much there is to do, in the same unit; 0 where that is not known.
    pub total: u64,
}

/// The work was stopped by whoever watches it. Nothing has been changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("cancelled")]
pub struct Cancelled;

/// Somebody who watches.
struct Watcher {
    look: Box<dyn Fn(Progress) -> ControlFlow<()> + Send + Sync>,
    has_stopped: AtomicBool,
}

/// Who watches work, and may stop it. The default is nobody. A clone is the same watch; one that has stopped work once stops all work
/// from then on.
///
/// ```
/// use std::ops::ControlFlow;
/// use std::sync::Arc;
/// use std::sync::atomic::{AtomicBool, Ordering};
///
/// use meshmend_core::{Cancelled, Watch};
///
/// let stop = Arc::new(AtomicBool::new(false));
/// let seen = stop.clone();
/// let watch = Watch::new(move |_| match seen.load(Ordering::Relaxed) {
///     true => ControlFlow::Break(()),
///     false => ControlFlow::Continue(()),
/// });
/// assert_eq!(watch.look("weld", 0, 10), Ok(()));
/// stop.store(true, Ordering::Relaxed);
/// assert_eq!(watch.look("weld", 5, 10), Err(Cancelled));
/// ```
#[derive(Clone, Default)]
pub struct Watch(Option<Arc<Watcher>>);

impl Watch {
    /// Nobody watches.
    pub const NOBODY: Watch = Watch(None);

    /// A watch that is told at each look how far the work is, and answers whether it goes on. It may be asked on any thread, by
    /// several at a time, and some thousand times a second.
    pub fn new(look: impl Fn(Progress) -> ControlFlow<()> + Send + Sync + 'static) -> Self {
        Watch(Some(Arc::new(Watcher { look: Box::new(look), has_stopped: AtomicBool::new(false) })))
    }

    /// Says how far work is.
    ///
    /// # Errors
    /// [`Cancelled`] if it is not to go on.
    #[inline]
    pub fn look(&self, step: &'static str, done: usize, total: usize) -> Result<(), Cancelled> {
        let Some(watcher) = &self.0 else { return Ok(()) };
        watcher.look(Progress { step, done: done as u64, total: total as u64 })
    }

    /// Looks if a long step has come to an item at which it should: every [`ITEMS_BETWEEN_LOOKS`] ones.
    ///
    /// # Errors
    /// As [`look`](Self::look).
    #[inline]
    pub fn look_at_times(&self, step: &'static str, item: usize, total: usize) -> Result<(), Cancelled> {
        if item.is_multiple_of(ITEMS_BETWEEN_LOOKS) { self.look(step, item, total) } else { Ok(()) }
    }
}

impl Watcher {
    fn look(&self, at: Progress) -> Result<(), Cancelled> {
        if !self.has_stopped.load(Ordering::Relaxed) && (self.look)(at).is_continue() {
            return Ok(());
        }
        self.has_stopped.store(true, Ordering::Relaxed);
        Err(Cancelled)
    }
}

impl fmt::Debug for Watch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if self.0.is_some() { "Watch(somebody)" } else { "Watch(nobody)" })
    }
}

impl PartialEq for Watch {
    /// Whether both are the same watch.
    fn eq(&self, other: &Self) -> bool {
        match (&self.0, &other.0) {
            (None, None) => true,
            (Some(one), Some(other)) => Arc::ptr_eq(one, other),
            _ => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Mutex;

    use super::*;

    #[test]
    fn nobody_stops_nothing_and_is_equal_to_nobody() {
        assert_eq!(Watch::NOBODY.look("weld", 1, 2), Ok(()));
        assert_eq!(Watch::NOBODY, Watch::default());
        let some = Watch::new(|_| ControlFlow::Continue(()));
        assert_eq!(some, some.clone());
        assert_ne!(some, Watch::NOBODY);
        assert_ne!(some, Watch::new(|_| ControlFlow::Continue(())));
    }

    #[test]
    fn what_has_stopped_work_stops_all_work() {
        let watch =
            Watch::new(|at| if at.done == 1 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) });
        let looks = [0, 1, 2].map(|done| watch.clone().look("weld", done, 3));
        assert_eq!(looks, [Ok(()), Err(Cancelled), Err(Cancelled)]);
    }

    #[test]
    fn long_steps_look_at_times() {
        let seen = Arc::new(Mutex::new(Vec::new()));
        let told = seen.clone();
        let watch = Watch::new(move |progress| {
            told.lock().unwrap().push(progress.done);
            ControlFlow::Continue(())
        });
        let total = 2 * ITEMS_BETWEEN_LOOKS + 1;
        (0..total).try_for_each(|item| watch.look_at_times("weld", item, total)).unwrap();
        assert_eq!(*seen.lock().unwrap(), [0, ITEMS_BETWEEN_LOOKS as u64, 2 * ITEMS_BETWEEN_LOOKS as u64]);
    }
}
