//! What a repair promises in kinds of defects: what is gone afterwards, and what may be new.

use std::collections::BTreeMap;

use meshmend_core::{DefectKind, PolygonMesh};

use crate::oracle;

/// The promise of a repair.
#[derive(Clone, Copy, Debug)]
pub struct Promise {
    /// What is gone afterwards.
    pub removes: &'static [DefectKind],
    /// What must be gone before, for the promise to hold.
    pub requires: &'static [DefectKind],
    /// What may be there afterwards though it was not before.
    pub may_introduce: &'static [DefectKind],
}

/// How many defects of each kind a mesh has, by the oracle.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct DefectCounts {
    by_kind: BTreeMap<DefectKind, usize>,
    /// The inconsistent edges that flipping faces can mend.
    mendable_clashes: usize,
}

impl DefectCounts {
    /// Counts the defects of a mesh.
    pub fn of(mesh: &PolygonMesh) -> Self {
        let mut by_kind = BTreeMap::new();
        oracle::defects(mesh).iter().for_each(|defect| *by_kind.entry(defect.kind()).or_insert(0) += 1);
        DefectCounts { by_kind, mendable_clashes: oracle::mendable_clashes(mesh).len() }
    }

    /// The same, blind to some kinds: for a step in which they are not what the oracle takes them for.
    pub fn without(mut self, kinds: &[DefectKind]) -> Self {
        self.by_kind.retain(|kind, _| !kinds.contains(kind));
        if kinds.contains(&DefectKind::InconsistentEdge) {
            self.mendable_clashes = 0;
        }
        self
    }

    /// How many defects of a kind there are.
    pub fn count(&self, kind: DefectKind) -> usize {
        self.by_kind.get(&kind).copied().unwrap_or(0)
    }

    /// How many defects there are that are not part of another one, as the clashes in a patch without a consistent side
    /// are.
    fn alone(&self, kind: DefectKind) -> usize {
        if kind == DefectKind::InconsistentEdge { self.mendable_clashes } else { self.count(kind) }
    }
}

impl Promise {
    /// Whether what was to be gone is gone, if what had to be gone before was gone, and no kind of defect is new that
    /// may not be.
    ///
    /// # Errors
    /// The kind of defect that breaks the promise.
    pub fn law(&self, before: &DefectCounts, after: &DefectCounts) -> Result<(), String> {
        if self.requires.iter().any(|&kind| before.count(kind) > 0) {
            return Ok(());
        }
        if let Some(kind) = self.removes.iter().find(|kind| after.alone(**kind) > 0) {
            return Err(format!("{} {} are left", after.alone(*kind), kind.title()));
        }
        let is_new = |kind: &DefectKind| before.count(*kind) == 0 && after.alone(*kind) > 0;
        match DefectKind::ALL.iter().find(|kind| is_new(kind) && !self.may_introduce.contains(kind)) {
            Some(kind) => Err(format!("{} {} are new", after.count(*kind), kind.title())),
            None => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Soup;
    use crate::shapes::{Tiles, book, moebius_band, torus};

    const ORIENTS: Promise = Promise {
        removes: &[DefectKind::InconsistentEdge],
        requires: &[DefectKind::NonManifoldEdge],
        may_introduce: &[DefectKind::BoundaryEdge],
    };

    #[test]
    fn what_is_left_and_what_is_new_breaks_a_promise() {
        let counts = |soup: &Soup| DefectCounts::of(&soup.mesh());
        let whole = torus(3, 3, Tiles::Quads).soup;
        let (mut turned, mut open, mut pinched) = (whole.clone(), whole.clone(), whole.clone());
        turned.faces[4].reverse();
        open.faces.pop();
        pinched.faces.iter_mut().flatten().filter(|v| **v == 8).for_each(|v| *v = 0);
        let law = |after: &Soup| ORIENTS.law(&counts(&whole), &counts(after));
        assert_eq!((law(&whole), law(&open)), (Ok(()), Ok(())));
        assert_eq!(law(&turned), Err("4 inconsistently oriented edges are left".into()));
        assert!(law(&pinched).is_err());
        assert_eq!(
            ORIENTS.law(&counts(&book(3).soup), &counts(&turned)),
            Ok(()),
            "what it requires is missing"
        );
        let band = counts(&moebius_band(4, 1, Tiles::Quads).soup);
        assert_eq!(ORIENTS.law(&band, &band), Ok(()), "a band has a clash that no flip mends");
    }
}
