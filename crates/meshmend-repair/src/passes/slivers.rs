//! Mends triangles that are far longer than they are high, and says why it leaves others.
//!
//! *Why*: normals, textures and simulations go wrong on them, and programs that round coordinates make them turn over.
//!
//! 1. Find the slivers: triangles whose longest edge is at least so many times their height over it. One with a short edge is
//!    a needle, any other a cap.
//! 2. A needle's shortest edge is collapsed: one end goes into the other. A cap's longest edge is flipped; where that is
//!    boundary, the cap goes. Needles come first. [`meshmend_spatial::mend_slivers`] decides which steps may be made: none
//!    changes how faces hang together, turns a face over, makes another face a worse sliver or crosses a seam of attributes.
//! 3. No vertex moves, and every vertex as stored that one stands for in the end is within a distance of it.
//!
//! A corner that comes to another vertex has the attributes that this had in the faces that went.
//!
//! *Promises* that each sliver is mended or has a reason. *Requires* nothing; faces that are not triangles stay as they are.
//! *May introduce* nothing, but crossings that only a whole search sees. A second run may go on where the distance was the
//! reason: it does not know where vertices were. *Cost*: linear, and for each step that of the faces round it.

use meshmend_core::{Cancelled, Defect, DefectKind, FaceId, Id, PolygonMesh};
use meshmend_spatial::{FoundSliver, MendedSlivers, Reshaped, SliverTask, mend_slivers};
use serde::{Deserialize, Serialize};

use crate::tolerance::resolved_on;
use crate::{
    Context, Distance, Form, OptionValues, Outcome, Pass, PassError, PassKind, PassOption, PassRow, Reach,
};

mod attributes;
mod limit;
mod record;
mod reshaped;
mod stored;

pub use meshmend_spatial::SliverMend;
pub use record::{SliverFate, SliverRecord};

/// Mends triangles that are far longer than they are high.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
pub struct Slivers {
    /// From how many times its height on the longest edge makes a triangle a sliver: 1 or more.
    #[serde(deserialize_with = "limit::aspect")]
    pub aspect: f64,
    /// How far the surface may move: in parts of the diagonal of the box of all vertices that faces use, or a length.
    pub max_move: Reach,
}

impl Default for Slivers {
    fn default() -> Self {
        Slivers { aspect: 1000.0, max_move: Reach::Relative(1e-6) }
    }
}

/// All that is said of the pass.
pub(crate) const ROW: PassRow = PassRow {
    name: "slivers",
    explanation: "Mends triangles that are far longer than they are high: the short edge of a needle is collapsed, the long edge of \
                  a cap is flipped, or the cap goes where that edge is boundary. How faces hang together stays the same, no face \
                  turns over, and nothing moves farther than allowed from where it was stored. Each step is named, and each \
                  sliver that is left with the reason.",
    is_default: false,
    before: None,
    options: &[
        PassOption {
            name: "slivers",
            help: "Mend triangles that are at least so many times as long as they are high, such as 1000",
            sets: &["aspect"],
            values: OptionValues::Aspect,
        },
        PassOption {
            name: "max-move",
            help: "How far the surface may move where slivers are mended: a length, or a percentage of the bounding box's diagonal",
            sets: &["max-move"],
            values: OptionValues::Reach,
        },
    ],
    form: Form::of::<Slivers>(),
};

impl Pass for Slivers {
    fn kind(&self) -> PassKind {
        PassKind::Slivers
    }
    fn may_introduce(&self) -> &'static [DefectKind] {
        &[]
    }

    fn apply(&self, mesh: &PolygonMesh, context: &Context<'_>) -> Result<Outcome, PassError> {
        let task = SliverTask {
            mesh,
            aspect: limit::checked(self.aspect)
                .map_err(|reason| PassError::Request { pass: ROW.name, reason })?,
            // What went before is not known vertex by vertex: together they stay within the distance.
            reach: (resolved_on(ROW.name, mesh, self.reach())? - context.moved).max(0.0),
            stood_for: &stored::points(mesh, context),
            attributes: &attributes::Layers::of(mesh),
        };
        let goes_on = || context.check_cancelled().is_ok();
        let mended = mend_slivers(&task, &goes_on).ok_or(Cancelled)?;
        let records = record::of(&mended);
        let Some(reshaped) = &mended.reshaped else {
            let left = mended.left.iter().map(|left| defect(left.sliver, left.sliver.face)).collect();
            return Ok(Outcome { slivers: records, left, ..Outcome::unchanged(mesh) });
        };
        let went = reshaped::destinations(mesh, &mended.steps);
        let mut fixed = fixed(&mended, reshaped);
        let joined = went.iter().enumerate().filter(|(vertex, into)| into.index() != *vertex);
        fixed.extend(joined.map(|(vertex, &into)| Defect::coincident_vertex(Id::new(vertex), into)));
        let outcome = Outcome::changed(reshaped::rebuilt(mesh, reshaped, went)?, fixed);
        let new_ids = reshaped::new_ids(reshaped);
        let mut left: Vec<Defect> =
            mended.left.iter().map(|left| defect(left.sliver, new_ids.of(left.sliver.face))).collect();
        left.sort();
        Ok(Outcome { slivers: record::renamed(records, &new_ids), left, moved: mended.farthest, ..outcome })
    }
}

impl Slivers {
    /// How far the surface may move.
    fn reach(&self) -> Distance {
        match self.max_move {
            Reach::Absolute(length) => Distance::Absolute(length),
            Reach::Relative(part) => Distance::Relative(part),
        }
    }
}

/// A sliver as a defect of a face.
fn defect(sliver: FoundSliver, face: FaceId) -> Defect {
    match sliver.aspect {
        Some(_) => Defect::sliver_face(face, record::lie(sliver.kind)),
        None => Defect::zero_area_face(face),
    }
}

/// The slivers of the mesh that are none now, and the faces that went.
fn fixed(mended: &MendedSlivers, reshaped: &Reshaped) -> Vec<Defect> {
    let is_left = |face: FaceId| mended.left.binary_search_by_key(&face, |left| left.sliver.face).is_ok();
    let is_gone = |face: FaceId| reshaped.is_gone[face.index()];
    let mut named: Vec<FoundSliver> =
        mended.found.iter().filter(|sliver| !is_left(sliver.face)).copied().collect();
    named.extend(mended.steps.iter().map(|step| step.sliver).filter(|sliver| is_gone(sliver.face)));
    // The sort is stable: a face is named as it was found.
    named.sort_by_key(|sliver| sliver.face);
    named.dedup_by_key(|sliver| sliver.face);
    let has_name = |face: FaceId| named.binary_search_by_key(&face, |sliver| sliver.face).is_ok();
    let went = (0..reshaped.is_gone.len()).map(FaceId::new).filter(|&face| is_gone(face) && !has_name(face));
    let went = went.map(Defect::degenerate_face);
    named.iter().map(|&sliver| defect(sliver, sliver.face)).chain(went).collect()
}
