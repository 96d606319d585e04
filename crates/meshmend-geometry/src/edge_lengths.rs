//! How long is each edge?

use crate::vector::{Point, dot, minus};
use meshmend_core::{Column, EdgeId, PolygonMesh};

/// The distance between the ends of each edge of a mesh's complex; not finite where an end is not, or where it is too
/// large for a double.
///
/// *Cost*: linear; 8 bytes an edge.
pub fn edge_lengths(mesh: &PolygonMesh) -> Column<EdgeId, f64> {
    let ends = mesh.complex().edges().all_ends();
    ends.iter().map(|&[low, high]| distance(mesh.position(low), mesh.position(high))).collect()
}

fn distance(a: Point, b: Point) -> f64 {
    let way = minus(b, a);
    let square = dot(way, way);
    if square.is_normal() {
        return square.sqrt();
    }
    // Squares are too large or too small for a double, but the length need not be.
    let largest =
        way.iter().fold(0.0, |most: f64, x| if x.abs() > most || x.is_nan() { x.abs() } else { most });
    if largest == 0.0 || !largest.is_finite() {
        return largest;
    }
    let part = way.map(|x| x / largest);
    largest * dot(part, part).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_are_right_where_squares_are_not() {
        for unit in [1.0, 1e-300, 1e-200, 1e200, 1e300] {
            let length = distance([unit; 3], [4.0 * unit, 5.0 * unit, unit]) / unit;
            assert!((length - 5.0).abs() < 1e-9, "{unit}: {length}");
        }
        assert_eq!(distance([7.0; 3], [7.0; 3]), 0.0);
        assert!(distance([f64::NAN, 0.0, 0.0], [1.0; 3]).is_nan());
        assert!(distance([0.0, f64::NAN, 0.0], [1e300, 1.0, 0.0]).is_nan());
        assert_eq!(distance([f64::MAX, 0.0, 0.0], [-f64::MAX, 0.0, 0.0]), f64::INFINITY);
    }
}
