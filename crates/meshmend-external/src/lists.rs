//! What is wrong, counted, and the first of each kind.

use std::collections::BTreeMap;

use meshmend_core::{Defect, DefectKind};

use crate::lowest::Lowest;

/// How many defects of each kind there are, and the lowest of each.
#[derive(Debug)]
pub(crate) struct Lists {
    most: usize,
    of_kind: BTreeMap<DefectKind, Lowest<Defect>>,
}

impl Lists {
    /// Lists so many of a kind at most.
    pub(crate) fn new(most: usize) -> Self {
        Lists { most, of_kind: BTreeMap::new() }
    }

    pub(crate) fn add(&mut self, defect: Defect) {
        self.of_kind.entry(defect.kind).or_insert_with(|| Lowest::new(self.most)).add(defect);
    }

    /// Sets how many there are of a kind, and the first of them.
    pub(crate) fn set(&mut self, kind: DefectKind, count: u64, first: Vec<Defect>) {
        let mut lowest = Lowest::new(self.most);
        first.into_iter().for_each(|defect| lowest.add(defect));
        self.of_kind.insert(kind, lowest.counting(count));
    }

    pub(crate) fn count(&self, kind: DefectKind) -> u64 {
        self.of_kind.get(&kind).map_or(0, Lowest::count)
    }

    /// How many there are of each kind that occurs, and the first of them, ascending.
    pub(crate) fn into_kinds(self) -> BTreeMap<DefectKind, (u64, Vec<Defect>)> {
        let kinds = self.of_kind.into_iter().filter(|(_, lowest)| lowest.count() > 0);
        kinds.map(|(kind, lowest)| (kind, (lowest.count(), lowest.into_kept()))).collect()
    }
}
