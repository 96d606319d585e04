//! What the command line says of what fails a run.

use clap::Args;
use meshmend::{Criterion, Failing, Gate, Rules};

use crate::console::Console;
use crate::failure::{Failure, Status};

/// What fails a run that writes a file.
#[derive(Clone, Debug, Default, Args)]
pub(crate) struct GateWords {
    /// End with status 1 if there are any of these: kinds of defect that are left, loss, loss:KIND, removed faces, changed,
    /// or anything that is left
    #[arg(long, value_name = "KIND", value_delimiter = ',')]
    fail_on: Vec<String>,
    /// Write nothing if one of them is there
    #[arg(long)]
    strict: bool,
}

/// What a command can be failed on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Asks {
    /// What a mesh is.
    Defects,
    /// That, and what an output does not carry.
    DefectsAndLosses,
}

impl GateWords {
    /// The gate that they make, or else a plan.
    pub(crate) fn gate(&self, rules: Rules, planned: &[String]) -> Result<Gate, Failure> {
        let words = if self.fail_on.is_empty() { planned } else { &self.fail_on };
        let criteria: Result<Vec<_>, _> = words.iter().map(|word| criterion(rules, word)).collect();
        self.checked(Gate::new(criteria?))
    }

    /// The gate of a command that mends nothing.
    pub(crate) fn conversion(&self, rules: Rules) -> Result<Gate, Failure> {
        self.checked(gate_of(&self.fail_on, rules, Asks::DefectsAndLosses)?)
    }

    fn checked(&self, gate: Gate) -> Result<Gate, Failure> {
        if self.strict && gate.is_open() {
            return Err(Failure::usage("--strict needs --fail-on"));
        }
        Ok(gate)
    }

    /// Whether a file that fails is not written.
    pub(crate) fn withholds(&self, failing: &[Failing]) -> bool {
        self.strict && !failing.is_empty()
    }
}

/// The gate of a command that mends nothing: what only a repair or an output can be failed on is a mistake, not a gate that is
/// always open.
pub(crate) fn gate_of(words: &[String], rules: Rules, asks: Asks) -> Result<Gate, Failure> {
    let criteria = words.iter().map(|word| match (criterion(rules, word)?, asks) {
        (criterion @ Criterion::Defect(_), _) | (criterion @ Criterion::Loss(_), Asks::DefectsAndLosses) => {
            Ok(criterion)
        }
        (Criterion::Loss(_), Asks::Defects) => {
            Err(Failure::usage(format!("--fail-on {word} has no meaning here: nothing is written")))
        }
        _ => Err(Failure::usage(format!("--fail-on {word} has no meaning here: nothing is repaired"))),
    });
    criteria.collect::<Result<Vec<_>, _>>().map(Gate::new)
}

fn criterion(rules: Rules, word: &str) -> Result<Criterion, Failure> {
    Criterion::of(rules, word).map_err(|error| Failure::usage(error.to_string()))
}

/// The status of a file of which this fails the run, and says so.
pub(crate) fn judged(file: &str, failing: &[Failing], is_written: bool, console: &mut Console<'_>) -> Status {
    if failing.is_empty() {
        return Status::Done;
    }
    let told: Vec<String> = failing.iter().map(Failing::to_string).collect();
    let unwritten = if is_written { "" } else { "; nothing is written" };
    let message = format!("{file}: --fail-on {}{unwritten}", told.join(", "));
    console.complain(&Failure { status: Status::Failing, message });
    Status::Failing
}
