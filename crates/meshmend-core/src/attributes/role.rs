//! What the values of a layer mean, and what follows from that when a face is turned round.
//!
//! A pass never sees a layer: readers give roles, and
//! [`PolygonMesh::rebuild`](crate::PolygonMesh::rebuild) asks the one table here.

/// What the values of a layer mean.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Role {
    /// Nothing that a change of the mesh has to know.
    #[default]
    Plain,
    /// The direction of the surface's front.
    Normal,
    /// A direction along the surface, and as fourth number on which side of it the third axis lies.
    Tangent,
    /// A place in a picture.
    TexCoord,
    /// A colour.
    Color,
    /// The joints that move a vertex, by set.
    Joints(u8),
    /// How much each of them moves it, by set.
    Weights(u8),
    /// How far a morph target moves a position, by target.
    MorphPosition(u16),
    /// By how much a morph target changes a normal, by target.
    MorphNormal(u16),
    /// By how much a morph target changes a tangent, by target.
    MorphTangent(u16),
    /// The name of an element in its file: never a mean of others, and none for created elements.
    Identity,
}

/// What happens to stored normals where a face is turned round.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum FlippedNormals {
    /// They turn with the face; the handedness of tangents changes with them.
    #[default]
    Negate,
    /// They stay as they are.
    Keep,
}

/// Which numbers of a value change their sign where a face is turned round.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Turn {
    /// All of them.
    Whole,
    /// The fourth.
    Fourth,
}

impl Role {
    /// What turning a face does to a value of this role.
    pub(super) fn turn(self) -> Option<Turn> {
        match self {
            Role::Normal | Role::MorphNormal(_) => Some(Turn::Whole),
            Role::Tangent => Some(Turn::Fourth),
            _ => None,
        }
    }
}

impl Turn {
    /// Whether the number at a place within a value changes its sign.
    pub(crate) fn concerns(self, place: usize) -> bool {
        self == Turn::Whole || place == 3
    }
}
