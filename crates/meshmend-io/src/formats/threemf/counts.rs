//! How much of everything was read of a package, against the limits.

use crate::Limits;
use crate::formats::threemf::package::Fault;
use crate::limits::PARTS;

/// What was read of all models together.
pub(super) struct Counts<'l> {
    limits: &'l Limits,
    objects: u64,
    vertices: u64,
    triangles: u64,
}

impl<'l> Counts<'l> {
    pub(super) fn of(limits: &'l Limits) -> Self {
        Counts { limits, objects: 0, vertices: 0, triangles: 0 }
    }

    pub(super) fn object(&mut self, entry: &str) -> Result<(), Fault> {
        self.objects += 1;
        within(entry, PARTS, self.objects, self.limits.max_parts)
    }

    #[inline]
    pub(super) fn vertex(&mut self, entry: &str) -> Result<(), Fault> {
        self.vertices += 1;
        within(entry, "vertices", self.vertices, self.limits.max_vertices)
    }

    #[inline]
    pub(super) fn triangle(&mut self, entry: &str) -> Result<(), Fault> {
        self.triangles += 1;
        within(entry, "faces", self.triangles, self.limits.max_faces)?;
        within(entry, "corners", self.triangles * 3, self.limits.max_corners)
    }
}

#[inline]
fn within(entry: &str, what: &'static str, found: u64, limit: u64) -> Result<(), Fault> {
    if found <= limit { Ok(()) } else { Err(Fault::limit(entry, what, found, limit)) }
}
