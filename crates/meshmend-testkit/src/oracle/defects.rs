//! Everything that is wrong with a mesh, in the library's vocabulary, found by the definitions.

use std::collections::BTreeSet;

use meshmend_core::{Defect, EdgeId, FaceId, PolygonMesh, VertexId};

use super::cells::Cells;
use super::patches;
use super::vertices::{VertexKind, vertex_kind};
use crate::Soup;
use crate::damage::Way;

/// Every defect that a mesh can have as it is, by kind and then by id.
///
/// Of repeated corners the vertex is the first that is listed twice in a row, else the first to which the face walks
/// straight back; of non-simple faces the first that recurs.
pub fn defects(mesh: &PolygonMesh) -> Vec<Defect> {
    let soup = Soup::of_mesh(mesh);
    let cells = Cells::of(&soup);
    let mut found: Vec<Defect> = Vec::new();
    (0..soup.faces.len()).for_each(|f| found.extend(of_face(&soup, &cells, f)));
    (0..cells.ends.len()).for_each(|e| found.extend(of_edge(&cells, e)));
    (0..soup.vertex_count()).for_each(|v| found.extend(of_vertex(&soup, &cells, v)));
    found.extend(duplicates(&cells));
    for patch in patches::patches(&cells).iter().filter(|patch| !patches::is_orientable(&cells, patch)) {
        let strip = patches::witness(&cells, patch).expect("some edge contradicts the tree");
        let (faces, edges) = (strip.faces.into_iter().map(FaceId), strip.edges.into_iter().map(EdgeId));
        found.push(Defect::non_orientable_patch(faces.collect(), edges.collect()));
    }
    let edges = mesh.loose_edges().iter().zip(0..);
    found.extend(edges.map(|(&ends, index)| Defect::loose_edge(index, ends)));
    let points = mesh.loose_points().iter().zip(0..);
    found.extend(points.map(|(&vertex, index)| Defect::loose_point(index, vertex)));
    found.sort_by(|one, other| one.kind().cmp(&other.kind()).then_with(|| one.cmp(other)));
    found
}

/// The inconsistent edges of patches that can be oriented: those that flipping faces mends.
pub fn mendable_clashes(mesh: &PolygonMesh) -> Vec<EdgeId> {
    let cells = Cells::of(&Soup::of_mesh(mesh));
    let twisted: BTreeSet<usize> = patches::patches(&cells)
        .into_iter()
        .filter(|patch| !patches::is_orientable(&cells, patch))
        .flatten()
        .collect();
    let is_mendable = |e: &usize| cells.is_inconsistent(*e) && !twisted.contains(&cells.uses[*e][0].face);
    (0..cells.ends.len()).filter(is_mendable).map(|e| EdgeId(e as u32)).collect()
}

fn of_face(soup: &Soup, cells: &Cells, f: usize) -> Vec<Defect> {
    let (stored, word, face) = (&soup.faces[f], &cells.faces[f], FaceId(f as u32));
    let mut found = Vec::new();
    if let Some(&v) = stored.iter().find(|v| !is_finite(soup, **v)) {
        found.push(Defect::non_finite_face(face, VertexId(v)));
    }
    if word.is_empty() {
        found.push(Defect::degenerate_face(face));
        return found;
    }
    if word.len() > 3 {
        found.push(Defect::polygon_face(face, word.len() as u32));
    }
    if let Some(i) = (0..word.len()).find(|&i| word[..i].contains(&word[i])) {
        found.push(Defect::non_simple_face(face, VertexId(word[i])));
    }
    let recurs = |list: &[u32], by: usize| {
        (0..list.len()).find(|&i| list[i] == list[(i + by) % list.len()]).map(|i| list[i])
    };
    if let Some(v) = recurs(stored, 1).or_else(|| recurs(word, 2)) {
        found.push(Defect::repeated_corner(face, VertexId(v)));
    }
    found
}

fn of_edge(cells: &Cells, e: usize) -> Option<Defect> {
    let (edge, ends) = (EdgeId(e as u32), cells.ends[e].map(VertexId));
    match cells.uses[e].len() {
        1 => Some(Defect::boundary_edge(edge, ends)),
        2 => cells.is_inconsistent(e).then_some(Defect::inconsistent_edge(edge, ends)),
        degree => Some(Defect::non_manifold_edge(edge, ends, degree as u32)),
    }
}

fn of_vertex(soup: &Soup, cells: &Cells, v: usize) -> Vec<Defect> {
    let (name, vertex) = (v as u32, VertexId(v as u32));
    let mut found = Vec::new();
    if !is_finite(soup, name) {
        found.push(Defect::non_finite_vertex(vertex));
    } else if let Some(low) = (0..v).find(|&low| soup.positions[low] == soup.positions[v]) {
        found.push(Defect::coincident_vertex(vertex, VertexId(low as u32)));
    }
    if !cells.referenced.contains(&name) {
        found.push(Defect::unreferenced_vertex(vertex));
        return found;
    }
    match vertex_kind(cells, name) {
        VertexKind::Disc | VertexKind::HalfDisc => {}
        VertexKind::Singular => found.push(Defect::singular_vertex(vertex)),
        VertexKind::Pinched { umbrellas, boundary_only } => {
            found.push(Defect::pinched_vertex(vertex, umbrellas as u32, boundary_only));
        }
    }
    found
}

fn duplicates(cells: &Cells) -> Vec<Defect> {
    let (same, opposite) = cells.duplicates();
    let id = |f: usize| FaceId(f as u32);
    let first = |f: usize, way: Way| id((0..f).find(|&g| cells.are_alike(g, f, way)).expect("it is earlier"));
    let same = same.into_iter().map(|f| Defect::duplicate_face(id(f), first(f, Way::Same)));
    let opposite = opposite.into_iter().map(|f| Defect::opposite_face(id(f), first(f, Way::Opposite)));
    same.chain(opposite).collect()
}

fn is_finite(soup: &Soup, v: u32) -> bool {
    soup.positions[v as usize].iter().all(|x| x.is_finite())
}
