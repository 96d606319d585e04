//! How large the surface of each component is, and which way its faces look on the whole.

use meshmend_core::{Column, Connectivity, EdgeId, PolygonMesh};
use meshmend_geometry::vector::{Point, is_finite};
use meshmend_topology::{ComponentId, Components};

use super::NoSide;
use super::figures::LoopArea;
use crate::unit::Unit;

/// The faces of a component on the whole, in a unit of its own.
#[derive(Clone, Copy, Debug)]
pub(super) struct ComponentArea {
    pub(super) unit: Unit,
    /// How many faces it has, if all are finite.
    pub(super) faces: u32,
    /// Twice its area.
    pub(super) area: f64,
    /// Twice its faces' area vectors together.
    pub(super) sum: Point,
    /// Why its faces have no side.
    pub(super) no_side: Option<NoSide>,
}

impl ComponentArea {
    /// Takes a reason; the first in their order stays.
    fn object(&mut self, reason: NoSide) {
        self.no_side = Some(self.no_side.map_or(reason, |known| known.min(reason)));
    }
}

/// The faces of each component on the whole.
///
/// *Cost*: linear; some microseconds for a face so thin that rounding leaves no digits of its area.
pub(super) fn component_areas<K: Connectivity>(
    kernel: &K,
    mesh: &PolygonMesh,
    components: &Components,
) -> Column<ComponentId, ComponentArea> {
    let mut areas = units(kernel, mesh, components);
    for edge in kernel.edges() {
        if let Some(reason) = objection(kernel, edge)
            && let Some(component) = components.of_vertex(kernel.edge_ends(edge)[0])
        {
            areas[component].object(reason);
        }
    }
    let mut points: Vec<Point> = Vec::new();
    for face in kernel.faces() {
        let mut vertices = kernel.face_vertices(face);
        let Some(component) = vertices.next().and_then(|first| components.of_vertex(first)) else { continue };
        let of_component = &mut areas[component];
        if of_component.no_side == Some(NoSide::NotFinite) {
            continue;
        }
        points.clear();
        points.extend(kernel.face_vertices(face).map(|v| of_component.unit.shrunk(mesh.position(v))));
        of_component.faces += 1;
        let area = LoopArea::of(&points);
        of_component.area += area.twice;
        if let Some(direction) = area.direction {
            of_component.sum = std::array::from_fn(|i| of_component.sum[i] + direction[i] * area.twice);
        }
    }
    areas
}

/// The unit of each component, and whether its corners are finite; figures still 0.
fn units<K: Connectivity>(
    kernel: &K,
    mesh: &PolygonMesh,
    components: &Components,
) -> Column<ComponentId, ComponentArea> {
    let mut largest = Column::<ComponentId, f64>::filled(0.0, components.count());
    for vertex in kernel.vertices() {
        let Some(component) = components.of_vertex(vertex) else { continue };
        let point = mesh.position(vertex);
        let size = point.iter().fold(largest[component], |most, x| most.max(x.abs()));
        largest[component] = if is_finite(&point) { size } else { f64::INFINITY };
    }
    let empty = |&size: &f64| ComponentArea {
        unit: Unit::of(size),
        faces: 0,
        area: 0.0,
        sum: [0.0; 3],
        no_side: size.is_infinite().then_some(NoSide::NotFinite),
    };
    largest.values().iter().map(empty).collect()
}

fn objection<K: Connectivity>(kernel: &K, edge: EdgeId) -> Option<NoSide> {
    let mut sides = kernel.edge_sides(edge).map(|(_, is_forward)| is_forward);
    match (sides.next(), sides.next(), sides.next()) {
        (_, _, Some(_)) => Some(NoSide::NonManifold),
        (Some(one), Some(other), None) if one == other => Some(NoSide::Inconsistent),
        _ => None,
    }
}
