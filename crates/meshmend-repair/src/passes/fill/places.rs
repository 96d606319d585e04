//! Which triangles are there already by the positions of their corners, in meshes some of whose vertices share places.

use std::collections::BTreeSet;

use meshmend_core::{Id, PolygonMesh, VertexId};
use meshmend_geometry::Precision;
use meshmend_geometry::coincident::{coincident_in_single, coincident_vertices};
use meshmend_geometry::proximity::proximity_classes;

use crate::Clearance;

/// The triangles that have a corner at a place that vertices share.
pub(super) struct TrianglesByPlace {
    /// For each vertex the lowest one in its place.
    lowest: Vec<VertexId>,
    is_shared: Vec<bool>,
    /// By their places, ascending.
    triangles: BTreeSet<[VertexId; 3]>,
}

impl TrianglesByPlace {
    /// Vertices are in one place when a weld of the result would join them.
    ///
    /// *Cost*: linear, and O(n log n) in the triangles at shared places.
    pub(super) fn of(mesh: &PolygonMesh, clearance: Clearance) -> Self {
        let exactly = || match clearance.apart {
            Precision::Double => coincident_vertices(mesh),
            Precision::Single => coincident_in_single(mesh),
        };
        let within = (clearance.tolerance > 0.0)
            .then(|| proximity_classes(mesh.positions(), clearance.tolerance, &|| true).ok())
            .flatten();
        let lowest = within.unwrap_or_else(exactly);
        let mut is_shared = vec![false; lowest.len()];
        for (vertex, low) in lowest.iter().enumerate() {
            if low.index() != vertex {
                is_shared[vertex] = true;
                is_shared[low.index()] = true;
            }
        }
        let mut found = TrianglesByPlace { lowest, is_shared, triangles: BTreeSet::new() };
        if found.is_shared.contains(&true) {
            for face in mesh.faces().faces() {
                if let &[a, b, c] = mesh.faces().face_vertices(face) {
                    found.add([a, b, c]);
                }
            }
        }
        found
    }

    /// Whether a vertex shares its place.
    pub(super) fn is_shared(&self, vertex: VertexId) -> bool {
        self.is_shared[vertex.index()]
    }

    /// Whether a triangle is there, either way round, at a place that vertices share; or has two corners in one place.
    pub(super) fn excludes(&self, triangle: [VertexId; 3]) -> bool {
        let places = self.places(triangle);
        places[0] == places[1] || places[1] == places[2] || self.triangles.contains(&places)
    }

    /// Adds a triangle, if one of its places is shared.
    pub(super) fn add(&mut self, triangle: [VertexId; 3]) {
        if triangle.iter().any(|&vertex| self.is_shared(vertex)) {
            self.triangles.insert(self.places(triangle));
        }
    }

    /// Whether two of some new triangles have the same places.
    pub(super) fn are_repeated(&self, triangles: impl Iterator<Item = [VertexId; 3]>) -> bool {
        let mut places: Vec<[VertexId; 3]> = triangles.map(|triangle| self.places(triangle)).collect();
        places.sort_unstable();
        places.windows(2).any(|two| two[0] == two[1])
    }

    /// Whether two sides of a loop run between the same places, or one within a place.
    pub(super) fn runs_twice(&self, vertices: &[VertexId]) -> bool {
        let after = vertices.iter().cycle().skip(1);
        let place = |vertex: VertexId| self.lowest[vertex.index()];
        let sides = vertices.iter().zip(after).map(|(&from, &to)| (place(from), place(to)));
        let mut sides: Vec<_> = sides.map(|(from, to)| (from.min(to), from.max(to))).collect();
        sides.sort_unstable();
        sides.iter().any(|(from, to)| from == to) || sides.windows(2).any(|two| two[0] == two[1])
    }

    fn places(&self, triangle: [VertexId; 3]) -> [VertexId; 3] {
        let mut places = triangle.map(|vertex| self.lowest[vertex.index()]);
        places.sort_unstable();
        places
    }
}
