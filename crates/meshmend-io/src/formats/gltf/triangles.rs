//! The triangles of primitives: lists, strips and fans of vertices.

use meshmend_core::VertexId;

use crate::formats::gltf::accessor::{Accessor, is_index};
use crate::formats::gltf::asset::Asset;
use crate::formats::gltf::buffers::Bytes;
use crate::formats::gltf::fault::{Fault, Pointer};
use crate::formats::gltf::pools::Pool;
use crate::formats::gltf::primitives::{Mode, Primitive};
use crate::formats::gltf::rows::{Number, indices, pointer};

/// Where the indices of a primitive are.
///
/// # Errors
/// If they are not whole numbers one by one.
fn index_accessor(asset: &Asset<'_>, primitive: &Primitive<'_>) -> Result<Option<Accessor>, Fault> {
    let Some(index) = primitive.indices else { return Ok(None) };
    let accessor = asset.accessor(index)?;
    match accessor.form.width() {
        1 => Ok(Some(accessor)),
        _ => Err(pointer(&accessor).member("type").fault("is not SCALAR, as indices are")),
    }
}

/// The indices of a primitive, as stored; those of all its vertices in order if it has none.
///
/// # Errors
/// If one names a vertex that does not exist.
pub(super) fn stored_indices(
    asset: &Asset<'_>,
    primitive: &Primitive<'_>,
    bytes: &Bytes<'_>,
    rows: usize,
) -> Result<Vec<u32>, Fault> {
    let Some(accessor) = index_accessor(asset, primitive)? else {
        return Ok((0..rows as u32).collect());
    };
    let found = indices(&accessor, bytes)?;
    match found.iter().position(|&index| index as usize >= rows) {
        Some(at) => Err(no_such_vertex(&accessor, at, found[at], rows)),
        None => Ok(found),
    }
}

fn no_such_vertex(accessor: &Accessor, at: usize, index: u32, rows: usize) -> Fault {
    let reason = format!("index {at} is {index}, but the primitive has {rows} vertices");
    pointer(accessor).fault(reason)
}

/// Appends the corners of a primitive's triangles, as vertices of the part; returns how many triangles of a strip were left
/// out, as they only lead from one piece of it to the next.
///
/// # Errors
/// As [`stored_indices`]; if there are not enough for whole triangles.
pub(super) fn append_corners(
    asset: &Asset<'_>,
    primitive: &Primitive<'_>,
    bytes: &Bytes<'_>,
    pool: &Pool,
    corners: &mut Vec<VertexId>,
) -> Result<usize, Fault> {
    let accessor = index_accessor(asset, primitive)?;
    let count = accessor.as_ref().map_or(pool.rows, |accessor| accessor.count);
    check_count(primitive.mode, count, &primitive.object.pointer)?;
    if let (Mode::Triangles, Some(accessor)) = (primitive.mode, &accessor)
        && append_listed(accessor, bytes, pool, corners)?
    {
        return Ok(0);
    }
    let indices = stored_indices(asset, primitive, bytes, pool.rows)?;
    let base = pool.base as u32;
    let before = corners.len();
    let mut push = |triangle: [u32; 3]| corners.extend(triangle.map(|index| VertexId(base + index)));
    match primitive.mode {
        Mode::NoFaces => return Ok(0),
        Mode::Triangles => corners.extend(indices.iter().map(|index| VertexId(base + index))),
        Mode::Fan => indices.windows(2).skip(1).for_each(|pair| push([pair[0], pair[1], indices[0]])),
        Mode::Strip => {
            let turned =
                |(at, v): (usize, &[u32])| if at % 2 == 0 { [v[0], v[1], v[2]] } else { [v[0], v[2], v[1]] };
            let triangles = indices.windows(3).enumerate().map(turned);
            triangles.filter(|[a, b, c]| a != b && b != c && a != c).for_each(push);
            return Ok(indices.len() - 2 - (corners.len() - before) / 3);
        }
    }
    Ok(0)
}

fn check_count(mode: Mode, count: usize, pointer: &Pointer) -> Result<(), Fault> {
    match mode {
        Mode::Triangles if !count.is_multiple_of(3) => {
            Err(pointer.fault(format!("{count} indices are not whole triangles")))
        }
        Mode::Strip | Mode::Fan if count < 3 => {
            Err(pointer.fault(format!("{count} indices are too few for a triangle")))
        }
        _ => Ok(()),
    }
}

/// Appends indices that stand without gaps in one go; says whether they do.
fn append_listed(
    accessor: &Accessor,
    bytes: &Bytes<'_>,
    pool: &Pool,
    corners: &mut Vec<VertexId>,
) -> Result<bool, Fault> {
    let size = accessor.form.size();
    let Some(place) = accessor.place.filter(|place| place.stride == size && accessor.sparse.is_none()) else {
        return Ok(false);
    };
    let data = bytes.rows(&place, accessor.count, size)?;
    corners.reserve(accessor.count);
    let highest = match size {
        1 => extend::<u8>(data, pool.base as u32, corners),
        2 => extend::<u16>(data, pool.base as u32, corners),
        _ => extend::<u32>(data, pool.base as u32, corners),
    };
    // What is wrong with the indices is found where they are read one by one.
    let is_listed = (highest as usize) < pool.rows && is_index(accessor.form.component);
    if !is_listed {
        corners.truncate(corners.len() - accessor.count);
    }
    Ok(is_listed)
}

fn extend<T: Number + Into<u32>>(data: &[u8], base: u32, corners: &mut Vec<VertexId>) -> u32 {
    let mut highest = 0;
    corners.extend(data.chunks_exact(T::SIZE).map(|bytes| {
        let index: u32 = T::of(bytes).into();
        highest = highest.max(index);
        VertexId(base.wrapping_add(index))
    }));
    highest
}
