//! What is read of loose edges and points beside their vertices.

use crate::input::indices::Uses;

/// The layer that tells which loose edges are one polyline.
pub(super) const POLYLINE: &str = "polyline";

/// The layer of the texture coordinates at the ends of loose edges; those at their starts are in `texcoord`.
pub(super) const END_TEXCOORD: &str = "texcoord_end";

/// What was read of loose elements beside the elements themselves.
#[derive(Default)]
pub(super) struct LooseParts {
    /// Which polyline each edge belongs to, if there is one of several edges.
    pub(super) polylines: Vec<u32>,
    pub(super) polyline_count: u32,
    pub(super) has_long: bool,
    pub(super) texcoords: [Uses; 3],
}
