//! What is read of loose edges and points beside their vertices.

use crate::input::indices::Uses;

/// The layer whose values group loose edges into polylines.
pub(super) const POLYLINE: &str = "polyline";

/// The layer of the texture coordinates at the ends of loose edges. Those at the starts are in `texcoord`.
pub(super) const END_TEXCOORD: &str = "texcoord_end";

/// What was read about loose elements.
#[derive(Default)]
pub(super) struct LooseParts {
    /// The polyline of each edge.
    pub(super) polylines: Vec<u32>,
    pub(super) polyline_count: u32,
    pub(super) has_long: bool,
    pub(super) texcoords: [Uses; 3],
}
