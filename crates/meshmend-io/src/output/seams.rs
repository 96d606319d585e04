//! Seams in formats whose programs look for attributes at the vertices: a vertex whose corners differ becomes
//! several.

use meshmend_core::{Domain, Layer, Provenance};

use crate::{Loss, LossKind, Prepared, Seams, WriteErrorKind};

impl Prepared {
    /// Moves layers back to the vertices, as the options say: those that are at home there and that the format holds
    /// at vertices.
    ///
    /// *Cost*: O(1) where no such layer is at the corners.
    pub(crate) fn split_seams(&mut self, is_wanted: impl Fn(&Layer) -> bool) -> Result<(), WriteErrorKind> {
        let moved = |layer: &Layer| layer.home() == Domain::Vertex && is_wanted(layer);
        let layers = self.mesh.layers().iter().enumerate();
        let layers: Vec<usize> = layers.filter(|(_, layer)| moved(layer)).map(|(at, _)| at).collect();
        self.bring_to_vertices(&layers)
    }

    /// Moves the layers at these places from the corners to the vertices, wherever they are at home.
    pub(crate) fn bring_to_vertices(&mut self, layers: &[usize]) -> Result<(), WriteErrorKind> {
        if self.options.seams == Seams::Corners {
            return Ok(());
        }
        let (mesh, record) = self.mesh.split_for_vertex_layers(layers)?;
        let parts = Parts::of(&record);
        if self.options.seams == Seams::Fail && parts.vertices > 0 {
            return Err(WriteErrorKind::Seams { vertices: parts.vertices as u64 });
        }
        self.at_vertices.extend_from_slice(layers);
        if parts.vertices > 0 {
            self.become_mesh(mesh, record);
        } else {
            self.mesh = mesh;
        }
        self.losses.extend(parts.loss());
        Ok(())
    }
}

/// How many vertices became several, and how many those are now.
struct Parts {
    vertices: usize,
    written: usize,
}

impl Parts {
    fn of(record: &Provenance) -> Self {
        if record.vertices.is_all_of(record.before.vertices) {
            return Parts { vertices: 0, written: 0 };
        }
        let mut times = vec![0_usize; record.before.vertices];
        for old in record.vertices.iter().filter_map(|(_, old)| old) {
            times[old.0 as usize] += 1;
        }
        let several = times.iter().filter(|&&times| times > 1);
        Parts { vertices: several.clone().count(), written: several.sum() }
    }

    fn loss(&self) -> Option<Loss> {
        Loss::if_any(LossKind::SeamVertices, self.vertices, |count| {
            let (subject, whose) = match count {
                1 => ("1 vertex is".to_owned(), "its"),
                _ => (format!("{count} vertices are"), "their"),
            };
            let written = self.written;
            format!(
                "{subject} written {written} times, as {whose} attributes differ from face to face: the file is manifold \
                 by place, not by index"
            )
        })
    }
}

#[cfg(test)]
mod tests {
    use meshmend_core::{Carry, FaceTable, PolygonMesh, Role, Values, VertexId};

    use super::*;
    use crate::{Format, WriteOptions};

    /// PLY moves normals first and then texture coordinates. The record of both names vertices of the given mesh.
    #[test]
    fn what_is_split_twice_is_recorded_in_terms_of_the_given_mesh() {
        // A fan of three triangles round vertex 0, closed. The normals differ at vertex 0, the places in the picture
        // at vertex 1.
        let corners = [0, 1, 2, 0, 2, 3, 0, 3, 1].map(VertexId).to_vec();
        let points = vec![[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, -1.0, 0.0]];
        let layer = |name, role, width, uses: [u32; 9]| {
            let values = Values::F32((0..width * 2).map(|x| (x / width) as f32).collect());
            Layer::indexed(name, Domain::Corner, width, Carry::Copy, values, uses.to_vec()).with_role(role)
        };
        let layers = vec![
            layer("normal", Role::Normal, 3, [0, 0, 0, 1, 0, 0, 1, 0, 0]).at_home_on_vertices(4),
            layer("texcoord", Role::TexCoord, 2, [0, 0, 0, 0, 0, 0, 0, 0, 1]).at_home_on_vertices(4),
        ];
        let mesh = PolygonMesh::new(points, FaceTable::triangles(4, corners).unwrap()).unwrap();
        let mesh = mesh.with_layers(layers).unwrap();
        let mut prepared = Prepared::new(&mesh, &WriteOptions::of(Format::Off)).unwrap();
        prepared.mesh = mesh.clone();
        (prepared.record, prepared.losses) = (None, Vec::new());
        prepared.bring_to_vertices(&[0]).unwrap();
        prepared.bring_to_vertices(&[1]).unwrap();
        let record = prepared.record.clone().unwrap();
        assert_eq!((record.before, prepared.mesh.counts().vertices), (mesh.counts(), 6));
        for (new, old) in record.vertices.iter() {
            assert_eq!(mesh.position(old.unwrap()), prepared.mesh.position(new));
        }
        for (new, old) in record.corners.iter() {
            let (given, vertex) =
                (mesh.faces().corner_vertex(old.unwrap()), prepared.mesh.faces().corner_vertex(new));
            assert_eq!(record.vertices.of(vertex), Some(given));
        }
    }
}
