//! The cases of thin faces beside the workspace.

mod shared;

use meshmend_spatial::shapes;
use serde_json::json;

#[test]
fn thin_faces_are_those_of_the_cases() {
    for (case, mesh) in shared::cases("shape") {
        let found = shapes(&mesh, 1000.0);
        let slivers: Vec<_> = found.slivers.iter().map(|s| json!([s.face.0, s.kind.name()])).collect();
        let zero_area: Vec<u32> = found.zero_area.iter().map(|face| face.0).collect();
        let answer = json!({ "slivers": slivers, "zero_area": zero_area });
        for (question, expected) in case["by_construction"].as_object().unwrap() {
            if question != "steps" {
                assert_eq!(answer[question], *expected, "{}", case["file"]);
            }
        }
    }
}
