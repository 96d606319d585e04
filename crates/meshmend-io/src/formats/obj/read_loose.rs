//! Reading loose edges and points, with their texture coordinates.

use meshmend_core::{Carry, Domain, Layer, Values, VertexId};

use crate::formats::obj::loose_parts::{END_TEXCOORD, LooseParts, POLYLINE};
use crate::formats::obj::reader::Reader;
use crate::{NoteKind, ReadError};

/// A vertex of a loose element, with its texture coordinate.
struct LooseVertex {
    vertex: VertexId,
    texcoord: Option<u32>,
    at: usize,
}

impl Reader<'_> {
    pub(super) fn polyline(&mut self, start: usize) -> Result<(), ReadError> {
        let mut previous: Option<LooseVertex> = None;
        let first = self.parts.loose_edges.len();
        while self.cursor.more_items() {
            let vertex = self.loose_vertex()?;
            if let Some(previous) = previous.replace(LooseVertex { ..vertex }) {
                let edge = self.parts.loose_edges.len();
                self.parts.loose_edges.push([previous.vertex, vertex.vertex]);
                self.loose.polylines.push(self.loose.polyline_count);
                self.loose_texcoord(0, edge, &previous);
                self.loose_texcoord(1, edge, &vertex);
            }
        }
        match self.parts.loose_edges.len() - first {
            0 => {
                let source = self.source;
                let message = "lines of fewer than two vertices were skipped";
                self.parts.notes.add(NoteKind::SkippedElement, message, || source.line(start));
            }
            edges => {
                self.loose.has_long |= edges > 1;
                self.loose.polyline_count += 1;
            }
        }
        Ok(())
    }

    pub(super) fn points(&mut self) -> Result<(), ReadError> {
        while self.cursor.more_items() {
            let vertex = self.loose_vertex()?;
            let point = self.parts.loose_points.len();
            self.parts.loose_points.push(vertex.vertex);
            self.loose_texcoord(2, point, &vertex);
        }
        Ok(())
    }

    fn loose_texcoord(&mut self, which: usize, element: usize, vertex: &LooseVertex) {
        if let Some(value) = vertex.texcoord {
            self.loose.texcoords[which].set(element, value, vertex.at);
        }
    }

    fn loose_vertex(&mut self) -> Result<LooseVertex, ReadError> {
        let at = self.cursor.at;
        let raw = self.cursor.index("a vertex index")?;
        let vertex = VertexId(self.vertex_index(raw, at)?);
        let mut texcoord = None;
        if self.cursor.peek() == Some(b'/') {
            self.cursor.at += 1;
            if self.cursor.is_index() {
                let raw = self.cursor.index("a texture index")?;
                texcoord = Some(self.attribute_index(raw, self.texcoords.len(), at));
            }
        }
        self.cursor.end_item("an element")?;
        Ok(LooseVertex { vertex, texcoord, at })
    }

    /// The layers of loose elements over the pool of texture coordinates, and that of the polylines.
    pub(super) fn loose_layers(&mut self, texcoords: Option<&Layer>) {
        let LooseParts { polylines, polyline_count, has_long, texcoords: uses } =
            std::mem::take(&mut self.loose);
        let (edges, points) = (self.parts.loose_edges.len(), self.parts.loose_points.len());
        let places = [
            ("texcoord", Domain::LooseEdge, edges),
            (END_TEXCOORD, Domain::LooseEdge, edges),
            ("texcoord", Domain::LoosePoint, points),
        ];
        for ((name, domain, count), uses) in places.into_iter().zip(uses) {
            if uses.is_empty() {
                continue;
            }
            let values = texcoords.map_or(0, Layer::value_count);
            let (uses, wrong) = uses.checked(count, values);
            if let Some((count, at)) = wrong.filter(|&(count, _)| count > 0) {
                self.note_out_of_range(count, at);
            }
            let layer = texcoords.map(|pool| pool.over_same_values(name, domain, Carry::Copy, uses));
            self.parts.layers.extend(layer);
        }
        if has_long {
            let ids = Values::U32((0..polyline_count).collect());
            let layer = Layer::indexed(POLYLINE, Domain::LooseEdge, 1, Carry::Clear, ids, polylines);
            self.parts.layers.push(layer);
        }
    }
}
