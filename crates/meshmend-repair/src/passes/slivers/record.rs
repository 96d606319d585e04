//! What became of each sliver.

use std::fmt;

use meshmend_core::{FaceId, Lie, VertexId};
use meshmend_spatial::{FoundSliver, MendedSlivers, SliverKind, SliverMend, SliverReason};
use serde::{Serialize, Serializer};

use crate::fates::NewIds;

/// A step that was made for a sliver, or a sliver that is left.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SliverRecord {
    /// The face: of a step by its id before the pass, of a sliver that is left by that after it.
    pub face: FaceId,
    /// What it looks like, before the step.
    #[serde(serialize_with = "kind_by_name")]
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
    /// A step was made.
    Mended(SliverMending),
    /// It is left.
    Left {
        /// Why.
        #[serde(serialize_with = "reason_by_name")]
        left: SliverReason,
    },
}

/// A step that was made for a sliver, by ids before the pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "step", rename_all = "kebab-case")]
pub enum SliverMending {
    /// One end of its shortest edge went into the other.
    Collapse {
        /// The vertex that is gone.
        from: VertexId,
        /// The one that it went into.
        into: VertexId,
    },
    /// Its longest edge was flipped.
    Flip {
        /// The ends of the edge that went.
        edge: [VertexId; 2],
        /// The ends of the edge that came.
        to: [VertexId; 2],
        /// The other face of the edge.
        with: FaceId,
    },
    /// It went.
    Drop,
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

fn kind_by_name<S: Serializer>(kind: &SliverKind, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(kind.name())
}

fn reason_by_name<S: Serializer>(reason: &SliverReason, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(reason.name())
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
    let steps = mended.steps.iter().map(|step| record(step.sliver, SliverFate::Mended(mending(step.mend))));
    let left = mended.left.iter().map(|left| record(left.sliver, SliverFate::Left { left: left.reason }));
    steps.chain(left).collect()
}

/// The records with the slivers that are left by the ids of the mesh after.
pub(super) fn renamed(mut records: Vec<SliverRecord>, new_ids: &NewIds) -> Vec<SliverRecord> {
    let left = records.iter_mut().filter(|record| !record.is_step());
    left.for_each(|record| record.face = new_ids.of(record.face));
    records
}

fn mending(mend: SliverMend) -> SliverMending {
    match mend {
        SliverMend::Collapse { from, into } => SliverMending::Collapse { from, into },
        SliverMend::Flip { edge, to, with } => SliverMending::Flip { edge, to, with },
        SliverMend::Drop => SliverMending::Drop,
    }
}

impl fmt::Display for SliverMending {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SliverMending::Collapse { from, into } => write!(f, "{from} went into {into}"),
            SliverMending::Flip { edge: [a, b], to: [c, d], with } => {
                write!(f, "the edge {a}-{b} to {with} was flipped to {c}-{d}")
            }
            SliverMending::Drop => f.write_str("it went"),
        }
    }
}

impl fmt::Display for SliverRecord {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, a {}", self.face, self.shape.name())?;
        match self.aspect {
            Some(aspect) => write!(f, " of aspect {aspect:.6}: ")?,
            None => f.write_str(" without area: ")?,
        }
        match &self.fate {
            SliverFate::Mended(mending) => mending.fmt(f),
            SliverFate::Left { left } => write!(f, "left: {}", left.reason()),
        }
    }
}
