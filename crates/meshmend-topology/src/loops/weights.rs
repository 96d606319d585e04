//! How long is an edge?
//!
//! Lengths are data: this crate knows no positions. A component in which some length is not a number from 0 on, or
//! whose lengths are too large to be added up, is measured in edges as a whole: lengths and counts can't be compared
//! with one another.

use std::borrow::Cow;

use meshmend_core::{Column, Connectivity, EdgeId};
use serde::Serialize;

use super::error::GeneratorError;
use super::surfaces::Surfaces;
use crate::ComponentId;

/// In what the loops of a component are measured.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Measure {
    /// The lengths of their edges.
    #[default]
    Length,
    /// The number of their edges.
    Hops,
}

/// The weight of each edge.
pub(super) struct Weights<'a> {
    pub(super) measures: Column<ComponentId, Measure>,
    /// Absent where every component is measured in edges.
    of_edge: Option<Cow<'a, Column<EdgeId, f64>>>,
}

impl<'a> Weights<'a> {
    pub(super) fn new<K: Connectivity>(
        kernel: &K,
        surfaces: &Surfaces,
        lengths: Option<&'a Column<EdgeId, f64>>,
    ) -> Result<Self, GeneratorError> {
        let count = surfaces.components.count();
        let Some(lengths) = lengths else {
            return Ok(Weights { measures: Column::filled(Measure::Hops, count), of_edge: None });
        };
        if lengths.len() != kernel.edge_count() {
            return Err(GeneratorError::Lengths { found: lengths.len(), expected: kernel.edge_count() });
        }
        let component = |edge| surfaces.components.of_vertex(kernel.edge_ends(edge)[0]);
        let mut sums = Column::filled(0.0, count);
        let measured = lengths.iter().flat_map(|(edge, &length)| component(edge).zip(Some(length)));
        for (component, length) in measured {
            sums[component] += if length >= 0.0 { length } else { f64::INFINITY };
        }
        // No loop is longer than three times all edges, and there are fewer loops than edges.
        let most = f64::MAX / (4.0 * lengths.len().max(1) as f64);
        let measures: Column<ComponentId, Measure> =
            sums.values().iter().map(|&s| if s <= most { Measure::Length } else { Measure::Hops }).collect();
        let mut of_edge = Cow::Borrowed(lengths);
        if measures.values().contains(&Measure::Hops) {
            let in_edges = |edge: &EdgeId| component(*edge).is_some_and(|c| measures[c] == Measure::Hops);
            let weights = of_edge.to_mut();
            kernel.edges().filter(in_edges).for_each(|edge| weights[edge] = 1.0);
        }
        Ok(Weights { measures, of_edge: Some(of_edge) })
    }

    #[inline]
    pub(super) fn of(&self, edge: EdgeId) -> f64 {
        match &self.of_edge {
            None => 1.0,
            Some(weights) => weights[edge],
        }
    }
}
