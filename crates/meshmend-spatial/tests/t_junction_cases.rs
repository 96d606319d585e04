//! The cases of T-junctions beside the workspace.

mod shared;

use meshmend_core::Watch;
use meshmend_spatial::{heal, t_junctions};
use serde_json::json;

#[test]
fn pairs_are_as_many_as_in_the_cases() {
    for (case, mesh) in shared::cases("t_junctions") {
        let within = case["options"]["within"].as_str().map_or(0.0, |within| within.parse().unwrap());
        let found = t_junctions(&mesh, within, &Watch::NOBODY).unwrap();
        assert_eq!(
            found.len() as u64,
            case["by_construction"]["pairs"].as_u64().unwrap(),
            "{}",
            case["file"]
        );
        assert!(found.iter().all(|junction| junction.distance <= within));
    }
}

#[test]
fn what_is_healed_is_as_in_the_cases() {
    for (case, mesh) in shared::cases("t_junctions") {
        let within = case["options"]["within"].as_str().map_or(0.0, |within| within.parse().unwrap());
        let healed = heal(&mesh, within, &Watch::NOBODY).unwrap();
        let mut inserted: Vec<[u32; 2]> = healed.insertions.iter().map(|i| [i.vertex.0, i.face.0]).collect();
        inserted.sort_unstable();
        let answer = json!({ "inserted": inserted, "left": healed.left.len() });
        for question in ["inserted", "left"] {
            for told in ["by_construction", "reference"] {
                let expected = &case[told][question];
                assert!(expected.is_null() || answer[question] == *expected, "{} {question}", case["file"]);
            }
        }
    }
}
