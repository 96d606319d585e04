//! Joins vertices that are in the same place.
//!
//! *Why*: files without shared vertices (STL) fall apart into single triangles, and exporters split vertices along
//! seams of texture or normals.
//!
//! *Exact* (default): positions equal as numbers: −0 equals 0, and what is not finite equals nothing.
//! *Tolerance ε*: the connected components of "distance ≤ ε", so no pair within ε is missed.
//!
//! 1. Find the classes.
//! 2. Each class becomes its lowest vertex, whose position is kept to the bit. Attributes that differ across
//!    welded vertices move to the corners; none is averaged or dropped.
//!
//! *Promises* no coincident vertices. *Requires* nothing. *May introduce* degenerate faces, duplicates and
//! non-manifold edges and vertices: in a pipeline `orient` and `split` keep apart again what would leave the mesh
//! non-manifold, so that there welding is stitching and can't make a mesh worse. *Cost*: linear where exact; see the
//! grid for tolerance.

use meshmend_core::{DefectKind, Draft, Id, PolygonMesh, Sources, VertexId};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::{Context, Mended, Outcome, Pass, PassError, coincident_vertices, near};

/// Joins vertices that are in the same place.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
pub struct Weld {
    /// When two vertices are in the same place.
    pub distance: Distance,
}

/// When two vertices are in the same place.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Distance {
    /// When their positions are equal as numbers.
    #[default]
    Exact,
    /// When a chain of vertices joins them, each within so many units of length of the next.
    Absolute(f64),
    /// The same, in parts of the bounding box's diagonal: 0.001 is a thousandth of it.
    Relative(f64),
}

impl Pass for Weld {
    fn name(&self) -> &'static str {
        "weld"
    }
    fn removes(&self) -> &'static [DefectKind] {
        &[DefectKind::CoincidentVertex]
    }
    fn requires(&self) -> &'static [DefectKind] {
        &[]
    }
    fn may_introduce(&self) -> &'static [DefectKind] {
        &[
            DefectKind::DegenerateFace,
            DefectKind::NonSimpleFace,
            DefectKind::RepeatedCorner,
            DefectKind::DuplicateFace,
            DefectKind::OppositeFace,
            DefectKind::NonManifoldEdge,
            DefectKind::InconsistentEdge,
            DefectKind::PinchedVertex,
            DefectKind::SingularVertex,
            DefectKind::NonOrientablePatch,
            DefectKind::BoundaryEdge,
            // The vertices of faces that become degenerate.
            DefectKind::UnreferencedVertex,
        ]
    }

    fn apply(&self, mesh: &PolygonMesh, context: &Context<'_>) -> Result<Outcome, PassError> {
        let lowest = match self.distance {
            Distance::Exact => coincident_vertices(mesh),
            _ => within(mesh, self.tolerance_on(mesh), context)?,
        };
        join_to(mesh, lowest)
    }
}

impl Weld {
    /// How far apart vertices of a mesh may be that are joined; 0 if only those in one place are.
    ///
    /// *Cost*: linear where the distance is relative, else constant.
    pub fn tolerance_on(&self, mesh: &PolygonMesh) -> f64 {
        match self.distance {
            Distance::Exact => 0.0,
            Distance::Absolute(epsilon) => epsilon,
            Distance::Relative(part) => part * near::diagonal(mesh.positions()),
        }
    }
}

fn within(mesh: &PolygonMesh, epsilon: f64, context: &Context<'_>) -> Result<Vec<VertexId>, PassError> {
    if epsilon == 0.0 {
        Ok(coincident_vertices(mesh))
    } else if epsilon.is_finite() && epsilon > 0.0 {
        near::classes(mesh.positions(), epsilon, context)
    } else {
        Err(PassError::Request { pass: "weld", reason: format!("a tolerance of {epsilon} is no distance") })
    }
}

/// The mesh with each vertex replaced by the lowest one of its class.
fn join_to(mesh: &PolygonMesh, lowest: Vec<VertexId>) -> Result<Outcome, PassError> {
    let mended = Mended::joined(lowest);
    if mended.is_empty() {
        return Ok(Outcome::unchanged(mesh));
    }
    let lowest = mended.joined_to();
    let mut new_id = vec![VertexId(0); lowest.len()];
    let mut sources = Vec::with_capacity(lowest.len() - mended.len());
    for (v, &low) in lowest.iter().enumerate() {
        new_id[v] = if low.index() == v {
            sources.push(Some(low));
            VertexId::new(sources.len() - 1)
        } else {
            new_id[low.index()]
        };
    }
    let old = mesh.faces();
    let corners = old.corner_vertices().par_iter().map(|v| new_id[v.index()]).collect();
    let faces = old.over(sources.len(), corners)?;
    let draft = Draft {
        vertex_sources: Sources::listed(sources),
        merged_into: Some(new_id),
        ..Draft::of_faces(mesh, faces, Sources::same(old.face_count()), Sources::same(old.corner_count()))
    };
    Ok(Outcome::changed(mesh.rebuild(draft)?, mended))
}
