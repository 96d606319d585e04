//! The names of elements while a mesh is edited: keys that never name another element once theirs is gone.

use std::fmt;

use slotmap::{Key as _, new_key_type};
use thiserror::Error;

new_key_type! {
    /// A vertex.
    pub struct VertexKey;
    /// An edge.
    pub struct EdgeKey;
    /// A face.
    pub struct FaceKey;
    /// A half-edge: a corner of a face with its side, or the side of a hole.
    pub struct HalfKey;
}

/// A key of any kind, as refusals name it. Shown as the kind, the place and how often the place was taken: `edge 7v1`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Key {
    /// A vertex.
    Vertex(VertexKey),
    /// An edge.
    Edge(EdgeKey),
    /// A face.
    Face(FaceKey),
    /// A half-edge.
    Half(HalfKey),
}

impl fmt::Display for Key {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (kind, data) = match self {
            Key::Vertex(key) => ("vertex", key.data()),
            Key::Edge(key) => ("edge", key.data()),
            Key::Face(key) => ("face", key.data()),
            Key::Half(key) => ("half-edge", key.data()),
        };
        write!(f, "{kind} {data:?}")
    }
}

macro_rules! keys {
    ($($key:ident => $kind:ident),*) => {$(
        impl From<$key> for Key {
            fn from(key: $key) -> Self {
                Key::$kind(key)
            }
        }

        impl fmt::Display for $key {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                Key::from(*self).fmt(f)
            }
        }
    )*};
}

keys!(VertexKey => Vertex, EdgeKey => Edge, FaceKey => Face, HalfKey => Half);

/// A key was used whose element is gone.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("{0} is gone")]
pub struct StaleKey(pub Key);
