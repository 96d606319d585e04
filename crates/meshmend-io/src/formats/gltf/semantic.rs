//! What an attribute means: its name in the file, and the layer that it is.

use meshmend_core::{Carry, Role};

/// An attribute of a primitive, or of a morph target of it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Semantic {
    /// The morph target that it belongs to.
    pub(super) target: Option<usize>,
    /// As in the file, such as `TEXCOORD_0`.
    pub(super) name: String,
}

/// Attributes that come in sets, with the names of their layers.
const SETS: [(&str, &str); 4] =
    [("TEXCOORD_", "texcoord"), ("COLOR_", "color"), ("JOINTS_", "joints"), ("WEIGHTS_", "weights")];

impl Semantic {
    pub(super) fn of(name: &str) -> Self {
        Semantic { target: None, name: name.to_owned() }
    }

    pub(super) fn of_target(self, target: usize) -> Self {
        Semantic { target: Some(target), ..self }
    }

    /// Whether it is where vertices are, not how far a morph target moves them.
    pub(super) fn is_position(&self) -> bool {
        self.target.is_none() && self.name == "POSITION"
    }

    /// The set that it is of, with the name of its layer.
    fn set(&self) -> Option<(&'static str, u8)> {
        SETS.iter().find_map(|&(prefix, layer)| Some((layer, self.name.strip_prefix(prefix)?.parse().ok()?)))
    }

    /// The name of its layer.
    pub(super) fn layer_name(&self) -> String {
        match (self.target, self.name.as_str(), self.set()) {
            (Some(target), name, _) => format!("target.{target}.{name}"),
            (None, _, Some((layer, 0))) => layer.to_owned(),
            (None, _, Some((layer, set))) => format!("{layer}_{set}"),
            (None, "NORMAL", _) => "normal".to_owned(),
            (None, "TANGENT", _) => "tangent".to_owned(),
            (None, name, _) => name.to_owned(),
        }
    }

    /// The role of its layer.
    pub(super) fn role(&self) -> Role {
        if let Some(target) = self.target {
            let Ok(target) = u16::try_from(target) else { return Role::Plain };
            return match self.name.as_str() {
                "POSITION" => Role::MorphPosition(target),
                "NORMAL" => Role::MorphNormal(target),
                "TANGENT" => Role::MorphTangent(target),
                _ => Role::Plain,
            };
        }
        match (self.name.as_str(), self.set()) {
            ("NORMAL", _) => Role::Normal,
            ("TANGENT", _) => Role::Tangent,
            (_, Some(("texcoord", _))) => Role::TexCoord,
            (_, Some(("color", _))) => Role::Color,
            (_, Some(("joints", set))) => Role::Joints(set),
            (_, Some(("weights", set))) => Role::Weights(set),
            _ => Role::Plain,
        }
    }

    /// What created vertices get: the joints and weights of one vertex, as those of several can't be mixed one by one; a
    /// mean of numbers that measure something.
    pub(super) fn carry(&self) -> Carry {
        match self.role() {
            Role::Joints(_) | Role::Weights(_) => Carry::Copy,
            _ => Carry::Interpolate,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_attribute_has_a_layer_of_its_own() {
        let known = [
            ("NORMAL", "normal", Role::Normal),
            ("TANGENT", "tangent", Role::Tangent),
            ("TEXCOORD_0", "texcoord", Role::TexCoord),
            ("TEXCOORD_12", "texcoord_12", Role::TexCoord),
            ("COLOR_0", "color", Role::Color),
            ("JOINTS_1", "joints_1", Role::Joints(1)),
            ("WEIGHTS_0", "weights", Role::Weights(0)),
            ("_FEATURE_ID_0", "_FEATURE_ID_0", Role::Plain),
            ("TEXCOORD_x", "TEXCOORD_x", Role::Plain),
        ];
        for (name, layer, role) in known {
            let semantic = Semantic::of(name);
            assert_eq!((semantic.layer_name(), semantic.role()), (layer.to_owned(), role));
        }
        let moved = Semantic::of("POSITION").of_target(2);
        assert_eq!((moved.layer_name(), moved.role()), ("target.2.POSITION".into(), Role::MorphPosition(2)));
        assert!(!moved.is_position() && Semantic::of("POSITION").is_position());
        assert_eq!(Semantic::of("TEXCOORD_0").of_target(1).role(), Role::Plain);
        assert_eq!(Semantic::of("JOINTS_0").carry(), Carry::Copy);
        assert_eq!(Semantic::of("NORMAL").of_target(70_000).role(), Role::Plain);
    }
}
