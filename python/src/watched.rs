//! Work off the interpreter's lock, that can be watched and stopped.
//!
//! The work runs in a pool, and looks at its watch. The thread that called waits, and takes the lock again at each step and at
//! least each 50 ms, to see whether there is a signal such as Ctrl-C, and to call the progress callback. What either raises
//! stops the work at its next look, and is raised then. A panic becomes an `InternalError`.

use std::any::Any;
use std::num::NonZeroUsize;
use std::ops::ControlFlow;
use std::panic::{self, AssertUnwindSafe};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use meshmend::mesh::{Progress, Watch};
use pyo3::prelude::*;

use crate::{errors, panics, pool};

/// How often signals are looked at, and how often the callback is told of the same step.
const PULSE: Duration = Duration::from_millis(50);

/// How a call works: on how many threads, and who is told of its steps.
pub(crate) struct Watched<'py> {
    py: Python<'py>,
    threads: Option<NonZeroUsize>,
    progress: Option<Bound<'py, PyAny>>,
}

enum Told {
    Step(Progress),
    Ended,
}

/// What the looks of the work share with the thread that called.
struct Looks {
    is_stopped: AtomicBool,
    /// Where steps are told, and which was told last and when; nowhere if nobody asks.
    told: Option<Mutex<Telling>>,
}

struct Telling {
    steps: Sender<Told>,
    last: Option<(&'static str, Instant)>,
}

impl Looks {
    /// How far the work is; whether it goes on.
    fn look(&self, at: Progress) -> ControlFlow<()> {
        if let Some(told) = &self.told {
            told.lock().unwrap_or_else(PoisonError::into_inner).tell(at);
        }
        match self.is_stopped.load(Ordering::Relaxed) {
            true => ControlFlow::Break(()),
            false => ControlFlow::Continue(()),
        }
    }
}

impl Telling {
    fn tell(&mut self, at: Progress) {
        let is_told = self.last.is_some_and(|(step, when)| step == at.step && when.elapsed() < PULSE);
        if !is_told {
            self.last = Some((at.step, Instant::now()));
            // Nobody listens any more once the work is given up.
            let _ = self.steps.send(Told::Step(at));
        }
    }
}

impl<'py> Watched<'py> {
    pub(crate) fn new(
        py: Python<'py>,
        threads: Option<NonZeroUsize>,
        progress: Option<Bound<'py, PyAny>>,
    ) -> Self {
        Watched { py, threads, progress }
    }

    /// Does some work off the lock.
    pub(crate) fn run<R: Send>(self, work: impl FnOnce(&Watch) -> R + Send) -> PyResult<R> {
        panics::keep();
        let leased = pool::lease(self.threads).map_err(|error| errors::system(&error.to_string()))?;
        let progress = self.progress.map(Bound::unbind);
        let (sender, told) = mpsc::channel();
        let telling = progress.as_ref().map(|_| Mutex::new(Telling { steps: sender.clone(), last: None }));
        let looks = Arc::new(Looks { is_stopped: AtomicBool::new(false), told: telling });
        let looked_at = Arc::clone(&looks);
        let watch = Watch::new(move |at| looked_at.look(at));
        let mut outcome: Option<Result<R, Box<dyn Any + Send>>> = None;
        let raised = self.py.detach(|| {
            // Whoever waits is the only one who is told.
            let told = told;
            leased.pool.in_place_scope(|scope| {
                let outcome = &mut outcome;
                scope.spawn(move |_| {
                    *outcome = Some(panic::catch_unwind(AssertUnwindSafe(|| work(&watch))));
                    let _ = sender.send(Told::Ended);
                });
                let raised = wait(&told, progress.as_ref());
                if raised.is_err() {
                    looks.is_stopped.store(true, Ordering::Relaxed);
                }
                raised
            })
        });
        let panicked = panics::take(&leased.name);
        pool::give_back(leased);
        raised?;
        match outcome {
            Some(Ok(result)) => Ok(result),
            Some(Err(payload)) => {
                Err(errors::internal(self.py, &panics::message(&*payload), panicked.as_deref()))
            }
            None => Err(errors::internal(self.py, "the work did not end", panicked.as_deref())),
        }
    }
}

/// Waits until the work has ended, or something is raised.
fn wait(told: &Receiver<Told>, progress: Option<&Py<PyAny>>) -> PyResult<()> {
    loop {
        match told.recv_timeout(PULSE) {
            Ok(Told::Ended) | Err(RecvTimeoutError::Disconnected) => return Ok(()),
            Err(RecvTimeoutError::Timeout) => Python::attach(|py| py.check_signals())?,
            Ok(Told::Step(Progress { step, done, total })) => Python::attach(|py| {
                py.check_signals()?;
                progress.map_or(Ok(()), |progress| progress.call1(py, (step, done, total)).map(drop))
            })?,
        }
    }
}
