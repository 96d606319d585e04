//! Points and vectors in space, in doubles.

/// A point, or the vector from the origin to it.
pub type Point = [f64; 3];

/// Whether all coordinates of a point are finite.
pub fn is_finite(point: &Point) -> bool {
    point.iter().all(|x| x.is_finite())
}

/// A place as bits, −0 being 0.
pub fn place_bits(point: Point) -> [u64; 3] {
    point.map(|x| (x + 0.0).to_bits())
}

/// The vector from the second point to the first.
#[inline]
pub fn minus(a: Point, b: Point) -> Point {
    std::array::from_fn(|i| a[i] - b[i])
}

/// The scalar product.
#[inline]
pub fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The vector product.
#[inline]
pub fn cross(a: Point, b: Point) -> Point {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The length of a vector.
pub fn length(a: Point) -> f64 {
    dot(a, a).sqrt()
}

/// Twice the area vector of a polygon: the sum of a fan's cross products, taken from its first corner.
pub fn area_vector(mut corners: impl Iterator<Item = Point>) -> Point {
    let Some(first) = corners.next() else { return [0.0; 3] };
    let mut sum = [0.0; 3];
    let mut last: Option<Point> = None;
    for spoke in corners.map(|corner| minus(corner, first)) {
        if let Some(before) = last.replace(spoke) {
            let part = cross(before, spoke);
            sum = std::array::from_fn(|i| sum[i] + part[i]);
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_area_vector_of_a_square_is_twice_its_area_long() {
        let square = [[1.0, 1.0, 5.0], [3.0, 1.0, 5.0], [3.0, 3.0, 5.0], [1.0, 3.0, 5.0]];
        assert_eq!(area_vector(square.into_iter()), [0.0, 0.0, 8.0]);
        assert_eq!(area_vector(square.into_iter().rev()), [0.0, 0.0, -8.0]);
        assert_eq!(area_vector(std::iter::empty()), [0.0; 3]);
    }
}
