//! The uses of an edge in their order round it.
//!
//! Counter-clockwise about the edge directed from its lower to its higher vertex, starting at the half-plane of the
//! lowest use that has one; at equal angle forward uses come before backward ones, then by corner; uses without a
//! half-plane come last. A triangle's half-plane is exact: it goes through the third corner, and all comparisons
//! are exact predicates on the positions. A larger face's goes through a point in the direction of its area vector ×
//! the direction of the use, computed in doubles, and is then compared exactly like any other.

use std::cmp::Ordering;

use meshmend_core::{Connectivity, CornerId, EdgeId, PolygonMesh};
use meshmend_geometry::sorting::merge_sort;
use meshmend_geometry::vector::{Point, area_vector, cross, minus};
use robust::{Coord, Coord3D, orient2d, orient3d};

/// A use of an edge in its place round the edge.
#[derive(Clone, Copy, Debug)]
pub(super) struct RadialUse {
    pub(super) corner: CornerId,
    pub(super) is_forward: bool,
    /// The number of its half-plane, if it has one; equal half-planes have one number.
    pub(super) angle: Option<u32>,
}

/// All uses of an edge in radial order.
///
/// *Cost*: O(d log d) exact comparisons.
pub(super) fn radial_order<K: Connectivity>(kernel: &K, mesh: &PolygonMesh, edge: EdgeId) -> Vec<RadialUse> {
    let [low, high] = kernel.edge_ends(edge).map(|v| mesh.position(v));
    let uses: Vec<(CornerId, Option<Point>)> =
        kernel.edge_corners(edge).map(|c| (c, half_plane(kernel, mesh, c, low, high))).collect();
    let axis = Axis::new(low, high, uses.iter().filter_map(|(_, through)| *through));
    let is_off_axis = |through: &Option<Point>| through.filter(|&p| !axis.holds(p));
    let mut planes = Vec::new();
    let mut order = Vec::new();
    for (corner, through) in uses {
        let use_of = RadialUse { corner, is_forward: kernel.is_forward(corner), angle: None };
        match is_off_axis(&through) {
            Some(point) => planes.push((use_of, axis.scaled(point))),
            None => order.push(use_of),
        }
    }
    let Some(zero) = planes.first().map(|(_, point)| *point) else { return order };
    let mut keyed: Vec<Plane> = planes
        .into_iter()
        .map(|(use_of, through)| Plane {
            is_second_half: axis.is_second_half(zero, through),
            through,
            use_of,
        })
        .collect();
    merge_sort(&mut keyed, |one, other| {
        axis.turn(one, other).then_with(|| {
            let tie = |plane: &Plane| (!plane.use_of.is_forward, plane.use_of.corner);
            tie(one).cmp(&tie(other))
        })
    });
    let mut angle = 0;
    let mut sorted: Vec<RadialUse> = Vec::with_capacity(keyed.len() + order.len());
    for (place, plane) in keyed.iter().enumerate() {
        if place > 0 && axis.turn(&keyed[place - 1], plane) != Ordering::Equal {
            angle += 1;
        }
        sorted.push(RadialUse { angle: Some(angle), ..plane.use_of });
    }
    sorted.append(&mut order);
    sorted
}

struct Plane {
    use_of: RadialUse,
    through: Point,
    is_second_half: bool,
}

/// A point in the half-plane of a use, if its face has one and all its points are finite.
fn half_plane<K: Connectivity>(
    kernel: &K,
    mesh: &PolygonMesh,
    corner: CornerId,
    low: Point,
    high: Point,
) -> Option<Point> {
    let face = kernel.corner_face(corner);
    let size = kernel.face_corners(face).take(4).count();
    if size == 3 {
        let third = kernel.prev_corner(corner);
        return Some(mesh.position(kernel.corner_vertex(third))).filter(is_finite);
    }
    let area = area_vector(kernel.face_vertices(face).map(|v| mesh.position(v)));
    let along = if kernel.is_forward(corner) { minus(high, low) } else { minus(low, high) };
    let inward = cross(area, along);
    let size = |v: Point| v.iter().fold(0.0f64, |most, x| most.max(x.abs()));
    if size(inward) == 0.0 || !is_finite(&inward) {
        return None;
    }
    // About as far from the axis as the edge is long; the factor is a power of two, so that no digit is lost.
    let shrink = (size(along) / size(inward)).log2().round().clamp(-1000.0, 1000.0).exp2();
    Some(std::array::from_fn(|i| low[i] + inward[i] * shrink)).filter(is_finite)
}

fn is_finite(point: &Point) -> bool {
    point.iter().all(|x| x.is_finite())
}

/// The line of an edge, and exact questions about half-planes that it bounds.
struct Axis {
    low: Point,
    high: Point,
    /// A power of two that keeps products of three coordinates within the range of doubles.
    scale: f64,
}

impl Axis {
    fn new(low: Point, high: Point, points: impl Iterator<Item = Point>) -> Self {
        let largest =
            points.chain([low, high]).flatten().filter(|x| x.is_finite()).fold(0.0f64, |m, x| m.max(x.abs()));
        let exponent = if largest > 0.0 { largest.log2().floor() } else { 0.0 };
        let scale = if exponent.abs() > 250.0 { (-exponent).clamp(-1000.0, 1000.0).exp2() } else { 1.0 };
        let axis = Axis { low, high, scale };
        Axis { low: axis.scaled(low), high: axis.scaled(high), scale }
    }

    fn scaled(&self, point: Point) -> Point {
        point.map(|x| x * self.scale)
    }

    /// Whether a point that is not scaled yet is on the line. It always is if both ends of the line are one point.
    fn holds(&self, point: Point) -> bool {
        let point = self.scaled(point);
        !(is_finite(&self.low) && is_finite(&self.high))
            || (0..3).all(|drop| self.side_in_plane(point, drop) == 0)
    }

    /// On which side of the line a point is if one coordinate is dropped.
    fn side_in_plane(&self, point: Point, drop: usize) -> i8 {
        let (x, y) = ((drop + 1) % 3, (drop + 2) % 3);
        let coord = |p: Point| Coord { x: p[x], y: p[y] };
        sign(orient2d(coord(self.low), coord(self.high), coord(point)))
    }

    /// The sign of axis · (one × other), both taken from the line.
    fn sine(&self, one: Point, other: Point) -> i8 {
        let coord = |p: Point| Coord3D { x: p[0], y: p[1], z: p[2] };
        sign(orient3d(coord(self.high), coord(one), coord(other), coord(self.low)))
    }

    /// Whether a half-plane lies half a turn or more behind the one at which the order starts.
    fn is_second_half(&self, zero: Point, point: Point) -> bool {
        match self.sine(zero, point) {
            0 => (0..3).any(|drop| {
                let (one, other) = (self.side_in_plane(zero, drop), self.side_in_plane(point, drop));
                one != 0 && one == -other
            }),
            sine => sine < 0,
        }
    }

    fn turn(&self, one: &Plane, other: &Plane) -> Ordering {
        one.is_second_half
            .cmp(&other.is_second_half)
            .then_with(|| 0.cmp(&self.sine(one.through, other.through)))
    }
}

fn sign(determinant: f64) -> i8 {
    i8::from(determinant > 0.0) - i8::from(determinant < 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use meshmend_core::{Complex, EdgeUse, FaceTable, VertexId};

    /// Pages on the edge (0, 0, 0)-(0, 0, 1), each through a point; their order by the angle.
    fn order_of(tips: &[Point]) -> Vec<u32> {
        let mut positions = vec![[0.0; 3], [0.0, 0.0, 1.0]];
        positions.extend(tips);
        let corners = (0..tips.len() as u32).flat_map(|i| [0, 1, i + 2]).map(VertexId).collect();
        let faces = FaceTable::triangles(positions.len(), corners).unwrap();
        let mesh = PolygonMesh::new(positions, faces).unwrap();
        let kernel = EdgeUse::assemble(mesh.complex());
        radial_order(&kernel, &mesh, EdgeId(0)).iter().map(|u| u.corner.0 / 3).collect()
    }

    #[test]
    fn pages_come_counter_clockwise_from_the_lowest() {
        let at = |degrees: f64| [degrees.to_radians().cos(), degrees.to_radians().sin(), 0.3];
        let angles = [10.0, 200.0, 100.0, 189.0, 350.0, 5.0, 11.0];
        assert_eq!(order_of(&angles.map(at)), [0, 6, 2, 3, 1, 4, 5]);
    }

    #[test]
    fn coplanar_pages_are_told_apart_exactly() {
        let tips = [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.5], [2.0, 0.0, 9.0], [0.0, 1.0, 0.0], [0.0, 0.0, 7.0]];
        assert_eq!(order_of(&tips), [0, 2, 3, 1, 4]);
    }

    #[test]
    fn huge_and_tiny_coordinates_are_ordered_too() {
        for size in [1e300, 1e-300] {
            let tips =
                [[1.0, 0.0, 0.0], [-1.0, -1.0, 0.0], [0.0, 1.0, 0.0]].map(|p: Point| p.map(|x| x * size));
            let mut positions = vec![[0.0; 3], [0.0, 0.0, size]];
            positions.extend(tips);
            let corners = [0, 1, 2, 0, 1, 3, 0, 1, 4].map(VertexId).to_vec();
            let mesh = PolygonMesh::new(positions, FaceTable::triangles(5, corners).unwrap()).unwrap();
            let kernel = EdgeUse::assemble(mesh.complex());
            let order: Vec<u32> =
                radial_order(&kernel, &mesh, EdgeId(0)).iter().map(|u| u.corner.0 / 3).collect();
            assert_eq!(order, [0, 2, 1], "{size}");
        }
    }

    #[test]
    fn polygons_and_non_finite_pages_have_their_place() {
        let positions = vec![
            [0.0; 3],
            [0.0, 0.0, 1.0],
            [1.0, 0.0, 1.0],
            [1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [f64::NAN; 3],
            [-1.0, 0.0, 0.0],
        ];
        let corners = [0, 1, 5, 0, 1, 6, 0, 1, 2, 3, 0, 1, 4].map(VertexId).to_vec();
        let faces = FaceTable::polygons(7, vec![0, 3, 6, 10, 13], corners).unwrap();
        let mesh = PolygonMesh::new(positions, faces).unwrap();
        let kernel = EdgeUse::assemble(&Complex::of(&mesh.complex().shared_faces()));
        let order: Vec<u32> = radial_order(&kernel, &mesh, EdgeId(0)).iter().map(|u| u.corner.0).collect();
        assert_eq!(order, [3, 6, 10, 0]);
    }
}
