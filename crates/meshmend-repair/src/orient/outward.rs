//! What turning closed patches outward could not judge, and which walls of hollows it turned.

use meshmend_core::{Column, Connectivity, Defect, FaceId, PolygonMesh, Unjudged};

use super::nesting;
use super::patches::Patches;

/// A patch by its lowest face, and how many faces it has.
pub(super) struct PatchNamed {
    face: FaceId,
    faces: u32,
    what: What,
}

enum What {
    Unjudged(Unjudged),
    TurnedCavity,
}

/// Whether closed patches inside others are turned outward, too.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Nested {
    Outward,
    Alternating,
}

/// Turns the walls of hollows inward if they alternate, else names those that were turned outward; and names the patches
/// that have no outer side.
///
/// *Cost*: linear, and that of [`nesting::are_hollows`] if shells alternate or a closed patch was turned.
pub(super) fn judge<K: Connectivity>(
    kernel: &K,
    mesh: &PolygonMesh,
    patches: &mut Patches<'_, K>,
    nested: Nested,
) -> Vec<PatchNamed> {
    let closed = patches.closed();
    let turned: Vec<bool> = closed.iter().map(|faces| is_turned(faces, &patches.is_flipped)).collect();
    let unjudged = patches.unjudged();
    let mut without_volume: Vec<_> = unjudged.iter().filter_map(|(faces, _)| faces.iter().min()).collect();
    without_volume.sort_unstable();
    let mut named = Vec::new();
    if nested == Nested::Alternating || turned.contains(&true) {
        let hollows = nesting::are_hollows(kernel, mesh, &closed, &patches.is_flipped);
        for ((faces, is_turned), _) in
            closed.iter().zip(turned).zip(hollows).filter(|(_, is_hollow)| *is_hollow)
        {
            if nested == Nested::Alternating {
                // Without a volume it has no outer side, and goes by majority inside a shell, too.
                let is_judged =
                    faces.iter().min().is_none_or(|face| without_volume.binary_search(&face).is_err());
                if is_judged {
                    patches.turn(faces);
                }
            } else if is_turned {
                named.push(PatchNamed::of(faces, What::TurnedCavity));
            }
        }
    }
    named.extend(unjudged.iter().map(|(faces, reason)| PatchNamed::of(faces, What::Unjudged(*reason))));
    named
}

/// Whether most faces of a patch are turned; of as many as are not, whether the lowest is.
fn is_turned(faces: &[FaceId], is_flipped: &Column<FaceId, bool>) -> bool {
    let turned = faces.iter().filter(|&&face| is_flipped[face]).count();
    let lowest = faces.iter().min();
    2 * turned > faces.len() || (2 * turned == faces.len() && lowest.is_some_and(|&face| is_flipped[face]))
}

impl PatchNamed {
    fn of(faces: &[FaceId], what: What) -> Self {
        let face = faces.iter().min().copied().unwrap_or_default();
        PatchNamed { face, faces: faces.len() as u32, what }
    }

    /// The lowest face of the patch.
    pub(super) fn face(&self) -> FaceId {
        self.face
    }

    /// The patch as a defect, its lowest face having got a new number.
    pub(super) fn defect(&self, face: FaceId) -> Defect {
        match self.what {
            What::Unjudged(reason) => Defect::unjudged_patch(face, self.faces, reason),
            What::TurnedCavity => Defect::turned_cavity(face, self.faces),
        }
    }
}
