//! What happens to a mesh before it is written as STL: positions are rounded, and polygons are cut.

use meshmend_geometry::rounding::in_single_precision;

use crate::formats::stl::triangles;
use crate::{Encoding, Prepared, WriteErrorKind, rounding_losses};

/// Rounds positions if they are stored in single precision, and cuts polygons into triangles. Rounding comes first,
/// so that all further steps judge what will be read again.
pub(super) fn prepare(prepared: &mut Prepared) -> Result<(), WriteErrorKind> {
    let rounded =
        if prepared.encoding == Encoding::Ascii { None } else { in_single_precision(&prepared.mesh) };
    if let Some((mesh, rounding)) = rounded {
        let vertices = mesh.counts().vertices;
        prepared.mesh = mesh;
        prepared.losses.extend(rounding_losses(rounding, vertices));
    }
    triangles::cut_polygons(prepared)
}
