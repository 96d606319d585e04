//! The largest eigenvalues of a large symmetric matrix, by Lanczos's method.
//!
//! From a start vector r a basis of r, Mr, M²r, … grows. Each new vector is made orthogonal to *all* before it, twice, so
//! that rounding does no harm. When the basis is full, it is cut down to the best approximations that are in it, and grows
//! on (a *thick restart*).
//!
//! Such a basis has one vector of each eigenspace, so an eigenvalue shows once, however often it is one. What has been
//! found is therefore *locked*, and another run begins orthogonal to it, until a run finds nothing that is large enough.
//! The start vectors are always the same.
//!
//! *Source*: C. Lanczos, *An iteration method for the solution of the eigenvalue problem*, 1950; K. Wu, H. Simon,
//! *Thick-restart Lanczos method for large symmetric eigenvalue problems*, 2000.

use super::eigen::{Eigen, Square};

/// A symmetric matrix, as what it makes of a vector.
pub(super) struct Symmetric<'a> {
    /// Writes the product with the first vector into the second.
    pub(super) apply: &'a dyn Fn(&[f64], &mut [f64]),
    pub(super) size: usize,
    /// No eigenvalue is larger, with or without its sign.
    pub(super) bound: f64,
}

/// An eigenvalue with its vector, of length 1.
#[derive(Clone, Debug)]
pub(super) struct Pair {
    pub(super) value: f64,
    pub(super) vector: Vec<f64>,
}

/// What a search was about to spend too much of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct TooSlow;

/// An approximation is one whose residual is less than this, as a part of the matrix's bound.
const TOLERANCE: f64 = 1e-12;
/// Why not always the same number: so that no start vector is orthogonal to an eigenvector for a reason.
const SEED: u64 = 0x6d65_7368_6d65_6e64;

/// How many vectors a basis has at most.
pub(super) fn basis_size(count: usize) -> usize {
    2 * count + 60
}

/// The largest `count` eigenvalues, or as many as there are, the largest one first; within a number of products of two
/// numbers that are summed up.
///
/// *Cost*: for a basis of m vectors of n numbers, m² n for each time that it fills.
pub(super) fn largest(matrix: &Symmetric<'_>, count: usize, work: u64) -> Result<Vec<Pair>, TooSlow> {
    let mut search = Search { matrix, count, locked: Vec::new(), random: SEED, work };
    let count = count.min(matrix.size);
    while search.locked.len() < matrix.size {
        let found = Run::begin(&mut search).finish(&mut search)?;
        let is_last = match (found.first(), search.locked.get(count - 1)) {
            (Some(first), Some(least)) => first.value <= least.value + TOLERANCE * matrix.bound,
            (None, _) => true,
            (_, None) => false,
        };
        search.locked.extend(found);
        search.locked.sort_by(|one, other| other.value.total_cmp(&one.value));
        if is_last {
            break;
        }
    }
    search.locked.truncate(count);
    Ok(search.locked)
}

/// What all runs share.
struct Search<'a> {
    matrix: &'a Symmetric<'a>,
    count: usize,
    /// What has been found, the largest value first.
    locked: Vec<Pair>,
    random: u64,
    work: u64,
}

impl Search<'_> {
    /// A vector of random numbers between −1 and 1, by Steele, Lea and Flood's SplitMix.
    fn random_vector(&mut self) -> Vec<f64> {
        let mut next = || {
            self.random = self.random.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let mut z = self.random;
            z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 52) as f64 - 1.0
        };
        (0..self.matrix.size).map(|_| next()).collect()
    }

    fn spend(&mut self, products: usize) -> Result<(), TooSlow> {
        self.work = self.work.checked_sub(products as u64).ok_or(TooSlow)?;
        Ok(())
    }

    /// How many of these values, the largest ones of a run, are among the largest of all or close them off.
    fn needed(&self, values: &[f64]) -> Option<usize> {
        (1..=values.len()).find(|&run| {
            let larger = self.locked.iter().filter(|pair| pair.value >= values[run - 1]).count();
            run + larger >= self.count
        })
    }
}

/// A basis that grows from one start vector.
struct Run {
    basis: Vec<Vec<f64>>,
    /// The matrix as the basis sees it.
    projected: Square,
    /// The next vector of the basis.
    next: Vec<f64>,
    /// How many vectors the basis may have.
    room: usize,
    /// How many dimensions the locked vectors leave.
    dimension: usize,
}

impl Run {
    fn begin(search: &mut Search<'_>) -> Self {
        let room = basis_size(search.count);
        let mut next = search.random_vector();
        for _ in 0..2 {
            search.locked.iter().for_each(|pair| _ = project_out(&mut next, &pair.vector));
        }
        normalise(&mut next);
        let dimension = search.matrix.size - search.locked.len();
        Run { basis: Vec::new(), projected: Square::zero(room), next, room, dimension }
    }

    /// The largest eigenvalues of what is not locked, as many as are needed or as one start vector can show.
    fn finish(mut self, search: &mut Search<'_>) -> Result<Vec<Pair>, TooSlow> {
        loop {
            let beyond = self.grow(search)?;
            let size = self.basis.len();
            search.spend(size.pow(3) * 40)?;
            let eigen = self.projected.eigen(size);
            if beyond == 0.0 {
                let kept = search.needed(&eigen.values).unwrap_or(size);
                return Ok(self.pairs(&eigen, kept));
            }
            let is_settled =
                |vector: &&Vec<f64>| (beyond * vector[size - 1]).abs() <= TOLERANCE * search.matrix.bound;
            let settled = eigen.vectors.iter().take_while(is_settled).count();
            if let Some(kept) = search.needed(&eigen.values[..settled]) {
                return Ok(self.pairs(&eigen, kept));
            }
            self.restart(&eigen, search)?;
        }
    }

    /// Lets the basis grow until it is full, or until the matrix leads to nothing beyond it. How much there is beyond it.
    fn grow(&mut self, search: &mut Search<'_>) -> Result<f64, TooSlow> {
        loop {
            let size = self.basis.len() + 1;
            search.spend(self.next.len() * 4 * (size + search.locked.len()))?;
            let mut product = vec![0.0; self.next.len()];
            (search.matrix.apply)(&self.next, &mut product);
            self.basis.push(std::mem::take(&mut self.next));
            for _ in 0..2 {
                search.locked.iter().for_each(|pair| _ = project_out(&mut product, &pair.vector));
                for (at, vector) in self.basis.iter().enumerate() {
                    let part = self.projected.get(at, size - 1) + project_out(&mut product, vector);
                    self.projected.set_both(at, size - 1, part);
                }
            }
            let beyond = normalise(&mut product);
            if size == self.dimension || beyond <= TOLERANCE * search.matrix.bound {
                return Ok(0.0);
            }
            self.next = product;
            if size == self.room {
                return Ok(beyond);
            }
        }
    }

    /// Keeps the better half of what is in the basis.
    fn restart(&mut self, eigen: &Eigen, search: &mut Search<'_>) -> Result<(), TooSlow> {
        let kept = (search.count + self.room) / 2;
        search.spend(self.next.len() * kept * self.room)?;
        self.basis = self.pairs(eigen, kept).into_iter().map(|pair| pair.vector).collect();
        self.projected = Square::zero(self.room);
        (0..kept).for_each(|at| self.projected.set(at, at, eigen.values[at]));
        Ok(())
    }

    /// The first approximations, as vectors of the whole space.
    fn pairs(&self, eigen: &Eigen, count: usize) -> Vec<Pair> {
        let whole = |parts: &Vec<f64>| {
            let mut vector = vec![0.0; self.basis.first().map_or(0, Vec::len)];
            for (part, basis) in parts.iter().zip(&self.basis) {
                vector.iter_mut().zip(basis).for_each(|(x, y)| *x += part * y);
            }
            normalise(&mut vector);
            vector
        };
        let pairs = eigen.values.iter().zip(&eigen.vectors).take(count);
        pairs.map(|(&value, parts)| Pair { value, vector: whole(parts) }).collect()
    }
}

/// Takes the part along a vector of length 1 out of another one, and says how much that was.
fn project_out(vector: &mut [f64], direction: &[f64]) -> f64 {
    let part = dot(vector, direction);
    vector.iter_mut().zip(direction).for_each(|(x, y)| *x -= part * y);
    part
}

/// Makes a vector as long as 1, if it is not 0, and says how long it was.
fn normalise(vector: &mut [f64]) -> f64 {
    let length = dot(vector, vector).sqrt();
    if length > 0.0 {
        vector.iter_mut().for_each(|x| *x /= length);
    }
    length
}

/// The sum of products, always added up in the same order.
pub(super) fn dot(one: &[f64], other: &[f64]) -> f64 {
    const LANES: usize = 8;
    let mut sums = [0.0; LANES];
    let (ones, others) = (one.chunks_exact(LANES), other.chunks_exact(LANES));
    let rest: f64 = ones.remainder().iter().zip(others.remainder()).map(|(x, y)| x * y).sum();
    for (xs, ys) in ones.zip(others) {
        for lane in 0..LANES {
            sums[lane] += xs[lane] * ys[lane];
        }
    }
    sums.iter().sum::<f64>() + rest
}
