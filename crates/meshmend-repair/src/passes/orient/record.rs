//! What there is to say of a mesh that was oriented: what was fixed, what was left, and what went although it differed.

use meshmend_core::{Connectivity, Defect, Differences, EdgeId, FaceId, VertexId, is_inconsistent};

use super::fates::{Fates, NewIds};
use super::repeats::Repeats;
use super::subject::Subject;
use crate::copies::looks;
use crate::telling::Telling;
use crate::{Fixed, TellingLayers};

/// The inconsistent edges that flips made consistent, and the faces that went.
pub(super) fn fixed<K: Connectivity>(subject: &Subject<'_, K>, fates: &Fates, gone: Vec<Defect>) -> Fixed {
    Fixed::turned(turned_edges(subject.kernel, fates), gone)
}

/// The inconsistent edges of which one face is flipped and the other is not.
fn turned_edges<K: Connectivity>(kernel: &K, fates: &Fates) -> Vec<(EdgeId, [VertexId; 2])> {
    let is_turned = |&edge: &EdgeId| {
        is_inconsistent(kernel, edge) && {
            let mut flips = kernel.edge_faces(edge).map(|face| fates.is_flipped(face));
            flips.next() != flips.next()
        }
    };
    kernel.edges().filter(is_turned).map(|edge| (edge, kernel.edge_ends(edge))).collect()
}

/// The faces that went, each with one that stays and repeats it: in the same direction, or else in the other one.
pub(super) fn gone(repeats: &Repeats, fates: &Fates) -> Vec<Defect> {
    let runs_backward = |face: FaceId| repeats.runs_backward(face, fates.is_flipped(face));
    let defect = |face: FaceId| {
        let staying = || repeats.group_of(face).iter().copied().filter(|&other| fates.stays(other));
        let repeats_it =
            |&other: &FaceId| runs_backward(other) == runs_backward(face) && repeats.are_alike(other, face);
        match staying().find(repeats_it) {
            Some(original) => Defect::duplicate_face(face, original),
            None => Defect::opposite_face(face, staying().next().unwrap_or(face)),
        }
    };
    fates.going().map(defect).collect()
}

/// In what faces that went differ from those that they repeat, in any layer of the mesh.
pub(super) fn differed<K: Connectivity>(
    subject: &Subject<'_, K>,
    gone: &[Defect],
) -> Vec<(FaceId, Differences)> {
    let Some(telling) = Telling::of(subject.mesh, TellingLayers::All) else { return Vec::new() };
    let differs = |defect: &Defect| {
        let (face, original) = (defect.at.face()?, defect.beside.as_ref()?.face()?);
        Some((face, differences(subject, &telling, face, original)))
    };
    gone.iter().filter_map(differs).filter(|(_, differs)| !differs.is_empty()).collect()
}

fn differences<K: Connectivity>(
    subject: &Subject<'_, K>,
    telling: &Telling<'_>,
    one: FaceId,
    other: FaceId,
) -> Differences {
    let [one, other] = [one, other].map(|face| looks(subject.kernel, subject.mesh, face));
    telling.differences(&one, &other)
}

/// Opposite duplicates that stay, and repeated faces that stay because they differ, by the new faces' ids.
pub(super) fn left<K: Connectivity>(
    subject: &Subject<'_, K>,
    fates: &Fates,
    new_ids: &NewIds,
) -> Vec<Defect> {
    let repeats = &subject.repeats;
    let telling = Telling::of(subject.mesh, subject.context.telling);
    let runs_backward = |face: FaceId| repeats.runs_backward(face, fates.is_flipped(face));
    let mut left = Vec::new();
    for group in repeats.groups() {
        let staying: Vec<FaceId> = group.iter().copied().filter(|&face| fates.stays(face)).collect();
        let Some(&first) = staying.first() else { continue };
        let (alongside, against): (Vec<FaceId>, Vec<FaceId>) =
            staying.iter().partition(|&&face| runs_backward(face) == runs_backward(first));
        let opposite = |&face: &FaceId| Defect::opposite_face(new_ids.of(face), new_ids.of(first));
        left.extend(against.iter().map(opposite));
        let Some(telling) = &telling else { continue };
        for faces in [alongside, against] {
            left.extend(differing(subject, telling, &faces).map(|(face, original, differs)| {
                Defect::differing_face(new_ids.of(face), new_ids.of(original), differs)
            }));
        }
    }
    left.sort();
    left
}

/// The faces that differ from the first of some that run alike: the face, the first one, and in what they differ.
fn differing<K: Connectivity>(
    subject: &Subject<'_, K>,
    telling: &Telling<'_>,
    faces: &[FaceId],
) -> impl Iterator<Item = (FaceId, FaceId, Differences)> {
    faces.split_first().into_iter().flat_map(move |(&first, others)| {
        let differing = others.iter().filter(move |&&face| !subject.repeats.are_alike(face, first));
        differing.map(move |&face| (face, first, differences(subject, telling, face, first)))
    })
}
