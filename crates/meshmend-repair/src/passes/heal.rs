//! Puts vertices that lie on open edges into the faces there, so that the surface closes.
//!
//! *Why*: where one part of a surface is finer than the part beside it, vertices of the one lie on edges of the other. The
//! surface looks closed there and is open: light comes through, and every slicer sees a gap. Welding can't close it, as the
//! vertices have no partner.
//!
//! 1. Find the boundary vertices on boundary edges of other faces, exactly on them or within a distance.
//! 2. Those along which both boundaries run become corners of the faces, where after that exactly two sides run along each
//!    new edge. [`meshmend_spatial::heal`] decides that, in rounds, until one changes nothing.
//! 3. Corner values at a new corner are those of the side at the vertex's foot, by the rule of each layer; names are copied.
//!
//! No vertex moves, and no face is added or removed. In a pipeline `orient` and this pass then take turns until nothing is
//! healed: faces that are neighbours now may run against each other, and of faces that repeat each other one may go.
//!
//! *Promises* that each T-junction is healed or has a reason. *Requires* nothing. *May introduce* what joining sides does:
//! inconsistent edges, and polygons among triangles, which `triangulate` cuts again. Where several vertices share a place, as
//! nothing welded them, sides that meet there may have different ones: pinched vertices, which `split` takes apart. *Cost*: O(n log n + pairs) a round.

use meshmend_core::{
    Blend, CornerId, DefectKind, Draft, FaceId, FaceTableBuilder, PolygonMesh, Provenance, Sources, VertexId,
};
use meshmend_spatial::{Healed, HealedCorner, heal};
use serde::{Deserialize, Serialize};

use crate::tolerance::resolved_on;
use crate::{Context, Distance, Form, OptionValues, Outcome, Pass, PassError, PassKind, PassOption, PassRow};

mod record;

pub use record::{TJunctionFate, TJunctionRecord};

/// Puts vertices that lie on open edges into the faces there.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
pub struct Heal {
    /// Which vertices lie on an edge.
    pub within: HealWithin,
}

/// Which vertices lie on an edge.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum HealWithin {
    /// Those exactly on it.
    #[default]
    Exact,
    /// Those not farther from it than so many units of length.
    Absolute(f64),
    /// The same, in parts of the diagonal of the bounding box of all vertices that faces use.
    Relative(f64),
}

/// All that is said of the pass.
pub(crate) const ROW: PassRow = PassRow {
    name: "heal",
    explanation: "Puts boundary vertices that lie on boundary edges of other faces into these faces, so that the surface closes \
                  there. No vertex moves. Each T-junction is healed or named with the reason. In a pipeline it takes turns with \
                  orient until nothing is healed.",
    is_default: false,
    before: None,
    options: &[PassOption {
        name: "heal",
        help: "Which vertices on open edges become corners of the faces there: exact, or those within a length or a percentage of \
               the bounding box's diagonal",
        sets: &["within"],
        values: OptionValues::Distance,
    }],
    form: Form::of::<Heal>(),
};

impl Pass for Heal {
    fn kind(&self) -> PassKind {
        PassKind::Heal
    }
    fn may_introduce(&self) -> &'static [DefectKind] {
        &[
            DefectKind::InconsistentEdge,
            DefectKind::NonOrientablePatch,
            DefectKind::DuplicateFace,
            DefectKind::OppositeFace,
            DefectKind::PolygonFace,
            DefectKind::PinchedVertex,
        ]
    }

    fn apply(&self, mesh: &PolygonMesh, context: &Context<'_>) -> Result<Outcome, PassError> {
        let healed = heal(mesh, resolved_on(ROW.name, mesh, self.within.distance())?, context.watch())?;
        context.check_cancelled()?;
        let t_junctions = record::of(mesh, &healed);
        if healed.faces.is_empty() {
            return Ok(Outcome { t_junctions, ..Outcome::unchanged(mesh) });
        }
        let fixed: Vec<_> = healed.insertions.iter().map(|put_in| put_in.junction().defect(mesh)).collect();
        Ok(Outcome { t_junctions, ..Outcome::changed(with_corners(mesh, &healed)?, fixed) })
    }
}

impl HealWithin {
    fn distance(self) -> Distance {
        match self {
            HealWithin::Exact => Distance::Exact,
            HealWithin::Absolute(length) => Distance::Absolute(length),
            HealWithin::Relative(part) => Distance::Relative(part),
        }
    }
}

/// The mesh whose faces have the new corners.
fn with_corners(mesh: &PolygonMesh, healed: &Healed) -> Result<(PolygonMesh, Provenance), PassError> {
    let faces = mesh.faces();
    let mut builder = FaceTableBuilder::default();
    let mut sources = Vec::with_capacity(faces.corner_count() + healed.insertions.len());
    let mut created = Vec::with_capacity(healed.insertions.len());
    let mut changed = healed.faces.iter().peekable();
    for face in faces.faces() {
        match changed.next_if(|(other, _)| *other == face) {
            None => {
                builder.push_face(faces.face_vertices(face).iter().copied());
                sources.extend(faces.face_corners(face).map(Some));
            }
            Some((_, corners)) => {
                for corner in whole_face(mesh, face, corners) {
                    let new = CornerId(sources.len() as u32);
                    let (vertex, source) = match corner {
                        Whole::Kept(corner) => (faces.corner_vertex(corner), Some(corner)),
                        Whole::New(vertex, place) => {
                            created.extend(place.map(|place| (new, place)));
                            (vertex, None)
                        }
                    };
                    builder.push_corner(vertex);
                    sources.push(source);
                }
                builder.end_face();
            }
        }
    }
    let table = builder.build(mesh.counts().vertices)?;
    let draft = Draft {
        created_corners: created,
        ..Draft::of_faces(mesh, table, Sources::same(faces.face_count()), Sources::listed(sources))
    };
    Ok(mesh.rebuild(draft)?)
}

/// A corner of a face with new corners.
enum Whole {
    Kept(CornerId),
    New(VertexId, Option<Blend>),
}

/// All corners of a face: those that it had, with repeated ones, which healing does not see, and the new ones.
fn whole_face(mesh: &PolygonMesh, face: FaceId, corners: &[HealedCorner]) -> Vec<Whole> {
    let faces = mesh.faces();
    let place = |corner: CornerId| mesh.position(faces.corner_vertex(corner));
    let mut whole = Vec::new();
    let mut next = 0;
    let mut last = None;
    for corner in faces.face_corners(face) {
        // A repeated corner belongs to the one before it, but for those at the end that repeat the first one.
        let repeats_last = last.is_some_and(|last| place(last) == place(corner));
        if !repeats_last || corners.get(next) == Some(&HealedCorner::Kept(corner)) {
            push_new(corners, &mut next, &mut whole);
        }
        if corners.get(next) == Some(&HealedCorner::Kept(corner)) {
            next += 1;
            last = Some(corner);
        }
        whole.push(Whole::Kept(corner));
    }
    push_new(corners, &mut next, &mut whole);
    whole
}

/// Adds the new corners that come next.
fn push_new(corners: &[HealedCorner], next: &mut usize, whole: &mut Vec<Whole>) {
    while let Some(&HealedCorner::New { vertex, share }) = corners.get(*next) {
        whole.push(Whole::New(vertex, between(corners, *next, share)));
        *next += 1;
    }
}

/// Where a new corner lies: on the way from the last kept corner before it to the next one.
fn between(corners: &[HealedCorner], at: usize, share: f64) -> Option<Blend> {
    let kept = |corner: &HealedCorner| match *corner {
        HealedCorner::Kept(corner) => Some(corner),
        HealedCorner::New { .. } => None,
    };
    let from = corners[..at].iter().rev().find_map(kept)?;
    let to = corners[at..].iter().chain(corners).find_map(kept)?;
    let (numerator, denominator) = fraction(share);
    Some(Blend::Along { from, to, numerator, denominator })
}

/// A part of a whole from 0 to 1 in whole parts, to nine digits; exact where a small power of two is the denominator.
fn fraction(share: f64) -> (u32, u32) {
    const PARTS: u32 = 1 << 31;
    let numerator = (share * f64::from(PARTS)).round() as u32;
    let common = numerator.trailing_zeros().min(PARTS.trailing_zeros());
    (numerator >> common, PARTS >> common)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_share_is_the_simplest_fraction() {
        assert_eq!([0.75, 0.5, 0.0, 1.0].map(fraction), [(3, 4), (1, 2), (0, 1), (1, 1)]);
        let (numerator, denominator) = fraction(1.0 / 3.0);
        assert!((f64::from(numerator) / f64::from(denominator) - 1.0 / 3.0).abs() < 1e-9);
    }
}
