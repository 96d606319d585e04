//! The cases of internal faces beside the workspace.

mod shared;

use meshmend_spatial::{IntersectionOptions, Surface, internal_faces, intersections, nesting};
use serde_json::Value;

#[test]
fn internal_faces_are_as_many_as_those_of_the_cases() {
    for (case, mesh) in shared::cases("nesting") {
        let surface = Surface::of(&mesh).unwrap();
        let met = intersections(&surface, IntersectionOptions::default()).unwrap();
        let found = internal_faces(&surface, &met, &nesting(&surface).unwrap()).unwrap().unwrap();
        for known in ["by_construction", "reference"] {
            if let Value::Number(count) = &case[known]["internal"] {
                assert_eq!(count.as_u64(), Some(found.internal.len() as u64), "{}", case["file"]);
            }
        }
    }
}
