//! Which larger faces have the same cycle of corner positions, either way round.

use meshmend_core::{FaceId, PolygonMesh, VertexId};

/// Classes of larger faces with the same cycle.
#[derive(Default)]
pub(super) struct Cycles {
    /// For each larger face that shares its cycle with another one the lowest that has it; sorted by face.
    shared: Vec<(FaceId, FaceId)>,
}

impl Cycles {
    /// Of all faces with more than three corners but those that are unfit, given ascending.
    ///
    /// *Cost*: O(c log c) for c corners.
    pub(super) fn of(mesh: &PolygonMesh, place: impl Fn(VertexId) -> VertexId, unfit: &[FaceId]) -> Self {
        let is_asked =
            |face: &FaceId| mesh.faces().corner_range(*face).len() > 3 && unfit.binary_search(face).is_err();
        let cycle = |face: FaceId| {
            let corners = mesh.faces().face_vertices(face).iter().map(|&vertex| place(vertex));
            one_way(corners.collect())
        };
        let mut keyed: Vec<(Vec<VertexId>, FaceId)> =
            mesh.faces().faces().filter(is_asked).map(|face| (cycle(face), face)).collect();
        keyed.sort_unstable();
        let classes = keyed.chunk_by(|one, other| one.0 == other.0).filter(|class| class.len() > 1);
        let mut shared: Vec<(FaceId, FaceId)> =
            classes.flat_map(|class| class.iter().map(|(_, face)| (*face, class[0].1))).collect();
        shared.sort_unstable();
        Cycles { shared }
    }

    /// Whether two faces have the same cycle.
    pub(super) fn is_same(&self, one: FaceId, other: FaceId) -> bool {
        let class = |face: FaceId| {
            let at = self.shared.binary_search_by_key(&face, |&(face, _)| face).ok()?;
            Some(self.shared[at].1)
        };
        class(one).is_some_and(|lowest| class(other) == Some(lowest))
    }
}

/// A cycle of different vertices from its least one towards the lesser neighbour of that.
fn one_way(mut cycle: Vec<VertexId>) -> Vec<VertexId> {
    let least = (0..cycle.len()).min_by_key(|&at| cycle[at]).unwrap_or(0);
    cycle.rotate_left(least);
    if cycle.get(1) > cycle.last() {
        cycle[1..].reverse();
    }
    cycle
}
