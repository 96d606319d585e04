//! The faces as they become, and what was put in and left.

use meshmend_core::{Complex, CornerId, FaceId, FaceTable, FaceTableBuilder, Id, PolygonMesh, VertexId};
use meshmend_geometry::vector::{Point, dot, minus};

use super::copies::Copies;
use super::not_healed::NotHealed;
use super::round::Round;
use crate::t_junctions::{Boundary, OnEdges, TJunction, distance, junction};
use crate::unit::Unit;

/// What healing makes of a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Healed {
    /// The faces that have new corners, ascending, each with all its corners.
    pub faces: Vec<(FaceId, Vec<HealedCorner>)>,
    /// The new corners, by face and vertex.
    pub insertions: Vec<Insertion>,
    /// The T-junctions that are left, by vertex and ends, each with the reason.
    pub left: Vec<LeftTJunction>,
    /// How many rounds changed something.
    pub rounds: u32,
}

/// A corner of a face with new corners.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum HealedCorner {
    /// A corner of the mesh as it was.
    Kept(CornerId),
    /// A new one at a vertex, on the way from the last kept corner to the next one.
    New {
        /// The vertex.
        vertex: VertexId,
        /// At which part of that way its foot is.
        share: f64,
    },
}

/// A vertex that became a corner of a face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Insertion {
    /// The vertex.
    pub vertex: VertexId,
    /// The face.
    pub face: FaceId,
    /// The ends of the boundary edge on which it lies, in the direction of the face.
    pub ends: [VertexId; 2],
    /// At which part of the way from one end to the other its foot is.
    pub foot: f64,
    /// How far it is from the edge, in doubles.
    pub distance: f64,
}

impl Insertion {
    /// The T-junction that was healed.
    pub fn junction(&self) -> TJunction {
        let &Insertion { vertex, face, ends, distance, .. } = self;
        TJunction { vertex, ends, face, distance, is_aligned: true }
    }
}

/// A T-junction that healing leaves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeftTJunction {
    /// The T-junction, on the faces as they are in the end.
    pub junction: TJunction,
    /// Why it stays.
    pub reason: NotHealed,
}

/// Where vertices are, and how far from an edge they count as on it.
pub(super) struct Place<'a> {
    pub(super) positions: &'a [Point],
    pub(super) within: f64,
}

impl Place<'_> {
    /// A T-junction with its distance.
    fn junction(&self, boundary: &Boundary, edge: u32, vertex: VertexId) -> TJunction {
        let is_off = self.within > 0.0;
        let distance = if is_off { distance(self.positions, boundary, edge, vertex) } else { 0.0 };
        TJunction { distance, ..junction(boundary, edge, vertex) }
    }

    /// At which part of the way from one end of an edge to the other the foot of a vertex is, in doubles.
    fn share(&self, ends: [VertexId; 2], vertex: VertexId) -> f64 {
        let [from, to] = ends.map(|end| self.positions[end.index()]);
        let point = self.positions[vertex.index()];
        let largest = [from, to, point].iter().flatten().fold(0.0f64, |most, x| most.max(x.abs()));
        let unit = Unit::of(largest);
        let [from, to, point] = [from, to, point].map(|point| unit.shrunk(point));
        let along = minus(to, from);
        (dot(minus(point, from), along) / dot(along, along)).clamp(0.0, 1.0)
    }
}

/// The faces as they become, round by round.
pub(super) struct Recorder {
    /// For each corner of the present faces the one that it was at first; `None` for a new one.
    sources: Vec<Option<CornerId>>,
    insertions: Vec<Insertion>,
    rounds: u32,
}

impl Recorder {
    pub(super) fn of(complex: &Complex) -> Self {
        let corners = (0..complex.faces().corner_count()).map(CornerId::new);
        let sources = corners.map(|corner| Some(complex.stored_corner(corner))).collect();
        Recorder { sources, insertions: Vec::new(), rounds: 0 }
    }

    /// The faces with the corners that a round puts in; `None` if it puts none in.
    pub(super) fn insert(
        &mut self,
        place: &Place<'_>,
        boundary: &Boundary,
        round: &Round,
    ) -> Option<FaceTable> {
        // Behind which corner of which boundary edge something is put in.
        let chosen = round.chosen.iter().enumerate().filter(|(_, vertices)| !vertices.is_empty());
        let mut behind: Vec<(CornerId, usize)> =
            chosen.map(|(edge, _)| (boundary.edges()[edge].corner, edge)).collect();
        behind.sort_unstable();
        let faces = boundary.faces();
        let mut builder = FaceTableBuilder::default();
        let mut sources = Vec::with_capacity(self.sources.len() + behind.len());
        let mut next = behind.iter().peekable();
        for face in faces.faces() {
            for corner in faces.face_corners(face) {
                builder.push_corner(faces.corner_vertex(corner));
                sources.push(self.sources[corner.index()]);
                if let Some(&(_, edge)) = next.next_if(|(before, _)| *before == corner) {
                    for &vertex in &round.chosen[edge] {
                        builder.push_corner(vertex);
                        sources.push(None);
                        let junction = place.junction(boundary, edge as u32, vertex);
                        let foot = place.share(junction.ends, vertex);
                        let TJunction { face, ends, distance, .. } = junction;
                        self.insertions.push(Insertion { vertex, face, ends, foot, distance });
                    }
                }
            }
            builder.end_face();
        }
        if behind.is_empty() {
            return None;
        }
        self.sources = sources;
        self.rounds += 1;
        builder.build(faces.vertex_count()).ok()
    }

    /// What came of it all, once a round puts nothing in. The mesh is given where several of its vertices share a place.
    pub(super) fn finished(
        mut self,
        shared: Option<&PolygonMesh>,
        place: &Place<'_>,
        boundary: &Boundary,
        on: &OnEdges,
        round: &Round,
    ) -> Healed {
        let left = on.pairs().iter().zip(&round.is_aligned).map(|(&(edge, vertex), &is_aligned)| {
            let junction = TJunction { is_aligned, ..place.junction(boundary, edge, vertex) };
            let refused = round.refused[edge as usize].unwrap_or(NotHealed::Unmatched);
            let reason = if is_aligned { refused } else { NotHealed::Foreign };
            LeftTJunction { junction, reason }
        });
        let mut left: Vec<LeftTJunction> = left.collect();
        left.sort_unstable_by_key(|left| (left.junction.vertex, left.junction.ends));
        self.insertions.sort_unstable_by_key(|insertion| (insertion.face, insertion.vertex));
        let mut faces = self.healed_faces(place, boundary.faces());
        if let Some(mesh) = shared {
            let copies = Copies { mesh, sources: &self.sources, boundary };
            name_copies(&copies, boundary.faces(), &mut faces, &mut self.insertions);
        }
        Healed { faces, insertions: self.insertions, left, rounds: self.rounds }
    }

    fn healed_faces(&self, place: &Place<'_>, faces: &FaceTable) -> Vec<(FaceId, Vec<HealedCorner>)> {
        let mut touched: Vec<FaceId> = self.insertions.iter().map(|insertion| insertion.face).collect();
        touched.dedup();
        touched.into_iter().map(|face| (face, self.healed_face(place, faces, face))).collect()
    }

    fn healed_face(&self, place: &Place<'_>, faces: &FaceTable, face: FaceId) -> Vec<HealedCorner> {
        let range = faces.corner_range(face);
        let vertices = faces.face_vertices(face);
        let sources = &self.sources[range];
        let count = vertices.len();
        // The first corner is always kept: new ones come behind a corner.
        let mut last = 0;
        let mut corners = Vec::with_capacity(count);
        for at in 0..count {
            if let Some(corner) = sources[at] {
                last = at;
                corners.push(HealedCorner::Kept(corner));
                continue;
            }
            let next = (at..count).find(|&next| sources[next].is_some()).unwrap_or(0);
            let share = place.share([vertices[last], vertices[next]], vertices[at]);
            corners.push(HealedCorner::New { vertex: vertices[at], share });
        }
        corners
    }
}

/// Gives new corners, and the insertions that put them in, the vertices that they become.
fn name_copies(
    copies: &Copies<'_>,
    table: &FaceTable,
    faces: &mut [(FaceId, Vec<HealedCorner>)],
    insertions: &mut [Insertion],
) {
    let mut names = Vec::new();
    for (face, corners) in faces {
        for (corner, healed) in table.face_corners(*face).zip(corners) {
            let HealedCorner::New { vertex, .. } = healed else { continue };
            let name = copies.at(corner);
            let here =
                insertions.binary_search_by_key(&(*face, *vertex), |put_in| (put_in.face, put_in.vertex));
            names.extend(here.ok().map(|insertion| (insertion, name)));
            *vertex = name;
        }
    }
    names.into_iter().for_each(|(insertion, name)| insertions[insertion].vertex = name);
    insertions.sort_unstable_by_key(|insertion| (insertion.face, insertion.vertex));
}
