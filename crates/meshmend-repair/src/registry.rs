//! All passes, by name: a pass is one file and one line here.

use std::fmt;

use serde::{Deserialize, Serialize};

use crate::{Clean, Compact, Orient, Pass, Recompute, Split, Triangulate, Weld};

macro_rules! passes {
    ($($variant:ident $name:literal $explanation:literal)*) => {
        /// Which pass, without its options.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
        #[serde(rename_all = "kebab-case")]
        pub enum PassKind {
            $(#[doc = concat!("The pass `", $name, "`.")] $variant,)*
        }

        /// A pass with its options.
        #[derive(Clone, Debug, PartialEq)]
        pub enum AnyPass {
            $(#[doc = concat!("The pass `", $name, "`.")] $variant($variant),)*
        }

        impl PassKind {
            /// Every pass, in the order of the default pipeline.
            pub const ALL: &'static [Self] = &[$(PassKind::$variant,)*];

            /// The pass's name.
            pub fn name(self) -> &'static str {
                match self { $(PassKind::$variant => $name,)* }
            }

            /// What it does, why and how.
            pub fn explanation(self) -> &'static str {
                match self { $(PassKind::$variant => $explanation,)* }
            }

            /// The pass with its default options.
            pub fn with_defaults(self) -> AnyPass {
                match self { $(PassKind::$variant => AnyPass::$variant($variant::default()),)* }
            }
        }

        impl AnyPass {
            /// Which pass it is.
            pub fn kind(&self) -> PassKind {
                match self { $(AnyPass::$variant(_) => PassKind::$variant,)* }
            }

            /// The pass itself.
            pub fn as_pass(&self) -> &dyn Pass {
                match self { $(AnyPass::$variant(pass) => pass,)* }
            }
        }

        $(impl From<$variant> for AnyPass {
            fn from(pass: $variant) -> Self {
                AnyPass::$variant(pass)
            }
        })*
    };
}

passes! {
    Weld "weld"
        "Joins vertices at the same position (exact), or within a tolerance, to the lowest of them. Attributes that \
         differ across welded vertices move to the corners; none is averaged. In a pipeline orient and split keep \
         apart again what would leave the mesh non-manifold, so that welding is stitching and can't make a mesh \
         worse."
    Clean "clean"
        "Removes faces with non-finite corners, folds repeated corners and spikes away, splits faces that come back \
         to a vertex, removes degenerate faces, and of faces that are the same as stored keeps the first."
    Orient "orient"
        "Turns faces so that neighbours agree, each patch to the side that most of its faces have (or outward), \
         and drops patches each of whose faces is doubled in another patch. Patches without a consistent side are \
         named with a witness."
    Split "split"
        "Takes the mesh apart until it is manifold, and no further: sides at edges with three faces or more are paired \
         into sheets by their order round the edge, and each umbrella of faces gets a vertex of its own. No face is \
         removed."
    Triangulate "triangulate"
        "Cuts faces into triangles by shape, never repeating an edge that is there: those that are no longer \
         triangles if all were as stored (auto), or every face."
    Compact "compact"
        "Removes unreferenced vertices, loose edges and loose points, keeps the order of the rest, and lists what \
         went."
    Recompute "recompute"
        "Changes nothing: analyses the result afresh and checks the promises of the passes before it."
}

impl PassKind {
    /// The pass with a name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|kind| kind.name() == name)
    }
}

impl fmt::Display for PassKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pass_has_one_name_everywhere() {
        for &kind in PassKind::ALL {
            let pass = kind.with_defaults();
            assert_eq!((pass.kind(), pass.as_pass().name()), (kind, kind.name()));
            assert_eq!(
                (PassKind::from_name(kind.name()), kind.to_string().as_str()),
                (Some(kind), kind.name())
            );
        }
        assert_eq!(PassKind::from_name("mend"), None);
    }
}
