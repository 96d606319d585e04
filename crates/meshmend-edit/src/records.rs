//! What is stored of each element.

use meshmend_core::{FaceId, VertexId};

use crate::place::Place;
use crate::{EdgeKey, FaceKey, HalfKey, VertexKey};
use meshmend_core::Blend;

/// A half-edge: a side of a face seen from its corner, or the side of a hole.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Half {
    pub(crate) next: HalfKey,
    pub(crate) prev: HalfKey,
    pub(crate) twin: HalfKey,
    pub(crate) origin: VertexKey,
    /// None along a hole.
    pub(crate) face: Option<FaceKey>,
    pub(crate) edge: EdgeKey,
    /// Where the corner's attributes come from.
    pub(crate) place: Place,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Vertex {
    /// One that leaves the vertex; None where the vertex is in no face.
    pub(crate) half: Option<HalfKey>,
    pub(crate) position: [f64; 3],
    /// The vertex of the mesh that it is, or was split from.
    pub(crate) source: Option<VertexId>,
    /// Where a created vertex lies, if that can be said.
    pub(crate) place: Option<Blend>,
    /// How many elements were made before.
    pub(crate) made: u64,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Face {
    pub(crate) half: HalfKey,
    /// The face of the mesh that it is, or is a piece of.
    pub(crate) source: Option<FaceId>,
    /// How many elements were made before.
    pub(crate) made: u64,
}
