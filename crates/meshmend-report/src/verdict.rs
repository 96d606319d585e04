//! What became of a mesh, in one sentence.

use meshmend::Severity;
use meshmend::mesh::counted;
use meshmend::report::{CheckDocument, RepairDocument};
use serde::Serialize;

/// What became of a mesh.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Verdict {
    /// `sound`, `defective`, `mended`, `partly-mended` or `unread`.
    pub(crate) state: &'static str,
    pub(crate) sentence: String,
}

impl Verdict {
    /// What a check found.
    pub(crate) fn of_check(document: &CheckDocument) -> Self {
        let (defects, notes) = (Count::of(document, Severity::Defect), Count::of(document, Severity::Note));
        if defects.count == 0 {
            let sentence = format!("Nothing is wrong with it{}.", notes.worth_knowing());
            return Verdict { state: "sound", sentence };
        }
        let sentence = format!("{} of {}.", defects.shown("defect"), counted(defects.kinds, "kind"));
        Verdict { state: "defective", sentence }
    }

    /// What a repair came to.
    pub(crate) fn of_repair(document: &RepairDocument) -> Self {
        let of = |check: &Option<CheckDocument>| {
            check.as_ref().map_or(Count { count: 0, kinds: 0 }, |check| Count::of(check, Severity::Defect))
        };
        let (before, after) = (of(&document.before), of(&document.after));
        let removed = match document.removed_faces.count {
            0 => "no face was removed".to_owned(),
            1 => "one face was removed".to_owned(),
            count => format!("{count} faces were removed"),
        };
        let (state, sentence) = match (before.count, after.count, document.changed) {
            (_, 0, false) => ("sound", "Nothing was wrong with it, and nothing was changed.".to_owned()),
            (0, 0, true) => ("sound", format!("Nothing was wrong with it; it was tidied, and {removed}.")),
            (_, 0, true) => {
                ("mended", format!("Mended: {} before, none left; {removed}.", before.shown("defect")))
            }
            (_, left, true) => (
                "partly-mended",
                format!("Mended in part: {} before, {left} left; {removed}.", before.shown("defect")),
            ),
            (was, left, false) if was == left => (
                "defective",
                format!("{}, none of them mended: nothing was changed.", counted(left, "defect")),
            ),
            (_, left, false) => (
                "defective",
                format!(
                    "{} before, {left} left, without a change to the file: it does not store which vertices are one.",
                    before.shown("defect")
                ),
            ),
        };
        Verdict { state, sentence }
    }
}

struct Count {
    count: u64,
    kinds: usize,
}

impl Count {
    fn of(document: &CheckDocument, severity: Severity) -> Self {
        let groups = document.defects.iter().filter(|group| group.severity == severity);
        let (count, kinds) = groups.fold((0, 0), |(count, kinds), group| (count + group.count, kinds + 1));
        Count { count, kinds }
    }

    fn shown(&self, one: &str) -> String {
        counted(self.count, one)
    }

    fn worth_knowing(&self) -> String {
        if self.count == 0 { String::new() } else { format!("; {} worth knowing", self.shown("thing")) }
    }
}
