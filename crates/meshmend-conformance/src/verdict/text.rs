//! A verdict in words.

use std::fmt::Write;

use meshmend_core::counted;

use super::files::picture;
use super::verdicts::{Outcome, Verdict, Verdicts};
use crate::Soup;
use crate::run::{Example, shown};

/// More faces of a mesh are not shown.
const MOST_FACES: usize = 12;

impl Verdicts {
    /// The verdict on a law in words, with the smallest mesh that breaks it.
    pub fn text(&self, law: &str) -> String {
        self.on(law).map_or_else(|| format!("there is no verdict on `{law}`"), |verdict| text(self, verdict))
    }
}

/// The verdict on a law.
fn text(verdicts: &Verdicts, verdict: &Verdict) -> String {
    let (kernel, law) = (verdicts.kernel, verdict.law);
    let Some(finding) = &verdict.finding else {
        return format!("{kernel} keeps the law `{}`: {}.", law.id, law.sentence);
    };
    let mut text = format!("{kernel} breaks the law `{}`: {}.\n\n", law.id, law.sentence);
    text += &mesh(verdicts, &finding.example);
    text += &format!("  {}\n\n", finding.message());
    if let Some(often) = law.often {
        text += &format!("  often: {often}\n");
    }
    if finding.example.is_mesh() {
        text += &format!("  the mesh: {}\n", shown(&picture(verdicts, law)));
    }
    text + &format!("  {}", others(verdicts, verdict))
}

/// The mesh that breaks a law, with its corners.
fn mesh(verdicts: &Verdicts, example: &Example) -> String {
    if let Some(name) = &example.family {
        return format!("  a mesh that breaks it: {name}\n\n");
    }
    if !example.is_mesh() {
        return String::new();
    }
    let which = if example.is_shrunk {
        "a mesh that breaks it, made smaller from a random one,"
    } else {
        "smallest mesh that breaks it,"
    };
    let faces = counted(example.faces.len(), "face");
    let vertices = counted(example.vertex_count, "vertex");
    let mut text = format!("  {which} of {} tried ({faces}, {vertices}):\n", grouped(verdicts.meshes.tried));
    let complex = Soup::generic(example.vertex_count, &example.faces).complex();
    let list = |prefix: &str, ids: &mut dyn Iterator<Item = usize>| {
        ids.map(|id| format!("{prefix}{id}")).collect::<Vec<_>>().join(" ")
    };
    let vertices: Vec<String> =
        example.faces.iter().map(|face| list("v", &mut face.iter().map(|&vertex| vertex as usize))).collect();
    let width = vertices.iter().take(MOST_FACES).map(String::len).max().unwrap_or(0);
    for (face, vertices) in complex.faces().faces().zip(&vertices).take(MOST_FACES) {
        let corners = list("c", &mut complex.faces().corner_range(face));
        let corners = if corners.is_empty() { "no corner" } else { &corners };
        // Writing to a string can't fail.
        let _ = writeln!(text, "    {face}: {vertices:width$}     {corners}");
    }
    if let Some(more @ 1..) = example.faces.len().checked_sub(MOST_FACES) {
        text += &format!("    … {} more\n", counted(more, "face"));
    }
    text + "\n"
}

/// What came of the other laws, and how many meshes the kernel holds.
fn others(verdicts: &Verdicts, verdict: &Verdict) -> String {
    let count = |outcome| {
        let others = verdicts.each.iter().filter(|other| other.law.id != verdict.law.id);
        others.filter(|other| other.outcome == outcome).count()
    };
    let said = |outcome, one: &str, many: &str| match count(outcome) {
        0 => None,
        1 => Some(format!("1 {one}")),
        more => Some(format!("{more} {many}")),
    };
    let all = [
        said(Outcome::Kept, "kept", "kept"),
        said(Outcome::Broken, "broken", "broken"),
        said(Outcome::Panics, "panics", "panic"),
        said(Outcome::Hangs, "hangs", "hang"),
    ];
    let all: Vec<String> = all.into_iter().flatten().collect();
    let tried = grouped(verdicts.meshes.tried);
    let held = match verdicts.meshes.held {
        Some(held) => format!("it holds {} of the {tried} meshes", grouped(held)),
        None => format!("the run ended on mesh {tried}"),
    };
    if all.is_empty() { held } else { format!("other laws: {}; {held}", all.join(", ")) }
}

/// A number whose digits come in threes, from five digits on.
fn grouped(number: u32) -> String {
    let digits = number.to_string();
    if digits.len() < 5 {
        return digits;
    }
    let (head, rest) = digits.split_at((digits.len() - 1) % 3 + 1);
    let threes = rest.as_bytes().chunks(3).map(|three| String::from_utf8_lossy(three).into_owned());
    std::iter::once(head.to_owned()).chain(threes).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_come_in_threes() {
        let grouped: Vec<String> = [0, 626, 9_999, 59_241, 100_000, 1_048_576].map(grouped).into();
        assert_eq!(grouped, ["0", "626", "9999", "59 241", "100 000", "1 048 576"]);
    }
}
