//! Which cells beside its own a cube reaches.

use super::grid::{CUBES, InCell, PLACES, REACH, in_cell};

/// The rows of cells along z beside a cell, by their steps along x and y. The other half of the cells beside it, with those
/// before it in its own row, find this one among theirs.
pub(super) const ROWS: [[i8; 2]; 5] = [[0, 0], [0, 1], [1, -1], [1, 0], [1, 1]];

/// For each cube of a cell which cells of these rows it reaches: three bits a row, from a step of −1 along z up.
pub(super) const NEIGHBOURS_AHEAD: [u16; CUBES] = {
    let mut ahead = [0; CUBES];
    let mut at = 0;
    while at < CUBES {
        let mut row = 0;
        while row < ROWS.len() {
            let [dx, dy] = ROWS[row];
            let mut dz = if row == 0 { 1 } else { -1 };
            while dz <= 1 {
                if reaches(at as InCell, [dx, dy, dz]) {
                    ahead[at] |= 1 << (3 * row as i8 + dz + 1);
                }
                dz += 1;
            }
            row += 1;
        }
        at += 1;
    }
    ahead
};

/// The steps along z to the cells of a row that are reached.
pub(super) fn ahead_in_row(ahead: u16, row: usize) -> impl Iterator<Item = i8> {
    let steps = ahead >> (3 * row) & 7;
    (-1..=1).filter(move |step| steps >> (step + 1) & 1 == 1)
}

/// Whether a cube may be near one of the cell a step away.
pub(super) const fn reaches(at: InCell, step: [i8; 3]) -> bool {
    let [x, y, z] = in_cell(at);
    reaches_along(x, step[0]) && reaches_along(y, step[1]) && reaches_along(z, step[2])
}

const fn reaches_along(place: i8, step: i8) -> bool {
    match step {
        -1 => place < REACH,
        1 => place >= PLACES - REACH,
        _ => true,
    }
}

#[cfg(test)]
mod tests {
    use super::super::grid::steps_between;
    use super::*;

    #[test]
    fn every_pair_of_cubes_within_reach_is_found_from_one_side() {
        let steps = (0..27).map(|i| [i / 9 - 1, i / 3 % 3 - 1, i % 3 - 1]);
        for step in steps.filter(|step| *step != [0; 3]) {
            let row = ROWS.iter().position(|row| row == &step[..2]);
            let row = row.filter(|&row| row > 0 || step[2] > 0);
            let back = step.map(|x: i8| -x);
            let is_ahead_of_the_other = ROWS.iter().any(|row| row == &back[..2]) && back > [0; 3];
            assert_eq!(row.is_none(), is_ahead_of_the_other, "{step:?}");
            for (at, &ahead) in NEIGHBOURS_AHEAD.iter().enumerate() {
                let is_near = |other| {
                    let way = steps_between(at as InCell, other as InCell, step);
                    way.iter().all(|steps| steps.abs() <= REACH)
                };
                let any = (0..CUBES).any(is_near);
                assert_eq!(reaches(at as InCell, step), any);
                if let Some(row) = row {
                    assert_eq!(ahead_in_row(ahead, row).any(|dz| dz == step[2]), any, "{at} {step:?}");
                }
            }
        }
    }
}
