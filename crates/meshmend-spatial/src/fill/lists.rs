//! The triangles of a fill in the order in which they lie along the loop, as a list that can be compared.

use std::cmp::Ordering;

use meshmend_core::VertexId;
use meshmend_geometry::polygon::Triangle;

use super::LARGEST_EXACT;
use super::ranges::Ranges;

/// For each triangle the ones that were chosen below its two other sides.
pub(super) type Choices = [[Option<u32>; 2]];

/// The triangles of the fill below a triangle, in their order.
pub(super) fn listed(ranges: &Ranges<'_>, choices: &Choices, top: usize) -> Vec<Triangle> {
    Walk::new(choices, top).map(|triangle| ranges.corners(triangle)).collect()
}

/// Which of the fills below two triangles has the first list, by the vertices of their triangles.
pub(super) fn compared(ranges: &Ranges<'_>, choices: &Choices, one: usize, other: usize) -> Ordering {
    let names =
        |triangle: usize| -> [VertexId; 3] { ranges.corners(triangle).map(|corner| ranges.vertices[corner]) };
    let mut both = Walk::new(choices, one).zip(Walk::new(choices, other)).filter(|(a, b)| a != b);
    both.next().map_or(Ordering::Equal, |(a, b)| names(a).cmp(&names(b)))
}

/// Goes through the triangles of a fill along the loop: what is below the first side, the triangle, what is below the second.
struct Walk<'a> {
    choices: &'a Choices,
    /// What comes when all below its first side was there. Each lies below the one before it, so that there are fewer than
    /// corners.
    waiting: [u32; LARGEST_EXACT],
    count: usize,
}

impl<'a> Walk<'a> {
    fn new(choices: &'a Choices, top: usize) -> Self {
        let mut walk = Walk { choices, waiting: [0; LARGEST_EXACT], count: 0 };
        walk.descend(Some(top as u32));
        walk
    }

    fn descend(&mut self, mut from: Option<u32>) {
        while let Some(triangle) = from {
            self.waiting[self.count] = triangle;
            self.count += 1;
            from = self.choices[triangle as usize][0];
        }
    }
}

impl Iterator for Walk<'_> {
    type Item = usize;

    fn next(&mut self) -> Option<usize> {
        self.count = self.count.checked_sub(1)?;
        let triangle = self.waiting[self.count] as usize;
        self.descend(self.choices[triangle][1]);
        Some(triangle)
    }
}
