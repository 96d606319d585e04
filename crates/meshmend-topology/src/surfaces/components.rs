//! Which faces hang together through shared vertices?
//!
//! Two faces are of one *component* when a chain of faces leads from one to the other, each sharing a vertex with
//! the next. So two cones tip to tip are one component, of two [patches](crate::patches()). Unreferenced vertices
//! are in none. Their number is the Betti number β₀.
//!
//! *Source*: A. Bærentzen, *On the Topology of Polygonal Meshes*, 2025, §4.0.1.

use meshmend_core::{Column, Connectivity, Id, VertexId};
use petgraph::unionfind::UnionFind;

use crate::ComponentId;

/// The connected components of a complex, numbered by lowest vertex.
#[derive(Clone, Debug)]
pub struct Components {
    /// A component for each vertex, `NO_COMPONENT` for an unreferenced one.
    of_vertex: Column<VertexId, u32>,
    lowest_vertex: Column<ComponentId, VertexId>,
}

const NO_COMPONENT: u32 = u32::MAX;

impl Components {
    /// How many components there are.
    pub fn count(&self) -> usize {
        self.lowest_vertex.len()
    }

    /// Every component, ascending.
    pub fn ids(&self) -> impl ExactSizeIterator<Item = ComponentId> + Clone + use<> {
        (0..self.count()).map(ComponentId::new)
    }

    /// The component of a vertex; `None` for an unreferenced one.
    #[inline]
    pub fn of_vertex(&self, vertex: VertexId) -> Option<ComponentId> {
        let component = self.of_vertex[vertex];
        (component != NO_COMPONENT).then_some(ComponentId(component))
    }

    /// The lowest vertex of a component.
    pub fn lowest_vertex(&self, component: ComponentId) -> VertexId {
        self.lowest_vertex[component]
    }

    /// How many vertices are in some component, that is, in some face of the complex.
    pub fn referenced_vertices(&self) -> usize {
        self.of_vertex.values().iter().filter(|&&component| component != NO_COMPONENT).count()
    }
}

/// The connected components of a complex, by shared vertices.
///
/// *Cost*: near-linear in the corners; 9 bytes a vertex.
pub fn components<K: Connectivity>(kernel: &K) -> Components {
    let mut classes = UnionFind::<u32>::new(kernel.vertex_count());
    for face in kernel.faces() {
        let mut vertices = kernel.face_vertices(face);
        if let Some(first) = vertices.next() {
            vertices.for_each(|vertex| {
                classes.union(first.0, vertex.0);
            });
        }
    }
    let mut component_of_root = vec![NO_COMPONENT; kernel.vertex_count()];
    let mut lowest_vertex = Column::default();
    let number = |vertex: VertexId| {
        if !kernel.is_referenced(vertex) {
            return NO_COMPONENT;
        }
        let component = &mut component_of_root[classes.find_mut(vertex.0) as usize];
        if *component == NO_COMPONENT {
            let new: ComponentId = lowest_vertex.push(vertex);
            *component = new.0;
        }
        *component
    };
    let of_vertex = kernel.vertices().map(number).collect();
    Components { of_vertex, lowest_vertex }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::kernel;

    #[test]
    fn components_are_numbered_by_lowest_vertex() {
        let found = components(&kernel(9, &[&[6, 7, 8], &[1, 2, 3], &[3, 4, 5]]));
        assert_eq!(found.count(), 2);
        let of: Vec<_> = (0..9).map(|v| found.of_vertex(VertexId(v)).map(|c| c.0)).collect();
        assert_eq!(of, [None, Some(0), Some(0), Some(0), Some(0), Some(0), Some(1), Some(1), Some(1)]);
        assert_eq!(found.lowest_vertex(ComponentId(1)), VertexId(6));
        assert_eq!(found.referenced_vertices(), 8);
    }

    #[test]
    fn a_degenerate_face_joins_nothing() {
        let found = components(&kernel(6, &[&[0, 1, 2], &[2, 3], &[3, 4, 5]]));
        assert_eq!(found.count(), 2);
    }
}
