//! A mesh, and the file that it is from.

use std::sync::Arc;

use meshmend::formats::Document;
use meshmend::mesh::{Id, Metadata};
use meshmend::{FaceTable, Note, PolygonMesh, VertexId};
use numpy::{
    IntoPyArray, PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2, PyReadonlyArrayDyn,
    PyReadwriteArray1,
};
use pyo3::exceptions::{PyIndexError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};

use crate::arrays::{id, ids};
use crate::errors;
use crate::layers::{self, GivenLayer};

/// The file that a mesh is from.
#[derive(Debug)]
pub(crate) struct Origin {
    /// What the file is called in reports.
    pub(crate) name: String,
    /// All of it, with the meshes as they were read.
    pub(crate) document: Document,
}

/// What a document says of the file that its mesh is from, if it is from one.
#[derive(Default)]
pub(crate) struct OfFile {
    pub(crate) file: Option<String>,
    pub(crate) format: Option<&'static str>,
    pub(crate) notes: Vec<Note>,
}

/// A mesh.
#[pyclass(frozen, module = "meshmend._native")]
pub(crate) struct MeshHandle {
    pub(crate) mesh: PolygonMesh,
    /// The file that it is from, and which of its parts it is.
    pub(crate) origin: Option<(Arc<Origin>, usize)>,
}

impl MeshHandle {
    /// A mesh that is from no file.
    pub(crate) fn alone(mesh: PolygonMesh) -> MeshHandle {
        MeshHandle { mesh, origin: None }
    }

    pub(crate) fn of_file(&self) -> OfFile {
        let Some((origin, _)) = &self.origin else { return OfFile::default() };
        let document = &origin.document;
        OfFile { file: self.title(), format: Some(document.variant), notes: document.notes.clone() }
    }
}

/// Whole numbers in the type in which they came.
#[derive(FromPyObject)]
pub(crate) enum Numbers<'py> {
    I32(PyReadonlyArrayDyn<'py, i32>),
    U32(PyReadonlyArrayDyn<'py, u32>),
    I64(PyReadonlyArrayDyn<'py, i64>),
    U64(PyReadonlyArrayDyn<'py, u64>),
}

/// An array to be filled: numpy has made it in the type that is wanted.
#[derive(FromPyObject)]
pub(crate) enum Room<'py> {
    I32(PyReadwriteArray1<'py, i32>),
    I64(PyReadwriteArray1<'py, i64>),
}

impl Numbers<'_> {
    /// Them as vertices; what is no number of one is that of none.
    fn vertices(&self) -> PyResult<Vec<VertexId>> {
        fn of<T: Copy + TryInto<u32>>(numbers: &[T]) -> Vec<VertexId> {
            numbers.iter().map(|&number| VertexId(number.try_into().unwrap_or(u32::MAX))).collect()
        }
        Ok(match self {
            Numbers::I32(numbers) => of(numbers.as_slice()?),
            Numbers::U32(numbers) => of(numbers.as_slice()?),
            Numbers::I64(numbers) => of(numbers.as_slice()?),
            Numbers::U64(numbers) => of(numbers.as_slice()?),
        })
    }
}

type Pairs<'py> = Bound<'py, PyArray2<i32>>;

#[pymethods]
impl MeshHandle {
    /// A mesh of arrays, whose numbers the Python side has looked at; without starts its faces are triangles.
    #[new]
    fn of_arrays(
        points: PyReadonlyArray2<'_, f64>,
        corners: Numbers<'_>,
        starts: Option<PyReadonlyArray1<'_, u32>>,
        loose: (PyReadonlyArray2<'_, u32>, PyReadonlyArray1<'_, u32>),
        layers: Vec<GivenLayer<'_>>,
        metadata: Vec<(String, Vec<u8>)>,
    ) -> PyResult<Self> {
        let (points, rest) = points.as_slice()?.as_chunks::<3>();
        if !rest.is_empty() {
            return Err(PyValueError::new_err("a point has three coordinates"));
        }
        let of_faces = |error: &dyn std::fmt::Display| PyIndexError::new_err(error.to_string());
        let faces = match starts {
            Some(starts) => {
                FaceTable::polygons(points.len(), starts.as_slice()?.to_vec(), corners.vertices()?)
            }
            None => FaceTable::triangles(points.len(), corners.vertices()?),
        };
        let mesh = PolygonMesh::new(points.to_vec(), faces.map_err(|error| of_faces(&error))?)
            .map_err(|error| of_faces(&error))?;
        let (ends, _) = loose.0.as_slice()?.as_chunks::<2>();
        let edges = ends.iter().map(|ends| ends.map(VertexId)).collect();
        let points = loose.1.as_slice()?.iter().copied().map(VertexId).collect();
        let mesh = mesh.with_loose(edges, points).map_err(|error| of_faces(&error))?;
        let layers = layers.iter().map(GivenLayer::layer).collect::<PyResult<Vec<_>>>()?;
        let mesh = mesh.with_layers(layers).map_err(|error| PyValueError::new_err(error.to_string()))?;
        let metadata = metadata.into_iter().map(|(key, value)| Metadata { key, value });
        Ok(MeshHandle::alone(mesh.with_metadata(metadata.collect())))
    }

    fn vertices<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let flat = PyArray1::from_slice(py, self.mesh.positions().as_flattened());
        flat.reshape([self.mesh.positions().len(), 3])
    }

    /// Fills an array with the vertex of each corner.
    fn corners(&self, room: Room<'_>) -> PyResult<()> {
        let corners = self.mesh.faces().corner_vertices();
        match room {
            Room::I32(mut room) => fill(room.as_slice_mut()?, corners, |vertex| id(vertex.index())),
            Room::I64(mut room) => fill(room.as_slice_mut()?, corners, |vertex| i64::from(vertex.0)),
        }
        Ok(())
    }

    /// Where the corners of each face begin, and one more.
    fn offsets<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<i32>> {
        let faces = self.mesh.faces();
        let starts = faces.faces().map(|face| faces.corner_range(face).start);
        let starts = starts.chain([faces.corner_count()]).map(id);
        starts.collect::<Vec<i32>>().into_pyarray(py)
    }

    fn edges<'py>(&self, py: Python<'py>) -> PyResult<Pairs<'py>> {
        pairs(py, self.mesh.complex().edges().all_ends())
    }

    fn loose_edges<'py>(&self, py: Python<'py>) -> PyResult<Pairs<'py>> {
        pairs(py, self.mesh.loose_edges())
    }

    fn loose_points<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<i32>> {
        ids(self.mesh.loose_points()).into_pyarray(py)
    }

    /// How many vertices, faces and corners it has.
    fn counts(&self) -> (usize, usize, usize) {
        let counts = self.mesh.counts();
        (counts.vertices, counts.faces, counts.corners)
    }

    fn is_triangles(&self) -> bool {
        self.mesh.faces().is_all_triangles()
    }

    /// The layers, each as all that it is made of.
    fn layers<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyDict>>> {
        self.mesh.layers().iter().map(|layer| layers::given(py, layer)).collect()
    }

    /// What the file says beside its elements.
    fn metadata<'py>(&self, py: Python<'py>) -> Vec<(String, Bound<'py, PyBytes>)> {
        let metadata = self.mesh.metadata().iter();
        metadata.map(|said| (said.key.clone(), PyBytes::new(py, &said.value))).collect()
    }

    /// The form of the file that it is from, such as `ply-le`.
    fn variant(&self) -> Option<&'static str> {
        self.origin.as_ref().map(|(origin, _)| origin.document.variant)
    }

    /// What reports call it: the name of the file, or of the part of it.
    pub(crate) fn title(&self) -> Option<String> {
        let (origin, part) = self.origin.as_ref()?;
        if origin.document.is_whole() {
            return Some(origin.name.clone());
        }
        let part = origin.document.parts.get(*part).map(meshmend::formats::Part::title);
        Some(format!("{}, {}", origin.name, part.unwrap_or_default()))
    }

    /// Whether the file holds more than the mesh: what is written to the same format is then written again.
    fn has_shell(&self) -> bool {
        self.origin.as_ref().is_some_and(|(origin, _)| !origin.document.is_whole())
    }

    /// What the reader had to say, as JSON.
    fn notes(&self, py: Python<'_>) -> PyResult<String> {
        let notes = self.origin.as_ref().map(|(origin, _)| &origin.document.notes[..]);
        errors::written(py, serde_json::to_string(notes.unwrap_or_default()))
    }
}

fn fill<T>(room: &mut [T], corners: &[VertexId], of: impl Fn(VertexId) -> T) {
    room.iter_mut().zip(corners).for_each(|(place, &vertex)| *place = of(vertex));
}

fn pairs<'py, I: Id>(py: Python<'py>, all: &[[I; 2]]) -> PyResult<Pairs<'py>> {
    ids(all.as_flattened()).into_pyarray(py).reshape([all.len(), 2])
}
