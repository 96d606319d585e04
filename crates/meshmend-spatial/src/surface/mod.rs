//! The surface of a mesh: its faces as triangles, corners known by their positions.

mod cut;
mod cycles;
mod triangle;

use meshmend_core::{Cancelled, FaceId, FaceTableError, Id, PolygonMesh, VertexId, Watch, distinct_count};
use meshmend_geometry::coincident::watched_coincident_vertices;
use meshmend_geometry::vector::Point;
use rayon::prelude::*;
use thiserror::Error;

pub use triangle::{Cell, Triangle, WHOLE};

use crate::exact::are_collinear;
use cut::Cut;
use cycles::Cycles;

/// The triangles that the faces of a mesh are, each corner known by the lowest vertex at its position.
///
/// A larger face is the triangles that the pass `triangulate` makes of it in this mesh if it cuts all. Faces that have no
/// surface take no part: those of zero area, and those that are *unfit*, which have fewer than three corners, one that is not
/// finite, or two at one position. Triangles of zero area in a larger face's surface are left out.
pub struct Surface<'a> {
    mesh: &'a PolygonMesh,
    lowest: Vec<VertexId>,
    /// The points of vertices that lie on diagonals: those beyond the mesh's.
    created: Vec<Point>,
    triangles: Vec<Triangle>,
    /// For each face where its triangles begin, and one more.
    starts: Vec<u32>,
    zero_area: Vec<FaceId>,
    unfit: Vec<FaceId>,
    cycles: Cycles,
    watch: &'a Watch,
}

/// Why a mesh's surface is not there.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum SurfaceError {
    /// Its triangles have more corners than a table holds.
    #[error(transparent)]
    Table(#[from] FaceTableError),
    /// Whoever watches stopped it.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

const NOBODY: &Watch = &Watch::NOBODY;

/// Faces of a piece of work.
const CHUNK: usize = 4096;

impl<'a> Surface<'a> {
    /// The surface of a mesh, which nobody watches.
    ///
    /// # Errors
    /// When its triangles have more corners than a table holds.
    ///
    /// *Cost*: that of [`watched`](Self::watched).
    pub fn of(mesh: &'a PolygonMesh) -> Result<Self, SurfaceError> {
        Self::watched(mesh, NOBODY)
    }

    /// The surface of a mesh. Somebody watches while it is made, and while anything is asked about it.
    ///
    /// # Errors
    /// When its triangles have more corners than a table holds, or whoever watches stops it.
    ///
    /// *Cost*: linear for triangles, and 22 bytes a face; larger faces cost what it takes to cut them.
    pub fn watched(mesh: &'a PolygonMesh, watch: &'a Watch) -> Result<Self, SurfaceError> {
        const STEP: &str = "surface";
        let lowest = watched_coincident_vertices(mesh, || watch.look(STEP, 0, 0))?;
        let cut = if mesh.faces().is_all_triangles() { None } else { Some(Cut::of(mesh, &lowest)?) };
        let mut surface = Surface {
            mesh,
            created: cut.as_ref().map(Cut::created).unwrap_or_default(),
            lowest,
            triangles: Vec::with_capacity(mesh.counts().faces),
            starts: Vec::with_capacity(mesh.counts().faces + 1),
            zero_area: Vec::new(),
            unfit: Vec::new(),
            cycles: Cycles::default(),
            watch,
        };
        let count = mesh.counts().faces;
        let chunks: Vec<Part> = (0..count.div_ceil(CHUNK))
            .into_par_iter()
            .map(|chunk| {
                watch.look_at_times(STEP, chunk * CHUNK, count)?;
                Ok(surface.part(cut.as_ref(), chunk * CHUNK..count.min((chunk + 1) * CHUNK)))
            })
            .collect::<Result<_, Cancelled>>()?;
        watch.look(STEP, count, count)?;
        for part in chunks {
            let before = surface.triangles.len() as u32;
            surface.starts.extend(part.starts.into_iter().map(|start| before + start));
            surface.triangles.extend(part.triangles);
            surface.zero_area.extend(part.zero_area);
            surface.unfit.extend(part.unfit);
        }
        surface.starts.push(surface.triangles.len() as u32);
        if cut.is_some() {
            surface.cycles = Cycles::of(mesh, |vertex| surface.place(vertex), &surface.unfit);
        }
        Ok(surface)
    }

    /// Who watches what is asked about it.
    pub fn watch(&self) -> &'a Watch {
        self.watch
    }

    /// The mesh whose surface it is.
    pub fn mesh(&self) -> &'a PolygonMesh {
        self.mesh
    }

    /// All triangles, in the order of their faces.
    pub fn triangles(&self) -> &[Triangle] {
        &self.triangles
    }

    /// The triangles of a face; none if it takes no part.
    pub fn triangles_of(&self, face: FaceId) -> &[Triangle] {
        &self.triangles[self.range_of(face)]
    }

    /// The points of a triangle's corners.
    #[inline]
    pub fn points(&self, triangle: &Triangle) -> [Point; 3] {
        let [a, b, c] = triangle.corners;
        [self.point(a), self.point(b), self.point(c)]
    }

    /// The lowest vertex at a vertex's position: equal positions have equal ones.
    #[inline]
    pub fn place(&self, vertex: VertexId) -> VertexId {
        self.lowest[vertex.index()]
    }

    /// The faces all of whose corners lie on one line, ascending.
    pub fn zero_area(&self) -> &[FaceId] {
        &self.zero_area
    }

    /// The faces with fewer than three corners, one that is not finite, or two at one position, ascending.
    pub fn unfit(&self) -> &[FaceId] {
        &self.unfit
    }

    /// Where a face's triangles are among all.
    pub(crate) fn range_of(&self, face: FaceId) -> std::ops::Range<usize> {
        self.starts[face.index()] as usize..self.starts[face.index() + 1] as usize
    }

    /// Whether two different faces of more than three corners have the same cycle of corner positions, either way round.
    pub fn is_same_cycle(&self, one: FaceId, other: FaceId) -> bool {
        self.cycles.is_same(one, other)
    }

    /// Whether a face has three corners.
    #[inline]
    pub(crate) fn is_triangle(&self, face: FaceId) -> bool {
        self.mesh.faces().corner_range(face).len() == 3
    }

    #[inline]
    fn point(&self, corner: VertexId) -> Point {
        match self.mesh.positions().get(corner.index()) {
            Some(&point) => point,
            None => self.created[corner.index() - self.lowest.len()],
        }
    }

    /// What some faces in a row are.
    fn part(&self, cut: Option<&Cut>, faces: std::ops::Range<usize>) -> Part {
        let mut part = Part::default();
        for face in faces.map(FaceId::new) {
            part.starts.push(part.triangles.len() as u32);
            match self.fitness(face) {
                Fitness::Unfit => part.unfit.push(face),
                Fitness::ZeroArea => part.zero_area.push(face),
                Fitness::Fit => self.add_triangles(&mut part.triangles, face, cut),
            }
        }
        part
    }

    fn fitness(&self, face: FaceId) -> Fitness {
        let vertices = self.mesh.faces().face_vertices(face);
        if vertices.len() < 3 || !vertices.iter().all(|&vertex| self.mesh.is_finite(vertex)) {
            return Fitness::Unfit;
        }
        let is_flawed = match *vertices {
            [a, b, c] => {
                let [a, b, c] = [a, b, c].map(|vertex| self.place(vertex));
                a == b || b == c || c == a
            }
            _ => {
                let places: Vec<VertexId> = vertices.iter().map(|&vertex| self.place(vertex)).collect();
                distinct_count(&places) < places.len()
            }
        };
        if is_flawed {
            return Fitness::Unfit;
        }
        // The first two corners are apart, so that they span the line.
        let [first, second] = [0, 1].map(|at: usize| self.mesh.position(vertices[at]));
        let mut others = vertices[2..].iter().map(|&vertex| self.mesh.position(vertex));
        if others.all(|third| are_collinear([first, second, third])) {
            return Fitness::ZeroArea;
        }
        Fitness::Fit
    }

    fn add_triangles(&self, triangles: &mut Vec<Triangle>, face: FaceId, cut: Option<&Cut>) {
        if let (false, Some(cut)) = (self.is_triangle(face), cut) {
            let parts = cut.triangles_of(self.mesh, face, |vertex| self.place(vertex));
            triangles.extend(parts.filter(|part| !are_collinear(self.points(part))));
        } else if let [a, b, c] = *self.mesh.faces().face_vertices(face) {
            triangles.push(Triangle::whole(face, [a, b, c].map(|vertex| self.place(vertex))));
        }
    }
}

/// Whether a face has a surface.
enum Fitness {
    Fit,
    ZeroArea,
    Unfit,
}

/// What some faces in a row are.
#[derive(Default)]
struct Part {
    triangles: Vec<Triangle>,
    starts: Vec<u32>,
    zero_area: Vec<FaceId>,
    unfit: Vec<FaceId>,
}

#[cfg(test)]
mod tests;
