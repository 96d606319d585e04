//! Which components are surfaces, and what stands against the others?

use meshmend_core::{
    Cancelled, Column, Connectivity, Defect, EdgeClass, EdgeId, VertexClass, VertexId, Watch, edge_class,
    vertex_classes,
};

use super::STEP;
use crate::{
    BoundaryLoops, ComponentFacts, ComponentId, Components, Patches, boundary_loops, component_facts,
    components, patches,
};

/// What every question about loops has to know of a mesh beforehand.
pub(super) struct Surfaces {
    pub(super) components: Components,
    pub(super) facts: Column<ComponentId, ComponentFacts>,
    pub(super) patches: Patches,
    pub(super) boundary: BoundaryLoops,
    /// The first edge, or else the first vertex, that keeps a component from being a surface.
    pub(super) obstacles: Column<ComponentId, Option<Defect>>,
}

impl Surfaces {
    /// *Cost*: that of the questions which it asks, all near-linear.
    ///
    /// # Errors
    /// If the watch stops it.
    pub(super) fn of<K: Connectivity>(kernel: &K, watch: &Watch) -> Result<Self, Cancelled> {
        let look = || watch.look(STEP, 0, 0);
        look()?;
        let components = components(kernel);
        look()?;
        let patches = patches(kernel);
        look()?;
        let classes = vertex_classes(kernel);
        look()?;
        let boundary = boundary_loops(kernel);
        look()?;
        let facts = component_facts(kernel, &components, &patches, &classes, &boundary);
        look()?;
        let obstacles = obstacles(kernel, &components, &facts, &classes);
        Ok(Surfaces { components, facts, patches, boundary, obstacles })
    }

    /// The component of an edge, if it is a surface.
    pub(super) fn of_edge<K: Connectivity>(&self, kernel: &K, edge: EdgeId) -> Option<ComponentId> {
        self.of_vertex(kernel.edge_ends(edge)[0])
    }

    /// The component of a vertex, if it is a surface.
    pub(super) fn of_vertex(&self, vertex: VertexId) -> Option<ComponentId> {
        self.components.of_vertex(vertex).filter(|&component| self.facts[component].is_manifold)
    }
}

fn obstacles<K: Connectivity>(
    kernel: &K,
    components: &Components,
    facts: &Column<ComponentId, ComponentFacts>,
    classes: &Column<VertexId, VertexClass>,
) -> Column<ComponentId, Option<Defect>> {
    let mut found = Column::filled(None, components.count());
    if facts.values().iter().all(|facts| facts.is_manifold) {
        return found;
    }
    let mut note = |vertex: VertexId, defect: Defect| {
        if let Some(component) = components.of_vertex(vertex) {
            found[component].get_or_insert(defect);
        }
    };
    for edge in kernel.edges().filter(|&edge| edge_class(kernel, edge) == EdgeClass::NonManifold) {
        let (ends, degree) = (kernel.edge_ends(edge), kernel.edge_degree(edge) as u32);
        note(ends[0], Defect::non_manifold_edge(edge, ends, degree));
    }
    for (vertex, &class) in classes.iter() {
        if let VertexClass::Pinched { umbrellas, boundary_only } = class {
            note(vertex, Defect::pinched_vertex(vertex, umbrellas, boundary_only));
        }
    }
    found
}
