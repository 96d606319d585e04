//! Which patches could not be turned outward, and which walls of hollows were.

use meshmend_core::{Connectivity, Defect, FaceId, Unjudged};

use super::fates::Fates;
use super::nesting;
use super::patches::{OrientedPatch, Patches};
use super::subject::Subject;

/// Whether closed patches inside others are turned outward, too.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Nested {
    Outward,
    Alternating,
}

/// A patch of which something is to be said, by its lowest face.
pub(super) struct NamedPatch {
    pub(super) lowest: FaceId,
    faces: u32,
    what: What,
}

#[derive(Clone, Copy)]
enum What {
    Unjudged(Unjudged),
    TurnedCavity,
}

impl NamedPatch {
    fn of(patch: &OrientedPatch, what: What) -> Self {
        NamedPatch { lowest: patch.lowest, faces: patch.faces.len() as u32, what }
    }

    /// The patch as a defect, its lowest face having got a new number.
    pub(super) fn defect(&self, lowest: FaceId) -> Defect {
        match self.what {
            What::Unjudged(reason) => Defect::unjudged_patch(lowest, self.faces, reason),
            What::TurnedCavity => Defect::turned_cavity(lowest, self.faces),
        }
    }
}

/// Turns the walls of hollows inward if shells alternate, else names those that were turned outward; then names the
/// patches that have no outer side.
///
/// *Cost*: linear, and that of [`nesting::are_hollows`] if shells alternate or a closed patch was turned.
pub(super) fn judge<K: Connectivity>(
    subject: &Subject<'_, K>,
    patches: &mut Patches<'_, K>,
    nested: Nested,
) -> Vec<NamedPatch> {
    let all = patches.oriented();
    let unjudged: Vec<Option<Unjudged>> = all.iter().map(|patch| patches.unjudged(patch)).collect();
    let (closed, judged): (Vec<&OrientedPatch>, Vec<bool>) = all
        .iter()
        .zip(&unjudged)
        .filter(|(patch, _)| patch.is_closed)
        .map(|(patch, unjudged)| (patch, unjudged.is_none()))
        .unzip();
    let turned: Vec<bool> = closed.iter().map(|patch| is_turned(patch, patches.fates())).collect();
    let mut named = Vec::new();
    if nested == Nested::Alternating || turned.contains(&true) {
        let faces: Vec<&[FaceId]> = closed.iter().map(|patch| patch.faces.as_slice()).collect();
        let are_hollows = nesting::are_hollows(subject.kernel, subject.mesh, &faces, patches.fates());
        for place in (0..closed.len()).filter(|&place| are_hollows[place]) {
            let patch = closed[place];
            match nested {
                // Without a volume it has no outer side, and goes by majority inside a shell, too.
                Nested::Alternating if judged[place] => patches.turn(&patch.faces),
                Nested::Outward if turned[place] => named.push(NamedPatch::of(patch, What::TurnedCavity)),
                _ => {}
            }
        }
    }
    let reasons = all.iter().zip(unjudged).filter_map(|(patch, reason)| Some((patch, reason?)));
    named.extend(reasons.map(|(patch, reason)| NamedPatch::of(patch, What::Unjudged(reason))));
    named
}

/// Whether most faces of a patch are flipped; of as many as are not, whether the lowest is.
fn is_turned(patch: &OrientedPatch, fates: &Fates) -> bool {
    let flipped = patch.faces.iter().filter(|&&face| fates.is_flipped(face)).count();
    let count = patch.faces.len();
    2 * flipped > count || (2 * flipped == count && fates.is_flipped(patch.lowest))
}
