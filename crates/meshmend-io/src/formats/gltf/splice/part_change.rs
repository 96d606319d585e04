//! What of a mesh of the file is written anew, and what stays.

use meshmend_core::{CornerId, FaceId, PolygonMesh};

use crate::formats::gltf::accessor::Component;
use crate::formats::gltf::asset::Asset;
use crate::formats::gltf::buffers::Bytes;
use crate::formats::gltf::fault::Fault;
use crate::formats::gltf::primitives::{Mesh, Mode, Primitive};
use crate::formats::gltf::splice::classes::{Classes, NewPool};
use crate::formats::gltf::splice::closed_manifold::is_closed_manifold;
use crate::formats::gltf::splice::part_rows::PartRows;
use crate::formats::gltf::splice::pool_bytes::{Rounded, RowsOfAccessor, pool_bytes};
use crate::formats::gltf::triangles::stored_indices;
use crate::{Loss, ManifoldExtension};

/// What of a mesh is written anew.
pub(super) struct PartChange {
    /// Which mesh.
    pub(super) mesh: usize,
    /// The pools whose rows went, came or changed.
    pub(super) pools: Vec<PoolChange>,
    pub(super) primitives: Vec<PrimitiveChange>,
    /// The vertices of the corners of all primitives, as numbers of rows; `None` if there are several pools.
    pub(super) vertices: Option<Vec<u32>>,
    pub(super) told: Told,
}

/// What is to be said of a part that was written anew.
#[derive(Default)]
pub(super) struct Told {
    /// Rows that are written once more.
    pub(super) parted: usize,
    pub(super) rounded: Rounded,
    /// Faces that no primitive takes.
    pub(super) homeless: usize,
}

/// A pool whose rows went, came or changed.
pub(super) struct PoolChange {
    pub(super) primitives: Vec<usize>,
    pub(super) rows: Vec<RowsOfAccessor>,
}

/// A primitive that changed.
pub(super) struct PrimitiveChange {
    pub(super) primitive: usize,
    pub(super) change: Change,
}

/// What becomes of a primitive.
pub(super) enum Change {
    /// It has no face left.
    Removed,
    /// It has other indices.
    Indices {
        indices: Vec<u32>,
        component: Component,
        /// Whether its faces were no list of indices, and are one now.
        becomes_list: bool,
        /// Whether its triangles are others than before, or stand in another order.
        has_other_faces: bool,
    },
}

/// What becomes of a mesh.
pub(super) enum Outcome {
    /// It stays as it is; with the vertices of its corners, as in a part that changed.
    Unchanged(Option<Vec<u32>>),
    /// It would have no primitive left, which no file may say: it stays as it is.
    Emptied,
    Changed(Box<PartChange>),
}

/// What came of comparing a mesh with what the file has.
pub(super) struct Compared {
    pub(super) outcome: Outcome,
    /// What of the mesh has no place in the file.
    pub(super) losses: Vec<Loss>,
}

/// Compares a mesh with what the file has.
///
/// # Errors
/// As those of reading the mesh.
pub(super) fn compared(
    asset: &Asset<'_>,
    index: usize,
    bytes: &Bytes<'_>,
    now: &PolygonMesh,
    wanted: ManifoldExtension,
) -> Result<Compared, Fault> {
    let mesh = asset.mesh(index)?;
    let part = PartRows::of(asset, &mesh, bytes, now)?;
    let mut outcome = outcome(asset, index, &mesh, bytes, &part)?;
    if let Outcome::Unchanged(vertices) = &mut outcome {
        let is_asked_for = wanted == ManifoldExtension::Add && mesh.manifold_indices.is_none();
        if let Some(vertices) = vertices.take_if(|vertices| is_asked_for && is_closed_manifold(vertices)) {
            let (pools, primitives, told) = (Vec::new(), Vec::new(), Told::default());
            let change = PartChange { mesh: index, pools, primitives, vertices: Some(vertices), told };
            outcome = Outcome::Changed(Box::new(change));
        }
    }
    Ok(Compared { outcome, losses: part.unknown_layers() })
}

fn outcome(
    asset: &Asset<'_>,
    index: usize,
    mesh: &Mesh<'_>,
    bytes: &Bytes<'_>,
    part: &PartRows<'_>,
) -> Result<Outcome, Fault> {
    let classes = Classes::of(part, &kept_rows(asset, mesh, bytes, part)?);
    let changes = Changes { asset, mesh, bytes, part, classes: &classes };
    let primitives = changes.primitives()?;
    let is_removed = |change: &PrimitiveChange| matches!(change.change, Change::Removed);
    let removed = primitives.iter().filter(|change| is_removed(change)).count();
    if removed > 0 && removed == mesh.primitives.len() {
        return Ok(Outcome::Emptied);
    }
    let has_home = |face: &&Option<usize>| face.is_none();
    let mut told = Told { homeless: classes.primitives.iter().filter(has_home).count(), ..Told::default() };
    let mut pools = Vec::new();
    for (pool, new) in part.pools.list.iter().zip(&classes.pools).filter(|(_, new)| new.is_changed) {
        told.parted += new.parted;
        let rows = pool_bytes(part, pool, new, bytes, &mut told.rounded)?;
        pools.push(PoolChange { primitives: pool.primitives.clone(), rows });
    }
    let vertices = (part.pools.list.len() == 1).then(|| changes.vertices());
    if pools.is_empty() && primitives.is_empty() && told.homeless == 0 {
        return Ok(Outcome::Unchanged(vertices));
    }
    Ok(Outcome::Changed(Box::new(PartChange { mesh: index, pools, primitives, vertices, told })))
}

/// Which rows stay though no face uses them: those of points and lines, and all of a part that has such vertices.
fn kept_rows(
    asset: &Asset<'_>,
    mesh: &Mesh<'_>,
    bytes: &Bytes<'_>,
    part: &PartRows<'_>,
) -> Result<Vec<bool>, Fault> {
    let faces = part.mesh.faces();
    let mut has_corner = vec![false; faces.vertex_count()];
    faces.corner_vertices().iter().for_each(|vertex| has_corner[vertex.0 as usize] = true);
    let mut is_kept = vec![has_corner.contains(&false); part.pools.rows];
    if mesh.manifold_indices.is_some() {
        is_kept.fill(true);
        part.stored
            .corners
            .iter()
            .for_each(|corner| is_kept[corner.0 as usize] = has_corner.contains(&false));
    }
    for (primitive, pool) in mesh.primitives.iter().zip(&part.pools.of_primitive) {
        if let (Mode::NoFaces, Some(pool)) = (primitive.mode, *pool) {
            let pool = &part.pools.list[pool];
            for index in stored_indices(asset, primitive, bytes, pool.rows)? {
                is_kept[pool.base + index as usize] = true;
            }
        }
    }
    Ok(is_kept)
}

struct Changes<'c, 'p, 'a> {
    asset: &'c Asset<'a>,
    mesh: &'c Mesh<'a>,
    bytes: &'c Bytes<'a>,
    part: &'c PartRows<'p>,
    classes: &'c Classes,
}

impl Changes<'_, '_, '_> {
    fn primitives(&self) -> Result<Vec<PrimitiveChange>, Fault> {
        let mut corners: Vec<Vec<CornerId>> = vec![Vec::new(); self.mesh.primitives.len()];
        let faces = self.part.mesh.faces();
        for (face, primitive) in self.classes.primitives.iter().enumerate() {
            if let Some(primitive) = *primitive {
                corners[primitive].extend(faces.face_corners(FaceId(face as u32)));
            }
        }
        let mut changes = Vec::new();
        for (at, primitive) in self.mesh.primitives.iter().enumerate() {
            let Some(pool) = self.part.pools.of_primitive[at] else { continue };
            let change = self.change(at, primitive, pool, &corners[at])?;
            changes.extend(change.map(|change| PrimitiveChange { primitive: at, change }));
        }
        Ok(changes)
    }

    fn change(
        &self,
        at: usize,
        primitive: &Primitive<'_>,
        pool: usize,
        corners: &[CornerId],
    ) -> Result<Option<Change>, Fault> {
        let (stored_pool, new_pool) = (&self.part.pools.list[pool], &self.classes.pools[pool]);
        let now: Vec<u32> = corners.iter().map(|corner| self.classes.corners[corner.0 as usize]).collect();
        let start = at.checked_sub(1).map_or(0, |before| self.part.stored.ends[before]);
        let stored = &self.part.stored.corners[start..self.part.stored.ends[at]];
        let mapped = |row: u32| new_pool.row_now[row as usize];
        let is_same = stored.len() == now.len()
            && stored
                .iter()
                .zip(&now)
                .all(|(row, now)| mapped(row.0 - stored_pool.base as u32) == Some(*now));
        let component = self.component(primitive, new_pool)?;
        if is_same {
            let old = stored_indices(self.asset, primitive, self.bytes, stored_pool.rows)?;
            let new: Option<Vec<u32>> = old.iter().map(|&row| mapped(row)).collect();
            if let Some(indices) = new {
                let is_kept = indices == old
                    && (primitive.indices.is_some() || new_pool.rows.len() == stored_pool.rows);
                let becomes_list = primitive.indices.is_none();
                let change = Change::Indices { indices, component, becomes_list, has_other_faces: false };
                return Ok((!is_kept).then_some(change));
            }
        }
        if now.is_empty() {
            return Ok((!stored.is_empty()).then_some(Change::Removed));
        }
        let becomes_list = primitive.indices.is_none() || primitive.mode != Mode::Triangles;
        Ok(Some(Change::Indices { indices: now, component, becomes_list, has_other_faces: true }))
    }

    /// The type of a primitive's indices: the one that it has, if the greatest number of that is more than all of them.
    fn component(&self, primitive: &Primitive<'_>, pool: &NewPool) -> Result<Component, Fault> {
        let old = match primitive.indices {
            Some(indices) => self.asset.accessor(indices)?.form.component,
            None => Component::U16,
        };
        let rows = pool.rows.len();
        Ok(match old {
            Component::U8 if rows <= usize::from(u8::MAX) => Component::U8,
            Component::U8 | Component::U16 if rows <= usize::from(u16::MAX) => Component::U16,
            _ => Component::U32,
        })
    }

    /// For each corner, in the order of the file, the first row of its vertex.
    fn vertices(&self) -> Vec<u32> {
        let faces = self.part.mesh.faces();
        let mut first: Vec<u32> = vec![u32::MAX; faces.vertex_count()];
        for corner in faces.corners() {
            let slot = &mut first[self.part.vertex(corner).0 as usize];
            *slot = (*slot).min(self.classes.corners[corner.0 as usize]);
        }
        let mut order: Vec<(Option<usize>, usize)> =
            self.classes.primitives.iter().enumerate().map(|(face, &primitive)| (primitive, face)).collect();
        order.sort_unstable();
        let corners = order.into_iter().flat_map(|(_, face)| faces.face_corners(FaceId(face as u32)));
        corners.map(|corner| first[self.part.vertex(corner).0 as usize]).collect()
    }
}
