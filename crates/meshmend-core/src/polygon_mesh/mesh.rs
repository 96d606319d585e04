//! A mesh as it was read: positions, faces, loose elements and attributes.

use std::sync::{Arc, OnceLock};

use super::points::{Points, SharedPlaces};
use crate::{Complex, Counts, Domain, FaceTable, Id, Layer, MeshError, Metadata, VertexId};

/// An immutable polygon mesh. Cloning is O(1); every change makes a new mesh.
///
/// ```
/// # use meshmend_core::{FaceTable, PolygonMesh, VertexId};
/// let faces = FaceTable::triangles(3, [0, 1, 2].map(VertexId).to_vec())?;
/// let mesh = PolygonMesh::new(vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], faces)?;
/// assert_eq!(mesh.complex().edges().edge_count(), 3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct PolygonMesh {
    positions: Arc<Points>,
    faces: Arc<FaceTable>,
    loose_edges: Arc<Vec<[VertexId; 2]>>,
    loose_points: Arc<Vec<VertexId>>,
    layers: Arc<Vec<Layer>>,
    metadata: Arc<Vec<Metadata>>,
    complex: Arc<OnceLock<Complex>>,
}

impl PolygonMesh {
    /// A mesh of positions (one point a vertex, any unit) and faces over them.
    ///
    /// # Errors
    /// When the faces were made for another number of vertices.
    pub fn new(positions: Vec<[f64; 3]>, faces: FaceTable) -> Result<Self, MeshError> {
        Self::of_points(positions.into(), faces)
    }

    /// A mesh whose vertices share places. Its [positions](Self::positions) are listed when they are first asked for.
    ///
    /// # Errors
    /// When the faces were made for another number of vertices.
    pub fn of_shared_places(places: SharedPlaces, faces: FaceTable) -> Result<Self, MeshError> {
        Self::of_points(places.into(), faces)
    }

    pub(crate) fn of_points(positions: Points, faces: FaceTable) -> Result<Self, MeshError> {
        if faces.vertex_count() != positions.len() {
            return Err(MeshError::VertexCount { faces: faces.vertex_count(), positions: positions.len() });
        }
        Ok(Self::of_fitting(positions, faces))
    }

    /// A mesh of positions and faces over as many vertices.
    pub(super) fn of_fitting(positions: impl Into<Points>, faces: FaceTable) -> Self {
        PolygonMesh {
            positions: Arc::new(positions.into()),
            faces: Arc::new(faces),
            loose_edges: Arc::default(),
            loose_points: Arc::default(),
            layers: Arc::default(),
            metadata: Arc::default(),
            complex: Arc::default(),
        }
    }

    /// The mesh with these loose edges and points in place of its own.
    ///
    /// # Errors
    /// When one of them names a vertex that does not exist, or a layer is for another number of them.
    pub fn with_loose(self, edges: Vec<[VertexId; 2]>, points: Vec<VertexId>) -> Result<Self, MeshError> {
        let vertex_count = self.positions.len();
        let outside = |v: &VertexId| v.index() >= vertex_count;
        let wrong = |what, index, vertex: VertexId| {
            Err(MeshError::NoSuchVertex { what, index, vertex: vertex.0, vertex_count })
        };
        for (index, ends) in edges.iter().enumerate() {
            if let Some(&vertex) = ends.iter().find(|v| outside(v)) {
                return wrong("loose edge", index, vertex);
            }
        }
        if let Some(index) = points.iter().position(outside) {
            return wrong("loose point", index, points[index]);
        }
        let mesh = PolygonMesh { loose_edges: Arc::new(edges), loose_points: Arc::new(points), ..self };
        mesh.layers.iter().try_for_each(|layer| mesh.check_size(layer))?;
        Ok(mesh)
    }

    /// The mesh with these attribute layers in place of its own.
    ///
    /// # Errors
    /// When a layer is for another number of elements, or uses values that it does not have.
    pub fn with_layers(self, layers: Vec<Layer>) -> Result<Self, MeshError> {
        for layer in &layers {
            self.check_size(layer)?;
            if !layer.is_consistent() {
                return Err(MeshError::LayerValues { name: layer.name().to_owned() });
            }
        }
        Ok(PolygonMesh { layers: Arc::new(layers), ..self })
    }

    fn check_size(&self, layer: &Layer) -> Result<(), MeshError> {
        let (name, found, expected) =
            (layer.name(), layer.element_count(), self.element_count(layer.domain()));
        if found == expected {
            return Ok(());
        }
        Err(MeshError::LayerSize { name: name.to_owned(), found, expected })
    }

    /// How many elements of a kind there are.
    pub fn element_count(&self, domain: Domain) -> usize {
        match domain {
            Domain::Vertex => self.positions.len(),
            Domain::Corner => self.faces.corner_count(),
            Domain::Face => self.faces.face_count(),
            Domain::LooseEdge => self.loose_edges.len(),
            Domain::LoosePoint => self.loose_points.len(),
        }
    }

    /// The mesh with these statements about the file as a whole in place of its own.
    pub fn with_metadata(self, metadata: Vec<Metadata>) -> Self {
        PolygonMesh { metadata: Arc::new(metadata), ..self }
    }

    /// The point of each vertex.
    ///
    /// *Cost*: constant, but for a mesh of [shared places](Self::shared_places), whose points are listed the first time.
    pub fn positions(&self) -> &[[f64; 3]] {
        self.positions.each()
    }

    /// The places that vertices share, if it was found out when the mesh was made.
    pub fn shared_places(&self) -> Option<&SharedPlaces> {
        self.positions.shared()
    }

    /// The faces over the places that vertices share, of which each is a vertex: those of the welded mesh, but for places that are
    /// equal. `None` if no places are known, or the corners of the faces are not the vertices in order.
    ///
    /// *Cost*: one pass over the corners, of which none is copied.
    pub fn faces_at_places(&self) -> Option<FaceTable> {
        let places = self.shared_places()?;
        self.faces.over_shared(places.points().len(), places.shared_of_vertex())
    }

    /// The point of one vertex.
    pub fn position(&self, vertex: VertexId) -> [f64; 3] {
        self.positions.of(vertex.index())
    }

    /// The faces as stored.
    pub fn faces(&self) -> &FaceTable {
        &self.faces
    }

    /// The faces in normal form, which is what every analysis and kernel is about; made when first asked for and
    /// shared by all clones.
    pub fn complex(&self) -> &Complex {
        self.complex.get_or_init(|| Complex::of(&self.faces))
    }

    /// The same mesh, which shares a complex that has its edges; but one that is still to be built is its own, so that
    /// it goes with the copy and not with the mesh.
    pub fn with_own_cache(&self) -> Self {
        let is_built = self.complex.get().is_some_and(Complex::has_edges);
        let complex = if is_built { Arc::clone(&self.complex) } else { Arc::default() };
        PolygonMesh { complex, ..self.clone() }
    }

    /// Whether this is a copy of another mesh of which nothing was exchanged. What is exchanged by something equal counts as
    /// exchanged. *Cost*: O(1).
    pub fn is_copy_of(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.positions, &other.positions)
            && Arc::ptr_eq(&self.faces, &other.faces)
            && Arc::ptr_eq(&self.loose_edges, &other.loose_edges)
            && Arc::ptr_eq(&self.loose_points, &other.loose_points)
            && Arc::ptr_eq(&self.layers, &other.layers)
            && Arc::ptr_eq(&self.metadata, &other.metadata)
    }

    /// Edges that are elements of their own.
    pub fn loose_edges(&self) -> &[[VertexId; 2]] {
        &self.loose_edges
    }

    /// Points that are elements of their own.
    pub fn loose_points(&self) -> &[VertexId] {
        &self.loose_points
    }

    /// The attribute layers.
    pub fn layers(&self) -> &[Layer] {
        &self.layers
    }

    /// What the file says of itself as a whole, in its order.
    pub fn metadata(&self) -> &[Metadata] {
        &self.metadata
    }

    /// The first layer of a name and domain.
    pub fn layer(&self, name: &str, domain: Domain) -> Option<&Layer> {
        self.layers.iter().find(|layer| layer.name() == name && layer.domain() == domain)
    }

    /// How many vertices, faces and corners there are.
    pub fn counts(&self) -> Counts {
        Counts {
            vertices: self.positions.len(),
            faces: self.faces.face_count(),
            corners: self.faces.corner_count(),
        }
    }

    /// Whether all three coordinates of a vertex are finite.
    pub fn is_finite(&self, vertex: VertexId) -> bool {
        self.position(vertex).iter().all(|x| x.is_finite())
    }

    /// The mesh with other positions for the same vertices: only for tests of invariance and for front ends that
    /// change units. A repair never moves a vertex.
    ///
    /// # Errors
    /// When the number of positions is another.
    pub fn with_positions(self, positions: Vec<[f64; 3]>) -> Result<Self, MeshError> {
        if positions.len() != self.positions.len() {
            return Err(MeshError::VertexCount { faces: self.positions.len(), positions: positions.len() });
        }
        Ok(PolygonMesh { positions: Arc::new(positions.into()), ..self })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Carry, Values};

    fn triangle() -> PolygonMesh {
        let faces = FaceTable::triangles(3, [0, 1, 2].map(VertexId).to_vec()).unwrap();
        PolygonMesh::new(vec![[0.0; 3], [1.0, 0.0, 0.0], [f64::NAN, 1.0, 0.0]], faces).unwrap()
    }

    #[test]
    fn parts_that_do_not_fit_are_named() {
        let faces = FaceTable::empty(2);
        let wrong = PolygonMesh::new(vec![[0.0; 3]], faces).unwrap_err();
        assert_eq!(wrong, MeshError::VertexCount { faces: 2, positions: 1 });
        let wrong = triangle().with_loose(vec![[VertexId(0), VertexId(7)]], Vec::new()).unwrap_err();
        assert_eq!(wrong.to_string(), "loose edge 0 names vertex 7, but there are 3 vertices");
        let wrong = triangle().with_loose(Vec::new(), vec![VertexId(3)]).unwrap_err();
        assert_eq!(wrong.to_string(), "loose point 0 names vertex 3, but there are 3 vertices");
        assert!(triangle().with_positions(Vec::new()).is_err());
        let moved = triangle().with_positions(vec![[7.0; 3]; 3]).unwrap();
        assert_eq!((moved.position(VertexId(2)), moved.faces()), ([7.0; 3], triangle().faces()));
    }

    #[test]
    fn a_layer_must_speak_of_every_element_and_of_values_that_it_has() {
        let numbers = |count| Values::U8(vec![0; count]);
        let short = Layer::direct("quality", Domain::Face, 1, Carry::Copy, numbers(2));
        let wrong = triangle().with_layers(vec![short]).unwrap_err();
        assert_eq!(wrong, MeshError::LayerSize { name: "quality".into(), found: 2, expected: 1 });
        let outside = Layer::indexed("quality", Domain::Corner, 1, Carry::Copy, numbers(2), vec![0, 1, 2]);
        let wrong = triangle().with_layers(vec![outside]).unwrap_err();
        assert_eq!(wrong, MeshError::LayerValues { name: "quality".into() });
        let of_edges = Layer::direct("quality", Domain::LooseEdge, 1, Carry::Copy, numbers(1));
        assert!(triangle().with_layers(vec![of_edges.clone()]).is_err());
        let with_edge = triangle().with_loose(vec![[VertexId(0), VertexId(1)]], Vec::new()).unwrap();
        let with_layer = with_edge.with_layers(vec![of_edges]).unwrap();
        assert!(with_layer.with_loose(Vec::new(), Vec::new()).is_err());
        let uneven = Layer::indexed("pair", Domain::Face, 2, Carry::Copy, numbers(3), vec![0]);
        assert!(triangle().with_layers(vec![uneven]).is_err());
    }

    #[test]
    fn a_copy_with_its_own_cache_keeps_for_itself_what_it_builds() {
        let mesh = triangle();
        let copy = mesh.with_own_cache();
        assert!(!std::ptr::eq(mesh.complex(), copy.complex()));
        mesh.complex().edges();
        assert!(std::ptr::eq(mesh.complex(), mesh.with_own_cache().complex()));
        assert_eq!(mesh.complex().edges(), copy.complex().edges());
    }

    #[test]
    fn clones_share_the_complex() {
        let mesh = triangle();
        let clone = mesh.clone();
        assert!(std::ptr::eq(mesh.complex(), clone.complex()));
        assert!(mesh.is_finite(VertexId(0)) && !mesh.is_finite(VertexId(2)));
    }
}
