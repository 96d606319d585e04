//! What any kernel must do, whatever it is made of.
//!
//! What a kernel says is compared with the plain lists of the complex's faces, and edges found anew from those; the
//! shared edge table is not looked at.

use std::collections::{BTreeMap, BTreeSet};

use meshmend_core::{
    Build, Capabilities, Complex, Connectivity, CornerId, EdgeId, FaceId, Id, Refusal, VertexId, admission,
};

use super::same::same;

/// Every law of a kernel, over one complex; a complex that the kernel refuses rightly keeps them all.
///
/// # Errors
/// The law that is broken, and where.
pub fn kernel_laws<K: Connectivity>(complex: &Complex) -> Result<(), String> {
    let Some(kernel) = admitted::<K>(complex)? else { return Ok(()) };
    let expected = Expected::of(complex);
    numbering(&kernel, &expected)?;
    faces(&kernel, &expected)?;
    edges(&kernel, &expected)?;
    vertices(&kernel, &expected)?;
    derived_answers(&kernel, &expected)
}

/// What a kernel says when it refuses a complex: its name, and everything that stands against it, which is something.
///
/// # Errors
/// What is wrong with the refusal.
pub fn refusal_law(
    refusal: &Refusal,
    name: &str,
    capabilities: &Capabilities,
    complex: &Complex,
) -> Result<(), String> {
    same("the refusal's kernel", name, refusal.kernel, name)?;
    same("the refusal's reasons", name, &refusal.defects, &admission(complex, capabilities))?;
    if refusal.defects.is_empty() { Err(format!("{name} refuses without a reason")) } else { Ok(()) }
}

/// Whether what a kernel says of its `heap_bytes` is within a twentieth of what an allocator counted for it.
///
/// # Errors
/// Both figures, when they differ by more.
pub fn heap_law<K: Connectivity>(said: usize, measured: usize) -> Result<(), String> {
    if said.abs_diff(measured).saturating_mul(20) <= measured {
        Ok(())
    } else {
        Err(format!("{} says {said} bytes, but {measured} were allocated", K::NAME))
    }
}

/// The kernel, or nothing where it refuses as it should.
fn admitted<K: Connectivity>(complex: &Complex) -> Result<Option<K>, String> {
    match K::build(complex) {
        Err(refusal) => refusal_law(&refusal, K::NAME, &K::CAPABILITIES, complex).map(|()| None),
        Ok(kernel) => {
            let against = admission(complex, &K::CAPABILITIES);
            same("what stands against a kernel that builds", K::NAME, against, Vec::new())?;
            Ok(Some(kernel))
        }
    }
}

/// The right answers, from plain lists.
struct Expected {
    vertex_count: usize,
    /// The vertices of each face.
    faces: Vec<Vec<usize>>,
    /// The first corner of each face.
    first: Vec<usize>,
    /// Of each corner its vertex, its face and its edge.
    corner_vertex: Vec<usize>,
    corner_face: Vec<usize>,
    corner_edge: Vec<usize>,
    /// The edges in order of their ends, each with its corners.
    edges: Vec<([usize; 2], Vec<usize>)>,
}

impl Expected {
    fn of(complex: &Complex) -> Self {
        let table = complex.faces();
        let list = |f| table.face_vertices(f).iter().map(|v| v.index()).collect::<Vec<_>>();
        let faces: Vec<Vec<usize>> = table.faces().map(list).collect();
        let (mut first, mut corner_vertex, mut corner_face) = (Vec::new(), Vec::new(), Vec::new());
        let mut by_ends: BTreeMap<[usize; 2], Vec<usize>> = BTreeMap::new();
        for (f, face) in faces.iter().enumerate() {
            first.push(corner_vertex.len());
            for (i, &v) in face.iter().enumerate() {
                let target = face[(i + 1) % face.len()];
                by_ends.entry([v.min(target), v.max(target)]).or_default().push(corner_vertex.len());
                corner_vertex.push(v);
                corner_face.push(f);
            }
        }
        let edges: Vec<_> = by_ends.into_iter().collect();
        let mut corner_edge = vec![0; corner_vertex.len()];
        for (e, (_, corners)) in edges.iter().enumerate() {
            corners.iter().for_each(|&corner| corner_edge[corner] = e);
        }
        let vertex_count = table.vertex_count();
        Expected { vertex_count, faces, first, corner_vertex, corner_face, corner_edge, edges }
    }

    fn corners_of(&self, face: usize) -> Vec<CornerId> {
        (0..self.faces[face].len()).map(|i| CornerId::new(self.first[face] + i)).collect()
    }
}

/// Ids are dense and the table's.
fn numbering<K: Connectivity>(kernel: &K, expected: &Expected) -> Result<(), String> {
    same("the number of vertices", K::NAME, kernel.vertex_count(), expected.vertex_count)?;
    same("the number of edges", K::NAME, kernel.edge_count(), expected.edges.len())?;
    same("the number of faces", K::NAME, kernel.face_count(), expected.faces.len())?;
    same("the number of corners", K::NAME, kernel.corner_count(), expected.corner_vertex.len())?;
    for corner in kernel.corners() {
        let c = corner.index();
        same("the vertex", corner, kernel.corner_vertex(corner).index(), expected.corner_vertex[c])?;
        same("the face", corner, kernel.corner_face(corner).index(), expected.corner_face[c])?;
        same("the edge", corner, kernel.corner_edge(corner).index(), expected.corner_edge[c])?;
    }
    Ok(())
}

/// Faces partition the corners, in order; next and previous are inverse and go round the face.
fn faces<K: Connectivity>(kernel: &K, expected: &Expected) -> Result<(), String> {
    for face in kernel.faces() {
        let corners = expected.corners_of(face.index());
        same("the corners", face, kernel.face_corners(face).collect::<Vec<_>>(), corners.clone())?;
        for (i, &corner) in corners.iter().enumerate() {
            let next = corners[(i + 1) % corners.len()];
            same("the next corner", corner, kernel.next_corner(corner), next)?;
            same("the corner before", next, kernel.prev_corner(next), corner)?;
        }
    }
    Ok(())
}

/// Edges partition the corners, ascending, and each side joins its edge's ends.
fn edges<K: Connectivity>(kernel: &K, expected: &Expected) -> Result<(), String> {
    for edge in kernel.edges() {
        let (ends, corners) = &expected.edges[edge.index()];
        same("the ends", edge, kernel.edge_ends(edge).map(Id::index), *ends)?;
        let corners: Vec<_> = corners.iter().copied().map(CornerId::new).collect();
        same("the sides", edge, kernel.edge_corners(edge).collect::<Vec<_>>(), corners.clone())?;
        let low = kernel.edge_ends(edge)[0];
        let ways: Vec<_> = corners.into_iter().map(|c| (c, kernel.corner_vertex(c) == low)).collect();
        same("the directions of the sides", edge, kernel.edge_sides(edge).collect::<Vec<_>>(), ways)?;
    }
    for corner in kernel.corners() {
        let mut side = [kernel.corner_vertex(corner), kernel.corner_vertex(kernel.next_corner(corner))];
        side.sort_unstable();
        same("the ends of the side", corner, kernel.edge_ends(kernel.corner_edge(corner)), side)?;
    }
    Ok(())
}

/// Vertices partition the corners: ascending, or in rotational order where the kernel says so.
fn vertices<K: Connectivity>(kernel: &K, expected: &Expected) -> Result<(), String> {
    let mut at: Vec<Vec<CornerId>> = vec![Vec::new(); expected.vertex_count];
    for (corner, &v) in expected.corner_vertex.iter().enumerate() {
        at[v].push(CornerId::new(corner));
    }
    for vertex in kernel.vertices() {
        let mut corners: Vec<CornerId> = kernel.vertex_corners(vertex).collect();
        if K::CAPABILITIES.ordered_vertex_stars {
            rotational(kernel, vertex, &corners)?;
            corners.sort_unstable();
        }
        same("the corners", vertex, corners, at[vertex.index()].clone())?;
    }
    Ok(())
}

/// A star is one walk: from each corner to the one that it shares an edge with, on over its other edge. It is passed
/// counter-clockwise as the face of its lowest corner runs. A fan goes from the boundary to the boundary, a closed
/// star begins at its lowest corner.
fn rotational<K: Connectivity>(kernel: &K, vertex: VertexId, star: &[CornerId]) -> Result<(), String> {
    let Some(lowest) = (0..star.len()).min_by_key(|&place| star[place]) else { return Ok(()) };
    let [clockwise, counter] = edges_at(kernel, star[lowest]);
    let last = star[lowest + 1..].iter().try_fold(counter, |over, &corner| passed(kernel, corner, over))?;
    let first =
        star[..lowest].iter().rev().try_fold(clockwise, |over, &corner| passed(kernel, corner, over))?;
    if kernel.edge_degree(first) == 1 {
        same("the degree of the edge at the end of the fan", vertex, kernel.edge_degree(last), 1)
    } else {
        same("the place of the lowest corner in the closed star", vertex, lowest, 0)?;
        same("the edge over which the closed star ends", vertex, last, first)
    }
}

/// The two edges at which a corner's umbrella goes on, clockwise one first as its own face runs.
fn edges_at<K: Connectivity>(kernel: &K, corner: CornerId) -> [EdgeId; 2] {
    [kernel.corner_edge(corner), kernel.corner_edge(kernel.prev_corner(corner))]
}

/// The other edge of a corner that is come to over one edge.
fn passed<K: Connectivity>(kernel: &K, corner: CornerId, over: EdgeId) -> Result<EdgeId, String> {
    match edges_at(kernel, corner) {
        [clockwise, counter] if over == clockwise => Ok(counter),
        [clockwise, counter] if over == counter => Ok(clockwise),
        _ => Err(format!("{corner} is not next to the corner before it")),
    }
}

/// The answers that are derived from the others.
fn derived_answers<K: Connectivity>(kernel: &K, expected: &Expected) -> Result<(), String> {
    let referenced: BTreeSet<usize> = expected.corner_vertex.iter().copied().collect();
    for v in kernel.vertices() {
        same("being referenced", v, kernel.is_referenced(v), referenced.contains(&v.index()))?;
        let faces: Vec<FaceId> = kernel.vertex_corners(v).map(|c| kernel.corner_face(c)).collect();
        same("the faces", v, kernel.vertex_faces(v).collect::<Vec<_>>(), faces)?;
    }
    for f in kernel.faces() {
        let vertices = &expected.faces[f.index()];
        same("being proper", f, kernel.is_proper_face(f), !vertices.is_empty())?;
        same(
            "the vertices",
            f,
            kernel.face_vertices(f).map(Id::index).collect::<Vec<_>>(),
            vertices.clone(),
        )?;
    }
    for e in kernel.edges() {
        let corners = &expected.edges[e.index()].1;
        same("the degree", e, kernel.edge_degree(e), corners.len())?;
        let faces: Vec<usize> = corners.iter().map(|&c| expected.corner_face[c]).collect();
        same("the faces", e, kernel.edge_faces(e).map(Id::index).collect::<Vec<_>>(), faces)?;
    }
    kernel.corners().try_for_each(|c| derived_of_corner(kernel, expected, c))
}

fn derived_of_corner<K: Connectivity>(
    kernel: &K,
    expected: &Expected,
    corner: CornerId,
) -> Result<(), String> {
    let edge: EdgeId = kernel.corner_edge(corner);
    let (ends, sides) = &expected.edges[edge.index()];
    let start = expected.corner_vertex[corner.index()];
    let target = if start == ends[0] { ends[1] } else { ends[0] };
    same("the target", corner, kernel.corner_target(corner).index(), target)?;
    same("running forward", corner, kernel.is_forward(corner), start == ends[0])?;
    let other = match sides[..] {
        [one, other] if one == corner.index() => Some(other),
        [one, _] => Some(one),
        _ => None,
    };
    same("the side across", corner, kernel.across(corner).map(Id::index), other)
}
