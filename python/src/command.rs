//! The command line, for a process that is it alone.

use std::ffi::OsString;

use meshmend_cli::{Console, end_cleanly};
use pyo3::prelude::*;

/// Does what a command line says on the streams of the process, and gives its status. Signals end the process from then on.
#[pyfunction]
pub(crate) fn command_line(py: Python<'_>, words: Vec<OsString>) -> u8 {
    py.detach(|| {
        end_cleanly();
        meshmend_cli::run(words, &mut Console::standard()) as u8
    })
}
