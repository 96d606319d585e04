//! The cases of nested components beside the workspace.

mod shared;

use meshmend_spatial::{NestingState, Surface, nesting};
use serde_json::json;

#[test]
fn components_are_nested_as_in_the_cases() {
    for (case, mesh) in shared::cases("nesting") {
        let found = nesting(&Surface::of(&mesh).unwrap()).unwrap().components;
        let states: Vec<_> = found.iter().map(|part| part.state.map(NestingState::name)).collect();
        let depths: Vec<_> = found.iter().map(|part| part.depth).collect();
        let answer = json!({ "states": states, "depths": depths });
        for (question, expected) in case["by_construction"].as_object().unwrap() {
            if question != "internal" {
                assert_eq!(answer[question], *expected, "{}", case["file"]);
            }
        }
    }
}
