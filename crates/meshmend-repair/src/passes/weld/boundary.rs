//! Which vertices of open edges are joined to close a crack.
//!
//! Pairs of boundary vertices within the distance are taken by their distance, nearest first, then by their ids. Their classes
//! are joined unless the joined class would hold two corners of a face, two ends of a loose edge, or two vertices farther apart
//! than the distance. So what is whole stays as it is, no face loses a corner, and no chain of vertices shrinks to a point.
//!
//! A class is where its lowest vertex is, and that may be near others. So this is done again with the classes as vertices, until
//! nothing is joined: a second run would find it.

use std::sync::Arc;

use meshmend_core::{Cancelled, Complex, DraftError, Id, PolygonMesh, VertexId, Watch};
use meshmend_geometry::proximity::Nearness;
use meshmend_geometry::vector::{dot, is_finite, minus};
use meshmend_spatial::near_pairs;

use super::ROW;
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
    let open = OpenEdges::of(mesh, &exact)?;
    context.check_cancelled()?;
    let most = open.most_pairs();
    let watch = (context.watch(), ROW.name);
    let Some(pairs) = near_pairs(&open.points, epsilon, most, watch)? else {
        let reason = format!(
            "more than {most} pairs of the {} vertices of open edges are within {epsilon:e}; take a smaller distance",
            open.points.len()
        );
        return Err(PassError::Request { pass: ROW.name, reason });
    };
    context.check_cancelled()?;
    let mut classes = open.classes();
    let near = Nearness::within(epsilon);
    pairs.into_iter().for_each(|pair| classes.join_if_near(pair, &near));
    let mut lowest = exact;
    let mut joined_to: Vec<VertexId> = (0..lowest.len()).map(VertexId::new).collect();
    for (place, &vertex) in (0..).zip(&open.vertices) {
        joined_to[vertex.index()] = open.vertices[classes.class_of(place) as usize];
    }
    lowest.iter_mut().for_each(|low| *low = joined_to[low.index()]);
    Ok(lowest)
}

/// The open edges of a mesh whose vertices were put into classes, and their ends at finite places.
pub(crate) struct OpenEdges {
    /// The ends, ascending.
    vertices: Vec<VertexId>,
    points: Vec<[f64; 3]>,
    /// The edges with both ends at finite places, by the places of their ends among the vertices.
    edges: Vec<[u32; 2]>,
    /// What has each of the vertices as a corner or an end, ascending: faces, and behind these loose edges.
    holders: Vec<Vec<u32>>,
}

/// Two vertices of open edges that are near each other, by their places among these.
pub(crate) struct NearPair {
    pub(crate) distance: f64,
    pub(crate) places: [u32; 2],
}

impl OpenEdges {
    /// The open edges of the mesh in which each vertex is the lowest one of its class.
    ///
    /// *Cost*: O(n log n).
    pub(crate) fn of(mesh: &PolygonMesh, classes: &[VertexId]) -> Result<Self, DraftError> {
        let corners = mesh.faces().corner_vertices().iter().map(|vertex| classes[vertex.index()]).collect();
        let complex = Complex::of(&Arc::new(mesh.faces().over(mesh.counts().vertices, corners)?));
        let edges = complex.edges();
        let open =
            || edges.edges().filter(|&edge| edges.edge_sides(edge).len() == 1).map(|edge| edges.ends(edge));
        let mut vertices: Vec<VertexId> =
            open().flatten().filter(|&end| is_finite(&mesh.position(end))).collect();
        vertices.sort_unstable();
        vertices.dedup();
        let place = |vertex: VertexId| vertices.binary_search(&vertex).ok().map(|place| place as u32);
        let mut holders: Vec<Vec<u32>> = vec![Vec::new(); vertices.len()];
        let mut hold = |vertex: VertexId, holder: u32| {
            if let Some(place) = place(vertex) {
                holders[place as usize].push(holder);
            }
        };
        let faces = complex.faces();
        for face in faces.faces() {
            faces.face_vertices(face).iter().for_each(|&vertex| hold(vertex, face.0));
        }
        for (ends, holder) in mesh.loose_edges().iter().zip(faces.face_count() as u32..) {
            ends.iter().for_each(|end| hold(classes[end.index()], holder));
        }
        holders.iter_mut().for_each(|holders| holders.dedup());
        let edges = open().filter_map(|[one, other]| Some([place(one)?, place(other)?])).collect();
        let points = vertices.iter().map(|&vertex| mesh.position(vertex)).collect();
        Ok(OpenEdges { vertices, points, edges, holders })
    }

    /// How many vertices there are at finite places.
    pub(crate) fn vertex_count(&self) -> usize {
        self.vertices.len()
    }

    /// The edges, by the places of their ends.
    pub(crate) fn edges(&self) -> &[[u32; 2]] {
        &self.edges
    }

    /// Each vertex in a class of its own.
    pub(crate) fn classes(&self) -> Classes<'_> {
        let count = self.vertices.len() as u32;
        let members = (0..count).map(|place| vec![place]).collect();
        Classes { points: &self.points, class: (0..count).collect(), members, holders: self.holders.clone() }
    }

    /// The pairs of vertices within a distance, nearest first, and that distance; a shorter one where there are very many.
    ///
    /// # Errors
    /// When whoever watches the step stops it.
    pub(crate) fn near_pairs(
        &self,
        mut within: f64,
        watch: (&Watch, &'static str),
    ) -> Result<(Vec<NearPair>, f64), Cancelled> {
        let most = self.most_pairs();
        let pairs = loop {
            match near_pairs(&self.points, within, most, watch)? {
                Some(pairs) => break pairs,
                None => within /= 2.0,
            }
        };
        let distance = |places: [u32; 2]| {
            let [one, other] = places.map(|place| self.points[place as usize]);
            let between = minus(one, other);
            dot(between, between).sqrt()
        };
        let pairs = pairs.into_iter().map(|places| NearPair { distance: distance(places), places });
        Ok((pairs.collect(), within))
    }

    /// How many of the edges coincide with others after a weld along open edges within a distance. `exact` are the classes that
    /// the edges were found with.
    ///
    /// # Errors
    /// As the weld.
    pub(crate) fn coincident_within(
        &self,
        mesh: &PolygonMesh,
        exact: Vec<VertexId>,
        epsilon: f64,
        context: &Context<'_>,
    ) -> Result<u64, PassError> {
        let classes = joined_along_boundaries(mesh, exact, epsilon, context)?;
        let class = |place: u32| classes[self.vertices[place as usize].index()];
        let mut edges: Vec<[VertexId; 2]> = self.edges.iter().map(|ends| ends.map(class)).collect();
        edges.iter_mut().for_each(|ends| ends.sort_unstable());
        edges.sort_unstable();
        let places = edges.chunk_by(|one, other| one == other).map(<[_]>::len);
        Ok(places.filter(|&count| count > 1).sum::<usize>() as u64)
    }

    /// Distances with more pairs than this are larger than the edges of the mesh.
    fn most_pairs(&self) -> usize {
        PAIRS.0 * self.vertices.len() + PAIRS.1
    }
}

/// Classes of the vertices of open edges, by their places among these. A class has the place of its lowest vertex.
pub(crate) struct Classes<'a> {
    points: &'a [[f64; 3]],
    /// The class of each.
    class: Vec<u32>,
    /// The members of each class, ascending; none of one that was joined to another.
    members: Vec<Vec<u32>>,
    /// What has each class as a corner or an end, ascending: faces, and behind these loose edges.
    holders: Vec<Vec<u32>>,
}

impl Classes<'_> {
    /// The class of a vertex.
    pub(crate) fn class_of(&self, place: u32) -> u32 {
        self.class[place as usize]
    }

    /// Whether some face or loose edge has both classes.
    pub(crate) fn share_a_holder(&self, one: u32, other: u32) -> bool {
        let is_shared = |holder: &u32| self.holders[other as usize].binary_search(holder).is_ok();
        self.holders[one as usize].iter().any(is_shared)
    }

    /// Joins two classes.
    pub(crate) fn join(&mut self, one: u32, other: u32) {
        let (kept, gone) = (one.min(other) as usize, one.max(other) as usize);
        let (members, holders) =
            (std::mem::take(&mut self.members[gone]), std::mem::take(&mut self.holders[gone]));
        members.iter().for_each(|&place| self.class[place as usize] = kept as u32);
        for (list, more) in [(&mut self.members[kept], members), (&mut self.holders[kept], holders)] {
            list.extend(more);
            list.sort_unstable();
        }
    }

    /// Joins the classes of two vertices, if nothing is against it.
    fn join_if_near(&mut self, pair: [u32; 2], near: &Nearness) {
        let [one, other] = pair.map(|place| self.class_of(place));
        if one != other && !self.share_a_holder(one, other) && self.are_near(one, other, near) {
            self.join(one, other);
        }
    }

    /// Whether each member of a class is near each of another.
    fn are_near(&self, one: u32, other: u32, near: &Nearness) -> bool {
        let point = |place: &u32| self.points[*place as usize];
        let others = &self.members[other as usize];
        self.members[one as usize].iter().all(|place| {
            let here = point(place);
            others.iter().all(|place| near.are_near(here, point(place)))
        })
    }
}
