//! What is to be drawn, and from where.

use meshmend_core::PolygonMesh;

use crate::scenes::camera::Camera;
use crate::scenes::overlay::Overlay;

/// A mesh, what to show on it, and from where to look.
///
/// ```
/// # use meshmend_core::{FaceTable, PolygonMesh, VertexId};
/// use meshmend_render::{Scene, Size, boundary, render};
///
/// let faces = FaceTable::triangles(3, [0, 1, 2].map(VertexId).to_vec())?;
/// let mesh = PolygonMesh::new(vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], faces)?;
/// let scene = Scene { overlays: vec![boundary(&mesh)], ..Scene::of(mesh) };
/// let picture = render(&scene, Size::new(320, 240)?)?;
/// assert_eq!(picture.legend(), ["boundary"]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Scene {
    /// The mesh; its complex is drawn, with its loose edges and points. Of a mesh that has no face and nothing loose
    /// the vertices are drawn.
    pub mesh: PolygonMesh,
    /// From where it is seen.
    pub camera: Camera,
    /// Whether the edges of the faces are drawn.
    pub outlines: Outlines,
    /// What is drawn over the faces: trees below all else, then wide lines below narrow ones.
    pub overlays: Vec<Overlay>,
    /// What is said above the picture.
    pub caption: Option<String>,
}

/// Whether the edges of the faces are drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Outlines {
    /// Faces are told apart by their shades alone.
    #[default]
    Omitted,
    /// Each edge that is seen is a thin line.
    Drawn,
}

impl Scene {
    /// A mesh alone, from the usual direction.
    pub fn of(mesh: PolygonMesh) -> Self {
        Scene {
            mesh,
            camera: Camera::default(),
            outlines: Outlines::default(),
            overlays: Vec::new(),
            caption: None,
        }
    }
}
