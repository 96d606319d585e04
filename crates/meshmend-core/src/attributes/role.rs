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
    /// Its name: `normal`, or `joints:1` for the second set.
    pub fn name(self) -> String {
        let numbered = |name: &str, number: usize| format!("{name}:{number}");
        match self {
            Role::Joints(set) => numbered("joints", set.into()),
            Role::Weights(set) => numbered("weights", set.into()),
            Role::MorphPosition(target) => numbered("morph-position", target.into()),
            Role::MorphNormal(target) => numbered("morph-normal", target.into()),
            Role::MorphTangent(target) => numbered("morph-tangent", target.into()),
            role => role.plain_name().to_owned(),
        }
    }

    /// The role of a name.
    pub fn from_name(name: &str) -> Option<Self> {
        let plain = [Role::Plain, Role::Normal, Role::Tangent, Role::TexCoord, Role::Color, Role::Identity];
        let Some((name, number)) = name.split_once(':') else {
            return plain.into_iter().find(|role| role.plain_name() == name);
        };
        match name {
            "joints" => number.parse().ok().map(Role::Joints),
            "weights" => number.parse().ok().map(Role::Weights),
            "morph-position" => number.parse().ok().map(Role::MorphPosition),
            "morph-normal" => number.parse().ok().map(Role::MorphNormal),
            "morph-tangent" => number.parse().ok().map(Role::MorphTangent),
            _ => None,
        }
    }

    /// The name of a role without a number.
    fn plain_name(self) -> &'static str {
        match self {
            Role::Normal => "normal",
            Role::Tangent => "tangent",
            Role::TexCoord => "texcoord",
            Role::Color => "color",
            Role::Identity => "identity",
            _ => "plain",
        }
    }

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_role_is_found_by_its_name() {
        let roles = [
            Role::Plain,
            Role::Normal,
            Role::Tangent,
            Role::TexCoord,
            Role::Color,
            Role::Joints(1),
            Role::Weights(255),
            Role::MorphPosition(0),
            Role::MorphNormal(65_535),
            Role::MorphTangent(7),
            Role::Identity,
        ];
        roles.iter().for_each(|&role| assert_eq!(Role::from_name(&role.name()), Some(role)));
        for wrong in ["", "normals", "joints", "joints:256", "joints:-1", "normal:1", "plain:0"] {
            assert_eq!(Role::from_name(wrong), None, "{wrong}");
        }
    }
}
