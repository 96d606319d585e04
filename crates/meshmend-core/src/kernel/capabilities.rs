//! What a kernel holds, and what it offers.

/// What a kernel admits, and what it offers beyond the questions that all kernels answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Capabilities {
    /// Faces that come back to a vertex.
    pub non_simple_faces: bool,
    /// Edges with three sides or more.
    pub non_manifold_edges: bool,
    /// Vertices that are neither disc nor half-disc.
    pub non_manifold_vertices: bool,
    /// Edges both of whose sides run the same way.
    pub mixed_orientation: bool,
    /// Faces with more than three corners.
    pub polygons: bool,
    /// A vertex's corners come in rotational order instead of ascending.
    pub ordered_vertex_stars: bool,
}

impl Capabilities {
    /// A kernel that holds any complex.
    pub const PERMISSIVE: Capabilities = Capabilities {
        non_simple_faces: true,
        non_manifold_edges: true,
        non_manifold_vertices: true,
        mixed_orientation: true,
        polygons: true,
        ordered_vertex_stars: false,
    };

    /// Manifold meshes of simple faces of any size, directed as they please.
    pub const SURFACES: Capabilities = Capabilities {
        non_simple_faces: false,
        non_manifold_edges: false,
        non_manifold_vertices: false,
        mixed_orientation: true,
        polygons: true,
        ordered_vertex_stars: false,
    };

    /// Manifold meshes of simple faces of any size, each of which agrees with its neighbours.
    pub const ORIENTED_SURFACES: Capabilities =
        Capabilities { mixed_orientation: false, ..Capabilities::SURFACES };

    /// Manifold triangle meshes, each of whose faces agrees with its neighbours.
    pub const TRIANGLES: Capabilities = Capabilities { polygons: false, ..Capabilities::ORIENTED_SURFACES };

    /// Whether all that the other capabilities admit is admitted. The order of stars makes no difference.
    pub fn holds_all_of(&self, other: &Capabilities) -> bool {
        self.refused_kinds().all(|kind| other.refused_kinds().any(|refused| refused == kind))
    }

    /// What a mesh must be like to be held, in words; nothing for a kernel that holds anything.
    pub fn needs(&self) -> Vec<&'static str> {
        let needs = [
            (self.non_simple_faces, "no face that comes back to a vertex"),
            (self.polygons, "triangles"),
            (self.non_manifold_edges, "no edge with three faces or more"),
            (self.non_manifold_vertices, "no pinched vertex"),
            (self.mixed_orientation, "neighbours that agree on their side"),
        ];
        needs.into_iter().filter(|(is_able, _)| !is_able).map(|(_, need)| need).collect()
    }

    /// Whether no admitted edge has three sides or more and each admitted vertex has one umbrella.
    pub const fn is_manifold(&self) -> bool {
        !self.non_manifold_edges && !self.non_manifold_vertices
    }

    /// Whether every complex is admitted.
    pub fn is_permissive(&self) -> bool {
        self.non_simple_faces
            && self.non_manifold_edges
            && self.non_manifold_vertices
            && self.mixed_orientation
            && self.polygons
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_holds_more_holds_all_of_what_holds_less() {
        let ladder = [
            Capabilities::TRIANGLES,
            Capabilities::ORIENTED_SURFACES,
            Capabilities::SURFACES,
            Capabilities::PERMISSIVE,
        ];
        for (more, one) in ladder.iter().enumerate() {
            for (less, other) in ladder.iter().enumerate() {
                assert_eq!(one.holds_all_of(other), more >= less, "{one:?} {other:?}");
            }
        }
        assert!(Capabilities::SURFACES.is_manifold() && !Capabilities::PERMISSIVE.is_manifold());
    }
}
