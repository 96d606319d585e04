//! The ledger of a batch: a row a line, only ever added to.

use std::collections::BTreeMap;
use std::fs::{File, OpenOptions};
use std::io::{self, BufRead, BufReader, Write};
use std::path::Path;

use meshmend::report::Row;

use crate::failure::Failure;

/// A ledger that is open for one run; another run with it waits for nobody and ends.
pub(crate) struct Ledger {
    file: File,
    name: String,
}

/// The rows that a ledger has.
#[derive(Default)]
pub(crate) struct Rows {
    /// By path, the last one of each.
    pub(crate) by_path: BTreeMap<String, Row>,
    /// How many lines are no row: the last may have been cut off by the end of a run.
    pub(crate) broken: u64,
}

impl Ledger {
    /// Opens a ledger, and reads what it has.
    pub(crate) fn open(path: &Path) -> Result<(Self, Rows), Failure> {
        let name = path.display().to_string();
        let failed = |error: io::Error| Failure::unwritable(&name, error);
        let mut file = OpenOptions::new().create(true).read(true).append(true).open(path).map_err(failed)?;
        if file.try_lock().is_err() {
            return Err(Failure::unwritable(&name, "another run has the ledger"));
        }
        let (mut rows, mut line, mut reader) = (Rows::default(), Vec::new(), BufReader::new(&file));
        let mut is_torn = false;
        while reader.read_until(b'\n', &mut line).map_err(failed)? > 0 {
            is_torn = line.last() != Some(&b'\n');
            match serde_json::from_slice::<Row>(&line) {
                Ok(row) => drop(rows.by_path.insert(row.path.clone(), row)),
                Err(_) => rows.broken += 1,
            }
            line.clear();
        }
        drop(reader);
        if is_torn {
            file.write_all(b"\n").map_err(failed)?;
        }
        Ok((Ledger { file, name }, rows))
    }

    /// Adds a row, by one write.
    pub(crate) fn add(&mut self, row: &Row) -> Result<(), Failure> {
        let line = crate::commands::json_line(row)?;
        self.file.write_all(line.as_bytes()).map_err(|error| Failure::unwritable(&self.name, error))
    }
}
