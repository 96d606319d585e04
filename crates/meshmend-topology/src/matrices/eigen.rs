//! The eigenvalues and eigenvectors of a small symmetric matrix, by Jacobi's rotations.
//!
//! Each rotation makes one entry beside the diagonal 0; a few rounds over all of them leave nothing but the diagonal.
//! Nothing but sums, products, quotients and roots is used, so every machine gives the same bits.
//!
//! *Source*: C. G. J. Jacobi, *Über ein leichtes Verfahren, die in der Theorie der Säcularstörungen vorkommenden
//! Gleichungen numerisch aufzulösen*, 1846.

/// A square matrix, by rows.
#[derive(Clone, Debug, Default)]
pub(super) struct Square {
    size: usize,
    entries: Vec<f64>,
}

/// Eigenvalues, the largest one first, each with its vector.
#[derive(Clone, Debug)]
pub(super) struct Eigen {
    pub(super) values: Vec<f64>,
    pub(super) vectors: Vec<Vec<f64>>,
}

/// More rounds than any matrix needs.
const MOST_ROUNDS: usize = 60;

impl Square {
    pub(super) fn zero(size: usize) -> Self {
        Square { size, entries: vec![0.0; size * size] }
    }

    pub(super) fn get(&self, row: usize, column: usize) -> f64 {
        self.entries[row * self.size + column]
    }

    pub(super) fn set(&mut self, row: usize, column: usize, value: f64) {
        self.entries[row * self.size + column] = value;
    }

    /// Sets an entry and the one that is equal to it.
    pub(super) fn set_both(&mut self, row: usize, column: usize, value: f64) {
        self.set(row, column, value);
        self.set(column, row, value);
    }

    /// The eigenvalues and eigenvectors of the first rows and columns, so many of them, which are symmetric.
    pub(super) fn eigen(&self, size: usize) -> Eigen {
        let (mut matrix, mut vectors) = (Square::zero(size), Square::zero(size));
        for row in 0..size {
            vectors.set(row, row, 1.0);
            (0..size).for_each(|column| matrix.set(row, column, self.get(row, column)));
        }
        for _ in 0..MOST_ROUNDS {
            let mut has_rotated = false;
            for p in 0..size {
                for q in p + 1..size {
                    if let Some((cosine, sine)) = matrix.rotation(p, q) {
                        matrix.rotate_rows(p, q, cosine, sine);
                        matrix.rotate_columns(p, q, cosine, sine);
                        vectors.rotate_rows(p, q, cosine, sine);
                        matrix.set_both(p, q, 0.0);
                        has_rotated = true;
                    }
                }
            }
            if !has_rotated {
                break;
            }
        }
        let mut order: Vec<usize> = (0..size).collect();
        order.sort_by(|&one, &other| matrix.get(other, other).total_cmp(&matrix.get(one, one)));
        Eigen {
            values: order.iter().map(|&at| matrix.get(at, at)).collect(),
            vectors: order.iter().map(|&at| vectors.row(at).to_vec()).collect(),
        }
    }

    fn row(&self, row: usize) -> &[f64] {
        &self.entries[row * self.size..(row + 1) * self.size]
    }

    /// The cosine and sine of the rotation that makes an entry 0; `None` where it is 0 beside the diagonal already.
    fn rotation(&self, p: usize, q: usize) -> Option<(f64, f64)> {
        let (entry, from, to) = (self.get(p, q), self.get(p, p), self.get(q, q));
        if entry.abs() <= f64::EPSILON * 1e-2 * (from.abs() + to.abs()) || entry.abs() < f64::MIN_POSITIVE {
            return None;
        }
        let slope = (to - from) / (2.0 * entry);
        let tangent = slope.signum() / (slope.abs() + (slope * slope + 1.0).sqrt());
        let cosine = 1.0 / (tangent * tangent + 1.0).sqrt();
        Some((cosine, tangent * cosine))
    }

    fn rotate_rows(&mut self, p: usize, q: usize, cosine: f64, sine: f64) {
        for column in 0..self.size {
            let (one, other) = (self.get(p, column), self.get(q, column));
            self.set(p, column, cosine * one - sine * other);
            self.set(q, column, sine * one + cosine * other);
        }
    }

    fn rotate_columns(&mut self, p: usize, q: usize, cosine: f64, sine: f64) {
        for row in 0..self.size {
            let (one, other) = (self.get(row, p), self.get(row, q));
            self.set(row, p, cosine * one - sine * other);
            self.set(row, q, sine * one + cosine * other);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::Random;

    #[test]
    fn a_matrix_times_its_vectors_are_its_values_times_its_vectors() {
        let mut random = Random(3);
        for size in 0..30 {
            let mut matrix = Square::zero(size);
            for row in 0..size {
                (0..=row).for_each(|column| matrix.set_both(row, column, random.below(9) as f64 - 4.0));
            }
            let found = matrix.eigen(size);
            assert!(found.values.is_sorted_by(|one, other| one >= other));
            for (value, vector) in found.values.iter().zip(&found.vectors) {
                let length: f64 = vector.iter().map(|x| x * x).sum();
                assert!((length - 1.0).abs() < 1e-13);
                for (row, x) in vector.iter().enumerate() {
                    let product: f64 = matrix.row(row).iter().zip(vector).map(|(a, x)| a * x).sum();
                    assert!((product - value * x).abs() < 1e-12, "{size}");
                }
            }
        }
    }
}
