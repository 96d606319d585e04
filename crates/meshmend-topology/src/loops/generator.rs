//! One generator, and the generators of one component.

use meshmend_core::{Defect, EdgeId, VertexId};
use serde::Serialize;

use super::weights::Measure;
use crate::{ComponentId, Surface};

/// What a generator goes round.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum GeneratorKind {
    /// A handle of an orientable surface: along it or round it.
    Handle,
    /// The cross-caps of a non-orientable surface.
    CrossCap,
    /// A hole.
    Boundary,
}

/// One of the closed paths that generate the first homology of a surface over ℤ/2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Generator {
    /// What it goes round.
    pub kind: GeneratorKind,
    /// How long it is, in the measure of its component.
    pub length: f64,
    /// How many vertices it has, all different.
    pub vertex_count: usize,
    /// Whether it has two sides, that is, an annular neighbourhood and no Möbius band.
    pub is_two_sided: bool,
    pub(super) path: Path,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Path {
    /// A left-over edge, and the vertex at which its two ways to the root meet.
    Closed { edge: EdgeId, ends: [VertexId; 2], apex: VertexId },
    /// A boundary loop, by its place.
    Boundary(usize),
}

/// The generators of a component, or why there are none.
#[derive(Clone, Debug, PartialEq)]
pub struct ComponentGenerators {
    /// The component.
    pub component: ComponentId,
    /// Where the generators begin and what they are; `None` for a component that is not a surface.
    pub system: Option<LoopSystem>,
    /// For a component that is not a surface, the first edge, or else the first vertex, that no surface has.
    pub obstacle: Option<Defect>,
    /// Its generators: by left-over edge, and then boundary loops by lowest vertex.
    pub generators: Vec<Generator>,
}

/// From where the loops of a surface were found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoopSystem {
    /// Which surface the component is.
    pub surface: Surface,
    /// The vertex at which the shortest paths begin.
    pub root: VertexId,
    /// In what lengths are measured.
    pub measure: Measure,
    /// How long all loops but the boundary's are together, each taken from the root and back to it.
    pub length: f64,
}
