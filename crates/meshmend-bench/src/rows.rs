//! One row of a report for each operation, order, number of threads and size, measured in a process of its own.

use std::path::Path;
use std::process::Command;

use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::failure::Failure;
use crate::inputs::{Folder, Order};
use crate::measure::Measured;
use crate::operations::{Figures, Operation};

/// What is measured of each operation.
#[derive(Clone, Debug)]
pub(crate) struct Conditions {
    /// How many faces, each in turn.
    pub(crate) faces: Vec<usize>,
    pub(crate) orders: Vec<Order>,
    pub(crate) threads: Vec<usize>,
    pub(crate) runs: usize,
}

/// What was measured of one operation under one condition.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Row {
    pub(crate) operation: &'static str,
    pub(crate) order: &'static str,
    pub(crate) threads: usize,
    /// How many faces were asked for.
    pub(crate) size: usize,
    /// How many the input has.
    pub(crate) faces: u64,
    pub(crate) runs: usize,
    /// Seconds.
    pub(crate) cpu: Spread,
    /// Seconds.
    pub(crate) wall: Spread,
    /// Million input faces a second of processor time or time by the clock, whichever is less, in the best run.
    pub(crate) megafaces: f64,
    /// Bytes at the peak for each input face.
    pub(crate) bytes_a_face: f64,
    /// How many times as long it takes as with a tenth of the faces, if that was measured too.
    pub(crate) growth: Option<f64>,
    /// What came out.
    pub(crate) figures: Figures,
    /// What should have.
    pub(crate) expected: Figures,
}

/// The least and the middle one of some times.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub(crate) struct Spread {
    pub(crate) best: f64,
    pub(crate) median: f64,
}

impl Row {
    /// Whether what came out is right.
    pub(crate) fn is_right(&self) -> bool {
        self.figures == self.expected
    }

    fn time(&self) -> f64 {
        self.cpu.best.min(self.wall.best)
    }
}

impl Spread {
    /// Of the times of some runs; of none it is 0.
    fn of(mut times: Vec<f64>) -> Self {
        times.sort_by(f64::total_cmp);
        let at = |place: usize| times.get(place).copied().unwrap_or(0.0);
        Spread { best: at(0), median: at(times.len() / 2) }
    }
}

/// Measures operations under all conditions, and tells of each row when it is there.
pub(crate) fn rows(
    operations: &[&'static Operation],
    conditions: &Conditions,
    folder: &Folder,
    mut tell: impl FnMut(&Row),
) -> Result<Vec<Row>, Failure> {
    let mut rows = Vec::new();
    for &operation in operations {
        for &order in &conditions.orders {
            for &threads in &conditions.threads {
                for &size in &conditions.faces {
                    let mut row = row(operation, order, threads, size, conditions.runs, folder)?;
                    row.growth = growth(&row, &rows);
                    tell(&row);
                    rows.push(row);
                }
            }
        }
    }
    Ok(rows)
}

fn growth(row: &Row, earlier: &[Row]) -> Option<f64> {
    let alike = |other: &&Row| {
        (other.operation, other.order, other.threads) == (row.operation, row.order, row.threads)
            && 10 * other.size == row.size
    };
    earlier.iter().find(alike).map(|less| row.time() / less.time())
}

fn row(
    operation: &'static Operation,
    order: Order,
    threads: usize,
    size: usize,
    runs: usize,
    folder: &Folder,
) -> Result<Row, Failure> {
    let input = operation.input(order, size);
    let file = folder.file(&input, operation.form())?;
    let mut child = own_process(threads)?;
    child.args(["measure", operation.name]).arg(&file).arg(folder.path()).args(["--runs", &runs.to_string()]);
    let Measured { cpu, wall, peak, figures } = told(child, operation.name)?;
    let faces = input.known().faces;
    let (cpu, wall) = (Spread::of(cpu), Spread::of(wall));
    Ok(Row {
        operation: operation.name,
        order: order.name(),
        threads,
        size,
        faces,
        runs,
        cpu,
        wall,
        megafaces: faces as f64 / 1e6 / cpu.best.min(wall.best),
        bytes_a_face: peak as f64 / faces as f64,
        growth: None,
        figures,
        expected: operation.expected(&input),
    })
}

/// This program, to be started once more with as many threads.
pub(crate) fn own_process(threads: usize) -> Result<Command, Failure> {
    let program = std::env::current_exe().map_err(|error| Failure::io(Path::new("meshmend-bench"), error))?;
    let mut command = Command::new(program);
    command.env("RAYON_NUM_THREADS", threads.to_string());
    Ok(command)
}

/// What a process prints as JSON.
pub(crate) fn told<T: DeserializeOwned>(mut command: Command, what: &str) -> Result<T, Failure> {
    let output = command.output().map_err(|error| Failure::io(Path::new(command.get_program()), error))?;
    if !output.status.success() {
        let errors = String::from_utf8_lossy(&output.stderr).into_owned();
        return Err(Failure::Process { what: what.to_owned(), errors });
    }
    serde_json::from_slice(&output.stdout).map_err(|error| Failure::NotFigures(what.to_owned(), error))
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    pub(crate) fn a_row(size: usize, seconds: f64) -> Row {
        let time = Spread::of(vec![seconds, 2.0 * seconds, 1.5 * seconds]);
        Row {
            operation: "weld",
            order: "mesh",
            threads: 1,
            size,
            faces: size as u64,
            runs: 3,
            cpu: time,
            wall: time,
            megafaces: size as f64 / 1e6 / seconds,
            bytes_a_face: 30.0,
            growth: None,
            figures: Figures::default(),
            expected: Figures::default(),
        }
    }

    #[test]
    fn the_best_and_the_middle_run_are_told() {
        assert_eq!(a_row(1, 2.0).cpu, Spread { best: 2.0, median: 3.0 });
    }

    #[test]
    fn growth_is_between_sizes_of_which_one_is_ten_times_the_other() {
        let earlier = [a_row(10, 1.0), a_row(50, 1.0), Row { order: "shuffled", ..a_row(100, 1.0) }];
        assert_eq!(growth(&a_row(100, 11.0), &earlier), Some(11.0));
        assert_eq!(growth(&a_row(1000, 11.0), &earlier), None);
    }
}
