//! What changes in the text of a model where an object has another mesh.

use std::ops::Range;

use meshmend_core::{CornerId, FaceId, Id, PolygonMesh, VertexId};

use super::numbers::{self, Edit, lattice_edits, mark_used, set_edits};
use super::rows::Rows;
use super::triangles::{Stretched, Triangles};
use super::vertices::{Sources, Vertices};
use crate::formats::threemf::parts::Origin;

/// What has to be said of an object that was written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Told {
    /// Vertices that only beams and balls use, and that are not in the mesh any more.
    pub(super) needed: usize,
    pub(super) stretched: Stretched,
    /// Members of sets of triangles that are no more.
    pub(super) lost_members: usize,
}

/// Whether a mesh is the one that was read, row for row.
pub(super) fn is_as_read(mesh: &PolygonMesh, origin: &Origin) -> bool {
    if mesh.is_copy_of(&origin.mesh) {
        return true;
    }
    let sources = Sources::of(mesh);
    let bits = |position: &[f64; 3]| position.map(f64::to_bits);
    let same_vertices = || {
        mesh.positions().iter().map(bits).eq(origin.mesh.positions().iter().map(bits))
            && (0..mesh.counts().vertices).all(|at| sources.vertex(VertexId::new(at)) == Some(at as u32))
    };
    let same_corner = |corner: CornerId| sources.corner(corner) == Some(mesh.faces().corner_vertex(corner).0);
    mesh.faces() == origin.mesh.faces()
        && same_vertices()
        && mesh.faces().corners().all(same_corner)
        && mesh.faces().faces().all(|face: FaceId| sources.triangle(face.index()) == Some(face.0))
}

/// The edits that put a mesh into the text of its object. `None` if the text has no place for it.
pub(super) fn edits(text: &str, origin: &Origin, mesh: &PolygonMesh) -> Option<(Vec<Edit>, Told)> {
    let places = &origin.places;
    let vertices_at = places.vertices.clone().filter(|place| has_room(text, place))?;
    let triangles_at = places.triangles.clone().filter(|place| has_room(text, place))?;
    let (before, sources) = (&origin.mesh, Sources::of(mesh));
    let mut is_needed = vec![false; before.counts().vertices];
    places.lattices.iter().for_each(|lattice| mark_used(text, lattice, &mut is_needed));
    let vertices = Vertices::of(mesh, &sources, &is_needed);
    let mut told = Told { needed: vertices.needed(), ..Told::default() };
    let rows = Rows::of(&text[vertices_at.clone()]);
    let mut edits = vec![Edit { place: vertices_at, text: vertices.text(&rows, mesh, before) }];
    let rows = Rows::of(&text[triangles_at.clone()]);
    let triangles = Triangles { rows: &rows, mesh, before, sources: &sources, vertices: &vertices };
    let (new, stretched) = triangles.text();
    told.stretched = stretched;
    edits.push(Edit { place: triangles_at, text: new });
    for lattice in &places.lattices {
        lattice_edits(text, lattice, &vertices, &mut edits);
    }
    if !places.sets.is_empty() {
        let of_triangles: Vec<Option<u32>> =
            (0..mesh.counts().faces).map(|face| sources.triangle(face)).collect();
        let map = numbers::Triangles::of(&of_triangles, before.counts().faces);
        let lost = places.sets.iter().map(|sets| set_edits(text, sets, &map, &mut edits));
        told.lost_members = lost.sum();
    }
    Some((edits, told))
}

/// Whether a part of a text stands between two tags, and not behind an empty one.
fn has_room(text: &str, place: &Range<usize>) -> bool {
    !text[..place.start].ends_with("/>")
}

/// A text with edits, which do not overlap.
pub(super) fn edited(text: &str, mut edits: Vec<Edit>) -> String {
    edits.sort_by_key(|edit| edit.place.start);
    let mut changed = String::with_capacity(text.len());
    let mut at = 0;
    for edit in edits {
        changed.push_str(&text[at..edit.place.start]);
        changed.push_str(&edit.text);
        at = edit.place.end;
    }
    changed + &text[at..]
}
