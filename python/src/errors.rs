//! What can go wrong, and the exception of Python that says it.

use std::fmt::Display;
use std::io;

use meshmend::formats::{Place, ReadErrorKind, WriteErrorKind};
use meshmend::passes::{PassError, PlanError, SayingError};
use meshmend::{Defect, LoopError, Loss, ReadError, UnfoldError, WriteError};
use pyo3::exceptions::{PyOSError, PyRuntimeError, PyTypeError, PyValueError};
use pyo3::prelude::*;

use crate::defects::DefectList;

/// What went wrong in work off the interpreter's lock.
pub(crate) enum Problem {
    Read(ReadError),
    Write(WriteError),
    /// The work on a file, or on arrays, gave no mesh.
    Pass {
        file: Option<String>,
        error: PassError,
    },
    /// A text or words that are no plan.
    Plan(PlanError),
    /// What a file can't carry, where that is not to be written.
    Losses {
        file: String,
        losses: Vec<Loss>,
    },
    /// An argument can't be that.
    Value(String),
    /// The mesh can't be worked on as asked.
    Refused(String),
}

pub(crate) type Done<T> = Result<T, Problem>;

impl From<ReadError> for Problem {
    fn from(error: ReadError) -> Self {
        Problem::Read(error)
    }
}

impl From<WriteError> for Problem {
    fn from(error: WriteError) -> Self {
        Problem::Write(error)
    }
}

impl From<PassError> for Problem {
    fn from(error: PassError) -> Self {
        Problem::Pass { file: None, error }
    }
}

impl From<SayingError> for Problem {
    fn from(error: SayingError) -> Self {
        match error {
            SayingError::Plan(error) => Problem::Plan(error),
            error => Problem::Value(error.to_string()),
        }
    }
}

impl From<LoopError> for Problem {
    fn from(error: LoopError) -> Self {
        match error {
            LoopError::Pass(error) => error.into(),
            error => Problem::Refused(error.to_string()),
        }
    }
}

impl From<UnfoldError> for Problem {
    fn from(error: UnfoldError) -> Self {
        match error {
            UnfoldError::Cut(error) => error.into(),
            error => Problem::Refused(error.to_string()),
        }
    }
}

/// What was done, or the exception.
pub(crate) fn raise<T>(py: Python<'_>, done: Done<T>) -> PyResult<T> {
    done.map_err(|problem| problem.exception(py))
}

impl Problem {
    fn exception(self, py: Python<'_>) -> PyErr {
        match self {
            Problem::Read(error) => of_reading(py, error),
            Problem::Write(error) => of_writing(py, error),
            Problem::Pass { file, error } => of_pass(py, file, error),
            Problem::Plan(error) => own(py, "PlanError", (error.to_string(),)),
            Problem::Losses { file, losses } => {
                let what: Vec<String> = losses.iter().map(ToString::to_string).collect();
                let message = format!("{file}: not written, as it can't carry all: {}", what.join("; "));
                match serde_json::to_string(&losses) {
                    Ok(losses) => own(py, "LossError", (message, file, losses)),
                    Err(error) => internal(py, &error.to_string(), None),
                }
            }
            Problem::Value(message) => PyValueError::new_err(message),
            Problem::Refused(message) => own(py, "RefusedError", (message,)),
        }
    }
}

/// An exception of the package.
fn own<'py>(py: Python<'py>, name: &str, arguments: impl pyo3::call::PyCallArgs<'py>) -> PyErr {
    let made = py.import("meshmend._errors").and_then(|module| module.getattr(name)?.call1(arguments));
    made.map_or_else(|error| error, PyErr::from_value)
}

/// A mistake of meshmend itself: a panic, or a promise that was broken.
pub(crate) fn internal(py: Python<'_>, message: &str, place: Option<&str>) -> PyErr {
    own(py, "InternalError", (message, place))
}

/// A document that was written as text: that it can't be is a mistake of meshmend itself.
pub(crate) fn written<T>(py: Python<'_>, written: Result<T, impl Display>) -> PyResult<T> {
    written.map_err(|error| internal(py, &error.to_string(), None))
}

/// The system gives no more of something.
pub(crate) fn system(message: &str) -> PyErr {
    PyRuntimeError::new_err(message.to_owned())
}

/// An argument of the package's own Python code is of another type: it says it before.
pub(crate) fn of_type(message: impl Into<String>) -> PyErr {
    PyTypeError::new_err(message.into())
}

fn of_reading(py: Python<'_>, error: ReadError) -> PyErr {
    let kind = match &error.kind {
        ReadErrorKind::Io(cause) => return of_system(py, cause, &error.file),
        ReadErrorKind::UnknownFormat { .. } => "unknown-format",
        ReadErrorKind::LimitExceeded { .. } => "limit",
        _ => "malformed",
    };
    let (line, byte) = match error.place {
        Place::Line(line) => (Some(line), None),
        Place::Byte(byte) => (None, Some(byte)),
        _ => (None, None),
    };
    own(py, "ReadError", (error.to_string(), error.file, line, byte, kind))
}

fn of_writing(py: Python<'_>, error: WriteError) -> PyErr {
    match &error.kind {
        WriteErrorKind::Io(cause) => of_system(py, cause, &error.file),
        _ => own(py, "WriteError", (error.to_string(), error.file)),
    }
}

/// What the system says, as the exception that Python has for it.
fn of_system(py: Python<'_>, cause: &io::Error, file: &str) -> PyErr {
    const IS_A_DIRECTORY: i32 = 21;
    let number = match (cause.raw_os_error(), cause.kind()) {
        (Some(number), _) => Some(number),
        (None, io::ErrorKind::IsADirectory) => Some(IS_A_DIRECTORY),
        (None, _) => None,
    };
    let Some(number) = number else { return PyOSError::new_err(format!("{file}: {cause}")) };
    let said = py.import("os").and_then(|os| os.getattr("strerror")?.call1((number,)));
    // With a number Python chooses the class: FileNotFoundError and others.
    match said {
        Ok(text) => PyOSError::new_err((number, text.unbind(), file.to_owned())),
        Err(error) => error,
    }
}

fn of_pass(py: Python<'_>, file: Option<String>, error: PassError) -> PyErr {
    let message = file.map_or(error.to_string(), |file| format!("{file}: {error}"));
    match error {
        PassError::Refused(refusal) => refused(py, message, refusal.defects, Some(refusal.kernel)),
        PassError::Policy { defects, .. } => refused(py, message, defects, None),
        PassError::Request { .. } => PyValueError::new_err(message),
        PassError::Emptied(_) | PassError::Table(_) => own(py, "RefusedError", (message,)),
        PassError::Cancelled(_)
        | PassError::Promise { .. }
        | PassError::Unnamed { .. }
        | PassError::Draft(_) => internal(py, &message, None),
    }
}

fn refused(py: Python<'_>, message: String, defects: Vec<Defect>, kernel: Option<&'static str>) -> PyErr {
    own(py, "RefusedError", (message, DefectList::by_kind(defects), kernel))
}
