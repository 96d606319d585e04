//! The points of vertices: one each, or places that vertices share.

use std::sync::{Arc, OnceLock};

use crate::{Id, VertexId};

/// Points of which several vertices have the same.
///
/// A soup has six times as many vertices as places. Whoever reads one may find that out as it reads, and then the soup takes
/// half the memory, and is welded without looking at its points again.
#[derive(Clone, Debug, Default)]
pub struct SharedPlaces {
    points: Arc<Vec<[f64; 3]>>,
    of_vertex: Arc<Vec<VertexId>>,
}

impl SharedPlaces {
    /// Points that differ, to the bit, in the order in which vertices first have them, and for each vertex which one it has.
    /// `None` if the vertices don't come to the points in that order, or not to all of them.
    ///
    /// *Cost*: one pass over the vertices.
    pub fn new(points: Vec<[f64; 3]>, of_vertex: Vec<VertexId>) -> Option<Self> {
        let mut next = 0;
        for &VertexId(place) in &of_vertex {
            if place > next {
                return None;
            }
            next += u32::from(place == next);
        }
        let is_whole = next as usize == points.len();
        is_whole.then(|| SharedPlaces { points: Arc::new(points), of_vertex: Arc::new(of_vertex) })
    }

    /// The points, in the order in which vertices first have them.
    pub fn points(&self) -> &[[f64; 3]] {
        &self.points
    }

    /// The points, to be shared.
    pub fn shared_points(&self) -> Arc<Vec<[f64; 3]>> {
        Arc::clone(&self.points)
    }

    /// For each vertex the number of its point: the vertex that it is once they are welded.
    pub fn of_vertex(&self) -> &[VertexId] {
        &self.of_vertex
    }

    /// For each point the lowest vertex that has it.
    ///
    /// *Cost*: one pass over the vertices.
    pub fn first_vertices(&self) -> Vec<VertexId> {
        let mut first = Vec::with_capacity(self.points.len());
        for (vertex, place) in self.of_vertex.iter().enumerate() {
            if place.index() == first.len() {
                first.push(VertexId::new(vertex));
            }
        }
        first
    }

    /// Those of each vertex, to be shared.
    pub(super) fn shared_of_vertex(&self) -> &Arc<Vec<VertexId>> {
        &self.of_vertex
    }

    fn of_each(&self) -> Vec<[f64; 3]> {
        self.of_vertex.iter().map(|place| self.points[place.index()]).collect()
    }
}

/// The points of all vertices of a mesh.
#[derive(Clone, Debug)]
pub(crate) struct Points {
    shared: Option<SharedPlaces>,
    /// That of each vertex; of places that are shared it is listed when that is first asked for.
    each: OnceLock<Arc<Vec<[f64; 3]>>>,
}

impl Points {
    pub(super) fn each(&self) -> &[[f64; 3]] {
        self.each.get_or_init(|| self.shared.as_ref().map(SharedPlaces::of_each).unwrap_or_default().into())
    }

    pub(super) fn shared(&self) -> Option<&SharedPlaces> {
        self.shared.as_ref()
    }

    #[inline]
    pub(super) fn of(&self, vertex: usize) -> [f64; 3] {
        match &self.shared {
            None => self.each()[vertex],
            Some(shared) => shared.points[shared.of_vertex[vertex].index()],
        }
    }

    pub(super) fn len(&self) -> usize {
        self.shared.as_ref().map_or_else(|| self.each().len(), |shared| shared.of_vertex.len())
    }
}

impl From<Arc<Vec<[f64; 3]>>> for Points {
    fn from(points: Arc<Vec<[f64; 3]>>) -> Self {
        Points { shared: None, each: OnceLock::from(points) }
    }
}

impl From<Vec<[f64; 3]>> for Points {
    fn from(points: Vec<[f64; 3]>) -> Self {
        Arc::new(points).into()
    }
}

impl From<SharedPlaces> for Points {
    fn from(shared: SharedPlaces) -> Self {
        Points { shared: Some(shared), each: OnceLock::new() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{FaceTable, PolygonMesh};

    #[test]
    fn a_mesh_of_shared_places_is_that_of_their_points() {
        let points = vec![[0.0, -0.0, 1.0], [0.0, 0.0, 1.0], [f64::NAN; 3]];
        let faces = || FaceTable::triangles(6, [0, 1, 2, 3, 4, 5].map(VertexId).to_vec()).unwrap();
        let shared = SharedPlaces::new(points.clone(), [0, 1, 0, 2, 2, 1].map(VertexId).to_vec()).unwrap();
        let mesh = PolygonMesh::of_shared_places(shared, faces()).unwrap();
        let bits = |point: [f64; 3]| point.map(f64::to_bits);
        let expected = [0, 1, 0, 2, 2, 1].map(|place: usize| bits(points[place]));
        assert_eq!([0, 1, 2, 3, 4, 5].map(|vertex| bits(mesh.position(VertexId(vertex)))), expected);
        assert_eq!(mesh.positions().iter().map(|&point| bits(point)).collect::<Vec<_>>(), expected);
        assert_eq!(mesh.counts().vertices, 6);
        let few = SharedPlaces::new(points.clone(), [0, 1, 2].map(VertexId).to_vec()).unwrap();
        assert!(PolygonMesh::of_shared_places(few, faces()).is_err());
        assert!(mesh.with_positions(vec![[0.0; 3]; 6]).unwrap().shared_places().is_none());
    }

    #[test]
    fn vertices_come_to_all_points_in_order() {
        let points = vec![[0.0; 3], [1.0; 3]];
        assert!(SharedPlaces::new(points.clone(), [1, 0].map(VertexId).to_vec()).is_none());
        assert!(SharedPlaces::new(points.clone(), [0, 0].map(VertexId).to_vec()).is_none());
        assert!(SharedPlaces::new(points, [0, 1, 2].map(VertexId).to_vec()).is_none());
        assert!(SharedPlaces::new(Vec::new(), Vec::new()).is_some());
    }
}
