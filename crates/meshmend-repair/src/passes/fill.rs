//! Closes holes with faces over their vertices, and says of each boundary loop what became of it.
//!
//! *Why*: scans and exports have holes where nothing was seen or something was lost, and slicers and solvers need closed
//! surfaces. Which loop is a hole is judged by the surface: the outer border of a sheet is none.
//!
//! 1. Find the boundary loops with their figures. Rims of sheets are left (policy), and so are the loops of what has no side,
//!    of single faces, and those beyond the limits.
//! 2. Fill each of the others: with the triangles over its vertices that fold least ([`meshmend_spatial::best_fill`]), that
//!    have the least area, or with a fan round a new vertex. Where no triangles are admissible, a fan it is.
//! 3. A fill that would cross a face, another fill or itself is not made (policy), and the loop is left with that as its reason.
//!    This is decided exactly.
//! 4. What is filled changes what the other loops are measured by. So they are judged again, until none is filled.
//!
//! New faces have no source. They have the name that most faces round the loop have; a new corner has the value of both corners
//! beside it, if these are the same to the bit; numbers of faces are not given.
//!
//! *Promises* that each loop is filled or has a reason. *Requires* nothing; it leaves what is not simple. *May introduce* no
//! defect. *Cost*: that of the fills, and O(n log n) a round with what it takes to compare faces whose boxes overlap.

use meshmend_core::{CornerId, Defect, DefectKind, PolygonMesh, Provenance};
use serde::{Deserialize, Serialize};

use crate::{Context, Form, OptionValues, Outcome, Pass, PassError, PassKind, PassOption, PassRow, Word};

mod borders;
mod built;
mod crossing;
mod filling;
mod hole;
mod judging;
mod limits;
mod places;
mod record;

pub use limits::{FillLimits, FillLoops, Reach};
pub use record::{Crossed, FillCrossing, FillShape, LeftOpen, LoopFate, LoopRecord};

/// Closes holes with faces over their vertices.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
pub struct Fill {
    /// Which holes are filled.
    pub loops: FillLoops,
    /// What with.
    pub by: FillWith,
    /// What happens to the outer borders of sheets.
    pub rims: FillRims,
    /// What happens to fills that cross what is there.
    pub crossing: CrossingFills,
}

/// What happens to fills that cross what is there, another fill, or themselves.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum CrossingFills {
    /// They are not made.
    #[default]
    Leave,
    /// They are made, and what they cross is named.
    Keep,
}

/// What holes are filled with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum FillWith {
    /// Triangles that fold least against each other and against what is round the hole, and of these those of least area.
    #[default]
    Fold,
    /// Triangles of least area.
    Area,
    /// Triangles round a new vertex in the middle.
    Fan,
}

/// What happens to the outer borders of sheets.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum FillRims {
    /// They stay open.
    #[default]
    Leave,
    /// They are filled like holes.
    Take,
}

/// All that is said of the pass.
pub(crate) const ROW: PassRow = PassRow {
    name: "fill",
    explanation: "Closes holes: each gets the triangles over its vertices that fold least, against each other and against the faces \
                  round it. The outer border of a sheet is not a hole and stays open unless asked for, and so do loops beyond the \
                  limits. Each boundary loop is named with its figures and with what became of it.",
    is_default: false,
    before: None,
    options: &[
        PassOption {
            name: "fill",
            help: "Which holes are filled: all, or those within limits, such as edges:12,length:5%,area:0.5. A percentage is one of \
               the diagonal of the component's bounding box, and for an area of that squared in the square; all limits have to hold",
            sets: &["loops"],
            values: OptionValues::Limits,
        },
        PassOption {
            name: "fill-by",
            help: "What holes are filled with",
            sets: &["by"],
            values: OptionValues::Words(&[
                Word::new("fold", "The triangles that fold least"),
                Word::new("area", "The triangles of least area"),
                Word::new("fan", "Triangles round a new vertex"),
            ]),
        },
        PassOption {
            name: "fill-rims",
            help: "Fill the outer borders of sheets too",
            sets: &["rims"],
            values: OptionValues::Flag("take"),
        },
        PassOption {
            name: "fill-crossing",
            help: "What happens to fills that would cross a face or another fill",
            sets: &["crossing"],
            values: OptionValues::Words(&[
                Word::new("leave", "They are not made"),
                Word::new("keep", "They are made, and what they cross is named"),
            ]),
        },
    ],
    form: Form::of::<Fill>(),
};

impl Pass for Fill {
    fn kind(&self) -> PassKind {
        PassKind::Fill
    }
    fn may_introduce(&self) -> &'static [DefectKind] {
        &[]
    }

    fn apply(&self, mesh: &PolygonMesh, context: &Context<'_>) -> Result<Outcome, PassError> {
        let mut now = mesh.clone();
        let mut provenance = Provenance::same(mesh.counts());
        let mut loops: Vec<LoopRecord> = Vec::new();
        let mut fixed = Vec::new();
        loop {
            context.check_cancelled()?;
            let judged = judging::judged(self, &now, context)?;
            let filled = filling::filled(self, &now, &judged, context)?;
            loops.extend(filled.records.into_iter().filter(|row| filled.mesh.is_none() || row.is_filled()));
            let Some((next, step)) = filled.mesh else { break };
            context.check_cancelled()?;
            fixed.extend(filled.closed.iter().map(|&side| closed_edge(mesh, side)));
            provenance = provenance.then(&step, mesh.faces(), next.faces());
            now = next;
        }
        loops.sort_by_key(|row| row.first_vertex);
        if provenance.is_same() {
            return Ok(Outcome { loops, ..Outcome::unchanged(mesh) });
        }
        Ok(Outcome { loops, ..Outcome::changed((now, provenance), fixed) })
    }
}

/// A boundary edge that was closed, by its id before the pass: sides that were there are the first ones after any round too.
fn closed_edge(mesh: &PolygonMesh, side: CornerId) -> Defect {
    let edges = mesh.complex().edges();
    let edge = edges.corner_edge(side);
    Defect::boundary_edge(edge, edges.ends(edge))
}
