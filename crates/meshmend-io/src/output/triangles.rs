//! Polygons are cut into triangles before they are written, as the repair cuts them.

use std::collections::BTreeSet;
use std::io;

use meshmend_core::{FaceId, Id, PolygonMesh, VertexId, counted, distinct_count};
use meshmend_geometry::coincident::coincident_vertices;
use meshmend_geometry::polygon::{Polygon, has_hole, simple_pieces};
use meshmend_geometry::vector::{Point, place_bits};
use meshmend_geometry::words::WordSplitter;
use meshmend_geometry::{FaceCutter, OnDiagonal, Room};

use crate::text::one_or_many;
use crate::{Encoding, Loss, LossKind, Prepared, WriteErrorKind};

/// Cuts every face of more than three corners into triangles that repeat no edge by position, and names the losses. A
/// face that returns to a point is split there; if it has a hole, it is cut so that the hole stays open.
///
/// # Errors
/// If there are more triangles than a table can hold.
///
/// *Cost*: that of the repair's `triangulate`, if there is such a face.
pub(crate) fn cut_polygons(prepared: &mut Prepared) -> Result<(), WriteErrorKind> {
    let mesh = prepared.mesh.clone();
    let is_polygon = |face: FaceId| mesh.faces().corner_range(face).len() > 3;
    if mesh.faces().is_all_triangles() || !mesh.faces().faces().any(is_polygon) {
        return Ok(());
    }
    let lowest = coincident_vertices(&mesh);
    let mut cutter = FaceCutter::new(&mesh, &lowest);
    let mut room = RoomBesideMesh { mesh: &mesh, encoding: prepared.encoding, taken: None, created: 0 };
    let mut simplifier = Simplifier { mesh: &mesh, lowest: &lowest, splitter: None, found: Found::default() };
    for face in mesh.faces().faces() {
        if is_polygon(face) {
            let pieces = simplifier.pieces(face, &cutter);
            cutter.cut(face, &pieces, &mut room);
        } else {
            cutter.keep(face);
        }
    }
    let (found, created) = (simplifier.found, room.created);
    let (mesh, record) = mesh.rebuild(cutter.into_draft().map_err(io::Error::other)?)?;
    prepared.become_mesh(mesh, record);
    prepared.losses.extend(found.losses(created));
    Ok(())
}

/// Splits faces into simple pieces.
struct Simplifier<'a> {
    mesh: &'a PolygonMesh,
    lowest: &'a [VertexId],
    splitter: Option<WordSplitter>,
    found: Found,
}

/// How many faces of more than three corners there are, and of what kind.
#[derive(Clone, Copy, Default)]
struct Found {
    polygons: usize,
    with_holes: usize,
    crossing: usize,
    empty: usize,
}

impl Simplifier<'_> {
    /// The pieces of a face, as places of its corners.
    fn pieces(&mut self, face: FaceId, cutter: &FaceCutter<'_>) -> Vec<Vec<usize>> {
        self.found.polygons += 1;
        let vertices = self.mesh.faces().face_vertices(face);
        let lowest: Vec<VertexId> = vertices.iter().map(|vertex| self.lowest[vertex.index()]).collect();
        if distinct_count(&lowest) == lowest.len() {
            return vec![(0..lowest.len()).collect()];
        }
        let splitter = self.splitter.get_or_insert_with(|| WordSplitter::new(self.lowest.len()));
        let loops = splitter.split(&lowest);
        let points = |places: &[usize]| -> Vec<[f64; 3]> {
            places.iter().map(|&place| self.mesh.position(vertices[place])).collect()
        };
        let word = points(&loops.word);
        if loops.loops.len() > 1 && has_hole(&word, loops.loops.iter().map(|places| points(places))) {
            let vertices: Vec<VertexId> = loops.word.iter().map(|&place| lowest[place]).collect();
            let is_taken = |one: usize, other: usize| cutter.is_taken([vertices[one], vertices[other]]);
            if let Some(pieces) = simple_pieces(Polygon { points: &word, vertices: &vertices }, &is_taken) {
                self.found.with_holes += 1;
                let places = |piece: &Vec<usize>| piece.iter().map(|&at| loops.word[at]).collect();
                return pieces.iter().map(places).collect();
            }
            self.found.crossing += 1;
        }
        self.found.empty += usize::from(loops.loops.is_empty());
        loops.loops
    }
}

impl Found {
    fn losses(self, created: usize) -> impl Iterator<Item = Loss> {
        let cut = Loss::if_any(LossKind::Polygons, self.polygons - self.empty, |n| {
            let mut message =
                format!("{} of more than three corners: cut into triangles", counted(n, "face"));
            if self.with_holes > 0 {
                let holes = if self.with_holes == 1 { "a hole" } else { "holes" };
                let faces = counted(self.with_holes, "face");
                message.push_str(&format!(", {faces} with {holes} left open"));
            }
            if created > 0 {
                message.push_str(&format!(", with {} more", counted(created, "vertex")));
            }
            message
        });
        let crossing = Loss::if_any(LossKind::Polygons, self.crossing, |n| {
            format!("{} with a hole and a rim that crosses itself: the hole is filled", counted(n, "face"))
        });
        let empty = Loss::if_any(LossKind::ShortFaces, self.empty, |n| {
            one_or_many(
                n,
                "face of more than three corners that bounds nothing",
                "faces of more than three corners that bound nothing",
            )
        });
        [cut, crossing, empty].into_iter().flatten()
    }
}

/// Finds points for new vertices where a mesh has no vertex.
struct RoomBesideMesh<'a> {
    mesh: &'a PolygonMesh,
    encoding: Encoding,
    /// The positions of all vertices. It is made for the first new vertex.
    taken: Option<BTreeSet<[u64; 3]>>,
    created: usize,
}

impl RoomBesideMesh<'_> {
    /// The first point without a vertex at 1/2, 1/3, 2/3, 1/4, … 63/64 of the way.
    fn first_free(&mut self, ends: [Point; 2]) -> Option<OnDiagonal> {
        let positions = self.mesh.positions();
        let taken = self.taken.get_or_insert_with(|| positions.iter().copied().map(place_bits).collect());
        let ratios = (2..=64).flat_map(|d| (1..d).map(move |n| (n, d)));
        let mut points = ratios.map(|ratio| (stored(self.encoding, ends, ratio), ratio));
        points.find(|(point, _)| !taken.contains(&place_bits(*point)))
    }
}

impl Room for RoomBesideMesh<'_> {
    fn is_between(&mut self, ends: [Point; 2]) -> bool {
        self.first_free(ends).is_some()
    }
    fn take_between(&mut self, ends: [Point; 2]) -> OnDiagonal {
        let middle = (stored(self.encoding, ends, (1, 2)), (1, 2));
        let (point, ratio) = self.first_free(ends).unwrap_or(middle);
        self.taken.iter_mut().for_each(|taken| {
            taken.insert(place_bits(point));
        });
        self.created += 1;
        (point, ratio)
    }
}

/// A point on the way between two, as the file will hold it.
fn stored(encoding: Encoding, [from, to]: [Point; 2], (n, d): (u32, u32)) -> Point {
    let point = std::array::from_fn(|i| from[i] + (to[i] - from[i]) * f64::from(n) / f64::from(d));
    if encoding == Encoding::Ascii { point } else { point.map(|x| f64::from(x as f32)) }
}
