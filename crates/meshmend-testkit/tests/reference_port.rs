//! The port of the reference repair gives what the reference itself gives, on the reference's own random meshes.
//!
//! Skipped, with a message, where there is no Python or no reference beside the workspace.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::path::PathBuf;
use std::process::Command;

use meshmend_testkit::reference::{
    Inserted, Point, Repaired, Split, broken_postconditions, faces_with_holes, hole_faults, loops_of, repair,
    word_of,
};
use num_rational::BigRational;
use serde_json::Value;

const SEEDS: usize = 600;

/// Prints one line a seed: the mesh, what the reference makes of it by each policy, and what is wrong with the mesh.
const DRIVER: &str = r#"
import json, random, sys
sys.dont_write_bytecode = True
sys.path.insert(0, sys.argv[1])
import repair_reference as reference

def point(p):
    return None if p is None else [str(x) for x in p]

def result(positions, faces, split):
    once = reference.repair(positions, faces, split)
    once["positions"] = [point(p) for p in once["positions"]]
    return once

def faults(positions, faces, f):
    first_at = {}
    welded = [i if p is None else first_at.setdefault(p, i) for i, p in enumerate(positions)]
    word = reference.fold_spikes([welded[v] for v in faces[f]], lambda v: v)
    return len(reference.hole_faults(positions, word, reference.simple_loops(word, lambda v: v)))

for seed in range(int(sys.argv[2])):
    positions, faces = reference.random_mesh(random.Random(seed))
    print(json.dumps({
        "positions": [point(p) for p in positions],
        "faces": faces,
        "broken": sorted(reference.broken_postconditions(positions, faces)),
        "sheets": result(positions, faces, "sheets"),
        "cut": result(positions, faces, "cut"),
        "holes": [[f, faults(positions, faces, f)] for f in reference.faces_with_holes(positions, faces)],
    }))
"#;

#[test]
fn the_port_gives_what_the_reference_gives() {
    let Some(lines) = reference_lines() else { return };
    let mut count = 0;
    for (seed, line) in lines.lines().enumerate() {
        let case: Value = serde_json::from_str(line).unwrap();
        let (positions, faces) = (points(&case["positions"]), lists(&case["faces"]));
        for (policy, split) in [("sheets", Split::Sheets), ("cut", Split::Cut)] {
            let found = repair(positions.clone(), &faces, split);
            assert_eq!(found, repaired(&case[policy]), "seed {seed}, {policy}");
            assert_eq!(broken_postconditions(found.positions.len(), &found.faces), [""; 0], "seed {seed}");
        }
        let holes: Vec<(u32, usize)> = faces_with_holes(&positions, &faces)
            .into_iter()
            .map(|f| {
                let word = word_of(&positions, &faces[f as usize]);
                (f, hole_faults(&positions, &word, &loops_of(&word)).len())
            })
            .collect();
        assert_eq!(serde_json::to_value(holes).unwrap(), case["holes"], "seed {seed}");
        let mut broken = broken_postconditions(positions.len(), &faces);
        broken.sort();
        assert_eq!(serde_json::to_value(broken).unwrap(), case["broken"], "seed {seed}");
        count += 1;
    }
    assert_eq!(count, SEEDS);
}

/// What the reference prints, or nothing where it can't be run.
fn reference_lines() -> Option<String> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../../shared/reference");
    if !folder.join("repair_reference.py").is_file() {
        println!("skipped: there is no {}/repair_reference.py", folder.display());
        return None;
    }
    let mut command = Command::new("python3");
    command.arg("-c").arg(DRIVER).arg(&folder).arg(SEEDS.to_string());
    let output = match command.output() {
        Ok(output) => output,
        Err(why) => {
            println!("skipped: python3 does not run: {why}");
            return None;
        }
    };
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    Some(String::from_utf8(output.stdout).unwrap())
}

fn repaired(value: &Value) -> Repaired {
    let numbers = |list: &Value| list.as_array().unwrap().iter().map(number).collect::<Vec<u32>>();
    let optional = |v: &Value| if v.is_null() { None } else { Some(number(v)) };
    let inserted = value["inserted"].as_object().unwrap().iter().map(|(new, at)| {
        let [a, b, numerator, denominator] = numbers(at).try_into().unwrap();
        (new.parse().unwrap(), Inserted { ends: [a, b], numerator, denominator })
    });
    Repaired {
        positions: points(&value["positions"]),
        faces: lists(&value["faces"]),
        source_vertex: value["source_vertex"].as_array().unwrap().iter().map(optional).collect(),
        inserted: inserted.collect(),
        source_face: numbers(&value["source_face"]),
        flipped: value["flipped"].as_array().unwrap().iter().map(|v| v.as_bool().unwrap()).collect(),
        non_orientable: lists(&value["non_orientable"]),
    }
}

fn points(value: &Value) -> Vec<Point> {
    let rational = |x: &Value| x.as_str().unwrap().parse::<BigRational>().unwrap();
    let point = |p: &Value| Some(p.as_array()?.iter().map(rational).collect::<Vec<_>>().try_into().unwrap());
    value.as_array().unwrap().iter().map(point).collect()
}

fn lists(value: &Value) -> Vec<Vec<u32>> {
    let list = |face: &Value| face.as_array().unwrap().iter().map(number).collect();
    value.as_array().unwrap().iter().map(list).collect()
}

fn number(value: &Value) -> u32 {
    value.as_u64().unwrap().try_into().unwrap()
}
