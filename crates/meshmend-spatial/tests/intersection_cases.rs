//! The cases of intersections beside the workspace.

mod shared;

use meshmend_spatial::{IntersectionOptions, Surface, intersections};
use serde_json::{Map, Value, json};

#[test]
fn intersections_are_those_of_the_cases() {
    for (case, mesh) in shared::cases("intersections") {
        let surface = Surface::of(&mesh).unwrap();
        let found = intersections(&surface, IntersectionOptions::default()).unwrap();
        let pairs: Vec<Value> = found
            .pairs
            .iter()
            .map(|pair| json!([pair.faces[0].0, pair.faces[1].0, pair.contact.name(), pair.is_coplanar]))
            .collect();
        let figures = found.figures.unwrap();
        let counts: Map<String, Value> = meshmend_spatial::Contact::ALL
            .into_iter()
            .filter(|&contact| figures.count(contact) > 0)
            .map(|contact| (contact.name().to_owned(), json!(figures.count(contact))))
            .collect();
        let answer = json!({
            "pairs": pairs,
            "counts": counts,
            "crossing": figures.crossing,
            "overlapping": figures.overlapping,
            "crossing_faces": figures.crossing_faces,
            "clusters": figures.clusters,
            "zero_area": found.zero_area.iter().map(|face| face.0).collect::<Vec<_>>(),
        });
        for known in ["by_construction", "reference"] {
            for (question, expected) in case[known].as_object().unwrap() {
                assert_eq!(answer[question], *expected, "{}: {question}", case["file"]);
            }
        }
        assert!(found.self_crossing.is_empty() && found.complete_to.is_none());
    }
}
