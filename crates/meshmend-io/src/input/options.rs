//! How to read.

use meshmend_core::Watch;

use crate::{Format, Limits};

/// How to read.
#[derive(Clone, Debug, Default)]
#[non_exhaustive]
pub struct ReadOptions {
    /// The most that a file may hold.
    pub limits: Limits,
    /// The format, whatever name and content say; by default they decide.
    pub format: Option<Format>,
    /// Who watches the reading, and may stop it.
    pub watch: Watch,
}

impl ReadOptions {
    /// These options with a format, whatever name and content say. With `None` they decide.
    pub fn with_format(self, format: impl Into<Option<Format>>) -> Self {
        ReadOptions { format: format.into(), ..self }
    }

    /// These options with limits.
    pub fn with_limits(self, limits: Limits) -> Self {
        ReadOptions { limits, ..self }
    }

    /// These options for reading that is watched.
    pub fn with_watch(self, watch: &Watch) -> Self {
        ReadOptions { watch: watch.clone(), ..self }
    }
}
