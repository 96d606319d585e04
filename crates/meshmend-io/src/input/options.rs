//! How to read.

use crate::{Format, Limits};

/// How to read.
#[derive(Clone, Copy, Debug, Default)]
pub struct ReadOptions {
    /// What a file may hold at most.
    pub limits: Limits,
    /// The format, whatever name and content say.
    pub format: Option<Format>,
}
