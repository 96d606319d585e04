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
