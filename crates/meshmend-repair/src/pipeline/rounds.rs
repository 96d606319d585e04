//! Whether a repair is final, and what is done where it is not.
//!
//! A second repair with the same options must find nothing to change. The default policies leave nothing for it: what
//! they match as welded they match as stored the next time. Other policies may: a face that was turned outward repeats
//! another one, a patch that `pinch-only` left is no longer held together by what it was, two faces that are the same
//! as welded are now the same as stored. Then all passes run again on the result as it will be read, round by round,
//! until a round changes nothing. That round is not part of the record. Faces that repeat others and differ from them are
//! looked at again under any policy: which faces those are depends on the sides that were chosen.

use super::Pipeline;
use crate::{
    AnyPass, Distance, Duplicates, NonFinite, NonOrientable, PassError, PassKind, Seams, Session, Side,
    SplitEdges,
};

/// More rounds than any mesh is known to need.
const MOST_ROUNDS: usize = 16;

/// How many times the corners of what is read again a round may make of them. Passes in another order than the usual one,
/// or twice, may subdivide the same faces in each round, without an end.
const MOST_GROWTH: usize = 4;

/// What tells that a repair is final.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Finality {
    /// It always is, unless vertices that came apart are one again when they are read: with the default policies, and where
    /// passes only remove what no later one brings back.
    Always,
    /// No face came apart from another, and none was cut: then the result is manifold, and no two of its vertices are
    /// welded, so that the same sides are matched again.
    UnlessTakenApart,
    /// No pass changed anything, and faces that share a vertex do so when the result is read again.
    IfUnchanged,
}

impl Pipeline {
    /// Runs the passes on the result as it will be read, again and again, until that changes nothing.
    pub(super) fn settled(&self, mut session: Session) -> Result<Session, PassError> {
        if !self.may_change_again(&session)? || self.faces.is_read_again(session.stored(), session.mesh())? {
            return Ok(session);
        }
        let looks = |pass: &&AnyPass| pass.kind() == PassKind::Verify;
        let again = self.passes().iter().filter(|pass| pass.as_pass().is_idempotent());
        let (looking, changing): (Vec<&AnyPass>, Vec<&AnyPass>) = again.partition(looks);
        let mut most_corners = None;
        for _ in 0..MOST_ROUNDS {
            let (read, reading) = self.faces.read_again(session.mesh())?;
            let most_corners = *most_corners.get_or_insert(MOST_GROWTH * read.counts().corners);
            let mut next = session.another(&read);
            self.run_round(changing.iter().copied(), &mut next)?;
            let has_outgrown = next.mesh().counts().corners > most_corners;
            if has_outgrown || self.faces.is_read_again(&read, next.mesh())? {
                break;
            }
            self.run_round(looking.iter().copied(), &mut next)?;
            session.follow((&read, &reading), next);
            if !self.may_change_again(&session)? {
                break;
            }
        }
        Ok(session)
    }

    /// Whether the passes might change what the last round left.
    fn may_change_again(&self, session: &Session) -> Result<bool, PassError> {
        let changed =
            |kind| session.last_round().iter().any(|record| record.pass == kind && record.is_changed);
        let has_changed = session.last_round().iter().any(|record| record.is_changed);
        let is_taken_apart =
            [PassKind::Split, PassKind::Fill, PassKind::Triangulate, PassKind::Slivers, PassKind::Outward]
                .into_iter()
                .any(changed);
        let is_cut_by_writer = self.faces.is_apart() && !session.mesh().faces().is_all_triangles();
        let may_change = match self.finality() {
            Finality::Always => {
                let has_copies = session.has_copies() && has_changed;
                has_copies || is_taken_apart && self.faces.takes_apart(session.mesh())?
            }
            Finality::UnlessTakenApart => is_taken_apart,
            Finality::IfUnchanged => has_changed || self.faces.takes_apart(session.mesh())?,
        };
        Ok(may_change || is_cut_by_writer || self.welds_further(session))
    }

    /// Whether a tolerance in parts of a box has grown with the box: vertices that were joined to one that no face used are
    /// where that was.
    fn welds_further(&self, session: &Session) -> bool {
        let grows = |pass: &AnyPass| pass.as_pass().tolerance_on(session.mesh()) > session.tolerance();
        self.passes().iter().any(grows)
    }

    /// What tells that a repair by these passes is final.
    fn finality(&self) -> Finality {
        let mut kinds: Vec<PassKind> = self.passes().iter().map(AnyPass::kind).collect();
        // Where closed patches are turned outward, `orient` runs once more after `split`.
        if let Some(again) = kinds.windows(2).position(|two| two == [PassKind::Split, PassKind::Orient]) {
            kinds.remove(again + 1);
        }
        let removes_alone =
            |kind: &PassKind| matches!(kind, PassKind::Clean | PassKind::Compact | PassKind::Verify);
        if kinds.iter().all(removes_alone) {
            return Finality::Always;
        }
        let needed = [PassKind::Weld, PassKind::Clean, PassKind::Orient, PassKind::Split];
        let is_whole = needed.iter().all(|kind| kinds.contains(kind))
            && kinds.windows(2).all(|two| two[0] < two[1])
            && !self.passes().iter().any(leaves_edges);
        if !is_whole {
            Finality::IfUnchanged
        } else if self.passes().iter().all(|pass| self.is_usual(pass)) && !self.faces.is_apart() {
            Finality::Always
        } else {
            Finality::UnlessTakenApart
        }
    }

    /// Whether a pass has a policy that leaves nothing for a second run.
    fn is_usual(&self, pass: &AnyPass) -> bool {
        let cuts = |pass: &AnyPass| matches!(pass, AnyPass::Orient(orient) if orient.non_orientable == NonOrientable::Cut);
        match pass {
            AnyPass::Weld(weld) => weld.distance == Distance::Exact,
            AnyPass::Orient(orient) => orient.side == Side::Majority && orient.duplicates == Duplicates::Keep,
            AnyPass::Split(split) => split.seams == Seams::Keep || self.passes().iter().any(cuts),
            AnyPass::Slivers(_) | AnyPass::Outward(_) => false,
            _ => true,
        }
    }
}

/// Whether a pass leaves edges of three sides or more, vertices that can't be welded again, or what it may judge in another way
/// once vertices are joined or moved, or faces cut or dropped.
fn leaves_edges(pass: &AnyPass) -> bool {
    match pass {
        AnyPass::Split(split) => split.edges == SplitEdges::PinchOnly,
        AnyPass::Clean(clean) => clean.non_finite == NonFinite::Keep,
        AnyPass::Weld(weld) => {
            matches!(weld.distance, Distance::Boundary(_) | Distance::BoundaryRelative(_) | Distance::Auto)
        }
        // Nothing is known of a pass of another crate.
        AnyPass::Heal(_) | AnyPass::DropParts(_) | AnyPass::KeepApart(_) | AnyPass::Own(_) => true,
        _ => false,
    }
}
