//! How a call works: on how many threads, and who is told of its steps.

use std::num::NonZeroUsize;

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::watched::Watched;

/// How a call works.
#[derive(FromPyObject)]
pub(crate) struct How<'py>(Option<i64>, Option<Bound<'py, PyAny>>);

/// Nobody has more threads.
const MOST_THREADS: i64 = 1024;

impl<'py> How<'py> {
    /// The work of the call.
    pub(crate) fn watched(self, py: Python<'py>) -> PyResult<Watched<'py>> {
        Ok(Watched::new(py, self.0.map(threads).transpose()?, self.1))
    }
}

/// A number of threads.
pub(crate) fn threads(count: i64) -> PyResult<NonZeroUsize> {
    let fits = (1..=MOST_THREADS).contains(&count).then(|| usize::try_from(count).ok()).flatten();
    let wrong = || PyValueError::new_err(format!("threads = {count}: it is between 1 and {MOST_THREADS}"));
    fits.and_then(NonZeroUsize::new).ok_or_else(wrong)
}
