//! The closed paths of surfaces, and a cut along them.

use meshmend::cutting::CutAlong;
use meshmend::mesh::counted;
use meshmend::report::{
    ComponentLoops, CutComponent, CutDocument, LoopDocument, LoopsDocument, SeamDocument,
};
use meshmend::topology::{GeneratorKind, Measure};

use super::check::faces_round;
use super::table::{self, Align};
use super::{Style, paragraph, printable};

/// How many vertices of a path are shown.
const MOST_VERTICES: usize = 8;

/// The report on the paths of one mesh.
pub(crate) fn loops(document: &LoopsDocument, style: Style) -> String {
    let name = printable(document.file.as_deref().unwrap_or("mesh"));
    let (components, loops) = (document.components_total, document.loops_total);
    let mut page = format!(
        "{}: {}, {}\n",
        style.heading(&name),
        counted(components, "component"),
        counted(loops, "loop")
    );
    for (place, component) in document.components.iter().enumerate() {
        page.push_str(&paragraph(&style.heading(&heading(place, component)), rows(component)));
    }
    let hidden = components - document.components.len() as u64;
    if hidden > 0 {
        page.push_str(&format!("\nand {} more (--limit)\n", counted(hidden, "component")));
    }
    let notes = document.notes.iter().map(|note| printable(&note.to_string()));
    page.push_str(&paragraph("notes of the reader", notes));
    page
}

fn heading(place: usize, component: &ComponentLoops) -> String {
    let Some(name) = &component.name else { return format!("component {place} is not a surface") };
    let root = component.root.map_or(String::new(), |root| format!(", from {root}"));
    let unit = if component.measure == Some(Measure::Hops) { ", lengths in edges" } else { "" };
    format!("component {place}: {name}{root}{unit}")
}

fn rows(component: &ComponentLoops) -> Vec<String> {
    if let Some(obstacle) = &component.obstacle {
        return vec![format!("{}{}", obstacle.defect, faces_round(obstacle))];
    }
    if component.loops.is_empty() {
        return vec!["every closed path bounds".to_owned()];
    }
    let heads = ["kind", "vertices", "length", "sides", "path"].map(str::to_owned).to_vec();
    let rows: Vec<Vec<String>> = std::iter::once(heads).chain(component.loops.iter().map(row)).collect();
    table::lines(&rows, &[Align::Left, Align::Right, Align::Right, Align::Right])
}

fn row(path: &LoopDocument) -> Vec<String> {
    let kind = match path.kind {
        GeneratorKind::Handle => "handle",
        GeneratorKind::CrossCap => "cross-cap",
        GeneratorKind::Boundary => "boundary",
    };
    let sides = if path.two_sided { "2" } else { "1" };
    let first = path.vertices.iter().flatten().take(MOST_VERTICES);
    let mut shown: Vec<String> = first.map(ToString::to_string).collect();
    if path.vertex_count > shown.len() {
        shown.push("…".to_owned());
    }
    let length = format!("{:.6}", path.length);
    let length = length.trim_end_matches('0').trim_end_matches('.');
    vec![kind.to_owned(), path.vertex_count.to_string(), length.to_owned(), sides.to_owned(), shown.join(" ")]
}

/// The report on a cut.
pub(crate) fn cut(document: &CutDocument, style: Style) -> String {
    let [input, output] = [&document.file, &document.output].map(|name| name.as_deref().unwrap_or("mesh"));
    let (before, after) = (&document.stored.before, &document.stored.after);
    let along = match document.along {
        CutAlong::CutGraph => "a cut graph",
        CutAlong::Generators => "generators",
    };
    let mut page = format!(
        "{} → {}: cut along {along}, {} opened, {} added\n",
        style.heading(&printable(input)),
        style.heading(&printable(output)),
        counted(document.seams.count, "edge"),
        counted(after.vertices - before.vertices, "vertex"),
    );
    let components = document.components.items.iter().map(component);
    page.push_str(&paragraph(&style.heading("components"), listed(components, document.components.count)));
    let seams = document.seams.items.iter().map(seam);
    page.push_str(&paragraph(&style.heading("what belongs together"), listed(seams, document.seams.count)));
    let losses = document.losses.iter().map(|loss| printable(&loss.to_string()));
    page.push_str(&paragraph(&style.heading("what the output can't carry"), losses));
    let notes = document.notes.iter().map(|note| printable(&note.to_string()));
    page.push_str(&paragraph("notes of the reader", notes));
    page
}

/// The items of a list, and how many more there are.
fn listed(items: impl ExactSizeIterator<Item = String>, count: u64) -> Vec<String> {
    let hidden = count - items.len() as u64;
    items.chain((hidden > 0).then(|| format!("and {hidden} more (--limit)"))).collect()
}

fn component(component: &CutComponent) -> String {
    let word = component.word.as_ref().map_or(String::new(), |word| format!(": {word}"));
    format!("{} → {}{word}", component.name, component.after)
}

fn seam(seam: &SeamDocument) -> String {
    let [[a, b], [c, d]] = seam.sides;
    format!("{}–{} became {a}–{b} and {c}–{d}", seam.edge[0], seam.edge[1])
}
