//! Cuts polygons into triangles without making an edge twice.
//!
//! *Why*: a mesh of triangles should stay one. If `clean` or `split` made a face larger, it is cut again. And some kernels
//! and formats hold only triangles.
//!
//! 1. Choose the faces: with `auto`, if all faces were triangles as stored, those that have more corners now; with `all`,
//!    every face of more than three corners.
//! 2. Cut each by shape: see [`meshmend_geometry::polygon`]. A diagonal never joins two places that an edge joins already.
//!    Such an edge would be non-manifold, or a triangle might be there twice, at the latest when the mesh is stored without
//!    indices.
//! 3. If every diagonal would, one gets a vertex of its own: in its middle or, if that is not free, at the first free point
//!    on it or beside it.
//!
//! *Promises* triangles wherever faces are simple. *Requires* simple faces: others stay and are named. *May introduce* no
//! defect. *Cost*: O(n³) for faces up to 64 corners, O(n²) up to 4096 and mostly n log n, O(n log n) beyond.

use meshmend_core::{Defect, DefectKind, FaceId, Id, PolygonMesh, distinct_count};
use meshmend_geometry::{FaceCutter, GatheredRoom};
use serde::{Deserialize, Serialize};

use crate::{
    Clearance, Context, Form, OptionValues, Outcome, Pass, PassError, PassKind, PassOption, PassRow, Word,
};
use meshmend_geometry::coincident::coincident_vertices;

/// Cuts polygons into triangles without making an edge twice.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
pub struct Triangulate {
    /// Which faces are cut.
    pub faces: TriangulateFaces,
}

/// Which faces are cut into triangles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum TriangulateFaces {
    /// Those that have more than three corners now, if all faces were triangles as stored.
    #[default]
    Auto,
    /// Every face of more than three corners.
    All,
}

/// All that is said of the pass.
pub(crate) const ROW: PassRow = PassRow {
    name: "triangulate",
    explanation: "Cuts faces into triangles by shape, never repeating an edge that is there: those that are no longer \
                  triangles if all were as stored (auto), or every face.",
    is_default: true,
    before: None,
    options: &[PassOption {
        name: "triangulate",
        help: "Which faces are cut into triangles; by default all of them where the output's format holds nothing else",
        sets: &["faces"],
        values: OptionValues::Words(&[
            Word::new("auto", "Those that were triangles before and are no longer, if all were"),
            Word::new("all", "All"),
        ]),
    }],
    form: Form::of::<Triangulate>(),
};

impl Pass for Triangulate {
    fn kind(&self) -> PassKind {
        PassKind::Triangulate
    }
    fn removes(&self) -> &'static [DefectKind] {
        match self.faces {
            TriangulateFaces::All => &[DefectKind::PolygonFace],
            TriangulateFaces::Auto => &[],
        }
    }
    fn requires(&self) -> &'static [DefectKind] {
        &[DefectKind::DegenerateFace, DefectKind::NonSimpleFace, DefectKind::RepeatedCorner]
    }
    fn may_introduce(&self) -> &'static [DefectKind] {
        &[]
    }

    fn apply(&self, mesh: &PolygonMesh, context: &Context<'_>) -> Result<Outcome, PassError> {
        let stored = context.history.map_or(mesh, |history| history.stored());
        let is_wanted = self.faces == TriangulateFaces::All || stored.faces().is_all_triangles();
        if !is_wanted || mesh.faces().is_all_triangles() {
            return Ok(Outcome::unchanged(mesh));
        }
        cut_all(mesh, context.clearance)
    }
}

/// Cuts every face of more than three corners that is simple.
fn cut_all(mesh: &PolygonMesh, clearance: Clearance) -> Result<Outcome, PassError> {
    let lowest = coincident_vertices(mesh);
    let mut cutter = FaceCutter::new(mesh, &lowest);
    let mut room = GatheredRoom::new(|| clearance.free_points(mesh));
    let (mut fixed, mut left) = (Vec::new(), Vec::new());
    for face in mesh.faces().faces() {
        let vertices = mesh.faces().face_vertices(face);
        let corners = vertices.len() as u32;
        if corners <= 3 {
            cutter.keep(face);
        } else if distinct_count(vertices) < vertices.len() {
            left.push(Defect::polygon_face(FaceId::new(cutter.face_count()), corners));
            cutter.keep(face);
        } else {
            fixed.push(Defect::polygon_face(face, corners));
            cutter.cut(face, &[(0..vertices.len()).collect()], &mut room);
        }
    }
    if fixed.is_empty() {
        return Ok(Outcome { left, ..Outcome::unchanged(mesh) });
    }
    let rebuilt = mesh.rebuild(cutter.into_draft()?)?;
    Ok(Outcome { left, ..Outcome::changed(rebuilt, fixed) })
}
