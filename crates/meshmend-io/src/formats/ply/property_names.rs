//! The names of elements and properties that have a meaning.

/// The elements of known meaning.
pub(super) const KNOWN_ELEMENTS: [&str; 4] = ["vertex", "face", "tristrips", "edge"];

/// Names that stand for one layer together.
pub(super) struct Group {
    pub(super) layer: &'static str,
    pub(super) members: &'static [&'static str],
}

/// The groups. A group comes before those that it extends.
pub(super) const GROUPS: [Group; 6] = [
    Group { layer: "normal", members: &["nx", "ny", "nz"] },
    Group { layer: "color", members: &["red", "green", "blue", "alpha"] },
    Group { layer: "color", members: &["red", "green", "blue"] },
    Group { layer: "texcoord", members: &["s", "t"] },
    Group { layer: "texcoord", members: &["u", "v"] },
    Group { layer: "texcoord", members: &["texture_u", "texture_v"] },
];

/// The key of metadata with the names that the properties of a group had, if they were not the usual ones.
pub(super) const PROPERTY_NAMES: &str = "ply-property";

/// The start of the name of a list property whose values are those of the corners.
pub(super) const CORNER_PREFIX: &str = "corner_";
