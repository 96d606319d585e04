//! The cases of T-junctions beside the workspace.

mod shared;

use meshmend_spatial::t_junctions;

#[test]
fn pairs_are_as_many_as_in_the_cases() {
    for (case, mesh) in shared::cases("t_junctions") {
        let within = case["options"]["within"].as_str().map_or(0.0, |within| within.parse().unwrap());
        let found = t_junctions(&mesh, within);
        assert_eq!(
            found.len() as u64,
            case["by_construction"]["pairs"].as_u64().unwrap(),
            "{}",
            case["file"]
        );
        assert!(found.iter().all(|junction| junction.distance <= within));
    }
}
