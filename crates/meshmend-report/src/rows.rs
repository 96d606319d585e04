//! Files of a batch as entries of a page: what their rows say, without the meshes.

use meshmend::report::{Row, RowFigures, RowStatus};
use meshmend::{DefectKind, Rules, Severity};
use serde_json::{Value, json};

use crate::Entry;
use crate::verdict::Verdict;

impl Entry {
    /// A file of a batch, by its row. The mesh is not in the page.
    pub fn of_row(row: &Row, rules: Rules) -> Self {
        let mut before = row.before.as_ref().map_or(Value::Null, figures);
        if before.is_object() {
            before["defects"] = defects(row, rules);
        }
        let row_alone = Row { report: None, ..row.clone() };
        let report = json!({
            "row": serde_json::to_value(row_alone).unwrap_or_default(),
            "before": before,
            "after": row.after.as_ref().map_or(Value::Null, figures),
        });
        let mut entry = Entry::without(&row.path, "");
        (entry.verdict, entry.command, entry.report) = (verdict(row), Some("batch"), report);
        entry
    }
}

/// The figures under the names that they have in reports.
fn figures(figures: &RowFigures) -> Value {
    let mut value = serde_json::to_value(figures).unwrap_or_default();
    value["euler_characteristic"] = figures.euler.into();
    value
}

fn defects(row: &Row, rules: Rules) -> Value {
    let severity = |code: &str| {
        let kind = rules.kinds().find(|kind| kind.code() == code);
        kind.map_or(Severity::Note, DefectKind::severity)
    };
    let group = |(code, count): (&String, &u64)| json!({"kind": code, "severity": severity(code), "count": count, "items": []});
    row.defects.iter().map(group).collect()
}

fn verdict(row: &Row) -> Verdict {
    let state = match row.status {
        RowStatus::Mended => "mended",
        RowStatus::Clean => "sound",
        RowStatus::Left => "partly-mended",
        RowStatus::Unreadable | RowStatus::Missing => "unread",
        _ => "failed",
    };
    let usual = match row.status {
        RowStatus::Mended => "Mended, and nothing is left.",
        RowStatus::Clean => "There was nothing to do.",
        RowStatus::Left => "Something is left of what was wrong.",
        _ => "It has no result.",
    };
    Verdict { state, sentence: row.message.clone().unwrap_or_else(|| usual.to_owned()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_says_how_it_ended_and_what_was_wrong() {
        let mut row = Row::of("a.obj");
        row.status = RowStatus::Left;
        row.defects = [("pinched-vertex".to_owned(), 2), ("boundary-edge".to_owned(), 5)].into();
        row.before = Some(RowFigures { faces: 7, euler: -2, ..RowFigures::default() });
        let entry = serde_json::to_value(Entry::of_row(&row, Rules::default())).unwrap();
        assert_eq!(
            (&entry["command"], &entry["verdict"]["state"]),
            (&"batch".into(), &"partly-mended".into())
        );
        let before = &entry["report"]["before"];
        assert_eq!((&before["faces"], &before["euler_characteristic"]), (&7.into(), &(-2).into()));
        let severities: Vec<&Value> =
            before["defects"].as_array().unwrap().iter().map(|group| &group["severity"]).collect();
        assert_eq!(severities, ["note", "defect"]);
        let lost = Row::of("b.obj").failed(RowStatus::Crashed, "it ended by signal 11");
        let lost = Entry::of_row(&lost, Rules::default());
        assert_eq!((lost.verdict(), lost.title().as_str()), ("it ended by signal 11", "b.obj"));
    }
}
