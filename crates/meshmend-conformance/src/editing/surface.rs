//! Faces as plain lists: whether a half-edge structure holds them, and their figures.

use std::collections::{BTreeMap, BTreeSet};

use super::Side;

/// The faces of a manifold surface that is oriented.
#[derive(Clone, Debug)]
pub(super) struct Surface {
    pub(super) faces: Vec<Vec<u32>>,
    /// For each side of a face the face, and the place where the side begins.
    sides: BTreeMap<Side, [usize; 2]>,
    /// The vertex before each vertex of the boundary, as the hole runs.
    hole_before: BTreeMap<u32, u32>,
}

/// What the Euler formula is about, with the number of holes and of components.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Figures {
    pub(super) vertices: isize,
    pub(super) edges: isize,
    pub(super) faces: isize,
    pub(super) holes: isize,
    pub(super) components: isize,
}

impl Surface {
    /// The surface of some faces. None if they are not simple, or not those of an oriented manifold.
    pub(super) fn of(faces: Vec<Vec<u32>>) -> Option<Self> {
        let mut sides = BTreeMap::new();
        for (face, vertices) in faces.iter().enumerate() {
            let different: BTreeSet<u32> = vertices.iter().copied().collect();
            if vertices.len() < 3 || different.len() < vertices.len() {
                return None;
            }
            for (place, &vertex) in vertices.iter().enumerate() {
                let side = [vertex, vertices[(place + 1) % vertices.len()]];
                if sides.insert(side, [face, place]).is_some() {
                    return None;
                }
            }
        }
        let mut hole_before = BTreeMap::new();
        for &[from, to] in sides.keys() {
            // A hole runs from `to` to `from`.
            if !sides.contains_key(&[to, from]) && hole_before.insert(from, to).is_some() {
                return None;
            }
        }
        let surface = Surface { faces, sides, hole_before };
        surface.has_one_umbrella_a_vertex().then_some(surface)
    }

    fn has_one_umbrella_a_vertex(&self) -> bool {
        let mut corners: BTreeMap<u32, usize> = BTreeMap::new();
        self.faces.iter().flatten().for_each(|&vertex| *corners.entry(vertex).or_default() += 1);
        corners.iter().all(|(&vertex, &count)| {
            let ends = usize::from(self.hole_before.contains_key(&vertex));
            self.star(vertex).len() == count + ends
        })
    }

    pub(super) fn vertices(&self) -> BTreeSet<u32> {
        self.faces.iter().flatten().copied().collect()
    }

    /// Every half-edge, those along holes included.
    pub(super) fn halves(&self) -> BTreeSet<Side> {
        self.sides.keys().flat_map(|&[a, b]| [[a, b], [b, a]]).collect()
    }

    pub(super) fn is_half(&self, [a, b]: Side) -> bool {
        self.sides.contains_key(&[a, b]) || self.sides.contains_key(&[b, a])
    }

    pub(super) fn is_hole(&self, [a, b]: Side) -> bool {
        !self.sides.contains_key(&[a, b]) && self.sides.contains_key(&[b, a])
    }

    /// The face to the left of a half-edge, and the place where that begins.
    pub(super) fn face(&self, side: Side) -> Option<[usize; 2]> {
        self.sides.get(&side).copied()
    }

    /// The vertices of the face to the left of a half-edge, from that one on.
    pub(super) fn face_from(&self, side: Side) -> Option<Vec<u32>> {
        let [face, place] = self.face(side)?;
        let mut vertices = self.faces[face].clone();
        vertices.rotate_left(place);
        Some(vertices)
    }

    /// The vertices along the hole to the left of a half-edge, from that one on.
    pub(super) fn hole_from(&self, [from, to]: Side) -> Option<Vec<u32>> {
        if !self.is_hole([from, to]) {
            return None;
        }
        let mut back = vec![to, from];
        while let Some(&before) = back.last().and_then(|vertex| self.hole_before.get(vertex)) {
            if before == to || back.len() > self.sides.len() {
                break;
            }
            back.push(before);
        }
        back.reverse();
        back.rotate_right(2);
        Some(back)
    }

    pub(super) fn is_on_boundary(&self, vertex: u32) -> bool {
        self.hole_before.contains_key(&vertex)
    }

    /// The neighbour that comes after another one, counter-clockwise.
    pub(super) fn turned(&self, vertex: u32, neighbour: u32) -> Option<u32> {
        match self.face([vertex, neighbour]) {
            Some([face, place]) => {
                let vertices = &self.faces[face];
                Some(vertices[(place + vertices.len() - 1) % vertices.len()])
            }
            None => self.hole_before.get(&vertex).copied(),
        }
    }

    /// The neighbours of a vertex, counter-clockwise from one of them on, once round.
    pub(super) fn star_from(&self, vertex: u32, first: u32) -> Vec<u32> {
        let mut star = vec![first];
        let mut at = first;
        while let Some(next) = self.turned(vertex, at) {
            if next == first || star.len() > self.sides.len() {
                break;
            }
            star.push(next);
            at = next;
        }
        star
    }

    /// The neighbours of a vertex, counter-clockwise.
    pub(super) fn star(&self, vertex: u32) -> Vec<u32> {
        let mut sides = self.sides.range([vertex, 0]..=[vertex, u32::MAX]);
        sides.next().map_or_else(Vec::new, |(side, _)| self.star_from(vertex, side[1]))
    }

    pub(super) fn figures(&self) -> Figures {
        let edges: BTreeSet<Side> = self.sides.keys().map(|&[a, b]| [a.min(b), a.max(b)]).collect();
        Figures {
            vertices: self.vertices().len() as isize,
            edges: edges.len() as isize,
            faces: self.faces.len() as isize,
            holes: cycles(&self.hole_before),
            components: self.components(),
        }
    }

    fn components(&self) -> isize {
        let mut left = self.vertices();
        let mut count = 0;
        while let Some(vertex) = left.pop_first() {
            count += 1;
            let mut open = vec![vertex];
            while let Some(vertex) = open.pop() {
                open.extend(self.star(vertex).into_iter().filter(|neighbour| left.remove(neighbour)));
            }
        }
        count
    }
}

/// How many cycles a permutation has.
fn cycles(before: &BTreeMap<u32, u32>) -> isize {
    let mut left: BTreeSet<u32> = before.keys().copied().collect();
    let mut count = 0;
    while let Some(first) = left.pop_first() {
        count += 1;
        let mut at = before.get(&first);
        while let Some(vertex) = at.filter(|&&vertex| left.remove(&vertex)) {
            at = before.get(vertex);
        }
    }
    count
}

/// The faces each from its lowest vertex on, ascending.
pub(super) fn canonical(faces: &[Vec<u32>]) -> Vec<Vec<u32>> {
    let mut faces = faces.to_vec();
    for face in &mut faces {
        let lowest = face.iter().enumerate().min_by_key(|&(_, vertex)| vertex).map_or(0, |(place, _)| place);
        face.rotate_left(lowest);
    }
    faces.sort();
    faces
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_of_small_surfaces() {
        let tetrahedron =
            Surface::of(vec![vec![0, 1, 2], vec![0, 2, 3], vec![0, 3, 1], vec![1, 3, 2]]).unwrap();
        let figures = Figures { vertices: 4, edges: 6, faces: 4, holes: 0, components: 1 };
        assert_eq!(tetrahedron.figures(), figures);
        let strip = Surface::of(vec![vec![0, 1, 2], vec![2, 1, 3], vec![7, 8, 9]]).unwrap();
        let figures = Figures { vertices: 7, edges: 8, faces: 3, holes: 2, components: 2 };
        assert_eq!(strip.figures(), figures);
        assert_eq!(strip.star(1), [2, 0, 3]);
        assert_eq!(strip.hole_from([1, 3]), None, "a face is there");
        assert_eq!(strip.hole_from([3, 1]), Some(vec![3, 1, 0, 2]));
    }

    #[test]
    fn what_is_no_oriented_manifold_is_no_surface() {
        let bow_tie = vec![vec![0, 1, 2], vec![0, 3, 4]];
        let clash = vec![vec![0, 1, 2], vec![0, 1, 3]];
        let two_shells = vec![vec![0, 1, 2], vec![0, 2, 1], vec![0, 3, 4], vec![0, 4, 3]];
        for faces in [bow_tie, clash, two_shells, vec![vec![0, 1]], vec![vec![0, 1, 0, 2]]] {
            assert!(Surface::of(faces.clone()).is_none(), "{faces:?}");
        }
    }
}
