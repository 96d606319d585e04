//! Every small mesh there is: all 59 049 sets of oriented triangles over five vertices (each of the ten triples absent,
//! one way round, or the other), through every kernel, the whole topology and the whole repair.
//!
//! The oracle in the testkit shares nothing with the library: it is the definitions, naively.

use meshmend_core::Connectivity;
use meshmend_kernels::{KernelKind, KernelTask};
use meshmend_repair::{Emptying, Pipeline};
use meshmend_testkit::{Soup, oracle, reference, worlds};
use meshmend_topology::topology;
use rayon::prelude::*;
use serde_json::Value;

struct Report<'a>(&'a meshmend_core::PolygonMesh);

impl KernelTask for Report<'_> {
    type Output = Value;
    fn run<K: Connectivity>(self, kernel: &K) -> Value {
        serde_json::to_value(topology(kernel, self.0)).unwrap()
    }
}

/// The oracle's keys of a report.
fn agrees(report: &Value, oracle: &Value) -> Result<(), String> {
    let (Value::Object(report), Value::Object(oracle)) = (report, oracle) else {
        return Err("no object".into());
    };
    for (key, wanted) in oracle {
        if report.get(key) != Some(wanted) {
            return Err(format!("{key} is {:?}, not {wanted}", report.get(key)));
        }
    }
    Ok(())
}

fn check_world(soup: &Soup) -> Result<usize, String> {
    let mesh = soup.mesh();
    let wanted = serde_json::to_value(oracle::report(soup)).unwrap();
    let mut held = 0;
    for kernel in KernelKind::ALL {
        match kernel.run(mesh.complex(), Report(&mesh)) {
            Ok(report) => {
                agrees(&report, &wanted).map_err(|e| format!("{kernel}: {e}"))?;
                held += 1;
            }
            Err(refusal) if refusal.defects.is_empty() => {
                return Err(format!("{kernel} refuses without a reason"));
            }
            Err(_) if kernel.capabilities().is_permissive() => return Err(format!("{kernel} refuses")),
            Err(_) => {}
        }
    }
    let repaired = Pipeline::default().on_emptying(Emptying::Allow).run(&mesh).map_err(|e| e.to_string())?;
    let result = Soup::of_mesh(&repaired.mesh);
    if mesh.counts().faces == 0 {
        return if result == Soup::of_mesh(&mesh) { Ok(held) } else { Err("points are changed".into()) };
    }
    let broken = reference::broken_postconditions(result.vertex_count(), &result.faces);
    if let Some(first) = broken.first() {
        return Err(first.clone());
    }
    let again =
        Pipeline::default().on_emptying(Emptying::Allow).run(&repaired.mesh).map_err(|e| e.to_string())?;
    if Soup::of_mesh(&again.mesh) != result {
        return Err("a second repair changes the result".into());
    }
    Ok(held)
}

fn check_all(sets: Vec<Vec<Vec<u32>>>, vertices: usize) {
    let results: Vec<(usize, Option<String>)> = sets
        .par_iter()
        .map(|faces| match check_world(&Soup::generic(vertices, faces)) {
            Ok(held) => (held, None),
            Err(why) => (0, Some(format!("{faces:?}: {why}"))),
        })
        .collect();
    let failures: Vec<&String> = results.iter().filter_map(|(_, why)| why.as_ref()).collect();
    assert!(failures.is_empty(), "{} of {} fail, such as {}", failures.len(), sets.len(), failures[0]);
    let by_all = results.iter().filter(|(held, _)| *held == KernelKind::ALL.len()).count();
    println!("{} worlds, {by_all} of them held by every kernel", sets.len());
    assert!(by_all > 0 && by_all < sets.len());
}

#[test]
fn every_set_of_oriented_triangles_over_five_vertices() {
    let sets: Vec<_> = worlds::oriented_triangle_sets(5).collect();
    assert_eq!(sets.len(), 59_049);
    check_all(sets, 5);
}

/// For nightly use: all 1 048 576 sets of triangles over six vertices.
#[test]
#[ignore = "takes minutes: cargo test --release -p meshmend-tests --test small_worlds -- --ignored"]
fn every_set_of_triangles_over_six_vertices() {
    let sets: Vec<_> = worlds::triangle_sets(6).collect();
    assert_eq!(sets.len(), 1 << 20);
    check_all(sets, 6);
}
