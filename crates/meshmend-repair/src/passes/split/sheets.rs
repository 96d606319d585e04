//! Pairs what is free at an edge of degree three or more into sheets, by the radial order of all its uses.
//!
//! With outward right-hand normals solid lies between a backward use and the next forward one; a closed orientable
//! patch of negative volume is read the other way. In turn these are matched:
//!
//! * (a) neighbours in the full order, both free, of one patch, with solid between them;
//! * (b) free uses of one patch, opposite direction and different angle, as brackets are matched;
//! * (c) as a, of any patches;
//! * (d) as b, of any patches and angles.
//!
//! The rest becomes boundary. So touching solids come apart, a sheet stays whole, double walls keep two sides, and
//! nothing is crossed.

use std::collections::VecDeque;

use meshmend_core::{Column, Connectivity, EdgeId, FaceId, Joined, PolygonMesh, SidedClasses};
use rayon::prelude::*;
use smallvec::SmallVec;

use super::radial::{RadialUse, radial_order};
use crate::copies::Copies;
use crate::matching::{Matching, may_match, run_the_same_way};
use crate::{Context, PassError};
use meshmend_geometry::SignedVolume;

/// Edges between two looks.
const BETWEEN_LOOKS: usize = 4096;

/// Completes a matching at the edges where two or more uses are free.
///
/// # Errors
/// When whoever watches the pass stops it.
///
/// *Cost*: O(n + Σ d log d) over the degrees d of those edges.
pub(super) fn match_sheets<K: Connectivity>(
    kernel: &K,
    mesh: &PolygonMesh,
    copies: Option<&Copies>,
    matching: &mut Matching,
    context: &Context<'_>,
) -> Result<(), PassError> {
    let wanting = |&edge: &EdgeId| {
        kernel.edge_corners(edge).take(3).count() == 3
            && kernel.edge_corners(edge).filter(|&c| matching.is_free(c)).take(2).count() == 2
    };
    let edges: Vec<EdgeId> = kernel.edges().filter(wanting).collect();
    if edges.is_empty() {
        return Ok(());
    }
    context.check_cancelled()?;
    let patches = PatchSides::of(kernel, mesh, matching);
    let pair_up = |(place, &edge): (usize, &EdgeId)| {
        if place.is_multiple_of(BETWEEN_LOOKS) {
            context.look(place, edges.len())?;
        }
        let order = radial_order(kernel, mesh, edge);
        let mut round =
            Round { kernel, copies, patches: &patches, is_free: Vec::new(), pairs: Vec::new(), order };
        round.is_free = round.order.iter().map(|u| matching.is_free(u.corner)).collect();
        round.match_all();
        Ok(round.corner_pairs())
    };
    let pairs = edges.par_iter().enumerate().map(pair_up).collect::<Result<Vec<Vec<_>>, PassError>>()?;
    context.check_cancelled()?;
    pairs.into_iter().flatten().for_each(|(one, other)| matching.pair(one, other));
    Ok(())
}

/// The patch of each face by number, and which patches are read inside out.
pub(super) struct PatchSides {
    patch: Column<FaceId, u32>,
    is_inside_out: Vec<bool>,
    is_twisted: Vec<bool>,
}

impl PatchSides {
    pub(super) fn of<K: Connectivity>(kernel: &K, mesh: &PolygonMesh, matching: &Matching) -> Self {
        let mut sides = Self::patches(kernel, matching);
        let mut is_open = sides.is_twisted.clone();
        for edge in kernel.edges() {
            sides.each_unbalanced_patch(kernel, edge, |patch| is_open[patch as usize] = true);
        }
        let mut volumes: Vec<Option<SignedVolume>> =
            is_open.into_iter().map(|is_open| (!is_open).then(SignedVolume::default)).collect();
        for face in kernel.faces() {
            if let Some(volume) = &mut volumes[sides.patch[face] as usize] {
                volume.add_face(mesh, kernel.face_corners(face), false);
            }
        }
        let is_negative = |volume: &SignedVolume| volume.sign() < 0;
        sides.is_inside_out = volumes.iter().map(|volume| volume.as_ref().is_some_and(is_negative)).collect();
        sides
    }

    /// Calls `tell` with each patch that uses an edge more often one way than the other.
    #[inline]
    fn each_unbalanced_patch<K: Connectivity>(&self, kernel: &K, edge: EdgeId, mut tell: impl FnMut(u32)) {
        let way = |is_forward| if is_forward { 1 } else { -1 };
        let uses = kernel
            .edge_sides(edge)
            .map(|(corner, is_forward)| (self.patch[kernel.corner_face(corner)], way(is_forward)));
        let mut first = uses.clone();
        if let (Some((one, there)), Some((other, back)), None) = (first.next(), first.next(), first.next())
            && one == other
            && there == -back
        {
            return;
        }
        let mut balance: SmallVec<[(u32, i32); 4]> = uses.collect();
        balance.sort_unstable();
        for patch in balance.chunk_by(|one, other| one.0 == other.0) {
            if patch.iter().map(|(_, way)| way).sum::<i32>() != 0 {
                tell(patch[0].0);
            }
        }
    }

    /// The patches, and which of them have no consistent orientation. None is read inside out yet.
    pub(super) fn patches<K: Connectivity>(kernel: &K, matching: &Matching) -> Self {
        const NONE: u32 = u32::MAX;
        let mut sets = SidedClasses::new(kernel.face_count());
        let mut contradicted = Vec::new();
        for (one, other) in matching.pairs() {
            let (f, g) = (kernel.corner_face(one), kernel.corner_face(other));
            if let Joined::Contradicts { root } = sets.join(f, g, run_the_same_way(kernel, one, other)) {
                contradicted.push(root);
            }
        }
        let mut number_of_root: Column<FaceId, u32> = Column::filled(NONE, kernel.face_count());
        let mut count = 0;
        let patch: Column<FaceId, u32> = kernel
            .faces()
            .map(|face| {
                let number = &mut number_of_root[sets.find(face).0];
                if *number == NONE {
                    *number = count;
                    count += 1;
                }
                *number
            })
            .collect();
        let mut is_twisted = vec![false; count as usize];
        contradicted.into_iter().for_each(|face| is_twisted[patch[face] as usize] = true);
        PatchSides { is_inside_out: vec![false; count as usize], patch, is_twisted }
    }

    /// Whether the patch of a face has no consistent orientation.
    pub(super) fn is_twisted(&self, face: FaceId) -> bool {
        self.is_twisted[self.patch[face] as usize]
    }
}

/// The pairing round one edge; uses go by their place in the order.
struct Round<'a, K> {
    kernel: &'a K,
    copies: Option<&'a Copies>,
    patches: &'a PatchSides,
    order: Vec<RadialUse>,
    is_free: Vec<bool>,
    pairs: Vec<(usize, usize)>,
}

impl<K: Connectivity> Round<'_, K> {
    fn match_all(&mut self) {
        self.pair_neighbours(|round, a, b| round.same_patch(a, b) && round.is_solid_between(a, b));
        self.pair_like_brackets(|round, a, b| {
            round.same_patch(a, b) && round.is_opposite(a, b) && round.is_apart(a, b)
        });
        self.pair_neighbours(Self::is_solid_between);
        self.pair_like_brackets(Self::is_opposite);
    }

    fn corner_pairs(&self) -> Vec<(meshmend_core::CornerId, meshmend_core::CornerId)> {
        self.pairs.iter().map(|&(a, b)| (self.order[a].corner, self.order[b].corner)).collect()
    }

    fn patch(&self, place: usize) -> u32 {
        self.patches.patch[self.kernel.corner_face(self.order[place].corner)]
    }

    fn same_patch(&self, a: usize, b: usize) -> bool {
        self.patch(a) == self.patch(b)
    }

    /// Whether two uses run against each other and may be matched. Copies that differ run the same way, unless they come
    /// back to the edge.
    fn is_opposite(&self, a: usize, b: usize) -> bool {
        let (one, other) = (&self.order[a], &self.order[b]);
        one.is_forward != other.is_forward && may_match(self.kernel, self.copies, one.corner, other.corner)
    }

    fn is_apart(&self, a: usize, b: usize) -> bool {
        self.order[a].angle.is_none() || self.order[a].angle != self.order[b].angle
    }

    fn is_outward_forward(&self, a: usize) -> bool {
        self.order[a].is_forward != self.patches.is_inside_out[self.patch(a) as usize]
    }

    fn is_solid_between(&self, a: usize, b: usize) -> bool {
        self.is_opposite(a, b) && !self.is_outward_forward(a) && self.is_outward_forward(b)
    }

    fn pair(&mut self, a: usize, b: usize) {
        (self.is_free[a], self.is_free[b]) = (false, false);
        self.pairs.push((a, b));
    }

    /// Neighbours in the full circular order, once round.
    fn pair_neighbours(&mut self, wanted: impl Fn(&Self, usize, usize) -> bool) {
        let count = self.order.len();
        for a in 0..count {
            let b = (a + 1) % count;
            if self.is_free[a] && self.is_free[b] && wanted(self, a, b) {
                self.pair(a, b);
            }
        }
    }

    /// Neighbours among the free uses, as brackets are matched; then the two ends of what is left.
    fn pair_like_brackets(&mut self, wanted: impl Fn(&Self, usize, usize) -> bool) {
        let mut stack: VecDeque<usize> = VecDeque::new();
        for place in 0..self.order.len() {
            if !self.is_free[place] {
                continue;
            }
            match stack.back() {
                Some(&top) if wanted(self, top, place) => {
                    stack.pop_back();
                    self.pair(top, place);
                }
                _ => stack.push_back(place),
            }
        }
        while let (Some(&first), Some(&last)) = (stack.front(), stack.back()) {
            // A single use that is left is both ends, and runs the same way as itself.
            if !wanted(self, last, first) {
                break;
            }
            stack.pop_back();
            stack.pop_front();
            self.pair(last, first);
        }
    }
}
