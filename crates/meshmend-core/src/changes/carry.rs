//! How attribute layers are carried along by a change.

use crate::attributes::turning::{Turned, turned};
use crate::changes::filled::{give_agreed_values, name_faces};
use crate::changes::influences::blend_influences;
use crate::{CornerId, Domain, Draft, FaceTable, FlippedNormals, Id, Layer, NO_VALUE, PolygonMesh};

impl PolygonMesh {
    /// The layers as the draft's mesh has them.
    pub(super) fn carried_layers(&self, draft: &Draft) -> Vec<Layer> {
        let carried = self.layers().iter().map(|layer| self.carried(layer, draft));
        let mut layers: Vec<Layer> = carried.map(|layer| with_turned_values(layer, draft)).collect();
        blend_influences(self, draft, &mut layers);
        layers
    }

    /// A layer as the draft's mesh has it.
    fn carried(&self, layer: &Layer, draft: &Draft) -> Layer {
        match layer.domain() {
            Domain::Face if draft.face_sources.is_all_of(self.counts().faces) => layer.clone(),
            Domain::Face => {
                let old = draft
                    .face_sources
                    .iter()
                    .map(|(_, old)| old.map_or(NO_VALUE, |f| layer.element_use(f.index())));
                let mut uses: Vec<u32> = old.collect();
                name_faces(layer, draft, &mut uses);
                layer.with_uses(Domain::Face, uses)
            }
            Domain::Vertex if draft.vertex_sources.is_all_of(self.counts().vertices) => layer.clone(),
            Domain::Vertex => self.carried_vertex_layer(layer, draft),
            Domain::Corner if self.keeps_corners(draft) && layer.home() != Domain::Vertex => layer.clone(),
            Domain::Corner => self.carried_corner_layer(layer, draft),
            Domain::LooseEdge if draft.drop_loose.edges => layer.with_uses(Domain::LooseEdge, Vec::new()),
            Domain::LoosePoint if draft.drop_loose.points => layer.with_uses(Domain::LoosePoint, Vec::new()),
            Domain::LooseEdge | Domain::LoosePoint => layer.clone(),
        }
    }

    fn keeps_corners(&self, draft: &Draft) -> bool {
        draft.corner_sources.is_all_of(self.counts().corners)
    }

    /// Stays on the vertices unless some corner's old vertex has another value than the vertex it is at now.
    fn carried_vertex_layer(&self, layer: &Layer, draft: &Draft) -> Layer {
        let mut layer = layer.clone();
        let uses = self.vertex_uses(&mut layer, draft);
        let old_use =
            |layer: &Layer, old: CornerId| layer.vertex_use(self.faces().corner_vertex(old).index());
        let differs = draft.corner_sources.iter().any(|(new, old)| {
            let at = draft.faces.corner_vertex(new).index();
            old.is_some_and(|old| !layer.same_value(old_use(&layer, old), uses[at]))
        });
        if !differs {
            return layer.with_uses(Domain::Vertex, uses);
        }
        let by_corner = draft.corner_sources.iter().map(|(new, old)| match old {
            Some(old) => old_use(&layer, old),
            None => uses[draft.faces.corner_vertex(new).index()],
        });
        let by_corner = by_corner.collect();
        settled(layer, by_corner, uses, &draft.faces)
    }

    /// What each new vertex uses: its source's value, or for a created one a blend.
    fn vertex_uses(&self, layer: &mut Layer, draft: &Draft) -> Vec<u32> {
        let kept = draft.vertex_sources.iter().filter_map(|(_, old)| Some(layer.vertex_use(old?.index())));
        let mut uses: Vec<u32> = kept.collect();
        for created in &draft.created_vertices {
            let parts = created.place.map_or_else(Vec::new, |place| place.parts(self.faces()));
            let parts: Vec<(u32, f64)> = parts
                .iter()
                .map(|&(c, weight)| (layer.vertex_use(self.faces().corner_vertex(c).index()), weight))
                .collect();
            uses.push(layer.blended(&parts));
        }
        uses
    }

    fn carried_corner_layer(&self, layer: &Layer, draft: &Draft) -> Layer {
        let (mut layer, first) = (layer.clone(), layer.value_count());
        let old = draft
            .corner_sources
            .iter()
            .map(|(_, old)| old.map_or(NO_VALUE, |c| layer.element_use(c.index())));
        let mut uses: Vec<u32> = old.collect();
        for &(corner, place) in &draft.created_corners {
            let parts = place.parts(self.faces());
            let parts: Vec<(u32, f64)> =
                parts.iter().map(|&(c, weight)| (layer.element_use(c.index()), weight)).collect();
            uses[corner.index()] = layer.blended(&parts);
        }
        give_agreed_values(&layer, draft, &mut uses);
        if layer.home() != Domain::Vertex {
            layer.pool_created(first, &mut uses);
            return layer.with_uses(Domain::Corner, uses);
        }
        let vertex_uses = self.vertex_uses(&mut layer, draft);
        settled(layer, uses, vertex_uses, &draft.faces)
    }
}

/// A layer whose values turn with flipped faces, if the draft says so.
fn with_turned_values(layer: Layer, draft: &Draft) -> Layer {
    if draft.flipped_normals == FlippedNormals::Keep {
        return layer;
    }
    let Some(Turned { layer, uses }) = turned(&layer, &draft.faces, &draft.flipped) else { return layer };
    if layer.home() != Domain::Vertex {
        let domain = layer.domain();
        return layer.with_uses(domain, uses);
    }
    let vertex_uses = (0..draft.faces.vertex_count()).map(|vertex| layer.vertex_use(vertex)).collect();
    settled(layer, uses, vertex_uses, &draft.faces)
}

/// A vertex layer by corners: back on the vertices if no vertex has corners that differ.
///
/// A vertex's own value is that of its corners where these agree, so that it depends on the current mesh alone, not on its
/// history.
fn settled(layer: Layer, uses: Vec<u32>, mut vertex_uses: Vec<u32>, faces: &FaceTable) -> Layer {
    let mut seen: Vec<Option<u32>> = vec![None; vertex_uses.len()];
    let mut differs = vec![false; vertex_uses.len()];
    for corner in faces.corners() {
        let (v, value) = (faces.corner_vertex(corner).index(), uses[corner.index()]);
        differs[v] |= !layer.same_value(*seen[v].get_or_insert(value), value);
    }
    for (vertex, own) in vertex_uses.iter_mut().enumerate() {
        *own = seen[vertex].filter(|_| !differs[vertex]).unwrap_or(*own);
    }
    if differs.contains(&true) {
        layer.with_uses(Domain::Corner, uses).with_vertex_uses(vertex_uses)
    } else {
        layer.with_uses(Domain::Vertex, vertex_uses).without_vertex_uses()
    }
}
