//! Vectors of three doubles.

pub(crate) type Vector = [f64; 3];

pub(crate) fn add(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub(crate) fn subtract(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(crate) fn scaled(a: Vector, factor: f64) -> Vector {
    a.map(|x| x * factor)
}

pub(crate) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The vector of length one that points the same way; `None` for a vector of no direction.
pub(crate) fn direction(a: Vector) -> Option<Vector> {
    let largest = a.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    if largest == 0.0 || !a.iter().all(|x| x.is_finite()) {
        return None;
    }
    let small = a.map(|x| x / largest);
    Some(scaled(small, 1.0 / dot(small, small).sqrt()))
}

/// The mean of some points; `None` where there is none.
pub(crate) fn mean(points: impl Iterator<Item = Vector>) -> Option<Vector> {
    let (sum, count) = points.fold(([0.0; 3], 0.0), |(sum, count), p| (add(sum, p), count + 1.0));
    (count > 0.0).then(|| scaled(sum, 1.0 / count))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_are_found_for_vectors_of_any_length() {
        assert_eq!(direction([0.0, 1e308, 0.0]), Some([0.0, 1.0, 0.0]));
        assert_eq!(direction([0.0, 0.0, -5e-324]), Some([0.0, 0.0, -1.0]));
        assert_eq!(direction([0.0; 3]), None);
        assert_eq!(direction([f64::NAN, 1.0, 0.0]), None);
    }

    #[test]
    fn a_mean_of_nothing_is_none() {
        assert_eq!(mean([[1.0, 2.0, 3.0], [3.0, 2.0, 1.0]].into_iter()), Some([2.0; 3]));
        assert_eq!(mean(std::iter::empty()), None);
    }
}
