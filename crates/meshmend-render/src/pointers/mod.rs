//! The record of one element, drawn on the mesh: each pointer an arrow with its field's name.

mod drawing;
mod flat;
mod patch;

use meshmend_core::{Cell, Connectivity, EdgeUse, Pointer, PolygonMesh, Target};
use thiserror::Error;

use patch::Patch;

/// The most arrows that a picture has.
pub const MOST_ARROWS: usize = 40;

/// Why a record is not drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum PointerPictureError {
    /// The mesh has no such element.
    #[error("the mesh has no {0}")]
    NoSuchElement(Cell),
    /// There are too many arrows to be told apart.
    #[error("the record of {at} has {count} pointers, and a picture shows {MOST_ARROWS} at most")]
    TooMany {
        /// The element.
        at: Cell,
        /// How many pointers it has.
        count: usize,
    },
    /// There are too many faces to be told apart.
    #[error("{count} faces are about {at}, and a picture shows {MOST_ARROWS} at most")]
    Crowded {
        /// The element.
        at: Cell,
        /// How many faces there are.
        count: usize,
    },
}

/// The record of an element as a picture in SVG: the faces about it laid out flat and regular, and an arrow for each pointer, from the
/// record to what it refers to. A vertex is at its point, an edge at its middle, a face at its centre, and a half-edge on
/// the left of its edge. What lies outside the mesh is drawn beyond the edge. Texts stay texts.
///
/// ```
/// use meshmend_core::{Build, Cell, CornerId, EdgeUse, Pointer, PolygonMesh, VertexId};
///
/// let mesh = PolygonMesh::from_triangles(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], &[[0, 1, 2]])?;
/// let record = [Pointer::new("origin", VertexId(0)), Pointer::new("next", CornerId(1))];
/// let svg = meshmend_render::pointer_picture(&mesh, Cell::Corner(CornerId(0)), &record, "a corner")?;
/// assert!(svg.contains(">origin</text>") && svg.contains(">next</text>"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// When the mesh has no such element, or there is too much to be told apart.
///
/// *Cost*: that of the table of edges, once for the mesh, and of the faces shown.
pub fn pointer_picture(
    mesh: &PolygonMesh,
    at: Cell,
    pointers: &[Pointer],
    title: &str,
) -> Result<String, PointerPictureError> {
    let kernel = EdgeUse::assemble(mesh.complex());
    let targets = pointers.iter().filter_map(|pointer| match pointer.to {
        Target::Cell(cell) => Some(cell),
        _ => None,
    });
    if let Some(missing) = std::iter::once(at).chain(targets.clone()).find(|&cell| !cell.is_in(&kernel)) {
        return Err(PointerPictureError::NoSuchElement(missing));
    }
    let arrows: Vec<Pointer> =
        pointers.iter().copied().filter(|pointer| pointer.to != Target::Nothing).collect();
    if arrows.len() > MOST_ARROWS {
        return Err(PointerPictureError::TooMany { at, count: arrows.len() });
    }
    let patch = Patch::about(&kernel, at, targets);
    if patch.faces.len() > MOST_ARROWS {
        return Err(PointerPictureError::Crowded { at, count: patch.faces.len() });
    }
    let flat = flat::flattened(&kernel, at, &patch);
    Ok(drawing::drawing(&kernel, &patch, &flat, at, &arrows, title))
}

#[cfg(test)]
mod tests;
