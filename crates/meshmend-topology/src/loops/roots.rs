//! At which vertex do the loops of a component begin?

use std::num::NonZeroU32;

use meshmend_core::{Column, Connectivity, Id, VertexId};

use super::error::GeneratorError;
use super::surfaces::Surfaces;
use crate::ComponentId;

/// Which vertex of each component is the root.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Roots {
    /// The lowest.
    #[default]
    Lowest,
    /// This one in its component, the lowest in every other.
    At(VertexId),
    /// Of so many vertices, spread evenly over the component's in their order, the one whose loops are the shortest
    /// together, each taken from the root and back; of equal ones the lowest.
    Best(NonZeroU32),
}

/// One root for each component that is a surface; `None` for the others.
pub(super) type RootChoice = Column<ComponentId, Option<VertexId>>;

/// The lowest vertex of each surface.
pub(super) fn lowest_roots(surfaces: &Surfaces) -> RootChoice {
    let components = surfaces.components.ids();
    let root = |c| surfaces.facts[c].is_manifold.then(|| surfaces.components.lowest_vertex(c));
    components.map(root).collect()
}

/// A vertex for its own component, and the lowest vertex of each other surface.
pub(super) fn roots_with<K: Connectivity>(
    kernel: &K,
    surfaces: &Surfaces,
    vertex: VertexId,
) -> Result<RootChoice, GeneratorError> {
    let is_known = vertex.index() < kernel.vertex_count();
    let component = is_known.then(|| surfaces.components.of_vertex(vertex)).flatten();
    let component = component.ok_or(GeneratorError::NoSuchRoot(vertex))?;
    let mut roots = lowest_roots(surfaces);
    if let Some(root) = &mut roots[component] {
        *root = vertex;
    }
    Ok(roots)
}

/// For each surface the vertex that has `place` of `count` equal parts of the component's vertices before it.
///
/// *Cost*: one pass over the vertices.
pub(super) fn spread_roots<K: Connectivity>(
    kernel: &K,
    surfaces: &Surfaces,
    place: u32,
    count: NonZeroU32,
) -> RootChoice {
    let mut roots = Column::filled(None, surfaces.components.count());
    let mut passed = Column::filled(0, surfaces.components.count());
    for vertex in kernel.vertices() {
        let Some(component) = surfaces.of_vertex(vertex) else { continue };
        let in_all = u64::from(surfaces.facts[component].vertices);
        if passed[component] == in_all * u64::from(place) / u64::from(count.get()) {
            roots[component] = Some(vertex);
        }
        passed[component] += 1;
    }
    roots
}
