//! New vertices on edges that would otherwise coincide by index.

use std::collections::{BTreeMap, BTreeSet};

use num_rational::BigRational;

use super::{Inserted, Pipeline, Point, Side};

/// The faces with the inserted vertices, and those.
pub(super) struct Subdivided {
    pub(super) words: Vec<Vec<u32>>,
    pub(super) positions: Vec<Point>,
    pub(super) inserted: BTreeMap<u32, Inserted>,
}

impl Pipeline {
    pub(super) fn subdivide(&self, words: Vec<Vec<u32>>, source_vertex: &[u32]) -> Subdivided {
        let mut positions: Vec<Point> =
            source_vertex.iter().map(|&v| self.positions[v as usize].clone()).collect();
        let mut occupied: BTreeSet<Point> = positions.iter().cloned().collect();
        let sides = self.sides_by_welded();
        let mut extra: BTreeMap<Side, u32> = BTreeMap::new();
        let mut inserted = BTreeMap::new();
        for ends in self.clashes(&words) {
            let (point, numerator, denominator) = self.free_point(ends, &occupied);
            occupied.insert(point.clone());
            for &side in &sides[&ends] {
                if extra.contains_key(&side) {
                    continue;
                }
                let new = positions.len() as u32;
                positions.push(point.clone());
                inserted.insert(new, Inserted { ends, numerator, denominator });
                extra.insert(side, new);
                extra.insert(self.partner(side), new);
            }
        }
        let with_extra = |(f, word): (usize, Vec<u32>)| {
            let here = |(i, c): (usize, u32)| [Some(c), extra.get(&(f, i)).copied()].into_iter().flatten();
            word.into_iter().enumerate().flat_map(here).collect()
        };
        let words = words.into_iter().enumerate().map(with_extra).collect();
        Subdivided { words, positions, inserted }
    }

    /// The side that a side is matched with, or itself.
    fn partner(&self, side: Side) -> Side {
        self.matches.get(&side).copied().unwrap_or(side)
    }

    /// The welded edges of which two different edges would join the same two new vertices.
    fn clashes(&self, words: &[Vec<u32>]) -> BTreeSet<[u32; 2]> {
        let mut edges_here: BTreeMap<[u32; 2], BTreeSet<Side>> = BTreeMap::new();
        for (f, word) in words.iter().enumerate() {
            for i in 0..word.len() {
                let (a, b) = (word[i], word[(i + 1) % word.len()]);
                let edge = (f, i).min(self.partner((f, i)));
                edges_here.entry([a.min(b), a.max(b)]).or_default().insert(edge);
            }
        }
        let clashing = edges_here.values().filter(|edges| edges.len() > 1).filter_map(BTreeSet::first);
        clashing
            .map(|&(f, i)| {
                let [a, b] = self.faces[f].side(i).map(|v| self.name(v));
                [a.min(b), a.max(b)]
            })
            .collect()
    }

    /// The first free point of 1/2, 1/3, 2/3, 1/4, … 63/64 along an edge; else its midpoint.
    fn free_point(&self, ends: [u32; 2], occupied: &BTreeSet<Point>) -> (Point, u32, u32) {
        let [low, high] = ends.map(|v| self.point(v));
        let at = |n: u32, d: u32| -> Point {
            let ratio = BigRational::new(n.into(), d.into());
            Some([0, 1, 2].map(|i| &low[i] + (&high[i] - &low[i]) * &ratio))
        };
        let ratios = (2..65).flat_map(|d| (1..d).map(move |n| (n, d)));
        let mut candidates = ratios.map(|(n, d)| (at(n, d), n, d));
        candidates.find(|(point, ..)| !occupied.contains(point)).unwrap_or_else(|| (at(1, 2), 1, 2))
    }
}
