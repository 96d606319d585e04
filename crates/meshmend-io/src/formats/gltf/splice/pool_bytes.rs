//! The bytes of a pool's rows: those of the file where they stay, new ones where a value came or changed.

use meshmend_core::Role;

use crate::formats::gltf::accessor::Component;
use crate::formats::gltf::buffers::Bytes;
use crate::formats::gltf::fault::Fault;
use crate::formats::gltf::pools::Pool;
use crate::formats::gltf::rows::{append_to_pool, empty_pool};
use crate::formats::gltf::splice::classes::{NewPool, NewRow};
use crate::formats::gltf::splice::part_rows::{Attribute, PartRows};
use crate::formats::gltf::splice::values::RowBytes;

/// All rows that an accessor is to have.
pub(super) struct RowsOfAccessor {
    /// The accessor that has them in the file.
    pub(super) accessor: usize,
    /// The name of the attribute, and the morph target that it is of.
    pub(super) name: String,
    pub(super) target: Option<usize>,
    pub(super) rows: RowBytes,
}

/// What was not written as it is.
#[derive(Default)]
pub(super) struct Rounded {
    /// Created vertices whose position was rounded, and by how much at most.
    pub(super) positions: usize,
    pub(super) farthest: f64,
    /// Values that a vertex does not have, and that the file must.
    pub(super) absent: usize,
}

/// The rows of all accessors of a pool.
///
/// # Errors
/// If the bytes of the file are not there.
pub(super) fn pool_bytes(
    part: &PartRows<'_>,
    pool: &Pool,
    new: &NewPool,
    bytes: &Bytes<'_>,
    rounded: &mut Rounded,
) -> Result<Vec<RowsOfAccessor>, Fault> {
    let mut all = Vec::with_capacity(pool.attributes.len());
    for (semantic, accessor) in &pool.attributes {
        let mut rows = RowBytes::new(accessor.form);
        if semantic.is_position() {
            let mut stored = empty_pool(accessor.form.component);
            append_to_pool(accessor, bytes, &mut stored)?;
            for row in &new.rows {
                match (kept_position(part, row), row.corner) {
                    (Some(old), _) => rows.push_value(&stored, old as usize - pool.base),
                    (None, Some(corner)) => {
                        let moved = rows.push_numbers(&part.position(corner));
                        rounded.positions += usize::from(moved > 0.0);
                        rounded.farthest = rounded.farthest.max(moved);
                    }
                    (None, None) => rows.push_absent(Role::Plain),
                }
            }
        } else {
            let is_it = |attribute: &&Attribute<'_>| {
                attribute.semantic == *semantic && attribute.form == accessor.form
            };
            if let Some(attribute) = part.attributes.iter().find(is_it) {
                new.rows.iter().for_each(|row| push(part, attribute, row, &mut rows, rounded));
            }
        }
        all.push(RowsOfAccessor {
            accessor: accessor.index,
            name: semantic.name.clone(),
            target: semantic.target,
            rows,
        });
    }
    Ok(all)
}

/// The row of the file whose position a row has.
fn kept_position(part: &PartRows<'_>, row: &NewRow) -> Option<u32> {
    row.old.filter(|&old| row.is_as_stored || row.corner.is_none_or(|corner| part.is_at(corner, old)))
}

fn push(
    part: &PartRows<'_>,
    attribute: &Attribute<'_>,
    row: &NewRow,
    rows: &mut RowBytes,
    rounded: &mut Rounded,
) {
    let keeps =
        |old: &u32| row.is_as_stored || row.corner.is_none_or(|corner| part.keeps(attribute, corner, *old));
    let stored = row.old.filter(keeps).and_then(|old| attribute.rows.value_of(old as usize));
    if let Some(stored) = stored {
        return rows.push_value(attribute.rows.values(), stored);
    }
    let role = attribute.rows.role();
    match row.corner.and_then(|corner| part.value(attribute, corner)) {
        Some((values, value)) => {
            rows.push_value(values, value);
            if row.old.is_none() && attribute.form.component == Component::F32 {
                rows.settle_last(role);
            }
        }
        None => {
            rounded.absent += 1;
            rows.push_absent(role);
        }
    }
}
