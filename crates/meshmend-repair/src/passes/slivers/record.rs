//! What became of each sliver.

use std::fmt;

use meshmend_core::{FaceId, Lie};
use meshmend_spatial::{FoundSliver, MendedSlivers, SliverKind, SliverMend, SliverReason};
use serde::Serialize;

use crate::fates::NewIds;

/// A step that was made for a sliver, or a sliver that is left.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SliverRecord {
    /// The face: of a step by its id before the pass, of a sliver that is left by that after it.
    pub face: FaceId,
    /// What it looks like, before the step.
    pub shape: SliverKind,
    /// How many times as long as high it is, before the step; absent if it has no area.
    pub aspect: Option<f64>,
    /// What became of it.
    #[serde(flatten)]
    pub fate: SliverFate,
}

/// What became of a sliver.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum SliverFate {
    /// A step was made, by ids before the pass.
    Mended(SliverMend),
    /// It is left.
    Left {
        /// Why.
        left: SliverReason,
    },
}

impl SliverRecord {
    /// Whether a step was made.
    pub fn is_step(&self) -> bool {
        matches!(self.fate, SliverFate::Mended(_))
    }

    /// Whether it is left because of the distance or the number of steps, so that a second run may go on.
    pub fn is_limited(&self) -> bool {
        matches!(self.fate, SliverFate::Left { left } if left.is_limit())
    }
}

/// What a sliver looks like, in the words of defects.
pub(super) fn lie(kind: SliverKind) -> Lie {
    match kind {
        SliverKind::Needle => Lie::Needle,
        SliverKind::Cap => Lie::Cap,
    }
}

/// The steps in order, and then the slivers that are left, by the ids of the mesh before.
pub(super) fn of(mended: &MendedSlivers) -> Vec<SliverRecord> {
    let record = |sliver: FoundSliver, fate| {
        let FoundSliver { face, kind, aspect } = sliver;
        SliverRecord { face, shape: kind, aspect, fate }
    };
    let steps = mended.steps.iter().map(|step| record(step.sliver, SliverFate::Mended(step.mend)));
    let left = mended.left.iter().map(|left| record(left.sliver, SliverFate::Left { left: left.reason }));
    steps.chain(left).collect()
}

/// The records with the slivers that are left by the ids of the mesh after.
pub(super) fn renamed(mut records: Vec<SliverRecord>, new_ids: &NewIds) -> Vec<SliverRecord> {
    let left = records.iter_mut().filter(|record| !record.is_step());
    left.for_each(|record| record.face = new_ids.of(record.face));
    records
}

impl fmt::Display for SliverRecord {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, a {}", self.face, self.shape.name())?;
        match self.aspect {
            Some(aspect) => write!(f, " of aspect {aspect:.6}: ")?,
            None => f.write_str(" without area: ")?,
        }
        match &self.fate {
            SliverFate::Mended(mend) => mend.fmt(f),
            SliverFate::Left { left } => write!(f, "left: {}", left.reason()),
        }
    }
}
