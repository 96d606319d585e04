//! What can be asked of `orient`.

use meshmend_core::FlippedNormals;
use serde::{Deserialize, Serialize};

use crate::{Form, OptionValues, PassOption, PassRow, Word};

/// Turns faces so that neighbours agree, and drops patches that are there twice.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
pub struct Orient {
    /// Which of a patch's two consistent orientations is taken.
    pub side: Side,
    /// What happens to a patch that has no consistent orientation.
    pub non_orientable: NonOrientable,
    /// What happens to faces that are there once in each direction.
    pub duplicates: Duplicates,
    /// Whether the stored normals of a face turn with it.
    pub flipped_normals: FlippedNormals,
}

/// All that is said of the pass.
pub(crate) const ROW: PassRow = PassRow {
    name: "orient",
    explanation: "Turns faces so that neighbours agree, each patch to the side that most of its faces have (or outward), \
                  and drops patches each of whose faces is doubled in another patch. Patches without a consistent side are \
                  named with a witness.",
    is_default: true,
    before: None,
    options: &[
        PassOption {
            name: "orient",
            help: "Which side of a patch is the front",
            sets: &["side"],
            values: OptionValues::Words(&[
                Word::new("majority", "That of most of its faces"),
                Word::new("outward", "The outer one where the patch is closed"),
                Word::new(
                    "outward-nested",
                    "The same, but shells inside others alternate, as the walls of hollows do",
                ),
            ]),
        },
        PassOption {
            name: "non-orientable",
            help: "Patches that have no consistent side",
            sets: &["non-orientable"],
            values: OptionValues::Words(&[
                Word::new("report", "Leave them as they are, and name them"),
                Word::new("cut", "Cut them open along a seam"),
                Word::new("fail", "Give up"),
            ]),
        },
        PassOption {
            name: "duplicates",
            help: "Faces that are there once in each direction",
            sets: &["duplicates"],
            values: OptionValues::Words(&[
                Word::new("keep", "Keep both: a double-sided wall"),
                Word::new("remove-pair", "Remove as many of each direction as there are pairs"),
                Word::new("keep-first", "Keep the first of each group"),
            ]),
        },
        PassOption {
            name: "flipped-normals",
            help: "Stored normals of faces that are turned round",
            sets: &["flipped-normals"],
            values: OptionValues::Words(&[
                Word::new("negate", "Turn them too, and the handedness of tangents with them"),
                Word::new("keep", "Keep them"),
            ]),
        },
    ],
    form: Form::of::<Orient>(),
};

/// Which of a patch's two consistent orientations is taken.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Side {
    /// The one that flips fewer faces; on a tie the one that keeps the lowest face.
    #[default]
    Majority,
    /// For a closed patch the one with positive signed volume; any other patch goes by majority.
    Outward,
    /// The same, but a closed patch inside an odd number of others gets negative signed volume: nested shells
    /// alternate, as the walls of hollows do.
    OutwardNested,
}

/// What happens to a patch that has no consistent orientation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum NonOrientable {
    /// It is left as it is and named, with a witness.
    #[default]
    Report,
    /// It is oriented nevertheless, so that its faces clash along few edges. `split` opens that seam.
    Cut,
    /// The repair gives up.
    Fail,
}

/// What happens to faces that are there once in each direction.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Duplicates {
    /// They are kept and reported: a double-sided wall.
    #[default]
    Keep,
    /// As many of each direction are removed as there are pairs.
    RemovePair,
    /// The first face of each group is kept.
    KeepFirst,
}
