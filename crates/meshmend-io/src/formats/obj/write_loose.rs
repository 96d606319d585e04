//! Writing loose edges and points as statements.

use std::io;

use meshmend_core::{Domain, Layer, PolygonMesh, Values, VertexId};

use crate::formats::obj::comment_anchors::{LINE, POINT};
use crate::formats::obj::loose_parts::{END_TEXCOORD, POLYLINE};
use crate::formats::obj::write_comments::Between;
use crate::formats::obj::write_names::NameWriter;
use crate::formats::obj::write_values::{attributes, values};
use crate::layers::{is_numeric, layer_of};
use crate::output::sink::Sink;

/// Which layers of loose elements are written, and where their texture coordinates are.
pub(super) struct LoosePlan<'a> {
    polylines: Option<&'a Layer>,
    /// At the starts of edges, at the ends of edges, and at points.
    texcoords: [Option<&'a Layer>; 3],
    /// The number of the first value of each of these layers.
    first_values: [usize; 3],
    /// Layers whose values are not among those of the corners.
    further: Vec<&'a Layer>,
}

impl<'a> LoosePlan<'a> {
    pub(super) fn of(mesh: &'a PolygonMesh, of_corners: Option<&'a Layer>) -> Self {
        let is_id = |layer: &Layer| matches!(layer.values(), Values::U32(_)) && layer.width() == 1;
        let is_texcoord = |layer: &Layer| is_numeric(layer) && layer.width() <= 3;
        let texcoords = [
            layer_of(mesh, "texcoord", Domain::LooseEdge, is_texcoord),
            layer_of(mesh, END_TEXCOORD, Domain::LooseEdge, is_texcoord),
            layer_of(mesh, "texcoord", Domain::LoosePoint, is_texcoord),
        ];
        let mut plan = LoosePlan {
            polylines: layer_of(mesh, POLYLINE, Domain::LooseEdge, is_id),
            texcoords,
            first_values: [0; 3],
            further: Vec::new(),
        };
        let mut written: Vec<(&Layer, usize)> = of_corners.map(|layer| (layer, 0)).into_iter().collect();
        for (layer, first) in texcoords.iter().zip(&mut plan.first_values) {
            let Some(layer) = layer else { continue };
            match written.iter().find(|(known, _)| begins_with(known, layer)) {
                Some((_, known)) => *first = *known,
                None => {
                    *first = written.last().map_or(0, |(last, at)| at + last.value_count());
                    written.push((layer, *first));
                    plan.further.push(layer);
                }
            }
        }
        plan
    }

    /// The layers that are written.
    pub(super) fn layers(&self) -> impl Iterator<Item = &'a Layer> + '_ {
        self.texcoords.iter().chain([&self.polylines]).flatten().copied()
    }

    /// Writes the texture coordinates that no corner has.
    pub(super) fn further_texcoords(&self, sink: &mut Sink<'_>) -> io::Result<()> {
        for layer in &self.further {
            for value in 0..layer.value_count() {
                values(layer, value, b"vt", sink);
                sink.checkpoint()?;
            }
        }
        Ok(())
    }

    /// Writes all loose elements. The edges of a polyline are one statement.
    pub(super) fn write(
        &self,
        mesh: &PolygonMesh,
        names: &mut NameWriter<'_>,
        between: &mut Between<'_>,
        sink: &mut Sink<'_>,
    ) -> io::Result<()> {
        let edges = mesh.loose_edges();
        let mut start = 0;
        while start < edges.len() {
            let end = self.polyline_end(edges, start);
            between.before(LINE, start, sink);
            names.before(1, start, sink);
            sink.byte(b'l');
            for (edge, ends) in edges.iter().enumerate().take(end).skip(start) {
                self.vertex(ends[0], 0, edge, sink);
            }
            self.vertex(edges[end - 1][1], 1, end - 1, sink);
            sink.byte(b'\n');
            sink.checkpoint()?;
            start = end;
        }
        between.after_all(LINE, sink);
        for (point, &vertex) in mesh.loose_points().iter().enumerate() {
            between.before(POINT, point, sink);
            names.before(2, point, sink);
            sink.byte(b'p');
            self.vertex(vertex, 2, point, sink);
            sink.byte(b'\n');
            sink.checkpoint()?;
        }
        between.after_all(POINT, sink);
        Ok(())
    }

    /// One past the last edge that continues this one within its polyline.
    fn polyline_end(&self, edges: &[[VertexId; 2]], start: usize) -> usize {
        let Some(polylines) = self.polylines else { return start + 1 };
        let Some(polyline) = polylines.value_of(start) else { return start + 1 };
        let goes_on =
            |at: usize| edges[at][0] == edges[at - 1][1] && polylines.value_of(at) == Some(polyline);
        (start + 1..edges.len()).find(|&at| !goes_on(at)).unwrap_or(edges.len())
    }

    fn vertex(&self, vertex: VertexId, which: usize, element: usize, sink: &mut Sink<'_>) {
        sink.byte(b' ');
        sink.integer(i64::from(vertex.0) + 1);
        let texcoord = self.texcoords[which].and_then(|layer| layer.value_of(element));
        attributes(sink, texcoord.map(|value| value + self.first_values[which]), None);
    }
}

/// Whether the values of a layer begin with those of another one.
fn begins_with(layer: &Layer, other: &Layer) -> bool {
    match (layer.values(), other.values()) {
        (Values::F64(all), Values::F64(some)) if layer.width() == other.width() => {
            all.len() >= some.len() && all.iter().zip(some).all(|(a, b)| a.to_bits() == b.to_bits())
        }
        (all, some) => all == some && layer.width() == other.width(),
    }
}
