//! The edges that a sweep line crosses, from the lowest to the highest.

/// So many edges make a block that is parted.
const FULL: usize = 1024;

/// A list of edges that is searched by halving, in blocks, so that inserting moves few of them.
#[derive(Default)]
pub(super) struct SweepLine {
    /// None is empty.
    blocks: Vec<Vec<u32>>,
}

/// A place between two edges.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    block: usize,
    at: usize,
}

impl SweepLine {
    /// The place above all edges that are below something.
    ///
    /// *Cost*: O(log n) questions.
    pub(super) fn place_above(&self, is_below: impl Fn(u32) -> bool) -> Place {
        let block = self.blocks.partition_point(|block| block.last().is_some_and(|&edge| is_below(edge)));
        let edges = self.blocks.get(block).map_or(&[][..], Vec::as_slice);
        Place { block, at: edges.partition_point(|&edge| is_below(edge)) }
    }

    /// The edge below a place.
    pub(super) fn below(&self, Place { block, at }: Place) -> Option<u32> {
        match at.checked_sub(1) {
            Some(before) => self.blocks.get(block)?.get(before).copied(),
            None => self.blocks.get(block.checked_sub(1)?)?.last().copied(),
        }
    }

    /// Takes out the edge above a place, if it is one that is asked for.
    pub(super) fn remove_above(&mut self, place: Place, is_wanted: impl Fn(u32) -> bool) -> Option<u32> {
        let Place { block, at } = match self.blocks.get(place.block)? {
            edges if place.at == edges.len() => Place { block: place.block + 1, at: 0 },
            _ => place,
        };
        let edges = self.blocks.get_mut(block)?;
        let edge = edges.get(at).copied().filter(|&edge| is_wanted(edge))?;
        edges.remove(at);
        if edges.is_empty() {
            self.blocks.remove(block);
        }
        Some(edge)
    }

    /// Puts edges, from the lowest to the highest, at a place.
    pub(super) fn insert(&mut self, place: Place, edges: impl DoubleEndedIterator<Item = u32>) {
        let Place { mut block, mut at } = place;
        for edge in edges.rev() {
            if block == self.blocks.len() {
                match block.checked_sub(1) {
                    Some(last) => (block, at) = (last, self.blocks[last].len()),
                    None => self.blocks.push(Vec::new()),
                }
            }
            self.blocks[block].insert(at, edge);
            if self.blocks[block].len() == FULL {
                let upper = self.blocks[block].split_off(FULL / 2);
                self.blocks.insert(block + 1, upper);
                if at > FULL / 2 {
                    (block, at) = (block + 1, at - FULL / 2);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_edges_stay_in_order() {
        let mut line = SweepLine::default();
        // A permutation of 0..5003.
        for i in 0..5003u32 {
            let edge = i * 1000 % 5003;
            let place = line.place_above(|other| other < edge);
            assert!(line.below(place).is_none_or(|other| other < edge));
            line.insert(place, std::iter::once(edge));
        }
        assert!(line.blocks.iter().flatten().copied().eq(0..5003));
        for i in 0..5003u32 {
            let edge = i * 77 % 5003;
            let place = line.place_above(|other| other < edge);
            assert_eq!(line.remove_above(place, |other| other == edge), Some(edge));
            assert_eq!(line.remove_above(place, |other| other == edge), None);
        }
        assert!(line.blocks.is_empty());
    }

    #[test]
    fn edges_are_put_in_together() {
        let mut line = SweepLine::default();
        line.insert(line.place_above(|_| true), [0, 1, 9000].into_iter());
        line.insert(line.place_above(|other| other < 2), 2..9000);
        assert!(line.blocks.iter().flatten().copied().eq(0..=9000));
        assert_eq!(line.below(line.place_above(|_| false)), None);
    }
}
