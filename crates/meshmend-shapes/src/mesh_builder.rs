//! A mesh while it is being made: points and faces, one after another.

use std::f64::consts::TAU;

use meshmend_core::{FaceTableBuilder, FaceTableError, MAX_CORNERS, PolygonMesh, VertexId};

use crate::{Closed, Shape, ShapeError, Truth};

/// Points and faces over them.
#[derive(Clone, Default)]
pub(crate) struct MeshBuilder {
    positions: Vec<[f64; 3]>,
    faces: FaceTableBuilder,
}

impl MeshBuilder {
    /// An empty builder, if a mesh has room for as many corners as the product of the factors, or for as many
    /// vertices, and so has the memory.
    pub(crate) fn with_room(factors: &[usize]) -> Result<Self, ShapeError> {
        has_room(factors.iter().fold(1usize, |product, &factor| product.saturating_mul(factor)))?;
        Ok(MeshBuilder::default())
    }

    /// Adds a point and gives its vertex.
    pub(crate) fn point(&mut self, place: [f64; 3]) -> u32 {
        self.positions.push(place);
        self.positions.len() as u32 - 1
    }

    /// Adds points.
    pub(crate) fn points(&mut self, places: impl IntoIterator<Item = [f64; 3]>) {
        self.positions.extend(places);
    }

    /// Adds a face.
    pub(crate) fn face(&mut self, vertices: &[u32]) {
        self.faces.push_face(vertices.iter().copied().map(VertexId));
    }

    /// The vertex of the next point.
    pub(crate) fn next(&self) -> u32 {
        self.positions.len() as u32
    }

    pub(crate) fn mesh(self) -> Result<PolygonMesh, ShapeError> {
        let faces = self.faces.build(self.positions.len())?;
        Ok(PolygonMesh::new(self.positions, faces)?)
    }

    pub(crate) fn shape(self, name: impl Into<String>, truth: Truth) -> Result<Shape, ShapeError> {
        Ok(Shape { name: name.into(), mesh: self.mesh()?, truth })
    }

    /// A connected surface with V, E and F.
    pub(crate) fn surface(
        self,
        name: impl Into<String>,
        kind: Closed,
        holes: usize,
        counts: [usize; 3],
    ) -> Result<Shape, ShapeError> {
        self.shape(name, Truth::surface(kind, holes, counts))
    }

    /// A connected complex with V, E and F that is not a manifold, with orientable patches and no torsion.
    pub(crate) fn branched(
        self,
        name: impl Into<String>,
        betti: [usize; 3],
        counts: [usize; 3],
    ) -> Result<Shape, ShapeError> {
        self.shape(name, Truth::branched(betti, counts))
    }
}

/// What a mesh takes at most while it is made, for each of its corners: its vertices, tables and edges, and those of
/// the coarser one that it is made from.
const BYTES_A_CORNER: usize = 40;

/// Fails unless a mesh holds so many corners, and the memory that it takes can be had. None of it is taken.
pub(crate) fn has_room(corners: usize) -> Result<(), ShapeError> {
    if corners >= MAX_CORNERS {
        return Err(FaceTableError::TooLarge { what: "corners", count: corners }.into());
    }
    let bytes = corners.saturating_mul(BYTES_A_CORNER);
    let asked: Result<(), _> = Vec::<u8>::new().try_reserve_exact(bytes);
    asked.map_err(|_| ShapeError::NoMemory { corners, bytes })
}

/// The size, if it is not too small.
pub(crate) fn at_least(least: usize, size: &'static str, given: usize) -> Result<(), ShapeError> {
    if given < least { Err(ShapeError::TooSmall { size, given, least }) } else { Ok(()) }
}

/// n points of a circle about the z axis.
pub(crate) fn circle(n: usize, radius: f64, height: f64) -> impl Iterator<Item = [f64; 3]> {
    (0..n).map(move |i| {
        let turn = TAU * i as f64 / n as f64;
        [radius * turn.cos(), radius * turn.sin(), height]
    })
}

/// Points in general position: point i is at (i, i², i³), so no two coincide, no three are on a line and no four in a
/// plane.
pub(crate) fn general_position(count: usize) -> impl Iterator<Item = [f64; 3]> {
    (0..count).map(|i| i as f64).map(|t| [t, t * t, t * t * t])
}
