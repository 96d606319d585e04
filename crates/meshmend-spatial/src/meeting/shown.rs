//! A point of what two crossing triangles have in common, in doubles.

use meshmend_geometry::vector::{Point, area_vector, dot, minus};

/// A point that two triangles whose insides cross or overlap have in common, within rounding: the middle of a segment, or
/// the mean of the corners of an area. It does not depend on the order of the triangles, nor of their corners.
pub(crate) fn shown_point(triangles: [[Point; 3]; 2], is_coplanar: bool) -> Point {
    let [f, g] = in_order(triangles);
    let greatest = f.iter().chain(&g).flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
    if greatest == 0.0 {
        return [0.0; 3];
    }
    // A power of two near the greatest coordinate, taken out so that no product leaves the range of doubles.
    let scale = f64::from_bits(greatest.to_bits() & 0x7ff0_0000_0000_0000).max(f64::MIN_POSITIVE);
    let [f, g] = [f, g].map(|triangle| triangle.map(|corner| corner.map(|x| x / scale)));
    let common = if is_coplanar { overlap(f, g) } else { segment(f, g) };
    let common = if common.is_empty() { [f, g].concat() } else { common };
    mean(&common).map(|x| x * scale)
}

/// The ends of what two triangles in different planes have in common.
fn segment(f: [Point; 3], g: [Point; 3]) -> Vec<Point> {
    let mut ends = [cut(f, g), cut(g, f)].concat();
    let Some(&first) = ends.first() else { return ends };
    // The two in the middle, along the line on which all lie.
    let far = |point: &Point| dot(minus(*point, first), minus(*point, first));
    let direction =
        ends.iter().max_by(|p, q| far(p).total_cmp(&far(q))).map_or([0.0; 3], |p| minus(*p, first));
    ends.sort_by(|p, q| dot(*p, direction).total_cmp(&dot(*q, direction)));
    let outside = ends.len().saturating_sub(2) / 2;
    ends[outside..ends.len() - outside].to_vec()
}

/// Where the outline of a triangle passes the plane of another: two points, if the plane passes it.
fn cut(triangle: [Point; 3], plane: [Point; 3]) -> Vec<Point> {
    let normal = area_vector(plane.into_iter());
    let heights = triangle.map(|corner| dot(normal, minus(corner, plane[0])));
    let sides = (0..3).map(|at| [at, (at + 1) % 3]);
    let passed = sides.filter(|&[one, other]| (heights[one] > 0.0) != (heights[other] > 0.0));
    passed
        .map(|[one, other]| {
            let part = heights[one] / (heights[one] - heights[other]);
            along(triangle[one], triangle[other], part)
        })
        .collect()
}

/// The corners of what two triangles in one plane have in common: the first is cut off along each side of the second.
fn overlap(f: [Point; 3], g: [Point; 3]) -> Vec<Point> {
    let normal = area_vector(g.into_iter());
    let mut corners = f.to_vec();
    for [from, to] in [[g[0], g[1]], [g[1], g[2]], [g[2], g[0]]] {
        let inwards = meshmend_geometry::vector::cross(normal, minus(to, from));
        let height = |point: Point| dot(inwards, minus(point, from));
        let mut kept = Vec::new();
        for (at, &one) in corners.iter().enumerate() {
            let other = corners[(at + 1) % corners.len()];
            let (low, high) = (height(one), height(other));
            if low >= 0.0 {
                kept.push(one);
            }
            if (low > 0.0 && high < 0.0) || (low < 0.0 && high > 0.0) {
                kept.push(along(one, other, low / (low - high)));
            }
        }
        corners = kept;
    }
    corners
}

fn along(from: Point, to: Point, part: f64) -> Point {
    std::array::from_fn(|i| from[i] + part * (to[i] - from[i]))
}

fn mean(points: &[Point]) -> Point {
    std::array::from_fn(|i| points.iter().map(|point| point[i] / points.len() as f64).sum())
}

/// The triangles with sorted corners, the lesser first.
fn in_order(triangles: [[Point; 3]; 2]) -> [[Point; 3]; 2] {
    let by_coordinates = |p: &Point, q: &Point| {
        let pairs = p.iter().zip(q).map(|(x, y)| (x + 0.0).total_cmp(&(y + 0.0)));
        pairs.fold(std::cmp::Ordering::Equal, std::cmp::Ordering::then)
    };
    let [f, g] = triangles.map(|mut triangle| {
        triangle.sort_by(by_coordinates);
        triangle
    });
    let order = f.iter().zip(&g).map(|(p, q)| by_coordinates(p, q));
    if order.fold(std::cmp::Ordering::Equal, std::cmp::Ordering::then).is_gt() { [g, f] } else { [f, g] }
}
