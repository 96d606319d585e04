//! Vertices for programs that know attributes of vertices alone: a vertex whose corners differ is written as several.
//!
//! Within a mesh a seam is corners that use different values. A format that has values for vertices only can say that
//! in one way: a vertex for each value, all at one place.

use crate::{
    CornerId, Domain, Draft, DraftError, Id, Layer, NO_VALUE, PolygonMesh, Provenance, Sources, VertexId,
};

impl PolygonMesh {
    /// The mesh with the given layers, by their places among [`layers`](PolygonMesh::layers), as layers of vertices: each
    /// vertex is there once for each class of its corners that agree in all of these layers, to the bit.
    ///
    /// A vertex that was stored with a value of its own is where it was among the vertices, as far as the layers tell
    /// which value that is; further ones follow at the end, by their lowest corner. So what a weld stitched comes apart
    /// into the vertices that it was, unless their values are the same.
    ///
    /// # Errors
    /// When there would be more vertices than a mesh holds.
    ///
    /// *Cost*: linear in the corners; n log n in those of vertices that are parted. O(1) where no layer is of corners.
    pub fn split_for_vertex_layers(&self, layers: &[usize]) -> Result<(PolygonMesh, Provenance), DraftError> {
        let at_corners = |&&at: &&usize| self.layers().get(at).is_some_and(|l| l.domain() == Domain::Corner);
        let layers: Vec<usize> = layers.iter().filter(at_corners).copied().collect();
        if layers.is_empty() {
            return Ok((self.clone(), Provenance::same(self.counts())));
        }
        let mesh = self.with_home_at_vertices(&layers)?;
        let listed: Vec<&Layer> = layers.iter().map(|&at| &mesh.layers()[at]).collect();
        let parts = Parts::of(&mesh, &listed);
        let order = parts.order(&mesh, &listed);
        let draft = parts.draft(&mesh, &order)?;
        mesh.rebuild(draft)
    }

    /// The mesh whose vertices [`split_for_vertex_layers`](Self::split_for_vertex_layers) made, with these layers, as it is
    /// when it was stored and read again: by the given draft, with a value of each layer at each vertex.
    ///
    /// # Errors
    /// When the draft does not describe a mesh.
    ///
    /// *Cost*: linear in the mesh and its layers.
    pub fn rebuilt_with_vertex_layers(
        &self,
        layers: &[usize],
        draft: Draft,
    ) -> Result<(PolygonMesh, Provenance), DraftError> {
        let (mesh, record) = self.with_home_at_vertices(layers)?.rebuild(draft)?;
        let mut stored = mesh.layers().to_vec();
        for &at in layers {
            stored[at] = stored[at].clone().stored_with_vertices();
        }
        Ok((mesh.with_layers(stored)?, record))
    }

    /// The mesh with these layers, by their places, at home on the vertices, so that they return there when no vertex
    /// differs in them.
    fn with_home_at_vertices(&self, layers: &[usize]) -> Result<PolygonMesh, DraftError> {
        let vertex_count = self.counts().vertices;
        let mut all = self.layers().to_vec();
        for &at in layers {
            all[at] = all[at].clone().at_home_on_vertices(vertex_count);
        }
        Ok(self.clone().with_layers(all)?)
    }
}

/// The corners of each vertex by classes that agree in some layers.
struct Parts {
    /// For each corner the lowest one of its class.
    class: Vec<CornerId>,
}

impl Parts {
    fn of(mesh: &PolygonMesh, layers: &[&Layer]) -> Self {
        let faces = mesh.faces();
        let mut first: Vec<Option<CornerId>> = vec![None; faces.vertex_count()];
        let mut is_mixed = vec![false; faces.vertex_count()];
        let mut class = Vec::with_capacity(faces.corner_count());
        for corner in faces.corners() {
            let vertex = faces.corner_vertex(corner).index();
            let lowest = *first[vertex].get_or_insert(corner);
            let same = |layer: &&Layer| {
                layer.same_value(layer.element_use(lowest.index()), layer.element_use(corner.index()))
            };
            is_mixed[vertex] |= !layers.iter().all(same);
            class.push(lowest);
        }
        let is_of_mixed = |corner: &CornerId| is_mixed[faces.corner_vertex(*corner).index()];
        let mixed: Vec<CornerId> = faces.corners().filter(is_of_mixed).collect();
        let mut parts = Parts { class };
        if !mixed.is_empty() {
            layers.iter().for_each(|layer| parts.refine(&mixed, layer));
        }
        parts
    }

    /// Parts classes whose corners differ in a layer.
    fn refine(&mut self, corners: &[CornerId], layer: &Layer) {
        let use_of = |corner: &CornerId| layer.element_use(corner.index());
        let same = SameValues::among(layer, corners.iter().map(use_of).collect());
        let key = |corner: &CornerId| (self.class[corner.index()], same.lowest(use_of(corner)), *corner);
        let mut keys: Vec<(CornerId, u32, CornerId)> = corners.iter().map(key).collect();
        keys.sort_unstable();
        for group in keys.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)) {
            group.iter().for_each(|&(_, _, corner)| self.class[corner.index()] = group[0].2);
        }
    }

    fn lowest(&self, corner: CornerId) -> CornerId {
        self.class[corner.index()]
    }

    /// The vertices that are to be made, in order.
    fn order(&self, mesh: &PolygonMesh, layers: &[&Layer]) -> Vec<Made> {
        let faces = mesh.faces();
        let vertices = faces.vertex_count();
        let mut classes: Vec<(VertexId, Option<u32>, CornerId)> = Vec::new();
        let mut has_corner = vec![false; vertices];
        let stored = self.stored_vertices(mesh, layers);
        for corner in faces.corners().filter(|&corner| self.lowest(corner) == corner) {
            let vertex = faces.corner_vertex(corner);
            has_corner[vertex.index()] = true;
            classes.push((vertex, stored[corner.index()], corner));
        }
        classes.sort_unstable_by_key(|&(vertex, _, corner)| (vertex, corner));
        let mut made = Vec::with_capacity(classes.len());
        let (mut places, mut classes) = (Places::default(), classes.into_iter().peekable());
        for vertex in (0..vertices).map(VertexId::new) {
            let mut is_first = true;
            while let Some((_, stored, corner)) = classes.next_if(|&(at, ..)| at == vertex) {
                made.push(Made { place: places.next(stored, corner, is_first), vertex, class: Some(corner) });
                is_first = false;
            }
            if is_first {
                let place = places.next(None, CornerId(0), true);
                made.push(Made { place, vertex, class: None });
            }
        }
        made.sort_by_key(|made| made.place);
        made
    }

    /// For the lowest corner of each class the vertex as stored that its values are those of, if that can be told.
    fn stored_vertices(&self, mesh: &PolygonMesh, layers: &[&Layer]) -> Vec<Option<u32>> {
        let mut stored: Vec<Option<u32>> = vec![None; mesh.counts().corners];
        for corner in mesh.faces().corners() {
            let own = layers.iter().find_map(|layer| layer.stored_vertex(corner));
            let of_class = &mut stored[self.lowest(corner).index()];
            *of_class = match (*of_class, own) {
                (Some(one), Some(other)) => Some(one.min(other)),
                (one, other) => one.or(other),
            };
        }
        stored
    }

    fn draft(&self, mesh: &PolygonMesh, order: &[Made]) -> Result<Draft, DraftError> {
        let faces = mesh.faces();
        let mut new_vertex = vec![VertexId(0); faces.corner_count()];
        for (new, made) in order.iter().enumerate() {
            if let Some(corner) = made.class {
                new_vertex[corner.index()] = VertexId::new(new);
            }
        }
        let vertices = self.class.iter().map(|lowest| new_vertex[lowest.index()]).collect();
        let new_faces = faces.over(order.len(), vertices)?;
        let (face_sources, corner_sources) =
            (Sources::same(faces.face_count()), Sources::same(faces.corner_count()));
        Ok(Draft {
            vertex_sources: Sources::listed(order.iter().map(|made| Some(made.vertex))),
            ..Draft::of_faces(mesh, new_faces, face_sources, corner_sources)
        })
    }
}

/// Which values of a pool are the same to the bit.
struct SameValues {
    /// Ascending.
    values: Vec<u32>,
    /// For each of them the lowest that is the same.
    lowest: Vec<u32>,
}

impl SameValues {
    fn among(layer: &Layer, mut values: Vec<u32>) -> Self {
        values.sort_unstable();
        values.dedup();
        values.pop_if(|value| *value == NO_VALUE);
        let mut by_bits: Vec<usize> = (0..values.len()).collect();
        by_bits.sort_by(|&one, &other| layer.cmp_values(values[one], values[other]));
        let mut lowest = values.clone();
        for same in by_bits.chunk_by(|&one, &other| layer.same_value(values[one], values[other])) {
            same.iter().for_each(|&at| lowest[at] = values[same[0]]);
        }
        SameValues { values, lowest }
    }

    fn lowest(&self, value: u32) -> u32 {
        self.values.binary_search(&value).map_or(value, |at| self.lowest[at])
    }
}

/// A vertex that is to be made.
struct Made {
    place: Place,
    /// The vertex that it is, or is a part of.
    vertex: VertexId,
    /// The lowest of its corners.
    class: Option<CornerId>,
}

/// Where a vertex stands among others.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Place {
    /// Where a stored vertex was, or after it (or before all), by how many others that follow it.
    Stored(Option<u32>, u32),
    /// After all that were stored.
    AtEnd(CornerId),
}

/// Gives places to the vertices of a mesh, in its order.
#[derive(Default)]
struct Places {
    is_taken: Vec<bool>,
    last: (Option<u32>, u32),
}

impl Places {
    /// The place of the next class of a vertex, or of a vertex without a corner.
    fn next(&mut self, stored: Option<u32>, corner: CornerId, is_first: bool) -> Place {
        if let Some(stored) = stored.filter(|&stored| self.takes(stored)) {
            self.last = if is_first { (Some(stored), 0) } else { self.last };
            return Place::Stored(Some(stored), 0);
        }
        if stored.is_some() || !is_first {
            return Place::AtEnd(corner);
        }
        self.last.1 += 1;
        Place::Stored(self.last.0, self.last.1)
    }

    /// Takes the place of a stored vertex, if it is free.
    fn takes(&mut self, stored: u32) -> bool {
        let at = stored as usize;
        self.is_taken.resize(self.is_taken.len().max(at + 1), false);
        !std::mem::replace(&mut self.is_taken[at], true)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Carry, FaceTable, Values};

    /// Triangles over so many vertices in a row.
    fn mesh(vertices: usize, corners: &[u32], layers: Vec<Layer>) -> PolygonMesh {
        let faces = FaceTable::triangles(vertices, corners.iter().copied().map(VertexId).collect()).unwrap();
        let points = (0..vertices).map(|v| [v as f64, 0.0, 0.0]).collect();
        PolygonMesh::new(points, faces).unwrap().with_layers(layers).unwrap()
    }

    /// The mesh with other vertices at its corners, each of which has the place of the one that is named.
    fn welded(mesh: &PolygonMesh, sources: &[u32], corners: &[u32]) -> PolygonMesh {
        let faces = FaceTable::triangles(sources.len(), corners.iter().copied().map(VertexId).collect());
        let counts = mesh.counts();
        let draft = Draft {
            vertex_sources: Sources::listed(sources.iter().map(|&v| Some(VertexId(v)))),
            ..Draft::of_faces(
                mesh,
                faces.unwrap(),
                Sources::same(counts.faces),
                Sources::same(counts.corners),
            )
        };
        mesh.rebuild(draft).unwrap().0
    }

    fn places(mesh: &PolygonMesh) -> Vec<f64> {
        mesh.positions().iter().map(|p| p[0]).collect()
    }

    fn corners(mesh: &PolygonMesh) -> Vec<u32> {
        mesh.faces().corner_vertices().iter().map(|v| v.0).collect()
    }

    fn colors(values: &[u8]) -> Layer {
        Layer::direct("color", Domain::Vertex, 1, Carry::Copy, Values::U8(values.to_vec()))
    }

    #[test]
    fn what_a_weld_stitched_comes_apart_into_the_vertices_that_it_was() {
        let stored = mesh(6, &[0, 1, 2, 3, 4, 5], vec![colors(&[1, 1, 1, 2, 2, 2])]);
        let joined = welded(&stored, &[0, 1, 2, 4], &[0, 1, 2, 1, 3, 2]);
        assert_eq!(joined.layers()[0].domain(), Domain::Corner);
        let (split, record) = joined.split_for_vertex_layers(&[0]).unwrap();
        assert_eq!(corners(&split), [0, 1, 2, 3, 4, 5]);
        assert_eq!(places(&split), [0.0, 1.0, 2.0, 1.0, 4.0, 2.0]);
        assert_eq!(split.layers()[0].domain(), Domain::Vertex);
        let sources: Vec<_> = record.vertices.iter().map(|(_, old)| old.map(|v| v.0)).collect();
        assert_eq!(sources, [0, 1, 2, 1, 3, 2].map(Some));
    }

    #[test]
    fn vertices_that_a_weld_joined_part_only_where_their_values_differ() {
        let stored = mesh(6, &[0, 1, 2, 3, 4, 5], vec![colors(&[1, 1, 1, 1, 2, 3])]);
        let joined = welded(&stored, &[0, 1, 2, 4], &[0, 1, 2, 1, 3, 2]);
        let (split, _) = joined.split_for_vertex_layers(&[0]).unwrap();
        assert_eq!(
            (corners(&split), places(&split)),
            (vec![0, 1, 2, 1, 3, 4], vec![0.0, 1.0, 2.0, 4.0, 2.0])
        );
    }

    #[test]
    fn classes_beyond_those_that_were_stored_follow_at_the_end_by_corner() {
        // Three triangles round vertex 0, at which each has a value of its own.
        let values = Values::F64((0..9).map(f64::from).collect());
        let layer = Layer::direct("normal", Domain::Corner, 1, Carry::Interpolate, values);
        let fan = mesh(4, &[0, 1, 2, 0, 2, 3, 0, 3, 1], vec![layer]);
        let (split, _) = fan.split_for_vertex_layers(&[0]).unwrap();
        assert_eq!(corners(&split), [0, 1, 2, 4, 5, 3, 6, 7, 8]);
        assert_eq!(places(&split), [0.0, 1.0, 2.0, 3.0, 0.0, 2.0, 0.0, 3.0, 1.0]);
        assert_eq!(split.layers()[0].domain(), Domain::Vertex);
    }

    #[test]
    fn equal_values_are_one_class_and_all_layers_have_to_agree() {
        let at_corners = |name: &str, values: [f32; 6]| {
            Layer::direct(name, Domain::Corner, 1, Carry::Interpolate, Values::F32(values.to_vec()))
        };
        let one = at_corners("one", [1.0, 2.0, 3.0, 2.0, 4.0, 3.0]);
        let other = at_corners("other", [0.0, 0.0, 0.0, 0.0, 0.0, -0.0]);
        let pair = mesh(4, &[0, 1, 2, 1, 3, 2], vec![one, other]);
        let (split, record) = pair.split_for_vertex_layers(&[0]).unwrap();
        assert!(record.vertices.is_same());
        assert_eq!(
            (split.layers()[0].domain(), split.layers()[1].domain()),
            (Domain::Vertex, Domain::Corner)
        );
        let (split, _) = pair.split_for_vertex_layers(&[0, 1]).unwrap();
        assert_eq!((corners(&split), split.layers()[1].domain()), (vec![0, 1, 2, 1, 3, 4], Domain::Vertex));
    }

    #[test]
    fn corners_without_a_value_are_a_class_and_loose_elements_keep_their_vertex() {
        let uses = vec![0, 0, NO_VALUE, 0, 0, 0];
        let layer = Layer::indexed("uv", Domain::Corner, 1, Carry::Copy, Values::F64(vec![7.0]), uses);
        let pair = mesh(5, &[0, 1, 2, 1, 3, 2], vec![layer]);
        let pair = pair.with_loose(vec![[VertexId(2), VertexId(4)]], vec![VertexId(4)]).unwrap();
        let (split, _) = pair.split_for_vertex_layers(&[0]).unwrap();
        assert_eq!(corners(&split), [0, 1, 2, 1, 3, 5]);
        assert_eq!(split.loose_edges(), [[VertexId(2), VertexId(4)]]);
        let values: Vec<_> = (0..6).map(|v| split.layers()[0].value_of(v)).collect();
        assert_eq!(values, [Some(0), Some(0), None, Some(0), None, Some(0)]);
    }

    #[test]
    fn layers_of_vertices_alone_change_nothing() {
        let plain = mesh(3, &[0, 1, 2], vec![colors(&[1, 2, 3])]);
        let (same, record) = plain.split_for_vertex_layers(&[0, 7]).unwrap();
        assert!(record.is_same() && std::ptr::eq(same.layers(), plain.layers()));
    }
}
