//! Messages that count one of something as several.

/// What may be counted, in the plural.
const COUNTED: [&str; 42] = [
    "bytes",
    "cavities",
    "coordinates",
    "colours",
    "comments",
    "components",
    "corners",
    "cross-caps",
    "declarations",
    "defects",
    "edges",
    "elements",
    "faces",
    "facets",
    "figures",
    "files",
    "generators",
    "groups",
    "handles",
    "holes",
    "images",
    "lines",
    "loops",
    "losses",
    "materials",
    "meshes",
    "names",
    "normals",
    "numbers",
    "objects",
    "patches",
    "pictures",
    "points",
    "positions",
    "rows",
    "seams",
    "sides",
    "statements",
    "triangles",
    "umbrellas",
    "values",
    "vertices",
];

/// The first place in a text at which one of something is counted as several: `1 faces`, `1 loose edges`.
pub fn miscounted(text: &str) -> Option<String> {
    text.lines().find_map(|line| {
        let words: Vec<&str> = line.split(' ').collect();
        (0..words.len()).find_map(|at| of_one(&words[at..]))
    })
}

/// The words from a number 1 on to what it counts, if that is in the plural. Adjectives may stand between.
fn of_one(words: &[&str]) -> Option<String> {
    const MOST_ADJECTIVES: usize = 2;
    let (first, others) = words.split_first()?;
    if first.trim_start_matches(['(', '`', '"']) != "1" {
        return None;
    }
    let is_letter = |c: char| c.is_ascii_lowercase() || c == '-';
    let ends = |word: &str| word.chars().find(|c| !is_letter(*c)).is_some();
    for (place, word) in others.iter().take(MOST_ADJECTIVES + 1).enumerate() {
        let noun = word.trim_end_matches(|c| !is_letter(c));
        // `edge 1 names vertex 2`
        let is_verb = noun == "names" && others.get(place + 1).is_some_and(|next| next.starts_with("vert"));
        if COUNTED.contains(&noun) && !is_verb {
            return Some(words[..place + 2].join(" "));
        }
        let is_no_adjective =
            ["of", "is", "has", "and", "in", "with", "joins", "names", "uses"].contains(&noun);
        if is_no_adjective || ends(word) || word.is_empty() {
            return None;
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_of_something_is_told_from_several_and_from_other_numbers() {
        for (text, found) in [
            ("1 faces", Some("1 faces")),
            ("of 1 vertices, and", Some("1 vertices,")),
            ("two lines\nthat (1 loose edges) are", Some("(1 loose edges)")),
            ("1 more loose points", Some("1 more loose points")),
            ("1 face, 2 edges", None),
            ("11 faces, 21 faces", None),
            ("face 1 has edges", None),
            ("row 1 of 3 faces", None),
            ("loose edge 1 names vertices", None),
            ("1 face, sides", None),
            ("1 names are", Some("1 names")),
            ("1", None),
        ] {
            assert_eq!(miscounted(text).as_deref(), found, "{text}");
        }
    }
}
