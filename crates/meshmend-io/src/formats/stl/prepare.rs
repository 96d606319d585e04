//! What happens to a mesh before it is written as STL: positions are rounded, and polygons are cut.

use crate::output::triangles::cut_polygons;
use crate::{Encoding, Prepared, WriteErrorKind};

/// Rounds positions if they are stored in single precision, and cuts polygons into triangles. Rounding comes first,
/// so that all further steps judge what will be read again.
pub(super) fn prepare(prepared: &mut Prepared) -> Result<(), WriteErrorKind> {
    if prepared.encoding != Encoding::Ascii {
        prepared.round_positions();
    }
    cut_polygons(prepared)
}
