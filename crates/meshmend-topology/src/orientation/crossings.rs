//! Which side lies across from each side, where an edge has exactly two?
//!
//! The same as [`Connectivity::across`] for all corners at once, with the question answered that every walk over
//! a patch asks next: whether the two sides run the same way, so that one of the two faces is mirrored.

use meshmend_core::{Column, Connectivity, CornerId};

/// For each corner the one across its edge, in one word.
#[derive(Clone, Debug)]
pub(crate) struct Crossings {
    /// The corner across, doubled, plus one where the two sides run the same way.
    of_corner: Column<CornerId, u32>,
}

/// The way over an edge with two sides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Crossing {
    /// The corner across.
    pub(crate) opposite: CornerId,
    /// Whether both sides run the same way.
    pub(crate) is_mirrored: bool,
}

const NONE: u32 = u32::MAX;

impl Crossings {
    /// The crossings of a complex.
    ///
    /// *Cost*: one pass over the edges; 4 bytes a corner.
    pub(crate) fn of<K: Connectivity>(kernel: &K) -> Self {
        let mut of_corner = Column::filled(NONE, kernel.corner_count());
        for edge in kernel.edges() {
            let mut sides = kernel.edge_sides(edge);
            if let (Some((one, way)), Some((other, back)), None) = (sides.next(), sides.next(), sides.next())
            {
                let is_mirrored = u32::from(way == back);
                // There are fewer than 2³¹ corners, so the doubled number fits.
                of_corner[one] = other.0 << 1 | is_mirrored;
                of_corner[other] = one.0 << 1 | is_mirrored;
            }
        }
        Crossings { of_corner }
    }

    /// The way across a corner's edge; `None` where it has not exactly two sides.
    #[inline]
    pub(crate) fn across(&self, corner: CornerId) -> Option<Crossing> {
        let word = self.of_corner[corner];
        (word != NONE).then_some(Crossing { opposite: CornerId(word >> 1), is_mirrored: word & 1 == 1 })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::Random;

    #[test]
    fn they_are_what_the_kernel_says() {
        let mut random = Random(31);
        for _ in 0..300 {
            let soup = random.soup(6, 9, 6);
            let faces: Vec<&[u32]> = soup.iter().map(Vec::as_slice).collect();
            let kernel = crate::shapes::kernel(6, &faces);
            let crossings = Crossings::of(&kernel);
            for corner in kernel.corners() {
                let expected = kernel.across(corner).map(|opposite| Crossing {
                    opposite,
                    is_mirrored: kernel.is_forward(corner) == kernel.is_forward(opposite),
                });
                assert_eq!(crossings.across(corner), expected);
            }
        }
    }
}
