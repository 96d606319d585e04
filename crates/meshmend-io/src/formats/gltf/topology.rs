//! Which rows of a mesh are vertices, and which of them are one.

use meshmend_core::VertexId;

use crate::formats::gltf::asset::Asset;
use crate::formats::gltf::buffers::Bytes;
use crate::formats::gltf::fault::Fault;
use crate::formats::gltf::pools::Pools;
use crate::formats::gltf::primitives::{Mesh, Mode};
use crate::formats::gltf::rows::indices;
use crate::formats::gltf::triangles::stored_indices;

/// Which rows are vertices of the mesh.
pub(super) enum Topology {
    /// All, each by itself.
    Rows,
    /// The same, and the file says so.
    StatedRows,
    /// These, each by itself: the others are used by points and lines alone.
    Listed(Vec<u32>),
    /// The file says which vertex each corner is at, with a row for each vertex.
    Stated { corners: Vec<VertexId>, rows: Vec<u32> },
}

/// Which rows the elements of the mesh have.
pub(super) enum Rows {
    /// Vertex i has row i.
    Same,
    /// Each vertex has this row.
    OfVertices(Vec<u32>),
    /// Each corner has this row: a vertex may have several.
    OfCorners(Vec<u32>),
}

/// Which rows are vertices of the mesh.
///
/// # Errors
/// If an index names a row that does not exist.
pub(super) fn topology(
    asset: &Asset<'_>,
    mesh: &Mesh<'_>,
    pools: &Pools,
    bytes: &Bytes<'_>,
    positions: &[[f64; 3]],
    corners: &[VertexId],
) -> Result<Topology, Fault> {
    if let Some(stated) = stated(asset, mesh, bytes, positions, corners)? {
        return Ok(stated);
    }
    let shares = |at: usize| pools.of_primitive[at].is_some() && mesh.primitives[at].mode == Mode::NoFaces;
    if !(0..mesh.primitives.len()).any(shares) {
        return Ok(if states_rows(asset, mesh, bytes, corners)? {
            Topology::StatedRows
        } else {
            Topology::Rows
        });
    }
    let mut is_of_lines = vec![false; pools.rows];
    for (at, primitive) in mesh.primitives.iter().enumerate().filter(|&(at, _)| shares(at)) {
        let Some(pool) = pools.of_primitive[at].map(|pool| &pools.list[pool]) else { continue };
        for index in stored_indices(asset, primitive, bytes, pool.rows)? {
            is_of_lines[pool.base + index as usize] = true;
        }
    }
    corners.iter().for_each(|corner| is_of_lines[corner.0 as usize] = false);
    match is_of_lines.contains(&true) {
        true => {
            Ok(Topology::Listed((0..pools.rows as u32).filter(|&row| !is_of_lines[row as usize]).collect()))
        }
        false => Ok(Topology::Rows),
    }
}

/// The vertices that `EXT_mesh_manifold` states, if they differ from the rows and fit the faces: each vertex is at one
/// place.
fn stated(
    asset: &Asset<'_>,
    mesh: &Mesh<'_>,
    bytes: &Bytes<'_>,
    positions: &[[f64; 3]],
    corners: &[VertexId],
) -> Result<Option<Topology>, Fault> {
    let Some(accessor) = mesh.manifold_indices else { return Ok(None) };
    let accessor = asset.accessor(accessor)?;
    let numbers = indices(&accessor, bytes)?;
    if numbers.len() != corners.len()
        || numbers.iter().zip(corners).all(|(&number, corner)| number == corner.0)
    {
        return Ok(None);
    }
    let mut known = numbers.clone();
    known.sort_unstable();
    known.dedup();
    let mut rows: Vec<Option<u32>> = vec![None; known.len()];
    let mut vertices = Vec::with_capacity(corners.len());
    for (number, corner) in numbers.iter().zip(corners) {
        let Ok(vertex) = known.binary_search(number) else { return Ok(None) };
        let first = *rows[vertex].get_or_insert(corner.0);
        let (one, other) = (positions[first as usize], positions[corner.0 as usize]);
        if first != corner.0 && one != other {
            return Ok(None);
        }
        vertices.push(VertexId(vertex as u32));
    }
    let rows = rows.into_iter().flatten().collect();
    Ok(Some(Topology::Stated { corners: vertices, rows }))
}

/// Whether `EXT_mesh_manifold` states that each row is a vertex of its own.
fn states_rows(
    asset: &Asset<'_>,
    mesh: &Mesh<'_>,
    bytes: &Bytes<'_>,
    corners: &[VertexId],
) -> Result<bool, Fault> {
    let Some(accessor) = mesh.manifold_indices else { return Ok(false) };
    Ok(indices(&asset.accessor(accessor)?, bytes)?.into_iter().eq(corners.iter().map(|corner| corner.0)))
}

impl Topology {
    /// Whether the file says which vertices are one.
    pub(super) fn is_stated(&self) -> bool {
        matches!(self, Topology::StatedRows | Topology::Stated { .. })
    }

    pub(super) fn vertex_count(&self, rows: usize) -> usize {
        match self {
            Topology::Rows | Topology::StatedRows => rows,
            Topology::Listed(rows) | Topology::Stated { rows, .. } => rows.len(),
        }
    }

    /// Positions and corners of the vertices, given those of the rows.
    pub(super) fn applied(
        self,
        positions: Vec<[f64; 3]>,
        corners: Vec<VertexId>,
    ) -> (Vec<[f64; 3]>, Vec<VertexId>, Rows) {
        let of = |rows: &[u32]| rows.iter().map(|&row| positions[row as usize]).collect();
        match self {
            Topology::Rows | Topology::StatedRows => (positions, corners, Rows::Same),
            Topology::Listed(rows) => {
                let mut vertex = vec![0; positions.len()];
                rows.iter().enumerate().for_each(|(at, &row)| vertex[row as usize] = at as u32);
                let corners = corners.iter().map(|corner| VertexId(vertex[corner.0 as usize])).collect();
                (of(&rows), corners, Rows::OfVertices(rows))
            }
            Topology::Stated { corners: vertices, rows } => {
                let own = corners.iter().map(|corner| corner.0).collect();
                (of(&rows), vertices, Rows::OfCorners(own))
            }
        }
    }
}
