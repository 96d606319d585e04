//! A soup whose reader tells which vertices share a place is mended, judged and written just as any other.

#![allow(clippy::unwrap_used, reason = "a test stops where it fails")]

use meshmend::files::{FileRepair, FileTarget, Maps};
use meshmend::formats::{Document, read_document_bytes};
use meshmend::mesh::Watch;
use meshmend::report::{CheckDocument, json};
use meshmend::{CheckOptions, Format, GeometryOptions, Plan, ReadOptions, Session, WriteOptions, check};

/// Numbers that look random and are the same each time.
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, end: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 33) % end
    }
}

/// Coordinates that are equal to the bit or not at all; then one that equals another by value, and two that are not finite.
const COORDINATES: [f32; 9] = [0.0, 1.0, 2.0, 1.000_000_1, 0.5, 1e-40, -0.0, f32::NAN, f32::INFINITY];

/// A binary STL of so many facets. Coordinates are drawn from the first so many.
fn stl(facets: u64, coordinates: u64, colours: bool, numbers: &mut Numbers) -> Vec<u8> {
    let mut bytes = vec![0; 80];
    bytes.extend((facets as u32).to_le_bytes());
    for _ in 0..facets {
        bytes.extend([0; 12]);
        for _ in 0..9 {
            bytes.extend(COORDINATES[numbers.below(coordinates) as usize].to_le_bytes());
        }
        let attribute = if colours { 0x8000 | numbers.below(3) as u16 } else { 0 };
        bytes.extend(attribute.to_le_bytes());
    }
    bytes
}

fn document(bytes: &[u8], shared: bool) -> Document {
    let options = ReadOptions::default();
    let options = if shared { options.with_shared_places() } else { options };
    let document = read_document_bytes(bytes, "soup.stl", &options).unwrap();
    assert_eq!(document.parts[0].mesh.shared_places().is_some(), shared);
    document
}

/// All that a repair says and writes, or why it does not.
fn told(bytes: &[u8], shared: bool, plan: &str, format: Format) -> String {
    let document = document(bytes, shared);
    let target = FileTarget::new("out", WriteOptions::of(format).with_shell(document.shell.clone()));
    let mut repair = FileRepair::of(Plan::from_toml(plan).unwrap());
    repair.maps = Maps::Whole;
    repair.limit = usize::MAX;
    match repair.run("soup.stl", document, Some(&target), &Watch::NOBODY) {
        Err(error) => error.to_string(),
        Ok(repaired) => {
            let mut written = Vec::new();
            repaired.prepared().unwrap().encode(&mut written).unwrap();
            format!("{}\n{written:?}", repaired.report_json().unwrap())
        }
    }
}

const PLANS: [&str; 8] = [
    "empty = 'allow'",
    "empty = 'allow'\n[weld]\ndistance = 'single'",
    "empty = 'allow'\n[weld]\ndistance = 'auto'",
    "empty = 'allow'\n[weld]\ndistance = { absolute = 0.01 }",
    "empty = 'allow'\n[weld]\ndistance = { boundary = 0.3 }",
    "empty = 'allow'\npasses = ['clean', 'orient', 'split', 'compact']",
    "empty = 'allow'\npasses = ['orient', 'weld', 'split', 'weld', 'verify']",
    "empty = 'allow'\n[orient]\nside = 'outward'\n[split]\nedges = 'cut'",
];

#[test]
fn a_repair_says_and_writes_the_same() {
    let mut numbers = Numbers(20);
    for round in 0..60 {
        let coordinates = [3, 6, 9][round % 3];
        let bytes = stl(1 + numbers.below(24), coordinates, round % 4 == 0, &mut numbers);
        for plan in PLANS {
            for format in [Format::Stl, Format::Ply, Format::Obj] {
                let [each, shared] = [false, true].map(|shared| told(&bytes, shared, plan, format));
                assert!(each == shared, "round {round}, {plan}, {format}:\n{each}\n{shared}");
            }
        }
    }
}

#[test]
fn a_check_and_a_session_find_the_same() {
    let mut numbers = Numbers(7);
    for round in 0..60 {
        let bytes = stl(1 + numbers.below(30), [3, 6, 9][round % 3], false, &mut numbers);
        let [each, shared] = [false, true].map(|shared| {
            let mesh = document(&bytes, shared).parts.remove(0).mesh;
            let options = CheckOptions::default().with_geometry(GeometryOptions::all());
            let report = check(&mesh, &options).unwrap();
            let session = Session::begin(&mesh);
            let bits = |point: &[f64; 3]| point.map(f64::to_bits);
            let positions: Vec<[u64; 3]> = session.mesh().positions().iter().map(bits).collect();
            (json(&CheckDocument::new(report, 1000)).unwrap(), positions)
        });
        assert_eq!(each, shared, "round {round}");
    }
}
