//! In which order unknowns are eliminated, and what then hangs on what.

use feral_amd::{CscPattern, amd_order};

use super::{CholeskyError, Pattern};

/// An order of elimination in which the columns that depend on each other follow each other.
#[derive(Debug)]
pub(super) struct Order {
    /// The unknown that is eliminated at each step.
    pub(super) unknown_at: Vec<u32>,
    /// The step at which each unknown is eliminated.
    pub(super) step_of: Vec<u32>,
    /// The first later step that each step changes; `NONE` where there is none. Steps are in postorder of this forest.
    pub(super) parent: Vec<u32>,
}

pub(super) const NONE: u32 = u32::MAX;

impl Order {
    /// An order of approximately minimum degree.
    pub(super) fn of(pattern: Pattern) -> Result<Self, CholeskyError> {
        let neighbours = Neighbours::of(pattern)?;
        let both_halves = CscPattern::new(pattern.size(), &neighbours.starts, &neighbours.of);
        let sparse = both_halves.and_then(|pattern| amd_order(&pattern).ok());
        let sparse = sparse.ok_or(CholeskyError::OutOfMemory)?;
        let unknown_at: Vec<u32> = sparse.into_iter().map(|unknown| unknown as u32).collect();
        let step_of = inverse(&unknown_at);
        let parent = neighbours.forest(&unknown_at, &step_of);
        let postorder = postorder(&parent);
        let place = inverse(&postorder);
        let unknown_at: Vec<u32> = postorder.iter().map(|&step| unknown_at[step as usize]).collect();
        let moved = |step: u32| if step == NONE { NONE } else { place[step as usize] };
        Ok(Order {
            step_of: inverse(&unknown_at),
            parent: postorder.iter().map(|&step| moved(parent[step as usize])).collect(),
            unknown_at,
        })
    }
}

/// The unknowns beside each unknown, ascending.
struct Neighbours {
    starts: Vec<i32>,
    of: Vec<i32>,
}

impl Neighbours {
    fn of(pattern: Pattern) -> Result<Self, CholeskyError> {
        let apart = || pattern.entries().filter(|&(_, row, column)| row != column);
        if i32::try_from(2 * pattern.rows.len()).is_err() {
            return Err(CholeskyError::OutOfMemory);
        }
        let mut starts = vec![0; pattern.size() + 1];
        apart().flat_map(|(_, row, column)| [row, column]).for_each(|one| starts[one as usize + 1] += 1);
        (0..pattern.size()).for_each(|one| starts[one + 1] += starts[one]);
        let mut of = vec![0; starts[pattern.size()] as usize];
        let mut next = starts.clone();
        let mut put = |to: u32, one: u32| {
            of[next[to as usize] as usize] = one as i32;
            next[to as usize] += 1;
        };
        // Lower neighbours before higher ones, each kind ascending.
        apart().for_each(|(_, row, column)| put(row, column));
        apart().for_each(|(_, row, column)| put(column, row));
        Ok(Neighbours { starts, of })
    }

    /// For each step the first later one that it changes: the forest of elimination.
    fn forest(&self, unknown_at: &[u32], step_of: &[u32]) -> Vec<u32> {
        let mut parent = vec![NONE; unknown_at.len()];
        // A short cut from each step to one above it, so that no path is walked twice.
        let mut above = parent.clone();
        for (&unknown, step) in unknown_at.iter().zip(0..) {
            let ends = self.starts[unknown as usize] as usize..self.starts[unknown as usize + 1] as usize;
            for &neighbour in &self.of[ends] {
                let mut at = step_of[neighbour as usize];
                while at < step {
                    let next = std::mem::replace(&mut above[at as usize], step);
                    if next == NONE {
                        parent[at as usize] = step;
                    }
                    at = next;
                }
            }
        }
        parent
    }
}

/// The nodes of a forest in which parents have higher numbers: the children of each node right before it.
fn postorder(parent: &[u32]) -> Vec<u32> {
    // From the last to the first, each node gets its place: its subtree lies right before it.
    let mut size: Vec<u32> = vec![1; parent.len()];
    for (node, &above) in parent.iter().enumerate() {
        if above != NONE {
            size[above as usize] += size[node];
        }
    }
    let mut order = vec![0; parent.len()];
    let mut free_before: Vec<u32> = vec![0; parent.len()];
    let mut free_at_roots = parent.len() as u32;
    for node in (0..parent.len()).rev() {
        let free = match parent[node] {
            NONE => &mut free_at_roots,
            above => &mut free_before[above as usize],
        };
        let place = *free - 1;
        *free -= size[node];
        order[place as usize] = node as u32;
        free_before[node] = place;
    }
    order
}

/// Where each number is in an order.
fn inverse(order: &[u32]) -> Vec<u32> {
    let mut places = vec![0; order.len()];
    order.iter().zip(0..).for_each(|(&one, place)| places[one as usize] = place);
    places
}
