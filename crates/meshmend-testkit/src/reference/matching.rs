//! Rules 1 and 2: which sides are joined, and the patches that this makes.

use std::collections::BTreeMap;

use super::corners::Classes;
use super::{Pipeline, Side};

impl Pipeline {
    pub(super) fn pair(&mut self, one: Side, other: Side) {
        self.matches.insert(one, other);
        self.matches.insert(other, one);
    }

    pub(super) fn is_free(&self, side: Side) -> bool {
        !self.matches.contains_key(&side)
    }

    /// Rule 1: two sides that are the only two of their edge as stored.
    pub(super) fn match_stored(&mut self) {
        self.matches.clear();
        for sides in self.sides_by(|v| v).into_values() {
            if let [one, other] = sides[..] {
                self.pair(one, other);
            }
        }
    }

    /// Rule 2: two sides that are the only two of their welded edge, both free.
    pub(super) fn match_welded(&mut self) {
        for sides in self.sides_by_welded().into_values() {
            if let [one, other] = sides[..]
                && self.is_free(one)
                && self.is_free(other)
            {
                self.pair(one, other);
            }
        }
    }

    /// Faces joined across matched sides, by lowest face.
    pub(super) fn find_patches(&mut self) {
        let mut classes = Classes::new(self.faces.len());
        for (one, other) in &self.matches {
            classes.join(one.0, other.0);
        }
        let mut members: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for f in 0..self.faces.len() {
            members.entry(classes.root(f)).or_default().push(f);
        }
        self.patches = members.into_values().collect();
    }
}
