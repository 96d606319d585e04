//! What one pass of a repair did, as a document.

use std::collections::BTreeMap;

use meshmend_core::{Defect, DefectKind};
use meshmend_repair::{
    Advice, ApartRecord, DropRecord, DroppedComponent, Figures, Looked, LoopRecord, PassKind, PassRecord,
    SeamFigures, SliverRecord, TJunctionRecord,
};
use serde::Serialize;

use super::Listing;

/// What one pass did.
#[derive(Clone, Debug, Serialize)]
pub struct PassDocument {
    /// The pass.
    pub pass: PassKind,
    /// Whether it changed anything.
    pub changed: bool,
    /// What was wrong and no longer is, by ids of the mesh before the pass.
    pub mended: BTreeMap<DefectKind, Listing<Defect>>,
    /// What it left alone, by ids of the mesh after the pass.
    pub left: BTreeMap<DefectKind, Listing<Defect>>,
    /// How the figures changed, if they were taken.
    pub delta: Option<FigureChanges>,
    /// What cutting non-orientable patches open took, where it did.
    pub seam: Option<SeamFigures>,
    /// What became of each boundary loop, where the pass judged them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub loops: Option<Listing<LoopRecord>>,
    /// What became of each vertex on an open edge, where the pass judged them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub t_junctions: Option<TJunctionsDocument>,
    /// What became of each sliver, where the pass mends them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub slivers: Option<SliversDocument>,
    /// What was dropped, where the pass drops parts.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub dropped: Option<DroppedDocument>,
    /// What became of the vertices at places of others, where the pass keeps these apart.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub apart: Option<ApartDocument>,
    /// Which weld tolerance stood out, where the pass looked for one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub advice: Option<Advice>,
    /// Whether `verify` looked at the mesh afresh, or was told what was known before and is still true.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub looked: Option<Looked>,
}

/// What became of the vertices on open edges.
#[derive(Clone, Debug, Serialize)]
pub struct TJunctionsDocument {
    /// Those that became corners of the faces there.
    pub healed: Listing<TJunctionRecord>,
    /// Those that are still there, with the reason.
    pub left: Listing<TJunctionRecord>,
}

impl TJunctionsDocument {
    fn new(records: &[TJunctionRecord], limit: usize) -> Self {
        let [healed, left] = parted(records, TJunctionRecord::is_healed, limit);
        TJunctionsDocument { healed, left }
    }
}

/// What became of the vertices at places of others.
#[derive(Clone, Debug, Serialize)]
pub struct ApartDocument {
    /// Those that have a place of their own now.
    pub moved: Listing<ApartRecord>,
    /// Those that are where they were, with the reason.
    pub left: Listing<ApartRecord>,
}

impl ApartDocument {
    fn new(records: &[ApartRecord], limit: usize) -> Self {
        let [moved, left] = parted(records, ApartRecord::is_moved, limit);
        ApartDocument { moved, left }
    }
}

/// Records of what was done, and those of what was left, each cut to a limit.
fn parted<T: Clone>(records: &[T], is_done: impl Fn(&T) -> bool, limit: usize) -> [Listing<T>; 2] {
    let (done, left): (Vec<T>, Vec<T>) = records.iter().cloned().partition(is_done);
    [done, left].map(|records| Listing::cut(records.into_iter(), limit))
}

/// What became of the slivers.
#[derive(Clone, Debug, Serialize)]
pub struct SliversDocument {
    /// The steps that were made, in order, by ids of the mesh before the pass.
    pub steps: Listing<SliverRecord>,
    /// The slivers that are left, each with the reason, by ids of the mesh after the pass.
    pub left: Listing<SliverRecord>,
    /// How many of these are left because of the distance or the number of steps: where there is one, a second run may go on.
    pub move_limit: u64,
}

impl SliversDocument {
    fn new(records: &[SliverRecord], limit: usize) -> Self {
        let (steps, left): (Vec<SliverRecord>, Vec<SliverRecord>) =
            records.iter().cloned().partition(SliverRecord::is_step);
        let move_limit = left.iter().filter(|record| record.is_limited()).count() as u64;
        let [steps, left] = [steps, left].map(|records| Listing::cut(records.into_iter(), limit));
        SliversDocument { steps, left, move_limit }
    }
}

/// What was dropped, and what it left.
#[derive(Clone, Debug, Serialize)]
pub struct DroppedDocument {
    /// The components that went as a whole.
    pub components: Listing<DroppedComponent>,
    /// How many edges of the boundary there are now that were none.
    pub opened_edges: usize,
    /// How many faces are still there of which it can't be said whether they are inside of others, where that was asked.
    pub mixed_faces: usize,
}

impl DroppedDocument {
    fn new(record: &DropRecord, limit: usize) -> Self {
        DroppedDocument {
            components: Listing::cut(record.components.iter().cloned(), limit),
            opened_edges: record.opened_edges,
            mixed_faces: record.mixed_faces,
        }
    }
}

/// How much a pass added to the three figures that show its effect.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct FigureChanges {
    /// To V − E + F.
    pub euler_characteristic: i64,
    /// To the number of components.
    pub components: i64,
    /// To the number of boundary loops; absent where the mesh is not manifold before or after.
    pub boundary_loops: Option<i64>,
}

impl PassDocument {
    pub(super) fn new(record: &PassRecord, limit: usize) -> Self {
        let judged = record.pass == PassKind::Fill || !record.loops.is_empty();
        PassDocument {
            pass: record.pass,
            changed: record.is_changed,
            mended: by_kind(record.fixed.iter(), limit),
            left: by_kind(record.left.iter().cloned(), limit),
            delta: record.figures.map(|[before, after]| FigureChanges::between(before, after)),
            seam: record.seam,
            loops: judged.then(|| Listing::cut(record.loops.iter().cloned(), limit)),
            t_junctions: (record.pass == PassKind::Heal)
                .then(|| TJunctionsDocument::new(&record.t_junctions, limit)),
            slivers: (record.pass == PassKind::Slivers).then(|| SliversDocument::new(&record.slivers, limit)),
            dropped: record.dropped.as_ref().map(|record| DroppedDocument::new(record, limit)),
            apart: (record.pass == PassKind::KeepApart).then(|| ApartDocument::new(&record.apart, limit)),
            advice: record.advice.clone(),
            looked: record.looked,
        }
    }
}

fn by_kind(defects: impl Iterator<Item = Defect>, limit: usize) -> BTreeMap<DefectKind, Listing<Defect>> {
    let mut groups: BTreeMap<DefectKind, Listing<Defect>> = BTreeMap::new();
    for defect in defects {
        groups.entry(defect.kind()).or_default().add(limit, || defect);
    }
    groups
}

impl FigureChanges {
    fn between(before: Figures, after: Figures) -> Self {
        let loops = before.boundary_loops.zip(after.boundary_loops);
        FigureChanges {
            euler_characteristic: after.euler_characteristic - before.euler_characteristic,
            components: after.components as i64 - before.components as i64,
            boundary_loops: loops.map(|(before, after)| after as i64 - before as i64),
        }
    }
}
