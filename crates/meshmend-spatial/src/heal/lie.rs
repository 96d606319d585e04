//! Whether two faces leave a common edge in the same half-plane.

use meshmend_core::{Id, VertexId};
use meshmend_geometry::vector::{Point, cross, dot, length, minus};
use num_bigint::BigInt;

use super::chains::Piece;
use crate::exact::integers::{self, IntegerPoint, integer, lowest_exponent};
use crate::exact::{Sign, compare_along};
use crate::t_junctions::Boundary;

/// Whether the faces of two boundary edges lie on each other beside a piece of both: if within no distance, exactly, else
/// nearly.
///
/// *Cost*: linear in the corners of both faces; big integers where doubles leave a doubt.
pub(super) fn lie_on_each_other(
    positions: &[Point],
    boundary: &Boundary,
    edges: [u32; 2],
    piece: Piece,
    within: f64,
) -> bool {
    let [a, b] = piece.map(|end| positions[end.index()]);
    let outlines = edges.map(|edge| outline(positions, boundary, edge, [a, b]));
    if !outlines.iter().all(|outline| outline.iter().flatten().all(|x| x.is_finite())) {
        return false;
    }
    if let [Some(one), Some(other)] = outlines.each_ref().map(|outline| inward(outline, [a, b])) {
        let size = length(one) * length(other);
        let is_turned = length(cross(one, other)) > 1e-3 * size;
        if dot(one, other) < 0.9 * size || within == 0.0 && is_turned {
            return false;
        }
    }
    let points: Vec<f64> = outlines.iter().flatten().chain([&a, &b]).flatten().copied().collect();
    let lowest = lowest_exponent(points.iter());
    let [one, other] = outlines.map(|outline| exact_inward(&outline, [a, b], lowest));
    let product = integers::dot(&one, &other);
    if Sign::from(&product) != Sign::Positive {
        return false;
    }
    if within == 0.0 {
        return integers::cross(&one, &other).iter().all(|x| *x == BigInt::ZERO);
    }
    let sizes = integers::dot(&one, &one) * integers::dot(&other, &other);
    product.pow(2) * BigInt::from(10u64.pow(8)).pow(2) >= sizes * BigInt::from(COSINE).pow(2)
}

/// From which cosine on, in parts of 10⁸, two half-planes count as one where vertices may be off the edge.
const COSINE: u64 = 99_969_541;

/// The corners of the face of a boundary edge, the way round in which it runs along a direction.
fn outline(positions: &[Point], boundary: &Boundary, edge: u32, axis: [Point; 2]) -> Vec<Point> {
    let edge = boundary.edges()[edge as usize];
    let vertices: &[VertexId] = boundary.faces().face_vertices(edge.face);
    let mut points: Vec<Point> = vertices.iter().map(|vertex| positions[vertex.index()]).collect();
    let [from, to] = edge.ends.map(|end| positions[end.index()]);
    if compare_along(axis, to, from) != Sign::Positive {
        points.reverse();
    }
    points
}

/// The direction in which a face leaves an edge, in doubles; `None` where rounding leaves no digits of it.
fn inward(outline: &[Point], [a, b]: [Point; 2]) -> Option<Point> {
    let &first = outline.first()?;
    let (mut area, mut size) = ([0.0; 3], 0.0);
    for pair in outline.windows(2) {
        let (one, other) = (minus(pair[0], first), minus(pair[1], first));
        let part = cross(one, other);
        area = std::array::from_fn(|i| area[i] + part[i]);
        size += length(one) * length(other);
    }
    let along = minus(b, a);
    let inward = cross(area, along);
    let has_digits = length(area) > 1e8 * f64::EPSILON * (outline.len() as f64 + 8.0) * size
        && length(inward) > 1e-3 * length(area) * length(along);
    let is_moderate = |x: f64| (1e-70..1e70).contains(&x);
    (has_digits && is_moderate(length(area)) && is_moderate(length(along))).then_some(inward)
}

/// The same without rounding, times a power of two.
fn exact_inward(outline: &[Point], [a, b]: [Point; 2], lowest: i32) -> IntegerPoint {
    let whole = |point: &Point| point.map(|x| integer(x, lowest));
    let mut area: IntegerPoint = std::array::from_fn(|_| BigInt::ZERO);
    if let Some(first) = outline.first().map(whole) {
        for pair in outline.windows(2) {
            let [one, other] = [&pair[0], &pair[1]].map(|point| integers::minus(&whole(point), &first));
            area.iter_mut().zip(integers::cross(&one, &other)).for_each(|(sum, part)| *sum += part);
        }
    }
    integers::cross(&area, &integers::minus(&whole(&b), &whole(&a)))
}
