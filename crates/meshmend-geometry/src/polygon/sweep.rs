//! Cuts a polygon in a plane into triangles in one sweep from left to right, whatever its shape.
//!
//! Between the edges that the sweep line crosses lie *strips*, inside the polygon or outside. Each strip inside has a
//! *chain*: the corners that it has passed and that may still get triangles, from its lower edge to its upper one. A
//! corner that comes cuts off all triangles that it can see, and becomes part of the chain.
//!
//! Several corners may stand at one vertex. Which of them a strip belongs to follows from the sides that bound it, so
//! the triangles lie between corners, and a polygon with bridges to its holes is cut like any other.
//!
//! *Source*: S. Hertel, K. Mehlhorn, *Fast triangulation of simple polygons*, 1983.

use meshmend_core::VertexId;

use super::corners::Triangle;
use super::outline::{Edge, Outline};
use super::sweep_chains::{Chain, Chains};
use super::sweep_line::SweepLine;

/// The triangles of a polygon in a plane that runs round its inside anticlockwise, each with its corners in the
/// polygon's order; corners of one name stand at one vertex. `None` if the polygon crosses itself.
///
/// *Cost*: O(n log n).
pub(super) fn by_sweep(points: &[[f64; 2]], names: &[VertexId]) -> Option<Vec<Triangle>> {
    let outline = Outline::of(points, names)?;
    let mut sweep = Sweep {
        outline: &outline,
        line: SweepLine::default(),
        strips: vec![None; outline.edge_count()],
        chains: Chains::of(&outline),
    };
    for vertex in 0..outline.vertex_count() as u32 {
        sweep.pass(vertex)?;
    }
    let triangles = sweep.chains.into_triangles();
    let are_in_order = triangles.iter().all(|[a, b, c]| a < b && b < c);
    (are_in_order && triangles.len() + 2 == points.len()).then_some(triangles)
}

struct Sweep<'a> {
    outline: &'a Outline,
    line: SweepLine,
    /// For each edge that the line crosses the chain of the strip above it, if that is inside.
    strips: Vec<Option<Chain>>,
    chains: Chains<'a>,
}

impl Sweep<'_> {
    /// Passes a vertex; `None` if the polygon turns out to cross itself.
    fn pass(&mut self, vertex: u32) -> Option<()> {
        let outline = self.outline;
        let ends_here = |edge: u32| outline.edge(edge).right == vertex;
        let place =
            self.line.place_above(|edge| !ends_here(edge) && outline.is_below(outline.edge(edge), vertex));
        let below = self.line.below(place);
        let ending: Vec<u32> = std::iter::from_fn(|| self.line.remove_above(place, ends_here)).collect();
        let starting = outline.rightward_edges(vertex);
        match (ending.first(), ending.last()) {
            (Some(&lowest), Some(&highest)) => {
                for pair in ending.windows(2) {
                    self.close(pair[0], outline.edge(pair[1]))?;
                }
                self.go_on(below, [lowest, highest], starting.clone())?;
            }
            _ => self.begin(below, starting.clone())?,
        }
        for (lower, upper) in starting.clone().zip(starting.clone().skip(1)) {
            if let Some(corner) = self.corner_between(outline.edge(lower), outline.edge(upper))? {
                self.strips[lower as usize] = Some(self.chains.single(corner));
            }
        }
        self.line.insert(place, starting);
        Some(())
    }

    /// The corner between two edges that start at one vertex, one above the other, if the inside is there; nothing if
    /// they contradict each other.
    fn corner_between(&self, lower: Edge, upper: Edge) -> Option<Option<usize>> {
        match (lower.rightward, upper.leftward) {
            (Some(leaving), Some(arriving)) => {
                (self.outline.next(arriving) == leaving).then_some(Some(leaving))
            }
            (None, None) => Some(None),
            _ => None,
        }
    }

    /// A vertex at which no edge ends: within a strip, which it parts, or outside.
    fn begin(&mut self, below: Option<u32>, starting: std::ops::Range<u32>) -> Option<()> {
        let outline = self.outline;
        let (lowest, highest) = (starting.clone().next()?, starting.last()?);
        let strip = below.filter(|&edge| outline.edge(edge).rightward.is_some());
        // Round the left of the vertex the inside lies from the highest edge on to the lowest one.
        let corner = self.corner_between(outline.edge(highest), outline.edge(lowest))?;
        match (strip, corner) {
            (Some(strip), Some(corner)) => {
                let chain = self.strips[strip as usize].take()?;
                let [lower, upper] = self.chains.part(chain, corner);
                self.strips[strip as usize] = Some(lower);
                self.strips[highest as usize] = Some(upper);
                Some(())
            }
            (None, None) => Some(()),
            _ => None,
        }
    }

    /// The strip between two edges that end at one vertex is done.
    fn close(&mut self, lower: u32, upper: Edge) -> Option<()> {
        let (arriving, leaving) = match (self.outline.edge(lower).rightward, upper.leftward) {
            (Some(arriving), Some(leaving)) => (arriving, leaving),
            (None, None) => return Some(()),
            _ => return None,
        };
        if self.outline.next(arriving) != leaving {
            return None;
        }
        let chain = self.strips[lower as usize].take()?;
        self.chains.close(chain, leaving);
        Some(())
    }

    /// The strips below and above the edges that end at a vertex go on along those that start there, or become one.
    fn go_on(
        &mut self,
        below: Option<u32>,
        [lowest, highest]: [u32; 2],
        mut starting: std::ops::Range<u32>,
    ) -> Option<()> {
        let outline = self.outline;
        let (first, last) = (starting.next(), starting.next_back());
        let last = last.or(first);
        let next = |side| outline.next(side);
        let lower = match outline.edge(lowest).leftward {
            Some(leaving) => {
                let strip = below.filter(|&edge| outline.edge(edge).rightward.is_some())?;
                let chain = self.strips[strip as usize].take()?;
                Some((strip, leaving, self.chains.push_high(chain, leaving)))
            }
            None => None,
        };
        let upper = match outline.edge(highest).rightward {
            Some(arriving) => {
                let chain = self.strips[highest as usize].take()?;
                Some((next(arriving), self.chains.push_low(chain, next(arriving))))
            }
            None => None,
        };
        let (Some(first), Some(last)) = (first, last) else {
            return match (lower, upper) {
                (Some((strip, leaving, lower)), Some((corner, upper))) if leaving == corner => {
                    self.strips[strip as usize] = Some(self.chains.join(lower, upper));
                    Some(())
                }
                (None, None) => Some(()),
                _ => None,
            };
        };
        match (lower, outline.edge(first).leftward) {
            (Some((strip, leaving, chain)), Some(arriving)) if next(arriving) == leaving => {
                self.strips[strip as usize] = Some(chain);
            }
            (None, None) => {}
            _ => return None,
        }
        match (upper, outline.edge(last).rightward) {
            (Some((corner, chain)), Some(leaving)) if corner == leaving => {
                self.strips[last as usize] = Some(chain);
            }
            (None, None) => {}
            _ => return None,
        }
        Some(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    type Flat = Vec<[f64; 2]>;

    fn cut(polygon: &[[f64; 2]]) -> Option<Vec<Triangle>> {
        let names: Vec<VertexId> = (0..polygon.len() as u32).map(VertexId).collect();
        by_sweep(polygon, &names)
    }

    fn area(polygon: &[[f64; 2]]) -> f64 {
        let twice = |i: usize| {
            let ([x, y], [u, v]) = (polygon[i], polygon[(i + 1) % polygon.len()]);
            x * v - u * y
        };
        (0..polygon.len()).map(twice).sum::<f64>() / 2.0
    }

    /// No triangle lies the wrong way round, and together they have the polygon's area.
    #[track_caller]
    fn assert_cut(polygon: Flat) {
        let triangles = cut(&polygon).unwrap_or_else(|| panic!("{:?} …", &polygon[..polygon.len().min(10)]));
        assert_eq!(triangles.len(), polygon.len() - 2);
        let areas: Vec<f64> = triangles.iter().map(|corners| area(&corners.map(|i| polygon[i]))).collect();
        let whole = area(&polygon);
        let folded = triangles.iter().zip(&areas).find(|(_, area)| **area < -1e-9 * whole);
        assert_eq!(folded, None, "of {:?} …", &polygon[..polygon.len().min(10)]);
        assert!((areas.iter().sum::<f64>() - whole).abs() <= 1e-9 * whole);
    }

    #[test]
    fn polygons_of_extreme_shape_are_cut() {
        let turned = |polygon: Flat| polygon.into_iter().map(|[x, y]| [-y, x]).collect::<Flat>();
        let comb: Flat = (0..500)
            .flat_map(|i| [[f64::from(i), 0.0], [f64::from(i) + 0.5, 1e4]])
            .chain([[500.0, -1.0], [0.0, -1.0]])
            .rev()
            .collect();
        let arm = |far: f64| move |i: u32| [f64::from(i) * 0.1, f64::from(i) + far];
        let round = |[turn, far]: [f64; 2]| [far * turn.cos(), far * turn.sin()];
        let spiral: Flat =
            (0..500).map(arm(10.0)).chain((0..500).rev().map(arm(9.8))).map(round).rev().collect();
        let spiral = if area(&spiral) < 0.0 { spiral.into_iter().rev().collect() } else { spiral };
        let stairs: Flat = (0..300)
            .flat_map(|i| [[f64::from(i), f64::from(i)], [f64::from(i + 1), f64::from(i)]])
            .chain([[300.0, 300.0], [-1.0, 300.0]])
            .collect();
        for polygon in [comb, spiral, stairs] {
            assert_cut(turned(polygon.clone()));
            assert_cut(polygon);
        }
    }

    /// A side that falls from the left passes under one that begins lower, further on. Between them is a gap, and
    /// above both a corner that belongs to the nearer one.
    #[test]
    fn sides_are_compared_where_both_are() {
        let polygon = [
            [0.0, 10.0],
            [30.0, -50.0],
            [30.0, -45.0],
            [15.0, -12.0],
            [10.0, -1.0],
            [28.0, 0.0],
            [28.0, 5.0],
            [18.0, 6.0],
            [28.0, 8.0],
            [28.0, 20.0],
        ];
        for far in [0.0, 1000.0, -1000.0] {
            assert_cut(polygon.iter().map(|&[x, y]| [x + far, y]).collect());
        }
    }

    /// Whether two sides have no point in common but an end that is one corner.
    fn are_apart(polygon: &[[f64; 2]], one: usize, other: usize) -> bool {
        let count = polygon.len();
        let [a, b, c, d] = [one, (one + 1) % count, other, (other + 1) % count].map(|i| polygon[i]);
        let turn = |[a, b, c]: [[f64; 2]; 3]| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        if b == c {
            return turn([a, b, d]) != 0.0;
        }
        if d == a {
            return turn([c, d, b]) != 0.0;
        }
        let is_on_one_side = |ends: [[f64; 2]; 2], others: [[f64; 2]; 2]| {
            let turns = others.map(|point| turn([ends[0], ends[1], point]));
            turns[0] * turns[1] > 0.0
        };
        let collinear = [c, d].iter().all(|&point| turn([a, b, point]) == 0.0);
        let reaches = |i: usize| a[i].max(b[i]) < c[i].min(d[i]) || c[i].max(d[i]) < a[i].min(b[i]);
        is_on_one_side([a, b], [c, d])
            || is_on_one_side([c, d], [a, b])
            || collinear && (reaches(0) || reaches(1))
    }

    #[test]
    fn every_small_simple_polygon_is_cut() {
        let mut state = 1u64;
        let mut random = |below: u64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) % below
        };
        let mut count = 0;
        for _ in 0..200_000 {
            let corners = 4 + random(6);
            let mut polygon: Flat = (0..corners).map(|_| [random(5) as f64, random(5) as f64]).collect();
            let pairs = (0..polygon.len()).flat_map(|i| (0..i).map(move |j| (j, i)));
            if !pairs.clone().all(|(j, i)| are_apart(&polygon, j, i)) {
                continue;
            }
            if area(&polygon) < 0.0 {
                polygon.reverse();
            }
            assert_cut(polygon);
            count += 1;
        }
        assert!(count > 1000, "{count} polygons are simple");
    }

    #[test]
    fn whatever_crosses_itself_gives_nothing() {
        for count in [5, 50, 5000] {
            let part = |i: usize, root: f64| (i as f64 * root).fract();
            let points: Flat = (0..count).map(|i| [part(i, 2.0f64.sqrt()), part(i, 3.0f64.sqrt())]).collect();
            assert_eq!(cut(&points), None);
        }
        for point in [0.0, 1e300, f64::MIN_POSITIVE] {
            assert_eq!(cut(&vec![[point; 2]; 100]), None);
        }
    }

    #[test]
    fn one_or_two_corners_are_no_polygon() {
        for count in [1, 2] {
            assert_eq!(cut(&vec![[1.0; 2]; count]), None);
        }
    }

    /// A square with rows of holes: from the left side of the square a bridge leads to the first hole of each row,
    /// and from each hole one to the next.
    fn perforated(rows: u32, columns: u32) -> (Flat, Vec<VertexId>) {
        let (mut polygon, mut names): (Flat, Vec<VertexId>) = (Vec::new(), Vec::new());
        let mut corner = |x: f64, y: f64| {
            let name = (x * 4.0) as u32 * 100_000 + (y * 4.0) as u32;
            polygon.push([x, y]);
            names.push(VertexId(name));
        };
        let (right, top) = (f64::from(columns) + 1.0, f64::from(rows) + 1.0);
        for [x, y] in [[0.0, 0.0], [right, 0.0], [right, top], [0.0, top]] {
            corner(x, y);
        }
        for y in (0..rows).rev().map(|row| f64::from(row) + 1.0) {
            corner(0.0, y);
            for x in (0..columns).map(|column| f64::from(column) + 1.0) {
                corner(x - 0.25, y);
                corner(x, y + 0.25);
                corner(x + 0.25, y);
            }
            for x in (0..columns).rev().map(|column| f64::from(column) + 1.0) {
                if x < f64::from(columns) {
                    corner(x + 0.25, y);
                }
                corner(x, y - 0.25);
                corner(x - 0.25, y);
            }
            corner(0.0, y);
        }
        (polygon, names)
    }

    #[test]
    fn holes_that_hang_on_bridges_stay_open() {
        for [rows, columns] in [[1, 1], [1, 5], [3, 1], [7, 4], [40, 50]] {
            let (mut polygon, names) = perforated(rows, columns);
            for _ in 0..4 {
                polygon = polygon.into_iter().map(|[x, y]| [-y, x]).collect();
                let triangles = by_sweep(&polygon, &names).unwrap();
                let areas = triangles.iter().map(|corners| area(&corners.map(|i| polygon[i])));
                assert!(areas.clone().all(|area| area > 0.0));
                let open = f64::from((rows + 1) * (columns + 1)) - 0.125 * f64::from(rows * columns);
                assert!((areas.sum::<f64>() - open).abs() < 1e-9 * open);
            }
        }
    }
}
