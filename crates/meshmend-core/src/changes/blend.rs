//! Where a created element lies.

use crate::{CornerId, FaceId, FaceTable, Sources};

/// Where a created element lies, in terms of the old mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum Blend {
    /// On the side between two neighbouring corners of a face: from + (to − from) · numerator / denominator.
    Along {
        /// The corner at which it would lie for numerator 0.
        #[cfg_attr(feature = "serde", serde(rename = "from_corner"))]
        from: CornerId,
        /// The corner at which it would lie for numerator = denominator.
        #[cfg_attr(feature = "serde", serde(rename = "to_corner"))]
        to: CornerId,
        /// How many parts of the way.
        numerator: u32,
        /// Of how many parts in all.
        denominator: u32,
    },
    /// Within a face, with the mean of its corners' attributes.
    Inside {
        /// The face.
        face: FaceId,
    },
}

impl Blend {
    /// The same place in terms of the mesh before an earlier change, where its elements existed there.
    pub(super) fn seen_from_before(
        self,
        corners: &Sources<CornerId>,
        faces: &Sources<FaceId>,
    ) -> Option<Blend> {
        Some(match self {
            Blend::Along { from, to, numerator, denominator } => {
                let (from, to) = (corners.of(from)?, corners.of(to)?);
                Blend::Along { from, to, numerator, denominator }
            }
            Blend::Inside { face } => Blend::Inside { face: faces.of(face)? },
        })
    }

    /// The corners that it lies between, with their weights.
    pub(super) fn parts(self, faces: &FaceTable) -> Vec<(CornerId, f64)> {
        match self {
            Blend::Along { from, to, numerator, denominator } => {
                let share = f64::from(numerator) / f64::from(denominator);
                vec![(from, 1.0 - share), (to, share)]
            }
            Blend::Inside { face } => {
                let corners = faces.face_corners(face);
                let share = 1.0 / corners.len() as f64;
                corners.map(|corner| (corner, share)).collect()
            }
        }
    }
}
