//! The numbers of a factor, group by group, and the solution of equations with them.

use super::structure::{Group, Structure};
use super::{CholeskyError, dense, zeros};

/// The factor of a matrix.
#[derive(Debug)]
pub(crate) struct Factor<'a> {
    structure: &'a Structure,
    /// Group by group its columns, with all its rows; what lies above a diagonal means nothing.
    numbers: Vec<f64>,
}

impl Structure {
    /// The factor of the matrix with these values, in the order of the pattern's rows.
    ///
    /// # Errors
    /// When the matrix is not positive definite in doubles, or the factor does not fit.
    ///
    /// *Cost*: for a triangulation of n nodes about n^1.5 operations.
    pub(crate) fn factorize(&self, values: &[f64]) -> Result<Factor<'_>, CholeskyError> {
        let mut numbers = zeros(self.length)?;
        let mut work = Work {
            structure: self,
            values,
            place_of: zeros(self.unknown_at.len())?,
            stack: Stack::default(),
            tiles: dense::Tiles::default(),
        };
        let mut rest = &mut numbers[..];
        for group in &self.groups {
            let (own, after) = rest.split_at_mut(group.length());
            work.eliminate(group, own)?;
            rest = after;
        }
        Ok(Factor { structure: self, numbers })
    }
}

/// What the groups that are done leave to those that they end in: a square matrix each, over their rows.
#[derive(Default)]
struct Stack<'a> {
    numbers: Vec<f64>,
    /// The rows of each matrix.
    rows: Vec<&'a [u32]>,
}

struct Work<'a> {
    structure: &'a Structure,
    values: &'a [f64],
    /// Where each row is among the rows of the group at hand.
    place_of: Vec<u32>,
    stack: Stack<'a>,
    tiles: dense::Tiles,
}

impl<'a> Work<'a> {
    /// Computes the columns of a group, and puts onto the stack what they leave to others.
    fn eliminate(&mut self, group: &Group, own: &mut [f64]) -> Result<(), CholeskyError> {
        let structure = self.structure;
        let (rows, side) = (group.rows(&structure.rows), group.below as usize);
        let all_rows = (group.first..group.first + group.width).chain(rows.iter().copied());
        all_rows.zip(0..).for_each(|(row, place)| self.place_of[row as usize] = place);
        self.load(group, own);
        let begin = self.stack.numbers.len();
        let square = side * side;
        self.stack.numbers.try_reserve(square).map_err(|_| CholeskyError::OutOfMemory)?;
        self.stack.numbers.resize(begin + square, 0.0);
        let taken = self.take_children(group, own, begin);
        dense::factorize(own, group.height(), &mut self.tiles)?;
        let square_of = &mut self.stack.numbers[begin..];
        dense::subtract_eliminated(square_of, side, own, group.height(), &mut self.tiles);
        self.stack.numbers.copy_within(begin.., taken);
        self.stack.numbers.truncate(taken + square);
        if side > 0 {
            self.stack.rows.push(rows);
        }
        Ok(())
    }

    /// Puts the values of the matrix in their places.
    fn load(&self, group: &Group, own: &mut [f64]) {
        let structure = self.structure;
        for (column, target) in (group.first as usize..).zip(own.chunks_exact_mut(group.height())) {
            for &(row, at) in
                &structure.entries[structure.entry_starts[column]..structure.entry_starts[column + 1]]
            {
                target[self.place_of[row as usize] as usize] += self.values[at];
            }
        }
    }

    /// Adds the matrices of a group's children to its columns, and to the square that begins there on the stack; gives
    /// where the first of them begins.
    fn take_children(&mut self, group: &Group, own: &mut [f64], begin: usize) -> usize {
        let (done, square) = self.stack.numbers.split_at_mut(begin);
        let (width, height) = (group.width as usize, group.height());
        let mut end = begin;
        for _ in 0..group.children {
            let Some(rows) = self.stack.rows.pop() else { break };
            let side = rows.len();
            let matrix = &done[end - side * side..end];
            end -= side * side;
            let places = || rows.iter().map(|&row| self.place_of[row as usize] as usize);
            for ((source, column), from) in matrix.chunks_exact(side).zip(places()).zip(0..) {
                let (target, above) = match column.checked_sub(width) {
                    None => (&mut own[column * height..(column + 1) * height], 0),
                    Some(column) => {
                        let side = height - width;
                        (&mut square[column * side..(column + 1) * side], width)
                    }
                };
                source[from..]
                    .iter()
                    .zip(places().skip(from))
                    .for_each(|(value, place)| target[place - above] += value);
            }
        }
        end
    }
}

impl Factor<'_> {
    /// Solves the equations for two right sides, a pair of numbers for each unknown, and puts the solution in their place.
    pub(crate) fn solve(&self, sides: &mut [[f64; 2]]) {
        let structure = self.structure;
        let mut by_column: Vec<[f64; 2]> =
            structure.unknown_at.iter().map(|&unknown| sides[unknown as usize]).collect();
        let mut below = Vec::new();
        for group in &structure.groups {
            self.descend(group, &mut by_column, &mut below);
        }
        for group in structure.groups.iter().rev() {
            self.ascend(group, &mut by_column, &mut below);
        }
        let places = structure.unknown_at.iter().map(|&unknown| unknown as usize);
        places.zip(by_column).for_each(|(unknown, solution)| sides[unknown] = solution);
    }

    fn columns(&self, group: &Group) -> impl DoubleEndedIterator<Item = (usize, &[f64])> {
        let numbers = &self.numbers[group.start..group.start + group.length()];
        numbers.chunks_exact(group.height()).enumerate().map(|(place, column)| (place, &column[place..]))
    }

    /// The unknowns of a group by those of the groups before it, and what they do to those after it.
    fn descend(&self, group: &Group, by_column: &mut [[f64; 2]], work: &mut Vec<[f64; 2]>) {
        let own = group.first as usize..(group.first + group.width) as usize;
        let rows = group.rows(&self.structure.rows);
        work.clear();
        work.extend_from_slice(&by_column[own.clone()]);
        work.extend(rows.iter().map(|&row| by_column[row as usize]));
        for (place, column) in self.columns(group) {
            let Some((pivot, below)) = column.split_first() else { continue };
            let solution = work[place].map(|side| side / pivot);
            work[place] = solution;
            for (target, &entry) in work[place + 1..].iter_mut().zip(below) {
                target[0] -= entry * solution[0];
                target[1] -= entry * solution[1];
            }
        }
        let (ours, theirs) = work.split_at(own.len());
        by_column[own].copy_from_slice(ours);
        rows.iter().zip(theirs).for_each(|(&row, &value)| by_column[row as usize] = value);
    }

    /// The unknowns of a group by those of the groups after it.
    fn ascend(&self, group: &Group, by_column: &mut [[f64; 2]], work: &mut Vec<[f64; 2]>) {
        let own = group.first as usize..(group.first + group.width) as usize;
        let rows = group.rows(&self.structure.rows);
        work.clear();
        work.extend_from_slice(&by_column[own.clone()]);
        work.extend(rows.iter().map(|&row| by_column[row as usize]));
        for (place, column) in self.columns(group).rev() {
            let Some((pivot, below)) = column.split_first() else { continue };
            let mut side = work[place];
            for (known, &entry) in work[place + 1..].iter().zip(below) {
                side[0] -= entry * known[0];
                side[1] -= entry * known[1];
            }
            work[place] = side.map(|side| side / pivot);
        }
        by_column[own.clone()].copy_from_slice(&work[..own.len()]);
    }
}
