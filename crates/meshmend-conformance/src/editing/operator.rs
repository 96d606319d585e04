//! The thirteen operators by vertex numbers.

use std::fmt;

/// A half-edge by the vertices that it leaves and leads to: an edge joins two vertices once, so there is one.
pub type Side = [u32; 2];

/// Where the arc of a vertex that is split begins or ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Opening {
    /// In the corner to the left of a half-edge, of a face or a hole, which gets a side more.
    Corner(Side),
    /// Along a half-edge, whose edge becomes a triangle.
    Edge(Side),
}

impl Opening {
    /// The half-edge that leaves the vertex there.
    pub fn side(self) -> Side {
        match self {
            Opening::Corner(side) | Opening::Edge(side) => side,
        }
    }
}

/// Which operator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// An edge becomes two.
    SplitEdge,
    /// Two edges become one.
    JoinEdges,
    /// A face becomes two.
    SplitFace,
    /// Two faces become one.
    JoinFaces,
    /// A vertex comes into a face.
    Poke,
    /// A vertex with three triangles or more goes.
    RemoveVertex,
    /// An edge turns.
    Flip,
    /// An edge shrinks.
    Collapse,
    /// A vertex becomes an edge.
    SplitVertex,
    /// A face becomes a hole.
    OpenFace,
    /// A hole becomes a face.
    CloseHole,
    /// A closed walk becomes two holes.
    CutLoop,
    /// Two holes become a closed walk.
    ZipHoles,
}

impl Kind {
    /// All of them.
    pub const ALL: [Kind; 13] = [
        Kind::SplitEdge,
        Kind::JoinEdges,
        Kind::SplitFace,
        Kind::JoinFaces,
        Kind::Poke,
        Kind::RemoveVertex,
        Kind::Flip,
        Kind::Collapse,
        Kind::SplitVertex,
        Kind::OpenFace,
        Kind::CloseHole,
        Kind::CutLoop,
        Kind::ZipHoles,
    ];
}

/// An operator with what it is applied to. A face or a hole is named by a half-edge to whose left it lies.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Operator {
    /// Puts a vertex on an edge.
    SplitEdge(Side),
    /// Takes a vertex out of the line of its two edges.
    JoinEdges(u32),
    /// Joins by an edge the corners from which two half-edges leave.
    SplitFace(Side, Side),
    /// Removes the edge between two faces.
    JoinFaces(Side),
    /// Puts a vertex into a face, joined to all corners.
    Poke(Side),
    /// Makes one face of the triangles round a vertex.
    RemoveVertex(u32),
    /// Turns the edge between two triangles, to join their tips.
    Flip(Side),
    /// Makes the first vertex of an edge the second.
    Collapse(Side),
    /// Hands what lies counter-clockwise from one opening to the other to a new vertex.
    SplitVertex(Opening, Opening),
    /// Makes a face a hole.
    OpenFace(Side),
    /// Makes a hole a face.
    CloseHole(Side),
    /// Cuts along a closed walk of vertices; what lies to its right gets new ones.
    CutLoop(Vec<u32>),
    /// Sews two holes together: the second half-edge comes to lie on the first, the other way round.
    ZipHoles(Side, Side),
}

impl Operator {
    /// Which operator it is.
    pub fn kind(&self) -> Kind {
        match self {
            Operator::SplitEdge(_) => Kind::SplitEdge,
            Operator::JoinEdges(_) => Kind::JoinEdges,
            Operator::SplitFace(..) => Kind::SplitFace,
            Operator::JoinFaces(_) => Kind::JoinFaces,
            Operator::Poke(_) => Kind::Poke,
            Operator::RemoveVertex(_) => Kind::RemoveVertex,
            Operator::Flip(_) => Kind::Flip,
            Operator::Collapse(_) => Kind::Collapse,
            Operator::SplitVertex(..) => Kind::SplitVertex,
            Operator::OpenFace(_) => Kind::OpenFace,
            Operator::CloseHole(_) => Kind::CloseHole,
            Operator::CutLoop(_) => Kind::CutLoop,
            Operator::ZipHoles(..) => Kind::ZipHoles,
        }
    }
}

impl fmt::Display for Operator {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self:?}")
    }
}
