//! The trees of the vertices from the roots that were asked for, and what they leave for the trees of the faces.

use std::num::NonZeroU32;

use meshmend_core::{Cancelled, Column, Connectivity, EdgeId, VertexId, Watch};

use super::STEP;
use super::co_tree::{CoTree, Dual};
use super::error::GeneratorError;
use super::forest::Forest;
use super::options::GeneratorOptions;
use super::roots::{RootChoice, Roots, lowest_roots, roots_with, spread_roots};
use super::surfaces::Surfaces;
use super::weights::Weights;
use crate::ComponentId;

/// Where trees grow: a mesh with what is known of it, and the length of its edges.
pub(super) struct Ground<'a, K> {
    pub(super) kernel: &'a K,
    pub(super) surfaces: &'a Surfaces,
    pub(super) dual: Dual<'a, K>,
    pub(super) weights: Weights<'a>,
    pub(super) watch: &'a Watch,
    co_tree: CoTree,
}

/// The trees of the vertices of all surfaces.
pub(super) struct Trees {
    pub(super) roots: RootChoice,
    pub(super) forest: Forest,
    /// The other edges, in the order in which they are offered to the tree of the faces.
    pub(super) order: Vec<EdgeId>,
}

impl<'a, K: Connectivity> Ground<'a, K> {
    pub(super) fn new(
        kernel: &'a K,
        surfaces: &'a Surfaces,
        options: &GeneratorOptions<'a>,
    ) -> Result<Self, GeneratorError> {
        let (watch, co_tree) = (options.watch(), options.co_tree);
        watch.look(STEP, 0, 0)?;
        let weights = Weights::new(kernel, surfaces, options.lengths)?;
        Ok(Ground { kernel, surfaces, dual: Dual::new(kernel, surfaces), weights, watch, co_tree })
    }

    /// *Cost*: O(n log n) for each root that is tried.
    pub(super) fn trees(&self, roots: Roots) -> Result<Trees, GeneratorError> {
        let roots = match roots {
            Roots::Lowest => lowest_roots(self.surfaces),
            Roots::At(vertex) => roots_with(self.kernel, self.surfaces, vertex)?,
            Roots::Best(count) => self.best_roots(count)?,
        };
        Ok(self.trees_from(roots)?)
    }

    fn trees_from(&self, roots: RootChoice) -> Result<Trees, Cancelled> {
        let starts: Vec<VertexId> = roots.values().iter().copied().flatten().collect();
        let forest = Forest::grow(self.kernel, &self.weights, &starts, self.watch)?;
        self.watch.look(STEP, 0, 0)?;
        let order = self.offered(&forest);
        self.watch.look(STEP, 0, 0)?;
        Ok(Trees { roots, forest, order })
    }

    /// The edges of surfaces that are in no tree of the vertices, in the order in which the tree of the faces is offered
    /// them.
    ///
    /// *Cost*: one pass, or a sort.
    fn offered(&self, forest: &Forest) -> Vec<EdgeId> {
        let is_outside = |&edge: &EdgeId| {
            self.surfaces.of_edge(self.kernel, edge).is_some()
                && !forest.has_edge(edge, self.kernel.edge_ends(edge))
        };
        let outside = self.kernel.edges().filter(is_outside);
        if self.co_tree == CoTree::Lowest {
            return outside.collect();
        }
        // Non-negative doubles are ordered as their bits are.
        let shortness = |edge| !self.based_length(forest, edge).to_bits();
        let mut keyed: Vec<(u64, EdgeId)> = outside.map(|edge| (shortness(edge), edge)).collect();
        keyed.sort_unstable();
        keyed.into_iter().map(|(_, edge)| edge).collect()
    }

    /// Of some roots of each surface the one whose loops are the shortest together.
    fn best_roots(&self, count: NonZeroU32) -> Result<RootChoice, Cancelled> {
        let surfaces = self.surfaces;
        let most = surfaces.facts.values().iter().map(|facts| facts.vertices).max();
        let count = most.and_then(NonZeroU32::new).map_or(count, |most| count.min(most));
        let mut roots: RootChoice = Column::filled(None, surfaces.components.count());
        let mut shortest = Column::filled(f64::INFINITY, surfaces.components.count());
        for place in 0..count.get() {
            let trees = self.trees_from(spread_roots(self.kernel, surfaces, place, count))?;
            let lengths = self.system_lengths(&trees)?;
            for component in surfaces.components.ids() {
                if lengths[component] < shortest[component] {
                    shortest[component] = lengths[component];
                    roots[component] = trees.roots[component];
                }
            }
        }
        Ok(roots)
    }

    /// How long the loops of each component are together.
    fn system_lengths(&self, trees: &Trees) -> Result<Column<ComponentId, f64>, Cancelled> {
        let mut lengths = Column::filled(0.0, self.surfaces.components.count());
        let [_, left_over] = self.dual.split(&trees.order, self.watch)?;
        for edge in left_over {
            if let Some(component) = self.surfaces.of_edge(self.kernel, edge) {
                lengths[component] += self.based_length(&trees.forest, edge);
            }
        }
        Ok(lengths)
    }

    /// How long the loop of an edge is, from the root to one end of it, across, and back to the root.
    pub(super) fn based_length(&self, forest: &Forest, edge: EdgeId) -> f64 {
        let [low, high] = self.kernel.edge_ends(edge);
        forest.distance(low) + forest.distance(high) + self.weights.of(edge)
    }
}
