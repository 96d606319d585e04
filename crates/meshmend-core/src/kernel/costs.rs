//! What a kernel's answers cost, as it declares it.

/// What the first answer to a query costs; each further one takes constant time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "kebab-case"))]
pub enum Cost {
    /// The same on every mesh.
    Constant,
    /// In proportion to the corners at a vertex.
    Degree,
    /// In proportion to the whole mesh.
    Linear,
}

/// What each kind of query costs a kernel: the largest cost that it has on any mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Costs {
    /// What a corner has and what is next to it: vertex, edge, face, next and previous corner; and an edge's ends.
    pub corner: Cost,
    /// The corners of a face.
    pub face_star: Cost,
    /// The corners along an edge.
    pub edge_star: Cost,
    /// The corners at a vertex.
    pub vertex_star: Cost,
    /// The side across.
    pub across: Cost,
}

impl Costs {
    /// Everything in constant time.
    pub const CONSTANT: Costs = Costs {
        corner: Cost::Constant,
        face_star: Cost::Constant,
        edge_star: Cost::Constant,
        vertex_star: Cost::Constant,
        across: Cost::Constant,
    };
}
