//! Classes of things that are joined two by two: union-find, with and without a side.
//!
//! *Source*: R. E. Tarjan, *Efficiency of a good but not linear set union algorithm*, 1975; path halving.

use crate::{Column, Id};

/// Disjoint classes of the numbers from 0 to n − 1. The root of a class is its lowest number.
///
/// Classes are small here (the corners of one vertex): a union takes the lower root, which needs no rank. For classes of
/// any size use `petgraph`'s.
#[derive(Clone, Debug, Default)]
pub struct Classes {
    parent: Vec<u32>,
}

impl Classes {
    /// Each of `count` numbers in a class of its own.
    pub fn new(count: usize) -> Self {
        let mut classes = Classes::default();
        classes.reset(count);
        classes
    }

    /// Each of `count` numbers in a class of its own again; the memory is used again. *Cost*: O(count).
    pub fn reset(&mut self, count: usize) {
        self.parent.clear();
        self.parent.extend(0..count as u32);
    }

    /// The lowest number of a class.
    pub fn root(&mut self, mut at: u32) -> u32 {
        while self.parent[at as usize] != at {
            self.parent[at as usize] = self.parent[self.parent[at as usize] as usize];
            at = self.parent[at as usize];
        }
        at
    }

    /// Joins the classes of two numbers; says whether they were apart.
    pub fn join(&mut self, one: u32, other: u32) -> bool {
        let (one, other) = (self.root(one), self.root(other));
        self.parent[one.max(other) as usize] = one.min(other);
        one != other
    }
}

/// Disjoint classes of elements, each of which lies on one of two sides.
///
/// *Cost*: 9 bytes an element; nearly constant time for each question, by path halving and union by size.
#[derive(Clone, Debug)]
pub struct SidedClasses<I> {
    parent: Column<I, I>,
    /// Whether each element lies on the other side than its parent.
    is_turned: Column<I, bool>,
    size: Column<I, u32>,
}

/// What joining two elements did.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Joined<I> {
    /// They were in one class already, on the sides asked for.
    Agrees,
    /// They were in one class already, and not on those sides.
    Contradicts {
        /// The class's root.
        root: I,
    },
    /// Their classes became one.
    Merged {
        /// The root of the new class.
        root: I,
        /// The root of the class that was joined to it.
        child: I,
    },
}

impl<I: Id> SidedClasses<I> {
    /// Each of `count` elements in a class of its own.
    pub fn new(count: usize) -> Self {
        SidedClasses {
            parent: (0..count).map(I::new).collect(),
            is_turned: Column::filled(false, count),
            size: Column::filled(1, count),
        }
    }

    /// The root of an element's class, and whether the element is turned against it.
    pub fn find(&mut self, element: I) -> (I, bool) {
        let (mut at, mut turned) = (element, false);
        while self.parent[at] != at {
            let up = self.parent[at];
            let step = self.is_turned[at];
            if self.parent[up] != up {
                // Skip a generation: the grandparent's side is the two steps together.
                self.parent[at] = self.parent[up];
                self.is_turned[at] = step ^ self.is_turned[up];
            }
            turned ^= self.is_turned[at];
            at = self.parent[at];
        }
        (at, turned)
    }

    /// Joins two classes so that the two elements are turned against each other or not.
    pub fn join(&mut self, one: I, other: I, turned: bool) -> Joined<I> {
        let ((a, side_a), (b, side_b)) = (self.find(one), self.find(other));
        let turned = turned ^ side_a ^ side_b;
        if a == b {
            return if turned { Joined::Contradicts { root: a } } else { Joined::Agrees };
        }
        let (root, child) = if self.size[a] < self.size[b] { (b, a) } else { (a, b) };
        self.parent[child] = root;
        self.is_turned[child] = turned;
        self.size[root] += self.size[child];
        Joined::Merged { root, child }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::FaceId;

    #[test]
    fn the_root_of_a_class_is_its_lowest_number() {
        let mut classes = Classes::new(6);
        assert!(classes.join(5, 3) && classes.join(3, 1) && !classes.join(1, 5));
        assert_eq!((0..6).map(|at| classes.root(at)).collect::<Vec<_>>(), [0, 1, 2, 1, 4, 1]);
        classes.reset(2);
        assert_eq!((classes.root(0), classes.root(1)), (0, 1));
    }

    #[test]
    fn sides_add_up_along_chains() {
        let mut classes = SidedClasses::new(6);
        for f in 0..5 {
            classes.join(FaceId(f), FaceId(f + 1), true);
        }
        for one in 0..6 {
            for other in 0..6 {
                let turned = (one + other) % 2 == 1;
                let [a, b] = [one, other].map(FaceId);
                assert_eq!(classes.join(a, b, turned), Joined::Agrees);
                assert!(matches!(classes.join(a, b, !turned), Joined::Contradicts { .. }));
            }
        }
    }
}
