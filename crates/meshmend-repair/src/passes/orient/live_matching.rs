//! The matching of sides while duplicate faces go: only edges that lost a side are looked at again.

use meshmend_core::{Column, Connectivity, CornerId, EdgeId, FaceId};

use super::fates::Fates;
use super::subject::Subject;
use crate::copies::Copies;
use crate::matching::{Matching, StoredGroups, StoredUse, may_match, pairs_by_rank};
use crate::stored_vertices::StoredVertices;

/// A pair of matched sides.
pub(super) type Pair = (CornerId, CornerId);

/// The pairs of rule 1 among all faces.
pub(super) fn pairs_as_stored<K: Connectivity>(subject: &Subject<'_, K>) -> Vec<Pair> {
    let Subject { kernel, stored, .. } = subject;
    let copies = subject.repeats.copies();
    let mut groups = StoredGroups::default();
    let mut pairs = Vec::new();
    for edge in kernel.edges() {
        for group in groups.uses_of(*kernel, stored, edge).chunk_by(|one, other| one.stored == other.stored) {
            match group {
                [one, other] if may_match(*kernel, copies, one.corner, other.corner) => {
                    pairs.push((one.corner, other.corner));
                }
                [_, _, _, ..] => {
                    let mut by_rank =
                        copies.map_or(Vec::new(), |copies| pairs_by_rank(*kernel, copies, group));
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

/// The group of a side along an edge with at most two. Such sides are matched at once, so no face that goes as a
/// duplicate can leave two of them.
const NO_GROUP: u32 = u32::MAX;

/// The sides that run along one edge as stored, where the welded edge has three sides or more.
struct Group {
    /// Where they begin in the list of all groups' sides; they end where those of the next group begin.
    first: u32,
    /// How many of them are sides of faces that stay.
    staying: u32,
}

/// What has become unambiguous and was not looked at yet.
#[derive(Default)]
struct Waiting {
    /// Pairs that rule 1 matches without a look.
    pairs: Vec<Pair>,
    /// Groups of two sides, for rule 1.
    groups: Vec<u32>,
    /// Edges of two sides, for rule 2.
    edges: Vec<EdgeId>,
    /// Edges at which there are copies.
    edges_with_copies: Vec<EdgeId>,
}

/// The matching by rules 1 and 2 of the faces that stay.
///
/// Matched pairs stay matched while duplicates go: sides only become fewer, and a patch goes as a whole.
pub(super) struct LiveMatching<'a, K> {
    kernel: &'a K,
    stored: &'a StoredVertices<'a>,
    copies: Option<&'a Copies>,
    matching: Matching,
    /// For each edge how many of its sides are left.
    staying: Column<EdgeId, u32>,
    group_of: Column<CornerId, u32>,
    groups: Vec<Group>,
    sides_of_groups: Vec<CornerId>,
    /// The edges at which there are copies, ascending.
    edges_with_copies: Vec<EdgeId>,
    waiting: Waiting,
}

impl<'a, K: Connectivity> LiveMatching<'a, K> {
    /// Nothing is matched yet.
    ///
    /// *Cost*: O(Σ d log d) over the degrees d of the edges; 8 bytes a corner and 4 an edge, and 16 for each side along
    /// an edge of three and more.
    pub(super) fn new(subject: &'a Subject<'a, K>, fates: &Fates) -> Self {
        let Subject { kernel, stored, repeats, .. } = subject;
        let (kernel, copies) = (*kernel, repeats.copies());
        let edges_with_copies = copies.map_or(Vec::new(), |copies| edges_of(kernel, copies.faces()));
        let mut live = LiveMatching {
            kernel,
            stored,
            copies,
            matching: Matching::free(kernel.corner_count()),
            staying: Column::filled(0, kernel.edge_count()),
            group_of: Column::filled(NO_GROUP, kernel.corner_count()),
            groups: Vec::new(),
            sides_of_groups: Vec::new(),
            waiting: Waiting { edges_with_copies: edges_with_copies.clone(), ..Waiting::default() },
            edges_with_copies,
        };
        let mut groups = StoredGroups::default();
        for edge in kernel.edges() {
            live.add_edge(edge, groups.uses_of(kernel, stored, edge), fates);
        }
        live
    }

    fn add_edge(&mut self, edge: EdgeId, uses: &[StoredUse], fates: &Fates) {
        let stays = |u: &&StoredUse| fates.stays(self.kernel.corner_face(u.corner));
        let staying = uses.iter().filter(stays).count() as u32;
        self.staying[edge] = staying;
        if staying == 2 {
            match uses {
                [one, other] if one.stored == other.stored && self.may_match(one.corner, other.corner) => {
                    self.waiting.pairs.push((one.corner, other.corner));
                }
                _ => self.waiting.edges.push(edge),
            }
        }
        if uses.len() > 2 {
            uses.chunk_by(|one, other| one.stored == other.stored)
                .for_each(|group| self.add_group(group, fates));
        }
    }

    fn add_group(&mut self, uses: &[StoredUse], fates: &Fates) {
        let (id, first) = (self.groups.len() as u32, self.sides_of_groups.len() as u32);
        for u in uses {
            self.group_of[u.corner] = id;
            self.sides_of_groups.push(u.corner);
        }
        let stays = |u: &&StoredUse| fates.stays(self.kernel.corner_face(u.corner));
        let staying = uses.iter().filter(stays).count() as u32;
        self.groups.push(Group { first, staying });
        if staying == 2 {
            self.waiting.groups.push(id);
        }
    }

    /// A face is gone: its sides no longer count.
    pub(super) fn remove_face(&mut self, face: FaceId) {
        for corner in self.kernel.face_corners(face) {
            let edge = self.kernel.corner_edge(corner);
            self.staying[edge] -= 1;
            if self.staying[edge] == 2 {
                self.waiting.edges.push(edge);
            }
            if self.edges_with_copies.binary_search(&edge).is_ok() {
                self.waiting.edges_with_copies.push(edge);
            }
            let id = self.group_of[corner];
            if let Some(group) = self.groups.get_mut(id as usize) {
                group.staying -= 1;
                if group.staying == 2 {
                    self.waiting.groups.push(id);
                }
            }
        }
    }

    /// Matches what has become unambiguous since the last call, by rule 1, then by rule 2, each by edge; then among the
    /// sides of one rank.
    ///
    /// A seam that was cut before is stitched by rule 2, so what contradicts is found there again.
    pub(super) fn new_pairs(&mut self, fates: &Fates) -> Vec<Pair> {
        let waiting = std::mem::take(&mut self.waiting);
        let mut pairs = waiting.pairs;
        pairs.extend(waiting.groups.into_iter().filter_map(|group| self.pair_of_group(group, fates)));
        pairs.sort_unstable_by_key(|&(one, _)| (self.kernel.corner_edge(one), one));
        pairs.iter().for_each(|&(one, other)| self.matching.pair(one, other));
        let mut edges = waiting.edges;
        edges.sort_unstable();
        for edge in edges {
            let both = self.the_two(self.kernel.edge_corners(edge), fates);
            pairs.extend(both.filter(|&pair| self.matching.pair_if_free(pair)));
        }
        if let Some(copies) = self.copies {
            self.match_ranks(copies, waiting.edges_with_copies, fates, &mut pairs);
        }
        pairs
    }

    fn pair_of_group(&self, group: u32, fates: &Fates) -> Option<Pair> {
        let first = self.groups[group as usize].first as usize;
        let next = self.groups.get(group as usize + 1);
        let end = next.map_or(self.sides_of_groups.len(), |next| next.first as usize);
        let sides = &self.sides_of_groups[first..end];
        // Sides of one rank may be matched already.
        let is_free = |corner| self.copies.is_none() || self.matching.is_free(corner);
        self.the_two(sides.iter().copied(), fates).filter(|&(one, _)| is_free(one))
    }

    /// Matches what has become unambiguous among the sides of one rank.
    fn match_ranks(&mut self, copies: &Copies, mut edges: Vec<EdgeId>, fates: &Fates, pairs: &mut Vec<Pair>) {
        edges.sort_unstable();
        edges.dedup();
        let mut groups = StoredGroups::default();
        for edge in edges {
            let mut uses = groups.uses_of(self.kernel, self.stored, edge).to_vec();
            uses.retain(|u| fates.stays(self.kernel.corner_face(u.corner)));
            let by_rank = pairs_by_rank(self.kernel, copies, &uses);
            pairs.extend(by_rank.into_iter().filter(|&pair| self.matching.pair_if_free(pair)));
        }
    }

    /// The sides of faces that stay, if they are exactly two and may be matched.
    fn the_two(&self, sides: impl Iterator<Item = CornerId>, fates: &Fates) -> Option<Pair> {
        let mut staying = sides.filter(|&corner| fates.stays(self.kernel.corner_face(corner)));
        match (staying.next(), staying.next(), staying.next()) {
            (Some(one), Some(other), None) if self.may_match(one, other) => Some((one, other)),
            _ => None,
        }
    }

    fn may_match(&self, one: CornerId, other: CornerId) -> bool {
        may_match(self.kernel, self.copies, one, other)
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

#[cfg(test)]
mod tests {
    use meshmend_testkit::Soup;

    use crate::Pipeline;

    /// Three fans at one place, of which two are found to be duplicates only once they are oriented: at their rims three
    /// uses become one at once, so no pair is left.
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
