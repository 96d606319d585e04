//! What a check found about where the faces lie, in a few lines. The items are listed as defects.

use meshmend::mesh::counted;
use meshmend::report::{GeometryDocument, IntersectionsDocument, LoopCounts};

use super::table;

/// A line for each answer.
pub(super) fn geometry(document: &GeometryDocument) -> Vec<String> {
    let mut rows: Vec<Vec<String>> = Vec::new();
    let mut row = |label: &str, text: String| rows.push(vec![label.to_owned(), text]);
    if let Some(found) = &document.intersections {
        row("crossings", crossings(found));
        row("contacts", contacts(found));
    }
    if let Some(junctions) = &document.t_junctions {
        row("T-junctions", junctions.count.to_string());
    }
    if let Some(counts) = &document.loop_counts {
        row("boundary loops", loops(counts));
    }
    if let Some(counts) = &document.state_counts {
        let states: Vec<String> = counts.iter().map(|(state, count)| format!("{count} {state}")).collect();
        row("components", if states.is_empty() { "none".to_owned() } else { states.join(", ") });
    }
    table::lines(&rows, &[])
}

fn crossings(found: &IntersectionsDocument) -> String {
    if let Some(face) = found.complete_to {
        return format!("the search stopped at {face}, as its budget was used up (--pair-budget)");
    }
    match (found.crossing.unwrap_or_default(), found.overlapping.unwrap_or_default()) {
        (0, 0) => "no two faces cross".to_owned(),
        (crossing, overlapping) => format!(
            "{} in {} of {}; passing through: {crossing}, overlapping in one plane: {overlapping}",
            counted(crossing + overlapping, "pair"),
            counted(found.clusters.unwrap_or_default(), "cluster"),
            counted(found.crossing_faces.unwrap_or_default(), "face"),
        ),
    }
}

fn contacts(found: &IntersectionsDocument) -> String {
    let Some(counts) = &found.counts else { return "not counted".to_owned() };
    let named = [
        ("coincident", found.coincident.unwrap_or_default()),
        ("edge-face", counts.edge_face),
        ("edge-edge", counts.edge_edge),
        ("vertex-face", counts.vertex_face),
        ("vertex-edge", counts.vertex_edge),
    ];
    let present = named.iter().filter(|(_, count)| *count > 0);
    let texts: Vec<String> = present.map(|(name, count)| format!("{count} {name}")).collect();
    if texts.is_empty() {
        "no two faces touch beside their corners and edges".to_owned()
    } else {
        texts.join(", ")
    }
}

fn loops(counts: &LoopCounts) -> String {
    let all = [
        (counts.holes, "hole", "holes"),
        (counts.rims, "rim of a sheet", "rims of sheets"),
        (counts.undecided, "loop of faces without a side", "loops of faces without a side"),
    ];
    let present = all.iter().filter(|(count, ..)| *count > 0);
    let texts: Vec<String> = present
        .map(|&(count, one, many)| format!("{count} {}", if count == 1 { one } else { many }))
        .collect();
    if texts.is_empty() { "none".to_owned() } else { texts.join(", ") }
}
