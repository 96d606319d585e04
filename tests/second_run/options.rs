//! Options of a repair, chosen at random.

use crate::random::Random;

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

/// Any options that go together.
pub(crate) fn options(random: &mut Random) -> Vec<[&'static str; 2]> {
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
