//! What the factor of a matrix looks like: groups of columns that share their rows.

use super::ordering::{NONE, Order};
use super::{CholeskyError, Pattern};

/// The pattern of a factor, found once for all matrices of one pattern.
#[derive(Debug)]
pub(crate) struct Structure {
    /// The unknown of each column of the factor.
    pub(super) unknown_at: Vec<u32>,
    /// The groups, each after those that it depends on.
    pub(super) groups: Vec<Group>,
    /// The rows of all groups below their own columns, ascending in each.
    pub(super) rows: Vec<u32>,
    /// Column by column the row of each entry of the matrix, and where its value stands.
    pub(super) entry_starts: Vec<usize>,
    pub(super) entries: Vec<(u32, usize)>,
    /// How many numbers the factor has.
    pub(super) length: usize,
}

/// Columns that follow each other and have the same rows below them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Group {
    /// The first column, and how many there are.
    pub(super) first: u32,
    pub(super) width: u32,
    /// Where its rows below its own columns begin among all rows, and how many there are.
    pub(super) rows_start: usize,
    pub(super) below: u32,
    /// Where its numbers begin: `width` columns of `width + below` numbers.
    pub(super) start: usize,
    /// How many of the groups before it end in it: theirs are the topmost matrices on the stack.
    pub(super) children: u32,
}

impl Group {
    /// How many rows it has, its own among them.
    pub(super) fn height(&self) -> usize {
        (self.width + self.below) as usize
    }

    /// How many numbers it has.
    pub(super) fn length(&self) -> usize {
        self.width as usize * self.height()
    }

    /// Its rows below its own columns.
    pub(super) fn rows<'a>(&self, rows: &'a [u32]) -> &'a [u32] {
        &rows[self.rows_start..self.rows_start + self.below as usize]
    }
}

impl Structure {
    /// The factor's pattern for a matrix's.
    ///
    /// *Cost*: near linear in the pattern, and in the rows of all groups.
    pub(crate) fn of(pattern: Pattern) -> Result<Self, CholeskyError> {
        let order = Order::of(pattern)?;
        let (entry_starts, entries) = in_order(pattern, &order.step_of);
        let mut growing = Growing::new(pattern.size());
        for column in 0..pattern.size() as u32 {
            let own = &entries[entry_starts[column as usize]..entry_starts[column as usize + 1]];
            growing.add(column, own, &order.parent);
        }
        growing.close();
        let length = growing.groups.iter().map(Group::length).sum();
        Ok(Structure {
            unknown_at: order.unknown_at,
            groups: growing.groups,
            rows: growing.rows,
            entry_starts,
            entries,
            length,
        })
    }
}

/// The entries of a matrix by the columns of its factor, diagonals among them.
fn in_order(pattern: Pattern, step_of: &[u32]) -> (Vec<usize>, Vec<(u32, usize)>) {
    let moved = || {
        pattern.entries().map(|(at, row, column)| {
            let [one, other] = [row, column].map(|unknown| step_of[unknown as usize]);
            (at, one.max(other), one.min(other))
        })
    };
    let mut starts = vec![0; pattern.size() + 1];
    moved().for_each(|(_, _, column)| starts[column as usize + 1] += 1);
    (0..pattern.size()).for_each(|column| starts[column + 1] += starts[column]);
    let mut entries = vec![(0, 0); pattern.rows.len()];
    let mut next = starts.clone();
    for (at, row, column) in moved() {
        entries[next[column as usize]] = (row, at);
        next[column as usize] += 1;
    }
    (starts, entries)
}

/// Groups as they are found, column by column.
struct Growing {
    groups: Vec<Group>,
    rows: Vec<u32>,
    /// The columns of the last group, which may still grow: the first, how many, and how many groups end in them.
    first: u32,
    width: u32,
    children: u32,
    /// The rows of the last group, and how many of them are columns of it that have been added since.
    open: Vec<u32>,
    taken: usize,
    /// How many of its numbers are zeros.
    zeros: usize,
    /// The rows that the column to be added has beside the open ones.
    fresh: Vec<u32>,
    /// For each row in which line of columns it was met last.
    met: Vec<u32>,
    line: u32,
    /// The last closed group that ends in each column, and for each group the one before it that ends where it does.
    last_child: Vec<u32>,
    brother: Vec<u32>,
}

impl Growing {
    fn new(size: usize) -> Self {
        Growing {
            groups: Vec::new(),
            rows: Vec::new(),
            first: 0,
            width: 0,
            children: 0,
            open: Vec::new(),
            taken: 0,
            zeros: 0,
            fresh: Vec::new(),
            met: vec![NONE; size],
            line: 0,
            last_child: vec![NONE; size],
            brother: Vec::new(),
        }
    }

    /// Adds a column, with its entries: to the last group if that has nearly its rows, else as the first of a new one.
    fn add(&mut self, column: u32, own: &[(u32, usize)], parent: &[u32]) {
        let goes_on = self.width > 0 && parent[column as usize - 1] == column;
        if goes_on {
            self.taken += 1;
        } else {
            self.close();
            self.open.clear();
            self.line += 1;
        }
        self.gather(column, own);
        if goes_on && !self.takes_fresh() {
            self.close();
            self.open.retain(|&row| row > column);
        }
        if self.width == 0 {
            (self.first, self.taken, self.zeros, self.children) = (column, 0, 0, 0);
        }
        self.open.append(&mut self.fresh);
        self.width += 1;
        self.children += self.children_of(column).count() as u32;
    }

    /// The closed groups that end in a column.
    fn children_of(&self, column: u32) -> impl Iterator<Item = &Group> {
        let place = |group: u32| (group != NONE).then_some(group);
        let first = place(self.last_child[column as usize]);
        let all = std::iter::successors(first, move |&group| place(self.brother[group as usize]));
        all.map(|group| &self.groups[group as usize])
    }

    /// Gathers the rows of a column that are not among the open ones.
    fn gather(&mut self, column: u32, own: &[(u32, usize)]) {
        let mut fresh = std::mem::take(&mut self.fresh);
        let mut met = std::mem::take(&mut self.met);
        let mut look_at = |row: u32| {
            if row > column && std::mem::replace(&mut met[row as usize], self.line) != self.line {
                fresh.push(row);
            }
        };
        own.iter().for_each(|&(row, _)| look_at(row));
        self.children_of(column)
            .for_each(|child| child.rows(&self.rows).iter().for_each(|&row| look_at(row)));
        (self.fresh, self.met) = (fresh, met);
    }

    /// Whether the last group takes a column with the fresh rows: whether few of its numbers are zeros then.
    fn takes_fresh(&mut self) -> bool {
        let zeros = self.zeros + self.fresh.len() * self.width as usize;
        let width = self.width as usize + 1;
        let length = width * (width + self.open.len() - self.taken + self.fresh.len());
        let share = match width {
            0..=4 => 2,
            5..=16 => 8,
            _ => 20,
        };
        let takes = self.fresh.is_empty() || zeros * share <= length;
        if takes {
            self.zeros = zeros;
        }
        takes
    }

    /// Ends the last group, if there is one.
    fn close(&mut self) {
        if self.width == 0 {
            return;
        }
        let last = self.first + self.width - 1;
        let rows_start = self.rows.len();
        self.rows.extend(self.open.iter().filter(|&&row| row > last));
        let rows = &mut self.rows[rows_start..];
        rows.sort_unstable();
        if let Some(&ends_in) = rows.first() {
            self.brother.push(self.last_child[ends_in as usize]);
            self.last_child[ends_in as usize] = self.groups.len() as u32;
        } else {
            self.brother.push(NONE);
        }
        let start = self.groups.last().map_or(0, |group| group.start + group.length());
        let (first, width, children) = (self.first, self.width, self.children);
        let below = rows.len() as u32;
        self.groups.push(Group { first, width, rows_start, below, start, children });
        self.width = 0;
    }
}
