//! The report on the repair of many files.

use std::collections::BTreeMap;

use serde::Serialize;

use super::{Row, RowStatus, SCHEMA};

/// What became of many files, in counts; each has a [`Row`] in the ledger.
#[derive(Clone, Debug, Serialize)]
pub struct BatchDocument {
    /// The number of the form of reports.
    pub schema: u32,
    /// How many files were listed.
    pub files: u64,
    /// How many of them were done by an earlier run.
    pub done_before: u64,
    /// How many are still to be done, as the run was stopped.
    pub to_do: u64,
    /// How many ended so, for each way to end.
    pub statuses: BTreeMap<&'static str, u64>,
    /// Where the rows are.
    pub ledger: String,
}

impl BatchDocument {
    /// The report on so many files, of which nothing is known yet.
    pub fn new(files: u64, ledger: impl Into<String>) -> Self {
        let statuses = RowStatus::ALL.iter().map(|status| (status.name(), 0)).collect();
        BatchDocument { schema: SCHEMA, files, done_before: 0, to_do: files, statuses, ledger: ledger.into() }
    }

    /// Counts a file.
    pub fn add(&mut self, row: &Row) {
        *self.statuses.entry(row.status.name()).or_insert(0) += 1;
        self.to_do = self.to_do.saturating_sub(1);
    }

    /// Counts a file that an earlier run has done.
    pub fn add_done_before(&mut self, row: &Row) {
        self.add(row);
        self.done_before += 1;
    }

    /// How many files have no result.
    pub fn failed(&self) -> u64 {
        let failures = RowStatus::ALL.iter().filter(|status| status.is_failure());
        failures.filter_map(|status| self.statuses.get(status.name())).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_file_is_counted_once_and_failures_are_those_without_a_result() {
        let mut batch = BatchDocument::new(4, "ledger.jsonl");
        for status in [RowStatus::Left, RowStatus::Crashed] {
            batch.add(&Row { status, ..Row::of("a") });
        }
        batch.add_done_before(&Row { status: RowStatus::Mended, ..Row::of("b") });
        assert_eq!((batch.failed(), batch.to_do, batch.done_before), (1, 1, 1));
        assert_eq!(batch.statuses.values().sum::<u64>(), 3);
    }
}
