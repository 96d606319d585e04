//! The weighted graph Laplacian of a triangulation, and the solution of its equations with a fixed boundary.
//!
//! The equations put each inner node in the mean of its neighbours, weighted by the weights of the edges. They are
//! solved by a Cholesky factorisation on one thread, and what rounding left is taken out in two further steps, whose
//! errors are relative to the distances between neighbours, not to their coordinates.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::LltRegularization;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LltRef, SymbolicCholesky, SymmetricOrdering, factorize_symbolic_cholesky,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut, Par, Side};

use crate::error::FlattenError;

/// The edges of a triangulation, each once, and the structure of the equations over its free nodes.
#[derive(Debug)]
pub(crate) struct Laplacian {
    /// The lower and the higher node of each edge, ascending.
    pub(crate) ends: Vec<[u32; 2]>,
    /// The place of each inner node among the unknowns, in order; `PINNED` for the others.
    unknown: Vec<u32>,
    /// The lower triangle of the system, column by column: where each begins, and the rows.
    starts: Vec<usize>,
    rows: Vec<usize>,
    factor: SymbolicCholesky<usize>,
}

const PINNED: u32 = u32::MAX;
const CORRECTIONS: usize = 2;

impl Laplacian {
    /// The Laplacian of triangles whose nodes are free except for the pinned ones.
    pub(crate) fn of(
        triangles: &[[u32; 3]],
        node_count: usize,
        pinned: impl Iterator<Item = u32>,
    ) -> Result<Self, FlattenError> {
        let mut ends: Vec<[u32; 2]> = triangles
            .iter()
            .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
            .map(|[a, b]| [a.min(b), a.max(b)])
            .collect();
        ends.sort_unstable();
        ends.dedup();
        let unknown = number_unknowns(triangles, node_count, pinned);
        let (starts, rows) = lower_triangle(&ends, &unknown);
        let count = starts.len() - 1;
        let pattern = SymbolicSparseColMatRef::new_checked(count, count, &starts, None, &rows);
        let parameters = CholeskySymbolicParams::default();
        let factor = factorize_symbolic_cholesky(pattern, Side::Lower, SymmetricOrdering::Amd, parameters)
            .map_err(|_| FlattenError::OutOfMemory)?;
        Ok(Laplacian { ends, unknown, starts, rows, factor })
    }

    /// The index of the edge between two nodes.
    pub(crate) fn between(&self, one: u32, other: u32) -> Option<usize> {
        self.ends.binary_search(&[one.min(other), one.max(other)]).ok()
    }

    /// Whether a node moves.
    pub(crate) fn is_free(&self, node: usize) -> bool {
        self.unknown[node] != PINNED
    }

    /// Moves the free nodes to the solution of the equations.
    pub(crate) fn solve(&self, weights: &[f64], points: &mut [[f64; 2]]) -> Result<(), FlattenError> {
        let count = self.starts.len() - 1;
        if count == 0 {
            return Ok(());
        }
        let pattern = SymbolicSparseColMatRef::new_checked(count, count, &self.starts, None, &self.rows);
        let values = self.matrix(weights);
        let matrix = SparseColMatRef::new(pattern, &values);
        let mut factors = vec![0.0; self.factor.len_val()];
        let mut memory =
            buffer(self.factor.factorize_numeric_llt_scratch::<f64>(Par::Seq, Default::default()))?;
        let factors = self
            .factor
            .factorize_numeric_llt(
                &mut factors,
                matrix,
                Side::Lower,
                LltRegularization::default(),
                Par::Seq,
                MemStack::new(&mut memory),
                Default::default(),
            )
            .map_err(|_| FlattenError::NoRest)?;
        // The free nodes start together, so that the first step is the solution and the others correct it.
        for (point, &unknown) in points.iter_mut().zip(&self.unknown) {
            if unknown != PINNED {
                *point = [0.5, 0.5];
            }
        }
        for _ in 0..=CORRECTIONS {
            self.correct(factors, weights, points)?;
        }
        Ok(())
    }

    /// Moves the free nodes by what the forces on them ask for.
    fn correct(
        &self,
        factors: LltRef<'_, usize, f64>,
        weights: &[f64],
        points: &mut [[f64; 2]],
    ) -> Result<(), FlattenError> {
        let count = self.starts.len() - 1;
        let mut moves = self.forces(weights, points);
        let mut memory = buffer(self.factor.solve_in_place_scratch::<f64>(2, Par::Seq))?;
        let sides = MatMut::from_column_major_slice_mut(&mut moves, count, 2);
        factors.solve_in_place_with_conj(Conj::No, sides, Par::Seq, MemStack::new(&mut memory));
        for (point, &unknown) in points.iter_mut().zip(&self.unknown) {
            if unknown != PINNED {
                point[0] += moves[unknown as usize];
                point[1] += moves[count + unknown as usize];
            }
        }
        Ok(())
    }

    /// The force on each free node: first along one axis, then along the other.
    fn forces(&self, weights: &[f64], points: &[[f64; 2]]) -> Vec<f64> {
        let count = self.starts.len() - 1;
        let mut forces = vec![0.0; 2 * count];
        for (&[a, b], &weight) in self.ends.iter().zip(weights) {
            let [from, to] = [a, b].map(|node| points[node as usize]);
            for (node, sign) in [(a, 1.0), (b, -1.0)] {
                let unknown = self.unknown[node as usize];
                if unknown != PINNED {
                    forces[unknown as usize] += sign * weight * (to[0] - from[0]);
                    forces[count + unknown as usize] += sign * weight * (to[1] - from[1]);
                }
            }
        }
        forces
    }

    /// The entries of the lower triangle, in the order of its rows.
    fn matrix(&self, weights: &[f64]) -> Vec<f64> {
        let mut values = vec![0.0; self.rows.len()];
        let mut next: Vec<usize> = self.starts.iter().map(|start| start + 1).collect();
        for (&[a, b], &weight) in self.ends.iter().zip(weights) {
            let [low, high] = [a, b].map(|node| self.unknown[node as usize]);
            for unknown in [low, high].into_iter().filter(|&unknown| unknown != PINNED) {
                values[self.starts[unknown as usize]] += weight;
            }
            if low != PINNED && high != PINNED {
                values[next[low as usize]] = -weight;
                next[low as usize] += 1;
            }
        }
        values
    }
}

/// Numbers the nodes of triangles that are not pinned; a node of no triangle counts as pinned.
fn number_unknowns(triangles: &[[u32; 3]], node_count: usize, pinned: impl Iterator<Item = u32>) -> Vec<u32> {
    let mut unknown = vec![PINNED; node_count];
    triangles.iter().flatten().for_each(|&node| unknown[node as usize] = 0);
    pinned.for_each(|node| unknown[node as usize] = PINNED);
    let free = unknown.iter_mut().filter(|unknown| **unknown != PINNED);
    free.zip(0..).for_each(|(unknown, place)| *unknown = place);
    unknown
}

/// Column by column a diagonal entry and one for each edge to a higher unknown. Edges are sorted, and so are these.
fn lower_triangle(ends: &[[u32; 2]], unknown: &[u32]) -> (Vec<usize>, Vec<usize>) {
    let inner = || {
        let both = ends.iter().map(|ends| ends.map(|node| unknown[node as usize]));
        both.filter(|both| !both.contains(&PINNED))
    };
    let count = unknown.iter().filter(|&&unknown| unknown != PINNED).count();
    let mut starts = vec![0; count + 1];
    inner().for_each(|[low, _]| starts[low as usize + 1] += 1);
    for column in 0..count {
        starts[column + 1] += starts[column] + 1;
    }
    let mut rows = vec![0; starts[count]];
    let mut next = starts.clone();
    for column in 0..count {
        rows[next[column]] = column;
        next[column] += 1;
    }
    for [low, high] in inner() {
        rows[next[low as usize]] = high as usize;
        next[low as usize] += 1;
    }
    (starts, rows)
}

fn buffer(size: faer::dyn_stack::StackReq) -> Result<MemBuffer, FlattenError> {
    MemBuffer::try_new(size).map_err(|_| FlattenError::OutOfMemory)
}
