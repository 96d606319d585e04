//! The sign of the volume that triangles enclose.

use meshmend_geometry::vector::{Point, cross, dot, length, minus};
use num_bigint::BigInt;

use super::integers::{cross as integers_cross, dot as integers_dot, integer, lowest_exponent};
use super::sign::Sign;

/// The sign of the volume that closed triangles enclose: positive if they run anticlockwise seen from outside.
///
/// Triangles that leave an opening enclose no volume; their answer means nothing.
///
/// *Cost*: linear; about a microsecond a triangle where the volume is within rounding of zero.
pub fn volume_sign(triangles: impl Iterator<Item = [Point; 3]> + Clone) -> Sign {
    let Some([origin, ..]) = triangles.clone().next() else { return Sign::Zero };
    let (mut sum, mut size, mut count) = (0.0, 0.0, 0.0);
    for [a, b, c] in triangles.clone().map(|triangle| triangle.map(|corner| minus(corner, origin))) {
        sum += dot(a, cross(b, c));
        // No term is larger than the product of the lengths.
        size += length(a) * length(b) * length(c) + f64::MIN_POSITIVE * 1e20;
        count += 1.0;
    }
    let is_moderate = |x: &f64| *x == 0.0 || (1e-72..1e72).contains(&x.abs());
    if sum.abs() > f64::EPSILON * (count + 32.0) * size
        && size < f64::INFINITY
        && triangles.clone().flatten().flatten().all(|x| is_moderate(&x))
    {
        return Sign::of(sum);
    }
    exactly(triangles)
}

fn exactly(triangles: impl Iterator<Item = [Point; 3]> + Clone) -> Sign {
    let coordinates: Vec<f64> = triangles.clone().flatten().flatten().collect();
    let lowest = lowest_exponent(coordinates.iter());
    let of_triangle = |triangle: [Point; 3]| {
        let [a, b, c] = triangle.map(|corner| corner.map(|number| integer(number, lowest)));
        integers_dot(&a, &integers_cross(&b, &c))
    };
    Sign::from(&triangles.map(of_triangle).sum::<BigInt>())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tetrahedron(scale: f64, height: f64) -> [[Point; 3]; 4] {
        let corners = [[0.0, 0.0, 0.0], [scale, 0.0, 0.0], [0.0, scale, 0.0], [scale, scale, height]];
        [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]].map(|face| face.map(|at: usize| corners[at]))
    }

    #[test]
    fn volumes_have_a_sign_at_any_scale() {
        for scale in [1.0, 5e-324, 1e-200, 1e200, 1e307] {
            for height in [scale, 5e-324, 0.0] {
                let solid = tetrahedron(scale, height);
                let turned = solid.map(|[a, b, c]| [a, c, b]);
                let expected = Sign::of(height);
                assert_eq!(volume_sign(solid.into_iter()), expected, "{scale} {height}");
                assert_eq!(volume_sign(turned.into_iter()), -expected, "{scale} {height}");
            }
        }
        assert_eq!(volume_sign(std::iter::empty()), Sign::Zero);
    }
}
