//! Best fills beside those of the executable specification.
//!
//! `fills.jsonl` has a hole a line: holes of 3 to 14 sides in bumpy and in flat tori, with the number of admissible fills and
//! the best cost (triangles of zero area, greatest fold, area), or for more than 9 sides the least greatest fold alone.
//! `MESHMEND_FILLS` names a file of more such lines.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test stops where it fails")]

use meshmend_core::VertexId;
use meshmend_spatial::{FillBy, Opening, best_fill};
use serde_json::Value;

#[test]
fn fills_are_those_of_the_specification() {
    let more = std::env::var("MESHMEND_FILLS").ok().map(|path| std::fs::read_to_string(path).unwrap());
    let text = include_str!("fills.jsonl");
    let lines = text.lines().chain(more.iter().flat_map(|more| more.lines()));
    let wrong: Vec<String> =
        lines.filter_map(|line| difference(&serde_json::from_str(line).unwrap())).collect();
    assert!(wrong.is_empty(), "{} differ:\n{}", wrong.len(), wrong[..wrong.len().min(5)].join("\n"));
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
}

fn points(value: &Value) -> Vec<[f64; 3]> {
    value.as_array().unwrap().iter().map(|point| numbers(point).try_into().unwrap()).collect()
}

/// In what the fill of a hole differs from what it should be, if it does.
fn difference(hole: &Value) -> Option<String> {
    let vertices: Vec<VertexId> =
        numbers(&hole["vertices"]).into_iter().map(|vertex| VertexId(vertex as u32)).collect();
    let (points, beside) = (points(&hole["points"]), points(&hole["beside"]));
    let joined: Vec<Vec<f64>> = hole["joined"].as_array().unwrap().iter().map(numbers).collect();
    let is_joined = |a: usize, b: usize| joined.contains(&vec![a.min(b) as f64, a.max(b) as f64]);
    let opening = Opening {
        points: &points,
        vertices: &vertices,
        beside: &beside,
        is_joined: &is_joined,
        is_there: &|_| false,
    };
    let found = best_fill(&opening, FillBy::Fold).map(|fill| fill.cost);
    let is_same = if let Some(fold) = hole["fold"].as_f64() {
        found.is_some_and(|cost| cost.zero_area > 0 || (cost.fold - fold).abs() < 1e-9)
    } else if hole["best"].is_null() {
        found.is_none()
    } else {
        let best = numbers(&hole["best"]);
        found.is_some_and(|cost| {
            cost.zero_area as f64 == best[0]
                && (cost.fold - best[1]).abs() < 1e-9
                && (cost.area - best[2]).abs() <= 1e-9 * best[2]
        })
    };
    (!is_same).then(|| format!("{found:?} in {hole}"))
}
