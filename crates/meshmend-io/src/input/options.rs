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
    /// Whether the vertices of a soup that share a place are told as it is read, where that is cheap: binary STL. The mesh is the
    /// same, in half the memory until its [positions](meshmend_core::PolygonMesh::positions) are asked for, and is welded sooner.
    pub shared_places: bool,
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

    /// These options for a mesh that will be welded.
    pub fn with_shared_places(self) -> Self {
        ReadOptions { shared_places: true, ..self }
    }

    /// These options for reading that is watched.
    pub fn with_watch(self, watch: &Watch) -> Self {
        ReadOptions { watch: watch.clone(), ..self }
    }
}
