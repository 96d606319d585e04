//! Faces laid out in the plane, whatever their shape in space: a record is about what is next to what, and slim faces leave no
//! room for arrows.
//!
//! The star of a vertex is spread out round it, each corner with the same share of the full turn. Otherwise each face is a regular
//! polygon, laid down beside an edge that it has with one that lies there. A vertex has one place, so a surface that closes up
//! is distorted where it does.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use meshmend_core::{Cell, Connectivity, CornerId, EdgeId, EdgeUse, FaceId, VertexId};

use super::patch::Patch;

pub(super) type Place = [f64; 2];
/// Where each vertex that is shown lies; y goes up.
pub(super) type Flat = BTreeMap<VertexId, Place>;

/// The places of all vertices of a patch.
pub(super) fn flattened(kernel: &EdgeUse, at: Cell, patch: &Patch) -> Flat {
    let mut flat = Flat::new();
    if let Cell::Vertex(vertex) = at {
        spread(kernel, vertex, &mut flat);
    }
    for &face in &patch.faces {
        lay_down(kernel, face, &mut flat);
    }
    for (place, &vertex) in patch.alone.iter().enumerate() {
        flat.entry(vertex).or_insert([place as f64, 0.0]);
    }
    flat
}

/// Spreads the star of a vertex round it.
fn spread(kernel: &EdgeUse, vertex: VertexId, flat: &mut Flat) {
    let star = in_order(kernel, vertex);
    if star.is_empty() {
        return;
    }
    flat.insert(vertex, [0.0; 2]);
    let gaps = star.iter().filter(|step| step.is_end).count() as f64;
    // Between fans an eighth of the turn is left open.
    let gap = TAU / 8.0 / gaps.max(1.0);
    let share = (TAU - gaps * gap) / star.len() as f64;
    let mut turned = 0.0;
    for step in &star {
        let between: Vec<VertexId> = step.spokes(kernel);
        let steps = (between.len() - 1).max(1) as f64;
        for (place, other) in between.into_iter().enumerate() {
            let way = turned + share * place as f64 / steps;
            let radius = if place > 0 && (place as f64) < steps { 1.25 } else { 1.0 };
            flat.entry(other).or_insert([radius * way.cos(), radius * way.sin()]);
        }
        turned += share + if step.is_end { gap } else { 0.0 };
    }
}

/// A corner in a walk round a vertex.
struct Step {
    corner: CornerId,
    /// Whether it is passed as its face runs: from its own side to the one before.
    is_forward: bool,
    /// Whether no corner follows across the edge behind it.
    is_end: bool,
}

impl Step {
    /// The other vertices of its face, in the order in which the walk passes them.
    fn spokes(&self, kernel: &EdgeUse) -> Vec<VertexId> {
        let first = kernel.next_corner(self.corner);
        let corners = std::iter::successors(Some(first), |&corner| {
            Some(kernel.next_corner(corner)).filter(|&next| next != self.corner)
        });
        let mut vertices: Vec<VertexId> = corners.map(|corner| kernel.corner_vertex(corner)).collect();
        if !self.is_forward {
            vertices.reverse();
        }
        vertices
    }
}

/// The corners at a vertex, umbrella by umbrella, each walked from edge to edge.
fn in_order(kernel: &EdgeUse, vertex: VertexId) -> Vec<Step> {
    let mut left: Vec<CornerId> = kernel.vertex_corners(vertex).collect();
    let mut steps = Vec::new();
    while let Some(place) =
        left.iter().position(|&corner| begins(kernel, corner)).or((!left.is_empty()).then_some(0))
    {
        let mut corner = left.remove(place);
        let [own, before] = edges(kernel, corner);
        let mut is_forward = is_lone(kernel, own) || !is_lone(kernel, before);
        loop {
            let out = if is_forward { before_edge(kernel, corner) } else { kernel.corner_edge(corner) };
            let next = left.iter().position(|&other| edges(kernel, other).contains(&out));
            steps.push(Step { corner, is_forward, is_end: next.is_none() && is_lone(kernel, out) });
            let Some(next) = next else { break };
            corner = left.remove(next);
            is_forward = kernel.corner_edge(corner) == out;
        }
    }
    steps
}

/// The edges of a corner at its vertex: that of its side, and that of the side before.
fn edges(kernel: &EdgeUse, corner: CornerId) -> [EdgeId; 2] {
    [kernel.corner_edge(corner), before_edge(kernel, corner)]
}

fn before_edge(kernel: &EdgeUse, corner: CornerId) -> EdgeId {
    kernel.corner_edge(kernel.prev_corner(corner))
}

fn begins(kernel: &EdgeUse, corner: CornerId) -> bool {
    edges(kernel, corner).into_iter().any(|edge| is_lone(kernel, edge))
}

fn is_lone(kernel: &EdgeUse, edge: EdgeId) -> bool {
    kernel.edge_degree(edge) == 1
}

/// Lays a face down, beside those that lie there.
fn lay_down(kernel: &EdgeUse, face: FaceId, flat: &mut Flat) {
    let corners: Vec<CornerId> = kernel.face_corners(face).collect();
    let vertices: Vec<VertexId> = corners.iter().map(|&corner| kernel.corner_vertex(corner)).collect();
    if vertices.iter().all(|vertex| flat.contains_key(vertex)) {
        return;
    }
    let shape = regular(vertices.len());
    let hinge = corners.iter().enumerate().find_map(|(place, _)| {
        let next = (place + 1) % vertices.len();
        let places = [flat.get(&vertices[place])?, flat.get(&vertices[next])?];
        (places[0] != places[1]).then_some((place, next, [*places[0], *places[1]]))
    });
    let laid: Vec<Place> = match hinge {
        Some((from, to, onto)) => {
            let turned = placed(&shape, [shape[from], shape[to]], onto);
            let lying = flat.values().copied().collect::<Vec<_>>();
            // To the other side of the edge than most of what lies there.
            let side = |points: &[Place]| points.iter().map(|&point| area(onto, point)).sum::<f64>();
            if side(&lying) * side(&turned) > 0.0 {
                turned.into_iter().map(|point| mirrored(point, onto)).collect()
            } else {
                turned
            }
        }
        None => {
            let right = flat.values().fold(0.0_f64, |most, place| most.max(place[0]));
            let shift = if flat.is_empty() { 0.0 } else { right + 1.5 };
            shape.iter().map(|[x, y]| [x + shift, *y]).collect()
        }
    };
    for (vertex, place) in vertices.into_iter().zip(laid) {
        flat.entry(vertex).or_insert(place);
    }
}

/// The corners of a regular polygon, counter-clockwise, its first side level and at the bottom.
fn regular(corners: usize) -> Vec<Place> {
    let step = TAU / corners as f64;
    let corner = |place: usize| {
        let angle = step * (place as f64 - 0.5) - TAU / 4.0;
        [angle.cos(), angle.sin()]
    };
    (0..corners).map(corner).collect()
}

/// Points turned, scaled and moved so that two of them come to lie on two places.
fn placed(points: &[Place], from: [Place; 2], onto: [Place; 2]) -> Vec<Place> {
    let (a, b) = (minus(from[1], from[0]), minus(onto[1], onto[0]));
    let length = a[0] * a[0] + a[1] * a[1];
    if length == 0.0 {
        return points.iter().map(|point| [point[0] + onto[0][0], point[1] + onto[0][1]]).collect();
    }
    // The complex number b / a.
    let turn = [(b[0] * a[0] + b[1] * a[1]) / length, (b[1] * a[0] - b[0] * a[1]) / length];
    let place = |point: &Place| {
        let [x, y] = minus(*point, from[0]);
        [onto[0][0] + turn[0] * x - turn[1] * y, onto[0][1] + turn[1] * x + turn[0] * y]
    };
    points.iter().map(place).collect()
}

/// The point on the other side of a line.
pub(super) fn mirrored(point: Place, line: [Place; 2]) -> Place {
    let (way, from) = (minus(line[1], line[0]), minus(point, line[0]));
    let length = way[0] * way[0] + way[1] * way[1];
    if length == 0.0 {
        return point;
    }
    let part = 2.0 * (from[0] * way[0] + from[1] * way[1]) / length;
    [line[0][0] + part * way[0] - from[0], line[0][1] + part * way[1] - from[1]]
}

/// Twice the area of the triangle of a line and a point: positive where the point is on the left.
fn area(line: [Place; 2], point: Place) -> f64 {
    let (way, from) = (minus(line[1], line[0]), minus(point, line[0]));
    way[0] * from[1] - way[1] * from[0]
}

fn minus(a: Place, b: Place) -> Place {
    [a[0] - b[0], a[1] - b[1]]
}
