//! Section 2: patches, whether they can be oriented, and the witness of one that can't.

use std::collections::{BTreeMap, BTreeSet, VecDeque};

use serde::Serialize;

use super::cells::{Cells, classes};

/// A closed strip of faces that reverses orientation once round: `edges[i]` lies between `faces[i]` and the next.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Witness {
    /// The faces, from the lowest on.
    pub faces: Vec<u32>,
    /// The edges between them, the last one back to the first face.
    pub edges: Vec<u32>,
}

/// Faces joined across edges of degree 2.
pub(super) fn patches(cells: &Cells) -> Vec<Vec<usize>> {
    let proper = cells.proper();
    let labels: Vec<BTreeSet<usize>> = proper
        .iter()
        .map(|&f| (0..cells.faces[f].len()).map(move |place| cells.edge(f, place)))
        .map(|edges| edges.filter(|&e| cells.uses[e].len() == 2).collect())
        .collect();
    classes(&labels).into_iter().map(|class| class.into_iter().map(|i| proper[i]).collect()).collect()
}

/// Whether the faces of a patch can be flipped so that no edge of degree 2 is inconsistent: sides are spread from
/// the first face until nothing changes, and then every edge is asked.
pub(super) fn is_orientable(cells: &Cells, patch: &[usize]) -> bool {
    let mut flipped: BTreeMap<usize, bool> = patch.iter().take(1).map(|&f| (f, false)).collect();
    let inside = |e: &usize| cells.uses[*e].len() == 2 && patch.contains(&cells.uses[*e][0].face);
    let edges: Vec<usize> = (0..cells.uses.len()).filter(inside).collect();
    while flipped.len() < patch.len() {
        for &e in &edges {
            let [one, other] = [cells.uses[e][0].face, cells.uses[e][1].face];
            match (flipped.get(&one).copied(), flipped.get(&other).copied()) {
                (Some(side), None) => flipped.insert(other, side ^ cells.is_inconsistent(e)),
                (None, Some(side)) => flipped.insert(one, side ^ cells.is_inconsistent(e)),
                _ => None,
            };
        }
    }
    edges.iter().all(|&e| {
        let [one, other] = [cells.uses[e][0].face, cells.uses[e][1].face];
        flipped[&one] ^ flipped[&other] == cells.is_inconsistent(e)
    })
}

/// The witness of a patch that is not orientable, as section 2 defines it.
pub(super) fn witness(cells: &Cells, patch: &[usize]) -> Option<Witness> {
    let tree = Tree::of(cells, *patch.first()?);
    let mut best: Option<(usize, usize, Witness)> = None;
    for (e, uses) in cells.uses.iter().enumerate().filter(|(_, uses)| uses.len() == 2) {
        let [one, other] = [uses[0].face, uses[1].face];
        let (Some(first), Some(second)) = (tree.flipped.get(&one), tree.flipped.get(&other)) else {
            continue;
        };
        if first ^ second == cells.is_inconsistent(e) {
            continue;
        }
        let strip = tree.cycle(one, other, e);
        if best.as_ref().is_none_or(|(length, edge, _)| (strip.faces.len(), e) < (*length, *edge)) {
            best = Some((strip.faces.len(), e, strip));
        }
    }
    best.map(|(_, _, strip)| strip.in_standard_form())
}

/// The breadth-first tree from a face, neighbours in corner order.
struct Tree {
    /// The parent and the edge to it; none for the root.
    parent: BTreeMap<usize, (usize, usize)>,
    flipped: BTreeMap<usize, bool>,
}

impl Tree {
    fn of(cells: &Cells, root: usize) -> Self {
        let mut tree = Tree { parent: BTreeMap::new(), flipped: [(root, false)].into() };
        let mut queue = VecDeque::from([root]);
        while let Some(f) = queue.pop_front() {
            for place in 0..cells.faces[f].len() {
                let e = cells.edge(f, place);
                let others = cells.uses[e].iter().filter(|side| (side.face, side.place) != (f, place));
                let others: Vec<usize> = others.map(|side| side.face).collect();
                let [g] = others[..] else { continue };
                if !tree.flipped.contains_key(&g) {
                    let side = tree.flipped[&f] ^ cells.is_inconsistent(e);
                    tree.flipped.insert(g, side);
                    tree.parent.insert(g, (f, e));
                    queue.push_back(g);
                }
            }
        }
        tree
    }

    /// The faces from one up to the root, itself first, with the edge above each.
    fn path_up(&self, face: usize) -> Vec<(usize, Option<usize>)> {
        let above = |&(f, _): &(usize, Option<usize>)| {
            self.parent.get(&f).map(|&(up, _)| (up, self.parent.get(&up).map(|p| p.1)))
        };
        std::iter::successors(Some((face, self.parent.get(&face).map(|p| p.1))), above).collect()
    }

    /// The cycle that an edge between two faces closes with the tree.
    fn cycle(&self, one: usize, other: usize, edge: usize) -> Witness {
        let (up, down) = (self.path_up(one), self.path_up(other));
        let meeting = up.iter().position(|(f, _)| down.iter().any(|(g, _)| f == g)).unwrap();
        let back = down.iter().position(|(g, _)| *g == up[meeting].0).unwrap();
        let (mut faces, mut edges) = (Vec::new(), Vec::new());
        for (f, above) in &up[..meeting] {
            faces.push(*f as u32);
            edges.push(above.unwrap() as u32);
        }
        faces.push(up[meeting].0 as u32);
        for (g, above) in down[..back].iter().rev() {
            edges.push(above.unwrap() as u32);
            faces.push(*g as u32);
        }
        edges.push(edge as u32);
        Witness { faces, edges }
    }
}

impl Witness {
    /// From the lowest face, in the direction whose first edge is lower.
    fn in_standard_form(mut self) -> Self {
        let n = self.faces.len();
        let lowest = (0..n).min_by_key(|&i| self.faces[i]).unwrap_or(0);
        self.faces.rotate_left(lowest);
        self.edges.rotate_left(lowest);
        if self.edges[n - 1] < self.edges[0] {
            self.faces[1..].reverse();
            self.edges.reverse();
        }
        self
    }
}

/// Whether faces and edges are a simple closed strip that reverses orientation; if not, why.
pub(super) fn check_witness(cells: &Cells, faces: &[u32], edges: &[u32]) -> Result<(), String> {
    let different = |list: &[u32]| list.iter().collect::<BTreeSet<_>>().len() == list.len();
    if faces.is_empty() || faces.len() != edges.len() || !different(faces) || !different(edges) {
        return Err(format!("{faces:?} and {edges:?} are no simple strip"));
    }
    let mut reversals = 0;
    for (i, &e) in edges.iter().enumerate() {
        let Some([one, other]) = cells.uses.get(e as usize).map(Vec::as_slice) else {
            return Err(format!("edge {e} has not degree 2"));
        };
        let mut joined = [one.face as u32, other.face as u32];
        let mut wanted = [faces[i], faces[(i + 1) % faces.len()]];
        joined.sort_unstable();
        wanted.sort_unstable();
        if joined != wanted {
            return Err(format!("edge {e} joins {joined:?} and not {wanted:?}"));
        }
        reversals += usize::from(one.forward == other.forward);
    }
    if reversals % 2 == 1 { Ok(()) } else { Err(format!("{faces:?} comes back as it went")) }
}
