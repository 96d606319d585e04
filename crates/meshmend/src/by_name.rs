//! Parts of a mesh by the names of faces, each checked by itself.

use meshmend_core::{DefectKind, Id, PolygonMesh, Sources, VertexId};
use meshmend_repair::{NamedPart, PassError, Session, named_parts};

use crate::CheckOptions;
use crate::View;
use crate::check::{CheckReport, check, viewed};

/// A part of a mesh, and what it is.
#[derive(Clone, Debug)]
pub struct NamedReport {
    /// The part.
    pub part: NamedPart,
    /// What it is by itself. Vertices and faces are named as stored in the whole; edges count within the part. An edge with
    /// one side that other parts use too is not listed as boundary.
    pub report: CheckReport,
    /// The edges with one side that other parts use too, by their ends as stored in the whole.
    pub shared_edges: Vec<[VertexId; 2]>,
}

/// Checks the faces of each name in a layer by themselves. `None` if faces have no names of this kind.
///
/// # Errors
/// As [`check`], and when a part would have more elements than a mesh holds.
///
/// *Cost*: that of [`check`] for each part, and for each part linear in the vertices of the mesh.
pub fn check_by_name(
    mesh: &PolygonMesh,
    layer: &str,
    options: &CheckOptions,
) -> Result<Option<Vec<NamedReport>>, PassError> {
    let mut session = Session::begin(mesh);
    let (whole, sources) = viewed(&mut session, options.view)?;
    let Some(parts) = named_parts(&whole, layer)? else { return Ok(None) };
    let by_index = options.clone().with_view(View::Indexed);
    let report = |part: NamedPart| Ok((check(&part.mesh, &by_index)?, part));
    let mut reports = parts.into_iter().map(report).collect::<Result<Vec<_>, PassError>>()?;
    let shared = shared_sides(&whole, &reports);
    for ((report, part), sides) in reports.iter_mut().zip(&shared) {
        report.view = options.view;
        let stored = part.record.vertices.iter().map(|(_, viewed)| sources.of(viewed?));
        report.vertex_sources = Sources::listed(stored);
        report.face_sources = part.record.faces.clone();
        report.leave_out(sides);
    }
    let named = |((report, part), sides): ((CheckReport, NamedPart), Vec<[VertexId; 2]>)| {
        let shared_edges = sides.into_iter().map(|ends| ends.map(|end| report.stored_vertex(end))).collect();
        NamedReport { part, report, shared_edges }
    };
    Ok(Some(reports.into_iter().zip(shared).map(named).collect()))
}

/// For each part its edges with one side that another part uses too, by their ends in the part, ascending.
fn shared_sides(whole: &PolygonMesh, parts: &[(CheckReport, NamedPart)]) -> Vec<Vec<[VertexId; 2]>> {
    let mut boundary: Vec<([VertexId; 2], usize, [VertexId; 2])> = Vec::new();
    let mut part_of = vec![0; whole.counts().faces];
    for (at, (report, part)) in parts.iter().enumerate() {
        for (_, face) in part.record.faces.iter() {
            face.into_iter().for_each(|face| part_of[face.index()] = at);
        }
        let whole_vertex = |vertex| part.record.vertices.of(vertex).unwrap_or(vertex);
        let edges = report.topology.defects.of_kind(DefectKind::BoundaryEdge);
        let ends = edges.filter_map(|defect| defect.at.ends());
        boundary.extend(ends.map(|ends| (ascending(ends.map(whole_vertex)), at, ascending(ends))));
    }
    boundary.sort_unstable();
    let mut is_shared = vec![false; boundary.len()];
    for face in whole.faces().faces() {
        let vertices = whole.faces().face_vertices(face);
        let next = vertices.iter().cycle().skip(1);
        for side in vertices.iter().zip(next).map(|(&from, &to)| ascending([from, to])) {
            let first = boundary.partition_point(|(known, ..)| *known < side);
            let same = boundary[first..].iter().take_while(|(known, ..)| *known == side);
            for (place, (_, part, _)) in same.enumerate() {
                is_shared[first + place] |= *part != part_of[face.index()];
            }
        }
    }
    let mut shared = vec![Vec::new(); parts.len()];
    for ((_, part, ends), _) in boundary.into_iter().zip(is_shared).filter(|(_, is_shared)| *is_shared) {
        shared[part].push(ends);
    }
    shared.iter_mut().for_each(|sides: &mut Vec<_>| sides.sort_unstable());
    shared
}

fn ascending([one, other]: [VertexId; 2]) -> [VertexId; 2] {
    if one <= other { [one, other] } else { [other, one] }
}

#[cfg(test)]
mod tests {
    use meshmend_core::{Carry, Domain, FaceTable, Layer, Values};

    use super::*;

    /// A square of two triangles in two objects.
    fn square() -> PolygonMesh {
        let corners = [0, 1, 2, 2, 1, 3].map(VertexId).to_vec();
        let positions = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]];
        let names = Values::Text(vec![b"one".to_vec(), b"two".to_vec()]);
        let object = Layer::direct("object", Domain::Face, 1, Carry::Copy, names);
        let faces = FaceTable::triangles(4, corners).unwrap();
        PolygonMesh::new(positions, faces).unwrap().with_layers(vec![object]).unwrap()
    }

    #[test]
    fn a_side_that_two_parts_share_is_not_their_boundary() {
        let options = CheckOptions::default();
        let reports = check_by_name(&square(), "object", &options).unwrap().unwrap();
        assert_eq!(reports.len(), 2);
        for named in &reports {
            assert_eq!(named.shared_edges, [[1, 2].map(VertexId)]);
            assert_eq!(named.report.count(DefectKind::BoundaryEdge), 2);
            assert_eq!(named.report.defects_of_kind(DefectKind::BoundaryEdge).count(), 2);
        }
        assert_eq!(reports[1].report.stored_vertex(VertexId(2)), VertexId(3));
        assert!(check_by_name(&square(), "material", &options).unwrap().is_none());
    }
}
