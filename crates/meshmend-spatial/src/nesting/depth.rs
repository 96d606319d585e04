//! How many others each closed component lies in.

use std::cmp::Ordering;

use meshmend_core::{PolygonMesh, VertexId};
use meshmend_geometry::vector::Point;
use rayon::prelude::*;

use super::parts::Parts;
use super::passage::{lies_on, passage};
use crate::Surface;
use crate::boxes::{Bounds, BoxTree, Query};

/// For each component that encloses space, how many others hold its anchor.
///
/// *Cost*: O(n log n), and for each point of a component that lies on another, as long as none has shown whether that one
/// holds it, a search.
pub(super) fn depths(mesh: &PolygonMesh, surface: &Surface<'_>, parts: &Parts) -> Vec<Option<u32>> {
    let solid: Vec<u32> = (0..parts.list.len() as u32).filter(|&part| parts.has_inside(part)).collect();
    let mut depths = vec![None; parts.list.len()];
    if let [only] = solid[..] {
        depths[only as usize] = Some(0);
    }
    if solid.len() < 2 {
        return depths;
    }
    let walls = Walls::of(mesh, surface, parts);
    let found: Vec<u32> = solid.par_chunks(RUN).flat_map_iter(|run| walls.depths_of(run)).collect();
    solid.iter().zip(found).for_each(|(&part, depth)| depths[part as usize] = Some(depth));
    depths
}

/// Components whose anchors are looked for together.
const RUN: usize = 256;

/// Most points that are asked for together.
const MOST: usize = 64;

/// The triangles of all components that enclose space, and their points.
struct Walls {
    triangles: Vec<Wall>,
    tree: BoxTree,
    /// The points of each component.
    points: Vec<Vec<Point>>,
}

/// A triangle of a component, also one without an area.
#[derive(Clone, Copy)]
struct Wall {
    corners: [Point; 3],
    part: u32,
}

/// How a point lies to a component, if not outside.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Place {
    On,
    Inside,
}

impl Walls {
    fn of(mesh: &PolygonMesh, surface: &Surface<'_>, parts: &Parts) -> Self {
        let triangles = walls(mesh, surface, parts);
        let tree = BoxTree::over(triangles.len(), |item| Bounds::of(triangles[item].corners));
        let mut points = vec![Vec::new(); parts.list.len()];
        for (vertex, &part) in parts.of_vertex.iter() {
            if parts.has_inside(part) {
                points[part as usize].push(mesh.position(vertex));
            }
        }
        Walls { triangles, tree, points }
    }

    /// The depths of some components.
    fn depths_of(&self, run: &[u32]) -> Vec<u32> {
        let least_point = |&part: &u32| {
            let points = self.points[part as usize].iter().copied();
            points.min_by(least).map(|point| (part, point))
        };
        let asked: Vec<(u32, Point)> = run.iter().filter_map(least_point).collect();
        let depth = |(&(part, _), places): (&(u32, Point), Vec<(u32, Place)>)| {
            let holding = places.iter().filter(|&&(_, place)| place == Place::Inside).count() as u32;
            let touched = places.iter().filter(|&&(_, place)| place == Place::On).map(|&(other, _)| other);
            holding + self.holding_among(touched.collect(), part)
        };
        asked.iter().zip(self.places(&asked)).map(depth).collect()
    }

    /// How many of some components, on all of which a component's least point lies, hold it.
    fn holding_among(&self, mut touched: Vec<u32>, part: u32) -> u32 {
        if touched.is_empty() {
            return 0;
        }
        let mut points = self.points[part as usize].clone();
        points.sort_unstable_by(least);
        points.dedup();
        let (mut holding, mut from, mut count) = (0, 1, 1);
        while from < points.len() && !touched.is_empty() {
            let end = points.len().min(from + count);
            let asked: Vec<(u32, Point)> = points[from..end].iter().map(|&point| (part, point)).collect();
            for places in self.places(&asked) {
                touched.retain(|other| {
                    let known = places.iter().find(|(touching, _)| touching == other);
                    holding += u32::from(known.is_some_and(|&(_, place)| place == Place::Inside));
                    known.is_some_and(|&(_, place)| place == Place::On)
                });
            }
            (from, count) = (end, MOST.min(2 * count));
        }
        holding
    }

    /// For each of some points, with the component that it belongs to, the others on or in which it lies, ascending.
    fn places(&self, asked: &[(u32, Point)]) -> Vec<Vec<(u32, Place)>> {
        let column = |&(_, point): &(u32, Point)| Query {
            bounds: Bounds { low: point, high: [point[0], point[1], f64::MAX] },
            from: 0,
        };
        let queries: Vec<Query> = asked.iter().map(column).collect();
        // Which point meets which component, and whether it is on that one.
        let mut met: Vec<(u32, u32, bool)> = Vec::new();
        let bounds = |item: usize| Bounds::of(self.triangles[item].corners);
        self.tree.each_overlap(&queries, bounds, |query, item| {
            let ((own, point), Wall { corners, part }) = (asked[query], self.triangles[item]);
            if own == part {
                return;
            }
            let is_on = lies_on(point, corners);
            if is_on || !passage(point, corners).is_zero() {
                met.push((query as u32, part, is_on));
            }
        });
        met.sort_unstable();
        let mut places = vec![Vec::new(); asked.len()];
        for met in met.chunk_by(|one, other| (one.0, one.1) == (other.0, other.1)) {
            // What is on a component sorts last.
            let Some(&(query, part, is_on)) = met.last() else { continue };
            if is_on {
                places[query as usize].push((part, Place::On));
            } else if !met.len().is_multiple_of(2) {
                places[query as usize].push((part, Place::Inside));
            }
        }
        places
    }
}

/// The triangles of all components that enclose space; faces without an area are cut from their first corner.
fn walls(mesh: &PolygonMesh, surface: &Surface<'_>, parts: &Parts) -> Vec<Wall> {
    let faces = mesh.complex().faces();
    let mut walls = Vec::new();
    for (face, &part) in parts.of_face.iter().filter(|&(_, &part)| parts.has_inside(part)) {
        let triangles = surface.triangles_of(face);
        walls.extend(triangles.iter().map(|triangle| Wall { corners: surface.points(triangle), part }));
        if let ([], [first, rest @ ..]) = (triangles, faces.face_vertices(face)) {
            let point = |vertex: VertexId| mesh.position(vertex);
            let corners = rest.windows(2).map(|pair| [point(*first), point(pair[0]), point(pair[1])]);
            walls.extend(corners.map(|corners| Wall { corners, part }));
        }
    }
    walls
}

/// The order of x, y and z.
fn least(one: &Point, other: &Point) -> Ordering {
    // Adding 0 makes the negative zero the positive one.
    let [one, other] = [one, other].map(|point| point.map(|x| x + 0.0));
    one.iter().zip(&other).map(|(a, b)| a.total_cmp(b)).find(|order| order.is_ne()).unwrap_or(Ordering::Equal)
}
