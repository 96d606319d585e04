//! A repair of what was repaired changes nothing, whatever the options are: random meshes with random options, through
//! the program, from every format into every format. The second output is the first to the byte, and the second report
//! says that nothing changed. Neither the number of threads nor the kernel makes a difference.
//!
//! More cases than the usual number: `MESHMEND_SECOND_RUN_CASES=20000`; from another one on:
//! `MESHMEND_SECOND_RUN_FIRST=20000`. What fails is told with its number, as small as it could be made.

use std::fmt::Write;
use std::ops::Range;
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};

use meshmend_cli::{Console, Status};
use meshmend_tests::scratch::Scratch;
use serde_json::Value;

/// How many cases there are, and the number of the first.
fn amount(variable: &str, usual: u64) -> u64 {
    std::env::var(variable).ok().and_then(|text| text.parse().ok()).unwrap_or(usual)
}

/// What once changed again: a file, the format that it goes into, and the options.
const KEPT: &[(&str, &str, &[&str])] = &[
    // Crowded edges of vertices that are written more than once for their texture coordinates.
    ("texture_seam.obj", "ply", &[]),
    // Edges that coincide were subdivided in one point, and so again when only places told vertices apart.
    ("crowded_edge.obj", "stl", &[]),
    // What was read is what is written, but for the indices that STL does not hold.
    ("stitched.obj", "stl", &[]),
    // The writer cuts polygons, with vertices of its own.
    ("polygons.ply", "stl", &["--triangulate", "auto"]),
    ("not_simple.off", "stl", &["--clean", "off"]),
    // Nothing was changed, but what hung together as stored no longer did.
    ("decal_at_a_seam.obj", "ply", &["--split", "off"]),
    // Whether a shell lies in another one was asked of a point that hung on the way round its face.
    ("shells_of_few_units.obj", "off", &["--orient", "outward-nested", "--split", "off"]),
    // Two seams of one edge each.
    ("seam.obj", "stl", &["--non-orientable", "cut"]),
];

#[test]
fn what_once_changed_again_no_longer_does() {
    for &(file, output, options) in KEPT {
        let stored = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/second_run").join(file);
        let outcome = Asked { output, options: options.to_vec() }.outcome(&stored, true);
        assert!(outcome == Outcome::Right, "{file}: {outcome:?}");
    }
}

#[test]
fn a_second_repair_changes_nothing() {
    let (first, count) = (amount("MESHMEND_SECOND_RUN_FIRST", 0), amount("MESHMEND_SECOND_RUN_CASES", 400));
    let outcomes = outcomes(first..first + count);
    let of = |wanted: fn(&Outcome) -> bool| outcomes.iter().filter(|(_, outcome)| wanted(outcome)).count();
    let refused = of(|outcome| matches!(outcome, Outcome::Refused));
    let wrong: Vec<u64> = outcomes
        .iter()
        .filter(|(_, outcome)| matches!(outcome, Outcome::Wrong(_)))
        .map(|(seed, _)| *seed)
        .collect();
    println!("{count} cases from {first} on: {refused} refused by a policy, {} wrong", wrong.len());
    let told: Vec<String> = wrong
        .iter()
        .take(amount("MESHMEND_SECOND_RUN_TOLD", 12) as usize)
        .map(|&seed| Case::random(seed).shrunk(seed).told(seed))
        .collect();
    assert!(wrong.is_empty(), "{} of {count} change again: {wrong:?}\n{}", wrong.len(), told.join("\n"));
    assert!(refused * 3 < outcomes.len() + 30, "most cases are to be judged");
}

/// What became of each case. Threads of their own take one after the other: each case starts threads itself, and a
/// pool's would take up the next case while they wait for those.
fn outcomes(seeds: Range<u64>) -> Vec<(u64, Outcome)> {
    let (next, outcomes) = (AtomicU64::new(seeds.start), Mutex::new(Vec::new()));
    let work = || {
        while let Some(seed) = Some(next.fetch_add(1, Ordering::Relaxed)).filter(|seed| seeds.contains(seed))
        {
            let outcome = Case::random(seed).outcome(seed);
            outcomes.lock().unwrap().push((seed, outcome));
        }
    };
    std::thread::scope(|scope| (0..4).for_each(|_| drop(scope.spawn(work))));
    let mut outcomes = outcomes.into_inner().unwrap();
    outcomes.sort_by_key(|(seed, _)| *seed);
    outcomes
}

/// What a case came to.
#[derive(Debug, PartialEq)]
enum Outcome {
    /// Nothing changed the second time.
    Right,
    /// A policy gave up, or no face was left.
    Refused,
    /// What is wrong.
    Wrong(String),
}

/// A mesh, how it is stored, and what is asked of its repair.
#[derive(Clone)]
struct Case {
    positions: Vec<[f64; 3]>,
    faces: Vec<Vec<u32>>,
    /// The material of each face, and for each face whether its corners have texture coordinates of their own.
    looks: Vec<(u8, bool)>,
    input: &'static str,
    output: &'static str,
    options: Vec<[&'static str; 2]>,
}

/// What is asked of a repair.
struct Asked {
    output: &'static str,
    options: Vec<&'static str>,
}

impl Asked {
    /// What becomes of a file, and where asked for whether that is the same everywhere.
    fn outcome(&self, stored: &Path, is_everywhere: bool) -> Outcome {
        let scratch = Scratch::new();
        let at = |name: &str| scratch.path().join(format!("{name}.{}", self.output));
        let (once, report) = match self.repair(stored, &at("once"), &[]) {
            Ok(repaired) => repaired,
            Err((Status::Refused, _)) => return Outcome::Refused,
            Err((_, complaint)) if complaint.contains("can't be resolved") => return Outcome::Refused,
            Err((_, complaint)) => return Outcome::Wrong(complaint),
        };
        if let Some(broken) = self.broken_postcondition(&report) {
            return Outcome::Wrong(broken);
        }
        match self.repair(&at("once"), &at("twice"), &[]) {
            Ok((twice, _)) if twice != once => return Outcome::Wrong("the second output differs".to_owned()),
            Ok((_, report)) => {
                if let Some(changed) = told_changes(&report) {
                    return Outcome::Wrong(format!(
                        "the second report says that something changed: {changed}"
                    ));
                }
            }
            Err((_, complaint)) => return Outcome::Wrong(format!("the second time: {complaint}")),
        }
        if is_everywhere { self.everywhere(stored, &at("elsewhere"), &once) } else { Outcome::Right }
    }

    /// The same on other kernels, and with other numbers of threads.
    fn everywhere(&self, stored: &Path, target: &Path, expected: &[u8]) -> Outcome {
        let threads = ["1", "2", "8"].map(|count| ["--threads", count]);
        let kernels =
            ["face-vertex", "adjacency-lists", "half-edge", "quad-edge"].map(|name| ["--kernel", name]);
        for choice in threads.iter().chain(&kernels) {
            match self.repair(stored, target, choice) {
                Ok((bytes, _)) if bytes != expected => {
                    return Outcome::Wrong(format!("{choice:?} gives another mesh"));
                }
                Err((status, complaint)) if status != Status::Refused => {
                    return Outcome::Wrong(format!("{choice:?}: {complaint}"));
                }
                _ => {}
            }
        }
        Outcome::Right
    }

    /// The bytes that a repair writes, and its report; or how it ended, and its complaint.
    fn repair(&self, from: &Path, to: &Path, further: &[&str]) -> Result<(Vec<u8>, Value), (Status, String)> {
        let (mut out, mut errors) = (Vec::new(), Vec::new());
        let mut words: Vec<&str> =
            vec!["meshmend", "repair", from.to_str().unwrap(), "-o", to.to_str().unwrap()];
        words.extend(["--json", "--limit", "3"]);
        words.extend(&self.options);
        words.extend(further);
        let mut console = Console::of(&mut out, &mut errors);
        let status = meshmend_cli::run(words, &mut console);
        drop(console);
        if status != Status::Done {
            return Err((status, String::from_utf8_lossy(&errors).into_owned()));
        }
        Ok((std::fs::read(to).unwrap(), serde_json::from_slice(&out).unwrap()))
    }

    /// What the report on the result says that it must not.
    fn broken_postcondition(&self, report: &Value) -> Option<String> {
        let is_off = |option: &str| self.options.windows(2).any(|two| two == [option, "off"]);
        let after = &report["after"];
        let topology = if after["topology"].is_object() { &after["topology"] } else { after };
        let clashes = topology["inconsistent_edges"].as_u64().unwrap_or(0);
        let is_orientable = topology["orientable"].as_bool().unwrap_or(false);
        // A face that repeats another one and differs from it is taken apart from it by `split`, which may be off.
        let passes = report["passes"].as_array().unwrap();
        let has_copies = passes.iter().any(|pass| pass["left"]["differing-face"].is_object());
        (!is_off("--orient") && !is_off("--clean") && is_orientable && !has_copies && clashes > 0)
            .then(|| format!("{clashes} inconsistent edges in an orientable mesh"))
    }
}

/// Numbers that look random, the same every time.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ self.0 >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ mixed >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ mixed >> 31
    }

    fn below(&mut self, end: usize) -> usize {
        (self.next() % end as u64) as usize
    }

    /// Whether something happens that does so many times in a hundred.
    fn percent(&mut self, chance: u64) -> bool {
        self.next() % 100 < chance
    }

    fn one<T: Copy>(&mut self, of: &[T]) -> T {
        of[self.below(of.len())]
    }
}

/// Every option with its values.
const OPTIONS: &[(&str, &[&str])] = &[
    ("--weld", &["none", "exact", "single", "0.3", "0.5", "1", "10%", "25%"]),
    ("--clean", &["off"]),
    ("--non-finite", &["keep"]),
    ("--repeated", &["keep-different", "drop"]),
    ("--orient", &["majority", "outward", "outward-nested", "off"]),
    ("--non-orientable", &["report", "cut"]),
    ("--duplicates", &["keep", "remove-pair", "keep-first"]),
    ("--split", &["sheets", "cut", "pinch-only", "off"]),
    ("--triangulate", &["auto", "all", "off"]),
    ("--compact", &["on", "keep-loose", "off"]),
    ("--seams", &["split", "corners"]),
    ("--flipped-normals", &["negate", "keep"]),
    ("--encoding", &["ascii"]),
];

impl Case {
    fn random(seed: u64) -> Self {
        let random = &mut Random(seed);
        let (mut positions, mut faces) = match random.below(5) {
            0 => strip(random),
            1 => solids(random),
            _ => soup(random),
        };
        spoil(random, &mut positions, &mut faces);
        let materials = random.one(&[1, 1, 2]);
        let has_textures = random.percent(20);
        let looks = faces
            .iter()
            .map(|_| (random.below(materials) as u8, has_textures && random.percent(50)))
            .collect();
        let input = random.one(&["obj", "obj", "off", "ply", "stl"]);
        let output = random.one(&["obj", "off", "ply", "ply", "stl", "stl"]);
        Case { positions, faces, looks, input, output, options: options(random) }
    }

    /// The file that stores the mesh.
    fn text(&self) -> String {
        match self.input {
            "obj" => self.obj(),
            "stl" => self.stl(),
            "off" => self.table("OFF\n", "0"),
            _ => self.table("", ""),
        }
    }

    fn obj(&self) -> String {
        let mut text = String::new();
        for [x, y, z] in &self.positions {
            writeln!(text, "v {x:?} {y:?} {z:?}").unwrap();
        }
        text.push_str("vt 0 0\nvt 0 1\nvt 1 0\n");
        for (number, (face, &(material, is_textured))) in self.faces.iter().zip(&self.looks).enumerate() {
            writeln!(text, "usemtl m{material}").unwrap();
            text.push('f');
            for (place, v) in face.iter().enumerate() {
                match is_textured {
                    true => write!(text, " {}/{}", v + 1, (place + number) % 3 + 1).unwrap(),
                    false => write!(text, " {}", v + 1).unwrap(),
                }
            }
            text.push('\n');
        }
        text
    }

    /// The first three corners of each face.
    fn stl(&self) -> String {
        let mut text = "solid s\n".to_owned();
        for face in self.faces.iter().filter(|face| face.len() > 2) {
            text.push_str("facet normal 0 0 0\nouter loop\n");
            for &v in &face[..3] {
                let [x, y, z] = self.positions[v as usize];
                writeln!(text, "vertex {x:?} {y:?} {z:?}").unwrap();
            }
            text.push_str("endloop\nendfacet\n");
        }
        text + "endsolid s\n"
    }

    /// As OFF, or where there is no keyword as PLY.
    fn table(&self, keyword: &str, edges: &str) -> String {
        let (vertices, faces) = (self.positions.len(), self.faces.len());
        let mut text = if keyword.is_empty() {
            let numbers = "property double x\nproperty double y\nproperty double z\n";
            let list = "property list uchar int vertex_indices\n";
            format!(
                "ply\nformat ascii 1.0\nelement vertex {vertices}\n{numbers}element face {faces}\n{list}end_header\n"
            )
        } else {
            format!("{keyword}{vertices} {faces} {edges}\n")
        };
        for [x, y, z] in &self.positions {
            writeln!(text, "{x:?} {y:?} {z:?}").unwrap();
        }
        for face in &self.faces {
            write!(text, "{}", face.len()).unwrap();
            face.iter().for_each(|v| write!(text, " {v}").unwrap());
            text.push('\n');
        }
        text
    }

    fn outcome(&self, seed: u64) -> Outcome {
        let scratch = Scratch::new();
        let stored = scratch.path().join(format!("stored.{}", self.input));
        std::fs::write(&stored, self.text()).unwrap();
        self.asked().outcome(&stored, seed.is_multiple_of(8))
    }

    fn asked(&self) -> Asked {
        Asked { output: self.output, options: self.options.iter().flatten().copied().collect() }
    }
    /// The same kind of failure with as few faces and options as can be.
    fn shrunk(self, seed: u64) -> Self {
        let mut least = self;
        loop {
            let fewer_options = (0..least.options.len()).map(|at| {
                let mut case = least.clone();
                case.options.remove(at);
                case
            });
            let fewer_faces = (0..least.faces.len()).map(|at| {
                let mut case = least.clone();
                case.faces.remove(at);
                case.looks.remove(at);
                case
            });
            let fewer_corners = (0..least.faces.len()).filter(|&at| least.faces[at].len() > 3).map(|at| {
                let mut case = least.clone();
                case.faces[at].pop();
                case
            });
            let plainer = (0..least.faces.len()).filter(|&at| least.looks[at] != (0, false)).map(|at| {
                let mut case = least.clone();
                case.looks[at] = (0, false);
                case
            });
            let smaller = fewer_options.chain(fewer_faces).chain(fewer_corners).chain(plainer);
            let found = smaller.into_iter().find(|case| matches!(case.outcome(seed), Outcome::Wrong(_)));
            match found {
                Some(case) => least = case,
                None => return least,
            }
        }
    }

    fn told(&self, seed: u64) -> String {
        let why = match self.outcome(seed) {
            Outcome::Wrong(why) => why,
            _ => "nothing".to_owned(),
        };
        let options = self.options.concat().join(" ");
        let path = std::env::temp_dir().join(format!("second-run-{seed}.{}", self.input));
        std::fs::write(&path, self.text()).unwrap();
        format!("{seed}: {} -o 1.{} {options}: {why}", path.display(), self.output)
    }
}

/// What a report says that was changed.
fn told_changes(report: &Value) -> Option<String> {
    let passes = report["passes"].as_array().unwrap();
    let changing: Vec<&Value> =
        passes.iter().filter(|pass| pass["changed"] != false).map(|pass| &pass["pass"]).collect();
    let lists = ["removed_faces", "flipped_faces", "created_vertices"];
    let counts: Vec<&str> = lists.into_iter().filter(|list| report[list]["count"] != 0).collect();
    (!changing.is_empty() || !counts.is_empty() || report["changed"] != false)
        .then(|| format!("{changing:?} {counts:?} {}", report["changed"]))
}

/// Any options that go together.
fn options(random: &mut Random) -> Vec<[&'static str; 2]> {
    let chance = random.one(&[0, 15, 30, 60]);
    let mut chosen: Vec<[&str; 2]> = Vec::new();
    for &(name, values) in OPTIONS {
        let is_off = |pass: &str| chosen.contains(&[pass, "off"]);
        let is_idle = match name {
            "--non-finite" | "--repeated" => is_off("--clean"),
            "--non-orientable" | "--duplicates" | "--flipped-normals" => is_off("--orient"),
            _ => false,
        };
        if !is_idle && random.percent(chance) {
            chosen.push([name, random.one(values)]);
        }
    }
    chosen
}

type Mesh = (Vec<[f64; 3]>, Vec<Vec<u32>>);

/// Faces over few points of a small grid.
fn soup(random: &mut Random) -> Mesh {
    let (count, side) = (3 + random.below(8), 1 + random.below(3));
    let positions = (0..count).map(|_| [0; 3].map(|_| random.below(side + 1) as f64)).collect();
    let sizes: &[usize] = random.one(&[&[3][..], &[3, 3, 3, 4, 4, 5, 6, 7, 2]]);
    let faces = (0..1 + random.below(12)).map(|_| {
        let size = random.one(sizes);
        let mut names: Vec<u32> = (0..count as u32).collect();
        let repeats = random.percent(10);
        (0..size.min(count))
            .map(|_| match repeats {
                true => random.below(count) as u32,
                false => names.swap_remove(random.below(names.len())),
            })
            .collect()
    });
    let faces = faces.collect();
    (positions, faces)
}

/// A strip of squares or triangles, closed or not, twisted or not, with a page or two at its edges.
fn strip(random: &mut Random) -> Mesh {
    let count = 3 + random.below(4) as u32;
    let points = |x: u32| [0, 1].map(|y| [f64::from(x), f64::from(y), f64::from(x * (count - x) % 3)]);
    let positions: Vec<[f64; 3]> = (0..count).flat_map(points).collect();
    let is_twisted = random.percent(60);
    let mut faces = Vec::new();
    for x in 0..count - random.below(2) as u32 {
        let mut next = [2 * x + 2, 2 * x + 3].map(|v| v % (2 * count));
        if is_twisted && x + 1 == count {
            next.reverse();
        }
        let square = vec![2 * x, next[0], next[1], 2 * x + 1];
        match random.below(3) {
            0 => faces.extend([[0, 1, 2], [0, 2, 3]].map(|f| f.map(|i| square[i]).to_vec())),
            _ => faces.push(square),
        }
    }
    for _ in 0..random.below(3) {
        let x = random.below(count as usize) as u32;
        faces.push(vec![2 * x, 2 * x + 1, random.below(2 * count as usize) as u32]);
    }
    (positions, faces)
}

/// Tetrahedra and cubes that touch, lie in each other or stand there twice; a ring with a bridge.
fn solids(random: &mut Random) -> Mesh {
    const CUBE: [[u32; 4]; 6] =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    const TETRAHEDRON: [[u32; 3]; 4] = [[0, 2, 1], [0, 1, 4], [0, 4, 2], [1, 2, 4]];
    const RING: [u32; 10] = [0, 1, 3, 2, 0, 8, 9, 10, 11, 8];
    let (mut positions, mut faces) = (Vec::new(), Vec::new());
    for _ in 0..1 + random.below(3) {
        let (first, size) = (positions.len() as u32, random.one(&[1.0, 1.0, 2.0, 4.0]));
        let origin = [0; 3].map(|_| random.below(3) as f64);
        let at = |corner: [f64; 3]| -> [f64; 3] { std::array::from_fn(|i| origin[i] + size * corner[i]) };
        positions.extend((0..8u8).map(|v| at([v & 1, v >> 1 & 1, v >> 2].map(f64::from))));
        let hole = [[0.25, 0.25], [0.25, 0.75], [0.75, 0.75], [0.75, 0.25]];
        positions.extend(hole.map(|[x, y]| at([x, y, 0.0])));
        let named = |face: &[u32]| face.iter().map(|v| first + v).collect::<Vec<u32>>();
        match random.below(3) {
            0 => faces.extend(CUBE.iter().map(|face| named(face))),
            1 => faces.extend(TETRAHEDRON.iter().map(|face| named(face))),
            _ => faces.push(named(&RING)),
        }
    }
    (positions, faces)
}

/// Turns, doubles and drops faces, stores vertices twice, moves points a little or to where numbers are scarce.
fn spoil(random: &mut Random, positions: &mut Vec<[f64; 3]>, faces: &mut Vec<Vec<u32>>) {
    for face in 0..faces.len() {
        if random.percent(20) {
            faces[face].reverse();
        }
        if random.percent(8) {
            let mut again = faces[face].clone();
            again.rotate_left(1);
            if random.percent(40) {
                again.reverse();
            }
            faces.push(again);
        }
        if random.percent(5) {
            faces[face].pop();
        }
    }
    let is_cracked = random.percent(50);
    for corner in faces.iter_mut().flatten().filter(|_| is_cracked) {
        if random.percent(25) {
            positions.push(positions[*corner as usize]);
            *corner = positions.len() as u32 - 1;
        }
    }
    let kind = random.below(12);
    for number in positions.iter_mut().flatten() {
        let noise = random.one(&[0.0, 0.0, 0.24, 0.26, -0.25, 0.3, -0.3]);
        *number = match kind {
            0 => f64::from_bits(*number as u64),
            1 => f64::from_bits(1.0f64.to_bits() + *number as u64),
            2 => -f64::from_bits(f64::MIN_POSITIVE.to_bits() - 1 + *number as u64),
            3 => *number + noise,
            4 => *number / 3.0 + noise / 1e6,
            5 => *number + 1e6,
            6 => f64::from(f32::from_bits(1.0f32.to_bits() + *number as u32)),
            7 if random.percent(2) => random.one(&[f64::NAN, f64::INFINITY]),
            8 if *number == 0.0 => random.one(&[0.0, -0.0]),
            _ => *number,
        };
    }
}
