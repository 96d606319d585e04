//! The Cholesky factorisation of a sparse matrix that is symmetric and positive definite.
//!
//! Three steps, each in a file of its own: an [order](ordering) of elimination that keeps the factor sparse; what the
//! factor [looks like](structure), which depends on the pattern alone; and the [numbers](numbers), for which the columns
//! are taken in groups that share their rows, so that all arithmetic is on [dense](dense) matrices.
//!
//! It rounds in one order, on any number of threads and with no instruction that only some processors have: the same
//! matrix has the same factor, bit by bit, wherever it is computed.
//!
//! *Sources*: P. R. Amestoy, T. A. Davis, I. S. Duff, *An approximate minimum degree ordering algorithm*, 1996.
//! J. W. H. Liu, *The multifrontal method for sparse matrix solution: theory and practice*, 1992.

mod dense;
mod numbers;
mod ordering;
mod structure;

pub(crate) use numbers::Factor;
pub(crate) use structure::Structure;

use thiserror::Error;

/// Why there is no factor.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub(crate) enum CholeskyError {
    /// A pivot is not positive.
    #[error("the matrix is not positive definite")]
    NotPositive,
    /// The factor does not fit.
    #[error("there is not enough memory for the factor")]
    OutOfMemory,
}

/// The lower triangle of a symmetric matrix, column by column: where each begins, and its rows, ascending from the diagonal.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pattern<'a> {
    pub(crate) starts: &'a [usize],
    pub(crate) rows: &'a [u32],
}

impl Pattern<'_> {
    /// How many rows and columns there are.
    pub(crate) fn size(&self) -> usize {
        self.starts.len() - 1
    }

    /// The place, the row and the column of each entry.
    fn entries(&self) -> impl Iterator<Item = (usize, u32, u32)> {
        let columns = self.starts.windows(2).zip(0..);
        columns.flat_map(move |(ends, column)| (ends[0]..ends[1]).map(move |at| (at, self.rows[at], column)))
    }
}

/// A vector of so many zeros, if there is room for it.
fn zeros<T: Clone + Default>(length: usize) -> Result<Vec<T>, CholeskyError> {
    let mut vector = Vec::new();
    vector.try_reserve_exact(length).map_err(|_| CholeskyError::OutOfMemory)?;
    vector.resize(length, T::default());
    Ok(vector)
}

#[cfg(test)]
mod tests;
