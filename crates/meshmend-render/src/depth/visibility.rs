//! Which parts of a path are seen, and which are behind faces.

use crate::depth::buffer::{DepthBuffer, NOTHING};
use crate::vector::{Vector, add, scaled, subtract};

/// Paths in the panel's pixels, as one list of points.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Polylines {
    points: Vec<[f64; 2]>,
    ends: Vec<usize>,
}

impl Polylines {
    /// The points of each path.
    pub(crate) fn iter(&self) -> impl Iterator<Item = &[[f64; 2]]> + Clone {
        let starts = std::iter::once(0).chain(self.ends.iter().copied());
        starts.zip(&self.ends).map(|(start, &end)| &self.points[start..end])
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// Adds a point to the path that is being made.
    pub(crate) fn push(&mut self, point: [f64; 2]) {
        self.points.push(point);
    }

    /// Ends the path that is being made.
    pub(crate) fn end(&mut self) {
        self.ends.push(self.points.len());
    }

    /// The same paths moved.
    pub(crate) fn moved(&self, by: [f64; 2]) -> Self {
        let points = self.points.iter().map(|point| [point[0] + by[0], point[1] + by[1]]);
        Polylines { points: points.collect(), ends: self.ends.clone() }
    }

    /// The longest path, the first of equal ones.
    pub(crate) fn longest(&self) -> &[[f64; 2]] {
        let mut longest: (f64, &[[f64; 2]]) = (0.0, &[]);
        for path in self.iter() {
            let length = length_of(path);
            if length > longest.0 {
                longest = (length, path);
            }
        }
        longest.1
    }
}

/// Paths, cut into what is seen and what is hidden.
#[derive(Clone, Debug)]
pub(crate) struct Sighted {
    pub(crate) seen: Polylines,
    pub(crate) hidden: Polylines,
    /// How often the paths are looked at, in pixels.
    step: f64,
}

/// A path is looked at this often, in pixels.
const STEP: f64 = 0.5;

/// All paths together are not looked at more often than this, apart from once for each of their pieces: where there is
/// so much of lines, single ones are not told apart.
const MOST_LOOKS: f64 = 4e6;

/// What shows or vanishes for less than this, in pixels, does not.
const SHORTEST: f64 = 2.0;

/// However long a piece of a path is, it is looked at no more often than this.
const MOST_STEPS: f64 = 65536.0;

/// A stretch of a path that is seen or hidden as a whole.
struct Stretch {
    is_seen: bool,
    length: f64,
    /// Its points but for the first one, which is the last one of the stretch before.
    points: Vec<[f64; 2]>,
}

impl Default for Sighted {
    fn default() -> Self {
        Sighted::of_length(0.0)
    }
}

impl Sighted {
    /// No paths yet, of those that are so long in all, in pixels.
    pub(crate) fn of_length(length: f64) -> Self {
        let step = STEP.max(length / MOST_LOOKS);
        Sighted { seen: Polylines::default(), hidden: Polylines::default(), step }
    }

    /// Cuts a path in the panel's pixels where it goes behind faces and where it comes out again.
    ///
    /// *Cost*: the path's length in pixels, and its points.
    pub(crate) fn add(&mut self, buffer: &DepthBuffer, path: &[Vector]) {
        self.add_on(buffer, path, &[]);
    }

    /// The same for a path each piece of which runs on a face, which does not hide it though it need not be plane.
    pub(crate) fn add_on(&mut self, buffer: &DepthBuffer, path: &[Vector], faces: &[u32]) {
        let Some(first) = path.first() else { return };
        let mut last = flat(*first);
        for stretch in stretches(buffer, path, faces, self.step) {
            let side = if stretch.is_seen { &mut self.seen } else { &mut self.hidden };
            side.push(last);
            stretch.points.iter().for_each(|&point| side.push(point));
            side.end();
            last = stretch.points.last().copied().unwrap_or(last);
        }
    }
}

fn stretches(buffer: &DepthBuffer, path: &[Vector], faces: &[u32], step: f64) -> Vec<Stretch> {
    let mut found: Vec<Stretch> = Vec::new();
    let faces = faces.iter().copied().chain(std::iter::repeat(NOTHING));
    for (pair, face) in path.windows(2).zip(faces) {
        let (from, way) = (pair[0], subtract(pair[1], pair[0]));
        let length = way[0].hypot(way[1]);
        let steps = (length / step).ceil().clamp(1.0, MOST_STEPS);
        for done in 0..steps as usize {
            let at = |part: f64| add(from, scaled(way, (done as f64 + part) / steps));
            let (is_seen, end) = (buffer.is_seen_on(face, at(0.5)), flat(at(1.0)));
            match found.last_mut() {
                Some(last) if last.is_seen == is_seen => {
                    last.length += length / steps;
                    // Along a straight line the end moves on.
                    if done > 0 {
                        last.points.pop();
                    }
                    last.points.push(end);
                }
                _ => found.push(Stretch { is_seen, length: length / steps, points: vec![end] }),
            }
        }
    }
    without_short_ones(found)
}

/// Joins what is too short to be noticed to what comes before it, or at the beginning to what comes after.
fn without_short_ones(stretches: Vec<Stretch>) -> Vec<Stretch> {
    let mut kept: Vec<Stretch> = Vec::new();
    for stretch in stretches {
        let begins_short = kept.len() == 1 && kept[0].length < SHORTEST;
        match kept.last_mut() {
            Some(last) if last.is_seen == stretch.is_seen || stretch.length < SHORTEST || begins_short => {
                if begins_short {
                    last.is_seen = stretch.is_seen;
                }
                last.length += stretch.length;
                last.points.extend(stretch.points);
            }
            _ => kept.push(stretch),
        }
    }
    kept
}

fn flat(point: Vector) -> [f64; 2] {
    [point[0], point[1]]
}

/// How far it is from one point to the next.
pub(crate) fn step_length(pair: &[[f64; 2]]) -> f64 {
    (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1])
}

/// How long paths are in the panel, all together.
pub(crate) fn length_in_panel<'a>(paths: impl Iterator<Item = &'a [Vector]>) -> f64 {
    let step = |pair: &[Vector]| step_length(&[flat(pair[0]), flat(pair[1])]);
    paths.flat_map(|path| path.windows(2)).map(step).filter(|length| length.is_finite()).sum()
}

fn length_of(path: &[[f64; 2]]) -> f64 {
    path.windows(2).map(step_length).sum()
}

/// Places along a path at about equal distances, with the direction of the path there; at least one.
pub(crate) fn places_every(path: &[[f64; 2]], spacing: f64) -> Vec<([f64; 2], [f64; 2])> {
    places_along(path, (length_of(path) / spacing).floor().max(1.0) as usize)
}

/// The middles of so many equal parts of a path, with the direction of the path there.
pub(crate) fn places_along(path: &[[f64; 2]], count: usize) -> Vec<([f64; 2], [f64; 2])> {
    let gap = length_of(path) / count as f64;
    let (mut places, mut walked) = (Vec::new(), 0.0);
    for pair in path.windows(2) {
        let length = step_length(pair);
        let way = [0, 1].map(|axis| (pair[1][axis] - pair[0][axis]) / length);
        let next = |places: &Vec<_>| (places.len() as f64 + 0.5) * gap - walked;
        while length > 0.0 && places.len() < count && next(&places) < length {
            let rest = next(&places);
            places.push(([0, 1].map(|axis| pair[0][axis] + rest * way[axis]), way));
        }
        walked += length;
    }
    places
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A panel whose right half is covered.
    fn half_covered() -> DepthBuffer {
        let mut buffer = DepthBuffer::new(20, 10, 2);
        buffer.paint(0, &[[10.0, 0.0, 0.0], [20.0, 0.0, 0.0], [20.0, 10.0, 0.0], [10.0, 10.0, 0.0]]);
        buffer
    }

    fn cut(path: &[Vector]) -> Sighted {
        let mut sighted = Sighted::default();
        sighted.add(&half_covered(), path);
        sighted
    }

    #[test]
    fn a_path_is_cut_where_it_goes_behind_a_face() {
        let sighted = cut(&[[2.0, 5.0, -1.0], [18.0, 5.0, -1.0]]);
        let (seen, hidden): (Vec<_>, Vec<_>) =
            (sighted.seen.iter().collect(), sighted.hidden.iter().collect());
        assert_eq!((seen.len(), hidden.len()), (1, 1));
        assert!((seen[0][1][0] - 10.0).abs() <= 1.0 && seen[0][1] == hidden[0][0]);
        assert_eq!((seen[0][0], hidden[0][1]), ([2.0, 5.0], [18.0, 5.0]));
    }

    #[test]
    fn a_path_in_front_is_seen_whole_and_keeps_its_corners() {
        let sighted = cut(&[[2.0, 5.0, 1.0], [15.0, 5.0, 1.0], [15.0, 8.0, 1.0]]);
        assert!(sighted.hidden.is_empty());
        assert_eq!(sighted.seen.iter().collect::<Vec<_>>(), [[[2.0, 5.0], [15.0, 5.0], [15.0, 8.0]]]);
    }

    #[test]
    fn what_vanishes_for_less_than_is_noticed_does_not() {
        let sighted = cut(&[[2.0, 5.0, -1.0], [11.0, 5.0, -1.0], [2.0, 8.0, -1.0]]);
        assert!(sighted.hidden.is_empty());
        assert_eq!(sighted.seen.iter().count(), 1);
        let begins_hidden = cut(&[[11.0, 5.0, -1.0], [2.0, 5.0, -1.0]]);
        assert!(begins_hidden.hidden.is_empty());
    }

    #[test]
    fn a_face_does_not_hide_what_runs_on_it() {
        let path = [[12.0, 5.0, -0.5], [18.0, 5.0, -0.5]];
        let mut sighted = Sighted::default();
        sighted.add_on(&half_covered(), &path, &[0]);
        assert!(sighted.hidden.is_empty());
        sighted.add_on(&half_covered(), &path, &[1]);
        assert!(!sighted.hidden.is_empty());
    }

    #[test]
    fn paths_of_one_point_or_of_none_give_nothing() {
        for path in [&[][..], &[[1.0, 1.0, 0.0]]] {
            let sighted = cut(path);
            assert!(sighted.seen.is_empty() && sighted.hidden.is_empty());
        }
        let still = cut(&[[1.0, 1.0, 0.0], [1.0, 1.0, 0.0]]);
        assert_eq!(still.seen.iter().count(), 1);
    }

    #[test]
    fn the_longest_path_is_found() {
        let mut lines = Polylines::default();
        let paths = [&[[0.0, 0.0], [1.0, 0.0]][..], &[[5.0, 0.0], [9.0, 0.0], [9.0, 6.0]]];
        for path in paths {
            path.iter().for_each(|&point| lines.push(point));
            lines.end();
        }
        assert_eq!(lines.longest(), paths[1]);
        assert!(Polylines::default().longest().is_empty());
    }

    #[test]
    fn places_are_spread_evenly_along_a_path() {
        let places = places_every(&[[0.0, 0.0], [6.0, 0.0], [6.0, 6.0]], 4.0);
        let expected = [([2.0, 0.0], [1.0, 0.0]), ([6.0, 0.0], [0.0, 1.0]), ([6.0, 4.0], [0.0, 1.0])];
        assert_eq!(places, expected);
        assert_eq!(places_every(&[[0.0, 0.0], [1.0, 0.0]], 4.0), [([0.5, 0.0], [1.0, 0.0])]);
        assert!(places_every(&[[3.0, 3.0]], 4.0).is_empty());
    }
}
