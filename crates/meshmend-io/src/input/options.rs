//! How to read.

use crate::{Format, Limits};

/// How to read.
#[derive(Clone, Copy, Debug, Default)]
#[non_exhaustive]
pub struct ReadOptions {
    /// What a file may hold at most.
    pub limits: Limits,
    /// The format, whatever name and content say.
    pub format: Option<Format>,
}

impl ReadOptions {
    /// These options with a format, whatever name and content say; with `None` they say again.
    pub fn with_format(self, format: impl Into<Option<Format>>) -> Self {
        ReadOptions { format: format.into(), ..self }
    }

    /// These options with limits.
    pub fn with_limits(self, limits: Limits) -> Self {
        ReadOptions { limits, ..self }
    }
}
