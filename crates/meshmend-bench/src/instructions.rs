//! Counts the instructions of operations, and compares them with those that were counted before.
//!
//! Instructions are the same on a busy machine as on a quiet one, so a change of a few parts in a hundred can be told.
//! They say nothing of memory that is slow to reach: times are still to be measured.

use std::fmt::Write as _;
use std::path::Path;
use std::process::{Command, Stdio};

use crate::failure::Failure;
use crate::inputs::{Folder, Order};
use crate::operations::{OPERATIONS, Operation};
use crate::rows::own_process;

/// On how many faces.
const FACES: usize = 100_000;
/// How many parts in a hundred more or less are worth a warning.
const WORTH_A_WARNING: u64 = 3;

/// The instructions of an operation, and what was counted before.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Count {
    pub(crate) operation: &'static str,
    pub(crate) now: u64,
    pub(crate) before: Option<u64>,
}

impl Count {
    /// The change as a part of what was before.
    fn change(&self) -> Option<f64> {
        self.before.map(|before| self.now as f64 / before as f64 - 1.0)
    }

    /// Whether it is to be looked into.
    pub(crate) fn is_worth_a_warning(&self) -> bool {
        self.before.is_some_and(|before| 100 * self.now.abs_diff(before) > WORTH_A_WARNING * before)
    }

    /// The line of a report.
    pub(crate) fn line(&self) -> String {
        let change = self.change().map_or("new".to_owned(), |change| format!("{:+.1} %", 100.0 * change));
        let warning = if self.is_worth_a_warning() { "  WARNING" } else { "" };
        format!("{:<16} {:>14} {change:>9}{warning}", self.operation, self.now)
    }
}

/// Whether valgrind is there.
pub(crate) fn can_count() -> bool {
    let probe =
        Command::new("valgrind").arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
    probe.is_ok_and(|status| status.success())
}

/// Counts the instructions of every operation beyond reading its input, and tells of each when it is counted.
pub(crate) fn count_all(
    before: &[(String, u64)],
    folder: &Folder,
    mut tell: impl FnMut(&Count),
) -> Result<Vec<Count>, Failure> {
    let counted = OPERATIONS.iter().map(|operation| {
        let [all, preparation] = [count(operation, "all", folder)?, count(operation, "preparation", folder)?];
        let earlier = before.iter().find(|(name, _)| name == operation.name);
        let count = Count {
            operation: operation.name,
            now: all.saturating_sub(preparation),
            before: earlier.map(|&(_, count)| count),
        };
        tell(&count);
        Ok(count)
    });
    counted.collect()
}

fn count(operation: &Operation, part: &str, folder: &Folder) -> Result<u64, Failure> {
    let file = folder.file(&operation.input(Order::Mesh, FACES), operation.form())?;
    let program = own_process(1)?;
    let mut valgrind = Command::new("valgrind");
    valgrind.args(["--tool=cachegrind", "--cache-sim=no", "--cachegrind-out-file=/dev/null"]);
    valgrind.arg(program.get_program()).args(["once", operation.name]).arg(&file).arg(folder.path());
    valgrind.args(["--part", part]).env("RAYON_NUM_THREADS", "1");
    let output = valgrind.output().map_err(|error| Failure::io(Path::new("valgrind"), error))?;
    let errors = String::from_utf8_lossy(&output.stderr);
    if !output.status.success() {
        return Err(Failure::Process { what: operation.name.to_owned(), errors: errors.into_owned() });
    }
    counted(&errors).ok_or_else(|| Failure::NotCounted(operation.name.to_owned()))
}

/// The count in `==7== I   refs:      1,234,567`.
fn counted(errors: &str) -> Option<u64> {
    let line = errors.lines().find(|line| line.contains("refs:"))?;
    let digits: String = line.rsplit(':').next()?.chars().filter(char::is_ascii_digit).collect();
    digits.parse().ok()
}

/// The counts in a file: an operation and its count a line, after `#` nothing.
pub(crate) fn read_counts(path: &Path) -> Result<Vec<(String, u64)>, Failure> {
    let text = std::fs::read_to_string(path).map_err(|error| Failure::io(path, error))?;
    let lines = text.lines().zip(1..).filter(|(line, _)| !line.is_empty() && !line.starts_with('#'));
    let pair = |(line, number): (&str, usize)| {
        let words = line.split_once(' ');
        words
            .and_then(|(name, count)| Some((name.to_owned(), count.trim().parse().ok()?)))
            .ok_or_else(|| Failure::NotACount { path: path.to_owned(), line: number })
    };
    lines.map(pair).collect()
}

/// Writes the counts to a file.
pub(crate) fn write_counts(path: &Path, counts: &[Count]) -> Result<(), Failure> {
    let mut text = format!(
        "# Instructions of each operation at {FACES} faces in mesh order on one thread.\n\
         # `bench/instructions` compares, `bench/instructions --update` writes.\n"
    );
    for Count { operation, now, .. } in counts {
        // Writing to a text can't fail.
        let _ = writeln!(text, "{operation:<16} {now:>14}");
    }
    std::fs::write(path, text).map_err(|error| Failure::io(path, error))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_count_is_read_from_what_valgrind_says() {
        let errors = "==7== Command: x\n==7== \n==7== I   refs:      1,234,567\n";
        assert_eq!(counted(errors), Some(1_234_567));
        assert_eq!(counted("==7== nothing"), None);
    }

    #[test]
    fn a_change_of_more_than_three_in_a_hundred_is_worth_a_warning() {
        let count = |now, before| Count { operation: "weld", now, before };
        assert!(!count(1030, Some(1000)).is_worth_a_warning());
        assert!(count(1031, Some(1000)).is_worth_a_warning());
        assert!(count(960, Some(1000)).is_worth_a_warning());
        assert!(!count(1, None).is_worth_a_warning());
        assert!(count(1031, Some(1000)).line().ends_with("+3.1 %  WARNING"));
    }

    #[test]
    fn counts_are_read_as_they_were_written() {
        let folder = Folder::temporary().unwrap();
        let path = folder.path().join("counts.txt");
        write_counts(&path, &[Count { operation: "weld", now: 12, before: None }]).unwrap();
        assert_eq!(read_counts(&path).unwrap(), [("weld".to_owned(), 12)]);
        std::fs::write(&path, "weld many\n").unwrap();
        assert!(matches!(read_counts(&path), Err(Failure::NotACount { line: 1, .. })));
    }
}
