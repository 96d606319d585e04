//! Which vertices of open edges are joined to close a crack.
//!
//! Pairs of boundary vertices within the distance are taken by their distance, nearest first, then by their ids. Their classes
//! are joined unless the joined class would hold two corners of a face, two ends of a loose edge, or two vertices farther apart
//! than the distance. So what is whole stays as it is, no face loses a corner, and no chain of vertices shrinks to a point.
//!
//! A class is where its lowest vertex is, and that may be near others. So this is done again with the classes as vertices, until
//! nothing is joined: a second run would find it.

use std::sync::Arc;

use meshmend_core::{Complex, Id, PolygonMesh, VertexId};
use meshmend_geometry::proximity::Nearness;
use meshmend_geometry::vector::is_finite;
use meshmend_spatial::near_pairs;

use crate::{Context, PassError};

/// So many pairs for each boundary vertex, and so many beside, are looked at; a distance that makes more of them is larger than
/// the edges of the mesh.
const PAIRS: (usize, usize) = (64, 10_000_000);

/// Classes of vertices, each named by its lowest, joined further along the boundary of the mesh that they make.
///
/// *Cost*: O(n log n + pairs · (faces at a vertex + vertices of a class)) for n boundary vertices, and as much again for each
/// time that classes come near each other.
pub(super) fn joined_along_boundaries(
    mesh: &PolygonMesh,
    exact: Vec<VertexId>,
    epsilon: f64,
    context: &Context<'_>,
) -> Result<Vec<VertexId>, PassError> {
    let mut classes = exact;
    loop {
        let joined = joined_once(mesh, classes.clone(), epsilon, context)?;
        if joined == classes {
            return Ok(classes);
        }
        classes = joined;
    }
}

/// The same, each class looked at once.
fn joined_once(
    mesh: &PolygonMesh,
    exact: Vec<VertexId>,
    epsilon: f64,
    context: &Context<'_>,
) -> Result<Vec<VertexId>, PassError> {
    let corners = mesh.faces().corner_vertices().iter().map(|vertex| exact[vertex.index()]).collect();
    let complex = Complex::of(&Arc::new(mesh.faces().over(mesh.counts().vertices, corners)?));
    let vertices = open_vertices(mesh, &complex);
    context.check_cancelled()?;
    let points: Vec<[f64; 3]> = vertices.iter().map(|&vertex| mesh.position(vertex)).collect();
    let most = PAIRS.0 * points.len() + PAIRS.1;
    let Some(pairs) = near_pairs(&points, epsilon, most) else {
        let reason = format!(
            "more than {most} pairs of the {} vertices of open edges are within {epsilon:e}; take a smaller distance",
            points.len()
        );
        return Err(PassError::Request { pass: "weld", reason });
    };
    context.check_cancelled()?;
    let mut classes = Classes::of(mesh, &exact, &complex, &vertices, &points);
    let near = Nearness::within(epsilon);
    pairs.into_iter().for_each(|pair| classes.join(pair, &near));
    let mut lowest = exact;
    let mut joined_to: Vec<VertexId> = (0..lowest.len()).map(VertexId::new).collect();
    for (place, &vertex) in vertices.iter().enumerate() {
        joined_to[vertex.index()] = vertices[classes.lowest(place) as usize];
    }
    lowest.iter_mut().for_each(|low| *low = joined_to[low.index()]);
    Ok(lowest)
}

/// The vertices at finite places that are ends of edges with one side, ascending.
fn open_vertices(mesh: &PolygonMesh, complex: &Complex) -> Vec<VertexId> {
    let edges = complex.edges();
    let open = edges.edges().filter(|&edge| edges.edge_sides(edge).len() == 1);
    let ends = open.flat_map(|edge| edges.ends(edge));
    let mut vertices: Vec<VertexId> = ends.filter(|&end| is_finite(&mesh.position(end))).collect();
    vertices.sort_unstable();
    vertices.dedup();
    vertices
}

/// Classes of some vertices, by their places in the list of these.
struct Classes<'a> {
    points: &'a [[f64; 3]],
    /// The class of each.
    class: Vec<u32>,
    /// The members of each class, ascending; none of one that was joined to another.
    members: Vec<Vec<u32>>,
    /// What has each class as a corner or an end, ascending: faces, and behind these loose edges.
    holders: Vec<Vec<u32>>,
}

impl<'a> Classes<'a> {
    fn of(
        mesh: &PolygonMesh,
        exact: &[VertexId],
        complex: &Complex,
        vertices: &[VertexId],
        points: &'a [[f64; 3]],
    ) -> Self {
        let mut holders: Vec<Vec<u32>> = vec![Vec::new(); vertices.len()];
        let mut hold = |vertex: VertexId, holder: u32| {
            if let Ok(place) = vertices.binary_search(&vertex) {
                holders[place].push(holder);
            }
        };
        let faces = complex.faces();
        for face in faces.faces() {
            faces.face_vertices(face).iter().for_each(|&vertex| hold(vertex, face.0));
        }
        for (ends, holder) in mesh.loose_edges().iter().zip(faces.face_count() as u32..) {
            ends.iter().for_each(|end| hold(exact[end.index()], holder));
        }
        holders.iter_mut().for_each(|holders| holders.dedup());
        let count = vertices.len() as u32;
        let members = (0..count).map(|place| vec![place]).collect();
        Classes { points, class: (0..count).collect(), members, holders }
    }

    /// Joins the classes of two vertices, if nothing is against it.
    fn join(&mut self, pair: [u32; 2], near: &Nearness) {
        let [one, other] = pair.map(|place| self.class[place as usize] as usize);
        let (kept, gone) = (one.min(other), one.max(other));
        if kept == gone || !self.may_join(kept, gone, near) {
            return;
        }
        let (members, holders) =
            (std::mem::take(&mut self.members[gone]), std::mem::take(&mut self.holders[gone]));
        members.iter().for_each(|&place| self.class[place as usize] = kept as u32);
        for (list, more) in [(&mut self.members[kept], members), (&mut self.holders[kept], holders)] {
            list.extend(more);
            list.sort_unstable();
        }
    }

    fn may_join(&self, one: usize, other: usize, near: &Nearness) -> bool {
        let is_shared = |holder: &u32| self.holders[other].binary_search(holder).is_ok();
        let point = |place: &u32| self.points[*place as usize];
        let is_near = |place: &u32| {
            let here = point(place);
            self.members[other].iter().all(|place| near.are_near(here, point(place)))
        };
        !self.holders[one].iter().any(is_shared) && self.members[one].iter().all(is_near)
    }

    /// The lowest vertex of the class of one: classes are joined to the lower one.
    fn lowest(&self, place: usize) -> u32 {
        self.class[place]
    }
}
