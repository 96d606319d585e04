//! New vertices: the classes of corners joined across matched sides.

use std::collections::BTreeMap;

use super::corners::{Classes, bases};
use super::{Pipeline, Repaired};

impl Pipeline {
    pub(super) fn rename(mut self) -> Repaired {
        let base = bases(self.faces.iter().map(|face| face.corners.len()));
        let corner = |f: usize, i: usize| base[f] + i % (base[f + 1] - base[f]);
        let mut classes = Classes::new(base[self.faces.len()]);
        for (&(f, i), &(g, j)) in &self.matches {
            let turn = usize::from(self.is_forward((f, i)) != self.is_forward((g, j)));
            classes.join(corner(f, i), corner(g, j + turn));
            classes.join(corner(f, i + 1), corner(g, j + 1 - turn));
        }
        // The lowest stored vertex of each class, by the class's lowest corner.
        let mut lowest: BTreeMap<usize, u32> = BTreeMap::new();
        for (f, face) in self.faces.iter().enumerate() {
            for (i, &vertex) in face.corners.iter().enumerate() {
                let least = lowest.entry(classes.root(corner(f, i))).or_insert(vertex);
                *least = vertex.min(*least);
            }
        }
        let (mut first, mut further) = (BTreeMap::new(), Vec::new());
        for (&root, &vertex) in &lowest {
            if *first.entry(vertex).or_insert(root) != root {
                further.push(root);
            }
        }
        let order: Vec<usize> = first.into_values().chain(further).collect();
        let new_id: BTreeMap<usize, u32> = order.iter().zip(0..).map(|(&root, id)| (root, id)).collect();
        let source_vertex: Vec<u32> = order.iter().map(|root| lowest[root]).collect();
        let words = (0..self.faces.len())
            .map(|f| (base[f]..base[f + 1]).map(|c| new_id[&classes.root(c)]).collect())
            .collect();
        let subdivided = self.subdivide(words, &source_vertex);
        let inserted_count = subdivided.inserted.len();
        for (face, word) in self.faces.iter_mut().zip(subdivided.words) {
            face.corners = word;
        }
        self.welded = (0..subdivided.positions.len() as u32).collect();
        self.positions = subdivided.positions;
        self.match_stored();
        self.orient();
        let nothing = std::iter::repeat_n(None, inserted_count);
        Repaired {
            positions: self.positions,
            source_vertex: source_vertex.into_iter().map(Some).chain(nothing).collect(),
            inserted: subdivided.inserted,
            source_face: self.faces.iter().map(|face| face.source).collect(),
            flipped: self.faces.iter().map(|face| face.flipped).collect(),
            faces: self.faces.into_iter().map(|face| face.corners).collect(),
            non_orientable: self
                .non_orientable
                .iter()
                .map(|patch| patch.iter().map(|&f| f as u32).collect())
                .collect(),
        }
    }
}
