//! Which sides of other edges run along a part of an edge, by position.

use meshmend_core::{EdgeId, Id, VertexId};
use meshmend_geometry::vector::{Point, is_finite};

use super::chains::Piece;
use crate::boxes::{Bounds, BoxTree};
use crate::exact::{Sign, compare_along};
use crate::t_junctions::{Boundary, PointTree, is_on};

/// All vertices and all edges of the faces, by where they are.
pub(super) struct Crowd {
    vertices: Vec<VertexId>,
    points: PointTree,
    /// The edges at each end, ascending.
    at: Vec<(VertexId, EdgeId)>,
    /// The edges whose ends are finite.
    edges: Vec<EdgeId>,
    boxes: BoxTree,
    within: f64,
}

/// A part of an edge along which so many sides run, between the feet of two points, the first one first.
struct Span {
    from: Point,
    to: Point,
    sides: usize,
}

impl Crowd {
    /// *Cost*: O(n log n) for all edges of the mesh.
    pub(super) fn of(positions: &[Point], boundary: &Boundary, within: f64) -> Self {
        let table = boundary.table();
        let finite = |&edge: &EdgeId| table.ends(edge).iter().all(|end| is_finite(&positions[end.index()]));
        let edges: Vec<EdgeId> = table.edges().filter(finite).collect();
        let mut at: Vec<(VertexId, EdgeId)> =
            edges.iter().flat_map(|&edge| table.ends(edge).map(|end| (end, edge))).collect();
        at.sort_unstable();
        let mut vertices: Vec<VertexId> = at.iter().map(|&(vertex, _)| vertex).collect();
        vertices.dedup();
        let points = PointTree::of(vertices.iter().map(|vertex| positions[vertex.index()]));
        let bounds = |item: usize| {
            let bounds = Bounds::of(table.ends(edges[item]).map(|end| positions[end.index()]));
            Bounds {
                low: bounds.low.map(|x| (x - within).next_down()),
                high: bounds.high.map(|x| (x + within).next_up()),
            }
        };
        let boxes = BoxTree::over(edges.len(), bounds);
        Crowd { vertices, points, at, edges, boxes, within }
    }

    /// Whether along some part of a piece of a boundary edge two or more sides of other edges run.
    pub(super) fn runs_along(
        &self,
        positions: &[Point],
        boundary: &Boundary,
        edge: u32,
        piece: Piece,
    ) -> bool {
        let ends = boundary.edges()[edge as usize].ends;
        let line = ends.map(|end| positions[end.index()]);
        let comes_before = |one: Point, other: Point| compare_along(line, one, other) == Sign::Negative;
        let [mut low, mut high] = piece.map(|end| positions[end.index()]);
        if comes_before(high, low) {
            (low, high) = (high, low);
        }
        let spans = self.spans(positions, boundary, ends);
        let borders = spans.iter().flat_map(|span| [span.from, span.to]);
        let inner = borders.filter(|&border| comes_before(low, border) && comes_before(border, high));
        // Where the number of sides may grow: at the beginning of the piece, and at each border in it.
        let mut starts = std::iter::once(low).chain(inner);
        starts.any(|start| {
            let covers = |span: &&Span| !comes_before(start, span.from) && comes_before(start, span.to);
            spans.iter().filter(covers).map(|span| span.sides).sum::<usize>() > 1
        })
    }

    /// The parts of an edge along which other edges run.
    fn spans(&self, positions: &[Point], boundary: &Boundary, ends: [VertexId; 2]) -> Vec<Span> {
        let table = boundary.table();
        let line = ends.map(|end| positions[end.index()]);
        let lies =
            |vertex: VertexId| ends.contains(&vertex) || is_on(positions[vertex.index()], line, self.within);
        let span = |other: EdgeId| {
            let others = table.ends(other);
            let other_line = others.map(|end| positions[end.index()]);
            let on_this = others.into_iter().filter(|&end| lies(end));
            let on_other = ends.into_iter().filter(|&end| {
                !others.contains(&end) && is_on(positions[end.index()], other_line, self.within)
            });
            let places: Vec<Point> = on_this.chain(on_other).map(|end| positions[end.index()]).collect();
            let order = |one: &Point, other: &Point| match compare_along(line, *one, *other) {
                Sign::Negative => std::cmp::Ordering::Less,
                Sign::Zero => std::cmp::Ordering::Equal,
                Sign::Positive => std::cmp::Ordering::Greater,
            };
            let from = places.iter().copied().min_by(order)?;
            let to = places.iter().copied().max_by(order)?;
            let sides = table.edge_sides(other).len();
            (order(&from, &to) == std::cmp::Ordering::Less).then_some(Span { from, to, sides })
        };
        self.near(positions, line, ends)
            .into_iter()
            .filter(|&other| table.ends(other) != sorted(ends))
            .filter_map(span)
            .collect()
    }

    /// The edges that may run along an edge: those at vertices on it, and those on which both of its ends lie.
    fn near(&self, positions: &[Point], line: [Point; 2], ends: [VertexId; 2]) -> Vec<EdgeId> {
        let mut near: Vec<EdgeId> = Vec::new();
        let mut add = |vertex: VertexId| {
            let first = self.at.partition_point(|&(other, _)| other < vertex);
            let here = self.at[first..].iter().take_while(|&&(other, _)| other == vertex);
            near.extend(here.map(|&(_, edge)| edge));
        };
        ends.into_iter().for_each(&mut add);
        self.points.visit_near(line, self.within, |number| {
            let vertex = self.vertices[number as usize];
            if is_on(positions[vertex.index()], line, self.within) {
                add(vertex);
            }
        });
        let end = Bounds { low: line[0], high: line[0] };
        self.boxes.any(
            |bounds| bounds.overlaps(&end),
            |item| {
                near.push(self.edges[item]);
                false
            },
        );
        near.sort_unstable();
        near.dedup();
        near
    }
}

fn sorted([a, b]: [VertexId; 2]) -> [VertexId; 2] {
    [a.min(b), a.max(b)]
}
