//! The spectrum of a graph: eigenvalues of its adjacency matrix A, or of its Laplacian L = D − A.
//!
//! The largest eigenvalue of A is at most the highest degree. L has the eigenvalue 0 once for each part of the graph, and
//! the next one tells how hard it is to cut a part in two. D has the degrees on its diagonal.
//!
//! Each value comes with its vector and its *residual*, the length of Mx − λx: an eigenvalue is surely no farther away.
//!
//! *Source*: M. Fiedler, *Algebraic connectivity of graphs*, 1973.

use meshmend_core::{Adjacency, Id, VertexId};
use thiserror::Error;

use super::krylov::{Pair, Symmetric, TooSlow, basis_size, dot, largest};

/// The most eigenvalues that are found.
pub const MOST_EIGENVALUES: usize = 32;

/// How many numbers a search may keep in memory: half a gigabyte's worth.
const MOST_NUMBERS: usize = 1 << 26;

/// How many products of two numbers are summed up before a search gives up: half a minute's worth.
const WORK: u64 = 1 << 35;

/// Of which matrix eigenvalues are found, and which of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Operator {
    /// The largest ones of the adjacency matrix A.
    Adjacency,
    /// The smallest ones of the Laplacian L = D − A.
    Laplacian,
}

impl Operator {
    /// What it is called in commands and reports.
    pub fn name(self) -> &'static str {
        match self {
            Operator::Adjacency => "adjacency",
            Operator::Laplacian => "laplacian",
        }
    }
}

/// An eigenvalue of a graph.
#[derive(Clone, Debug, PartialEq)]
pub struct Eigenvalue {
    /// The value.
    pub value: f64,
    /// How far from it there is surely an eigenvalue, apart from rounding in this figure.
    pub residual: f64,
    /// An eigenvector of length 1. The first of its numbers that is nearly the largest one is positive.
    pub vector: Vec<f64>,
}

/// Why there is no spectrum.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum SpectrumError {
    /// Too many eigenvalues are asked for.
    #[error("up to {MOST_EIGENVALUES} eigenvalues are found, not {asked}")]
    TooMany {
        /// How many.
        asked: usize,
    },
    /// The vectors would take too much memory.
    #[error("eigenvalues of a graph of {vertices} vertices need more memory than the {} MiB that are allowed", MOST_NUMBERS >> 17)]
    TooLarge {
        /// How many vertices the graph has.
        vertices: usize,
    },
    /// The values do not settle soon enough.
    #[error(
        "the eigenvalues of this graph of {vertices} vertices are too close to one another to be told apart soon"
    )]
    TooSlow {
        /// How many vertices the graph has.
        vertices: usize,
    },
}

/// The `count` largest eigenvalues of A, descending, or smallest ones of L, ascending; each as often as it is one. Of a
/// graph with fewer vertices, all.
///
/// ```
/// use meshmend_core::{FaceTable, PolygonMesh, VertexId};
/// use meshmend_topology::matrices::{Graph, Operator, spectrum};
///
/// // The graph of a tetrahedron is K₄: 3, and three times −1.
/// let faces = [0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0].map(VertexId).to_vec();
/// let mesh = PolygonMesh::new(vec![[0.0; 3]; 4], FaceTable::triangles(4, faces)?)?;
/// let found = spectrum(&Graph::of(mesh.complex()), Operator::Adjacency, 4)?;
/// for (found, expected) in found.iter().zip([3.0, -1.0, -1.0, -1.0]) {
///     assert!((found.value - expected).abs() < 1e-9);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// For more than [`MOST_EIGENVALUES`]; where the vectors would take too much memory; where the values do not settle within
/// the work that is allowed.
///
/// *Cost*: for k values of a graph of n vertices memory for 4 k + 100 vectors of n numbers; time by how close the values
/// are to one another. One thread, and the same bits on every machine.
pub fn spectrum(
    graph: &impl Adjacency,
    operator: Operator,
    count: usize,
) -> Result<Vec<Eigenvalue>, SpectrumError> {
    spectrum_within(graph, operator, count, WORK)
}

fn spectrum_within(
    graph: &impl Adjacency,
    operator: Operator,
    count: usize,
    work: u64,
) -> Result<Vec<Eigenvalue>, SpectrumError> {
    let vertices = graph.graph_counts()[0];
    if count > MOST_EIGENVALUES {
        return Err(SpectrumError::TooMany { asked: count });
    }
    if vertices.saturating_mul(2 * basis_size(count)) > MOST_NUMBERS {
        return Err(SpectrumError::TooLarge { vertices });
    }
    if vertices == 0 || count == 0 {
        return Ok(Vec::new());
    }
    let ids = || (0..vertices).map(VertexId::new);
    let sign = match operator {
        Operator::Adjacency => 1.0,
        Operator::Laplacian => -1.0,
    };
    // The smallest eigenvalues of L are the largest ones of −L.
    let apply = |x: &[f64], product: &mut [f64]| {
        for (vertex, product) in ids().zip(product) {
            let own = x[vertex.index()];
            let difference = |neighbour: VertexId| match operator {
                Operator::Adjacency => x[neighbour.index()],
                Operator::Laplacian => x[neighbour.index()] - own,
            };
            *product = graph.neighbours(vertex).map(difference).sum();
        }
    };
    let matrix = Symmetric { apply: &apply, size: vertices, bound: bound(graph, operator) };
    let pairs = largest(&matrix, count, work).map_err(|TooSlow| SpectrumError::TooSlow { vertices })?;
    Ok(pairs.into_iter().map(|pair| judged(pair, &matrix, sign)).collect())
}

/// What no eigenvalue exceeds: of A the largest √(d d′), of L the largest d + d′, of the degrees at both ends of an edge.
fn bound(graph: &impl Adjacency, operator: Operator) -> f64 {
    let ids = (0..graph.graph_counts()[0]).map(VertexId::new);
    let degrees: Vec<f64> = ids.clone().map(|vertex| graph.neighbours(vertex).count() as f64).collect();
    let at_edge = |vertex: VertexId, other: VertexId| {
        let (one, other) = (degrees[vertex.index()], degrees[other.index()]);
        match operator {
            Operator::Adjacency => (one * other).sqrt(),
            Operator::Laplacian => one + other,
        }
    };
    let at_vertex =
        |vertex| graph.neighbours(vertex).map(move |other| at_edge(vertex, other)).fold(1.0, f64::max);
    ids.map(at_vertex).fold(1.0, f64::max)
}

/// The value that fits a vector best, and how well.
fn judged(pair: Pair, matrix: &Symmetric<'_>, sign: f64) -> Eigenvalue {
    let mut vector = pair.vector;
    let mut product = vec![0.0; vector.len()];
    (matrix.apply)(&vector, &mut product);
    let value = dot(&vector, &product);
    let error: Vec<f64> = product.iter().zip(&vector).map(|(product, x)| product - value * x).collect();
    let most = vector.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    if vector.iter().find(|x| x.abs() > 0.999_999 * most).is_some_and(|&x| x < 0.0) {
        vector.iter_mut().for_each(|x| *x = -*x);
    }
    Eigenvalue { value: sign * value, residual: dot(&error, &error).sqrt(), vector }
}

#[cfg(test)]
mod tests {
    use meshmend_testkit::assert_every_variant;

    use super::*;
    use crate::matrices::Graph;
    use crate::shapes::{self, Shape};

    /// A graph of ten million vertices, without an edge.
    struct Huge;

    impl Adjacency for Huge {
        const VIEW: &'static str = "huge";
        fn graph_counts(&self) -> [usize; 2] {
            [10_000_000, 0]
        }
        fn neighbours(&self, _: VertexId) -> impl Iterator<Item = VertexId> {
            std::iter::empty()
        }
    }

    fn graph(shape: &Shape) -> Graph {
        Graph::of(shape.mesh().complex())
    }

    /// 2 cos(2πi/n) for each i.
    fn cycle(n: u32) -> Vec<f64> {
        (0..n).map(|i| 2.0 * (std::f64::consts::TAU * f64::from(i) / f64::from(n)).cos()).collect()
    }

    #[track_caller]
    fn assert_spectrum(graph: &Graph, operator: Operator, mut expected: Vec<f64>) {
        expected.sort_by(f64::total_cmp);
        if operator == Operator::Adjacency {
            expected.reverse();
        }
        for count in [1, 2, 6, 32] {
            let found = spectrum(graph, operator, count).unwrap();
            assert_eq!(found.len(), count.min(expected.len()));
            for (found, expected) in found.iter().zip(&expected) {
                assert!((found.value - expected).abs() < 1e-9, "{} is not {expected}", found.value);
                assert!(found.residual < 1e-9, "{}", found.residual);
            }
        }
    }

    /// Checks both matrices of a graph whose vertices all have the same degree.
    #[track_caller]
    fn assert_regular(graph: &Graph, degree: f64, expected: Vec<f64>) {
        assert_spectrum(graph, Operator::Laplacian, expected.iter().map(|value| degree - value).collect());
        assert_spectrum(graph, Operator::Adjacency, expected);
    }

    #[test]
    fn complete_graphs() {
        for n in [3u32, 4, 7, 20, 40, 130] {
            let pairs = (1..n).flat_map(|a| (a + 1..n).map(move |b| vec![0, a, b]));
            let mut expected = vec![-1.0; n as usize];
            expected[0] = f64::from(n) - 1.0;
            assert_regular(&graph(&Shape(pairs.collect())), f64::from(n) - 1.0, expected);
        }
    }

    #[test]
    fn cycles() {
        for n in [3, 4, 5, 12, 101, 400] {
            assert_regular(&graph(&Shape(vec![(0..n).collect()])), 2.0, cycle(n));
        }
    }

    #[test]
    fn the_cube() {
        let cube: [&[u32]; 6] =
            [&[0, 1, 3, 2], &[4, 6, 7, 5], &[0, 4, 5, 1], &[2, 3, 7, 6], &[0, 2, 6, 4], &[1, 5, 7, 3]];
        assert_regular(&graph(&Shape::of(&cube)), 3.0, vec![3.0, 1.0, 1.0, 1.0, -1.0, -1.0, -1.0, -3.0]);
    }

    #[test]
    fn torus_grids() {
        for (columns, rows) in [(3, 3), (5, 8), (12, 12), (30, 20)] {
            let around = cycle(rows);
            let sums = cycle(columns).into_iter().flat_map(|x| around.iter().map(move |y| x + y));
            assert_regular(&graph(&shapes::torus(columns, rows)), 4.0, sums.collect());
        }
    }

    #[test]
    fn each_part_and_each_lone_vertex_has_a_zero_of_its_own() {
        let parts = [shapes::tetrahedron(), shapes::tetrahedron(), Shape(vec![vec![2, 3, 4]])];
        let found = spectrum(&graph(&Shape::side_by_side(&parts)), Operator::Laplacian, 6).unwrap();
        let zeros = found.iter().filter(|eigenvalue| eigenvalue.value.abs() < 1e-12).count();
        assert_eq!(zeros, 5);
        assert!((found[5].value - 3.0).abs() < 1e-9, "the triangle's");
    }

    #[test]
    fn what_is_refused() {
        let triangle = graph(&Shape::of(&[&[0, 1, 2]]));
        let of = Operator::Laplacian;
        let cases = vec![
            (spectrum(&triangle, of, 33), "up to 32 eigenvalues are found, not 33"),
            (
                spectrum(&Huge, of, 6),
                "eigenvalues of a graph of 10000000 vertices need more memory than the 512 MiB that are allowed",
            ),
            (
                spectrum_within(&graph(&shapes::torus(30, 30)), of, 6, 1 << 20),
                "the eigenvalues of this graph of 900 vertices are too close to one another to be told apart soon",
            ),
        ];
        let cases: Vec<_> = cases.into_iter().map(|(found, message)| (found.unwrap_err(), message)).collect();
        assert_every_variant!(cases, SpectrumError { TooMany, TooLarge, TooSlow });
        assert_eq!(spectrum(&triangle, Operator::Adjacency, 0), Ok(Vec::new()));
        assert_eq!(spectrum(&graph(&Shape::of(&[])), Operator::Laplacian, 3), Ok(Vec::new()));
    }

    #[test]
    fn vectors_have_a_fixed_sign_and_the_same_bits_each_time() {
        let torus = graph(&shapes::torus(6, 9));
        let found = spectrum(&torus, Operator::Laplacian, 9).unwrap();
        assert_eq!(spectrum(&torus, Operator::Laplacian, 9), Ok(found.clone()));
        for one in &found {
            let most = one.vector.iter().fold(0.0f64, |most, x| most.max(x.abs()));
            assert!(one.vector.iter().any(|&x| x > 0.999_999 * most));
            for other in found.iter().filter(|other| !std::ptr::eq(*other, one)) {
                assert!(dot(&one.vector, &other.vector).abs() < 1e-9);
            }
        }
    }
}
