//! What is known of each component, gathered in any order.
//!
//! Facts of components are added up in runs and spilled by ranges of components, as there may be as many as faces.

use std::collections::BTreeMap;

use meshmend_core::VertexId;
use meshmend_topology::{ComponentFacts, ComponentKind};

use crate::budget::Budget;
use crate::error::ExternalError;
use crate::spill::Spill;

/// Facts of components on their way to their sums.
pub(crate) struct Tally {
    spill: Spill,
    /// How many components a part has.
    range: u32,
    count: u32,
    /// The component whose facts come now, and its lowest vertex so far.
    current: Option<(u32, VertexId)>,
    facts: ComponentFacts,
}

/// How many numbers a record has.
const RECORD: usize = 7;

impl Tally {
    /// For so many components, some of which take so many bytes at a time.
    pub(crate) fn new(budget: &Budget<'_>, count: u32, room: u64) -> Result<Self, ExternalError> {
        let bytes = u64::from(count) * size_of::<(ComponentFacts, VertexId)>() as u64;
        let parts = budget.parts.unwrap_or(bytes.div_ceil(room / 2) as usize).max(1);
        let range = count.div_ceil(parts as u32).max(1);
        let spill = budget.spill(count.div_ceil(range).max(1) as usize)?;
        Ok(Tally { spill, range, count, current: None, facts: ComponentFacts::NOTHING })
    }

    /// The facts of a component so far, to add what a vertex of it, or a loop through that, adds.
    #[inline]
    pub(crate) fn at(
        &mut self,
        component: u32,
        vertex: VertexId,
    ) -> Result<&mut ComponentFacts, ExternalError> {
        match self.current {
            Some((current, lowest)) if current == component => {
                self.current = Some((current, lowest.min(vertex)));
            }
            _ => {
                self.flush()?;
                self.current = Some((component, vertex));
            }
        }
        Ok(&mut self.facts)
    }

    fn flush(&mut self) -> Result<(), ExternalError> {
        let Some((component, vertex)) = self.current.take() else { return Ok(()) };
        let ComponentFacts { vertices, edges, faces, is_orientable, is_closed, is_manifold, loops } =
            std::mem::replace(&mut self.facts, ComponentFacts::NOTHING);
        let flags = u32::from(is_orientable) | u32::from(is_closed) << 1 | u32::from(is_manifold) << 2;
        let record = [component, vertex.0, vertices, edges, faces, loops, flags];
        self.spill.push((component / self.range) as usize, &record)
    }

    /// The components by kind, ordered by the lowest vertex of each kind, and how many bytes were written to disk.
    pub(crate) fn kinds(mut self) -> Result<(Vec<ComponentKind>, u64), ExternalError> {
        self.flush()?;
        let mut kinds: BTreeMap<ComponentFacts, (u64, VertexId)> = BTreeMap::new();
        for part in 0..self.spill.part_count() {
            let first = part as u32 * self.range;
            let count = self.count.saturating_sub(first).min(self.range);
            let mut all = vec![(ComponentFacts::NOTHING, VertexId(u32::MAX)); count as usize];
            // A record may lie in two blocks.
            let mut begun = Vec::new();
            self.spill.read(part, |numbers| {
                begun.extend_from_slice(numbers);
                let (records, rest) = begun.as_chunks::<RECORD>();
                records.iter().for_each(|record| add(record, &mut all[(record[0] - first) as usize]));
                begun = rest.to_vec();
                Ok(())
            })?;
            for (facts, lowest) in all {
                let kind = kinds.entry(facts.row()).or_insert((0, lowest));
                *kind = (kind.0 + 1, kind.1.min(lowest));
            }
        }
        let kind = |(facts, (count, first))| ComponentKind::of(facts, count, first);
        let mut kinds: Vec<ComponentKind> = kinds.into_iter().map(kind).collect();
        kinds.sort_unstable_by_key(|kind| kind.first_vertex);
        Ok((kinds, self.spill.written()))
    }
}

/// Adds a record to the facts of its component.
fn add(record: &[u32; RECORD], (facts, lowest): &mut (ComponentFacts, VertexId)) {
    let [_, vertex, vertices, edges, faces, loops, flags] = *record;
    *lowest = (*lowest).min(VertexId(vertex));
    facts.vertices += vertices;
    facts.edges += edges;
    facts.faces += faces;
    facts.loops += loops;
    facts.is_orientable &= flags & 1 != 0;
    facts.is_closed &= flags & 2 != 0;
    facts.is_manifold &= flags & 4 != 0;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn facts_add_up_in_any_order_and_any_number_of_parts() {
        let folder = std::env::temp_dir();
        let mut expected = None;
        for parts in [1, 2, 5] {
            let budget = Budget { memory: 1 << 16, folder: &folder, parts: Some(parts) };
            let mut tally = Tally::new(&budget, 4, 1 << 20).unwrap();
            for (component, vertex) in [(2, 9), (0, 0), (2, 7), (1, 3), (1, 2), (3, 11), (0, 1)] {
                let facts = tally.at(component, VertexId(vertex)).unwrap();
                facts.vertices += 1;
                facts.is_closed &= vertex != 3;
            }
            let (kinds, _) = tally.kinds().unwrap();
            let rows: Vec<_> =
                kinds.iter().map(|k| (k.count, k.vertices, k.closed, k.first_vertex.0)).collect();
            assert_eq!(rows, [(2, 2, true, 0), (1, 2, false, 2), (1, 1, true, 11)]);
            assert_eq!(expected.get_or_insert(rows.clone()), &rows);
        }
    }
}
