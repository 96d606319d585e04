//! Where attributes differ.

use meshmend_core::{Aspect, CornerId, Domain, FaceId, Id, Layer, PolygonMesh, Role};
use meshmend_spatial::Attributes;

/// The layers that tell corners of a vertex, and neighbouring faces, apart. What names a row of a file does not.
pub(super) struct Layers<'a> {
    corners: Vec<&'a Layer>,
    faces: Vec<&'a Layer>,
}

impl<'a> Layers<'a> {
    /// Those of a mesh: of corners all, of faces those that tell a face from one in the same place.
    pub(super) fn of(mesh: &'a PolygonMesh) -> Self {
        let of = |domain| move |layer: &&Layer| layer.domain() == domain && layer.role() != Role::Identity;
        let tells = |layer: &&Layer| Aspect::of_layer(layer).is_some();
        let layers = || mesh.layers().iter();
        Layers {
            corners: layers().filter(of(Domain::Corner)).collect(),
            faces: layers().filter(of(Domain::Face)).filter(tells).collect(),
        }
    }
}

impl Attributes for Layers<'_> {
    fn corners_agree(&self, one: CornerId, other: CornerId) -> bool {
        self.corners.iter().all(|layer| layer.agree(one.index(), other.index()))
    }
    fn faces_agree(&self, one: FaceId, other: FaceId) -> bool {
        self.faces.iter().all(|layer| layer.agree(one.index(), other.index()))
    }
}
