//! How the repair of a file is followed and stopped from outside.

use std::fmt;
use std::sync::atomic::AtomicBool;

use meshmend_repair::{PassKind, Session};

/// A step of the repair of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum FileStep<'a> {
    /// The mesh is judged as it is.
    Check,
    /// A pass begins.
    Pass(PassKind),
    /// The report is made.
    Report,
    /// The mesh is made ready to be written.
    Write,
    /// A part of a file is worked on. No other step is told of a file of parts.
    Part {
        /// What it is called.
        title: &'a str,
        /// Its place among those that are worked on, from 0.
        place: usize,
        /// How many are worked on.
        count: usize,
    },
}

impl FileStep<'_> {
    /// What it is called.
    pub fn name(&self) -> &str {
        match self {
            FileStep::Check => "check",
            FileStep::Pass(pass) => pass.name(),
            FileStep::Report => "report",
            FileStep::Write => "write",
            FileStep::Part { title, .. } => title,
        }
    }
}

/// Who follows the repair of a file, and can stop it.
#[derive(Clone, Copy, Default)]
#[non_exhaustive]
pub struct FileWatch<'a> {
    /// Is told each step as it begins.
    pub observe: Option<&'a dyn Fn(FileStep<'_>)>,
    /// Ends the repair with [`PassError::Cancelled`](crate::PassError::Cancelled) once another thread has set it.
    pub cancel: Option<&'a AtomicBool>,
}

impl<'a> FileWatch<'a> {
    /// Tells each step to a function.
    pub fn observed_by(observe: &'a dyn Fn(FileStep<'_>)) -> Self {
        FileWatch { observe: Some(observe), cancel: None }
    }

    /// This watch, which stops the repair once another thread has set the flag.
    #[must_use]
    pub fn with_cancel(self, cancel: &'a AtomicBool) -> Self {
        FileWatch { cancel: Some(cancel), ..self }
    }

    pub(super) fn tell(&self, step: FileStep<'_>) {
        if let Some(observe) = self.observe {
            observe(step);
        }
    }

    /// A session that can be stopped.
    pub(super) fn over<'s>(&self, session: Session<'s>) -> Session<'s>
    where
        'a: 's,
    {
        match self.cancel {
            Some(cancel) => session.with_cancel(cancel),
            None => session,
        }
    }
}

impl fmt::Debug for FileWatch<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("FileWatch").field("cancel", &self.cancel).finish_non_exhaustive()
    }
}
