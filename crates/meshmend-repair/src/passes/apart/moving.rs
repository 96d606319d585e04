//! Where vertices go that share a position in single precision.

use std::collections::BTreeSet;

use meshmend_core::{CornerId, DraftError, FaceId, Id, PolygonMesh, VertexId, Watch};
use meshmend_geometry::vector::{Point, is_finite, length, minus};
use meshmend_spatial::exact::{Sign, are_collinear};
use meshmend_spatial::{CrossingSearch, Surface, agreement};

use rayon::prelude::*;

use super::record::{ApartFate, ApartRecord, NotMoved};
use crate::PassError;

/// A place in single precision, by the bits of its coordinates; 0 and −0 are one.
type Place = [u32; 3];

/// A vertex stays where it is if it would have to go farther.
const MOST_STEPS: u32 = 64;

/// All positions as they become, and what became of each vertex at the place of a lower one.
///
/// # Errors
/// When the triangles of all faces have more corners than a table holds, or whoever watches stops it.
pub(super) fn moved(mesh: &PolygonMesh, watch: &Watch) -> Result<(Vec<Point>, Vec<ApartRecord>), PassError> {
    let mut places = used_places(mesh);
    places.sort_unstable();
    let together: Vec<&[(Place, VertexId)]> =
        places.chunk_by(|one, other| one.0 == other.0).filter(|together| together.len() > 1).collect();
    let corners =
        corners_of(mesh, together.iter().flat_map(|together| &together[1..]).map(|&(_, vertex)| vertex));
    let positions = mesh.positions().to_vec();
    let mut moving = Moving { mesh, positions, corners, places: &places, new: BTreeSet::new() };
    let mut records = Vec::new();
    for together in together {
        let Some((&(_, stays), others)) = together.split_first() else { continue };
        for &(_, vertex) in others {
            let fate = match moving.move_apart(vertex) {
                Ok((steps, length)) => ApartFate::Moved { length, steps },
                Err(left) => ApartFate::Left { left },
            };
            records.push(ApartRecord { vertex, stays, fate });
        }
    }
    records.sort_by_key(|record| record.vertex);
    let crossing = Crossing { mesh, corners: &moving.corners, watch };
    crossing.take_back(&mut moving.positions, &mut records)?;
    Ok((moving.positions, records))
}

/// The places of the vertices that faces use, as far as single precision has them.
fn used_places(mesh: &PolygonMesh) -> Vec<(Place, VertexId)> {
    let mut is_used = vec![false; mesh.counts().vertices];
    mesh.complex().faces().corner_vertices().iter().for_each(|vertex| is_used[vertex.index()] = true);
    let used = (0..is_used.len()).filter(|&vertex| is_used[vertex]).map(VertexId::new);
    used.filter_map(|vertex| Some((place(mesh.position(vertex))?, vertex))).collect()
}

/// The corners of some vertices, by these.
fn corners_of(mesh: &PolygonMesh, vertices: impl Iterator<Item = VertexId>) -> Vec<(VertexId, CornerId)> {
    let mut is_asked = vec![false; mesh.counts().vertices];
    vertices.for_each(|vertex| is_asked[vertex.index()] = true);
    let faces = mesh.complex().faces();
    let all = faces.corners().map(|corner| (faces.corner_vertex(corner), corner));
    let mut corners: Vec<(VertexId, CornerId)> = all.filter(|(vertex, _)| is_asked[vertex.index()]).collect();
    corners.sort_unstable();
    corners
}

/// The place of a point, if single precision has one.
fn place(point: Point) -> Option<Place> {
    let single = point.map(|x| x as f32);
    single.iter().all(|x| x.is_finite()).then(|| single.map(|x| (x + 0.0).to_bits()))
}

/// What the faces at vertices that moved cross.
struct Crossing<'a> {
    mesh: &'a PolygonMesh,
    /// The corners of those that may have moved, by vertex.
    corners: &'a [(VertexId, CornerId)],
    watch: &'a Watch,
}

impl Crossing<'_> {
    /// Takes back the moves by which a face came to cross another, until there is none.
    fn take_back(&self, positions: &mut [Point], records: &mut [ApartRecord]) -> Result<(), PassError> {
        let vertices: Vec<VertexId> =
            records.iter().filter(|record| record.is_moved()).map(|record| record.vertex).collect();
        if vertices.is_empty() {
            return Ok(());
        }
        let before = self.crossing(self.mesh.positions(), &vertices)?;
        loop {
            let now = self.crossing(positions, &vertices)?;
            let is_worse = |vertex: VertexId| {
                vertices
                    .binary_search(&vertex)
                    .is_ok_and(|at| now[at].iter().any(|pair| before[at].binary_search(pair).is_err()))
            };
            let is_wrong = |record: &ApartRecord| record.is_moved() && is_worse(record.vertex);
            let mut is_done = true;
            for record in records.iter_mut().filter(|record| is_wrong(record)) {
                record.fate = ApartFate::Left { left: NotMoved::Crossing };
                positions[record.vertex.index()] = self.mesh.position(record.vertex);
                is_done = false;
            }
            if is_done {
                return Ok(());
            }
        }
    }

    /// For each of some vertices the pairs of a face at it and a face that this one crosses, ascending.
    fn crossing(
        &self,
        positions: &[Point],
        vertices: &[VertexId],
    ) -> Result<Vec<Vec<[FaceId; 2]>>, PassError> {
        let faces = self.mesh.faces();
        let mesh = PolygonMesh::new(positions.to_vec(), faces.clone()).map_err(DraftError::from)?;
        let surface = Surface::watched(&mesh, self.watch)?;
        let search = CrossingSearch::new(&surface)?;
        let complex = self.mesh.complex().faces();
        let pairs = |vertex: &VertexId| {
            let first = self.corners.partition_point(|(other, _)| other < vertex);
            let corners = self.corners[first..].iter().take_while(|(other, _)| other == vertex);
            let own = corners.map(|&(_, corner)| complex.corner_face(corner));
            let crossed = own.flat_map(|face| {
                let triangles = surface.triangles_of(face).iter();
                let others = triangles.flat_map(|triangle| search.crossings(surface.points(triangle)));
                others.map(move |other| [face, other]).collect::<Vec<_>>()
            });
            let mut pairs: Vec<[FaceId; 2]> = crossed.collect();
            pairs.sort_unstable();
            pairs
        };
        Ok(vertices.par_iter().map(pairs).collect())
    }
}

/// The vertices while some of them move.
struct Moving<'a> {
    mesh: &'a PolygonMesh,
    positions: Vec<Point>,
    /// The corners of those that may move, by vertex.
    corners: Vec<(VertexId, CornerId)>,
    /// The places as they were, ascending.
    places: &'a [(Place, VertexId)],
    /// The places of those that moved.
    new: BTreeSet<Place>,
}

impl Moving<'_> {
    /// Moves a vertex to a place of its own; says by how many steps and how far.
    fn move_apart(&mut self, vertex: VertexId) -> Result<(u32, f64), NotMoved> {
        let triangles = self.triangles(vertex).ok_or(NotMoved::Polygon)?;
        let from = self.positions[vertex.index()];
        let beside: Vec<Point> = triangles.iter().flat_map(|triangle| [triangle[1], triangle[2]]).collect();
        let way = minus(mean(&beside), from);
        let reach = way.iter().fold(0.0f64, |most, x| most.max(x.abs()));
        let size = beside.iter().chain([&from]).flatten().fold(0.0f64, |most, x| most.max(x.abs()));
        if !(is_finite(&way) && reach > 0.0) {
            return Err(NotMoved::NoRoom);
        }
        let step = step_at(size);
        for steps in 1..=MOST_STEPS {
            let share = f64::from(steps) * step / reach;
            if share > 0.5 {
                break;
            }
            let to: Point = std::array::from_fn(|i| f64::from((from[i] + way[i] * share) as f32));
            let Some(place) = place(to).filter(|place| self.is_free(place)) else { continue };
            if triangles.iter().all(|&[_, b, c]| stays_as_it_is([from, b, c], [to, b, c])) {
                self.positions[vertex.index()] = to;
                self.new.insert(place);
                return Ok((steps, length(minus(to, from))));
            }
        }
        Err(NotMoved::NoRoom)
    }

    fn is_free(&self, place: &Place) -> bool {
        self.places.binary_search_by_key(place, |(other, _)| *other).is_err() && !self.new.contains(place)
    }

    /// The triangles at a vertex, each beginning with it; `None` if one of its faces is larger.
    fn triangles(&self, vertex: VertexId) -> Option<Vec<[Point; 3]>> {
        let faces = self.mesh.complex().faces();
        let triangle = |corner: CornerId| {
            let face: FaceId = faces.corner_face(corner);
            let &[a, b, c] = faces.face_vertices(face) else { return None };
            let turned = match faces.corner_range(face).start {
                first if first == corner.index() => [a, b, c],
                first if first + 1 == corner.index() => [b, c, a],
                _ => [c, a, b],
            };
            Some(turned.map(|vertex| self.positions[vertex.index()]))
        };
        let first = self.corners.partition_point(|(other, _)| *other < vertex);
        let corners = self.corners[first..].iter().take_while(|(other, _)| *other == vertex);
        corners.map(|&(_, corner)| triangle(corner)).collect()
    }
}

/// Whether a triangle neither turns over nor loses its area when it becomes another; one without area has none to lose.
fn stays_as_it_is(before: [Point; 3], after: [Point; 3]) -> bool {
    agreement(before, after) == Sign::Positive || are_collinear(before)
}

/// The least difference of two numbers of single precision that are as large.
fn step_at(size: f64) -> f64 {
    let single = size as f32;
    f64::from(single.next_up()) - f64::from(single)
}

fn mean(points: &[Point]) -> Point {
    let count = points.len().max(1) as f64;
    std::array::from_fn(|i| points.iter().map(|point| point[i] / count).sum())
}
