//! Who hands files to workers, and judges workers that die, hang or grow.

use std::ffi::OsString;
use std::path::PathBuf;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use meshmend::report::{Row, RowStatus};

use super::child::{Child, Ended};
use super::queue::Queue;
use super::stop::Stop;
use crate::failure::Failure;
use crate::jobs::{Job, host};

/// After so many files a worker is started anew.
const MOST_FILES: u32 = 10_000;
/// After so many files its memory has come to its first plateau.
const SETTLED: u32 = 100;

/// A file that is to be done.
pub(crate) struct Task {
    /// What the worker is asked.
    pub(crate) job: Job,
    /// What the row has of the listing, with the digest that it must have.
    pub(crate) row: Row,
    /// The memory to set aside.
    pub(crate) cost: u64,
}

/// What the files may take.
pub(crate) struct Limits {
    /// How many are worked on at a time.
    pub(crate) jobs: usize,
    /// What all workers together may have.
    pub(crate) memory: u64,
    /// How long one file may take.
    pub(crate) patience: Duration,
}

/// Who starts workers.
pub(crate) struct Supervisor {
    pub(crate) program: PathBuf,
    pub(crate) arguments: Vec<OsString>,
    pub(crate) limits: Limits,
    pub(crate) stop: Arc<Stop>,
}

/// What the threads share.
struct Shared<'a> {
    queue: Queue<Task>,
    /// What is tried once more.
    again: Vec<Task>,
    told: &'a mut (dyn FnMut(&Row) -> Result<(), Failure> + Send),
    failure: Option<Failure>,
}

impl Supervisor {
    /// Does all that is to be done; each row is told as soon as its output exists. What ended without an answer is tried once more
    /// in a fresh worker, alone.
    pub(crate) fn run(
        &self,
        tasks: Vec<Task>,
        told: &mut (dyn FnMut(&Row) -> Result<(), Failure> + Send),
    ) -> Result<(), Failure> {
        let queue = Queue::new(tasks.into_iter().map(|task| (task.cost, task)).collect(), self.limits.memory);
        let shared = Mutex::new(Shared { queue, again: Vec::new(), told, failure: None });
        let changed = Condvar::new();
        thread::scope(|scope| {
            for _ in 0..self.limits.jobs {
                scope.spawn(|| self.work(&shared, &changed));
            }
        });
        let Shared { again, told, failure, .. } = shared.into_inner().unwrap_or_else(PoisonError::into_inner);
        failure.map_or(Ok(()), Err)?;
        for task in again {
            if self.stop.signal().is_some() {
                break;
            }
            let row = self.tried(&task, &mut None)?;
            if !self.is_cut_off(&row) {
                told(&Row { attempts: 2, ..row })?;
            }
        }
        Ok(())
    }

    fn work(&self, shared: &Mutex<Shared<'_>>, changed: &Condvar) {
        let mut slot = None;
        while let Some((cost, task)) = self.next(shared, changed) {
            let row = self.tried(&task, &mut slot);
            let mut shared = locked(shared);
            shared.queue.done(cost);
            let outcome = match row {
                Ok(row) if row.status.is_settled() => (shared.told)(&row),
                Ok(row) if self.is_cut_off(&row) => Ok(()),
                Ok(_) => {
                    shared.again.push(task);
                    Ok(())
                }
                Err(failure) => Err(failure),
            };
            if let Err(failure) = outcome {
                shared.failure.get_or_insert(failure);
                shared.queue.clear();
            }
            drop(shared);
            changed.notify_all();
        }
    }

    /// The next piece of work, as soon as there is room for it; `None` when there is none, or nothing new is to begin.
    fn next(&self, shared: &Mutex<Shared<'_>>, changed: &Condvar) -> Option<(u64, Task)> {
        let mut shared = locked(shared);
        while self.stop.signal().is_none() {
            if let Some(next) = shared.queue.take() {
                return Some(next);
            }
            if shared.queue.is_empty() {
                return None;
            }
            shared = changed.wait(shared).unwrap_or_else(PoisonError::into_inner);
        }
        None
    }

    /// Whether a row tells of nothing but that its worker was killed as the batch was to end: the file is left for another run.
    fn is_cut_off(&self, row: &Row) -> bool {
        self.stop.has_killed() && row.status == RowStatus::Crashed
    }

    /// Tries a file once.
    fn tried(&self, task: &Task, slot: &mut Option<Slot>) -> Result<Row, Failure> {
        let begin = Instant::now();
        let mut worker = match slot.take() {
            Some(worker) => worker,
            None => Slot::new(
                Child::start(&self.program, &self.arguments).map_err(cannot_start)?,
                Arc::clone(&self.stop),
            ),
        };
        let failed = |status, reason: &str| {
            let row = Row { seconds: begin.elapsed().as_secs_f64(), host: host(), ..task.row.clone() };
            row.failed(status, reason)
        };
        match worker.child.ask(&task.job, self.limits.patience) {
            Ended::Row(row) => {
                if row.plan_digest != task.row.plan_digest {
                    return Err(Failure::usage("the plan was changed while the batch ran"));
                }
                let Row { size, mtime, .. } = task.row.clone();
                *slot = worker.after_a_file();
                Ok(Row { size, mtime, ..*row })
            }
            Ended::TooLate => {
                let reason =
                    format!("it took longer than {}", humantime::format_duration(self.limits.patience));
                Ok(failed(RowStatus::Timeout, &reason))
            }
            Ended::Died(status, said) => {
                let signal = status.and_then(signal_of);
                match (signal, status.and_then(|status| status.code())) {
                    (None, Some(0 | 2)) => Err(cannot_start(format!("it ended with {said}"))),
                    (Some(SIGABRT), _) if said.contains("memory allocation of") => {
                        Ok(Row { signal, ..failed(RowStatus::Memory, &said) })
                    }
                    _ => Ok(Row { signal, ..failed(RowStatus::Crashed, &said) }),
                }
            }
        }
    }
}

/// The signal by which memory that is refused ends a process.
const SIGABRT: i32 = 6;

/// A worker, with what it has done.
struct Slot {
    child: Child,
    files: u32,
    plateau: u64,
    stop: Arc<Stop>,
}

impl Drop for Slot {
    fn drop(&mut self) {
        self.stop.remove(self.child.id());
    }
}

impl Slot {
    fn new(child: Child, stop: Arc<Stop>) -> Self {
        stop.add(child.id());
        Slot { child, files: 0, plateau: 0, stop }
    }

    /// The worker after one more file; `None` if it has done enough, or has grown past twice its first plateau.
    fn after_a_file(mut self) -> Option<Self> {
        self.files += 1;
        let resident = self.child.resident().unwrap_or(0);
        if self.files <= SETTLED {
            self.plateau = self.plateau.max(resident);
        }
        let is_fit = self.files < MOST_FILES && resident / 2 <= self.plateau;
        is_fit.then_some(self)
    }
}

fn locked<'a, 'b>(shared: &'a Mutex<Shared<'b>>) -> MutexGuard<'a, Shared<'b>> {
    shared.lock().unwrap_or_else(PoisonError::into_inner)
}

fn cannot_start(reason: impl std::fmt::Display) -> Failure {
    Failure::usage(format!("the worker can't work: {reason}"))
}

#[cfg(unix)]
fn signal_of(status: std::process::ExitStatus) -> Option<i32> {
    std::os::unix::process::ExitStatusExt::signal(&status)
}

#[cfg(not(unix))]
fn signal_of(_: std::process::ExitStatus) -> Option<i32> {
    None
}
