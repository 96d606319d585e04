//! Which faces are there already?
//!
//! A face is the *same* as an earlier one when both have the same directed cycle of vertices up to rotation. It is
//! *opposite* to an earlier one when that has the reverse of its cycle and no earlier face has the cycle itself.
//! So of three faces A, A, reversed A the second is the same as the first and the third opposite to it.
//!
//! Faces that are alike have the same lowest and the same highest edge: only where two faces agree in both are
//! cycles compared, by their least rotations. No hash decides, so no input is slow.

use meshmend_core::{Connectivity, EdgeId, FaceId, Id, VertexId, canonical_rotation};
use serde::Serialize;

/// How a face repeats an earlier one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Likeness {
    /// The same directed cycle.
    Same,
    /// The reverse, and no earlier face has the same.
    Opposite,
}

/// A face that an earlier one repeats already.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
pub struct DuplicateFace {
    /// The later face.
    pub face: FaceId,
    /// The earliest face that it is like in this way.
    pub original: FaceId,
    /// In which way.
    pub likeness: Likeness,
}

/// The faces of a complex that repeat an earlier one, ascending.
///
/// ```
/// # use meshmend_core::{Build, EdgeUse, FaceId, FaceTable, PolygonMesh, VertexId};
/// # use meshmend_topology::{Likeness, duplicate_faces};
/// let wall = [0, 1, 2, 1, 0, 2, 2, 1, 0].map(VertexId).to_vec();
/// let mesh = PolygonMesh::new(vec![[0.0; 3]; 3], FaceTable::triangles(3, wall)?)?;
/// let found = duplicate_faces(&EdgeUse::build(mesh.complex())?);
/// assert_eq!((found[0].original, found[0].likeness), (FaceId(0), Likeness::Opposite));
/// assert_eq!((found[1].original, found[1].likeness), (FaceId(1), Likeness::Same));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// *Cost*: O(n log n) comparisons at worst, in practice one pass and a sort of the few faces that have a lowest
/// edge in common; a byte an edge and 16 bytes each of those.
pub fn duplicate_faces<K: Connectivity>(kernel: &K) -> Vec<DuplicateFace> {
    let mut found: Vec<DuplicateFace> = alike_faces(kernel).iter().flat_map(|group| repeats(group)).collect();
    found.sort_unstable();
    found
}

/// One of several faces with the same cycle of vertices up to rotation and direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct AlikeFace {
    /// The face.
    pub face: FaceId,
    /// Whether it runs the cycle in the greater of its two directions, from the least rotation of each.
    pub is_reversed: bool,
}

/// The faces of a complex that have their cycle in common with others, in either direction: by cycle, each group
/// ascending.
///
/// *Cost*: as [`duplicate_faces`].
pub fn alike_faces<K: Connectivity>(kernel: &K) -> Vec<Vec<AlikeFace>> {
    let (mut cycles, mut groups) = (Cycles::default(), Vec::new());
    for alike in candidates(kernel).chunk_by(|one, other| one.has_extremes_of(other)) {
        if alike.len() > 1 {
            cycles.fill(kernel, alike);
            groups.extend(cycles.groups());
        }
    }
    groups
}

/// The faces of a [group of alike ones](alike_faces) that repeat an earlier one.
pub fn repeats(group: &[AlikeFace]) -> impl Iterator<Item = DuplicateFace> {
    let mut first = [None::<FaceId>; 2];
    group.iter().filter_map(move |&AlikeFace { face, is_reversed }| {
        let (own, reverse) = (usize::from(is_reversed), usize::from(!is_reversed));
        let same = first[own].map(|original| (original, Likeness::Same));
        let opposite = first[reverse].map(|original| (original, Likeness::Opposite));
        first[own] = first[own].or(Some(face));
        same.or(opposite).map(|(original, likeness)| DuplicateFace { face, original, likeness })
    })
}

/// A face with what all faces like it have in common.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Candidate {
    lowest: EdgeId,
    highest: EdgeId,
    corners: u32,
    face: FaceId,
}

impl Candidate {
    fn of<K: Connectivity>(kernel: &K, face: FaceId) -> Option<Self> {
        let mut edges = kernel.face_corners(face).map(|corner| kernel.corner_edge(corner));
        let first = edges.next()?;
        let start = Candidate { lowest: first, highest: first, corners: 1, face };
        Some(edges.fold(start, |so_far, edge| Candidate {
            lowest: so_far.lowest.min(edge),
            highest: so_far.highest.max(edge),
            corners: so_far.corners + 1,
            face,
        }))
    }

    fn has_extremes_of(&self, other: &Self) -> bool {
        (self.lowest, self.highest, self.corners) == (other.lowest, other.highest, other.corners)
    }
}

/// The faces whose lowest edge is that of another face too, sorted by what they have in common.
fn candidates<K: Connectivity>(kernel: &K) -> Vec<Candidate> {
    let all = || kernel.faces().filter_map(|face| Candidate::of(kernel, face));
    let mut faces_with_lowest = vec![0u8; kernel.edge_count()];
    for candidate in all() {
        let count = &mut faces_with_lowest[candidate.lowest.index()];
        *count = count.saturating_add(1);
    }
    let mut shared: Vec<_> = all().filter(|c| faces_with_lowest[c.lowest.index()] > 1).collect();
    shared.sort_unstable();
    shared
}

/// The cycles of some faces in a form that no rotation and no reversal changes, with the way each runs.
#[derive(Default)]
struct Cycles {
    vertices: Vec<VertexId>,
    entries: Vec<Entry>,
    scratch: Vec<VertexId>,
}

struct Entry {
    start: usize,
    end: usize,
    alike: AlikeFace,
}

impl Cycles {
    fn fill<K: Connectivity>(&mut self, kernel: &K, alike: &[Candidate]) {
        self.vertices.clear();
        self.entries.clear();
        for &Candidate { face, .. } in alike {
            self.scratch.clear();
            self.scratch.extend(kernel.face_vertices(face));
            let start = self.vertices.len();
            push_least_rotation(&self.scratch, &mut self.vertices);
            let end = self.vertices.len();
            self.scratch.reverse();
            push_least_rotation(&self.scratch, &mut self.vertices);
            let is_reversed = self.vertices[end..] < self.vertices[start..end];
            if is_reversed {
                self.vertices.copy_within(end.., start);
            }
            self.vertices.truncate(end);
            self.entries.push(Entry { start, end, alike: AlikeFace { face, is_reversed } });
        }
        let vertices = &self.vertices;
        let key = |entry: &Entry| (&vertices[entry.start..entry.end], entry.alike.face);
        self.entries.sort_unstable_by(|one, other| key(one).cmp(&key(other)));
    }

    /// Those with equal cycles, where there are several.
    fn groups(&self) -> impl Iterator<Item = Vec<AlikeFace>> {
        let cycle = |entry: &Entry| &self.vertices[entry.start..entry.end];
        let equal = self.entries.chunk_by(move |one, other| cycle(one) == cycle(other));
        equal.filter(|group| group.len() > 1).map(|group| group.iter().map(|entry| entry.alike).collect())
    }
}

fn push_least_rotation(cycle: &[VertexId], vertices: &mut Vec<VertexId>) {
    let start = canonical_rotation(cycle);
    vertices.extend_from_slice(&cycle[start..]);
    vertices.extend_from_slice(&cycle[..start]);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::kernel;

    fn found(faces: &[&[u32]]) -> Vec<(u32, u32, Likeness)> {
        let found = duplicate_faces(&kernel(9, faces));
        found.iter().map(|d| (d.face.0, d.original.0, d.likeness)).collect()
    }

    #[test]
    fn same_wins_over_opposite_and_names_the_earliest() {
        let faces: &[&[u32]] = &[&[0, 1, 2], &[2, 1, 0], &[1, 0, 2], &[1, 2, 0], &[0, 1, 3], &[2, 0, 1]];
        use Likeness::{Opposite, Same};
        assert_eq!(found(faces), [(1, 0, Opposite), (2, 1, Same), (3, 0, Same), (5, 0, Same)]);
    }

    #[test]
    fn equal_extremes_are_not_enough() {
        // Same vertices, same lowest and highest edge, other cycles.
        assert_eq!(
            found(&[&[0, 1, 2, 3, 4, 5], &[0, 1, 3, 2, 4, 5], &[3, 4, 5, 0, 1, 2]]),
            [(2, 0, Likeness::Same)]
        );
    }

    #[test]
    fn a_cycle_that_is_its_own_reverse_is_the_same() {
        assert_eq!(found(&[&[0, 1, 2, 1], &[1, 2, 1, 0]]), [(1, 0, Likeness::Same)]);
    }

    #[test]
    fn random_faces_agree_with_comparing_all_pairs() {
        let mut random = crate::shapes::Random(7);
        for _ in 0..300 {
            let soup = random.soup(5, 8, 5);
            let faces: Vec<&[u32]> = soup.iter().map(Vec::as_slice).collect();
            assert_eq!(found(&faces), by_all_pairs(&kernel(9, &faces)), "{soup:?}");
        }
    }

    fn by_all_pairs(kernel: &impl Connectivity) -> Vec<(u32, u32, Likeness)> {
        let cycle = |f: FaceId| kernel.face_vertices(f).collect::<Vec<_>>();
        let alike = |a: &[VertexId], b: &[VertexId]| {
            a.len() == b.len() && (0..a.len()).any(|i| [&a[i..], &a[..i]].concat() == b)
        };
        let mut all = Vec::new();
        for face in kernel.faces().filter(|&f| kernel.is_proper_face(f)) {
            let own = cycle(face);
            let reverse: Vec<_> = own.iter().rev().copied().collect();
            let earlier =
                |wanted: &[VertexId]| kernel.faces().take(face.index()).find(|&f| alike(&cycle(f), wanted));
            if let Some(original) = earlier(&own) {
                all.push((face.0, original.0, Likeness::Same));
            } else if let Some(original) = earlier(&reverse) {
                all.push((face.0, original.0, Likeness::Opposite));
            }
        }
        all
    }
}
