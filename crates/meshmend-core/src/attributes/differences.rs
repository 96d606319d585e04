//! In what two faces over the same vertices differ, so that one is more than a repeat of the other.

use std::fmt;

use crate::{Domain, Layer, Role};

/// Something that tells a face from another one over the same vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Aspect {
    /// What the face is made of.
    Material,
    /// The object that it belongs to.
    Object,
    /// The group that it belongs to.
    Group,
    /// The solid that it belongs to.
    Solid,
    /// The part that it belongs to.
    Part,
    /// The colour of the face as a whole; the attribute bytes of STL count as one.
    FaceColor,
    /// The colour of a corner or of its vertex.
    Color,
    /// The texture coordinates of a corner or of its vertex.
    TexCoord,
}

impl Aspect {
    /// Every aspect, in the order in which they are named.
    pub const ALL: [Aspect; 8] = [
        Aspect::Material,
        Aspect::Object,
        Aspect::Group,
        Aspect::Solid,
        Aspect::Part,
        Aspect::FaceColor,
        Aspect::Color,
        Aspect::TexCoord,
    ];

    /// Its name in reports.
    pub fn name(self) -> &'static str {
        match self {
            Aspect::Material => "material",
            Aspect::Object => "object",
            Aspect::Group => "group",
            Aspect::Solid => "solid",
            Aspect::Part => "part",
            Aspect::FaceColor => "face color",
            Aspect::Color => "color",
            Aspect::TexCoord => "texcoord",
        }
    }

    /// What a layer says of faces, if it counts: by its role, or else by what readers call it.
    pub fn of_layer(layer: &Layer) -> Option<Aspect> {
        match (layer.role(), layer.home()) {
            (Role::TexCoord, _) => return Some(Aspect::TexCoord),
            (Role::Color, Domain::Face) => return Some(Aspect::FaceColor),
            (Role::Color, _) => return Some(Aspect::Color),
            _ => {}
        }
        match (layer.home(), layer.name()) {
            (Domain::Face, "material" | "material_index" | "material_indices" | "texnumber") => {
                Some(Aspect::Material)
            }
            (Domain::Face, "object") => Some(Aspect::Object),
            (Domain::Face, "group") => Some(Aspect::Group),
            (Domain::Face, "solid") => Some(Aspect::Solid),
            (Domain::Face, "part") => Some(Aspect::Part),
            (Domain::Face, "color" | "attribute") => Some(Aspect::FaceColor),
            (Domain::Vertex | Domain::Corner, "color") => Some(Aspect::Color),
            (Domain::Vertex | Domain::Corner | Domain::Face, "texcoord") => Some(Aspect::TexCoord),
            _ => None,
        }
    }
}

/// A set of aspects.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Differences(u8);

impl Differences {
    /// Adds an aspect to the set.
    pub fn add(&mut self, aspect: Aspect) {
        self.0 |= 1 << aspect as u8;
    }

    /// Whether there is none.
    pub fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// The aspects, in order.
    pub fn iter(self) -> impl Iterator<Item = Aspect> {
        Aspect::ALL.into_iter().filter(move |&aspect| self.0 & 1 << aspect as u8 != 0)
    }
}

impl FromIterator<Aspect> for Differences {
    fn from_iter<I: IntoIterator<Item = Aspect>>(aspects: I) -> Self {
        let mut differences = Differences::default();
        aspects.into_iter().for_each(|aspect| differences.add(aspect));
        differences
    }
}

impl fmt::Display for Differences {
    /// `material, object and texcoord`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names: Vec<&str> = self.iter().map(Aspect::name).collect();
        match names.split_last() {
            Some((last, [])) => f.write_str(last),
            Some((last, others)) => write!(f, "{} and {last}", others.join(", ")),
            None => f.write_str("nothing"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Carry, Values};

    #[test]
    fn a_set_is_named_in_order() {
        let set = |aspects: &[Aspect]| aspects.iter().copied().collect::<Differences>();
        assert_eq!(set(&[]).to_string(), "nothing");
        assert_eq!(set(&[Aspect::Color]).to_string(), "color");
        assert_eq!(set(&[Aspect::TexCoord, Aspect::Material]).to_string(), "material and texcoord");
        assert_eq!(set(&Aspect::ALL).iter().collect::<Vec<_>>(), Aspect::ALL);
        let two = set(&[Aspect::FaceColor, Aspect::Object, Aspect::Object]);
        assert!(set(&[]).is_empty() && !two.is_empty());
    }

    #[test]
    fn layers_that_count_are_known_by_name_and_by_what_they_are_of() {
        let aspect = |name: &str, domain| {
            Aspect::of_layer(&Layer::direct(name, domain, 1, Carry::Copy, Values::U8(Vec::new())))
        };
        assert_eq!(aspect("material", Domain::Face), Some(Aspect::Material));
        assert_eq!(aspect("attribute", Domain::Face), Some(Aspect::FaceColor));
        assert_eq!(aspect("color", Domain::Vertex), Some(Aspect::Color));
        assert_eq!(aspect("texcoord", Domain::Corner), Some(Aspect::TexCoord));
        for (name, domain) in [
            ("material", Domain::Vertex),
            ("normal", Domain::Corner),
            ("smoothing", Domain::Face),
            ("quality", Domain::Face),
        ] {
            assert_eq!(aspect(name, domain), None, "{name}");
        }
        let with_role = |name: &str, domain, role| {
            let layer = Layer::direct(name, domain, 1, Carry::Copy, Values::U8(Vec::new()));
            Aspect::of_layer(&layer.with_role(role))
        };
        assert_eq!(with_role("TEXCOORD_1", Domain::Vertex, Role::TexCoord), Some(Aspect::TexCoord));
        assert_eq!(with_role("tint", Domain::Face, Role::Color), Some(Aspect::FaceColor));
        assert_eq!(with_role("tint", Domain::Corner, Role::Color), Some(Aspect::Color));
    }
}
