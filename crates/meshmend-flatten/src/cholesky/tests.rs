//! The factor beside a dense one and beside the definition, on patterns of many kinds.

use super::{CholeskyError, Pattern, Structure};

/// A matrix as its lower triangle.
struct Matrix {
    starts: Vec<usize>,
    rows: Vec<u32>,
    values: Vec<f64>,
}

/// A fixed sequence without a pattern, of numbers below the bound.
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) as usize) % bound
    }
}

impl Matrix {
    /// The weighted Laplacian of a graph, and a little more on its diagonal, so that it is positive definite.
    fn of_graph(size: usize, edges: impl IntoIterator<Item = (usize, usize)>) -> Self {
        let mut edges: Vec<(usize, usize)> =
            edges.into_iter().map(|(a, b)| (a.min(b), a.max(b))).filter(|(a, b)| a != b).collect();
        edges.sort_unstable();
        edges.dedup();
        let weight = |a: usize, b: usize| 1.0 + ((a * 7 + b * 13) % 11) as f64 / 4.0;
        let mut matrix = Matrix { starts: vec![0], rows: Vec::new(), values: Vec::new() };
        for column in 0..size {
            let beside = edges.iter().filter(|&&(a, b)| a == column || b == column);
            let diagonal = 0.125 + beside.map(|&(a, b)| weight(a, b)).sum::<f64>();
            matrix.rows.push(column as u32);
            matrix.values.push(diagonal);
            for &(a, b) in edges.iter().filter(|&&(a, _)| a == column) {
                matrix.rows.push(b as u32);
                matrix.values.push(-weight(a, b));
            }
            matrix.starts.push(matrix.rows.len());
        }
        matrix
    }

    fn pattern(&self) -> Pattern<'_> {
        Pattern { starts: &self.starts, rows: &self.rows }
    }

    fn times(&self, vector: &[[f64; 2]]) -> Vec<[f64; 2]> {
        let mut product = vec![[0.0; 2]; vector.len()];
        for (at, row, column) in self.pattern().entries() {
            let (row, column) = (row as usize, column as usize);
            let mut add = |to: usize, from: usize| {
                product[to] = [0, 1].map(|side| product[to][side] + self.values[at] * vector[from][side]);
            };
            add(row, column);
            if row != column {
                add(column, row);
            }
        }
        product
    }

    fn solve(&self, sides: &[[f64; 2]]) -> Result<Vec<[f64; 2]>, CholeskyError> {
        let structure = Structure::of(self.pattern())?;
        let mut solution = sides.to_vec();
        structure.factorize(&self.values)?.solve(&mut solution);
        Ok(solution)
    }

    #[track_caller]
    fn assert_solved(&self) {
        let size = self.starts.len() - 1;
        let expected: Vec<[f64; 2]> =
            (0..size).map(|at| [(at % 17) as f64 - 8.0, 1.0 / (1 + at % 5) as f64]).collect();
        let found = self.solve(&self.times(&expected)).unwrap();
        for (unknown, (found, expected)) in found.iter().zip(&expected).enumerate() {
            let off = (found[0] - expected[0]).hypot(found[1] - expected[1]);
            assert!(off < 1e-9, "{size} unknowns: x{unknown} is {found:?} in place of {expected:?}");
        }
    }
}

/// A grid of so many rows and columns, with one diagonal in each cell.
fn grid(rows: usize, columns: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..rows * columns).flat_map(move |at| {
        let (row, column) = (at / columns, at % columns);
        let right = (column + 1 < columns).then_some((at, at + 1));
        let down = (row + 1 < rows).then_some((at, at + columns));
        let across = (column + 1 < columns && row + 1 < rows).then_some((at, at + columns + 1));
        [right, down, across].into_iter().flatten()
    })
}

#[test]
fn no_unknowns_one_and_none_that_hang_together() {
    for size in [0, 1, 2, 3, 40] {
        Matrix::of_graph(size, []).assert_solved();
    }
}

#[test]
fn paths_stars_cycles_and_full_graphs() {
    for size in [2, 3, 4, 5, 8, 31, 32, 33, 64, 65, 70, 130] {
        Matrix::of_graph(size, (1..size).map(|at| (at - 1, at))).assert_solved();
        Matrix::of_graph(size, (1..size).map(|at| (0, at))).assert_solved();
        Matrix::of_graph(size, (1..size).map(|at| (size - 1, at - 1))).assert_solved();
        Matrix::of_graph(size, (0..size).map(|at| (at, (at + 1) % size))).assert_solved();
        Matrix::of_graph(size, (0..size).flat_map(|a| (0..a).map(move |b| (a, b)))).assert_solved();
    }
}

#[test]
fn grids_long_and_square_and_several_of_them() {
    for (rows, columns) in [(2, 2), (2, 90), (3, 3), (5, 40), (9, 9), (24, 24), (40, 50)] {
        Matrix::of_graph(rows * columns, grid(rows, columns)).assert_solved();
        let other = grid(rows, columns).map(|(a, b)| (a + rows * columns, b + rows * columns));
        Matrix::of_graph(2 * rows * columns + 1, grid(rows, columns).chain(other)).assert_solved();
    }
}

#[test]
fn random_graphs_sparse_and_dense() {
    let mut numbers = Numbers(14);
    for case in 0..300 {
        let size = 1 + numbers.below(60);
        let count = numbers.below(size * (1 + case % 5));
        let edges: Vec<(usize, usize)> =
            (0..count).map(|_| (numbers.below(size), numbers.below(size))).collect();
        Matrix::of_graph(size, edges).assert_solved();
    }
}

/// The order keeps the factor sparse, and groups have few zeros.
#[test]
fn few_numbers_are_wasted() {
    let matrix = Matrix::of_graph(3600, grid(60, 60));
    let structure = Structure::of(matrix.pattern()).unwrap();
    let filled: usize = structure.groups.iter().map(|group| group.length()).sum();
    assert_eq!(filled, structure.length);
    assert!(filled < 110_000, "{filled} numbers for 3600 unknowns");
    let columns: u32 = structure.groups.iter().map(|group| group.width).sum();
    assert_eq!(columns, 3600);
}

#[test]
fn what_is_not_positive_definite_is_refused() {
    for change in [-1e3, 0.0, f64::NAN] {
        let mut matrix = Matrix::of_graph(81, grid(9, 9));
        let place = matrix.starts[40];
        matrix.values[place] = change;
        assert_eq!(matrix.solve(&[[0.0; 2]; 81]), Err(CholeskyError::NotPositive), "{change}");
    }
}

#[test]
fn a_factor_is_the_same_on_any_number_of_threads() {
    let full = (0..400).flat_map(|a| (0..a).map(move |b| (a, b)));
    let matrix = Matrix::of_graph(400, full);
    let sides: Vec<[f64; 2]> = (0..400).map(|at| [at as f64, 1.0 / (at + 1) as f64]).collect();
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| matrix.solve(&sides)).unwrap()
    };
    assert_eq!(on(1), on(3));
}
