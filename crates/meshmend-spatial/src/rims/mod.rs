//! Which boundary loops are holes, and which are the rim of a sheet?
//!
//! For a loop of an oriented component let N be its area vector, run as its faces run, A the area of the component, and P the
//! sum of its faces' area vectors along N. The loop is a *rim* when P ≥ 0.4 A: then the component is a sheet, its faces
//! turned less than 66° from the loop on average, and the loop its outer border. Else it is a *hole*. A loop whose area
//! vector is 0, exactly, is a hole.

mod component_areas;
mod figures;

use meshmend_core::{Cancelled, Column, Connectivity, PolygonMesh, VertexId, Watch};
use meshmend_geometry::vector::{Point, dot, length, minus};
use meshmend_topology::{ComponentId, Components, boundary_loops, components};

use component_areas::{ComponentArea, component_areas};
use figures::LoopArea;

/// A boundary loop with its figures.
#[derive(Clone, Debug, PartialEq)]
pub struct OpenLoop {
    /// Its vertices, the lowest one first, in the direction of its faces where these agree.
    pub vertices: Vec<VertexId>,
    /// The component that it belongs to.
    pub component: ComponentId,
    /// Whether this component is a single face.
    pub is_of_lone_face: bool,
    /// Its length.
    pub length: f64,
    /// The length of its area vector.
    pub area: f64,
    /// What part of the component's area faces as the loop does: between −1 and 1.
    pub turned: f64,
    /// What follows from that.
    pub kind: LoopKind,
}

/// Whether a boundary loop is a hole.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LoopKind {
    /// The outer border of a sheet.
    Rim,
    /// An opening.
    Hole,
    /// Neither, as the loop's component is not an oriented surface in space; its figures are 0 or mean nothing.
    Undecided(NoSide),
}

/// Why the faces of a component have no side.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum NoSide {
    /// A corner has a coordinate that is not finite.
    NotFinite,
    /// An edge has three sides or more.
    NonManifold,
    /// Two faces along an edge run the same way.
    Inconsistent,
}

/// From which part of the component's area on a loop is a rim.
pub const RIM: f64 = 0.4;

/// The boundary loops of a mesh, by lowest vertex. What hangs together only at a vertex is one component; which loops there
/// are is what [`boundary_loops`] says.
///
/// # Errors
/// When whoever watches stops it.
///
/// *Cost*: near-linear; 100 bytes a component and 21 bytes a vertex.
pub fn open_loops<K: Connectivity>(
    kernel: &K,
    mesh: &PolygonMesh,
    watch: &Watch,
) -> Result<Vec<OpenLoop>, Cancelled> {
    const STEP: &str = "loops";
    watch.look(STEP, 0, 0)?;
    let loops = boundary_loops(kernel);
    if loops.count() == 0 {
        return Ok(Vec::new());
    }
    watch.look(STEP, 0, loops.count())?;
    let components = components(kernel);
    watch.look(STEP, 0, loops.count())?;
    let areas = component_areas(kernel, mesh, &components);
    watch.look(STEP, 0, loops.count())?;
    let after = followers(kernel);
    let directed = |vertices: &[VertexId]| {
        let mut vertices = vertices.to_vec();
        if let &[first, second, ..] = &vertices[..]
            && after[first] != Some(second)
        {
            vertices[1..].reverse();
        }
        vertices
    };
    let judged = loops.iter().enumerate().filter_map(|(place, vertices)| {
        match watch.look_at_times(STEP, place, loops.count()) {
            Ok(()) => judged(mesh, &components, &areas, directed(vertices)).map(Ok),
            Err(cancelled) => Some(Err(cancelled)),
        }
    });
    judged.collect()
}

/// The vertex to which the boundary leads on from each, as the faces run.
fn followers<K: Connectivity>(kernel: &K) -> Column<VertexId, Option<VertexId>> {
    let mut after = Column::filled(None, kernel.vertex_count());
    for edge in kernel.edges() {
        let mut sides = kernel.edge_corners(edge);
        if let (Some(side), None) = (sides.next(), sides.next()) {
            after[kernel.corner_vertex(side)] = Some(kernel.corner_target(side));
        }
    }
    after
}

fn judged(
    mesh: &PolygonMesh,
    components: &Components,
    areas: &Column<ComponentId, ComponentArea>,
    vertices: Vec<VertexId>,
) -> Option<OpenLoop> {
    let component = components.of_vertex(*vertices.first()?)?;
    let of_component = &areas[component];
    let mut found = OpenLoop {
        vertices,
        component,
        is_of_lone_face: of_component.faces == 1,
        length: 0.0,
        area: 0.0,
        turned: 0.0,
        kind: LoopKind::Hole,
    };
    if let Some(reason) = of_component.no_side {
        found.kind = LoopKind::Undecided(reason);
    }
    if of_component.no_side == Some(NoSide::NotFinite) {
        return Some(found);
    }
    let unit = of_component.unit;
    let points: Vec<Point> = found.vertices.iter().map(|&v| unit.shrunk(mesh.position(v))).collect();
    let ends = points.iter().zip(points.iter().cycle().skip(1));
    found.length = unit.length(ends.map(|(&from, &to)| length(minus(to, from))).sum());
    let area = LoopArea::of(&points);
    found.area = unit.area(area.twice / 2.0);
    if of_component.no_side.is_some() {
        return Some(found);
    }
    if let Some(direction) = area.direction
        && of_component.area > 0.0
    {
        found.turned = dot(of_component.sum, direction) / of_component.area;
        found.kind = if found.turned >= RIM { LoopKind::Rim } else { LoopKind::Hole };
    }
    Some(found)
}

#[cfg(test)]
mod tests {
    use meshmend_core::{Build, EdgeUse};

    use super::*;

    fn loops(mesh: &PolygonMesh) -> Vec<OpenLoop> {
        open_loops(&EdgeUse::build(mesh.complex()).unwrap(), mesh, &Watch::NOBODY).unwrap()
    }

    fn open_box(scale: f64) -> PolygonMesh {
        let at = |code: u32| [4, 2, 1].map(|bit| if code & bit == 0 { -scale } else { scale });
        let points: Vec<Point> = (0..8).map(at).collect();
        let corners = [4, 6, 7, 5, 0, 4, 5, 1, 2, 3, 7, 6, 0, 2, 6, 4, 1, 5, 7, 3];
        PolygonMesh::from_polygons(&points, &corners, &[0, 4, 8, 12, 16, 20]).unwrap()
    }

    #[test]
    fn a_box_without_a_lid_is_open_at_a_hole_at_any_scale() {
        for scale in [1.0, 5e-324, 1e-160, 1e200, f64::MAX] {
            let [found] = &loops(&open_box(scale))[..] else { panic!("one loop") };
            assert_eq!(found.vertices, [0, 2, 3, 1].map(VertexId), "as the faces run");
            assert!((found.turned - 0.2).abs() < 1e-15 && found.kind == LoopKind::Hole, "{scale}");
            assert_eq!(found.length, (8.0 * scale).min(f64::MAX));
            assert_eq!(found.area, (4.0 * scale * scale).min(f64::MAX));
            assert!(!found.is_of_lone_face);
        }
    }

    #[test]
    fn loops_of_what_has_no_side_are_undecided() {
        let points = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let kinds = |points: &[Point], faces: &[[u32; 3]]| {
            let mesh = PolygonMesh::from_triangles(points, faces).unwrap();
            loops(&mesh).into_iter().map(|found| found.kind).collect::<Vec<_>>()
        };
        assert_eq!(kinds(&points, &[[0, 1, 2], [2, 1, 3]]), [LoopKind::Rim]);
        let undecided = |reason| [LoopKind::Undecided(reason)];
        assert_eq!(kinds(&points, &[[0, 1, 2], [1, 2, 3]]), undecided(NoSide::Inconsistent));
        let mut far = points;
        far[3] = [f64::INFINITY; 3];
        assert_eq!(kinds(&far, &[[0, 1, 2], [2, 1, 3]]), undecided(NoSide::NotFinite));
        let book = [[0, 1, 2], [1, 0, 3], [0, 1, 4], [2, 1, 3]];
        assert!(kinds(&points, &book).iter().all(|kind| *kind == LoopKind::Undecided(NoSide::NonManifold)));
        let slit = [[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]];
        assert_eq!(kinds(&slit, &[[0, 1, 2]]), [LoopKind::Hole], "without an area");
    }
}
