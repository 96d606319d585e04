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

    /// Whether every complex is admitted.
    pub fn is_permissive(&self) -> bool {
        self.non_simple_faces
            && self.non_manifold_edges
            && self.non_manifold_vertices
            && self.mixed_orientation
            && self.polygons
    }
}
