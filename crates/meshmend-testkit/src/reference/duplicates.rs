//! Dropping faces that are repeated as stored, and patches that double others.

use std::collections::{BTreeMap, BTreeSet};

use super::Pipeline;
use super::corners::canonical;

impl Pipeline {
    /// Of faces with the same cycle of vertices as stored, the first stays.
    pub(super) fn drop_repeated_faces(&mut self) {
        let mut seen = BTreeSet::new();
        self.faces.retain(|face| seen.insert(canonical(&face.corners)));
    }

    /// A patch goes when each of its faces is doubled, the same way, in another patch that is still there; the
    /// smallest is asked first, of equal ones the one with the higher lowest face. Says whether any went.
    pub(super) fn drop_duplicate_patches(&mut self) -> bool {
        let names = |corners: &[u32]| corners.iter().map(|&c| self.name(c)).collect::<Vec<_>>();
        let cycles: Vec<_> = self.faces.iter().map(|face| canonical(&names(&face.corners))).collect();
        let mut owners: BTreeMap<&Vec<u32>, BTreeSet<usize>> = BTreeMap::new();
        for (p, patch) in self.patches.iter().enumerate() {
            for &f in patch {
                owners.entry(&cycles[f]).or_default().insert(p);
            }
        }
        let mut order: Vec<usize> = (0..self.patches.len()).collect();
        order.sort_by_key(|&p| {
            let patch = &self.patches[p];
            (patch.len(), std::cmp::Reverse(patch.iter().min().copied()))
        });
        let mut gone = BTreeSet::new();
        for p in order {
            let is_doubled = |f: &usize| owners[&cycles[*f]].iter().any(|&owner| owner != p);
            if self.patches[p].iter().all(is_doubled) {
                gone.extend(self.patches[p].iter().copied());
                for &f in &self.patches[p] {
                    owners.entry(&cycles[f]).or_default().remove(&p);
                }
            }
        }
        let mut place = 0..;
        self.faces.retain(|_| !gone.contains(&place.next().unwrap_or(0)));
        !gone.is_empty()
    }
}
