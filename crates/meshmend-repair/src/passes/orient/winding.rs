//! How many closed shells wind round each of many points.
//!
//! The points are parted again and again, so that those of one part lie close together. Each part has a place among its
//! points, a winding of each shell round that place, and a list of the triangles that come near the points. On the way to
//! the place of a smaller part a winding changes only where a triangle of the list is crossed. A shell without a triangle
//! in the list winds as often round all points of the part. From there on it is only counted.

use std::ops::Range;

use super::crossing::{Triangle, crossing, is_on};
use meshmend_geometry::vector::{Point, cross, dot, length, minus};

/// A closed surface.
pub(super) struct Shell {
    triangles: Vec<Triangle>,
    bounds: Bounds,
}

/// A point, and the shell on which it lies. That shell is left out of the answer.
#[derive(Clone, Copy, Debug)]
pub(super) struct Query {
    pub(super) point: Point,
    pub(super) own: Option<u32>,
}

/// What is known of a point.
#[derive(Clone, Debug, Default)]
pub(super) struct Answer {
    /// How many shells wind round it.
    pub(super) inside: usize,
    /// The shells on which it lies, in order. They are not counted.
    pub(super) touching: Vec<u32>,
    /// Whether its own shell is among those that wind round its part from afar. It is not counted either.
    own_is_around: bool,
}

/// A point may be on a triangle if it is nearer to it than this, in parts of the triangle's size.
const CLOSE: f64 = 1e-8;

/// How much coordinates may be off, in parts of the largest.
const ROUNDING: f64 = 1e-14;

/// Volumes of coordinates beyond this may not be finite.
const LARGEST: f64 = 1e100;

/// If fewer triangles than this come near some points, each point is compared with all of them.
const FEW_TRIANGLES: usize = 24;

impl Shell {
    pub(super) fn of(triangles: Vec<Triangle>) -> Self {
        let bounds = Bounds::of(triangles.iter().flatten().copied());
        Shell { triangles, bounds }
    }

    /// Whether its volume can be computed. If not, no point counts as inside.
    fn is_sound(&self) -> bool {
        let is_small = |x: &f64| x.abs() <= LARGEST;
        self.triangles.iter().flatten().flatten().all(is_small)
    }
}

/// A box along the axes.
#[derive(Clone, Copy, Debug)]
struct Bounds {
    low: Point,
    high: Point,
}

impl Bounds {
    fn of(points: impl Iterator<Item = Point>) -> Self {
        let empty = Bounds { low: [f64::INFINITY; 3], high: [f64::NEG_INFINITY; 3] };
        points.fold(empty, |bounds, point| Bounds {
            low: std::array::from_fn(|i| bounds.low[i].min(point[i])),
            high: std::array::from_fn(|i| bounds.high[i].max(point[i])),
        })
    }

    fn holds(&self, point: Point) -> bool {
        (0..3).all(|i| self.low[i] <= point[i] && point[i] <= self.high[i])
    }

    fn middle(&self) -> Point {
        std::array::from_fn(|i| self.low[i] + (self.high[i] - self.low[i]) / 2.0)
    }

    /// The axis along which it is longest, and how long it is there.
    fn longest(&self) -> (usize, f64) {
        let length = |i: usize| self.high[i] - self.low[i];
        (1..3).fold((0, length(0)), |best, i| if length(i) > best.1 { (i, length(i)) } else { best })
    }

    /// Whether a triangle may come near the box. It does not if the shadows of both on some line lie apart: a line along
    /// an axis, along the triangle's normal, or across one of its sides and an axis.
    fn is_near(&self, triangle: &Triangle) -> bool {
        let own = Bounds::of(triangle.iter().copied());
        let middle = self.middle();
        let largest = (0..3).map(|i| middle[i].abs().max(own.low[i].abs()).max(own.high[i].abs()));
        let close = CLOSE * own.longest().1 + ROUNDING * largest.fold(0.0, f64::max);
        let is_beside = |i: usize| own.low[i] - close > self.high[i] || own.high[i] + close < self.low[i];
        if (0..3).any(is_beside) {
            return false;
        }
        let corners = triangle.map(|corner| minus(corner, middle));
        let half: Point = std::array::from_fn(|i| (self.high[i] - self.low[i]) / 2.0);
        let is_apart = |line: Point| {
            let shadow = corners.map(|corner| dot(line, corner));
            let reach: f64 = (0..3).map(|i| line[i].abs() * half[i]).sum();
            let most = 1.000_001 * (reach + length(line) * close);
            // Comparisons with NaN are false, so it is never apart.
            shadow.iter().all(|&at| at > most) || shadow.iter().all(|&at| at < -most)
        };
        let sides: [Point; 3] = std::array::from_fn(|i| minus(corners[(i + 1) % 3], corners[i]));
        if is_apart(cross(sides[0], sides[1])) {
            return false;
        }
        // A triangle smaller than the box is rarely told apart by the other lines.
        let unit = |axis: usize| std::array::from_fn(|i| f64::from(u8::from(i == axis)));
        let across = |side: Point| (0..3).map(move |axis| cross(side, unit(axis)));
        own.longest().1 <= self.longest().1 || !sides.into_iter().flat_map(across).any(is_apart)
    }
}

/// A shell in a part: how often it winds round the part's place, and how many triangles of the list it has.
#[derive(Clone, Copy, Debug)]
struct Near {
    shell: u32,
    winding: i32,
    triangles: usize,
}

/// What is known about the place of some points.
#[derive(Clone)]
struct Part {
    bounds: Bounds,
    place: Point,
    /// How many of the shells that are not near wind round all of the points.
    around: usize,
    /// Which of the search's shells are near.
    near: Range<usize>,
    /// Which of the search's triangles are near: those of the shells, shell by shell.
    triangles: Range<usize>,
}

/// The search.
pub(super) struct Windings<'a> {
    shells: &'a [&'a Shell],
    queries: &'a [Query],
    answers: Vec<Answer>,
    /// The shells near the part in hand, after those near the parts that contain it.
    near: Vec<Near>,
    /// Their triangles, in the same order.
    triangles: Vec<&'a Triangle>,
    /// Which query lies on a shell.
    query_on: Vec<Option<u32>>,
    /// The part that a query was in last.
    part_of: Vec<u32>,
    parts: u32,
}

impl<'a> Windings<'a> {
    /// How many shells wind round each point.
    ///
    /// A point that is not finite is inside of no shell, and no point is inside of a shell with such a corner.
    pub(super) fn of(shells: &'a [&'a Shell], queries: &'a [Query]) -> Vec<Answer> {
        let mut query_on = vec![None; shells.len()];
        for (place, query) in queries.iter().enumerate() {
            if let Some(own) = query.own {
                query_on[own as usize] = Some(place as u32);
            }
        }
        let mut search = Windings {
            shells,
            queries,
            answers: vec![Answer::default(); queries.len()],
            near: Vec::new(),
            triangles: Vec::new(),
            query_on,
            part_of: vec![0; queries.len()],
            parts: 0,
        };
        let is_small = |query: &Query| query.point.iter().all(|x| x.abs() <= LARGEST);
        let mut places: Vec<u32> = (0..queries.len() as u32).collect();
        places.retain(|&place| is_small(&queries[place as usize]));
        if !places.is_empty() {
            let whole = search.whole(&places);
            search.part(&mut places, &whole);
        }
        search.answers
    }

    fn bounds(&self, places: &[u32]) -> Bounds {
        Bounds::of(places.iter().map(|&place| self.queries[place as usize].point))
    }

    /// A part of some points, before the triangles near it are listed.
    fn begin(&mut self, places: &[u32], around: usize) -> Part {
        let bounds = self.bounds(places);
        self.parts += 1;
        places.iter().for_each(|&query| self.part_of[query as usize] = self.parts);
        let (near, triangles) = (self.near.len(), self.triangles.len());
        Part { bounds, place: bounds.middle(), around, near: near..near, triangles: triangles..triangles }
    }

    /// All points, with all shells.
    fn whole(&mut self, places: &[u32]) -> Part {
        let mut whole = self.begin(places, 0);
        let place = whole.place;
        let shells = self.shells;
        // If shells lie apart, the lists of all smaller parts together are about as long again.
        self.triangles.reserve(2 * shells.iter().map(|shell| shell.triangles.len()).sum::<usize>());
        for (number, shell) in shells.iter().enumerate().filter(|(_, shell)| shell.is_sound()) {
            // From outside of the shell to the place.
            let outside = shell.bounds.high[0].max(place[0]) + 1.0 + shell.bounds.longest().1;
            let crossings = shell.triangles.iter().map(|triangle| crossing(triangle, place, 0, outside));
            let winding = if shell.bounds.holds(place) { -crossings.sum::<i32>() } else { 0 };
            let near = shell.triangles.iter().filter(|triangle| whole.bounds.is_near(triangle));
            self.triangles.extend(near);
            self.keep(&mut whole, number as u32, winding);
        }
        whole
    }

    /// Ends the list of a shell's triangles. A shell without one near is only counted, if it winds round the part.
    fn keep(&mut self, part: &mut Part, shell: u32, winding: i32) {
        let triangles = self.triangles.len() - part.triangles.end;
        part.triangles.end = self.triangles.len();
        if triangles > 0 {
            self.near.push(Near { shell, winding, triangles });
            part.near.end = self.near.len();
        } else if winding != 0 {
            part.around += 1;
            // The corners of a face that is not plane may be far from its middle.
            let own = self.query_on[shell as usize];
            if let Some(own) = own.filter(|&own| self.part_of[own as usize] == self.parts) {
                self.answers[own as usize].own_is_around = true;
            }
        }
    }

    /// Answers for points by parting them.
    fn part(&mut self, places: &mut [u32], part: &Part) {
        let (axis, length) = part.bounds.longest();
        if places.len() == 1 || part.triangles.len() <= FEW_TRIANGLES || length == 0.0 {
            places.iter().for_each(|&place| self.answer(place, part));
            return;
        }
        let along = |place: u32| self.queries[place as usize].point[axis];
        let middle = places.len() / 2;
        places.select_nth_unstable_by(middle, |&one, &other| {
            along(one).total_cmp(&along(other)).then(one.cmp(&other))
        });
        let (before, after) = places.split_at_mut(middle);
        for half in [before, after] {
            let smaller = self.narrowed(part, half);
            self.part(half, &smaller);
            self.near.truncate(part.near.end);
            self.triangles.truncate(part.triangles.end);
        }
    }

    /// What is known about the place of some of a part's points.
    fn narrowed(&mut self, part: &Part, places: &[u32]) -> Part {
        let mut smaller = self.begin(places, part.around);
        let mut first = part.triangles.start;
        for at in part.near.clone() {
            let Near { shell, winding, triangles } = self.near[at];
            let own = first..first + triangles;
            first = own.end;
            let winding = winding + change(&self.triangles[own.clone()], part.place, smaller.place);
            for at in own {
                let triangle = self.triangles[at];
                if smaller.bounds.is_near(triangle) {
                    self.triangles.push(triangle);
                }
            }
            self.keep(&mut smaller, shell, winding);
        }
        smaller
    }

    /// Answers for one point.
    fn answer(&mut self, place: u32, part: &Part) {
        let Query { point, own } = self.queries[place as usize];
        let answer = &mut self.answers[place as usize];
        answer.inside = part.around - usize::from(answer.own_is_around);
        let mut rest = &self.triangles[part.triangles.clone()];
        for near in &self.near[part.near.clone()] {
            let (triangles, others) = rest.split_at(near.triangles);
            rest = others;
            if own == Some(near.shell) || !self.shells[near.shell as usize].bounds.holds(point) {
                continue;
            }
            if triangles.iter().any(|triangle| is_on(triangle, point)) {
                answer.touching.push(near.shell);
            } else {
                answer.inside += usize::from(near.winding + change(triangles, part.place, point) != 0);
            }
        }
    }
}

/// How the winding of a shell changes from one place to another, if only these of its triangles may lie between them.
fn change(triangles: &[&Triangle], from: Point, to: Point) -> i32 {
    let mut change = 0;
    let mut at = from;
    for axis in 0..3 {
        if at[axis] != to[axis] {
            change += triangles.iter().map(|triangle| crossing(triangle, at, axis, to[axis])).sum::<i32>();
            at[axis] = to[axis];
        }
    }
    change
}
