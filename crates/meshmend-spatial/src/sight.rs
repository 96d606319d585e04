//! From which side is an open component seen?
//!
//! From up to 256 points of the component, more where faces are large, rays go in 32 directions. Of those that go to one side
//! some leave the mesh without meeting a face. The side from which at least a tenth more leave than from the other is the
//! front. Points and directions are the same on every machine and for any number of threads. This is decided in doubles.

use meshmend_core::{Cancelled, FaceTableError, Id, PolygonMesh, Watch};
use meshmend_geometry::diagonal;
use meshmend_geometry::vector::{Point, cross, dot, length, minus, place_bits};
use rayon::prelude::*;

use crate::boxes::{Bounds, BoxTree};
use crate::{Nesting, Surface, SurfaceError};

/// What of an open component is seen more.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Front {
    /// The fronts of its faces.
    Shown,
    /// Their backs.
    Hidden,
    /// Neither is seen a tenth more than the other, or there would be too many rays.
    Undecided,
}

/// Most points of a component from which rays go.
const MOST_POINTS: usize = 256;

/// Most rays in all.
const MOST_RAYS: usize = 100_000_000;

/// For each of some components of a mesh, by their places, which side of it is seen more.
///
/// # Errors
/// When the triangles of the mesh's faces have more corners than a table holds, or whoever watches stops it.
///
/// *Cost*: O(n log n), and for each ray the faces near it.
pub fn fronts(
    mesh: &PolygonMesh,
    nesting: &Nesting,
    asked: &[usize],
    watch: &Watch,
) -> Result<Vec<Front>, SurfaceError> {
    const STEP: &str = "sight";
    if asked.is_empty() {
        return Ok(Vec::new());
    }
    // Points and triangles must not depend on which way faces run: else a turned component might be turned back.
    let (mesh, runs_back) = running_one_way(mesh)?;
    let surface = Surface::watched(&mesh, watch)?;
    let view = View::of(&mesh, &surface, &runs_back, STEP)?;
    let mut own = vec![Vec::new(); nesting.components.len()];
    for (place, triangle) in surface.triangles().iter().enumerate() {
        if let Some(part) = nesting.component_of(triangle.face) {
            own[part].push(place);
        }
    }
    let mut rays = 0;
    let in_budget: Vec<bool> = asked
        .iter()
        .map(|&part| {
            rays += point_count(nesting, part) * DIRECTIONS;
            rays <= MOST_RAYS
        })
        .collect();
    let front = |(place, (&part, in_budget)): (usize, (&usize, bool))| {
        watch.look(STEP, place, asked.len())?;
        let points = point_count(nesting, part);
        Ok(if in_budget { view.front(part, &own[part], points) } else { Front::Undecided })
    };
    asked.par_iter().zip(in_budget).enumerate().map(front).collect()
}

/// The mesh with each face run round its first corner in one direction, whichever way round it is stored and whatever its vertices
/// are called: that which has the lower places first. And which faces that reverses.
fn running_one_way(mesh: &PolygonMesh) -> Result<(PolygonMesh, Vec<bool>), FaceTableError> {
    let faces = mesh.faces();
    let mut corners = faces.corner_vertices().to_vec();
    let mut runs_back = Vec::with_capacity(faces.face_count());
    for face in faces.faces() {
        let rest = corners[faces.corner_range(face)].get_mut(1..).unwrap_or_default();
        let places = rest.iter().map(|vertex| place_bits(mesh.position(*vertex)));
        let is_back = places.clone().rev().lt(places);
        if is_back {
            rest.reverse();
        }
        runs_back.push(is_back);
    }
    let table = faces.over(faces.vertex_count(), corners)?;
    // As many positions as vertices, as before.
    let turned = PolygonMesh::new(mesh.positions().to_vec(), table).unwrap_or_else(|_| mesh.clone());
    Ok((turned, runs_back))
}

fn point_count(nesting: &Nesting, part: usize) -> usize {
    MOST_POINTS.min(4 * nesting.components[part].faces as usize)
}

/// The triangles of a mesh, scaled so that they lie between −1 and 1.
struct View {
    triangles: Vec<[Point; 3]>,
    /// For each triangle whether the face that it is of runs the other way.
    runs_back: Vec<bool>,
    tree: BoxTree,
}

impl View {
    fn of(
        mesh: &PolygonMesh,
        surface: &Surface<'_>,
        runs_back: &[bool],
        step: &'static str,
    ) -> Result<Self, Cancelled> {
        let finite = |point: &&Point| point.iter().all(|x| x.is_finite());
        let origin = mesh.positions().iter().find(finite).copied().unwrap_or([0.0; 3]);
        let size = diagonal(mesh.positions()).max(f64::MIN_POSITIVE);
        let seen = |point: Point| -> Point {
            // Halved first, so that nothing overflows.
            std::array::from_fn(|axis| (point[axis] / 2.0 - origin[axis] / 2.0) / (size / 2.0))
        };
        let triangles: Vec<[Point; 3]> =
            surface.triangles().iter().map(|triangle| surface.points(triangle).map(seen)).collect();
        let bounds = |item: usize| Bounds::of(triangles[item]);
        let tree = BoxTree::watched(triangles.len(), bounds, (surface.watch(), step))?;
        let runs_back = surface.triangles().iter().map(|triangle| runs_back[triangle.face.index()]).collect();
        Ok(View { triangles, runs_back, tree })
    }

    /// Which side of a component is seen more, by its triangles.
    fn front(&self, part: usize, own: &[usize], points: usize) -> Front {
        let mut area = 0.0;
        let until: Vec<f64> = own
            .iter()
            .map(|&place| {
                area += length(normal(self.triangles[place]));
                area
            })
            .collect();
        let (mut shown, mut hidden) = (0u64, 0u64);
        for point in 0..points {
            let [along, v, w] = [0, 1, 2].map(|number| random(part, 3 * point + number));
            let at = until.partition_point(|&until| until < along * area).min(own.len().saturating_sub(1));
            let Some(&place) = own.get(at) else { continue };
            let [a, b, c] = self.triangles[place];
            let [v, w] = if v + w > 1.0 { [1.0 - v, 1.0 - w] } else { [v, w] };
            let from: Point = std::array::from_fn(|i| a[i] + v * (b[i] - a[i]) + w * (c[i] - a[i]));
            let normal = normal([a, b, c]);
            for number in 0..DIRECTIONS {
                let direction = direction(number);
                let side = dot(direction, normal);
                if side != 0.0 && !self.is_hindered(place, from, direction) {
                    let is_front = (side > 0.0) != self.runs_back[place];
                    *(if is_front { &mut shown } else { &mut hidden }) += 1;
                }
            }
        }
        match (10 * shown, 10 * hidden) {
            (front, _) if front > 0 && front >= 11 * hidden => Front::Shown,
            (_, back) if back > 0 && back >= 11 * shown => Front::Hidden,
            _ => Front::Undecided,
        }
    }

    /// Whether a ray from a point of a triangle meets another one.
    fn is_hindered(&self, own: usize, from: Point, direction: Point) -> bool {
        let inverse = direction.map(|x| 1.0 / x);
        let enters = |bounds: &Bounds| {
            let (mut first, mut last) = (0.0f64, f64::INFINITY);
            for axis in 0..3 {
                let [one, other] =
                    [bounds.low[axis], bounds.high[axis]].map(|border| (border - from[axis]) * inverse[axis]);
                first = first.max(one.min(other));
                last = last.min(one.max(other));
            }
            first <= last + ROOM
        };
        self.tree.any(enters, |item| item != own && meets(from, direction, self.triangles[item]))
    }
}

/// What lies nearer than this to where a ray begins does not hinder it, as a wall on the same place.
const ROOM: f64 = 1e-10;

/// Whether a ray meets a triangle.
fn meets(from: Point, direction: Point, [a, b, c]: [Point; 3]) -> bool {
    let (one, other) = (minus(b, a), minus(c, a));
    let across = cross(direction, other);
    let determinant = dot(one, across);
    if determinant == 0.0 {
        return false;
    }
    let off = minus(from, a);
    let v = dot(off, across) / determinant;
    let round = cross(off, one);
    let w = dot(direction, round) / determinant;
    v >= 0.0 && w >= 0.0 && v + w <= 1.0 && dot(other, round) / determinant > ROOM
}

fn normal([a, b, c]: [Point; 3]) -> Point {
    cross(minus(b, a), minus(c, a))
}

/// How many directions there are.
const DIRECTIONS: usize = 32;

/// Directions evenly over the sphere, each with its opposite, none along an axis.
fn direction(number: usize) -> Point {
    // Along a spiral: heights in equal steps, turns by the golden angle.
    let (step, sign) = ((number / 2) as f64, if number.is_multiple_of(2) { 1.0 } else { -1.0 });
    let height = (step + 0.5) / (DIRECTIONS / 2) as f64;
    let around = step * GOLDEN_ANGLE + 0.3;
    let radius = (1.0 - height * height).sqrt();
    let [x, y] = turned(around);
    [radius * x, radius * y, height].map(|x| x * sign)
}

const GOLDEN_ANGLE: f64 = 2.399_963_229_728_653;

/// Cosine and sine by whole turns and series: the same on every machine.
fn turned(angle: f64) -> [f64; 2] {
    let half = angle.rem_euclid(std::f64::consts::TAU) - std::f64::consts::PI;
    let (mut cosine, mut sine, mut term) = (0.0, 0.0, 1.0);
    for power in 0..40u32 {
        let signed = if power & 2 == 0 { term } else { -term };
        *(if power.is_multiple_of(2) { &mut cosine } else { &mut sine }) += signed;
        term *= half / f64::from(power + 1);
    }
    [-cosine, -sine]
}

/// A number from 0 to 1 that is as good as drawn by lot, for a component and a count.
///
/// *Source*: G. Steele, D. Lea, C. Flood, *Fast splittable pseudorandom number generators*, 2014.
fn random(part: usize, count: usize) -> f64 {
    let mixed = |mut word: u64| {
        word = (word ^ (word >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        word = (word ^ (word >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        word ^ (word >> 31)
    };
    const STEP: u64 = 0x9e37_79b9_7f4a_7c15;
    let seed = mixed((part as u64 + 1).wrapping_mul(STEP));
    let word = mixed(seed.wrapping_add((count as u64 + 1).wrapping_mul(STEP)));
    (word >> 11) as f64 / (1u64 << 53) as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::nesting;

    /// A box without a lid, looking outward or inward, and perhaps a sheet far above it.
    fn fronts_of(faces: &[[u32; 4]]) -> Vec<Front> {
        let at = |code: u32| [4, 2, 1].map(|bit| if code & bit == 0 { 0.0 } else { 1.0 });
        let points: Vec<Point> = (0..8).map(at).collect();
        let starts: Vec<u32> = (0..=faces.len() as u32).map(|face| 4 * face).collect();
        let mesh = PolygonMesh::from_polygons(&points, &faces.concat(), &starts).unwrap();
        let nesting = nesting(&Surface::of(&mesh).unwrap()).unwrap();
        let asked: Vec<usize> = (0..nesting.components.len()).collect();
        fronts(&mesh, &nesting, &asked, &Watch::NOBODY).unwrap()
    }

    #[test]
    fn an_open_box_is_seen_from_outside_and_a_sheet_from_neither_side() {
        let outward = [[4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]];
        assert_eq!(fronts_of(&outward), [Front::Shown]);
        let inward = outward.map(|[a, b, c, d]| [d, c, b, a]);
        assert_eq!(fronts_of(&inward), [Front::Hidden]);
        assert_eq!(fronts_of(&outward[..1]), [Front::Undecided]);
    }

    #[test]
    fn directions_have_length_one_and_their_opposites() {
        for number in 0..DIRECTIONS {
            let one = direction(number);
            assert!((length(one) - 1.0).abs() < 1e-12, "{one:?}");
            let opposite = direction(number ^ 1);
            assert_eq!(one, opposite.map(|x| -x));
        }
        for angle in [0.0, 1.0, 2.0, 3.5, 6.0, 40.0] {
            let [cosine, sine] = turned(angle);
            assert!((cosine - angle.cos()).abs() < 1e-12 && (sine - angle.sin()).abs() < 1e-12, "{angle}");
        }
    }
}
