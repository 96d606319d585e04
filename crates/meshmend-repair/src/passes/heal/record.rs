//! What became of each T-junction.

use std::fmt;

use meshmend_core::{FaceId, PolygonMesh, VertexId};
use meshmend_geometry::vector::{Point, length, minus};
use meshmend_spatial::{Healed, HealedCorner, Insertion, LeftTJunction, NotHealed};
use serde::Serialize;

/// A piece shorter than this part of the diagonal of the mesh's box is named.
const SHORT: f64 = 1e-9;

/// A boundary vertex on a boundary edge of a face, and what became of it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct TJunctionRecord {
    /// The vertex.
    pub vertex: VertexId,
    /// The face that has the edge.
    pub face: FaceId,
    /// The ends of the edge, in the direction of the face.
    pub ends: [VertexId; 2],
    /// How far the vertex is from the edge.
    pub distance: f64,
    /// What became of it.
    #[serde(flatten)]
    pub fate: TJunctionFate,
}

/// What became of a T-junction.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum TJunctionFate {
    /// The vertex is a corner of the face now.
    Healed {
        /// At which part of the way from one end to the other.
        foot: f64,
        /// How long the shorter of the edges at the new corner is, where that is less than 10⁻⁹ of the mesh's diagonal.
        #[serde(skip_serializing_if = "Option::is_none")]
        short_edge: Option<f64>,
    },
    /// It is still there.
    Left {
        /// Why.
        left: NotHealed,
    },
}

impl TJunctionRecord {
    /// Whether the vertex is a corner of the face now.
    pub fn is_healed(&self) -> bool {
        matches!(self.fate, TJunctionFate::Healed { .. })
    }
}

/// What became of the T-junctions of a mesh, by vertex and ends.
pub(super) fn of(mesh: &PolygonMesh, healed: &Healed) -> Vec<TJunctionRecord> {
    let diagonal = meshmend_geometry::diagonal(mesh.positions());
    let mut short = Vec::new();
    for (face, corners) in &healed.faces {
        let points: Vec<(Option<VertexId>, Point)> = corners.iter().map(|corner| at(mesh, corner)).collect();
        let count = points.len();
        for (place, (new, point)) in points.iter().enumerate() {
            let beside = [(place + 1) % count, (place + count - 1) % count].map(|other| points[other].1);
            let shortest =
                beside.map(|other| length(minus(*point, other))).into_iter().fold(f64::MAX, f64::min);
            short.extend(
                new.filter(|_| shortest < SHORT * diagonal).map(|vertex| ((*face, vertex), shortest)),
            );
        }
    }
    short.sort_by_key(|(place, _)| *place);
    let short_edge = |face: FaceId, vertex: VertexId| {
        short.binary_search_by_key(&(face, vertex), |(place, _)| *place).ok().map(|found| short[found].1)
    };
    let put_in = healed.insertions.iter().map(|insertion| {
        let &Insertion { vertex, face, ends, foot, distance } = insertion;
        let fate = TJunctionFate::Healed { foot, short_edge: short_edge(face, vertex) };
        TJunctionRecord { vertex, face, ends, distance, fate }
    });
    let left = healed.left.iter().map(|LeftTJunction { junction, reason }| TJunctionRecord {
        vertex: junction.vertex,
        face: junction.face,
        ends: junction.ends,
        distance: junction.distance,
        fate: TJunctionFate::Left { left: *reason },
    });
    let mut records: Vec<TJunctionRecord> = put_in.chain(left).collect();
    records.sort_by_key(|record| (record.vertex, record.ends, record.face));
    records
}

/// The vertex of a corner if that is new, and its point.
fn at(mesh: &PolygonMesh, corner: &HealedCorner) -> (Option<VertexId>, Point) {
    match *corner {
        HealedCorner::Kept(corner) => (None, mesh.position(mesh.faces().corner_vertex(corner))),
        HealedCorner::New { vertex, .. } => (Some(vertex), mesh.position(vertex)),
    }
}

impl fmt::Display for TJunctionRecord {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let TJunctionRecord { vertex, face, ends: [from, to], distance, fate } = self;
        write!(f, "{vertex} on the edge {from}-{to} of {face}, at distance {distance:e}: ")?;
        match fate {
            TJunctionFate::Healed { foot, short_edge } => {
                write!(f, "put in at {foot:.6}")?;
                short_edge.iter().try_for_each(|short| write!(f, "; an edge there has length {short:e}"))
            }
            TJunctionFate::Left { left } => write!(f, "left: {}", left.reason()),
        }
    }
}
