//! What are the ranks of ∂₁ and ∂₂, and what follows for the Betti numbers?
//!
//! β₀ = V − rank ∂₁, β₁ = dim ker ∂₁ − rank ∂₂ = E − rank ∂₁ − rank ∂₂, β₂ = dim ker ∂₂ = F − rank ∂₂, over whichever
//! field the ranks are taken. V and F are the vertices and faces of the complex. `betti` finds the same numbers by patches.
//!
//! Over ℚ the rank is exact. It is never smaller than the rank modulo a prime, and larger only if the prime divides every
//! largest minor that is not 0. By Hadamard's inequality a minor is at most the product of the lengths of its columns. So
//! not all primes of a list can divide one if their product is larger than that, and the largest rank over such a list is
//! the rank over ℚ. The list has a prime for each 20 triangles or so, so this is for small complexes.
//!
//! *Source*: J. Hadamard, *Résolution d'une question relative aux déterminants*, 1893.

use meshmend_core::{EdgeId, FaceId, Id, Incidence};
use thiserror::Error;

use super::contraction::{Row, rank};
use super::{Field, IncidenceMatrices, Prime};

/// The most cells, that is vertices, edges and faces together, of a complex whose ranks over ℚ are found.
pub const MOST_RATIONAL_CELLS: usize = 2000;

/// How many matrix entries elimination touches before it gives up.
pub const RANK_BUDGET: u64 = 1 << 27;

/// Why there is no rank.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum RankError {
    /// The complex is too large for exact ranks over ℚ.
    #[error(
        "ranks over Q are found for up to {MOST_RATIONAL_CELLS} cells, and there are {cells}; over a prime there is no such limit"
    )]
    TooLarge {
        /// How many vertices, edges and faces there are.
        cells: usize,
    },
    /// Elimination would take too long.
    #[error("ranks over {field} take more than {budget} steps of elimination")]
    OverBudget {
        /// The field.
        field: Field,
        /// How many matrix entries may be touched.
        budget: u64,
    },
}

impl IncidenceMatrices {
    /// The ranks of ∂₁ and ∂₂ over a field.
    ///
    /// # Errors
    /// Over ℚ for more than [`MOST_RATIONAL_CELLS`] cells; over any field where elimination touches more than
    /// [`RANK_BUDGET`] entries.
    ///
    /// *Cost*: nearly linear where edges have up to two faces; elimination for the rest. Over ℚ as often as there are
    /// primes in the list.
    pub fn ranks(&self, field: Field) -> Result<[usize; 2], RankError> {
        self.ranks_within(field, RANK_BUDGET)
    }

    /// The ranks of ∂₁ and ∂₂ over a field, within a budget of matrix entries touched for each rank over a prime.
    ///
    /// # Errors
    /// Those of [`ranks`](Self::ranks), with this budget.
    ///
    /// *Cost*: that of [`ranks`](Self::ranks).
    pub fn ranks_within(&self, field: Field, budget: u64) -> Result<[usize; 2], RankError> {
        let over_budget = RankError::OverBudget { field, budget };
        let prime_count = match field {
            Field::Modulo(prime) => return self.ranks_modulo(prime, budget).ok_or(over_budget),
            Field::Rationals => self.rational_primes()?,
        };
        let mut found = [0; 2];
        for prime in Prime::descending().take(prime_count) {
            let [first, second] = self.ranks_modulo(prime, budget).ok_or(over_budget)?;
            found = [found[0].max(first), found[1].max(second)];
        }
        Ok(found)
    }

    /// The Betti numbers over a field, by the ranks.
    ///
    /// ```
    /// use meshmend_core::{FaceTable, PolygonMesh, VertexId};
    /// use meshmend_topology::matrices::{Field, IncidenceMatrices, Prime};
    ///
    /// // The projective plane with six vertices.
    /// let faces = [
    ///     0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5, 0, 5, 1, 1, 2, 4, 2, 3, 5, 3, 4, 1, 4, 5, 2, 5, 1, 3,
    /// ];
    /// let table = FaceTable::triangles(6, faces.map(VertexId).to_vec())?;
    /// let matrices = IncidenceMatrices::of(PolygonMesh::new(vec![[0.0; 3]; 6], table)?.complex());
    /// assert_eq!(matrices.betti(Field::Modulo(Prime::TWO)), Ok([1, 1, 1]));
    /// assert_eq!(matrices.betti(Field::Rationals), Ok([1, 0, 0]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`ranks`](Self::ranks).
    ///
    /// *Cost*: that of [`ranks`](Self::ranks).
    pub fn betti(&self, field: Field) -> Result<[usize; 3], RankError> {
        self.ranks(field).map(|ranks| self.betti_of_ranks(ranks))
    }

    /// The Betti numbers that follow from the ranks of ∂₁ and ∂₂.
    ///
    /// *Cost*: linear.
    pub fn betti_of_ranks(&self, [first, second]: [usize; 2]) -> [usize; 3] {
        let [vertices, faces] = self.proper_counts();
        let edges = self.cell_counts()[1];
        [vertices - first, edges - first - second, faces - second]
    }

    /// How many primes between 2³⁰ and 2³¹ have a product that is larger than any minor of ∂₁ or ∂₂.
    fn rational_primes(&self) -> Result<usize, RankError> {
        let cells = self.cell_counts().iter().sum();
        if cells > MOST_RATIONAL_CELLS {
            return Err(RankError::TooLarge { cells });
        }
        // In bits: a column of length √n adds half the logarithm of n, here rounded up.
        let bits = |column: &mut dyn Iterator<Item = i64>| {
            let square: u64 = column.map(|entry| entry.unsigned_abs().pow(2)).sum();
            f64::from(u64::BITS - square.leading_zeros()) / 2.0
        };
        let [_, edges, faces] = self.cell_counts();
        let first: f64 = (0..edges)
            .map(|e| bits(&mut self.boundary_of_edge(EdgeId::new(e)).into_iter().map(|entry| entry.1)))
            .sum();
        let second: f64 =
            (0..faces).map(|f| bits(&mut self.boundary_of_face(FaceId::new(f)).map(|entry| entry.1))).sum();
        Ok((first.max(second) / 30.0) as usize + 1)
    }

    fn ranks_modulo(&self, prime: Prime, budget: u64) -> Option<[usize; 2]> {
        let [vertices, edges, faces] = self.cell_counts();
        let of_edge = |e: usize| -> Row {
            self.boundary_of_edge(EdgeId::new(e)).map(|(vertex, sign)| (vertex.0, sign)).to_vec()
        };
        let along_edge = |e: usize| -> Row {
            self.coboundary_of_edge(EdgeId::new(e)).map(|(face, times)| (face.0, times)).collect()
        };
        let first = rank(prime.field(), vertices, (0..edges).map(of_edge), budget)?;
        let second = rank(prime.field(), faces, (0..edges).map(along_edge), budget)?;
        Some([first, second])
    }
}

#[cfg(test)]
mod tests {
    use meshmend_testkit::assert_every_variant;

    use super::*;
    use crate::shapes::{self, Shape};

    fn matrices(shape: &Shape) -> IncidenceMatrices {
        IncidenceMatrices::of(shape.mesh().complex())
    }

    fn over(shape: &Shape, fields: &[Field]) -> Vec<[usize; 3]> {
        fields.iter().map(|&field| matrices(shape).betti(field).unwrap()).collect()
    }

    #[test]
    fn torsion_shows_over_its_own_prime_alone() {
        let prime = |number| Field::Modulo(Prime::new(number).unwrap());
        let fields = [prime(2), prime(3), prime(5), Field::Rationals];
        let plain = [1, 0, 0];
        assert_eq!(over(&shapes::projective_plane(), &fields), [[1, 1, 1], plain, plain, plain]);
        let wrapped = |times| shapes::disc_with_rim(&[0, 1, 2].repeat(times));
        assert_eq!(over(&wrapped(3), &fields), [plain, [1, 1, 1], plain, plain]);
        assert_eq!(over(&wrapped(5), &fields), [plain, plain, [1, 1, 1], plain]);
        assert_eq!(over(&wrapped(6), &fields), [[1, 1, 1], [1, 1, 1], plain, plain]);
        assert_eq!(over(&shapes::klein_bottle(4, 5), &fields)[0], [1, 2, 1]);
        assert_eq!(over(&shapes::klein_bottle(4, 5), &fields)[3], [1, 1, 0]);
    }

    /// A disc wrapped round a circle as often as the first prime of the list says would deceive that prime alone.
    #[test]
    fn ranks_over_q_do_not_hang_on_one_prime() {
        let list: Vec<u32> = Prime::descending().take(4).map(Prime::number).collect();
        assert!(list.windows(2).all(|pair| pair[0] > pair[1]));
        // One face that goes round a triangle three times: a column of entries 3, so the bound has to know it.
        let solid = matrices(&Shape::of(&[&[0, 1, 2, 0, 1, 2, 0, 1, 2]]));
        assert_eq!(solid.ranks(Field::Modulo(Prime::new(3).unwrap())), Ok([2, 0]));
        assert_eq!(solid.ranks(Field::Rationals), Ok([2, 1]));
        assert_eq!(solid.rational_primes(), Ok(1));
        assert_eq!(matrices(&shapes::torus(10, 10)).rational_primes(), Ok(1 + 200 * 2 / 2 / 30));
    }

    #[test]
    fn nothing_has_no_rank() {
        let empty = matrices(&Shape::of(&[]));
        assert_eq!(empty.ranks(Field::Rationals), Ok([0, 0]));
        assert_eq!(empty.betti(Field::Modulo(Prime::TWO)), Ok([0, 0, 0]));
    }

    #[test]
    fn q_is_refused_with_the_size_and_all_else_where_it_would_take_too_long() {
        let large = matrices(&shapes::torus(30, 30));
        let too_large = large.ranks(Field::Rationals).unwrap_err();
        assert_eq!(large.betti(Field::Modulo(Prime::TWO)), Ok([1, 2, 1]));
        let branched = matrices(&shapes::three_hemispheres());
        let over_budget = branched.ranks_within(Field::Modulo(Prime::TWO), 2).unwrap_err();
        let cases = vec![
            (
                too_large,
                "ranks over Q are found for up to 2000 cells, and there are 3600; over a prime there is no such limit",
            ),
            (over_budget, "ranks over Z/2 take more than 2 steps of elimination"),
        ];
        assert_every_variant!(cases, RankError { TooLarge, OverBudget });
    }
}
