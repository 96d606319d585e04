//! Cuts a mesh along edges.
//!
//! Round a vertex the cut edges divide the corners into parts; the first keeps the vertex, and each other part gets a
//! vertex of its own in the same place. Faces and corners stay what they are, so every attribute stays where it is,
//! and the two sides of a cut edge are known by their corners before and after.
//!
//! *Source*: A. Guéziec, G. Taubin, F. Lazarus, W. Horn, *Cutting and stitching: converting sets of polygons to
//! manifold surfaces*, 2001.

use meshmend_core::{
    Classes, Column, Connectivity, CornerId, Defect, Draft, EdgeClass, EdgeId, EdgeUse, FaceId,
    FaceTableBuilder, FaceTableError, Id, PolygonMesh, Provenance, Sources, VertexClass, VertexId,
    edge_class, umbrellas,
};

use crate::error::CutError;

/// A mesh that was cut along edges.
#[must_use]
#[derive(Clone, Debug)]
pub struct CutOpen {
    /// The mesh with its cuts open.
    pub mesh: PolygonMesh,
    /// Where each of its elements came from: faces and corners are the same as before.
    pub provenance: Provenance,
    /// Which sides belong together, by ascending edge.
    pub seams: Vec<CutSeam>,
    /// The edges with two sides that could not be opened, since their ends stay whole: one that no other cut edge
    /// meets, within the surface. By index its two sides join the same two vertices, so it is one edge as before.
    pub closed: Vec<EdgeId>,
}

/// A cut edge, as two sides of the boundary.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CutSeam {
    /// The edge before.
    pub edge: EdgeId,
    /// Its ends before, the lower one first.
    pub ends: [VertexId; 2],
    /// The two corners, before as after, whose sides ran along it.
    pub sides: [CornerId; 2],
    /// What its ends have become along each of these sides, in the order of `ends`.
    pub side_ends: [[VertexId; 2]; 2],
}

/// Cuts a mesh along edges; boundary edges among them change nothing.
///
/// ```
/// # use meshmend_core::{EdgeId, FaceTable, PolygonMesh, VertexId};
/// # use meshmend_cut::cut_open;
/// // A tetrahedron, cut along two of the edges of its lowest vertex.
/// let faces = [0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0].map(VertexId).to_vec();
/// let mesh = PolygonMesh::new(vec![[0.0; 3]; 4], FaceTable::triangles(4, faces)?)?;
/// let cut = cut_open(&mesh, &[EdgeId(0), EdgeId(1)])?;
/// assert_eq!(cut.mesh.counts().vertices, 5);
/// assert_eq!(cut.provenance.vertices.of(VertexId(4)), Some(VertexId(0)));
/// assert_eq!(cut.seams.len(), 2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// When the mesh does not have an edge, or an edge ends in a vertex that no surface has.
///
/// *Cost*: linear in the mesh, and O(d log d) for each vertex of degree d on the cut.
pub fn cut_open(mesh: &PolygonMesh, edges: &[EdgeId]) -> Result<CutOpen, CutError> {
    let kernel = EdgeUse::assemble(mesh.complex());
    let cut = Cut::along(&kernel, edges)?;
    let parts = Parts::of(&kernel, &cut);
    let (mut seams, mut closed) = (Vec::new(), Vec::new());
    for &edge in &cut.edges {
        match parts.seam(&kernel, mesh, edge) {
            Some(seam) if seam.side_ends[0] == seam.side_ends[1] => closed.push(edge),
            Some(seam) => seams.push(seam),
            None => {}
        }
    }
    if parts.added.is_empty() {
        return Ok(CutOpen {
            provenance: Provenance::same(mesh.counts()),
            mesh: mesh.clone(),
            seams,
            closed,
        });
    }
    let (mesh, provenance) = mesh.rebuild(parts.draft(mesh)?)?;
    Ok(CutOpen { mesh, provenance, seams, closed })
}

/// The edges to cut, and the vertices at them.
struct Cut {
    /// Ascending, each once.
    edges: Vec<EdgeId>,
    is_cut: Column<EdgeId, bool>,
    /// Ascending, each once.
    vertices: Vec<VertexId>,
}

impl Cut {
    fn along(kernel: &EdgeUse, edges: &[EdgeId]) -> Result<Self, CutError> {
        let mut is_cut = Column::filled(false, kernel.edge_count());
        for &edge in edges {
            if edge.index() >= kernel.edge_count() {
                return Err(CutError::NoSuchEdge(edge));
            }
            is_cut[edge] = true;
        }
        let edges: Vec<EdgeId> = kernel.edges().filter(|&edge| is_cut[edge]).collect();
        let mut is_end = Column::filled(false, kernel.vertex_count());
        for &edge in &edges {
            if edge_class(kernel, edge) == EdgeClass::NonManifold {
                let (ends, degree) = (kernel.edge_ends(edge), kernel.edge_degree(edge) as u32);
                return Err(CutError::NotManifold(Defect::non_manifold_edge(edge, ends, degree)));
            }
            kernel.edge_ends(edge).into_iter().for_each(|end| is_end[end] = true);
        }
        let vertices: Vec<VertexId> = kernel.vertices().filter(|&vertex| is_end[vertex]).collect();
        match vertices.iter().find_map(|&vertex| non_manifold(kernel, vertex)) {
            Some(defect) => Err(CutError::NotManifold(defect)),
            None => Ok(Cut { edges, is_cut, vertices }),
        }
    }
}

/// What keeps a vertex from being one of a surface.
fn non_manifold(kernel: &EdgeUse, vertex: VertexId) -> Option<Defect> {
    match umbrellas(kernel, vertex).class() {
        VertexClass::Unreferenced | VertexClass::Disc | VertexClass::HalfDisc => None,
        VertexClass::Pinched { umbrellas, boundary_only } => {
            Some(Defect::pinched_vertex(vertex, umbrellas, boundary_only))
        }
        VertexClass::Singular => Some(Defect::singular_vertex(vertex)),
    }
}

/// What the vertices on the cut fall into.
struct Parts {
    /// The vertex at each corner of the complex.
    of_corner: Column<CornerId, VertexId>,
    /// For each vertex that is added the one that it was a part of.
    added: Vec<VertexId>,
}

impl Parts {
    /// Of each vertex the part with the lowest corner keeps its number; the others follow after all vertices, by
    /// vertex and lowest corner.
    fn of(kernel: &EdgeUse, cut: &Cut) -> Self {
        let of_corner = kernel.corners().map(|corner| kernel.corner_vertex(corner)).collect();
        let mut parts = Parts { of_corner, added: Vec::new() };
        let mut star = Star::default();
        for &vertex in &cut.vertices {
            star.divide(kernel, vertex, &cut.is_cut);
            for place in 0..star.corners.len() {
                let lowest = star.classes.root(place as u32) as usize;
                let part = if place == 0 {
                    vertex
                } else if place == lowest {
                    parts.added.push(vertex);
                    VertexId::new(kernel.vertex_count() + parts.added.len() - 1)
                } else {
                    parts.of_corner[star.corners[lowest]]
                };
                parts.of_corner[star.corners[place]] = part;
            }
        }
        parts
    }

    /// The two sides of a cut edge; `None` for a boundary edge.
    fn seam(&self, kernel: &EdgeUse, mesh: &PolygonMesh, edge: EdgeId) -> Option<CutSeam> {
        let mut corners = kernel.edge_corners(edge);
        let sides = [corners.next()?, corners.next()?];
        let ends_along = |side: CornerId| {
            let [from, to] = [side, kernel.next_corner(side)].map(|corner| self.of_corner[corner]);
            if kernel.is_forward(side) { [from, to] } else { [to, from] }
        };
        Some(CutSeam {
            edge,
            ends: kernel.edge_ends(edge),
            side_ends: sides.map(ends_along),
            sides: sides.map(|side| mesh.complex().stored_corner(side)),
        })
    }

    /// The mesh with the same faces over these vertices.
    fn draft(&self, mesh: &PolygonMesh) -> Result<Draft, FaceTableError> {
        let old = mesh.faces();
        let mut builder = FaceTableBuilder::default();
        let mut vertices = Vec::new();
        for face in old.faces() {
            vertices.clear();
            vertices.extend_from_slice(old.face_vertices(face));
            self.rename(mesh, face, &mut vertices);
            builder.push_face(vertices.iter().copied());
        }
        let (kept, count) = (mesh.counts().vertices, mesh.counts().vertices + self.added.len());
        let sources = (0..kept).map(VertexId::new).chain(self.added.iter().copied()).map(Some);
        let (faces, corners) = (Sources::same(old.face_count()), Sources::same(old.corner_count()));
        Ok(Draft {
            vertex_sources: Sources::listed(sources),
            ..Draft::of_faces(mesh, builder.build(count)?, faces, corners)
        })
    }

    /// Puts the new vertices into a stored face. A corner that the complex leaves out repeats the one before it, or
    /// at the end of the face the first one, and goes with that; a degenerate face keeps its vertices.
    fn rename(&self, mesh: &PolygonMesh, face: FaceId, vertices: &mut [VertexId]) {
        let (complex, first) = (mesh.complex(), mesh.faces().corner_range(face).start);
        let mut kept = complex.faces().face_corners(face).peekable();
        let Some(mut last) = kept.peek().copied() else { return };
        let wrapped = last;
        for (place, vertex) in (first..).zip(vertices) {
            if let Some(corner) = kept.next_if(|&corner| complex.stored_corner(corner).index() == place) {
                last = corner;
            } else if complex.faces().corner_vertex(last) != *vertex {
                last = wrapped;
            }
            *vertex = self.of_corner[last];
        }
    }
}

/// The corners of one vertex, joined where they share an edge there that is not cut; reused from vertex to vertex.
#[derive(Default)]
struct Star {
    /// Ascending.
    corners: Vec<CornerId>,
    classes: Classes,
    sides: Vec<(EdgeId, usize)>,
}

impl Star {
    fn divide(&mut self, kernel: &EdgeUse, vertex: VertexId, is_cut: &Column<EdgeId, bool>) {
        self.corners.clear();
        self.corners.extend(kernel.vertex_corners(vertex));
        self.classes.reset(self.corners.len());
        self.sides.clear();
        for (place, &corner) in self.corners.iter().enumerate() {
            let sides = [corner, kernel.prev_corner(corner)].map(|side| kernel.corner_edge(side));
            self.sides.extend(sides.into_iter().filter(|&edge| !is_cut[edge]).map(|edge| (edge, place)));
        }
        self.sides.sort_unstable();
        for i in 1..self.sides.len() {
            let [(before, one), (edge, other)] = [self.sides[i - 1], self.sides[i]];
            if before == edge {
                self.classes.join(one as u32, other as u32);
            }
        }
    }
}
