//! Why a repair would leave no face of a mesh that has some.

use std::fmt;

use meshmend_core::{DefectKind, FaceId, PolygonMesh, distinct_count};
use serde::{Deserialize, Serialize};

use crate::{
    AnyPass, Distance, DropParts, Duplicates, Internal, NonFinite, PassKind, Repaired, SmallComponents,
};

/// What happens when a repair would leave no face of a mesh that has some.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Emptying {
    /// It gives up, and says why each face would go.
    #[default]
    Refuse,
    /// It gives the mesh without a face.
    Allow,
}

/// No face would be left of a mesh that has some.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Emptied {
    /// How many faces there were.
    pub faces: usize,
    /// Why they would go, by pass and reason; never empty.
    pub causes: Vec<EmptyingCause>,
}

/// Why some of the faces would go.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EmptyingCause {
    /// The pass that removes them.
    pub pass: PassKind,
    /// What is wrong with them.
    pub reason: DefectKind,
    /// The option that makes it so, as the command line spells it. Absent for faces that are degenerate as stored.
    pub option: Option<String>,
    /// How many faces.
    pub count: usize,
}

impl std::error::Error for Emptied {}

impl fmt::Display for Emptied {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let causes: Vec<String> = self.causes.iter().map(EmptyingCause::to_string).collect();
        let faces =
            if self.faces == 1 { "the only face".to_owned() } else { format!("all {} faces", self.faces) };
        write!(f, "the repair would remove {faces}: {}", causes.join("; "))
    }
}

impl fmt::Display for EmptyingCause {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.reason.title(), self.count)?;
        match &self.option {
            Some(option) => write!(f, ", because of {option}"),
            None if self.pass.is_own() => write!(f, ", by {}", self.pass),
            None => write!(f, ", as stored"),
        }
    }
}

impl Emptied {
    /// Why passes removed all faces of a mesh.
    pub(crate) fn by(passes: &[AnyPass], stored: &PolygonMesh, repaired: &Repaired) -> Self {
        let mut causes: Vec<EmptyingCause> = Vec::new();
        for removed in &repaired.removed_faces {
            let (pass, reason) = (removed.pass, removed.reason);
            let option = option_behind(passes, stored, removed.face, reason);
            let option = option.map(|option| option + after_rounding(repaired));
            let same = |cause: &&mut EmptyingCause| {
                (cause.pass, cause.reason, &cause.option) == (pass, reason, &option)
            };
            match causes.iter_mut().find(same) {
                Some(cause) => cause.count += 1,
                None => causes.push(EmptyingCause { pass, reason, option, count: 1 }),
            }
        }
        Emptied { faces: stored.counts().faces, causes }
    }
}

/// What else is behind an option where rounding to single precision emptied faces.
fn after_rounding(repaired: &Repaired) -> &'static str {
    match repaired.rounding {
        Some(rounding) if rounding.emptied > 0 => {
            " after rounding to single precision, which --encoding ascii spares"
        }
        _ => "",
    }
}

/// The option because of which a face goes for a reason.
fn option_behind(
    passes: &[AnyPass],
    stored: &PolygonMesh,
    face: FaceId,
    reason: DefectKind,
) -> Option<String> {
    match reason {
        DefectKind::DegenerateFace if distinct_count(stored.faces().face_vertices(face)) < 3 => None,
        DefectKind::DegenerateFace => passes.iter().find_map(|pass| match pass {
            AnyPass::Weld(weld) => Some(weld_option(weld.distance)),
            _ => None,
        }),
        DefectKind::NonFiniteFace => passes.iter().find_map(|pass| match pass {
            AnyPass::Clean(clean) if clean.non_finite == NonFinite::Drop => {
                Some("--non-finite drop".to_owned())
            }
            _ => None,
        }),
        DefectKind::SmallComponent => passes.iter().find_map(|pass| match pass {
            AnyPass::DropParts(drop) => drop_option(drop.components),
            _ => None,
        }),
        DefectKind::InternalFace => passes.iter().find_map(|pass| match pass {
            AnyPass::DropParts(DropParts { internal: Internal::RemoveFaces, .. }) => {
                Some("--internal remove-faces".to_owned())
            }
            AnyPass::DropParts(_) => Some("--internal remove-components".to_owned()),
            _ => None,
        }),
        DefectKind::OppositeFace => passes.iter().find_map(|pass| match pass {
            AnyPass::Orient(orient) => match orient.duplicates {
                Duplicates::RemovePair => Some("--duplicates remove-pair".to_owned()),
                Duplicates::KeepFirst => Some("--duplicates keep-first".to_owned()),
                Duplicates::Keep => None,
            },
            _ => None,
        }),
        _ => None,
    }
}

fn drop_option(components: SmallComponents) -> Option<String> {
    let limit = match components {
        SmallComponents::Keep => return None,
        SmallComponents::Faces(count) => format!("faces:{count}"),
        SmallComponents::Area(area) => format!("area:{area}"),
        SmallComponents::Volume(volume) => format!("volume:{volume}"),
    };
    Some(format!("--drop-components {limit}"))
}

fn weld_option(distance: Distance) -> String {
    match distance {
        Distance::Exact => "--weld exact".to_owned(),
        Distance::Single => "--weld single".to_owned(),
        Distance::Absolute(length) => format!("--weld {length}"),
        Distance::Relative(part) => format!("--weld {}%", part * 100.0),
        Distance::Boundary(length) => format!("--weld boundary:{length}"),
        Distance::BoundaryRelative(part) => format!("--weld boundary:{}%", part * 100.0),
        Distance::Auto => "--weld auto".to_owned(),
    }
}
