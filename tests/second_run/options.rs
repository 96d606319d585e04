//! Options of a repair, chosen at random.

use crate::random::Random;

/// Every option with its values.
const OPTIONS: &[(&str, &[&str])] = &[
    (
        "--weld",
        &["none", "exact", "single", "0.3", "0.5", "1", "10%", "25%", "boundary:0.3", "boundary:10%", "auto"],
    ),
    ("--clean", &["off"]),
    ("--non-finite", &["keep"]),
    ("--repeated", &["keep-different", "drop"]),
    ("--orient", &["majority", "outward", "outward-nested", "off"]),
    ("--non-orientable", &["report", "cut"]),
    ("--duplicates", &["keep", "remove-pair", "keep-first"]),
    ("--heal", &["exact", "0.1", "5%", "off"]),
    ("--split", &["sheets", "cut", "pinch-only", "off"]),
    ("--fill", &["all", "edges:5", "off"]),
    ("--fill-by", &["fold", "area", "fan"]),
    ("--triangulate", &["auto", "all", "off"]),
    ("--drop-components", &["faces:2", "area:0.3", "volume:0.1"]),
    ("--internal", &["remove-components", "remove-faces"]),
    ("--outward", &["solids", "nested", "visible"]),
    ("--compact", &["on", "keep-loose", "off"]),
    ("--seams", &["split", "corners"]),
    ("--flipped-normals", &["negate", "keep"]),
    ("--apart", &["nudge"]),
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
            "--non-orientable" | "--duplicates" | "--flipped-normals" | "--heal" => is_off("--orient"),
            "--fill-by" => is_off("--fill"),
            _ => false,
        };
        if !is_idle && random.percent(chance) {
            let option = [name, random.one(values)];
            if !is_refused(&chosen, option) {
                chosen.push(option);
            }
        }
    }
    chosen
}

/// Whether an option is refused together with others.
fn is_refused(chosen: &[[&str; 2]], option: [&str; 2]) -> bool {
    let fills = chosen.iter().any(|[name, value]| name.starts_with("--fill") && *value != "off");
    let crowds = chosen.contains(&["--split", "pinch-only"]);
    match option {
        ["--internal", "remove-faces"] => fills,
        ["--fill" | "--fill-by", value] => crowds && value != "off",
        ["--apart", _] => chosen.contains(&["--weld", "none"]),
        _ => false,
    }
}
