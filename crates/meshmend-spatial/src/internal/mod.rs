//! Which faces lie inside of what closed components enclose, on both of their sides?
//!
//! *w* is the winding number of all closed oriented components. A face of one of them that has no face-face, edge-face or
//! coincident contact has one status all over. It is *internal* when w is not 0 on both of its sides, taken at the mean of a
//! triangle's corners. Faces with such a contact, those on which another face lies there, and those with two corners at one
//! position are *mixed*.
//!
//! Faces that meet others properly alone have the status of their neighbours across edges that only the two of them have, so
//! one face of each such region is asked.

mod regions;
mod walls;

use meshmend_core::{Cancelled, FaceId, PolygonMesh};
use rayon::prelude::*;

use crate::meeting::Contact;
use crate::nesting::Nesting;
use crate::{Intersections, Surface};
use regions::regions;
use walls::{Status, Walls};

/// The faces inside of what closed components enclose.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct InternalFaces {
    /// The internal faces, ascending.
    pub internal: Vec<FaceId>,
    /// The faces of which it can't be said, ascending.
    pub mixed: Vec<FaceId>,
}

impl InternalFaces {
    /// For each component whether all of its faces are internal.
    ///
    /// *Cost*: linear.
    pub fn whole_components(&self, nesting: &Nesting) -> Vec<bool> {
        let mut internal = vec![0_u32; nesting.components.len()];
        let components = self.internal.iter().filter_map(|&face| nesting.component_of(face));
        components.for_each(|place| internal[place] += 1);
        nesting
            .components
            .iter()
            .zip(internal)
            .map(|(component, internal)| component.faces == internal)
            .collect()
    }
}

/// Regions that are asked together.
const TOGETHER: usize = 64;

/// Which faces of a surface are internal. `None` if the search for intersections stopped before the last face.
///
/// # Errors
/// When whoever watches the surface stops it.
///
/// *Cost*: O(n log n), and for each region a search and some microseconds for each face above it.
pub fn internal_faces(
    surface: &Surface<'_>,
    intersections: &Intersections,
    nesting: &Nesting,
) -> Result<Option<InternalFaces>, Cancelled> {
    const STEP: &str = "internal faces";
    if intersections.figures.is_none() {
        return Ok(None);
    }
    let (mesh, watch) = (surface.mesh(), surface.watch());
    watch.look(STEP, 0, 0)?;
    let is_solid = |face: FaceId| {
        let component = nesting.component_of(face).map(|place| &nesting.components[place]);
        component.is_some_and(|component| component.state.is_some())
    };
    let contact = |face: FaceId| intersections.contacts[face];
    let is_mixed = |face: FaceId| contact(face).is_some_and(|contact| contact >= Contact::EdgeFace);
    let is_asked =
        |face: &FaceId| is_solid(*face) && !is_mixed(*face) && !surface.triangles_of(*face).is_empty();
    let lowest = regions(surface, |face| is_asked(&face) && contact(face).is_none(), STEP)?;
    watch.look(STEP, 0, 0)?;
    let asked: Vec<FaceId> = mesh.faces().faces().filter(is_asked).collect();
    let seeds: Vec<FaceId> = asked.iter().copied().filter(|&face| lowest[face] == face).collect();
    watch.look(STEP, 0, seeds.len())?;
    let walls = Walls::of(surface, is_solid, STEP)?;
    let statuses = seeds.par_chunks(TOGETHER).map(|faces| {
        watch.look(STEP, 0, seeds.len())?;
        Ok(walls.statuses(faces))
    });
    let statuses: Vec<Status> =
        statuses.collect::<Result<Vec<_>, Cancelled>>()?.into_iter().flatten().collect();
    watch.look(STEP, 0, seeds.len())?;
    let mut found = InternalFaces { mixed: of_mesh(mesh, is_mixed), ..InternalFaces::default() };
    for face in asked {
        let status = seeds.binary_search(&lowest[face]).map(|at| statuses[at]);
        match status {
            Ok(Status::Internal) => found.internal.push(face),
            Ok(Status::Covered) => found.mixed.push(face),
            _ => {}
        }
    }
    found.mixed.extend(surface.unfit().iter().filter(|&&face| is_solid(face)));
    found.mixed.sort_unstable();
    Ok(Some(found))
}

fn of_mesh(mesh: &PolygonMesh, is_wanted: impl Fn(FaceId) -> bool) -> Vec<FaceId> {
    mesh.faces().faces().filter(|&face| is_wanted(face)).collect()
}

#[cfg(test)]
mod tests;
