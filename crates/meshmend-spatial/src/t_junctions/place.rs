//! Where a vertex lies along an edge, and how far from it.

use std::cmp::Ordering;

use meshmend_core::Id;
use meshmend_geometry::vector::{Point, cross, is_finite, length, minus};

use crate::exact::integers::{self, IntegerPoint, integer_points};
use crate::exact::{Sign, are_collinear, compare_along};
use crate::unit::Unit;

use super::boundary::Boundary;

/// Whether a finite point lies on an edge: not farther than a distance from it, its foot strictly between the ends, and
/// farther than that from both of them.
///
/// *Cost*: constant; microseconds where doubles can't tell.
pub(crate) fn is_on(point: Point, [from, to]: [Point; 2], within: f64) -> bool {
    let ends = [from, to];
    let is_between = compare_along(ends, point, from) == Sign::Positive
        && compare_along(ends, point, to) == Sign::Negative;
    if !is_between {
        return false;
    }
    if within == 0.0 {
        return are_collinear([from, to, point]);
    }
    is_within(point, ends, within) && is_farther(point, from, within) && is_farther(point, to, within)
}

/// How far a point is from the line of an edge, in doubles.
pub(crate) fn distance(point: Point, [from, to]: [Point; 2]) -> f64 {
    let largest = [point, from, to].iter().flatten().fold(0.0f64, |most, x| most.max(x.abs()));
    let unit = Unit::of(largest);
    let [point, from, to] = [point, from, to].map(|point| unit.shrunk(point));
    let along = minus(to, from);
    unit.length(length(cross(along, minus(point, from))) / length(along))
}

/// How the distances of two points from the line of an edge compare, exactly.
///
/// *Cost*: microseconds.
pub(crate) fn compare_distance([from, to]: [Point; 2], one: Point, other: Point) -> Ordering {
    let [from, to, one, other] = integer_points([from, to, one, other]);
    let along = integers::minus(&to, &from);
    let square = |point: &IntegerPoint| {
        let bow = integers::cross(&along, &integers::minus(point, &from));
        integers::dot(&bow, &bow)
    };
    square(&one).cmp(&square(&other))
}

/// Whether the face of a boundary edge has a corner, other than the edge's ends, not farther from the edge's line than twice a
/// distance.
///
/// *Cost*: linear in the corners of the face.
pub(crate) fn is_thin(positions: &[Point], boundary: &Boundary, edge: u32, within: f64) -> bool {
    let edge = boundary.edges()[edge as usize];
    let [from, to] = edge.ends.map(|end| positions[end.index()]);
    let is_near = |point: Point| {
        if within == 0.0 {
            are_collinear([from, to, point])
        } else {
            is_within(point, [from, to], (2.0 * within).min(f64::MAX))
        }
    };
    let vertices = boundary.faces().face_vertices(edge.face).iter();
    let mut others = vertices.filter(|vertex| !edge.ends.contains(vertex));
    others.any(|vertex| {
        let point = positions[vertex.index()];
        is_finite(&point) && is_near(point)
    })
}

/// Rounding changes a length by less than this part of it, and a distance from a line by less than this part of the
/// distance from its end.
const ERROR: f64 = 16.0 * f64::EPSILON;

/// Whether squares of a number, and products of these, are far within the range of doubles.
fn is_moderate(x: f64) -> bool {
    (1e-70..1e70).contains(&x)
}

/// Whether a point is not farther than a distance from the line of an edge.
fn is_within(point: Point, [from, to]: [Point; 2], within: f64) -> bool {
    let (along, off) = (minus(to, from), minus(point, from));
    let (size, reach) = (length(along), length(off));
    let found = length(cross(along, off)) / size;
    let error = ERROR * (reach + found + within);
    if is_moderate(size) && is_moderate(reach) && is_moderate(within) && (found - within).abs() > error {
        return found < within;
    }
    let [point, from, to, within] = whole(point, from, to, within);
    let along = integers::minus(&to, &from);
    let bow = integers::cross(&along, &integers::minus(&point, &from));
    integers::dot(&bow, &bow) <= within[0].pow(2) * integers::dot(&along, &along)
}

/// Whether a point is farther than a distance from another.
fn is_farther(point: Point, other: Point, within: f64) -> bool {
    let found = length(minus(point, other));
    let is_sure = is_moderate(found) && is_moderate(within);
    if is_sure && (found - within).abs() > ERROR * (found + within) {
        return found > within;
    }
    let [point, other, _, within] = whole(point, other, other, within);
    let way = integers::minus(&point, &other);
    integers::dot(&way, &way) > within[0].pow(2)
}

/// Points and a distance as whole numbers, all times one power of two.
fn whole(a: Point, b: Point, c: Point, distance: f64) -> [IntegerPoint; 4] {
    integer_points([a, b, c, [distance, 0.0, 0.0]])
}
