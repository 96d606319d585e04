//! A file that is repaired twice, and what comes of it.

use std::path::Path;

use meshmend_cli::{Program, Status};
use meshmend_kernels::KernelKind;
use meshmend_tests::in_process;
use meshmend_tests::scratch::Scratch;
use serde_json::Value;

/// What a case came to.
#[derive(Debug, PartialEq)]
pub(crate) enum Outcome {
    /// Nothing changed the second time.
    Right,
    /// A policy gave up, or no face was left.
    Refused,
    /// What is wrong.
    Wrong(String),
}

/// What is asked of a repair.
pub(crate) struct Asked {
    pub(crate) output: &'static str,
    pub(crate) options: Vec<&'static str>,
}

impl Asked {
    /// What becomes of a file, and where asked for whether that is the same everywhere.
    pub(crate) fn outcome(&self, stored: &Path, is_everywhere: bool) -> Outcome {
        let scratch = Scratch::new();
        let at = |name: &str| scratch.path().join(format!("{name}.{}", self.output));
        let (once, report) = match self.repair(stored, &at("once"), &[]) {
            Ok(repaired) => repaired,
            Err((Status::Refused, _)) => return Outcome::Refused,
            Err((_, complaint)) if complaint.contains("can't be resolved") => return Outcome::Refused,
            Err((_, complaint)) => return Outcome::Wrong(complaint),
        };
        if let Some(broken) = self.broken_postcondition(&report) {
            return Outcome::Wrong(broken);
        }
        match self.repair(&at("once"), &at("twice"), &[]) {
            Ok((twice, _)) if twice != once => return Outcome::Wrong("the second output differs".to_owned()),
            Ok((_, report)) => {
                if let Some(changed) = told_changes(&report) {
                    return Outcome::Wrong(format!(
                        "the second report says that something changed: {changed}"
                    ));
                }
            }
            Err((_, complaint)) => return Outcome::Wrong(format!("the second time: {complaint}")),
        }
        if is_everywhere { self.everywhere(stored, &at("elsewhere"), &once) } else { Outcome::Right }
    }

    /// The same on other kernels, and with other numbers of threads.
    pub(crate) fn everywhere(&self, stored: &Path, target: &Path, expected: &[u8]) -> Outcome {
        let threads = ["1", "2", "8"].map(|count| ["--threads", count]);
        let kernels: Vec<_> = KernelKind::ALL.iter().skip(1).map(|kind| ["--kernel", kind.name()]).collect();
        for choice in threads.iter().chain(&kernels) {
            match self.repair(stored, target, choice) {
                Ok((bytes, _)) if bytes != expected => {
                    return Outcome::Wrong(format!("{choice:?} gives another mesh"));
                }
                Err((status, complaint)) if status != Status::Refused => {
                    return Outcome::Wrong(format!("{choice:?}: {complaint}"));
                }
                _ => {}
            }
        }
        Outcome::Right
    }

    /// The bytes that a repair writes, and its report; or how it ended, and its complaint.
    pub(crate) fn repair(
        &self,
        from: &Path,
        to: &Path,
        further: &[&str],
    ) -> Result<(Vec<u8>, Value), (Status, String)> {
        let mut words: Vec<&str> = vec!["repair", from.to_str().unwrap(), "-o", to.to_str().unwrap()];
        words.extend(["--json", "--limit", "3"]);
        words.extend(&self.options);
        words.extend(further);
        let (status, out, errors) = in_process::run(Program::default(), &words);
        if status != Status::Done {
            return Err((status, errors));
        }
        Ok((std::fs::read(to).unwrap(), serde_json::from_str(&out).unwrap()))
    }

    /// What the report on the result says that it must not.
    pub(crate) fn broken_postcondition(&self, report: &Value) -> Option<String> {
        let is_off = |option: &str| self.options.windows(2).any(|two| two == [option, "off"]);
        let after = &report["after"];
        let topology = if after["topology"].is_object() { &after["topology"] } else { after };
        let clashes = topology["inconsistent_edges"].as_u64().unwrap_or(0);
        let is_orientable = topology["orientable"].as_bool().unwrap_or(false);
        // A face that repeats another one and differs from it is taken apart from it by `split`, which may be off.
        let passes = report["passes"].as_array().unwrap();
        let has_copies = passes.iter().any(|pass| pass["left"]["differing-face"].is_object());
        (!is_off("--orient") && !is_off("--clean") && is_orientable && !has_copies && clashes > 0)
            .then(|| format!("{clashes} inconsistent edges in an orientable mesh"))
    }
}

/// What a report says that was changed.
pub(crate) fn told_changes(report: &Value) -> Option<String> {
    let passes = report["passes"].as_array().unwrap();
    let changing: Vec<&Value> =
        passes.iter().filter(|pass| pass["changed"] != false).map(|pass| &pass["pass"]).collect();
    let lists = ["removed_faces", "flipped_faces", "created_vertices"];
    let counts: Vec<&str> = lists.into_iter().filter(|list| report[list]["count"] != 0).collect();
    (!changing.is_empty() || !counts.is_empty() || report["changed"] != false)
        .then(|| format!("{changing:?} {counts:?} {}", report["changed"]))
}
