//! Faces that are there once in each direction, as in double-sided walls: which of them go.

use meshmend_core::FaceId;

use super::fates::Fates;
use super::options::Duplicates;
use super::repeats::Repeats;

/// The faces that go because they are there in the other direction too.
pub(super) fn to_remove(policy: Duplicates, repeats: &Repeats, fates: &Fates) -> Vec<FaceId> {
    match policy {
        Duplicates::Keep => Vec::new(),
        Duplicates::RemovePair => {
            repeats.groups().iter().flat_map(|group| pairs(&Directions::of(group, repeats, fates))).collect()
        }
        Duplicates::KeepFirst => {
            let but_first = |group: &Vec<FaceId>| but_first(Directions::of(group, repeats, fates), repeats);
            repeats.groups().iter().flat_map(but_first).collect()
        }
    }
}

/// The faces of a group that stay, by the direction in which they run its cycle, each ascending.
struct Directions {
    backward: Vec<FaceId>,
    forward: Vec<FaceId>,
}

impl Directions {
    fn of(group: &[FaceId], repeats: &Repeats, fates: &Fates) -> Self {
        let staying = group.iter().copied().filter(|&face| fates.stays(face));
        let (backward, forward) =
            staying.partition(|&face| repeats.runs_backward(face, fates.is_flipped(face)));
        Directions { backward, forward }
    }
}

/// As many faces of each direction as there are pairs.
fn pairs(Directions { backward, forward }: &Directions) -> Vec<FaceId> {
    let count = backward.len().min(forward.len());
    [&backward[..count], &forward[..count]].concat()
}

/// If there are faces of both directions: all but the first, and but those that run as the first does and differ from it.
fn but_first(Directions { backward, forward }: Directions, repeats: &Repeats) -> Vec<FaceId> {
    let (Some(&first_backward), Some(&first_forward)) = (backward.first(), forward.first()) else {
        return Vec::new();
    };
    let first = first_backward.min(first_forward);
    let (alongside, against) =
        if first == first_backward { (backward, forward) } else { (forward, backward) };
    let repeating = alongside.into_iter().filter(|&face| face != first && repeats.are_alike(face, first));
    repeating.chain(against).collect()
}
