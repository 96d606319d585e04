//! Turns faces so that neighbours agree, and drops patches that are there twice.
//!
//! *Why*: half of a mesh looks inward, a wall is stored twice, a body once more on top of itself. Turning comes before
//! any splitting: a torus with half its faces flipped needs nothing but flips.
//!
//! 1. On the patches of rule 1 alone, with the directions as stored, drop duplicate patches: a doubled object goes
//!    whole, and a closed solid that merely touches another one is never torn.
//! 2. On the patches of rules 1 and 2, orient and drop duplicate patches, again and again until there is none. Only edges
//!    that lost a side and patches that merged are looked at again.
//! 3. Opposite duplicates (double-sided walls) stay, unless the policy says otherwise. If some go, step 2 is done again.
//! 4. A flipped face keeps its first corner first and reverses the rest.
//!
//! A patch without a consistent orientation is left as it is and named with a witness; or the policy cuts it or gives up.
//! If patches are turned outward, those that have no outer side are named, and the walls of hollows that were turned.
//!
//! *Promises* no inconsistent edge in any orientable patch. *Requires* simple faces, so that duplicates are those of the
//! text; it works on any faces. *May introduce* boundary edges where duplicates went, and unreferenced vertices. *Cost*:
//! O(n log n), however many rounds there are.
//!
//! | what the text says | where |
//! |---|---|
//! | faces with the same directed cycle of vertices | [`repeats`] |
//! | the matching by rules 1 and 2, while faces go | [`live_matching`] |
//! | a patch, and what is known of it | [`patch_table`] |
//! | to orient a patch; duplicate patches go | [`patches`], [`ownership`] |
//! | outward, and nested shells | [`outward`], [`nesting`], [`winding`], [`crossing`] |
//! | the seam of a patch that is cut | [`seams`] |
//! | opposite duplicates | [`opposites`] |
//! | the new mesh and the record | [`fates`], [`turned`], [`record`], [`one_sided`] |

use meshmend_core::{Connectivity, DefectKind, FaceId, PolygonMesh};
use meshmend_kernels::KernelTask;
use meshmend_topology::TopologyReport;

use crate::fates::{self, Fates};
use crate::turned::turned;
use crate::{Context, Outcome, Pass, PassError, PassKind};

mod crossing;
mod live_matching;
mod manifold_fast_path;
mod nesting;
mod one_sided;
mod opposites;
mod options;
mod outward;
mod ownership;
mod patch_table;
mod patches;
mod record;
mod repeats;
mod seams;
mod subject;
mod winding;

pub(crate) use options::ROW;
pub use options::{Duplicates, NonOrientable, Orient, Side};

use live_matching::{LiveMatching, pairs_as_stored};
use outward::{NamedPatch, Nested};
use patches::{Choice, Contradiction, Patches, Policy};
use subject::Subject;

impl Pass for Orient {
    fn kind(&self) -> PassKind {
        PassKind::Orient
    }
    fn removes(&self) -> &'static [DefectKind] {
        &[DefectKind::InconsistentEdge]
    }
    fn requires(&self) -> &'static [DefectKind] {
        &[DefectKind::DegenerateFace, DefectKind::NonSimpleFace, DefectKind::RepeatedCorner]
    }
    fn may_introduce(&self) -> &'static [DefectKind] {
        &[
            DefectKind::BoundaryEdge,
            DefectKind::UnreferencedVertex,
            DefectKind::NonOrientablePatch,
            DefectKind::PinchedVertex,
            // A face that is turned may run as another one does, or against it.
            DefectKind::DuplicateFace,
            DefectKind::OppositeFace,
        ]
    }

    fn apply(&self, mesh: &PolygonMesh, context: &Context<'_>) -> Result<Outcome, PassError> {
        if self.side == Side::Majority && context.known.is_some_and(is_oriented) {
            return Ok(Outcome::unchanged(mesh));
        }
        let complex = mesh.complex();
        context.check_cancelled()?;
        context.kernel.run(complex, Task { options: self, mesh, context })?
    }
}

/// Whether no face is there twice, in either direction, no edge has three sides or more, and all neighbours agree.
fn is_oriented(report: &TopologyReport) -> bool {
    report.duplicate_faces.same == 0
        && report.duplicate_faces.opposite == 0
        && report.non_manifold_edges == 0
        && report.consistently_oriented
}

struct Task<'a> {
    options: &'a Orient,
    mesh: &'a PolygonMesh,
    context: &'a Context<'a>,
}

impl KernelTask for Task<'_> {
    type Output = Result<Outcome, PassError>;

    fn run<K: Connectivity>(self, kernel: &K) -> Self::Output {
        self.context.check_cancelled()?;
        let subject = Subject::new(kernel, self.mesh, self.context);
        self.context.check_cancelled()?;
        let oriented = self.options.oriented(&subject)?;
        self.options.outcome(&subject, &oriented)
    }
}

/// What the steps have found.
struct Oriented {
    fates: Fates,
    /// The lowest face of each patch without a consistent orientation, ascending.
    non_orientable: Vec<FaceId>,
    /// What there is to say of patches that were to be turned outward.
    outward: Vec<NamedPatch>,
}

impl Orient {
    /// Steps 1 to 3.
    fn oriented<K: Connectivity>(&self, subject: &Subject<'_, K>) -> Result<Oriented, PassError> {
        let mut fates = Fates::unchanged(subject.kernel.face_count());
        if !subject.repeats.is_empty() {
            fates = without_stored_duplicates(subject, fates);
        } else if self.side == Side::Majority
            && let Some(fates) = manifold_fast_path::fates(subject.kernel)
        {
            return Ok(Oriented { fates, non_orientable: Vec::new(), outward: Vec::new() });
        }
        loop {
            subject.context.check_cancelled()?;
            let mut oriented = self.oriented_once(subject, fates)?;
            let opposites = opposites::to_remove(self.duplicates, &subject.repeats, &oriented.fates);
            if opposites.is_empty() {
                return Ok(oriented);
            }
            opposites.into_iter().for_each(|face| oriented.fates.remove(face));
            fates = oriented.fates;
        }
    }

    /// Step 2.
    fn oriented_once<K: Connectivity>(
        &self,
        subject: &Subject<'_, K>,
        fates: Fates,
    ) -> Result<Oriented, PassError> {
        let mut matching = LiveMatching::new(subject, &fates);
        let mut patches = Patches::new(subject, self.policy(), fates);
        subject.context.check_cancelled()?;
        let mut pairs = matching.new_pairs(patches.fates());
        if self.non_orientable == NonOrientable::Cut {
            pairs = seams::seams_last(subject.kernel, &subject.stored, pairs);
        }
        loop {
            patches.join_across(&pairs);
            subject.context.check_cancelled()?;
            let gone = patches.drop_duplicates();
            if gone.is_empty() {
                break;
            }
            subject.context.check_cancelled()?;
            gone.into_iter().for_each(|face| matching.remove_face(face));
            pairs = matching.new_pairs(patches.fates());
        }
        let outward = match self.side {
            Side::Majority => Vec::new(),
            Side::Outward => outward::judge(subject, &mut patches, Nested::Outward),
            Side::OutwardNested => outward::judge(subject, &mut patches, Nested::Alternating),
        };
        let non_orientable = patches.non_orientable();
        Ok(Oriented { fates: patches.into_fates(), non_orientable, outward })
    }

    /// How patches are oriented in step 2.
    fn policy(&self) -> Policy {
        Policy {
            choice: match self.side {
                Side::Majority => Choice::Majority,
                Side::Outward | Side::OutwardNested => Choice::Outward,
            },
            contradiction: match self.non_orientable {
                NonOrientable::Cut => Contradiction::Cuts,
                NonOrientable::Report | NonOrientable::Fail => Contradiction::Twists,
            },
        }
    }

    /// Step 4, and the record.
    fn outcome<K: Connectivity>(
        &self,
        subject: &Subject<'_, K>,
        oriented: &Oriented,
    ) -> Result<Outcome, PassError> {
        let Oriented { fates, non_orientable, outward } = oriented;
        subject.context.check_cancelled()?;
        let mut outcome = if fates.all_stay() && !fates.any_is_flipped() {
            Outcome::unchanged(subject.mesh)
        } else {
            let gone = record::gone(&subject.repeats, fates);
            let differed = record::differed(subject, &gone);
            subject.context.check_cancelled()?;
            let rebuilt = turned(subject.mesh, fates, self.flipped_normals)?;
            Outcome { differed, ..Outcome::changed(rebuilt, record::fixed(subject, fates, gone)) }
        };
        subject.context.check_cancelled()?;
        let new_ids = fates.new_ids();
        outcome.left = record::left(subject, fates, &new_ids);
        outcome.left.extend(outward.iter().map(|patch| patch.defect(new_ids.of(patch.lowest))));
        let lowest: Vec<_> = non_orientable.iter().map(|&face| new_ids.of(face)).collect();
        let one_sided = one_sided::judge(self.non_orientable, subject.context, &outcome, &lowest)?;
        outcome.left.extend(one_sided);
        Ok(outcome)
    }
}

/// Step 1. One round is enough here: patches that merge without a flip unblock nothing.
fn without_stored_duplicates<K: Connectivity>(subject: &Subject<'_, K>, fates: Fates) -> Fates {
    let policy = Policy { choice: Choice::AsStored, contradiction: Contradiction::Twists };
    let mut patches = Patches::new(subject, policy, fates);
    patches.join_across(&pairs_as_stored(subject));
    patches.drop_duplicates();
    patches.into_fates()
}
