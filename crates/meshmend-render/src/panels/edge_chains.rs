//! Joining links to paths, so that a dashed line goes on from one edge to the next.

/// The links of each path, in order, each with whether it is followed from its first node to its second.
#[derive(Clone, Debug, Default)]
pub(crate) struct Chains {
    links: Vec<(u32, Direction)>,
    ends: Vec<usize>,
}

/// Which way a link is followed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Direction {
    Forward,
    Backward,
}

impl Chains {
    /// Joins links at every node where exactly two of them meet; each link is in one path. Paths begin at their
    /// lowest possible link.
    ///
    /// *Cost*: one sort of the links' ends.
    pub(crate) fn of(links: &[[u32; 2]]) -> Self {
        let meeting = Meeting::of(links);
        let mut chains = Chains::default();
        let mut is_taken = vec![false; links.len()];
        // First from the ends of open paths, then round what is left.
        for only_ends in [true, false] {
            for link in 0..links.len() {
                for direction in [Direction::Forward, Direction::Backward] {
                    let start = end_of(links, link as u32, direction, 0);
                    if !is_taken[link] && (!only_ends || meeting.next(start, link as u32).is_none()) {
                        chains.follow(links, &meeting, &mut is_taken, (link as u32, direction));
                    }
                }
            }
        }
        chains
    }

    /// The paths.
    pub(crate) fn iter(&self) -> impl Iterator<Item = &[(u32, Direction)]> {
        let starts = std::iter::once(0).chain(self.ends.iter().copied());
        starts.zip(&self.ends).map(|(start, &end)| &self.links[start..end])
    }

    fn follow(
        &mut self,
        links: &[[u32; 2]],
        meeting: &Meeting,
        is_taken: &mut [bool],
        first: (u32, Direction),
    ) {
        let mut step = Some(first);
        while let Some((link, direction)) = step.filter(|&(link, _)| !is_taken[link as usize]) {
            is_taken[link as usize] = true;
            self.links.push((link, direction));
            let node = end_of(links, link, direction, 1);
            step = meeting.next(node, link).map(|next| {
                let is_forward = links[next as usize][0] == node;
                (next, if is_forward { Direction::Forward } else { Direction::Backward })
            });
        }
        self.ends.push(self.links.len());
    }
}

/// The node at which a link begins (0) or ends (1) when it is followed in a direction.
fn end_of(links: &[[u32; 2]], link: u32, direction: Direction, end: usize) -> u32 {
    let ends = links[link as usize];
    match direction {
        Direction::Forward => ends[end],
        Direction::Backward => ends[1 - end],
    }
}

/// The ends of all links as (node, link), sorted.
struct Meeting(Vec<(u32, u32)>);

impl Meeting {
    fn of(links: &[[u32; 2]]) -> Self {
        let ends = (0_u32..).zip(links).flat_map(|(link, ends)| ends.map(|node| (node, link)));
        let mut ends: Vec<_> = ends.collect();
        ends.sort_unstable();
        Meeting(ends)
    }

    /// The link that goes on from another at a node where just these two meet.
    fn next(&self, node: u32, link: u32) -> Option<u32> {
        let first = self.0.partition_point(|&(other, _)| other < node);
        let mut here = self.0[first..].iter().take_while(|end| end.0 == node);
        let (one, other) = (here.next()?.1, here.next()?.1);
        if here.next().is_some() { None } else { Some(if one == link { other } else { one }) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn paths(links: &[[u32; 2]]) -> Vec<Vec<u32>> {
        let chains = Chains::of(links);
        let nodes = |path: &[(u32, Direction)]| {
            let starts = path.iter().map(|&(link, direction)| end_of(links, link, direction, 0));
            let last = path.last().map(|&(link, direction)| end_of(links, link, direction, 1));
            starts.chain(last).collect()
        };
        chains.iter().map(nodes).collect()
    }

    #[test]
    fn links_are_joined_to_open_and_closed_paths() {
        assert_eq!(paths(&[[2, 3], [1, 2], [3, 4]]), [[1, 2, 3, 4]]);
        assert_eq!(paths(&[[2, 3], [1, 2], [3, 1]]), [[2, 3, 1, 2]]);
        assert_eq!(paths(&[]), Vec::<Vec<u32>>::new());
    }

    #[test]
    fn paths_end_where_three_links_meet() {
        let found = paths(&[[0, 9], [9, 1], [1, 2], [9, 3]]);
        assert_eq!(found, [vec![0, 9], vec![9, 1, 2], vec![9, 3]]);
    }

    #[test]
    fn links_that_are_there_twice_and_loops_are_kept() {
        let found: usize =
            paths(&[[0, 1], [1, 0], [2, 2], [3, 4], [3, 4]]).iter().map(|path| path.len() - 1).sum();
        assert_eq!(found, 5);
    }
}
