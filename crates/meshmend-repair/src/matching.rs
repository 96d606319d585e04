//! Which side is joined to which, where that is beyond doubt.
//!
//! Two rules, each about one edge of the mesh alone, so that edges can be asked in any order:
//!
//! 1. two uses that are the only two of their edge by vertices *as stored* are matched;
//! 2. two uses that are the only two of their edge by the present (welded) vertices are matched, if both are free.
//!
//! Two uses of faces that run round the same vertices in the same direction and differ are never matched. If such faces
//! have neighbours, [`Copies`] says what is matched.
//!
//! Faces joined across matched uses make a *patch* of the repair.

use meshmend_core::{Column, Connectivity, CornerId, EdgeId, VertexId};

use crate::copies::Copies;
use crate::stored_vertices::StoredVertices;

const FREE: CornerId = CornerId(u32::MAX);

/// Each side's partner.
#[derive(Clone, Debug)]
pub(crate) struct Matching {
    mate: Column<CornerId, CornerId>,
}

impl Matching {
    pub(crate) fn free(corner_count: usize) -> Self {
        Matching { mate: Column::filled(FREE, corner_count) }
    }

    /// The matching of all edges by rules 1 and 2.
    ///
    /// *Cost*: O(Σ d log d) over the edges' degrees d.
    pub(crate) fn by_rules<K: Connectivity>(
        kernel: &K,
        stored: &StoredVertices<'_>,
        copies: Option<&Copies>,
    ) -> Self {
        let mut matching = Matching::free(kernel.corner_count());
        let mut groups = StoredGroups::default();
        for edge in kernel.edges() {
            let mut corners = kernel.edge_corners(edge);
            match (corners.next(), corners.next(), corners.next()) {
                // Two uses are a pair by one rule or the other.
                (Some(one), Some(other), None) if may_match(kernel, copies, one, other) => {
                    matching.pair(one, other);
                }
                (_, _, None) => {}
                _ => {
                    let uses = groups.uses_of(kernel, stored, edge);
                    for group in uses.chunk_by(|one, other| one.stored == other.stored) {
                        if let [one, other] = group
                            && may_match(kernel, copies, one.corner, other.corner)
                        {
                            matching.pair(one.corner, other.corner);
                        }
                    }
                }
            }
        }
        matching
    }

    /// Adds the pairs of [`pairs_by_rank`] at each edge of three sides or more, if both sides are free.
    ///
    /// *Cost*: O(Σ d log d) over the degrees d of those edges.
    pub(crate) fn pair_by_rank<K: Connectivity>(
        &mut self,
        kernel: &K,
        stored: &StoredVertices<'_>,
        copies: &Copies,
    ) {
        let mut groups = StoredGroups::default();
        for edge in kernel.edges().filter(|&edge| kernel.edge_degree(edge) > 2) {
            for pair in pairs_by_rank(kernel, copies, groups.uses_of(kernel, stored, edge)) {
                self.pair_if_free(pair);
            }
        }
    }

    #[inline]
    pub(crate) fn mate(&self, corner: CornerId) -> Option<CornerId> {
        let mate = self.mate[corner];
        (mate != FREE).then_some(mate)
    }

    #[inline]
    pub(crate) fn is_free(&self, corner: CornerId) -> bool {
        self.mate[corner] == FREE
    }

    pub(crate) fn pair(&mut self, one: CornerId, other: CornerId) {
        self.mate[one] = other;
        self.mate[other] = one;
    }

    /// Pairs two sides if both are free, and says whether they were.
    pub(crate) fn pair_if_free(&mut self, (one, other): (CornerId, CornerId)) -> bool {
        let are_free = self.is_free(one) && self.is_free(other);
        if are_free {
            self.pair(one, other);
        }
        are_free
    }

    pub(crate) fn part(&mut self, one: CornerId, other: CornerId) {
        self.mate[one] = FREE;
        self.mate[other] = FREE;
    }

    /// Each matched pair once, by its lower corner.
    pub(crate) fn pairs(&self) -> impl Iterator<Item = (CornerId, CornerId)> + '_ {
        self.mate
            .iter()
            .filter(|&(one, &other)| other != FREE && one < other)
            .map(|(one, &other)| (one, other))
    }
}

/// Whether two sides may be matched. They may not if their faces are copies that differ.
pub(crate) fn may_match<K: Connectivity>(
    kernel: &K,
    copies: Option<&Copies>,
    one: CornerId,
    other: CornerId,
) -> bool {
    copies.is_none_or(|copies| !copies.are_apart(kernel.corner_face(one), kernel.corner_face(other)))
}

/// The pairs of an edge at which there are copies: two uses that are the only two of their rank at their edge as stored,
/// then two that are the only two of their rank at the whole edge. The uses are given sorted by what they join as stored.
///
/// Only uses that run against each other are paired. Else turning a face could change the ranks of others without end.
pub(crate) fn pairs_by_rank<K: Connectivity>(
    kernel: &K,
    copies: &Copies,
    uses: &[StoredUse],
) -> Vec<(CornerId, CornerId)> {
    let rank = |u: &StoredUse| copies.rank(kernel.corner_face(u.corner));
    let mut pairs = Vec::new();
    if uses.iter().all(|u| rank(u) == 0) {
        return pairs;
    }
    let mut ranked: Vec<StoredUse> = uses.to_vec();
    ranked.sort_by_key(|u| (rank(u), u.stored));
    for group in ranked.chunk_by(|one, other| (rank(one), one.stored) == (rank(other), other.stored)) {
        pairs.extend(the_two(group));
    }
    for group in ranked.chunk_by(|one, other| rank(one) == rank(other)) {
        pairs.extend(the_two(group));
    }
    pairs.retain(|&(one, other)| !run_the_same_way(kernel, one, other));
    pairs
}

/// The corners of uses, if they are exactly two.
fn the_two(uses: &[StoredUse]) -> Option<(CornerId, CornerId)> {
    if let [one, other] = uses { Some((one.corner, other.corner)) } else { None }
}

/// A use of an edge with the pair of vertices that it joins as stored.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct StoredUse {
    pub(crate) stored: [VertexId; 2],
    pub(crate) corner: CornerId,
}

/// The uses of one edge, sorted by what they join as stored; keeps its memory from edge to edge.
#[derive(Default)]
pub(crate) struct StoredGroups {
    uses: Vec<StoredUse>,
}

impl StoredGroups {
    pub(crate) fn uses_of<K: Connectivity>(
        &mut self,
        kernel: &K,
        stored: &StoredVertices<'_>,
        edge: EdgeId,
    ) -> &[StoredUse] {
        self.uses.clear();
        self.uses.extend(kernel.edge_corners(edge).map(|corner| {
            let (from, to) = (stored.of(corner), stored.of(kernel.next_corner(corner)));
            StoredUse { stored: [from.min(to), from.max(to)], corner }
        }));
        if self.uses.len() > 2 {
            self.uses.sort_unstable();
        }
        &self.uses
    }
}

/// Whether two sides along the same edge run the same way.
pub(crate) fn run_the_same_way<K: Connectivity>(kernel: &K, one: CornerId, other: CornerId) -> bool {
    kernel.corner_vertex(one) == kernel.corner_vertex(other)
}
