//! Whether points lie on one line.

use meshmend_geometry::vector::Point;

use crate::exact::are_collinear;

/// Whether some finite points lie on one line, exactly.
///
/// *Cost*: that of [`are_collinear`] for each point.
pub fn is_straight(points: &[Point]) -> bool {
    let Some(&first) = points.first() else { return true };
    let Some(&second) = points.iter().find(|&&point| point != first) else { return true };
    points.iter().all(|&third| are_collinear([first, second, third]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_on_a_line_are_told_from_those_that_nearly_are() {
        let line = |t: f64| [0.1 * t, 3.0 - 7.0 * t, t];
        assert!(!is_straight(&[line(1.0), line(3.0), line(7.0)]), "rounded");
        let exact = |t: f64| [0.125 * t, 3.0 - 7.0 * t, t];
        assert!(is_straight(&[exact(1.0), exact(4.0), exact(2.0), exact(-8.0)]));
        assert!(!is_straight(&[exact(1.0), exact(4.0), [0.25, -11.0, 2f64.next_up()]]));
        assert!(is_straight(&[exact(1.0), exact(1.0), exact(1.0)]) && is_straight(&[]));
    }

    #[test]
    fn also_where_products_under_or_overflow() {
        for unit in [5e-324, 1e-200, 1e300] {
            let at = |x: f64, y: f64| [x * unit, y * unit, 0.0];
            assert!(is_straight(&[at(0.0, 0.0), at(1.0, 2.0), at(2.0, 4.0)]), "{unit}");
            assert!(!is_straight(&[at(0.0, 0.0), at(1.0, 2.0), at(2.0, 5.0)]), "{unit}");
        }
        assert!(!is_straight(&[[0.0, 0.0, 0.0], [1e300, 0.0, 0.0], [0.0, 5e-324, 0.0]]));
        assert!(!is_straight(&[[f64::MAX, 0.0, 0.0], [-f64::MAX, 0.0, 0.0], [0.0, 0.0, 5e-324]]));
    }
}
