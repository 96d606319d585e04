//! The pools of a mesh: primitives that name the same accessors share their vertices.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use crate::formats::gltf::accessor::{Accessor, Form};
use crate::formats::gltf::asset::Asset;
use crate::formats::gltf::fault::Fault;
use crate::formats::gltf::primitives::{Mesh, Mode, Primitive};
use crate::formats::gltf::semantic::Semantic;

/// The vertices of the file that some primitives share.
pub(super) struct Pool {
    /// Sorted.
    pub(super) attributes: Vec<(Semantic, Accessor)>,
    /// How many vertices there are.
    pub(super) rows: usize,
    /// The number of the first one among all of the part.
    pub(super) base: usize,
    /// Which primitives, those without faces included.
    pub(super) primitives: Vec<usize>,
}

impl Pool {
    /// The accessor that holds the positions.
    pub(super) fn positions(&self) -> Option<&Accessor> {
        self.attributes.iter().find(|(semantic, _)| semantic.is_position()).map(|(_, accessor)| accessor)
    }
}

/// The vertices of a part: pool after pool, in the order in which faces first use them.
pub(super) struct Pools {
    pub(super) list: Vec<Pool>,
    /// The pool of each primitive. One whose pool has no face has none.
    pub(super) of_primitive: Vec<Option<usize>>,
    /// How many vertices all of them have.
    pub(super) rows: usize,
}

/// An attribute that is stored in one way by some of the pools: one layer.
pub(super) struct Column {
    pub(super) semantic: Semantic,
    pub(super) form: Form,
    /// The pools that have it, each with the accessor.
    pub(super) accessors: Vec<(usize, Accessor)>,
}

impl Pools {
    /// The pools of a mesh.
    ///
    /// # Errors
    /// If an accessor is malformed, or attributes of one primitive have different numbers of rows.
    pub(super) fn of(asset: &Asset<'_>, mesh: &Mesh<'_>) -> Result<Self, Fault> {
        let mut known: BTreeMap<Vec<(Semantic, usize)>, usize> = BTreeMap::new();
        let mut pools = Pools { list: Vec::new(), of_primitive: Vec::new(), rows: 0 };
        for primitive in mesh.primitives.iter().filter(|primitive| primitive.mode != Mode::NoFaces) {
            let key = key_of(primitive);
            if let Entry::Vacant(entry) = known.entry(key) {
                let pool = pool_of(asset, primitive, entry.key(), pools.rows)?;
                pools.rows += pool.rows;
                entry.insert(pools.list.len());
                pools.list.push(pool);
            }
        }
        pools.of_primitive =
            mesh.primitives.iter().map(|primitive| known.get(&key_of(primitive)).copied()).collect();
        for (at, pool) in pools.of_primitive.iter().enumerate() {
            if let Some(pool) = *pool {
                pools.list[pool].primitives.push(at);
            }
        }
        Ok(pools)
    }

    /// The attributes of all pools but the positions, one for each way in which one is stored; sorted by pool, then by name.
    pub(super) fn columns(&self) -> Vec<Column> {
        let mut known: BTreeMap<(Semantic, Form), usize> = BTreeMap::new();
        let mut columns: Vec<Column> = Vec::new();
        for (at, pool) in self.list.iter().enumerate() {
            for (semantic, accessor) in pool.attributes.iter().filter(|(semantic, _)| !semantic.is_position())
            {
                let (semantic, form) = (semantic.clone(), accessor.form);
                let column = *known.entry((semantic.clone(), form)).or_insert(columns.len());
                if column == columns.len() {
                    columns.push(Column { semantic, form, accessors: Vec::new() });
                }
                columns[column].accessors.push((at, accessor.clone()));
            }
        }
        columns
    }
}

fn key_of(primitive: &Primitive<'_>) -> Vec<(Semantic, usize)> {
    let mut key = primitive.attributes.clone();
    key.sort();
    key
}

fn pool_of(
    asset: &Asset<'_>,
    primitive: &Primitive<'_>,
    key: &[(Semantic, usize)],
    base: usize,
) -> Result<Pool, Fault> {
    let accessor =
        |(semantic, accessor): &(Semantic, usize)| Ok((semantic.clone(), asset.accessor(*accessor)?));
    let attributes: Vec<(Semantic, Accessor)> = key.iter().map(accessor).collect::<Result<_, Fault>>()?;
    let mut pool = Pool { attributes, rows: 0, base, primitives: Vec::new() };
    pool.rows = pool.positions().map_or(0, |positions| positions.count);
    let differs = |(_, accessor): &&(Semantic, Accessor)| accessor.count != pool.rows;
    if let Some((semantic, accessor)) = pool.attributes.iter().find(differs) {
        let reason =
            format!("{} has {} rows where POSITION has {}", semantic.name, accessor.count, pool.rows);
        return Err(primitive.object.pointer.fault(reason));
    }
    Ok(pool)
}
