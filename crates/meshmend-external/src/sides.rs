//! Faces joined into patches, in four bytes a face.
//!
//! *Source*: R. E. Tarjan, *Efficiency of a good but not linear set union algorithm*, 1975; path halving, with the side against
//! the parent as in R. E. Tarjan, J. van Leeuwen, *Worst-case analysis of set union algorithms*, 1984.

use fixedbitset::FixedBitSet;

/// Disjoint classes of faces, each of which lies on one of two sides. The root of a class is its lowest face.
pub(crate) struct PatchSides {
    /// The parent of each face, doubled, plus one where it is turned against it.
    parent: Vec<u32>,
    /// Of roots: whether no sides agree with all that was joined.
    is_twisted: FixedBitSet,
    /// Of roots: whether a face of the class has an edge with one side.
    is_open: FixedBitSet,
}

impl PatchSides {
    /// Each of fewer than 2³¹ faces in a class of its own.
    pub(crate) fn new(count: usize) -> Self {
        PatchSides {
            parent: (0..count as u32).map(|face| face << 1).collect(),
            is_twisted: FixedBitSet::with_capacity(count),
            is_open: FixedBitSet::with_capacity(count),
        }
    }

    /// How many bytes it takes for so many faces.
    pub(crate) fn bytes(count: u64) -> u64 {
        4 * count + count / 4
    }

    /// The root of a face's class, and whether the face is turned against it.
    pub(crate) fn find(&mut self, face: u32) -> (u32, bool) {
        let (mut at, mut turned) = (face, 0);
        loop {
            let word = self.parent[at as usize];
            let up = word >> 1;
            if up == at {
                return (at, turned == 1);
            }
            // Skip a generation: the grandparent's side is the two steps together.
            let above = self.parent[up as usize];
            let skipped = above ^ (word & 1);
            self.parent[at as usize] = if above >> 1 == up { word } else { skipped };
            turned ^= self.parent[at as usize] & 1;
            at = self.parent[at as usize] >> 1;
        }
    }

    /// Joins the classes of two faces so that they are turned against each other or not. Returns whether that contradicts
    /// what was joined before.
    pub(crate) fn join(&mut self, one: u32, other: u32, turned: bool) -> bool {
        let ((a, side_a), (b, side_b)) = (self.find(one), self.find(other));
        let turned = turned ^ side_a ^ side_b;
        if a == b {
            if turned {
                self.is_twisted.insert(a as usize);
            }
            return turned;
        }
        let (root, child) = (a.min(b), a.max(b));
        self.parent[child as usize] = root << 1 | u32::from(turned);
        for flags in [&mut self.is_twisted, &mut self.is_open] {
            if flags.contains(child as usize) {
                flags.insert(root as usize);
            }
        }
        false
    }

    /// Marks the class of a face as open.
    pub(crate) fn open(&mut self, face: u32) {
        let root = self.find(face).0;
        self.is_open.insert(root as usize);
    }

    pub(crate) fn is_root(&self, face: u32) -> bool {
        self.parent[face as usize] >> 1 == face
    }

    /// Whether the class of a root has no consistent sides.
    pub(crate) fn is_twisted(&self, root: u32) -> bool {
        self.is_twisted.contains(root as usize)
    }

    /// Whether the class of a root has an edge with one side.
    pub(crate) fn is_open(&self, root: u32) -> bool {
        self.is_open.contains(root as usize)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use meshmend_core::{FaceId, Joined, SidedClasses};

    #[test]
    fn they_agree_with_classes_of_nine_bytes() {
        let mut state = 7u64;
        let mut below = |n: u64| {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            ((state >> 33) % n) as u32
        };
        for _ in 0..200 {
            let (mut sides, mut known) = (PatchSides::new(40), SidedClasses::<FaceId>::new(40));
            for _ in 0..30 {
                let (one, other, turned) = (below(40), below(40), below(2) == 1);
                let contradicts =
                    matches!(known.join(FaceId(one), FaceId(other), turned), Joined::Contradicts { .. });
                assert_eq!(sides.join(one, other, turned), contradicts);
            }
            for one in 0..40 {
                let (root, turned) = sides.find(one);
                assert!(root <= one && sides.is_root(root));
                let (known_root, known_side) = known.find(FaceId(one));
                let (of_root, root_side) = known.find(FaceId(root));
                assert_eq!((known_root, known_side ^ root_side), (of_root, turned));
            }
        }
    }

    #[test]
    fn marks_stay_with_the_class() {
        let mut sides = PatchSides::new(6);
        assert!(!sides.join(4, 5, true) && sides.join(5, 4, false));
        sides.open(3);
        sides.join(5, 3, false);
        sides.join(3, 1, true);
        let root = sides.find(4).0;
        assert_eq!((root, sides.is_twisted(1), sides.is_open(1)), (1, true, true));
        assert!(!sides.is_twisted(0) && !sides.is_open(0));
    }
}
