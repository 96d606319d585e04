//! What the page knows of each kind of defect: what `explain` says.

use std::collections::BTreeMap;

use meshmend::{Rules, Severity};
use serde::Serialize;

/// What is said of a kind of defect.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct KindData {
    title: &'static str,
    severity: Severity,
    explanation: &'static str,
}

/// What is said of each kind, by its code.
pub(crate) fn kinds(rules: Rules) -> BTreeMap<&'static str, KindData> {
    let data = |kind: meshmend::DefectKind| KindData {
        title: kind.title(),
        severity: kind.severity(),
        explanation: kind.explanation(),
    };
    rules.kinds().map(|kind| (kind.code(), data(kind))).collect()
}
