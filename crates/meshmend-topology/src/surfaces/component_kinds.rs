//! What is each component, and how often is there one just like it?
//!
//! A manifold component is named by the classification theorem. One that is not has neither name nor genus nor
//! loops: they are absent, never guessed. Components with the same row are counted in it.

use meshmend_core::{Column, Connectivity, EdgeClass, VertexClass, VertexId, edge_class};
use serde::Serialize;

use crate::{BoundaryLoops, ComponentId, Components, Patches, Surface, surface_name};

/// What is known of one component.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct ComponentFacts {
    /// How many vertices.
    pub vertices: u32,
    /// How many edges.
    pub edges: u32,
    /// How many faces.
    pub faces: u32,
    /// Whether every patch is orientable.
    pub is_orientable: bool,
    /// Whether no edge has one side.
    pub is_closed: bool,
    /// Whether every edge has one side or two and every vertex is disc or half-disc.
    pub is_manifold: bool,
    /// How many boundary loops touch it.
    pub loops: u32,
}

impl ComponentFacts {
    /// Those of a component of which nothing is known yet: each element adds to them.
    pub const NOTHING: ComponentFacts = ComponentFacts {
        vertices: 0,
        edges: 0,
        faces: 0,
        is_orientable: true,
        is_closed: true,
        is_manifold: true,
        loops: 0,
    };

    /// V − E + F.
    pub fn euler_characteristic(&self) -> i64 {
        i64::from(self.vertices) - i64::from(self.edges) + i64::from(self.faces)
    }

    /// The surface that the component is; `None` where it is not manifold.
    pub fn surface(&self) -> Option<Surface> {
        match (self.is_manifold, self.is_orientable) {
            (false, _) => None,
            (true, true) => Surface::orientable(self.euler_characteristic(), self.loops.into()),
            (true, false) => Surface::non_orientable(self.euler_characteristic(), self.loops.into()),
        }
    }
}

/// Components that are alike in all figures.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct ComponentKind {
    /// How many there are.
    pub count: u64,
    /// What the surface is called; absent where a component is not manifold.
    pub name: Option<String>,
    /// How many vertices each has.
    pub vertices: u64,
    /// How many edges.
    pub edges: u64,
    /// How many faces.
    pub faces: u64,
    /// V − E + F.
    pub euler_characteristic: i64,
    /// How many boundary loops; absent where a component is not manifold.
    pub boundary_loops: Option<u64>,
    /// Whether every patch is orientable.
    pub orientable: bool,
    /// How many handles; absent where a component is not manifold or not orientable.
    pub genus: Option<u64>,
    /// How many cross-caps; absent where a component is not manifold, or is orientable.
    pub cross_caps: Option<u64>,
    /// Whether no edge has one side.
    pub closed: bool,
    /// Whether it is a surface.
    pub manifold: bool,
    /// The lowest vertex of the first of them.
    pub first_vertex: VertexId,
}

/// What is known of each component.
///
/// *Cost*: linear in the elements.
pub fn component_facts<K: Connectivity>(
    kernel: &K,
    components: &Components,
    patches: &Patches,
    vertex_classes: &Column<VertexId, VertexClass>,
    loops: &BoundaryLoops,
) -> Column<ComponentId, ComponentFacts> {
    let mut facts = Column::filled(ComponentFacts::NOTHING, components.count());
    for (vertex, class) in vertex_classes.iter() {
        if let Some(component) = components.of_vertex(vertex) {
            facts[component].vertices += 1;
            facts[component].is_manifold &= class.is_manifold();
        }
    }
    for edge in kernel.edges() {
        let Some(component) = components.of_vertex(kernel.edge_ends(edge)[0]) else { continue };
        facts[component].edges += 1;
        match edge_class(kernel, edge) {
            EdgeClass::Boundary => facts[component].is_closed = false,
            EdgeClass::Interior => {}
            EdgeClass::NonManifold => facts[component].is_manifold = false,
        }
    }
    for patch in patches.ids() {
        let faces = patches.faces(patch);
        let vertex = faces.first().and_then(|&face| kernel.face_vertices(face).next());
        let Some(component) = vertex.and_then(|v| components.of_vertex(v)) else { continue };
        facts[component].faces += faces.len() as u32;
        facts[component].is_orientable &= patches.is_orientable(patch);
    }
    for path in loops.iter() {
        if let Some(component) = path.first().and_then(|&v| components.of_vertex(v)) {
            facts[component].loops += 1;
        }
    }
    facts
}

/// The components by kind, ordered by the lowest vertex of each kind.
///
/// *Cost*: n log n in the number of components.
pub fn component_kinds(
    components: &Components,
    facts: &Column<ComponentId, ComponentFacts>,
) -> Vec<ComponentKind> {
    let row = |component: ComponentId| facts[component].row();
    let mut sorted: Vec<ComponentId> = components.ids().collect();
    sorted.sort_unstable_by_key(|&component| (row(component), component));
    let alike = sorted.chunk_by(|&one, &other| row(one) == row(other));
    let kind = |run: &[ComponentId]| {
        ComponentKind::of(row(run[0]), run.len() as u64, components.lowest_vertex(run[0]))
    };
    let mut kinds: Vec<ComponentKind> = alike.map(kind).collect();
    kinds.sort_unstable_by_key(|kind| kind.first_vertex);
    kinds
}

impl ComponentFacts {
    /// The facts that tell components apart. Loops that touch a component which is not a surface do not count.
    #[must_use]
    pub fn row(self) -> Self {
        ComponentFacts { loops: if self.is_manifold { self.loops } else { 0 }, ..self }
    }
}

impl ComponentKind {
    /// So many components with these facts, the first of which has this lowest vertex.
    pub fn of(facts: ComponentFacts, count: u64, first_vertex: VertexId) -> Self {
        let surface = facts.surface();
        ComponentKind {
            count,
            name: surface.map(surface_name),
            vertices: facts.vertices.into(),
            edges: facts.edges.into(),
            faces: facts.faces.into(),
            euler_characteristic: facts.euler_characteristic(),
            boundary_loops: surface.map(Surface::holes),
            orientable: facts.is_orientable,
            genus: surface.and_then(Surface::genus),
            cross_caps: surface.and_then(Surface::cross_caps),
            closed: facts.is_closed,
            manifold: facts.is_manifold,
            first_vertex,
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::shapes::{self, Shape};

    #[test]
    fn equal_rows_are_counted_in_one() {
        let parts =
            [shapes::tetrahedron(), shapes::bow_tie(), shapes::tetrahedron(), shapes::moebius_band(5)];
        let kinds = Shape::side_by_side(&parts).report().component_kinds;
        let rows: Vec<_> = kinds.iter().map(|k| (k.count, k.name.as_deref(), k.first_vertex.0)).collect();
        assert_eq!(rows, [(2, Some("sphere"), 0), (1, None, 4), (1, Some("Möbius band"), 13)]);
        assert_eq!((kinds[1].genus, kinds[1].boundary_loops, kinds[1].cross_caps), (None, None, None));
        assert_eq!((kinds[2].genus, kinds[2].boundary_loops, kinds[2].cross_caps), (None, Some(1), Some(1)));
        assert_eq!((kinds[0].genus, kinds[0].cross_caps), (Some(0), None));
    }
}
