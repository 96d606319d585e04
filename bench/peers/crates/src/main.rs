//! Measures one operation of one crate in this process, and prints a line of JSON.
//!
//! `peer-crates CRATE OPERATION FILE SCRATCH RUNS`; without a word the operations of every crate.

use std::collections::BTreeMap;
use std::error::Error;
use std::fs::{self, File};
use std::io::{BufReader, Read};
use std::time::Instant;

use alum::{HasTopology, PolyMeshF64, VH};
use cpu_time::ProcessTime;
use serde_json::json;

type Figures = BTreeMap<&'static str, usize>;
/// Looks at what came out, after the time was taken.
type Answer = Box<dyn FnOnce() -> Result<Figures, Box<dyn Error>>>;
/// The operation, with its input.
type Work = Box<dyn FnOnce() -> Result<Answer, Box<dyn Error>>>;
type Prepare = fn(&str) -> Result<Work, Box<dyn Error>>;

const OPERATIONS: &[(&str, &str, Prepare)] = &[
    ("meshopt", "weld", weld),
    ("alum", "connectivity", connectivity),
    ("tobj", "read-obj", read_obj),
    ("stl_io", "read-stl", read_stl),
    ("stl_io", "read-stl-ascii", read_stl),
    ("stl_io", "read-stl-welded", read_stl_welded),
    ("ply-rs-bw", "read-ply", read_ply),
    ("ply-rs-bw", "read-ply-ascii", read_ply),
];

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let [name, operation, file, _, runs] = &words[..] else {
        for (name, operation, _) in OPERATIONS {
            println!("{name} {operation}");
        }
        return Ok(());
    };
    let found = OPERATIONS.iter().find(|(peer, work, _)| peer == name && work == operation);
    let (_, _, prepare) = found.ok_or("no such operation")?;
    let (mut cpu, mut wall, mut growth, mut figures) = (Vec::new(), Vec::new(), 0, Figures::new());
    for run in 0..runs.parse()? {
        let work = prepare(file)?;
        let before = resident("VmRSS:")?;
        fs::write("/proc/self/clear_refs", "5")?;
        let (processor, clock) = (ProcessTime::now(), Instant::now());
        let answer = work()?;
        cpu.push(processor.elapsed().as_secs_f64());
        wall.push(clock.elapsed().as_secs_f64());
        if run == 0 {
            growth = resident("VmHWM:")?.saturating_sub(before);
        }
        figures = answer()?;
    }
    let report =
        json!({"version": version(name), "cpu": cpu, "wall": wall, "growth": growth, "figures": figures});
    println!("{report}");
    Ok(())
}

/// The version that is in the lock file.
fn version(name: &str) -> String {
    let lock = include_str!("../Cargo.lock");
    let entry = lock.split("[[package]]").find(|entry| entry.contains(&format!("name = \"{name}\"\n")));
    let number = entry.and_then(|entry| entry.split('"').nth(3)).unwrap_or("?");
    match name {
        "meshopt" => format!("meshoptimizer (crate meshopt {number})"),
        _ => format!("{name} {number}"),
    }
}

/// Bytes of memory, by the name of a line in the status of this process.
fn resident(field: &str) -> Result<usize, Box<dyn Error>> {
    let status = fs::read_to_string("/proc/self/status")?;
    let line = status.lines().find(|line| line.starts_with(field)).ok_or("no such field")?;
    Ok(line.split_whitespace().nth(1).ok_or("no figure")?.parse::<usize>()? * 1024)
}

/// The vertices and triangles of a binary PLY file that meshmend-bench wrote.
fn load(file: &str) -> Result<(Vec<[f32; 3]>, Vec<[u32; 3]>), Box<dyn Error>> {
    let mut bytes = Vec::new();
    File::open(file)?.read_to_end(&mut bytes)?;
    let end = bytes.windows(11).position(|window| window == b"end_header\n").ok_or("no header")? + 11;
    let header = std::str::from_utf8(&bytes[..end])?;
    let count = |element: &str| {
        let line = header.lines().find_map(|line| line.strip_prefix(element)).ok_or("no such element")?;
        Ok::<usize, Box<dyn Error>>(line.trim().parse()?)
    };
    let (vertex_end, face_count) = (end + 12 * count("element vertex ")?, count("element face ")?);
    let word = |row: &[u8], i: usize| [row[4 * i], row[4 * i + 1], row[4 * i + 2], row[4 * i + 3]];
    let vertices = bytes[end..vertex_end].chunks_exact(12);
    let vertices = vertices.map(|row| [0, 1, 2].map(|i| f32::from_le_bytes(word(row, i)))).collect();
    let faces = bytes[vertex_end..vertex_end + 13 * face_count].chunks_exact(13);
    let faces = faces.map(|row| [0, 1, 2].map(|i| u32::from_le_bytes(word(&row[1..], i)))).collect();
    Ok((vertices, faces))
}

fn counts(vertices: usize, faces: usize) -> Result<Answer, Box<dyn Error>> {
    Ok(Box::new(move || Ok([("vertices", vertices), ("faces", faces)].into())))
}

fn weld(file: &str) -> Result<Work, Box<dyn Error>> {
    let (vertices, _) = load(file)?;
    Ok(Box::new(move || {
        // Without indices before, the table is the list of indices after.
        let (count, remap) = meshopt::generate_vertex_remap(&vertices, None);
        let welded = meshopt::remap_vertex_buffer(&vertices, count, &remap);
        Ok(Box::new(move || {
            let is_same = remap.iter().zip(&vertices).all(|(&new, old)| welded[new as usize] == *old);
            if is_same { Ok([("vertices", count)].into()) } else { Err("a vertex has moved".into()) }
        }))
    }))
}

fn connectivity(file: &str) -> Result<Work, Box<dyn Error>> {
    let (vertices, triangles) = load(file)?;
    let points: Vec<_> =
        vertices.iter().map(|point| alum::DVec3(point[0].into(), point[1].into(), point[2].into())).collect();
    Ok(Box::new(move || {
        let mut mesh = PolyMeshF64::with_capacity(points.len(), 3 * triangles.len() / 2, triangles.len());
        mesh.add_vertices(&points).map_err(|error| format!("{error:?}"))?;
        for triangle in &triangles {
            let [a, b, c] = triangle.map(VH::from);
            // Faces that it can't hold are left out.
            let _ = mesh.add_tri_face(a, b, c);
        }
        Ok(Box::new(move || Ok([("edges", mesh.num_edges())].into())))
    }))
}

fn read_obj(file: &str) -> Result<Work, Box<dyn Error>> {
    let file = file.to_owned();
    Ok(Box::new(move || {
        let (models, _) = tobj::load_obj(&file, &tobj::LoadOptions::default())?;
        let vertices = models.iter().map(|model| model.mesh.positions.len() / 3).sum();
        let faces = models.iter().map(|model| model.mesh.indices.len() / 3).sum();
        Ok(Box::new(move || {
            drop(models);
            counts(vertices, faces)?()
        }))
    }))
}

/// Iterates and keeps nothing.
fn read_stl(file: &str) -> Result<Work, Box<dyn Error>> {
    let file = file.to_owned();
    Ok(Box::new(move || {
        let mut reader = BufReader::new(File::open(file)?);
        let mut faces = 0;
        for triangle in stl_io::create_stl_reader(&mut reader)? {
            std::hint::black_box(triangle?);
            faces += 1;
        }
        counts(3 * faces, faces)
    }))
}

fn read_stl_welded(file: &str) -> Result<Work, Box<dyn Error>> {
    let file = file.to_owned();
    Ok(Box::new(move || {
        let mesh = stl_io::read_stl(&mut BufReader::new(File::open(file)?))?;
        Ok(Box::new(move || counts(mesh.vertices.len(), mesh.faces.len())?()))
    }))
}

fn read_ply(file: &str) -> Result<Work, Box<dyn Error>> {
    use ply_rs::parser::Parser;
    use ply_rs::ply::DefaultElement;

    let file = file.to_owned();
    Ok(Box::new(move || {
        let ply = Parser::<DefaultElement>::new().read_ply(&mut BufReader::new(File::open(file)?))?;
        let count = |element: &str| ply.payload.get(element).map_or(0, |rows| rows.len());
        let (vertices, faces) = (count("vertex"), count("face"));
        Ok(Box::new(move || {
            drop(ply);
            counts(vertices, faces)?()
        }))
    }))
}
