//! Patches without a consistent orientation: each gets a witness, or the repair gives up.

use meshmend_core::{Connectivity, CornerId, Defect, DefectKind, EdgeId, EdgeUse, FaceId, PolygonMesh};
use meshmend_topology::{OneSidedStrip, orientability, patches};

use super::options::NonOrientable;
use crate::{Context, Outcome, PassError, apart};

/// What the policy makes of patches without a consistent orientation.
///
/// `lowest` is a face of each of them in the new mesh. It is named if no strip is found, because a face is not simple.
///
/// # Errors
/// When the policy is to give up.
pub(super) fn judge(
    policy: NonOrientable,
    context: &Context<'_>,
    outcome: &Outcome,
    lowest: &[FaceId],
) -> Result<Vec<Defect>, PassError> {
    if policy == NonOrientable::Cut || lowest.is_empty() {
        return Ok(Vec::new());
    }
    let history = context.history.map(|h| h.extended(&outcome.provenance, &outcome.mesh));
    let context = Context { history: history.as_ref(), known: None, ..*context };
    let mut defects = one_sided_patches(&outcome.mesh, &context)?;
    if defects.is_empty() {
        defects = lowest.iter().map(|&face| Defect::non_orientable_patch(vec![face], Vec::new())).collect();
    }
    match policy {
        NonOrientable::Fail => {
            Err(PassError::Policy { pass: "orient", kind: DefectKind::NonOrientablePatch, defects })
        }
        _ => Ok(defects),
    }
}

/// The non-orientable patches of a repair's matching, each with its witness.
///
/// The mesh is taken apart along everything that is not matched: then these patches are its own. Faces keep their ids, and
/// edges are led back through their corners.
fn one_sided_patches(mesh: &PolygonMesh, context: &Context<'_>) -> Result<Vec<Defect>, PassError> {
    let (apart, provenance) = apart::along_rules(mesh, context)?;
    let kernel = EdgeUse::assemble(apart.complex());
    let strips = orientability(&kernel, &patches(&kernel)).one_sided;
    let here = mesh.complex();
    let edge_here = |edge: EdgeId| {
        let old = |c: CornerId| provenance.corners.of(apart.complex().stored_corner(c));
        let corner = kernel.edge_corners(edge).find_map(old)?;
        here.is_as_stored().then(|| here.edges().corner_edge(corner))
    };
    let defect = |strip: OneSidedStrip| {
        let edges = strip.edges.iter().filter_map(|&edge| edge_here(edge)).collect();
        Defect::non_orientable_patch(strip.faces, edges)
    };
    Ok(strips.into_iter().map(defect).collect())
}
