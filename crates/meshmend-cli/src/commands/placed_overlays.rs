//! What positions tell of a mesh, as overlays of a picture.

use meshmend::mesh::{Defect, EdgeId, Element, FaceId, VertexId, Watch};
use meshmend::spatial::LoopKind;
use meshmend::{DefectKind, GeometryOptions, GeometryReport, PolygonMesh, Question};
use meshmend_render::{Overlay, Placed};

use crate::failure::Failure;

/// The overlays of what is asked.
pub(super) fn placed_overlays(mesh: &PolygonMesh, asked: &[Placed]) -> Result<Vec<Overlay>, Failure> {
    if asked.is_empty() {
        return Ok(Vec::new());
    }
    let questions = asked.iter().map(|&what| question(what)).collect();
    let report = GeometryReport::of(mesh, &GeometryOptions::default().asking(questions), &Watch::NOBODY)
        .map_err(|error| Failure::of_pass("picture", &error))?;
    Ok(asked.iter().map(|&what| overlay(mesh, &report, what)).collect())
}

/// The question that tells it.
fn question(what: Placed) -> Question {
    match what {
        Placed::Crossings => Question::Crossings,
        Placed::TJunctions | Placed::Holes => Question::TJunctions,
        Placed::Slivers => Question::Shape,
        Placed::InsideOut => Question::Nesting,
        Placed::Internal => Question::Internal,
    }
}

/// The kinds of defect that are shown.
fn kinds(what: Placed) -> &'static [DefectKind] {
    match what {
        Placed::Crossings => &[DefectKind::CrossingFaces, DefectKind::SelfCrossingFace],
        Placed::TJunctions => &[DefectKind::TJunction],
        Placed::Holes => &[],
        Placed::Slivers => &[DefectKind::SliverFace, DefectKind::ZeroAreaFace],
        Placed::InsideOut => &[DefectKind::InsideOutComponent],
        Placed::Internal => &[DefectKind::InternalFace],
    }
}

fn overlay(mesh: &PolygonMesh, report: &GeometryReport, what: Placed) -> Overlay {
    let defects: Vec<Defect> = kinds(what).iter().flat_map(|&kind| report.defects(kind, mesh)).collect();
    let elements = || defects.iter().flat_map(|defect| [Some(&defect.at), defect.beside.as_ref()]).flatten();
    let vertices: Vec<VertexId> = elements().filter_map(Element::vertex).collect();
    let mut edges: Vec<EdgeId> = elements().flat_map(|element| edges_of(mesh, report, element)).collect();
    if what == Placed::Holes {
        edges.extend(hole_edges(mesh, report));
    }
    edges.sort_unstable();
    edges.dedup();
    Overlay::Placed { what, edges, vertices }
}

/// The edges of a face, of all faces of a component, or of an edge itself.
fn edges_of(mesh: &PolygonMesh, report: &GeometryReport, element: &Element) -> Vec<EdgeId> {
    let (faces, edges) = (mesh.complex().faces(), mesh.complex().edges());
    let round = |face: FaceId| faces.face_corners(face).map(|corner| edges.corner_edge(corner));
    match element {
        Element::Edge { edge, .. } => vec![*edge],
        Element::Component(lowest) => {
            let component = |face| report.nesting.as_ref().and_then(|nesting| nesting.component_of(face));
            let whole = component(*lowest);
            faces.faces().filter(|&face| component(face) == whole).flat_map(round).collect()
        }
        _ => element.face().into_iter().flat_map(round).collect(),
    }
}

/// The edges of the loops that are holes.
fn hole_edges(mesh: &PolygonMesh, report: &GeometryReport) -> Vec<EdgeId> {
    let edges = mesh.complex().edges();
    let holes = report.loops.iter().flatten().filter(|found| matches!(found.kind, LoopKind::Hole));
    let along = |vertices: &Vec<VertexId>| -> Vec<EdgeId> {
        let next = vertices.iter().cycle().skip(1);
        let ends = vertices.iter().zip(next).map(|(&a, &b)| [a.min(b), a.max(b)]);
        ends.filter_map(|ends| edges.all_ends().binary_search(&ends).ok().map(|at| EdgeId(at as u32)))
            .collect()
    };
    holes.flat_map(|hole| along(&hole.vertices)).collect()
}
