#![allow(clippy::unwrap_used, reason = "a case that can't be read is a failed test")]
//! The folder of cases and references beside the workspace, and its small meshes.

use std::path::{Path, PathBuf};

use meshmend_core::PolygonMesh;
use serde_json::Value;

/// A path in the shared folder; nothing, and a message, where it does not exist.
pub(crate) fn shared(name: &str) -> Option<PathBuf> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared").join(name);
    match path.canonicalize() {
        Ok(path) => Some(path),
        Err(_) => {
            println!("skipped: there is no {}", path.display());
            None
        }
    }
}

/// The geometry cases that ask a question, each with its mesh.
pub(crate) fn cases(question: &str) -> Vec<(Value, PolygonMesh)> {
    let Some(folder) = shared("geometry/cases") else { return Vec::new() };
    let all = std::fs::read_to_string(folder.join("expected.json")).unwrap();
    let all: Vec<Value> = serde_json::from_str(&all).unwrap();
    let asked = all.into_iter().filter(|case| case["question"] == question);
    asked.map(|case| (case.clone(), read(&folder.join(case["file"].as_str().unwrap())))).collect()
}

/// A mesh of an OFF or OBJ file that has nothing but points and faces.
pub(crate) fn read(path: &Path) -> PolygonMesh {
    let text = std::fs::read_to_string(path).unwrap();
    let rows: Vec<Vec<&str>> = text.lines().map(|line| line.split_whitespace().collect()).collect();
    let rows = || rows.iter().filter(|row| row.first().is_some_and(|word| !word.starts_with('#')));
    let is_off = path.extension().is_some_and(|ending| ending == "off");
    let (points, faces): (Vec<_>, Vec<_>) = if is_off {
        let counts = rows().nth(1).unwrap();
        let count: usize = counts[0].parse().unwrap();
        let rows: Vec<&[&str]> = rows().skip(2).map(|row| &row[..]).collect();
        (rows[..count].to_vec(), rows[count..].iter().map(|row| &row[1..]).collect())
    } else {
        let of = |word: &str| rows().filter(|row| row[0] == word).map(|row| &row[1..]).collect();
        (of("v"), of("f"))
    };
    let points: Vec<[f64; 3]> =
        points.iter().map(|row| [0, 1, 2].map(|axis| row[axis].parse().unwrap())).collect();
    let first = u32::from(!is_off);
    let faces = faces.iter().map(|row| row.iter().map(|word| word.parse::<u32>().unwrap() - first).collect());
    mesh(&points, &faces.collect::<Vec<Vec<u32>>>())
}

/// A mesh of points and faces.
pub(crate) fn mesh(points: &[[f64; 3]], faces: &[Vec<u32>]) -> PolygonMesh {
    let mut starts = vec![0];
    starts.extend(faces.iter().scan(0, |end, face| {
        *end += face.len() as u32;
        Some(*end)
    }));
    PolygonMesh::from_polygons(points, &faces.concat(), &starts).unwrap()
}
