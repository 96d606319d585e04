//! What a repair did to what was found about where the faces lie.

use std::collections::BTreeMap;

use meshmend_core::{Defect, DefectKind, Element, FaceId, PolygonMesh, Provenance};
use serde::Serialize;

use super::{GeometryOptions, Question};
use crate::CheckReport;

/// How many defects of a kind there were, and what became of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct GeometryChange {
    /// How many there were.
    pub before: u64,
    /// How many of these are gone.
    pub mended: u64,
    /// How many there are that were not there, by the stored faces that they are about, or for T-junctions by position.
    pub new: u64,
    /// How many there are that were there before. Of a face that was cut there may be several.
    pub left: u64,
}

/// What a repair did to the defects of each kind; none where a search stopped at its budget.
pub type GeometryChanges = BTreeMap<DefectKind, Option<GeometryChange>>;

/// What tells that two defects of a kind are the same one, before a repair and after it.
type Key = Vec<[u64; 3]>;

/// The defects that a check found about where faces lie, as they can be found again after a repair.
#[derive(Clone, Debug, Default)]
pub struct GeometryMarks {
    of_kind: BTreeMap<DefectKind, Option<Vec<Key>>>,
}

impl GeometryMarks {
    /// Those of a mesh as stored.
    pub fn before(report: &CheckReport, options: &GeometryOptions) -> Self {
        Self::of(report, options, Some)
    }

    /// Those of a repaired mesh, in terms of the mesh as stored.
    pub fn after(report: &CheckReport, options: &GeometryOptions, provenance: &Provenance) -> Self {
        Self::of(report, options, |face| provenance.faces.of(face))
    }

    fn of(
        report: &CheckReport,
        options: &GeometryOptions,
        stored: impl Fn(FaceId) -> Option<FaceId> + Copy,
    ) -> Self {
        let is_asked = |kind: &DefectKind| {
            Question::about(*kind).is_some_and(|question| options.questions.contains(question))
        };
        let found = report.geometry.as_ref();
        let is_stopped = found
            .and_then(|found| found.intersections.as_ref())
            .is_some_and(|intersections| intersections.figures.is_none());
        let keys = |kind: DefectKind| {
            let needs_all = matches!(Question::about(kind), Some(Question::Crossings | Question::Internal));
            let mut keys: Vec<Key> =
                report.defects_of_kind(kind).map(|defect| key(&defect, &report.mesh, stored)).collect();
            keys.sort_unstable();
            (!is_stopped || !needs_all).then_some(keys)
        };
        let kinds = DefectKind::ALL.iter().copied().filter(is_asked);
        GeometryMarks { of_kind: kinds.map(|kind| (kind, keys(kind))).collect() }
    }

    /// What became of each kind.
    ///
    /// *Cost*: O(n log n).
    pub fn changes_to(&self, after: &GeometryMarks) -> GeometryChanges {
        let change = |(kind, before): (&DefectKind, &Option<Vec<Key>>)| {
            let both = before.as_ref().zip(after.of_kind.get(kind).and_then(Option::as_ref));
            (*kind, both.map(|(before, after)| change(before, after)))
        };
        self.of_kind.iter().map(change).collect()
    }
}

fn change(before: &[Key], after: &[Key]) -> GeometryChange {
    let missing = |keys: &[Key], among: &[Key]| {
        keys.iter().filter(|key| among.binary_search(key).is_err()).count() as u64
    };
    let new = missing(after, before);
    GeometryChange {
        before: before.len() as u64,
        mended: missing(before, after),
        new,
        left: after.len() as u64 - new,
    }
}

/// The stored faces that a defect is about, ascending; for a vertex on an edge where these are.
fn key(defect: &Defect, mesh: &PolygonMesh, stored: impl Fn(FaceId) -> Option<FaceId>) -> Key {
    let elements = [Some(&defect.at), defect.beside.as_ref()].into_iter().flatten();
    let place = |vertex| mesh.position(vertex).map(|x| (x + 0.0).to_bits());
    let parts = elements.flat_map(|element| match element {
        Element::Vertex(vertex) => vec![place(*vertex)],
        Element::Edge { ends, .. } => ends.map(place).to_vec(),
        _ => element.face().map(|face| face_mark(face, stored(face))).into_iter().collect(),
    });
    let mut key: Key = parts.collect();
    key.sort_unstable();
    key
}

/// What marks a face: the one that it is or was a part of, else its own number.
fn face_mark(face: FaceId, stored: Option<FaceId>) -> [u64; 3] {
    match stored {
        Some(stored) => [0, stored.0.into(), 0],
        None => [1, face.0.into(), 0],
    }
}
