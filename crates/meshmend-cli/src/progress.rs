//! A bar on a terminal for work that takes more than a second.

use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::thread::{Builder, JoinHandle};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::render::printable;

const PATIENCE: Duration = Duration::from_secs(1);
const TICK: Duration = Duration::from_millis(100);

/// How far a command is. It is shown after the first second, if standard error is a terminal.
pub(crate) struct Progress {
    bar: ProgressBar,
    watch: Option<Watch>,
}

/// The thread that shows the bar when the time has come.
struct Watch {
    is_done: Sender<()>,
    thread: JoinHandle<()>,
}

impl Progress {
    /// The progress of work in so many steps, shown on standard error.
    pub(crate) fn shown(steps: usize) -> Self {
        let mut progress = Progress::hidden(steps);
        progress.watch = Watch::over(&progress.bar);
        progress
    }

    /// The progress that nobody watches.
    pub(crate) fn hidden(steps: usize) -> Self {
        let bar = ProgressBar::with_draw_target(Some(steps as u64), ProgressDrawTarget::hidden());
        if let Ok(style) = ProgressStyle::with_template("{spinner} {bar:24} {pos}/{len} {msg} {elapsed}") {
            bar.set_style(style);
        }
        Progress { bar, watch: None }
    }

    /// Begins the next step.
    pub(crate) fn step(&self, name: &str) {
        self.bar.set_message(printable(name));
        self.bar.inc(1);
    }

    /// Begins the step of this place among so many that are counted by themselves.
    pub(crate) fn step_of(&self, name: &str, place: usize, count: usize) {
        self.bar.set_length(count as u64);
        self.bar.set_position(place as u64);
        self.step(name);
    }
}

impl Watch {
    fn over(bar: &ProgressBar) -> Option<Self> {
        let (is_done, done) = channel();
        let bar = bar.clone();
        let show = move || {
            if done.recv_timeout(PATIENCE) == Err(RecvTimeoutError::Timeout) {
                bar.set_draw_target(ProgressDrawTarget::stderr());
                bar.enable_steady_tick(TICK);
            }
        };
        Some(Watch { is_done, thread: Builder::new().spawn(show).ok()? })
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some(Watch { is_done, thread }) = self.watch.take() {
            drop(is_done);
            thread.join().ok();
        }
        self.bar.finish_and_clear();
    }
}
