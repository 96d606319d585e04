//! A bar on a terminal for work that takes more than a second.

use std::ops::ControlFlow;
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::sync::{Mutex, PoisonError};
use std::thread::{Builder, JoinHandle};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use meshmend::files::PART;
use meshmend::mesh::Watch;

use crate::render::printable;

const PATIENCE: Duration = Duration::from_secs(1);
const TICK: Duration = Duration::from_millis(100);

/// How far a command is. It is shown after the first second, if standard error is a terminal.
pub(crate) struct Progress {
    bar: ProgressBar,
    shown: Option<Shown>,
}

/// The thread that shows the bar when the time has come.
struct Shown {
    is_done: Sender<()>,
    thread: JoinHandle<()>,
}

impl Progress {
    /// The progress of work in so many steps, shown on standard error.
    pub(crate) fn shown(steps: usize) -> Self {
        let mut progress = Progress::hidden(steps);
        progress.shown = Shown::over(&progress.bar);
        progress
    }

    /// The progress that nobody watches.
    pub(crate) fn hidden(steps: usize) -> Self {
        let bar = ProgressBar::with_draw_target(Some(steps as u64), ProgressDrawTarget::hidden());
        if let Ok(style) = ProgressStyle::with_template("{spinner} {bar:24} {pos}/{len} {msg} {elapsed}") {
            bar.set_style(style);
        }
        Progress { bar, shown: None }
    }

    /// The same where each step is a file: how many are done in a second, and how long it will take, are shown too.
    pub(crate) fn of_files(self) -> Self {
        let template = "{spinner} {bar:24} {pos}/{len} files, {per_sec}, {eta} left {wide_msg}";
        if let Ok(style) = ProgressStyle::with_template(template) {
            self.bar.set_style(style);
        }
        self
    }

    /// Begins the next step.
    pub(crate) fn step(&self, name: &str) {
        self.bar.set_message(printable(name));
        self.bar.inc(1);
    }

    /// What begins the next step whenever watched work does. In a file of parts these are the steps.
    pub(crate) fn watch(&self) -> Watch {
        let (bar, last) = (self.bar.clone(), Mutex::new(Last { step: "", of_parts: false }));
        Watch::new(move |at| {
            let mut last = last.lock().unwrap_or_else(PoisonError::into_inner);
            if at.step == PART {
                last.of_parts = true;
                bar.set_length(at.total);
                bar.set_position(at.done + 1);
            } else if last.step != at.step {
                bar.set_message(at.step);
                bar.inc(u64::from(!last.of_parts));
            }
            last.step = at.step;
            ControlFlow::Continue(())
        })
    }
}

/// What was told last.
struct Last {
    step: &'static str,
    of_parts: bool,
}

impl Shown {
    fn over(bar: &ProgressBar) -> Option<Self> {
        let (is_done, done) = channel();
        let bar = bar.clone();
        let show = move || {
            if done.recv_timeout(PATIENCE) == Err(RecvTimeoutError::Timeout) {
                bar.set_draw_target(ProgressDrawTarget::stderr());
                bar.enable_steady_tick(TICK);
            }
        };
        Some(Shown { is_done, thread: Builder::new().spawn(show).ok()? })
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some(Shown { is_done, thread }) = self.shown.take() {
            drop(is_done);
            thread.join().ok();
        }
        self.bar.finish_and_clear();
    }
}
