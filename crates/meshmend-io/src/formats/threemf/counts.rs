//! How much of everything was read of a package, against the limits.

use meshmend_core::{ITEMS_BETWEEN_LOOKS, Watch};

use crate::Limits;
use crate::formats::threemf::package::Fault;
use crate::limits::PARTS;
use crate::watched::READ;

/// Text takes longer than numbers do.
const BETWEEN_LOOKS: u64 = ITEMS_BETWEEN_LOOKS as u64 / 16;

/// What was read of all models together.
pub(super) struct Counts<'l> {
    limits: &'l Limits,
    watch: &'l Watch,
    objects: u64,
    vertices: u64,
    triangles: u64,
}

impl<'l> Counts<'l> {
    pub(super) fn of(limits: &'l Limits, watch: &'l Watch) -> Self {
        Counts { limits, watch, objects: 0, vertices: 0, triangles: 0 }
    }

    pub(super) fn object(&mut self, entry: &str) -> Result<(), Fault> {
        self.objects += 1;
        self.look(self.objects)?;
        within(entry, PARTS, self.objects, self.limits.max_parts)
    }

    #[inline]
    pub(super) fn vertex(&mut self, entry: &str) -> Result<(), Fault> {
        self.vertices += 1;
        self.look(self.vertices)?;
        within(entry, "vertices", self.vertices, self.limits.max_vertices)
    }

    #[inline]
    pub(super) fn triangle(&mut self, entry: &str) -> Result<(), Fault> {
        self.triangles += 1;
        self.look(self.triangles)?;
        within(entry, "faces", self.triangles, self.limits.max_faces)?;
        within(entry, "corners", self.triangles * 3, self.limits.max_corners)
    }

    /// Looks at the watch from time to time, and at the first element.
    #[inline]
    fn look(&self, count: u64) -> Result<(), Fault> {
        if count % BETWEEN_LOOKS != 1 {
            return Ok(());
        }
        let read = usize::try_from(self.vertices + self.triangles).unwrap_or(usize::MAX);
        self.watch.look(READ, read, 0).map_err(Fault::stopped)
    }
}

#[inline]
fn within(entry: &str, what: &'static str, found: u64, limit: u64) -> Result<(), Fault> {
    if found <= limit { Ok(()) } else { Err(Fault::limit(entry, what, found, limit)) }
}
