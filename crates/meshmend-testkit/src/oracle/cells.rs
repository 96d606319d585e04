//! Section 1: normalised faces, edges with their uses, duplicates.

use std::collections::{BTreeMap, BTreeSet};

use crate::Soup;
use crate::damage::Way;

/// One use of an edge by a face.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Use {
    /// The face.
    pub(super) face: usize,
    /// The place of its corner.
    pub(super) place: usize,
    /// Whether it runs from the smaller to the larger vertex.
    pub(super) forward: bool,
}

/// The complex as plain lists.
pub(super) struct Cells {
    /// The normalised faces; empty where degenerate.
    pub(super) faces: Vec<Vec<u32>>,
    /// The ends of the edges, in order: an edge's number is its place.
    pub(super) ends: Vec<[u32; 2]>,
    /// The uses of each edge.
    pub(super) uses: Vec<Vec<Use>>,
    /// The number of an edge.
    pub(super) edge_of: BTreeMap<[u32; 2], usize>,
    /// The vertices in faces.
    pub(super) referenced: BTreeSet<u32>,
}

impl Cells {
    pub(super) fn of(soup: &Soup) -> Self {
        let faces: Vec<Vec<u32>> = soup
            .faces
            .iter()
            .map(|face| normalised(face))
            .map(|face| if is_degenerate(&face) { Vec::new() } else { face })
            .collect();
        let mut by_ends: BTreeMap<[u32; 2], Vec<Use>> = BTreeMap::new();
        for (face, word) in faces.iter().enumerate() {
            for place in 0..word.len() {
                let (a, b) = (word[place], word[(place + 1) % word.len()]);
                let side = Use { face, place, forward: a < b };
                by_ends.entry([a.min(b), a.max(b)]).or_default().push(side);
            }
        }
        let edge_of = by_ends.keys().enumerate().map(|(number, ends)| (*ends, number)).collect();
        let referenced = faces.iter().flatten().copied().collect();
        let (ends, uses) = by_ends.into_iter().unzip();
        Cells { faces, ends, uses, edge_of, referenced }
    }

    /// The faces that are not degenerate.
    pub(super) fn proper(&self) -> Vec<usize> {
        (0..self.faces.len()).filter(|&f| !self.faces[f].is_empty()).collect()
    }

    /// The edge from a corner of a face to the next one.
    pub(super) fn edge(&self, face: usize, place: usize) -> usize {
        let word = &self.faces[face];
        let (a, b) = (word[place], word[(place + 1) % word.len()]);
        self.edge_of[&[a.min(b), a.max(b)]]
    }

    /// Whether an edge has two uses and both run the same way.
    pub(super) fn is_inconsistent(&self, edge: usize) -> bool {
        self.uses[edge].len() == 2 && self.uses[edge][0].forward == self.uses[edge][1].forward
    }

    /// The edges with so many uses, by their number of uses.
    pub(super) fn edges_where(&self, wanted: impl Fn(usize) -> bool) -> Vec<usize> {
        (0..self.uses.len()).filter(|&e| wanted(self.uses[e].len())).collect()
    }

    /// The faces that have three or more different vertices and come back to one.
    pub(super) fn non_simple(&self) -> Vec<usize> {
        let different = |f: &usize| self.faces[*f].iter().collect::<BTreeSet<_>>().len();
        self.proper().into_iter().filter(|f| different(f) < self.faces[*f].len()).collect()
    }

    /// The faces whose cycle an earlier face has: the same way, and (where none has it so) the other way only.
    pub(super) fn duplicates(&self) -> (Vec<usize>, Vec<usize>) {
        let (mut same, mut opposite) = (Vec::new(), Vec::new());
        for f in self.proper() {
            if (0..f).any(|g| self.are_alike(g, f, Way::Same)) {
                same.push(f);
            } else if (0..f).any(|g| self.are_alike(g, f, Way::Opposite)) {
                opposite.push(f);
            }
        }
        (same, opposite)
    }

    /// Whether two faces that are not degenerate have one cycle, run the same way or the opposite one.
    pub(super) fn are_alike(&self, one: usize, other: usize, way: Way) -> bool {
        let (word, mut turned) = (&self.faces[one], self.faces[other].clone());
        if way == Way::Opposite {
            turned.reverse();
        }
        !word.is_empty() && is_rotation(word, &turned)
    }
}

/// The cyclic sequence with consecutive repeats dropped; the earlier corner stays.
pub(super) fn normalised(face: &[u32]) -> Vec<u32> {
    let mut word = face.to_vec();
    while word.len() > 1 {
        let last = word.len() - 1;
        let repeat = (1..=last).find(|&i| word[i] == word[i - 1]);
        match repeat.or((word[last] == word[0]).then_some(last)) {
            Some(place) => word.remove(place),
            None => break,
        };
    }
    word
}

fn is_degenerate(normalised: &[u32]) -> bool {
    normalised.iter().collect::<BTreeSet<_>>().len() < 3
}

fn is_rotation(one: &[u32], other: &[u32]) -> bool {
    one.len() == other.len() && (0..one.len()).any(|by| [&other[by..], &other[..by]].concat() == one)
}

/// The classes of things that share a label, directly or through others, each ascending, by lowest member.
pub(super) fn classes<L: Ord + Clone>(labels: &[BTreeSet<L>]) -> Vec<Vec<usize>> {
    let mut classes: Vec<(Vec<usize>, BTreeSet<L>)> = Vec::new();
    for (thing, own) in labels.iter().enumerate() {
        let (touching, apart): (Vec<_>, Vec<_>) =
            classes.into_iter().partition(|(_, have)| !have.is_disjoint(own));
        let mut joined = (vec![thing], own.clone());
        for (members, have) in touching {
            joined.0.extend(members);
            joined.1.extend(have);
        }
        joined.0.sort_unstable();
        classes = apart;
        classes.push(joined);
    }
    let mut members: Vec<Vec<usize>> = classes.into_iter().map(|(members, _)| members).collect();
    members.sort_unstable();
    members
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn repeats_go_round_the_end_too_and_the_first_corner_stays_in_front() {
        assert_eq!(normalised(&[0, 0, 1, 2, 2, 0]), [0, 1, 2]);
        assert_eq!(normalised(&[3, 3, 3]), [3]);
        assert_eq!(normalised(&[]), [0; 0]);
    }

    #[test]
    fn classes_join_through_others() {
        let labels = [vec![1], vec![2], vec![3], vec![1, 2], vec![]].map(|l| l.into_iter().collect());
        assert_eq!(classes::<u8>(&labels), [vec![0, 1, 3], vec![2], vec![4]]);
    }
}
