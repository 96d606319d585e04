//! The cases of holes beside the workspace.

mod shared;

use meshmend_core::{Build, EdgeUse, Watch};
use meshmend_spatial::{LoopKind, open_loops};

#[test]
fn loops_have_the_figures_of_the_cases() {
    for (case, mesh) in shared::cases("holes") {
        let kernel = EdgeUse::build(mesh.complex()).unwrap();
        let found = open_loops(&kernel, &mesh, &Watch::NOBODY).unwrap();
        let by_construction = case["by_construction"]["loops"].as_array().unwrap();
        let reference = case["reference"]["loops"].as_array().unwrap();
        assert_eq!(found.len(), by_construction.len(), "{}", case["file"]);
        for (found, expected) in found.iter().zip(by_construction) {
            assert_eq!(found.vertices.len() as u64, expected["edges"].as_u64().unwrap());
            assert_eq!(found.kind == LoopKind::Rim, expected["rim"].as_bool().unwrap(), "{}", case["file"]);
        }
        for (found, expected) in found.iter().zip(reference) {
            let vertices: Vec<u64> = found.vertices.iter().map(|vertex| vertex.0.into()).collect();
            let loop_: Vec<u64> =
                expected["loop"].as_array().unwrap().iter().filter_map(|v| v.as_u64()).collect();
            assert_eq!(vertices, loop_, "{}", case["file"]);
            assert_eq!(found.is_of_lone_face, expected["lone_face"].as_bool().unwrap());
            let figures = [("turned", found.turned), ("length", found.length), ("area", found.area)];
            for (name, figure) in figures {
                let expected = expected[name].as_f64().unwrap();
                let difference = (figure - expected).abs();
                assert!(difference <= 1e-12 * expected.abs().max(1e-3), "{} {name} {figure}", case["file"]);
            }
        }
    }
}
