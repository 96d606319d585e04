//! A hole, and what covers it.

use meshmend_core::{FaceId, PolygonMesh, VertexId};
use meshmend_geometry::polygon::Triangle;
use meshmend_geometry::vector::Point;
use meshmend_geometry::{Edges, FreePoints, GatheredRoom};
use meshmend_spatial::{
    Fill as Triangles, FillBy, FillCost, Opening, best_fill, direction_of_face, fan_cost, is_straight,
};

use super::judging::SideBeside;
use super::places::TrianglesByPlace;
use super::record::{FillShape, LeftOpen};
use super::{Fill, FillWith};

/// A loop that is to be filled, with its own lists.
pub(super) struct Hole<'a> {
    pub(super) sides: &'a [SideBeside],
    pub(super) vertices: Vec<VertexId>,
    points: Vec<Point>,
    beside: Vec<Point>,
}

/// What is best for a hole.
pub(super) enum Choice {
    /// These triangles.
    Triangles(Triangles),
    /// A fan.
    Fan,
    /// None.
    Left(LeftOpen),
}

/// What covers a hole.
pub(super) struct Cover {
    pub(super) shape: FillShape,
    /// By the places of the hole's corners; the new vertex of a fan comes behind the last.
    pub(super) triangles: Vec<Triangle>,
    /// Where a fan's new vertex is.
    pub(super) centre: Option<Point>,
    pub(super) cost: FillCost,
}

impl<'a> Hole<'a> {
    pub(super) fn of(mesh: &PolygonMesh, sides: &'a [SideBeside]) -> Self {
        let vertices: Vec<VertexId> = sides.iter().map(|side| side.from).collect();
        let points = vertices.iter().map(|&vertex| mesh.position(vertex)).collect();
        // Neighbouring sides often lie along one face, which may be large.
        let mut last: Option<(FaceId, Point)> = None;
        let direction = |side: &SideBeside| match last {
            Some((face, direction)) if face == side.face => direction,
            _ => {
                let corners = mesh.faces().face_vertices(side.face).iter();
                let points: Vec<Point> = corners.map(|&vertex| mesh.position(vertex)).collect();
                last.insert((side.face, direction_of_face(&points))).1
            }
        };
        let beside = sides.iter().map(direction).collect();
        Hole { sides, vertices, points, beside }
    }

    /// Whether no vertex of the hole shares its place.
    pub(super) fn is_apart(&self, there: &TrianglesByPlace) -> bool {
        !self.vertices.iter().any(|&vertex| there.is_shared(vertex))
    }

    fn asked<T>(
        &self,
        edges: &Edges<'_>,
        there: &TrianglesByPlace,
        ask: impl FnOnce(&Opening<'_>) -> T,
    ) -> T {
        let is_joined = |one: usize, other: usize| {
            let ends = [self.vertices[one], self.vertices[other]];
            edges.contains([ends[0].min(ends[1]), ends[0].max(ends[1])])
        };
        let is_apart = self.is_apart(there);
        let is_there =
            |corners: [usize; 3]| !is_apart && there.excludes(corners.map(|corner| self.vertices[corner]));
        ask(&Opening {
            points: &self.points,
            vertices: &self.vertices,
            beside: &self.beside,
            is_joined: &is_joined,
            is_there: &is_there,
        })
    }

    /// What is best for the hole.
    pub(super) fn choice(&self, options: &Fill, edges: &Edges<'_>, there: &TrianglesByPlace) -> Choice {
        let by = match options.by {
            FillWith::Fold => Some(FillBy::Fold),
            FillWith::Area => Some(FillBy::Area),
            FillWith::Fan => None,
        };
        let fill = by.and_then(|by| self.asked(edges, there, |opening| best_fill(opening, by)));
        let is_folded = |fill: &Triangles| {
            let triangles = fill.triangles.iter().map(|t| t.map(|corner| self.vertices[corner]));
            !self.is_apart(there) && there.are_repeated(triangles)
        };
        match fill {
            Some(fill) if fill.cost.zero_area == fill.triangles.len() => Choice::Left(LeftOpen::Flat),
            Some(fill) if !is_folded(&fill) => Choice::Triangles(fill),
            _ if is_straight(&self.points) => Choice::Left(LeftOpen::Flat),
            _ if !self.is_apart(there) && there.runs_twice(&self.vertices) => {
                Choice::Left(LeftOpen::Repeated)
            }
            _ => Choice::Fan,
        }
    }

    /// The cover that was chosen, or why there is none.
    pub(super) fn cover(
        &self,
        choice: Choice,
        room: &mut GatheredRoom<impl FnMut() -> FreePoints>,
    ) -> Result<Cover, LeftOpen> {
        match choice {
            Choice::Left(reason) => Err(reason),
            Choice::Triangles(Triangles { triangles, cost }) => {
                Ok(Cover { shape: FillShape::Triangles, triangles, centre: None, cost })
            }
            Choice::Fan => {
                let (count, centre) = (self.points.len(), room.free().amid(&self.points));
                let triangles = (0..count).map(|corner| [corner, (corner + 1) % count, count]).collect();
                let opening = Opening {
                    points: &self.points,
                    vertices: &self.vertices,
                    beside: &self.beside,
                    is_joined: &|_, _| false,
                    is_there: &|_| false,
                };
                let cost = fan_cost(&opening, centre);
                Ok(Cover { shape: FillShape::Fan, triangles, centre: Some(centre), cost })
            }
        }
    }

    /// Where a corner of the cover is.
    pub(super) fn points_of(&self, cover: &Cover, triangle: Triangle) -> [Point; 3] {
        let beyond = cover.centre.unwrap_or([f64::NAN; 3]);
        triangle.map(|corner| self.points.get(corner).copied().unwrap_or(beyond))
    }
}
