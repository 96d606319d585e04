//! Orienting each patch by majority.

use std::collections::{BTreeMap, BTreeSet, VecDeque};

use super::{Pipeline, Side};

impl Pipeline {
    /// Finds the patches and flips the minority of each that can be oriented; a tie keeps the lowest face.
    pub(super) fn orient(&mut self) {
        let mut neighbours: BTreeMap<usize, Vec<(usize, bool)>> = BTreeMap::new();
        for (&one, &other) in &self.matches {
            let same_way = self.is_forward(one) == self.is_forward(other);
            neighbours.entry(one.0).or_default().push((other.0, same_way));
        }
        let mut flips = BTreeSet::new();
        let mut side: BTreeMap<usize, bool> = BTreeMap::new();
        self.patches.clear();
        self.non_orientable.clear();
        for start in 0..self.faces.len() {
            if side.contains_key(&start) {
                continue;
            }
            let (patch, is_orientable) = spread(start, &neighbours, &mut side);
            if is_orientable {
                let turned: Vec<usize> = patch.iter().copied().filter(|f| side[f]).collect();
                if 2 * turned.len() <= patch.len() {
                    flips.extend(turned);
                } else {
                    flips.extend(patch.iter().copied().filter(|f| !side[f]));
                }
            } else {
                let mut faces = patch.clone();
                faces.sort_unstable();
                self.non_orientable.push(faces);
            }
            self.patches.push(patch);
        }
        self.flip(&flips);
    }

    /// Reverses faces, and moves their sides with them.
    fn flip(&mut self, flips: &BTreeSet<usize>) {
        let moved = |(f, place): Side| {
            if flips.contains(&f) { (f, self.faces[f].corners.len() - 1 - place) } else { (f, place) }
        };
        self.matches = self.matches.iter().map(|(&one, &other)| (moved(one), moved(other))).collect();
        for &f in flips {
            self.faces[f] = self.faces[f].reversed();
        }
    }
}

/// Gives each face of a patch a side, breadth first; says whether all sides agree.
fn spread(
    start: usize,
    neighbours: &BTreeMap<usize, Vec<(usize, bool)>>,
    side: &mut BTreeMap<usize, bool>,
) -> (Vec<usize>, bool) {
    side.insert(start, false);
    let (mut patch, mut queue, mut is_orientable) = (vec![start], VecDeque::from([start]), true);
    while let Some(f) = queue.pop_front() {
        for &(g, same_way) in neighbours.get(&f).into_iter().flatten() {
            let wanted = side[&f] ^ same_way;
            match side.get(&g) {
                Some(&have) => is_orientable &= have == wanted,
                None => {
                    side.insert(g, wanted);
                    patch.push(g);
                    queue.push_back(g);
                }
            }
        }
    }
    (patch, is_orientable)
}
