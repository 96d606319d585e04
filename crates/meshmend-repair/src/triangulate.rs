//! Cuts polygons into triangles without making an edge twice.
//!
//! *Why*: a mesh of triangles should stay one: where `clean` or `split` made a face larger, it is cut again. And some
//! kernels and formats hold triangles alone.
//!
//! 1. Choose the faces: with `auto`, if all faces were triangles as stored, those that are no longer; with `all`,
//!    every face of more than three corners.
//! 2. Cut each by shape: see the polygons' file. A diagonal never repeats an edge that is there already, as that
//!    would make it non-manifold.
//! 3. Where every choice would, the face gets a vertex of its own at the mean of its corners, or at the first free
//!    point after that.
//!
//! *Promises* triangles, wherever faces are simple. *Requires* simple faces: others stay and are named. *May introduce*
//! nothing. *Cost*: O(n³) for faces up to 64 corners, O(n²)
//! up to 4096 and mostly n log n, O(n log² n) beyond.

use std::collections::BTreeSet;

use meshmend_core::{
    Blend, CornerId, Defect, DefectKind, Draft, EdgeTable, FaceId, FaceTableBuilder, Id, PolygonMesh,
    Sources, VertexDraft, VertexId, distinct_count,
};
use meshmend_geometry::polygon::{Triangle, triangulate_polygon};
use serde::{Deserialize, Serialize};

use crate::free_points::FreePoints;
use crate::{Clearance, Context, Outcome, Pass, PassError, Unused};

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
    /// If all faces were triangles as stored, those that are no longer.
    #[default]
    Auto,
    /// Every face of more than three corners.
    All,
}

impl Pass for Triangulate {
    fn name(&self) -> &'static str {
        "triangulate"
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
        Cutter::new(mesh, context.clearance).cut_all()
    }
}

/// The new faces as they are made.
struct Cutter<'a> {
    mesh: &'a PolygonMesh,
    edges: &'a EdgeTable,
    /// Diagonals of faces that were cut before, the smaller vertex first.
    diagonals: BTreeSet<[VertexId; 2]>,
    builder: FaceTableBuilder,
    face_sources: Vec<Option<FaceId>>,
    corner_sources: Vec<Option<CornerId>>,
    created_vertices: Vec<VertexDraft>,
    created_corners: Vec<(CornerId, Blend)>,
    clearance: Clearance,
    /// Where there is room, from the first created vertex on.
    free: Option<FreePoints>,
    mended: Vec<Defect>,
    left: Vec<Defect>,
}

impl<'a> Cutter<'a> {
    fn new(mesh: &'a PolygonMesh, clearance: Clearance) -> Self {
        Cutter {
            mesh,
            edges: mesh.complex().edges(),
            diagonals: BTreeSet::new(),
            builder: FaceTableBuilder::default(),
            face_sources: Vec::new(),
            corner_sources: Vec::new(),
            created_vertices: Vec::new(),
            created_corners: Vec::new(),
            clearance,
            free: None,
            mended: Vec::new(),
            left: Vec::new(),
        }
    }

    fn cut_all(mut self) -> Result<Outcome, PassError> {
        for face in self.mesh.faces().faces() {
            let vertices = self.mesh.faces().face_vertices(face);
            let corners = vertices.len() as u32;
            if corners <= 3 {
                self.keep(face);
            } else if distinct_count(vertices) < vertices.len() {
                self.left.push(Defect::PolygonFace { face: FaceId::new(self.face_sources.len()), corners });
                self.keep(face);
            } else {
                self.mended.push(Defect::PolygonFace { face, corners });
                self.cut(face);
            }
        }
        self.into_outcome()
    }

    fn keep(&mut self, face: FaceId) {
        self.builder.push_face(self.mesh.faces().face_vertices(face).iter().copied());
        self.corner_sources.extend(self.mesh.faces().face_corners(face).map(Some));
        self.face_sources.push(Some(face));
    }

    fn cut(&mut self, face: FaceId) {
        let vertices = self.mesh.faces().face_vertices(face);
        let points: Vec<[f64; 3]> = vertices.iter().map(|&v| self.mesh.position(v)).collect();
        let is_taken = |one: usize, other: usize| {
            let ends = sorted(vertices[one], vertices[other]);
            self.edges.all_ends().binary_search(&ends).is_ok() || self.diagonals.contains(&ends)
        };
        match triangulate_polygon(&points, &is_taken) {
            Some(triangles) => self.push_triangles(face, &triangles),
            None => self.push_star(face, &points),
        }
    }

    fn push_triangles(&mut self, face: FaceId, triangles: &[Triangle]) {
        let vertices = self.mesh.faces().face_vertices(face);
        let first = self.mesh.faces().corner_range(face).start;
        for &triangle in triangles {
            self.builder.push_face(triangle.map(|place| vertices[place]));
            self.corner_sources.extend(triangle.map(|place| Some(CornerId::new(first + place))));
            self.face_sources.push(Some(face));
            let [a, b, c] = triangle.map(|place| vertices[place]);
            // Sides of the polygon are in there too: they are taken anyway.
            self.diagonals.extend([sorted(a, b), sorted(b, c), sorted(c, a)]);
        }
    }

    fn push_star(&mut self, face: FaceId, points: &[[f64; 3]]) {
        let centre = VertexId::new(self.mesh.counts().vertices + self.created_vertices.len());
        let position = self.free_points().in_face(points);
        self.created_vertices.push(VertexDraft { position, place: Blend::Inside { face } });
        let corners: Vec<CornerId> = self.mesh.faces().face_corners(face).collect();
        for (place, &corner) in corners.iter().enumerate() {
            let next = corners[(place + 1) % corners.len()];
            let ends = [corner, next].map(|c| self.mesh.faces().corner_vertex(c));
            self.builder.push_face([ends[0], ends[1], centre]);
            self.corner_sources.extend([Some(corner), Some(next), None]);
            self.created_corners.push((CornerId::new(self.corner_sources.len() - 1), Blend::Inside { face }));
            self.face_sources.push(Some(face));
        }
    }

    /// The vertices of the result so far, by which a new one is placed.
    fn free_points(&mut self) -> &mut FreePoints {
        let (mesh, clearance) = (self.mesh, self.clearance);
        self.free.get_or_insert_with(|| {
            let is_used = used_vertices(mesh);
            let is_in_result = |v: usize| clearance.unused == Unused::Kept || is_used[v];
            let vertices = mesh.positions().iter().enumerate().filter(|(v, _)| is_in_result(*v));
            FreePoints::beside(clearance, vertices.map(|(_, &position)| position))
        })
    }

    fn into_outcome(self) -> Result<Outcome, PassError> {
        if self.mended.is_empty() {
            return Ok(Outcome { left: self.left, ..Outcome::unchanged(self.mesh) });
        }
        let (kept, created) = (self.mesh.counts().vertices, self.created_vertices.len());
        let faces = self.builder.build(kept + created)?;
        let vertices = (0..kept).map(|v| Some(VertexId::new(v))).chain(std::iter::repeat_n(None, created));
        let (face_sources, corner_sources) =
            (Sources::listed(self.face_sources), Sources::listed(self.corner_sources));
        let draft = Draft {
            vertex_sources: Sources::listed(vertices),
            created_vertices: self.created_vertices,
            created_corners: self.created_corners,
            ..Draft::of_faces(self.mesh, faces, face_sources, corner_sources)
        };
        Ok(Outcome { left: self.left, ..Outcome::changed(self.mesh.rebuild(draft)?, self.mended.into()) })
    }
}

fn sorted(one: VertexId, other: VertexId) -> [VertexId; 2] {
    [one.min(other), one.max(other)]
}

/// For each vertex whether a face uses it.
fn used_vertices(mesh: &PolygonMesh) -> Vec<bool> {
    let mut is_used = vec![false; mesh.counts().vertices];
    mesh.faces().corner_vertices().iter().for_each(|v| is_used[v.index()] = true);
    is_used
}
