//! What a check found.

use meshmend::mesh::counted;
use meshmend::report::{CheckDocument, DefectGroup, PlacedDefect};
use meshmend::topology::{ComponentKind, Reason, TopologyReport};
use meshmend::{DefectKind, Distance, Severity};

use super::geometry::geometry;
use super::table::{self, Align};
use super::{ABSENT, Style, figure, kinds_with_counts, paragraph, printable, yes_no};

/// How many points of a face are shown.
const MOST_POINTS: usize = 4;

/// The report on one mesh.
pub(crate) fn check(document: &CheckDocument, style: Style) -> String {
    let mut page = heading(document, style);
    page.push_str(&paragraph(&style.heading("figures"), figures(&document.topology)));
    page.push_str(&paragraph(&style.heading("verdicts"), verdicts(&document.topology, style)));
    page.push_str(&paragraph(&style.heading("components"), components(document)));
    let geometry = document.geometry.as_ref().map(geometry).unwrap_or_default();
    page.push_str(&paragraph(&style.heading("where the faces lie"), geometry));
    page.push_str(&paragraph(&style.heading("what is wrong"), defects(document, Severity::Defect)));
    page.push_str(&paragraph(&style.heading("worth knowing"), defects(document, Severity::Note)));
    page.push_str(&paragraph(&style.heading("kernels"), kernels(document)));
    let notes = document.notes.iter().map(|note| printable(&note.to_string()));
    page.push_str(&paragraph(&style.heading("notes of the reader"), notes));
    page
}

fn heading(document: &CheckDocument, style: Style) -> String {
    let stored = &document.stored;
    let mut counts = format!("{}, {}", counted(stored.vertices, "vertex"), counted(stored.faces, "face"));
    if stored.loose_edges > 0 {
        counts.push_str(&format!(", {}", counted(stored.loose_edges, "loose edge")));
    }
    if stored.loose_points > 0 {
        counts.push_str(&format!(", {}", counted(stored.loose_points, "loose point")));
    }
    let name = printable(document.file.as_deref().unwrap_or("mesh"));
    let wrong = document.defects.iter().filter(|group| group.severity == Severity::Defect);
    let verdict = match wrong.clone().count() {
        0 if document.topology.faces == 0 => "there are no faces, and nothing is wrong".to_owned(),
        0 => style.good("nothing is wrong"),
        _ => style.bad(&kinds_with_counts(wrong.map(|group| (group.kind, group.count)))),
    };
    let format = document.format.unwrap_or("in memory");
    format!("{}: {format}, {counts}\n{}\n{verdict}\n", style.heading(&name), view(document))
}

fn view(document: &CheckDocument) -> String {
    let joined = document.group(DefectKind::CoincidentVertex).map_or(0, |group| group.count);
    let view = match document.weld {
        None if joined > 0 => {
            let joined = counted(joined, "vertex");
            format!("judged as stored; exact welding would join {joined} to others (--weld exact)")
        }
        None => "judged as stored; exact welding would join nothing".to_owned(),
        Some(Distance::Exact) => "judged as welded: vertices at the same position are one".to_owned(),
        Some(Distance::Single) => {
            "judged as welded: vertices at the same position in single precision are one".to_owned()
        }
        Some(Distance::Absolute(length)) => format!("judged as welded: vertices within {length} are one"),
        Some(Distance::Relative(part)) => {
            format!("judged as welded: vertices within {part} of the bounding box's diagonal are one")
        }
        Some(Distance::Auto) => "judged as welded within what stands out".to_owned(),
        Some(Distance::Boundary(length)) => {
            format!(
                "judged as welded: vertices at the same position, and of open edges within {length}, are one"
            )
        }
        Some(Distance::BoundaryRelative(part)) => format!(
            "judged as welded: vertices at the same position, and of open edges within {part} of the bounding box's \
             diagonal, are one"
        ),
    };
    let view = match document.apart_in_pose {
        0 => view,
        1 => format!("{view}; 1 vertex at the position of another stays apart, as it moves in another way"),
        apart => {
            format!(
                "{view}; {apart} vertices at the position of others stay apart, as they move in another way"
            )
        }
    };
    match document.joined_in_single {
        0 => view,
        1 => format!("{view}; 1 more vertex would be joined in single precision (--weld single)"),
        more => format!("{view}; {more} more vertices would be joined in single precision (--weld single)"),
    }
}

/// The figures with what explains them.
pub(super) fn figures(report: &TopologyReport) -> Vec<String> {
    let row = |label: &str, value: String, remark: String| vec![label.to_owned(), value, remark];
    let betti = |numbers: Option<[u64; 3]>| figure(numbers.map(|[a, b, c]| format!("{a} {b} {c}")));
    let why = |name: &str| {
        report
            .undefined
            .iter()
            .find(|u| u.figure == name)
            .map_or(String::new(), |u| reason(u.reason).to_owned())
    };
    let edges = format!(
        "{} interior, {} boundary, {} non-manifold",
        report.interior_edges, report.boundary_edges, report.non_manifold_edges
    );
    let rows = [
        row("vertices", report.vertices.to_string(), beside(report.unreferenced_vertices, "in no face")),
        row("edges", report.edges.to_string(), edges),
        row("faces", report.faces.to_string(), beside(report.degenerate_faces, "degenerate")),
        row(
            "Euler characteristic",
            report.euler_characteristic.to_string(),
            "vertices − edges + faces".into(),
        ),
        row("components", report.components.to_string(), String::new()),
        row(
            "patches",
            report.patches.to_string(),
            beside_of(report.non_orientable_patches, "not orientable"),
        ),
        row("boundary loops", figure(report.boundary_loops), why("boundary_loops")),
        row("genus", figure(report.genus), why("genus")),
        row("cross-caps", figure(report.cross_caps), why("cross_caps")),
        row("Betti numbers mod 2", betti(report.betti.z2), why("betti")),
        row("Betti numbers over Q", betti(report.betti.q), why("betti")),
    ];
    table::lines(&rows, &[Align::Left, Align::Right])
}

fn beside(count: u64, what: &str) -> String {
    if count == 0 { String::new() } else { format!("and {count} {what}") }
}

fn beside_of(count: u64, what: &str) -> String {
    if count == 0 { String::new() } else { format!("{count} of them {what}") }
}

fn reason(reason: Reason) -> &'static str {
    match reason {
        Reason::NonManifoldComponent => "not defined: a component is not manifold",
        Reason::NoFaces => "not defined: there is no face",
        Reason::NoOrientableComponent => "not defined: no component is orientable",
        Reason::NoNonOrientableComponent => "not defined: every component is orientable",
        Reason::EliminationBudget | Reason::SearchBudget => "not computed: it would take too long",
        Reason::BeyondMemory => "not computed: it would take more memory than --memory allows",
    }
}

/// The answers of yes and no, each no with its reasons.
pub(super) fn verdicts(report: &TopologyReport, style: Style) -> Vec<String> {
    if report.faces == 0 {
        return vec!["there is no face to judge".to_owned()];
    }
    let verdict = |label: &str, answer: bool, reasons: &[(DefectKind, u64)]| {
        let reasons = reasons.iter().copied().filter(|&(_, count)| count > 0);
        let mark = format!("{:<3}", yes_no(answer));
        let mark = if answer { style.good(&mark) } else { style.bad(&mark) };
        format!("{label:<23} {mark}  {}", kinds_with_counts(reasons)).trim_end().to_owned()
    };
    let vertices = report.non_manifold_vertices;
    let branching = [
        (DefectKind::NonManifoldEdge, report.non_manifold_edges),
        (DefectKind::PinchedVertex, vertices.pinched),
        (DefectKind::SingularVertex, vertices.singular),
    ];
    vec![
        verdict("manifold", report.manifold, &branching),
        verdict("closed", report.closed, &[(DefectKind::BoundaryEdge, report.boundary_edges)]),
        verdict(
            "consistently oriented",
            report.consistently_oriented,
            &[(DefectKind::InconsistentEdge, report.inconsistent_edges)],
        ),
        verdict(
            "orientable",
            report.orientable,
            &[(DefectKind::NonOrientablePatch, report.non_orientable_patches)],
        ),
    ]
}

fn components(document: &CheckDocument) -> Vec<String> {
    let kinds = &document.topology.component_kinds;
    let mut lines = table::lines(&kinds.iter().map(component).collect::<Vec<_>>(), &[Align::Right]);
    let hidden = document.component_kinds_total - kinds.len() as u64;
    if hidden > 0 {
        lines.push(format!("… and {}", counted(hidden, "more kind")));
    }
    lines
}

fn component(kind: &ComponentKind) -> Vec<String> {
    let name = kind.name.clone().unwrap_or_else(|| "not a surface".to_owned());
    let elements = format!(
        "{}, {}, {}",
        counted(kind.vertices, "vertex"),
        counted(kind.edges, "edge"),
        counted(kind.faces, "face")
    );
    let euler = format!("χ {}", kind.euler_characteristic);
    let place = format!("{} {}", if kind.count > 1 { "the first at" } else { "at" }, kind.first_vertex);
    vec![format!("{} ×", kind.count), name, elements, euler, place]
}

/// The kinds of a severity with their places.
pub(super) fn defects(document: &CheckDocument, severity: Severity) -> Vec<String> {
    document.defects.iter().filter(|group| group.severity == severity).flat_map(group).collect()
}

fn group(group: &DefectGroup) -> Vec<String> {
    let mut lines = vec![format!("{}: {} ({})", group.kind.title(), group.count, group.kind)];
    lines.extend(group.items.iter().map(|item| format!("  {}", placed(item))));
    let hidden = group.count - group.items.len() as u64;
    if hidden > 0 {
        lines.push(format!("  … and {hidden} more"));
    }
    lines
}

fn placed(item: &PlacedDefect) -> String {
    let points: Vec<String> = item.positions.iter().take(MOST_POINTS).map(point).collect();
    let more = if item.positions.len() > MOST_POINTS { " …" } else { "" };
    let faces = faces_round(item);
    if points.is_empty() {
        format!("{}{faces}", item.defect)
    } else {
        format!("{}, at {}{more}{faces}", item.defect, points.join(" "))
    }
}

/// The faces along an edge or round a vertex. Returns an empty text if there are no faces, or the limit is 0.
pub(super) fn faces_round(item: &PlacedDefect) -> String {
    let Some(round) = &item.round else { return String::new() };
    let names: Vec<String> = round.faces.iter().map(ToString::to_string).collect();
    let hidden = round.face_count - round.faces.len() as u64;
    match (names.len(), hidden) {
        (0, _) => String::new(),
        (1, 0) => format!("; face {}", names[0]),
        (_, 0) => format!("; faces {}", names.join(" ")),
        (_, hidden) => format!("; faces {} … and {hidden} more", names.join(" ")),
    }
}

fn point(point: &[f64; 3]) -> String {
    let [x, y, z] = point.map(coordinate);
    format!("({x}, {y}, {z})")
}

/// A number as short as it can be, and never hundreds of digits.
fn coordinate(value: f64) -> String {
    if value.fract() == 0.0 && value.abs() < 1e15 { format!("{value}") } else { format!("{value:?}") }
}

fn kernels(document: &CheckDocument) -> Vec<String> {
    let verdict = |kernel: &meshmend::KernelVerdict| {
        let refusals = kernel.refusals.iter().map(|(&kind, &count)| (kind, count));
        let text = if kernel.holds {
            "holds it".to_owned()
        } else {
            format!("refuses: {}", kinds_with_counts(refusals))
        };
        vec![kernel.name.to_owned(), text]
    };
    table::lines(&document.kernels.iter().map(verdict).collect::<Vec<_>>(), &[])
}

/// Of which kind the components are, if they are of one.
pub(super) fn which(document: &CheckDocument) -> String {
    let name = |kind: &ComponentKind| kind.name.clone().unwrap_or_else(|| "not a surface".to_owned());
    match document.topology.component_kinds.as_slice() {
        [kind] if document.component_kinds_total == 1 => format!("{} × {}", kind.count, name(kind)),
        [] => ABSENT.to_owned(),
        _ => counted(document.component_kinds_total, "kind"),
    }
}

/// The figures of a mesh in the order in which a repair sets them side by side.
pub(super) fn column(document: &CheckDocument) -> Vec<(&'static str, String)> {
    let report = &document.topology;
    let what = which(document);
    let betti = figure(report.betti.z2.map(|[a, b, c]| format!("{a} {b} {c}")));
    vec![
        ("vertices", report.vertices.to_string()),
        ("edges", report.edges.to_string()),
        ("faces", report.faces.to_string()),
        ("Euler characteristic", report.euler_characteristic.to_string()),
        ("components", report.components.to_string()),
        ("which", what),
        ("boundary loops", figure(report.boundary_loops)),
        ("genus", figure(report.genus)),
        ("cross-caps", figure(report.cross_caps)),
        ("Betti numbers mod 2", betti),
        ("manifold", yes_no(report.manifold).to_owned()),
        ("closed", yes_no(report.closed).to_owned()),
        ("consistently oriented", yes_no(report.consistently_oriented).to_owned()),
        ("orientable", yes_no(report.orientable).to_owned()),
    ]
}
