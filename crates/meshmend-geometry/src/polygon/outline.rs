//! A polygon in a plane as a sweep from left to right meets it.

use meshmend_core::VertexId;
use robust::{Coord, orient2d};

use crate::sorting::merge_sort;

/// A polygon in a plane that runs round its inside anticlockwise, and may touch itself: several corners may stand at
/// one vertex, and a side may be run both ways (a *bridge* to a hole). Corners, and the sides that start at them, are
/// named after their places; vertices after their order from left to right, of those above each other from below.
pub(super) struct Outline {
    points: Vec<[f64; 2]>,
    /// The vertex of each corner.
    vertices: Vec<u32>,
    /// Where the edges that start at each vertex and run to the right begin, and one more.
    starts: Vec<u32>,
    edges: Vec<Edge>,
    /// Some corner of each vertex.
    corners: Vec<u32>,
}

/// One or two sides between the same two vertices.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    pub(super) left: u32,
    pub(super) right: u32,
    /// The side that runs to the right, and so has the inside above it.
    pub(super) rightward: Option<usize>,
    /// The side that runs to the left, and so has the inside below it.
    pub(super) leftward: Option<usize>,
}

impl Outline {
    /// `None` if two vertices are at one point, or a side is run twice the same way.
    ///
    /// *Cost*: O(n log n).
    pub(super) fn of(points: &[[f64; 2]], names: &[VertexId]) -> Option<Self> {
        let mut order: Vec<usize> = (0..points.len()).collect();
        order.sort_unstable_by(|&one, &other| {
            let ([x, y], [u, v]) = (points[one], points[other]);
            x.total_cmp(&u).then(y.total_cmp(&v)).then(names[one].cmp(&names[other]))
        });
        let mut outline = Outline {
            points: Vec::new(),
            vertices: vec![0; points.len()],
            starts: Vec::new(),
            edges: Vec::new(),
            corners: Vec::new(),
        };
        for run in order.chunk_by(|&one, &other| names[one] == names[other]) {
            let point = points[run[0]];
            let is_same = |other: [f64; 2]| point[0] == other[0] && point[1] == other[1];
            if outline.points.last().copied().is_some_and(is_same) {
                return None;
            }
            run.iter().for_each(|&corner| outline.vertices[corner] = outline.points.len() as u32);
            outline.points.push(point);
            outline.corners.push(run[0] as u32);
        }
        outline.join_sides()?;
        outline.sort_edges();
        Some(outline)
    }

    fn join_sides(&mut self) -> Option<()> {
        let count = self.vertices.len();
        let mut sides: Vec<(u32, u32, bool, usize)> = (0..count)
            .map(|side| {
                let (from, to) = (self.vertices[side], self.vertices[self.next(side)]);
                (from.min(to), from.max(to), from < to, side)
            })
            .collect();
        sides.sort_unstable();
        for run in sides.chunk_by(|one, other| (one.0, one.1) == (other.0, other.1)) {
            let (left, right, ..) = run[0];
            let side = |is_rightward| {
                let mut found = run.iter().filter(move |side| side.2 == is_rightward).map(|side| side.3);
                (found.next(), found.next())
            };
            let ((rightward, twice), (leftward, twice_too)) = (side(true), side(false));
            if left == right || twice.is_some() || twice_too.is_some() {
                return None;
            }
            self.edges.push(Edge { left, right, rightward, leftward });
        }
        Some(())
    }

    /// Brings the edges that start at each vertex into their order from below.
    fn sort_edges(&mut self) {
        let mut sorted = Vec::with_capacity(self.edges.len());
        let mut edges = std::mem::take(&mut self.edges).into_iter().peekable();
        for vertex in 0..self.points.len() as u32 {
            self.starts.push(sorted.len() as u32);
            let mut fan: Vec<Edge> = Vec::new();
            while let Some(edge) = edges.next_if(|edge| edge.left == vertex) {
                fan.push(edge);
            }
            merge_sort(&mut fan, |one, other| {
                0.0f64.total_cmp(&(self.turn([one.left, one.right, other.right]) + 0.0))
            });
            sorted.append(&mut fan);
        }
        self.starts.push(sorted.len() as u32);
        self.edges = sorted;
    }

    pub(super) fn vertex_count(&self) -> usize {
        self.points.len()
    }

    pub(super) fn edge_count(&self) -> usize {
        self.edges.len()
    }

    pub(super) fn edge(&self, edge: u32) -> Edge {
        self.edges[edge as usize]
    }

    /// The edges from a vertex to the right, from below.
    pub(super) fn rightward_edges(&self, vertex: u32) -> std::ops::Range<u32> {
        self.starts[vertex as usize]..self.starts[vertex as usize + 1]
    }

    pub(super) fn next(&self, corner: usize) -> usize {
        if corner + 1 == self.vertices.len() { 0 } else { corner + 1 }
    }

    /// Above zero where the way through the vertices of three corners turns left.
    pub(super) fn turn_at(&self, corners: [usize; 3]) -> f64 {
        self.turn(corners.map(|corner| self.vertices[corner]))
    }

    fn turn(&self, vertices: [u32; 3]) -> f64 {
        let [a, b, c] = vertices.map(|vertex| {
            let [x, y] = self.points[vertex as usize];
            Coord { x, y }
        });
        orient2d(a, b, c)
    }

    /// Whether an edge that reaches over a vertex runs below it. One that runs through it, without a corner there,
    /// lies on the side on which the polygon does not go on from the vertex.
    pub(super) fn is_below(&self, edge: Edge, vertex: u32) -> bool {
        let turn = self.turn([edge.left, edge.right, vertex]);
        if turn != 0.0 {
            return turn > 0.0;
        }
        let corner = self.corners[vertex as usize] as usize;
        let before = corner.checked_sub(1).unwrap_or(self.vertices.len() - 1);
        let beside = [before, self.next(corner)].map(|corner| self.vertices[corner]);
        let turns = beside.map(|other| self.turn([edge.left, edge.right, other]));
        turns.into_iter().find(|turn| *turn != 0.0).is_some_and(|turn| turn > 0.0)
    }
}
