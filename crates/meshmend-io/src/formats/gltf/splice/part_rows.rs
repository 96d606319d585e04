//! A part as it is now, in terms of the rows that the file has.

use meshmend_core::{CornerId, Domain, Id, Layer, PolygonMesh, Values, VertexId};

use crate::formats::gltf::accessor::Form;
use crate::formats::gltf::asset::Asset;
use crate::formats::gltf::buffers::Bytes;
use crate::formats::gltf::fault::Fault;
use crate::formats::gltf::part::{FACE, MATERIAL, PRIMITIVE, RENDER_VERTEX, Stored, layer_of};
use crate::formats::gltf::pools::Pools;
use crate::formats::gltf::primitives::Mesh;
use crate::formats::gltf::semantic::Semantic;
use crate::formats::gltf::splice::values::same_bits;
use crate::formats::gltf::topology::Rows;
use crate::{Loss, LossKind};

/// An attribute as the file has it, row by row, and as the part has it now.
pub(super) struct Attribute<'p> {
    pub(super) semantic: Semantic,
    pub(super) form: Form,
    /// A vertex is a row.
    pub(super) rows: Layer,
    /// The layer of the part, if it still has it.
    pub(super) now: Option<&'p Layer>,
}

/// A part with the rows of the file.
pub(super) struct PartRows<'p> {
    pub(super) mesh: &'p PolygonMesh,
    pub(super) pools: Pools,
    pub(super) stored: Stored,
    pub(super) attributes: Vec<Attribute<'p>>,
    render_vertex: Option<&'p Layer>,
    primitive: Option<&'p Layer>,
}

impl<'p> PartRows<'p> {
    /// Reads the rows of a mesh of the file once more.
    ///
    /// # Errors
    /// As those of reading it.
    pub(super) fn of(
        asset: &Asset<'_>,
        mesh: &Mesh<'_>,
        bytes: &Bytes<'_>,
        now: &'p PolygonMesh,
    ) -> Result<Self, Fault> {
        let pools = Pools::of(asset, mesh)?;
        let stored = Stored::of(asset, mesh, &pools, bytes)?;
        let mut attributes = Vec::new();
        for column in pools.columns() {
            let rows = layer_of(&column, &pools, bytes, pools.rows, &Rows::Same)?;
            let is_same = |layer: &&Layer| {
                layer.name() == rows.name()
                    && layer.width() == rows.width()
                    && layer.role() == rows.role()
                    && layer.is_normalized() == rows.is_normalized()
                    && matches!(layer.domain(), Domain::Vertex | Domain::Corner)
                    && std::mem::discriminant(layer.values()) == std::mem::discriminant(rows.values())
            };
            let now = now.layers().iter().find(is_same);
            attributes.push(Attribute { semantic: column.semantic, form: column.form, rows, now });
        }
        let named =
            |name: &str, domains: &[Domain]| domains.iter().find_map(|&domain| now.layer(name, domain));
        Ok(PartRows {
            mesh: now,
            pools,
            stored,
            attributes,
            render_vertex: named(RENDER_VERTEX, &[Domain::Vertex, Domain::Corner]),
            primitive: named(PRIMITIVE, &[Domain::Face]),
        })
    }

    /// The primitive of a face, if it has one that exists.
    pub(super) fn primitive(&self, face: usize) -> Option<usize> {
        let primitive = number(self.primitive?, face)? as usize;
        self.pools.of_primitive.get(primitive).copied().flatten().map(|_| primitive)
    }

    /// The row of a corner, if it has one in a pool.
    pub(super) fn row(&self, corner: CornerId, pool: usize) -> Option<u32> {
        let layer = self.render_vertex?;
        let row = number(layer, self.element(layer, corner))?;
        let pool = &self.pools.list[pool];
        (pool.base..pool.base + pool.rows).contains(&(row as usize)).then_some(row)
    }

    /// Whether a corner has the place of a row: as numbers, so that a zero has no sign.
    pub(super) fn is_at(&self, corner: CornerId, row: u32) -> bool {
        let (now, stored) = (self.position(corner), self.stored.positions[row as usize]);
        now == stored || now.map(f64::to_bits) == stored.map(f64::to_bits)
    }

    pub(super) fn position(&self, corner: CornerId) -> [f64; 3] {
        self.mesh.position(self.vertex(corner))
    }

    pub(super) fn vertex(&self, corner: CornerId) -> VertexId {
        self.mesh.faces().corner_vertex(corner)
    }

    /// Whether a corner has all values of a row.
    pub(super) fn is_as_stored(&self, corner: CornerId, row: u32) -> bool {
        self.is_at(corner, row) && self.attributes.iter().all(|attribute| self.keeps(attribute, corner, row))
    }

    /// Whether a corner has the value of a row in an attribute.
    pub(super) fn keeps(&self, attribute: &Attribute<'_>, corner: CornerId, row: u32) -> bool {
        let Some(now) = attribute.now else { return true };
        match (attribute.rows.value_of(row as usize), now.value_of(self.element(now, corner))) {
            (Some(stored), Some(value)) => {
                same_bits(attribute.rows.values(), stored, now.values(), value, attribute.rows.width())
            }
            // A value that the row does not have has no place in its pool.
            (None, _) => true,
            (Some(_), None) => false,
        }
    }

    /// The value that a corner has now in an attribute.
    pub(super) fn value(&self, attribute: &Attribute<'p>, corner: CornerId) -> Option<(&'p Values, usize)> {
        let now = attribute.now?;
        now.value_of(self.element(now, corner)).map(|value| (now.values(), value))
    }

    fn element(&self, layer: &Layer, corner: CornerId) -> usize {
        match layer.domain() {
            Domain::Vertex => self.vertex(corner).index(),
            _ => corner.index(),
        }
    }

    /// The uses of all values of a corner, by which those that are alike are one row.
    pub(super) fn uses(&self, corner: CornerId) -> Vec<u32> {
        let use_of = |attribute: &Attribute<'_>| {
            let now = attribute.now?;
            now.value_of(self.element(now, corner)).map(|value| value as u32)
        };
        self.attributes.iter().map(|attribute| use_of(attribute).unwrap_or(u32::MAX)).collect()
    }

    /// Layers of the part that the file has no place for.
    pub(super) fn unknown_layers(&self) -> Vec<Loss> {
        let own = [RENDER_VERTEX, PRIMITIVE, FACE, MATERIAL];
        let is_attribute =
            |layer: &Layer| self.attributes.iter().any(|a| a.now.is_some_and(|now| std::ptr::eq(now, layer)));
        let is_unknown = |layer: &&Layer| !own.contains(&layer.name()) && !is_attribute(layer);
        let loss = |layer: &Layer| {
            let (name, domain) = (layer.name().escape_debug(), layer.domain().name());
            let message = format!("{domain} attribute `{name}`");
            Loss::new(LossKind::Layer, layer.element_count(), message).of_layer(layer)
        };
        self.mesh.layers().iter().filter(is_unknown).map(loss).collect()
    }
}

/// The number that a layer gives to an element.
fn number(layer: &Layer, element: usize) -> Option<u32> {
    match layer.values() {
        Values::U32(values) => layer.value_of(element).and_then(|value| values.get(value).copied()),
        _ => None,
    }
}
