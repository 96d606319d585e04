//! Passes that need not be begun.
//!
//! On an oriented surface of triangles most passes have nothing to do: no face is degenerate, not simple or repeated, no side runs the
//! wrong way, no edge has a third side, no vertex comes apart, and none is unused. Whether a mesh is one is told by the corners of its
//! vertices alone, in a tenth of the time that the passes take, and in a third of the memory. That is asked after the first weld; where a
//! pass has something to do, those after it are begun too: which sides are matched depends on the vertices as stored, and not on the mesh
//! alone. Who wants a report gets the passes one by one: they are what this way is tested against.

use meshmend_geometry::vector::is_finite;
use meshmend_kernels::KernelKind;

use super::Session;
use crate::{AnyPass, Orient, Side};

impl Session {
    /// Whether a pass would find nothing to do, and nobody asks what it sees.
    pub(crate) fn is_spared(&mut self, pass: &AnyPass) -> bool {
        let is_sparing = self.spares_topology
            && !self.takes_figures
            && self.topology.is_none()
            && self.kernel == KernelKind::default();
        is_sparing && has_nothing_to_do_on_a_surface(pass) && self.is_plain_surface()
    }

    /// Whether the mesh is an oriented surface of triangles and nothing else, at finite places. It is asked once for each mesh.
    fn is_plain_surface(&mut self) -> bool {
        if let Some(known) = self.is_plain_surface {
            return known;
        }
        let mesh = &self.mesh;
        let is_finite = match mesh.shared_places() {
            Some(places) => places.points().iter().all(is_finite),
            None => mesh.positions().iter().all(is_finite),
        };
        let is_alone = mesh.loose_edges().is_empty() && mesh.loose_points().is_empty();
        let found = is_finite && is_alone && mesh.complex().is_oriented_surface();
        self.is_plain_surface = Some(found);
        found
    }
}

/// Whether a pass changes no oriented surface of triangles, whatever its other options are.
fn has_nothing_to_do_on_a_surface(pass: &AnyPass) -> bool {
    match pass {
        AnyPass::Clean(_)
        | AnyPass::Split(_)
        | AnyPass::Triangulate(_)
        | AnyPass::Compact(_)
        | AnyPass::Verify(_) => true,
        AnyPass::Orient(Orient { side, .. }) => *side == Side::Majority,
        _ => false,
    }
}
