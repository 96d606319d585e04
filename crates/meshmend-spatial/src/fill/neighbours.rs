//! The way round that triangles of a fill have, and which of them lie side by side.

use meshmend_geometry::polygon::Triangle;

/// What lies across a side of a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Across {
    /// The face beside the side of the loop that begins at this corner.
    Loop(usize),
    /// Another triangle.
    Triangle(usize),
}

/// A side by the places of its ends, the lower first.
pub(super) type Side = [usize; 2];

/// A triangle with its places in ascending order: the way round that the loop has.
pub(super) fn ascending(mut triangle: Triangle) -> Triangle {
    triangle.sort_unstable();
    triangle
}

/// The sides of a triangle with ascending places.
pub(super) fn sides_of([a, b, c]: Triangle) -> [Side; 3] {
    [[a, b], [b, c], [a, c]]
}

/// For each triangle what lies across its three sides; `None` if these are not the triangles of one fill of a loop of `count`
/// corners, each with ascending places.
///
/// *Cost*: O(n log n).
pub(super) fn neighbours(triangles: &[Triangle], count: usize) -> Option<Vec<[Across; 3]>> {
    // Each side but those of the loop is the longest side of one triangle and a shorter one of another.
    let mut by_longest: Vec<(Side, usize)> =
        triangles.iter().enumerate().map(|(at, &[a, _, c])| ([a, c], at)).collect();
    by_longest.sort_unstable();
    if triangles.len() + 2 != count || by_longest.windows(2).any(|two| two[0].0 == two[1].0) {
        return None;
    }
    let mut across = vec![[Across::Loop(count - 1); 3]; triangles.len()];
    let mut below_sides = 0;
    for (at, &triangle) in triangles.iter().enumerate() {
        for (side, ends) in sides_of(triangle).into_iter().enumerate().take(2) {
            if ends[0] + 1 == ends[1] {
                across[at][side] = Across::Loop(ends[0]);
                continue;
            }
            let found = by_longest.binary_search_by_key(&ends, |(longest, _)| *longest).ok()?;
            let below = by_longest[found].1;
            across[at][side] = Across::Triangle(below);
            across[below][2] = Across::Triangle(at);
            below_sides += 1;
        }
    }
    let is_ascending = triangles.iter().all(|[a, b, c]| a < b && b < c && *c < count);
    (is_ascending && below_sides + 3 == count).then_some(across)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fan_is_a_row_of_triangles() {
        let across = neighbours(&[[0, 1, 2], [0, 2, 3], [0, 3, 4]], 5).unwrap();
        assert_eq!(across[1], [Across::Triangle(0), Across::Loop(2), Across::Triangle(2)]);
        assert_eq!(across[2], [Across::Triangle(1), Across::Loop(3), Across::Loop(4)]);
    }

    #[test]
    fn what_is_no_fill_is_told() {
        for triangles in
            [&[[0, 1, 2]][..], &[[0, 1, 2], [0, 1, 3]], &[[0, 1, 2], [0, 1, 2]], &[[0, 2, 1], [0, 2, 3]]]
        {
            assert_eq!(neighbours(triangles, 4), None, "{triangles:?}");
        }
    }
}
