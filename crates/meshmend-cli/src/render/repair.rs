//! What a repair did: before and after side by side, pass by pass, what went, what is left.

use std::fmt::Display;

use meshmend::formats::LossKind;
use meshmend::mesh::{Listed, counted};

use meshmend::passes::{Looked, LoopRecord, SeamFigures};
use meshmend::report::{
    DroppedDocument, FigureChanges, Listing, NamedFace, PassDocument, RepairDocument, SliversDocument,
};
use meshmend::{DefectKind, GeometryChange, GeometryChanges, Loss, PassKind, Severity};

use super::advice::advised;
use super::check::{column, defects};
use super::table::{self, Align};
use super::{Style, change, counts, figure, kinds_with_counts, paragraph, printable, rest};

/// The report on a repair.
pub(crate) fn repair(document: &RepairDocument, style: Style) -> String {
    let mut page = summary(document);
    page.push_str(&paragraph(&style.heading("figures"), side_by_side(document)));
    page.push_str(&paragraph(&style.heading("passes"), document.passes.iter().flat_map(pass)));
    page.push_str(&paragraph(&style.heading("removed faces"), removed(document)));
    let emptied = &document.emptied_names;
    let mut names: Vec<String> = emptied.items.iter().map(|name| printable(&name.message)).collect();
    names.extend(rest(emptied));
    page.push_str(&paragraph(&style.heading("names of which nothing is left"), names));
    let after = document.after.as_ref();
    let wrong = after.map(|after| defects(after, Severity::Defect)).unwrap_or_default();
    page.push_str(&paragraph(&style.heading("still wrong"), wrong));
    let known = after.map(|after| defects(after, Severity::Note)).unwrap_or_default();
    page.push_str(&paragraph(&style.heading("worth knowing"), known));
    let lie = document.geometry_changes.as_ref().map(geometry_changes).unwrap_or_default();
    page.push_str(&paragraph(&style.heading("where the faces lie"), lie));
    let losses = document.losses.iter().map(|loss| printable(&loss.to_string()));
    page.push_str(&paragraph(&style.heading("what the output can't carry"), losses));
    page.push_str(seam_hint(&document.losses));
    let notes = document.notes.iter().map(|note| printable(&note.to_string()));
    page.push_str(&paragraph(&style.heading("notes of the reader"), notes));
    page
}

/// What became of the defects of each kind that positions tell; kinds of which there were none and are none are left out.
fn geometry_changes(changes: &GeometryChanges) -> Vec<String> {
    let heading = ["", "before", "mended", "new", "left"].map(str::to_owned).to_vec();
    let rows = changes.iter().filter_map(|(kind, change)| {
        let Some(GeometryChange { before, mended, new, left }) = change else {
            return Some(vec![kind.title().to_owned(), "the search stopped at its budget".to_owned()]);
        };
        let counts = [before, mended, new, left];
        let row = std::iter::once(kind.title().to_owned()).chain(counts.map(u64::to_string));
        counts.iter().any(|count| **count > 0).then(|| row.collect())
    });
    let rows: Vec<Vec<String>> = std::iter::once(heading).chain(rows).collect();
    if rows.len() == 1 {
        return vec!["nothing was wrong, and nothing is".to_owned()];
    }
    table::lines(&rows, &[Align::Left, Align::Right, Align::Right, Align::Right, Align::Right])
}

/// How to keep vertices whole that the output has several times.
fn seam_hint(losses: &[Loss]) -> &'static str {
    if losses.iter().any(|loss| loss.kind == LossKind::SeamVertices) {
        "  (--seams corners keeps each vertex whole, for programs that read attributes of corners; see --help)\n"
    } else {
        ""
    }
}

/// One line that says what became of the mesh.
pub(crate) fn summary(document: &RepairDocument) -> String {
    let input = printable(document.file.as_deref().unwrap_or("mesh"));
    let target = match &document.output {
        Some(output) => format!("{input} → {}", printable(output)),
        None => format!("{input}, nothing written"),
    };
    format!("{target}: {}\n", changes(document))
}

/// What became of the mesh, from its size to its notes.
pub(super) fn changes(document: &RepairDocument) -> String {
    let (before, after) = (document.stored.before, document.stored.after);
    let mut parts = vec![
        format!("{} → {}", before.vertices, counted(after.vertices, "vertex")),
        format!("{} → {}", before.faces, counted(after.faces, "face")),
    ];
    let changes = [
        (document.removed_faces.count, "faces removed"),
        (document.emptied_names.count, "names of which nothing is left"),
        (document.flipped_faces.count, "faces flipped"),
        (document.turned_normals, "normals turned with their faces"),
        (document.created_faces.count, "faces created"),
        (document.created_vertices.count, "vertices created"),
        (document.stitched, "vertices stitched"),
        ((before.loose_edges - after.loose_edges.min(before.loose_edges)) as u64, "loose edges removed"),
        ((before.loose_points - after.loose_points.min(before.loose_points)) as u64, "loose points removed"),
        (document.losses.len() as u64, "losses in the output"),
        (document.notes.len() as u64, "notes of the reader"),
    ];
    let changes = changes.into_iter().filter(|&(count, _)| count > 0);
    parts.extend(changes.map(|(count, what)| format!("{what}: {count}")));
    match (before.faces, after.faces) {
        (0, _) => parts.push("nothing to mend: there is no face".to_owned()),
        (_, 0) => parts.push("the result is empty: no face is left".to_owned()),
        _ if !document.changed => parts.push("nothing to mend".to_owned()),
        _ => {}
    }
    parts.join(", ")
}

fn side_by_side(document: &RepairDocument) -> Vec<String> {
    let (Some(before), Some(after)) = (&document.before, &document.after) else { return Vec::new() };
    let heading = [String::new(), format!("before, as {}", before.view), "after".to_owned()].to_vec();
    let figures = column(before).into_iter().zip(column(after));
    let rows = figures.map(|((label, before), (_, after))| vec![label.to_owned(), before, after]);
    let rows: Vec<Vec<String>> = std::iter::once(heading).chain(rows).collect();
    table::lines(&rows, &[Align::Left, Align::Right, Align::Right])
}

fn pass(document: &PassDocument) -> Vec<String> {
    let mended = kinds_with_counts(counts(&document.mended));
    let text = match (document.pass, document.changed, mended.is_empty()) {
        (PassKind::Verify, ..) => looked(document.looked).to_owned(),
        (_, false, _) => "nothing to do".to_owned(),
        (_, true, true) => "changed the mesh".to_owned(),
        (PassKind::Slivers, true, _) => {
            counted(document.slivers.as_ref().map_or(0, |slivers| slivers.steps.count), "step")
        }
        (PassKind::Weld, true, false) => format!("vertices joined to others: {}", joined(document)),
        (_, true, false) => mended,
    };
    let figures = match document.delta {
        Some(delta) if document.changed => format!("  [{}]", deltas(delta)),
        _ => String::new(),
    };
    let mut lines = vec![format!("{:<12}{text}{figures}", document.pass.name())];
    lines.extend(document.seam.map(|seam| format!("{:<12}{}", "", cut_open(seam))));
    lines.extend(document.advice.iter().map(|advice| format!("{:<12}{}", "", advised(advice))));
    let loops = document.loops.iter().flat_map(loops);
    let t_junctions = document.t_junctions.iter().flat_map(|found| items_and_more(&found.left));
    let dropped = document.dropped.iter().flat_map(dropped);
    let slivers = document.slivers.iter().flat_map(slivers);
    let apart = document
        .apart
        .iter()
        .flat_map(|apart| items_and_more(&apart.moved).chain(items_and_more(&apart.left)));
    lines.extend(
        loops
            .chain(t_junctions)
            .chain(slivers)
            .chain(dropped)
            .chain(apart)
            .map(|line| format!("{:<12}{line}", "")),
    );
    let left = kinds_with_counts(counts(&document.left));
    if !left.is_empty() {
        lines.push(format!("{:<12}left alone: {left}", ""));
    }
    lines.extend(named_one_by_one(document).map(|line| format!("{:<14}{line}", "")));
    lines
}

/// What `verify` did to know what the result is.
fn looked(looked: Option<Looked>) -> &'static str {
    match looked {
        Some(Looked::Afresh) | None => "looked at the result afresh",
        Some(Looked::Before) => "no pass changed the mesh since it was looked at before",
    }
}

/// The items of what a pass left that the result no longer shows, with what could be done about it.
fn named_one_by_one(document: &PassDocument) -> impl Iterator<Item = String> + '_ {
    let in_record = |kind: &DefectKind| match kind.rule().listed {
        Listed::InRecord { hint } => Some(hint),
        _ => None,
    };
    let kinds = document.left.iter().filter_map(move |(kind, left)| Some((left, in_record(kind)?)));
    kinds.flat_map(|(left, hint)| items_and_more(left).chain((!hint.is_empty()).then(|| hint.to_owned())))
}

/// What cutting non-orientable patches open took.
fn cut_open(seam: SeamFigures) -> String {
    let length = seam.length.map_or(String::new(), |length| format!(" of length {length:.6}"));
    let SeamFigures { edges, edges_added, vertices_added, .. } = seam;
    let seam = format!("seam of {}{length} cut open", counted(edges, "edge"));
    format!("{seam}: {} and {} added", counted(edges_added, "edge"), counted(vertices_added, "vertex"))
}

/// What became of each boundary loop.
fn loops(loops: &Listing<LoopRecord>) -> Vec<String> {
    if loops.count == 0 {
        return vec!["there is no boundary loop".to_owned()];
    }
    items_and_more(loops).collect()
}

/// What was done to slivers, and which are left.
fn slivers(document: &SliversDocument) -> impl Iterator<Item = String> + '_ {
    let limited = (document.move_limit > 0).then(|| {
        let count = counted(document.move_limit, "sliver");
        format!("left because of --max-move or the number of steps: {count}")
    });
    items_and_more(&document.steps).chain(items_and_more(&document.left)).chain(limited)
}

/// What was dropped, and what it left.
fn dropped(document: &DroppedDocument) -> impl Iterator<Item = String> + '_ {
    let (opened, mixed) = (document.opened_edges as u64, document.mixed_faces as u64);
    let opened = (opened > 0).then(|| format!("opened: {}", counted(opened, "edge")));
    let mixed =
        (mixed > 0).then(|| format!("left, as others cross or cover them: {}", counted(mixed, "face")));
    items_and_more(&document.components).chain(opened).chain(mixed)
}

/// A line for each item of a list, and one that says how many there are beside them.
fn items_and_more<T: Display>(list: &Listing<T>) -> impl Iterator<Item = String> + '_ {
    list.items.iter().map(ToString::to_string).chain(rest(list))
}

/// How many vertices welding joined. The kind's own title speaks of what exact welding would do.
fn joined(document: &PassDocument) -> u64 {
    counts(&document.mended).map(|(_, count)| count).sum()
}

fn deltas(delta: FigureChanges) -> String {
    let loops = figure(delta.boundary_loops.map(change));
    format!("Δχ {}, Δs {}, Δb {loops}", change(delta.euler_characteristic), change(delta.components))
}

fn removed_face(face: &NamedFace) -> String {
    let had: Vec<String> =
        face.had.iter().map(|(aspect, name)| format!("{aspect} {}", printable(name))).collect();
    let had = if had.is_empty() { String::new() } else { format!(" (it had {})", had.join(", ")) };
    let differed = if face.differed.is_empty() {
        String::new()
    } else {
        format!(", although it differed in {}{had}", face.differed)
    };
    format!("  {} by {}: {}{differed}", face.face, face.pass, face.reason)
}

fn removed(document: &RepairDocument) -> Vec<String> {
    let removed = &document.removed_faces;
    if removed.count == 0 {
        return Vec::new();
    }
    let mut lines = vec![kinds_with_counts(removed.by_reason.iter().map(|(&kind, &count)| (kind, count)))];
    if removed.differing > 0 {
        lines.push(format!("that differed from what they repeat: {}", removed.differing));
    }
    lines.extend(removed.items.iter().map(removed_face));
    let hidden = removed.count - removed.items.len() as u64;
    if hidden > 0 {
        lines.push(format!("  … and {hidden} more"));
    }
    lines
}
