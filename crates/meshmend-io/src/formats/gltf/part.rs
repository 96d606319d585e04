//! A mesh of the file as a part of the document.

use meshmend_core::{Carry, Domain, FaceTable, Layer, NO_VALUE, PolygonMesh, Role, Values, VertexId};

use crate::formats::gltf::accessor::Component;
use crate::formats::gltf::asset::Asset;
use crate::formats::gltf::buffers::Bytes;
use crate::formats::gltf::fault::{Fault, Pointer};
use crate::formats::gltf::pools::{Column, Pools};
use crate::formats::gltf::primitives::{Mesh, Mode};
use crate::formats::gltf::rows::{append_positions, append_to_pool, empty_pool};
use crate::formats::gltf::topology::{Rows, topology};
use crate::formats::gltf::triangles::append_corners;

/// The layer that names the row of a vertex among those of its part.
pub(super) const RENDER_VERTEX: &str = "render-vertex";
/// The layer that names the primitive of a face.
pub(super) const PRIMITIVE: &str = "primitive";
/// The layer that names the place of a face among the triangles of its primitive.
pub(super) const FACE: &str = "face";
/// The layer that names the material of a face.
pub(super) const MATERIAL: &str = "material";

/// A mesh with all that the file says of its rows.
pub(super) struct ReadPart {
    pub(super) mesh: PolygonMesh,
    /// Triangles of strips that are no faces.
    pub(super) stitches: usize,
    /// Whether the file says which vertices are one.
    pub(super) tells_vertices: bool,
}

/// The rows and corners of a mesh, as stored.
pub(super) struct Stored {
    pub(super) positions: Vec<[f64; 3]>,
    /// The row of each corner.
    pub(super) corners: Vec<VertexId>,
    /// How many corners there are up to the end of each primitive.
    pub(super) ends: Vec<usize>,
    pub(super) stitches: usize,
}

impl Stored {
    /// Reads the rows and corners of a mesh.
    ///
    /// # Errors
    /// If an accessor is malformed, or an index names a row that does not exist.
    pub(super) fn of(
        asset: &Asset<'_>,
        mesh: &Mesh<'_>,
        pools: &Pools,
        bytes: &Bytes<'_>,
    ) -> Result<Self, Fault> {
        let mut stored = Stored { positions: Vec::new(), corners: Vec::new(), ends: Vec::new(), stitches: 0 };
        for pool in &pools.list {
            if let Some(accessor) = pool.positions() {
                append_positions(accessor, bytes, &mut stored.positions)?;
            }
        }
        for (primitive, pool) in mesh.primitives.iter().zip(&pools.of_primitive) {
            if let (Some(pool), true) = (*pool, primitive.mode != Mode::NoFaces) {
                let pool = &pools.list[pool];
                stored.stitches += append_corners(asset, primitive, bytes, pool, &mut stored.corners)?;
            }
            stored.ends.push(stored.corners.len());
        }
        Ok(stored)
    }
}

/// Reads a mesh of the file.
///
/// # Errors
/// As [`Stored::of`].
pub(super) fn read_part(
    asset: &Asset<'_>,
    mesh: &Mesh<'_>,
    pools: &Pools,
    bytes: &Bytes<'_>,
) -> Result<ReadPart, Fault> {
    let Stored { positions, corners, ends, stitches } = Stored::of(asset, mesh, pools, bytes)?;
    let topology = topology(asset, mesh, pools, bytes, &positions, &corners)?;
    let tells_vertices = topology.is_stated();
    let vertices = topology.vertex_count(positions.len());
    let (positions, corners, rows) = topology.applied(positions, corners);
    let pointer = || Pointer::item("meshes", mesh.object.pointer.index().unwrap_or_default());
    let failed = |error: &dyn std::fmt::Display| pointer().fault(error.to_string());
    let faces = FaceTable::triangles(vertices, corners).map_err(|error| failed(&error))?;
    let mut layers = vec![render_vertices(pools.rows, vertices, &rows)];
    layers.extend(face_layers(asset, mesh, &ends));
    for column in pools.columns() {
        layers.push(layer_of(&column, pools, bytes, vertices, &rows)?);
    }
    let mesh = PolygonMesh::new(positions, faces).map_err(|error| failed(&error))?;
    let mesh = mesh.with_layers(layers).map_err(|error| failed(&error))?;
    Ok(ReadPart { mesh, stitches, tells_vertices })
}

fn render_vertices(count: usize, vertices: usize, rows: &Rows) -> Layer {
    let numbers = Values::U32((0..count as u32).collect());
    of_rows(RENDER_VERTEX, (1, Carry::Clear, numbers), None, vertices, rows).with_role(Role::Identity)
}

/// A layer of a value for each row, or for those that have one.
fn of_rows(
    name: &str,
    (width, carry, values): (usize, Carry, Values),
    value_of: Option<Vec<u32>>,
    vertices: usize,
    rows: &Rows,
) -> Layer {
    let use_of = |&row: &u32| value_of.as_ref().map_or(row, |values| values[row as usize]);
    match rows {
        Rows::Same => match value_of {
            None => Layer::direct(name, Domain::Vertex, width, carry, values),
            Some(uses) => Layer::indexed(name, Domain::Vertex, width, carry, values, uses),
        },
        Rows::OfVertices(rows) => {
            Layer::indexed(name, Domain::Vertex, width, carry, values, rows.iter().map(use_of).collect())
        }
        Rows::OfCorners(rows) => {
            let uses = rows.iter().map(use_of).collect();
            Layer::indexed(name, Domain::Corner, width, carry, values, uses).at_home_on_vertices(vertices)
        }
    }
}

/// The layer of a column, for so many vertices.
///
/// # Errors
/// If the bytes of its accessors are not there.
pub(super) fn layer_of(
    column: &Column,
    pools: &Pools,
    bytes: &Bytes<'_>,
    vertices: usize,
    rows: &Rows,
) -> Result<Layer, Fault> {
    let (semantic, form) = (&column.semantic, column.form);
    let mut values = empty_pool(form.component);
    let mut uses = None;
    if column.accessors.len() < pools.list.len() {
        uses = Some(vec![NO_VALUE; pools.rows]);
    }
    for (pool, accessor) in &column.accessors {
        let pool = &pools.list[*pool];
        let first = values.len() / form.width();
        append_to_pool(accessor, bytes, &mut values)?;
        if let Some(uses) = &mut uses {
            let slots = uses[pool.base..][..pool.rows].iter_mut();
            slots.enumerate().for_each(|(row, slot)| *slot = (first + row) as u32);
        }
    }
    // Whole numbers of a name that only the file knows are names themselves.
    let is_name = semantic.name.starts_with('_') && form.component != Component::F32;
    let carry = if is_name { Carry::Copy } else { semantic.carry() };
    let layer = of_rows(&semantic.layer_name(), (form.width(), carry, values), uses, vertices, rows);
    Ok(layer.with_role(semantic.role()).with_normalized(form.normalized))
}

/// The primitive, the place in it, and the material of each face.
fn face_layers(asset: &Asset<'_>, mesh: &Mesh<'_>, ends: &[usize]) -> Vec<Layer> {
    let counts: Vec<usize> =
        ends.iter().scan(0, |start, &end| Some((end - std::mem::replace(start, end)) / 3)).collect();
    let by_face = |value: &dyn Fn(usize) -> u32| -> Vec<u32> {
        let runs = counts.iter().enumerate();
        runs.flat_map(|(at, &count)| std::iter::repeat_n(value(at), count)).collect()
    };
    let numbers = Values::U32((0..counts.len() as u32).collect());
    let primitive =
        Layer::indexed(PRIMITIVE, Domain::Face, 1, Carry::Clear, numbers, by_face(&|at| at as u32));
    let places = counts.iter().flat_map(|&count| 0..count as u32).collect();
    let face = Layer::direct(FACE, Domain::Face, 1, Carry::Clear, Values::U32(places));
    let mut layers = vec![primitive.with_role(Role::Identity), face.with_role(Role::Identity)];
    let mut used: Vec<usize> = mesh.primitives.iter().filter_map(|primitive| primitive.material).collect();
    used.sort_unstable();
    used.dedup();
    if !used.is_empty() {
        let names = used.iter().map(|&material| asset.material_names().name(material).to_vec()).collect();
        let material = |at: usize| -> u32 {
            let material = mesh.primitives[at].material;
            material.and_then(|m| used.binary_search(&m).ok()).map_or(NO_VALUE, |value| value as u32)
        };
        let uses = by_face(&material);
        layers.push(Layer::indexed(MATERIAL, Domain::Face, 1, Carry::Copy, Values::Text(names), uses));
    }
    layers
}
