//! All figures of a mesh in one answer.

use std::sync::Arc;

use serde::Serialize;

use crate::{Betti, ComponentKind, DefectList, Instigators};

/// The topology of a mesh: facts, sorted, without a word of text.
///
/// Vertices, edges and faces are those of the complex: referenced vertices, and no degenerate face. A figure that
/// is not defined for this mesh is absent, and [`undefined`](Self::undefined) says why.
#[derive(Clone, Debug, Serialize)]
#[non_exhaustive]
pub struct TopologyReport {
    /// V: vertices in some face of the complex.
    pub vertices: u64,
    /// E: unordered pairs of vertices that follow one another in some face.
    pub edges: u64,
    /// F: faces with three or more different vertices.
    pub faces: u64,
    /// Vertices in no face of the complex.
    pub unreferenced_vertices: u64,
    /// Edges that are elements of their own.
    pub loose_edges: u64,
    /// Points that are elements of their own.
    pub loose_points: u64,
    /// Vertices, unreferenced ones included, with a coordinate that is not finite.
    pub non_finite_vertices: u64,
    /// Faces with fewer than three different vertices.
    pub degenerate_faces: u64,
    /// Faces that come back to a vertex.
    pub non_simple_faces: u64,
    /// Faces that list a vertex twice in a row, or walk to a vertex and straight back.
    pub repeated_corner_faces: u64,
    /// Faces that repeat an earlier one.
    pub duplicate_faces: DuplicateCounts,
    /// Edges with one side.
    pub boundary_edges: u64,
    /// Edges with two sides.
    pub interior_edges: u64,
    /// Edges with three sides or more.
    pub non_manifold_edges: u64,
    /// Edges with two sides that run the same way.
    pub inconsistent_edges: u64,
    /// Vertices that are neither disc nor half-disc.
    pub non_manifold_vertices: NonManifoldVertexCounts,
    /// Whether every edge has one side or two and every vertex is disc or half-disc.
    pub manifold: bool,
    /// Whether there is a face and no edge has one side.
    pub closed: bool,
    /// Whether no edge is inconsistent.
    pub consistently_oriented: bool,
    /// Whether every patch is orientable.
    pub orientable: bool,
    /// χ = V − E + F.
    pub euler_characteristic: i64,
    /// s: classes of faces joined by shared vertices.
    pub components: u64,
    /// Classes of faces joined across edges with two sides.
    pub patches: u64,
    /// Patches that no flipping of faces makes consistent.
    pub non_orientable_patches: u64,
    /// b: boundary loops of all components; absent where one is not manifold.
    pub boundary_loops: Option<u64>,
    /// Handles of all orientable components; absent where a component is not manifold or none is orientable.
    pub genus: Option<u64>,
    /// Cross-caps of all non-orientable components; absent where a component is not manifold or none is
    /// non-orientable.
    pub cross_caps: Option<u64>,
    /// The Betti numbers.
    pub betti: Betti,
    /// Why a Betti number is absent.
    pub betti_unknown: Option<Reason>,
    /// Elements by what they negate and create.
    pub instigators: Instigators,
    /// The components by kind, ordered by lowest vertex.
    pub component_kinds: Vec<ComponentKind>,
    /// Which strips show that patches are not orientable.
    pub witness: Witness,
    /// Which figures are absent, and why.
    pub undefined: Vec<Undefined>,
    /// Where everything is that is wrong; apart from the figures, as it can be long.
    #[serde(skip)]
    pub defects: Arc<DefectList>,
}

/// How many faces repeat an earlier one, by the way in which they do.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct DuplicateCounts {
    /// With the same directed cycle.
    pub same: u64,
    /// With the reverse cycle, and none earlier the same.
    pub opposite: u64,
}

/// How many vertices are not vertices of a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct NonManifoldVertexCounts {
    /// With two umbrellas or more.
    pub pinched: u64,
    /// At an edge with three sides or more.
    pub singular: u64,
}

/// Which strip of faces shows that a patch is not orientable.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Witness {
    /// The one that is read off a breadth-first tree, in near-linear time.
    #[default]
    BreadthFirst,
    /// A shortest one.
    Shortest,
}

/// A figure that is absent.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Undefined {
    /// Its key in the report.
    pub figure: &'static str,
    /// Why it is absent.
    pub reason: Reason,
}

/// Why a figure is absent.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Reason {
    /// A component is not a surface, and only surfaces have the figure.
    NonManifoldComponent,
    /// There is no face that bounds anything, and so no surface.
    NoFaces,
    /// Only orientable components have the figure, and there is none.
    NoOrientableComponent,
    /// Only non-orientable components have the figure, and there is none.
    NoNonOrientableComponent,
    /// Elimination would touch more than [`ELIMINATION_BUDGET`](crate::ELIMINATION_BUDGET) matrix entries, or a
    /// reduction more than [`REDUCTION_BUDGET`](crate::REDUCTION_BUDGET).
    EliminationBudget,
    /// The faces that it needs do not fit the memory that may be used.
    BeyondMemory,
    /// The search would look more than [`ONE_SIDED_BUDGET`](crate::ONE_SIDED_BUDGET) times at a side.
    SearchBudget,
}
