//! The vertices of open edges joined in thought, nearest first.

use std::collections::BTreeMap;

use meshmend_core::{Cancelled, ITEMS_BETWEEN_LOOKS, Watch};

use crate::passes::{NearPair, OpenEdges};

/// What happens at one distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Step {
    pub(super) distance: f64,
    /// How many vertices are joined to another at it.
    pub(super) joined: u64,
    /// How many open edges coincide with another from it on.
    pub(super) closed: u64,
}

/// All that happens up to where a face would lose a corner.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Merging {
    /// How many open edges coincide with another from the beginning.
    pub(super) coincident: u64,
    /// By distance.
    pub(super) steps: Vec<Step>,
    /// The distance at which a face would lose a corner, or an edge its length.
    pub(super) harm: Option<f64>,
}

impl Merging {
    /// Joins the vertices of pairs, nearest first.
    pub(super) fn of(open: &OpenEdges, pairs: Vec<NearPair>, watch: &Watch) -> Result<Self, Cancelled> {
        let mut classes = open.classes();
        let mut edges = EdgesOfClasses::of(open);
        let (coincident, mut steps, total) = (edges.coincident, Vec::<Step>::new(), pairs.len());
        for (done, NearPair { distance, places }) in pairs.into_iter().enumerate() {
            if done % ITEMS_BETWEEN_LOOKS == 0 {
                watch.look(super::STEP, done, total)?;
            }
            let [one, other] = places.map(|place| classes.class_of(place));
            // Equal positions that are still two are told apart by how the model moves.
            if one == other || distance == 0.0 {
                continue;
            }
            if classes.share_a_holder(one, other) {
                return Ok(Merging { coincident, steps, harm: Some(distance) });
            }
            edges.join(one.min(other), one.max(other));
            classes.join(one, other);
            match steps.last_mut().filter(|step| step.distance == distance) {
                Some(step) => (step.joined, step.closed) = (step.joined + 1, edges.coincident),
                None => steps.push(Step { distance, joined: 1, closed: edges.coincident }),
            }
        }
        Ok(Merging { coincident, steps, harm: None })
    }
}

/// The open edges between classes of vertices.
struct EdgesOfClasses {
    /// How many lie between two classes, the lower first.
    between: BTreeMap<[u32; 2], u64>,
    /// The classes that open edges join each class to.
    beside: Vec<Vec<u32>>,
    /// How many coincide with another.
    coincident: u64,
}

impl EdgesOfClasses {
    fn of(open: &OpenEdges) -> Self {
        let mut beside = vec![Vec::new(); open.vertex_count()];
        let mut edges = EdgesOfClasses { between: BTreeMap::new(), beside: Vec::new(), coincident: 0 };
        for &[one, other] in open.edges() {
            beside[one as usize].push(other);
            beside[other as usize].push(one);
            edges.add([one, other], 1);
        }
        edges.beside = beside;
        edges
    }

    /// Replaces a class by the one that it is joined to.
    fn join(&mut self, kept: u32, gone: u32) {
        let mut moved = std::mem::take(&mut self.beside[gone as usize]);
        moved.sort_unstable();
        moved.dedup();
        for &other in &moved {
            let count = self.between.remove(&sorted([gone, other])).unwrap_or_default();
            self.coincident -= coincident(count);
            self.add([kept, other], count);
            self.beside[other as usize].push(kept);
        }
        self.beside[kept as usize].extend(moved);
    }

    fn add(&mut self, ends: [u32; 2], count: u64) {
        let between = self.between.entry(sorted(ends)).or_insert(0);
        self.coincident -= coincident(*between);
        *between += count;
        self.coincident += coincident(*between);
    }
}

/// How many of so many edges at one place coincide with another.
fn coincident(count: u64) -> u64 {
    if count >= 2 { count } else { 0 }
}

fn sorted([one, other]: [u32; 2]) -> [u32; 2] {
    [one.min(other), one.max(other)]
}
