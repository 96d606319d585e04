//! `derived`: what a kernel answers in place of a provided method.

use meshmend_core::{Connectivity, CornerId, FaceId, Id, VertexId};

use super::asked::Asked;
use super::law::{Breach, Law, same, same_star};

pub(super) const DERIVED: Law = Law {
    id: "derived",
    sentence: "each provided method that is overridden answers as the provided one",
    why: "a kernel may be faster in its own way, and no answer hangs on that",
    often: None,
};

pub(super) fn derived<K: Connectivity>(asked: &Asked<'_, K>) -> Result<(), Breach> {
    let (kernel, right) = (asked.kernel, asked.expected);
    same_star(|| "vertices()".to_owned(), kernel.vertices(), &right.vertices().collect::<Vec<_>>())?;
    same_star(|| "edges()".to_owned(), kernel.edges(), &right.all_edges().collect::<Vec<_>>())?;
    same_star(|| "faces()".to_owned(), kernel.faces(), &right.all_faces().collect::<Vec<_>>())?;
    same_star(|| "corners()".to_owned(), kernel.corners(), &right.corners().collect::<Vec<_>>())?;
    right.all_faces().try_for_each(|face| of_face(asked, face))?;
    right.all_edges().try_for_each(|edge| {
        let corners = right.edge_corners(edge);
        same(|| format!("edge_degree({edge})"), &kernel.edge_degree(edge), &corners.len())?;
        let faces: Vec<FaceId> = corners.iter().map(|corner| right.face[corner.index()]).collect();
        same_star(|| format!("edge_faces({edge})"), kernel.edge_faces(edge), &faces)?;
        let [low, high] = right.ends(edge);
        let elsewhere = right.vertices().find(|vertex| ![low, high].contains(vertex));
        [low, high].into_iter().chain(elsewhere).try_for_each(|at| {
            let expected = right.next_boundary_edge(edge, at);
            same(
                || format!("next_boundary_edge({edge}, {at})"),
                &kernel.next_boundary_edge(edge, at),
                &expected,
            )
        })
    })?;
    right.corners().try_for_each(|corner| {
        same(|| format!("corner_target({corner})"), &kernel.corner_target(corner), &right.target(corner))?;
        same(|| format!("is_forward({corner})"), &kernel.is_forward(corner), &right.is_forward(corner))
    })?;
    right.vertices().try_for_each(|vertex| of_vertex(asked, vertex))
}

fn of_face<K: Connectivity>(asked: &Asked<'_, K>, face: FaceId) -> Result<(), Breach> {
    let (kernel, vertices) = (asked.kernel, &asked.expected.faces[face.index()]);
    same_star(|| format!("face_vertices({face})"), kernel.face_vertices(face), vertices)?;
    same(|| format!("is_proper_face({face})"), &kernel.is_proper_face(face), &!vertices.is_empty())
}

fn of_vertex<K: Connectivity>(asked: &Asked<'_, K>, vertex: VertexId) -> Result<(), Breach> {
    let (kernel, right) = (asked.kernel, asked.expected);
    let is_referenced = !right.stars[vertex.index()].is_empty();
    same(|| format!("is_referenced({vertex})"), &kernel.is_referenced(vertex), &is_referenced)?;
    let edges = right.vertex_edges(vertex);
    same_star(|| format!("vertex_edges({vertex})"), kernel.vertex_edges(vertex), &edges)?;
    let across = |[low, high]: [VertexId; 2]| if low == vertex { high } else { low };
    let neighbours: Vec<VertexId> = edges.iter().map(|&edge| across(right.ends(edge))).collect();
    same_star(|| format!("vertex_neighbours({vertex})"), kernel.vertex_neighbours(vertex), &neighbours)?;
    // These two come in the order of the corners, which `vertex-stars` and `rotation` have judged.
    let star: Vec<CornerId> = kernel.vertex_corners(vertex).collect();
    let faces: Vec<FaceId> = star.iter().map(|corner| right.face[corner.index()]).collect();
    same_star(|| format!("vertex_faces({vertex})"), kernel.vertex_faces(vertex), &faces)?;
    let ring: Vec<VertexId> = star.iter().map(|&corner| right.target(corner)).collect();
    same_star(|| format!("vertex_ring({vertex})"), kernel.vertex_ring(vertex), &ring)
}
