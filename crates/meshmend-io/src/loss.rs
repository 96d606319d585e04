//! What a format can't carry.

use std::fmt;

use meshmend_core::{Domain, Layer};
use serde::{Deserialize, Serialize};

/// Something of a mesh that a written file lacks, or holds inexactly.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[non_exhaustive]
pub struct Loss {
    /// What kind of loss it is.
    pub kind: LossKind,
    /// How many elements it concerns.
    pub count: u64,
    /// What is lost, for people.
    pub message: String,
    /// The layer that is left out, where a whole layer is.
    #[serde(skip)]
    pub layer: Option<LostLayer>,
}

/// An attribute layer that a written file does not have, by what tells it from others.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct LostLayer {
    /// The elements that have its values.
    pub domain: Domain,
    /// Its name.
    pub name: String,
}

impl LostLayer {
    /// What a loss of this layer carries.
    pub fn of(layer: &Layer) -> Self {
        LostLayer { domain: layer.domain(), name: layer.name().to_owned() }
    }
}

/// The kinds of loss, with stable names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum LossKind {
    /// An attribute layer is left out.
    Layer,
    /// Some elements had no value in a layer. The format gives them one.
    AbsentValue,
    /// Vertices at the same point can't be told apart: the format stores coordinates only, so a reader joins them.
    SharedVertices,
    /// Values are kept in another type, or at other elements.
    Converted,
    /// Positions are rounded to single precision.
    Precision,
    /// Faces lose their area when positions are rounded.
    EmptiedFaces,
    /// Vertices coincide with others when positions are rounded.
    JoinedVertices,
    /// Faces of more than three corners are cut into triangles.
    Polygons,
    /// Faces of fewer than three corners are left out.
    ShortFaces,
    /// Faces with coordinates that are not finite are left out.
    NonFiniteFaces,
    /// Vertices that no face uses are left out.
    UnusedVertices,
    /// Loose edges are left out.
    LooseEdges,
    /// Loose points are left out.
    LoosePoints,
    /// Statements about the file as a whole are left out.
    Metadata,
    /// Files that the input names, such as material libraries, are not where the output looks for them.
    Companion,
    /// Something that a file says about a material is left out.
    Material,
    /// Names are spelled in another way, as the format can't write them.
    Names,
    /// Vertices whose attributes differ from face to face are written several times: the file is manifold by place,
    /// not by index.
    SeamVertices,
    /// Elements that only the format of the input holds are left out.
    Elements,
    /// Transforms of nodes or of build items are applied to positions.
    NodeTransforms,
    /// Something round the meshes, such as skins, animations or cameras, is left out.
    ScenePart,
    /// A created corner has the property of a corner beside it.
    CopiedProperty,
    /// Values are kept, but laid out in another way.
    TextLayout,
    /// Nothing of what a name stands for is left: a primitive is left out, or a whole part stays as it was.
    EmptiedName,
    /// Elements that are carried unchanged name vertices or faces by numbers that are out of date.
    StaleData,
}

impl Loss {
    pub(crate) fn new(kind: LossKind, count: usize, message: impl Into<String>) -> Self {
        Loss { kind, count: count as u64, message: message.into(), layer: None }
    }

    /// This loss, as that of a layer.
    pub(crate) fn of_layer(self, layer: &Layer) -> Self {
        Loss { layer: Some(LostLayer::of(layer)), ..self }
    }

    /// The loss, or `None` if it concerns no element.
    pub(crate) fn if_any(
        kind: LossKind,
        count: usize,
        message: impl FnOnce(usize) -> String,
    ) -> Option<Self> {
        (count > 0).then(|| Loss::new(kind, count, message(count)))
    }
}

impl fmt::Display for Loss {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl fmt::Display for LossKind {
    /// Its stable name.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.serialize(f)
    }
}

#[cfg(test)]
mod tests {
    use meshmend_core::counted;

    use super::*;

    #[test]
    fn a_loss_of_nothing_is_none_and_any_other_says_what_is_lost() {
        let loss = |count| Loss::if_any(LossKind::LooseEdges, count, |n| counted(n, "loose edge"));
        assert_eq!(loss(0), None);
        let one = loss(1).unwrap();
        assert_eq!((one.count, one.to_string()), (1, "1 loose edge".to_owned()));
    }
}
