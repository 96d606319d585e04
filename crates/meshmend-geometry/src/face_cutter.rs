//! Cuts faces of a mesh into triangles that repeat no edge, and describes the mesh that comes of it.

use std::borrow::Cow;

use meshmend_core::{
    Blend, CornerId, Draft, FaceId, FaceTableBuilder, FaceTableError, Id, PolygonMesh, Sources, VertexDraft,
    VertexId,
};

use crate::polygon::{Avoid, Polygon, Triangle, triangulate_polygon};
use crate::taken::{Diagonals, Edges};
use crate::vector::Point;

/// Where a new vertex on a diagonal is, and at which part of the way: numerator and denominator.
pub type OnDiagonal = (Point, (u32, u32));

/// Where new vertices on diagonals may be.
pub trait Room {
    /// Whether there is room between two points.
    fn is_between(&mut self, ends: [Point; 2]) -> bool;
    /// A place for a new vertex between two points, or near them if there is no room between; it is then taken.
    fn take_between(&mut self, ends: [Point; 2]) -> OnDiagonal;
}

/// The faces of a mesh as they are cut into triangles.
///
/// A diagonal repeats no edge that is there, nor another diagonal, nor joins places that such an edge joins. So no triangle
/// has its corners where those of another are, also when the mesh is stored without indices. Where every choice would
/// repeat one, or fold the face, the diagonal gets a vertex of its own; if there is no room on it, the face is folded.
pub struct FaceCutter<'a> {
    mesh: &'a PolygonMesh,
    /// For each vertex the lowest one in its place.
    lowest: &'a [VertexId],
    /// All edges, by the lowest vertices in the places of their ends.
    edges: Edges<'a>,
    /// All diagonals, likewise.
    diagonals: Diagonals,
    builder: FaceTableBuilder,
    face_sources: Vec<Option<FaceId>>,
    corner_sources: Vec<Option<CornerId>>,
    created_vertices: Vec<VertexDraft>,
    created_corners: Vec<(CornerId, Blend)>,
}

impl<'a> FaceCutter<'a> {
    /// Begins with no face. For each vertex of the mesh `lowest` has the lowest one in the same place.
    ///
    /// *Cost*: that of the mesh's edges, if they are not known; O(n log n) where vertices share places.
    pub fn new(mesh: &'a PolygonMesh, lowest: &'a [VertexId]) -> Self {
        let mut edges = Cow::Borrowed(mesh.complex().edges().all_ends());
        if lowest.iter().enumerate().any(|(vertex, low)| low.index() != vertex) {
            let moved = edges.iter().map(|&ends| places_of(lowest, ends));
            let mut moved: Vec<[VertexId; 2]> = moved.collect();
            moved.sort_unstable();
            edges = Cow::Owned(moved);
        }
        FaceCutter {
            mesh,
            lowest,
            edges: Edges::new(edges, mesh.counts().vertices),
            diagonals: Diagonals::none(mesh.counts().vertices),
            builder: FaceTableBuilder::default(),
            face_sources: Vec::new(),
            corner_sources: Vec::new(),
            created_vertices: Vec::new(),
            created_corners: Vec::new(),
        }
    }

    /// How many new faces there are so far.
    pub fn face_count(&self) -> usize {
        self.face_sources.len()
    }

    /// Keeps a face as it is.
    pub fn keep(&mut self, face: FaceId) {
        self.builder.push_face(self.mesh.faces().face_vertices(face).iter().copied());
        self.corner_sources.extend(self.mesh.faces().face_corners(face).map(Some));
        self.face_sources.push(Some(face));
    }

    /// Whether an edge or a diagonal joins the places of two vertices, or, if they are in one place, these vertices.
    ///
    /// *Cost*: O(log n).
    pub fn is_taken(&self, ends: [VertexId; 2]) -> bool {
        let ends = places_of(self.lowest, ends);
        self.edges.contains(ends) || self.diagonals.contains(ends)
    }

    /// Cuts a face, given as simple pieces by the places of their corners, into triangles.
    ///
    /// *Cost*: as for [`triangulate_polygon`], and O(log n) for each diagonal.
    pub fn cut(&mut self, face: FaceId, pieces: &[Vec<usize>], room: &mut dyn Room) {
        if matches!(pieces, [piece] if piece[..] == [0, 1, 2, 3]) && self.cut_in_two(face) {
            return;
        }
        if pieces.len() > 1 {
            let vertices = self.mesh.faces().face_vertices(face);
            for piece in pieces {
                let sides = piece.iter().zip(piece.iter().cycle().skip(1));
                for (&one, &other) in sides {
                    self.diagonals.insert(places_of(self.lowest, [vertices[one], vertices[other]]));
                }
            }
        }
        for piece in pieces {
            self.cut_piece(face, piece, room);
        }
    }

    /// Cuts a whole face of four corners, as nearly all polygons are, if the better one of its diagonals is free: what
    /// [`Self::cut_piece`] does, without a list. Tells whether it was cut.
    fn cut_in_two(&mut self, face: FaceId) -> bool {
        let mesh = self.mesh;
        let Ok(vertices) = <[VertexId; 4]>::try_from(mesh.faces().face_vertices(face)) else { return false };
        let points = vertices.map(|vertex| mesh.position(vertex));
        let lowest = vertices.map(|vertex| self.lowest[vertex.index()]);
        let polygon = Polygon { points: &points, vertices: &lowest };
        let is_taken = |one: usize, other: usize| self.is_taken([vertices[one], vertices[other]]);
        let (triangles, [one, other]) = polygon.in_two(Avoid::Folds, &is_taken);
        let diagonal = places_of(self.lowest, [vertices[one], vertices[other]]);
        if self.edges.contains(diagonal) || !self.diagonals.insert(diagonal) {
            return false;
        }
        let first = mesh.faces().corner_range(face).start;
        for triangle in triangles {
            self.push(face, triangle.map(|at| NewCorner::Kept(CornerId::new(first + at), vertices[at])));
        }
        true
    }

    fn cut_piece(&mut self, face: FaceId, places: &[usize], room: &mut dyn Room) {
        let vertices = self.mesh.faces().face_vertices(face);
        let points: Vec<Point> = places.iter().map(|&place| self.mesh.position(vertices[place])).collect();
        let lowest: Vec<VertexId> =
            places.iter().map(|&place| self.lowest[vertices[place].index()]).collect();
        let own: Vec<VertexId> = places.iter().map(|&place| vertices[place]).collect();
        let polygon = Polygon { points: &points, vertices: &lowest };
        let (triangles, repeated) = self.triangulated(polygon, &own, room);
        let first = self.mesh.faces().corner_range(face).start;
        let mut corners: Vec<NewCorner> = places
            .iter()
            .map(|&place| NewCorner::Kept(CornerId::new(first + place), vertices[place]))
            .collect();
        for &[one, other] in &repeated {
            let [from, to] = [one, other].map(|at| CornerId::new(first + places[at]));
            corners.push(self.created([from, to], room.take_between([points[one], points[other]])));
        }
        for triangle in triangles {
            for part in parted(triangle, &repeated, places.len()) {
                self.push(face, part.map(|at| corners[at]));
            }
        }
    }

    /// The triangles of a polygon, whose diagonals are taken then, and which of these were taken already.
    fn triangulated(
        &mut self,
        polygon: Polygon<'_>,
        vertices: &[VertexId],
        room: &mut dyn Room,
    ) -> (Vec<Triangle>, Vec<[usize; 2]>) {
        let points = polygon.points;
        let choice = |cutter: &Self, avoid| {
            triangulate_polygon(polygon, avoid, &|one, other| {
                cutter.is_taken([vertices[one], vertices[other]])
            })
        };
        let mut triangles = choice(self, Avoid::Folds);
        let mut diagonals = diagonals(&triangles, vertices.len());
        let is_repeated = |&[one, other]: &[usize; 2]| self.is_taken([vertices[one], vertices[other]]);
        let mut repeated = diagonals.iter().filter(|ends| is_repeated(ends));
        if !repeated.all(|ends| room.is_between(ends.map(|at| points[at]))) {
            triangles = choice(self, Avoid::TakenDiagonals);
            diagonals = self::diagonals(&triangles, vertices.len());
        }
        diagonals.retain(|ends| {
            let ends = places_of(self.lowest, ends.map(|at| vertices[at]));
            self.edges.contains(ends) || !self.diagonals.insert(ends)
        });
        diagonals.sort_unstable();
        (triangles, diagonals)
    }

    /// The mesh that comes of it, once each face was kept or cut.
    ///
    /// # Errors
    /// When it has more corners than a table holds.
    pub fn into_draft(self) -> Result<Draft, FaceTableError> {
        let (kept, created) = (self.mesh.counts().vertices, self.created_vertices.len());
        let faces = self.builder.build(kept + created)?;
        let vertices = (0..kept).map(|v| Some(VertexId::new(v))).chain(std::iter::repeat_n(None, created));
        let (face_sources, corner_sources) =
            (Sources::listed(self.face_sources), Sources::listed(self.corner_sources));
        Ok(Draft {
            vertex_sources: Sources::listed(vertices),
            created_vertices: self.created_vertices,
            created_corners: self.created_corners,
            ..Draft::of_faces(self.mesh, faces, face_sources, corner_sources)
        })
    }

    fn created(&mut self, [from, to]: [CornerId; 2], (position, ratio): OnDiagonal) -> NewCorner {
        let vertex = VertexId::new(self.mesh.counts().vertices + self.created_vertices.len());
        let place = Blend::Along { from, to, numerator: ratio.0, denominator: ratio.1 };
        self.created_vertices.push(VertexDraft { position, place: Some(place) });
        NewCorner::Created(place, vertex)
    }

    fn push(&mut self, face: FaceId, corners: [NewCorner; 3]) {
        for corner in corners {
            if let NewCorner::Created(place, _) = corner {
                self.created_corners.push((CornerId::new(self.corner_sources.len()), place));
            }
            self.corner_sources.push(match corner {
                NewCorner::Kept(corner, _) => Some(corner),
                NewCorner::Created(..) => None,
            });
        }
        self.builder.push_face(corners.map(|corner| match corner {
            NewCorner::Kept(_, vertex) | NewCorner::Created(_, vertex) => vertex,
        }));
        self.face_sources.push(Some(face));
    }
}

/// The diagonals of the triangles of a polygon with so many corners, as the places of their ends.
fn diagonals(triangles: &[Triangle], count: usize) -> Vec<[usize; 2]> {
    // Each is the longest side of one triangle; so is the polygon's last side.
    let longest = triangles.iter().map(|&[a, b, c]| [a.min(b).min(c), a.max(b).max(c)]);
    longest.filter(|&[low, high]| high - low < count - 1).collect()
}

/// A corner of a triangle: one of the face, or one at a vertex on a diagonal.
#[derive(Clone, Copy)]
enum NewCorner {
    Kept(CornerId, VertexId),
    Created(Blend, VertexId),
}

/// A triangle of a polygon with so many corners in parts: on each of its sides that is among the `repeated` ones lies one more
/// corner, which has the number of that side beyond those of the polygon.
fn parted(triangle: Triangle, repeated: &[[usize; 2]], count: usize) -> Vec<Triangle> {
    if repeated.is_empty() {
        return vec![triangle];
    }
    let on = |one: usize, other: usize| {
        let at = repeated.binary_search(&[one.min(other), one.max(other)]).ok()?;
        Some(count + at)
    };
    let [a, b, c] = triangle;
    // Turned so that the sides with a corner come first.
    let turns = [[a, b, c], [b, c, a], [c, a, b]];
    let sides = turns.map(|[a, b, c]| ([on(a, b), on(b, c), on(c, a)], [a, b, c]));
    for (on, [a, b, c]) in sides {
        match on {
            [None, None, None] => return vec![[a, b, c]],
            [Some(m), None, None] => return vec![[a, m, c], [m, b, c]],
            [Some(m), Some(n), None] => return vec![[m, b, n], [a, m, n], [a, n, c]],
            [Some(m), Some(n), Some(o)] => return vec![[a, m, o], [m, b, n], [n, c, o], [m, n, o]],
            _ => {}
        }
    }
    vec![triangle]
}

/// What an edge between two vertices is known by: the lowest vertices in their places, or, if that is one, themselves; the
/// smaller first.
fn places_of(lowest: &[VertexId], ends: [VertexId; 2]) -> [VertexId; 2] {
    let places = ends.map(|vertex| lowest[vertex.index()]);
    let [one, other] = if places[0] == places[1] { ends } else { places };
    [one.min(other), one.max(other)]
}
