//! What can be asked of `orient`.

use meshmend_core::FlippedNormals;
use serde::{Deserialize, Serialize};

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
