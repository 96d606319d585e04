//! What was dropped.

use std::fmt;

use meshmend_core::{DefectKind, FaceId, counted};
use serde::Serialize;

/// What was dropped, and what it left.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct DropRecord {
    /// The components that went as a whole, by lowest face.
    pub components: Vec<DroppedComponent>,
    /// How many edges of the boundary there are now that were none.
    pub opened_edges: usize,
    /// How many faces are still there of which it can't be said whether they are inside of others, where that was asked.
    pub mixed_faces: usize,
}

/// A component that went as a whole.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DroppedComponent {
    /// Its lowest face.
    pub lowest_face: FaceId,
    /// How many faces it had.
    pub faces: u32,
    /// Its area.
    pub area: f64,
    /// The volume that it enclosed, if it did.
    pub volume: Option<f64>,
    /// Why it went.
    pub reason: DefectKind,
}

impl fmt::Display for DroppedComponent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let DroppedComponent { lowest_face, faces, area, volume, reason } = self;
        write!(f, "component of {lowest_face}: {}, area {area:.6}", counted(*faces as usize, "face"))?;
        volume.iter().try_for_each(|volume| write!(f, ", volume {volume:.6}"))?;
        let why = if *reason == DefectKind::InternalFace { "inside others" } else { "under the limit" };
        write!(f, ": dropped, {why}")
    }
}
