//! The matching of sides while duplicate faces go: only edges that lost a use are looked at again.

use meshmend_core::{Column, Connectivity, CornerId, EdgeId, FaceId};

use crate::copies::Copies;
use crate::matching::{Matching, StoredGroups, may_match, pairs_by_rank};
use crate::stored_vertices::StoredVertices;

/// The group of all uses along edges with at most two. These are matched at once, so that no face which goes for its
/// double in another patch has one of them; they are too many ever to be two.
const NO_GROUP: u32 = 0;

/// A pair of matched sides.
pub(crate) type Pair = (CornerId, CornerId);

/// The pairs of rule 1 among the faces that are alive.
pub(crate) fn pairs_as_stored<K: Connectivity>(
    kernel: &K,
    names: &StoredVertices<'_>,
    copies: Option<&Copies>,
) -> Vec<Pair> {
    let mut groups = StoredGroups::default();
    let mut pairs = Vec::new();
    for edge in kernel.edges() {
        for group in groups.uses_of(kernel, names, edge).chunk_by(|one, other| one.stored == other.stored) {
            match group {
                [one, other] if may_match(kernel, copies, one.corner, other.corner) => {
                    pairs.push((one.corner, other.corner));
                }
                [_, _, _, ..] => {
                    let mut by_rank =
                        copies.map_or(Vec::new(), |copies| pairs_by_rank(kernel, copies, group));
                    by_rank.sort_unstable();
                    by_rank.dedup();
                    pairs.extend(by_rank);
                }
                _ => {}
            }
        }
    }
    pairs
}

/// The alive uses of every edge, by what they join as stored, and their matching by rules 1 and 2.
///
/// Matched pairs stay matched while duplicates go: uses only become fewer, and a patch goes as a whole.
pub(crate) struct LiveUses<'a> {
    copies: Option<&'a Copies>,
    edge_alive: Column<EdgeId, u32>,
    /// Only edges of degree three or more have groups.
    group_of: Column<CornerId, u32>,
    group_starts: Vec<u32>,
    group_uses: Vec<CornerId>,
    group_alive: Vec<u32>,
    matching: Matching,
    /// Edges with two alive uses in all, and pairs alone as stored, that were not looked at yet.
    edges_with_two: Vec<EdgeId>,
    groups_with_two: Vec<u32>,
    pairs_as_stored: Vec<Pair>,
    /// The edges at which there are copies, ascending, and those of them that are to be looked at.
    edges_with_copies: Vec<EdgeId>,
    changed_edges_with_copies: Vec<EdgeId>,
}

impl<'a> LiveUses<'a> {
    pub(crate) fn new<K: Connectivity>(
        kernel: &K,
        names: &StoredVertices<'_>,
        copies: Option<&'a Copies>,
        is_alive: &Column<FaceId, bool>,
    ) -> Self {
        let edges_with_copies = copies.map_or(Vec::new(), |copies| edges_of(kernel, copies.faces()));
        let mut live = LiveUses {
            copies,
            changed_edges_with_copies: edges_with_copies.clone(),
            edges_with_copies,
            edge_alive: Column::filled(0, kernel.edge_count()),
            group_of: Column::filled(NO_GROUP, kernel.corner_count()),
            group_starts: vec![0, 0],
            group_uses: Vec::new(),
            group_alive: vec![u32::MAX],
            matching: Matching::free(kernel.corner_count()),
            edges_with_two: Vec::new(),
            groups_with_two: Vec::new(),
            pairs_as_stored: Vec::new(),
        };
        let mut groups = StoredGroups::default();
        for edge in kernel.edges() {
            let uses = groups.uses_of(kernel, names, edge);
            let alive = |corner: CornerId| is_alive[kernel.corner_face(corner)];
            live.edge_alive[edge] = uses.iter().filter(|u| alive(u.corner)).count() as u32;
            match uses {
                [one, other]
                    if live.edge_alive[edge] == 2
                        && one.stored == other.stored
                        && may_match(kernel, copies, one.corner, other.corner) =>
                {
                    live.pairs_as_stored.push((one.corner, other.corner));
                }
                _ if live.edge_alive[edge] == 2 => live.edges_with_two.push(edge),
                _ => {}
            }
            if uses.len() < 3 {
                continue;
            }
            for group in uses.chunk_by(|one, other| one.stored == other.stored) {
                let (id, count) =
                    (live.group_alive.len() as u32, group.iter().filter(|u| alive(u.corner)).count());
                group.iter().for_each(|u| live.group_of[u.corner] = id);
                live.group_uses.extend(group.iter().map(|u| u.corner));
                live.group_starts.push(live.group_uses.len() as u32);
                live.group_alive.push(count as u32);
                if count == 2 {
                    live.groups_with_two.push(id);
                }
            }
        }
        live
    }

    /// A face is gone: its uses no longer count.
    pub(crate) fn remove_face<K: Connectivity>(&mut self, kernel: &K, face: FaceId) {
        for corner in kernel.face_corners(face) {
            let edge = kernel.corner_edge(corner);
            self.edge_alive[edge] -= 1;
            if self.edge_alive[edge] == 2 {
                self.edges_with_two.push(edge);
            }
            if self.edges_with_copies.binary_search(&edge).is_ok() {
                self.changed_edges_with_copies.push(edge);
            }
            let group = self.group_of[corner];
            self.group_alive[group as usize] -= 1;
            if self.group_alive[group as usize] == 2 {
                self.groups_with_two.push(group);
            }
        }
    }

    /// Matches what has become unambiguous since the last call: by rule 1, then by rule 2, each by edge. A seam that
    /// was cut before is stitched by rule 2, so what contradicts is found there again.
    pub(crate) fn new_pairs<K: Connectivity>(
        &mut self,
        kernel: &K,
        names: &StoredVertices<'_>,
        is_alive: &Column<FaceId, bool>,
    ) -> Vec<Pair> {
        let mut pairs = std::mem::take(&mut self.pairs_as_stored);
        let copies = self.copies;
        let alive = |corner: &CornerId| is_alive[kernel.corner_face(*corner)];
        for group in std::mem::take(&mut self.groups_with_two).into_iter().map(|g| g as usize) {
            let range = self.group_starts[group] as usize..self.group_starts[group + 1] as usize;
            let both = the_two(self.group_uses[range].iter().copied().filter(alive));
            // Those of one rank may be matched already.
            pairs.extend(both.filter(|&(a, b)| {
                copies.is_none() || (self.matching.is_free(a) && may_match(kernel, copies, a, b))
            }));
        }
        pairs.sort_unstable_by_key(|&(one, _)| (kernel.corner_edge(one), one));
        pairs.iter().for_each(|&(one, other)| self.matching.pair(one, other));
        let mut edges = std::mem::take(&mut self.edges_with_two);
        edges.sort_unstable();
        for edge in edges {
            let both = the_two(kernel.edge_corners(edge).filter(alive));
            let both = both.filter(|&(a, b)| may_match(kernel, copies, a, b));
            pairs.extend(both.filter(|&pair| self.matching.pair_if_free(pair)));
        }
        if let Some(copies) = copies {
            self.match_ranks(kernel, names, copies, is_alive, &mut pairs);
        }
        pairs
    }

    /// Matches what has become unambiguous among the uses of one rank.
    fn match_ranks<K: Connectivity>(
        &mut self,
        kernel: &K,
        names: &StoredVertices<'_>,
        copies: &Copies,
        is_alive: &Column<FaceId, bool>,
        pairs: &mut Vec<Pair>,
    ) {
        let mut edges = std::mem::take(&mut self.changed_edges_with_copies);
        edges.sort_unstable();
        edges.dedup();
        let mut groups = StoredGroups::default();
        for edge in edges {
            let mut uses = groups.uses_of(kernel, names, edge).to_vec();
            uses.retain(|u| is_alive[kernel.corner_face(u.corner)]);
            let by_rank = pairs_by_rank(kernel, copies, &uses);
            pairs.extend(by_rank.into_iter().filter(|&pair| self.matching.pair_if_free(pair)));
        }
    }
}

/// The edges of some faces, ascending.
fn edges_of<K: Connectivity>(kernel: &K, faces: impl Iterator<Item = FaceId>) -> Vec<EdgeId> {
    let corners = faces.flat_map(|face| kernel.face_corners(face));
    let mut edges: Vec<EdgeId> = corners.map(|corner| kernel.corner_edge(corner)).collect();
    edges.sort_unstable();
    edges.dedup();
    edges
}

/// The two items of an iterator that gives exactly two.
fn the_two(mut items: impl Iterator<Item = CornerId>) -> Option<Pair> {
    match (items.next(), items.next(), items.next()) {
        (Some(one), Some(other), None) => Some((one, other)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use meshmend_testkit::Soup;

    use crate::Pipeline;

    /// Three fans at one place, of which two are found to be doubles only once they are oriented: at their rims three
    /// uses become one at a stroke, which is no pair.
    #[test]
    fn uses_that_go_together_leave_no_pair() {
        let rim = [[3, 0], [3, 1], [2, 2], [1, 3], [0, 3], [-1, 3]];
        let points = std::iter::once([0, 0]).chain(rim).map(|[x, y]| [f64::from(x), f64::from(y), 0.0]);
        // No fan has all its faces in the others before they are oriented.
        let fan = |first: u32, flipped: &[u32]| {
            let face = |i: u32| if flipped.contains(&i) { [0, i + 1, i] } else { [0, i, i + 1] };
            (1..=5).map(|i| face(i).map(|v| first + v).to_vec()).collect::<Vec<_>>()
        };
        let positions: Vec<[f64; 3]> = points.collect();
        let soup = Soup {
            positions: positions.repeat(3),
            faces: [fan(0, &[]), fan(7, &[2, 3]), fan(14, &[2, 4])].concat(),
        };
        let repaired = Pipeline::default().run(&soup.mesh()).unwrap();
        assert_eq!(repaired.mesh.faces(), &Soup::generic(7, fan(0, &[])).table());
        let removed: Vec<u32> = repaired.removed_faces.iter().map(|removed| removed.face.0).collect();
        assert_eq!(removed, (5..15).collect::<Vec<_>>());
    }
}
