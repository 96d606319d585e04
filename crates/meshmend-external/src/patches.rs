//! Patches, and the Betti numbers that follow from them.

use fixedbitset::FixedBitSet;
use meshmend_topology::{Betti, ELIMINATION_BUDGET, PatchEnds, PatchId, PatchUse, TwoCycles, betti_of};

use crate::error::ExternalError;
use crate::lowest::Lowest;
use crate::sides::PatchSides;
use crate::spill::Spill;

/// What is known of the patches of a mesh.
pub(crate) struct Patches {
    /// How many there are.
    pub(crate) count: u64,
    /// How many are not orientable.
    pub(crate) twisted: u64,
    /// The lowest faces of the first of those.
    pub(crate) first_twisted: Vec<u32>,
    system: System,
}

/// The system that tells β₂: of patches at edges of degree 3 or more each is known, of others only how many are unknowns.
struct System {
    /// The patches at such edges, by lowest face.
    patches: Vec<PatchEnds>,
    uses: Vec<PatchUse>,
    /// Where the uses of each edge end.
    ends: Vec<usize>,
    free: [u64; 2],
}

impl Patches {
    /// Looks at the classes of so many faces, of which so many are no part of the complex.
    pub(crate) fn of(
        sides: &mut PatchSides,
        (faces, degenerate): (u32, u64),
        branches: &Spill,
        listed: usize,
    ) -> Result<Self, ExternalError> {
        let mut roots = Vec::new();
        each_branch(branches, |uses| roots.extend(uses.iter().map(|&word| sides.find(word >> 1).0)))?;
        roots.sort_unstable();
        roots.dedup();
        roots.shrink_to_fit();
        let ends = |sides: &PatchSides, root| PatchEnds {
            has_boundary: sides.is_open(root),
            is_orientable: !sides.is_twisted(root),
        };
        // A face that is no part of the complex is joined to none, and looks like a closed patch.
        let (mut count, mut free, mut twisted) = (0, [0, 0], Lowest::new(listed));
        let mut known = roots.iter().peekable();
        for root in (0..faces).filter(|&face| sides.is_root(face)) {
            count += 1;
            let patch = ends(sides, root);
            if !patch.is_orientable {
                twisted.add(root);
            }
            if known.next_if_eq(&&root).is_none() && !patch.has_boundary {
                free[0] += 1;
                free[1] += u64::from(patch.is_orientable);
            }
        }
        let patches = roots.iter().map(|&root| ends(sides, root)).collect();
        let (mut uses, mut use_ends) = (Vec::new(), Vec::new());
        each_branch(branches, |words| {
            uses.extend(words.iter().map(|&word| {
                let (root, turned) = sides.find(word >> 1);
                let place = roots.partition_point(|&known| known < root);
                PatchUse { patch: PatchId(place as u32), is_forward: (word & 1 == 1) != turned }
            }));
            use_ends.push(uses.len());
        })?;
        let free = free.map(|count: u64| count - degenerate);
        Ok(Patches {
            count: count - degenerate,
            twisted: twisted.count(),
            first_twisted: twisted.into_kept(),
            system: System { patches, uses, ends: use_ends, free },
        })
    }

    /// The Betti numbers of a complex with these numbers of vertices, edges and faces, and of components.
    pub(crate) fn betti(&self, elements: [u64; 3], components: u64) -> Betti {
        betti_of(elements, components, &self.system, ELIMINATION_BUDGET)
    }
}

impl TwoCycles for System {
    fn patches(&self) -> impl Iterator<Item = PatchEnds> {
        self.patches.iter().copied()
    }

    fn free(&self) -> [u64; 2] {
        self.free
    }

    fn each_branch(&self, mut visit: impl FnMut(&[PatchUse])) {
        let mut first = 0;
        for &end in &self.ends {
            visit(&self.uses[first..end]);
            first = end;
        }
    }
}

/// Hands over the uses of each edge of degree 3 or more.
fn each_branch(branches: &Spill, mut take: impl FnMut(&[u32])) -> Result<(), ExternalError> {
    let mut begun: Vec<u32> = Vec::new();
    branches.read(0, |numbers| {
        begun.extend_from_slice(numbers);
        let mut at = 0;
        while let Some(&degree) = begun.get(at)
            && let Some(uses) = begun.get(at + 1..at + 1 + degree as usize)
        {
            take(uses);
            at += 1 + uses.len();
        }
        begun.drain(..at);
        Ok(())
    })
}

/// The faces of some patches, by their lowest faces, which ascend.
pub(crate) fn faces_of(sides: &mut PatchSides, faces: u32, lowest: &[u32]) -> FixedBitSet {
    let mut found = FixedBitSet::with_capacity(faces as usize);
    if !lowest.is_empty() {
        for face in 0..faces {
            if lowest.binary_search(&sides.find(face).0).is_ok() {
                found.insert(face as usize);
            }
        }
    }
    found
}
