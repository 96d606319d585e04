//! One scene, drawn into one rectangle: what is nearest where, and the lines over it.

use meshmend_core::{FaceId, Id, PolygonMesh, VertexId};

use crate::depth::buffer::{DepthBuffer, NOTHING};
use crate::depth::painting::paint_faces;
use crate::depth::visibility::{Polylines, Sighted, length_in_panel};
use crate::look::appearance::{self, Side, Tone};
use crate::look::legend::{Entry, Shape, Swatch};
use crate::look::shade::{component_of_face, tones};
use crate::panels::frame::{Bounds, Frame, Rectangle};
use crate::panels::layers::{Label, Layer, Mark, View, entries, layers};
use crate::scenes::overlay::{Overlay, component_count};
use crate::scenes::scene::{Outlines, Scene};
use crate::vector::Vector;

/// A scene in its rectangle of the picture, ready to be written.
#[derive(Clone, Debug)]
pub(crate) struct Panel {
    /// Where it is; all other places are within it.
    pub(crate) place: Rectangle,
    pub(crate) mesh: PolygonMesh,
    /// The vertices; no numbers for those that are not finite.
    pub(crate) placed: Vec<Vector>,
    pub(crate) buffer: DepthBuffer,
    /// The look of each face.
    pub(crate) tones: Vec<Tone>,
    /// The faces that are not drawn, as a corner of theirs is not finite.
    pub(crate) left_out: Vec<FaceId>,
    /// Over the backs of faces.
    pub(crate) hatching: Polylines,
    /// From the lowest to the uppermost.
    pub(crate) layers: Vec<Layer>,
    /// Numbers of components.
    pub(crate) labels: Vec<Label>,
    pub(crate) entries: Vec<Entry>,
}

/// Distance between hatching lines, along the axes and in pixels.
const HATCHING: f64 = 7.0;

/// A component that covers fewer samples than this has no number on it.
const LEAST_LABELLED: usize = 250;

/// More components than this are not numbered.
const MOST_LABELLED: usize = 24;

/// The vertices that a picture shows: those of faces, loose elements and overlays; all of them where there is neither
/// face nor loose element. Those that are not finite are none.
pub(crate) fn shown_vertices(scene: &Scene) -> Box<dyn Iterator<Item = VertexId> + '_> {
    let mesh = &scene.mesh;
    let corners = mesh.complex().faces().corner_vertices();
    let loose = mesh.loose_edges().iter().flatten().chain(mesh.loose_points());
    let overlaid = scene.overlays.iter().flat_map(Overlay::vertices);
    let finite = |v: &VertexId| mesh.is_finite(*v);
    if is_cloud(mesh) {
        return Box::new((0..mesh.positions().len()).map(VertexId::new).filter(finite));
    }
    Box::new(corners.iter().chain(loose).copied().chain(overlaid).filter(finite))
}

/// Whether a mesh is nothing but vertices.
fn is_cloud(mesh: &PolygonMesh) -> bool {
    let faces = mesh.complex().faces();
    faces.corner_count() == 0 && mesh.loose_edges().is_empty() && mesh.loose_points().is_empty()
}

impl Panel {
    /// Draws a scene.
    ///
    /// *Cost*: linear in the mesh, in the samples that its faces cover, and in the length of all lines in pixels.
    pub(crate) fn draw(scene: &Scene, frame: &Frame, place: Rectangle, density: usize) -> Self {
        let mesh = &scene.mesh;
        let position = |v: VertexId| {
            if mesh.is_finite(v) { frame.place(mesh.position(v)) } else { [f64::NAN; 3] }
        };
        let placed: Vec<Vector> = (0..mesh.positions().len()).map(|v| position(VertexId::new(v))).collect();
        let mut buffer = DepthBuffer::new(place.width as usize, place.height as usize, density);
        let mut panel = Panel {
            place,
            tones: tones(scene, frame, &placed),
            left_out: paint_faces(mesh, &placed, &mut buffer),
            hatching: Polylines::default(),
            layers: Vec::new(),
            labels: Vec::new(),
            entries: Vec::new(),
            mesh: mesh.clone(),
            placed,
            buffer,
        };
        panel.hatching = panel.hatch();
        panel.labels = scene.overlays.iter().flat_map(|overlay| panel.component_labels(overlay)).collect();
        panel.layers = panel.make_layers(scene);
        panel.entries = panel.make_entries(scene);
        panel
    }

    fn view(&self) -> View<'_> {
        View { mesh: &self.mesh, placed: &self.placed, buffer: &self.buffer }
    }

    fn make_layers(&self, scene: &Scene) -> Vec<Layer> {
        let view = self.view();
        let mut all = Vec::new();
        if scene.outlines == Outlines::Drawn {
            all.push(self.outlines());
        }
        all.push(self.loose(&view));
        let mut overlays: Vec<Layer> =
            scene.overlays.iter().flat_map(|overlay| layers(overlay, &view)).collect();
        // Wide lines below, so that a narrow one along the same edges is seen within it; but trees, which what is
        // found with them runs along, below all.
        let is_tree = |layer: &Layer| [appearance::TREE, appearance::COTREE].contains(&layer.ink);
        overlays.sort_by(|one, other| {
            is_tree(other).cmp(&is_tree(one)).then(other.ink.width.total_cmp(&one.ink.width))
        });
        all.extend(overlays);
        all
    }

    /// The seen parts of the edges of all faces.
    fn outlines(&self) -> Layer {
        let view = self.view();
        let edges = self.mesh.complex().edges().all_ends().iter();
        let placed = edges.filter(|ends| ends.iter().all(|&end| view.is_placed(end)));
        let lines: Vec<[Vector; 2]> = placed.map(|ends| ends.map(|end| self.placed[end.index()])).collect();
        let mut layer = Layer::empty(appearance::FACE_OUTLINE);
        layer.lines = Sighted::of_length(length_in_panel(lines.iter().map(|line| &line[..])));
        lines.iter().for_each(|line| layer.lines.add(&self.buffer, line));
        layer.lines.hidden = Polylines::default();
        layer
    }

    /// Loose edges and points, or the vertices where there is nothing else.
    fn loose(&self, view: &View<'_>) -> Layer {
        let mut layer = Layer::empty(appearance::LOOSE_EDGE);
        for ends in self.mesh.loose_edges() {
            if ends.iter().all(|&end| view.is_placed(end)) {
                layer.lines.add(&self.buffer, &ends.map(|end| self.placed[end.index()]));
            }
        }
        let colour = appearance::LOOSE_EDGE.colour;
        let mark = |v: VertexId| {
            let place = self.placed[v.index()];
            Mark { shape: Shape::Disc, at: [place[0], place[1]], reach: 1.6, colour }
        };
        let all =
            (0..self.placed.len()).map(VertexId::new).take(if is_cloud(&self.mesh) { usize::MAX } else { 0 });
        let points = all.chain(self.mesh.loose_points().iter().copied());
        let seen = points.filter(|&v| view.is_placed(v) && self.buffer.is_seen(self.placed[v.index()]));
        layer.marks = seen.map(mark).collect();
        layer
    }

    /// Slanted lines over the backs of faces.
    fn hatch(&self) -> Polylines {
        let mut lines = Polylines::default();
        let is_back = |x: f64, y: f64| {
            self.buffer.face_at(x, y).is_some_and(|face| self.tones[face as usize].side == Side::Back)
        };
        let (width, height) = (self.place.width, self.place.height);
        let step = 0.5;
        let mut start = HATCHING;
        while start < width + height {
            // Along x + y = start, from below on the left to above on the right.
            let (mut x, mut begin) = ((start - height).max(0.0), None);
            while x <= width && x <= start {
                match (begin, is_back(x, start - x)) {
                    (None, true) => begin = Some(x),
                    (Some(from), false) => {
                        lines.push([from, start - from]);
                        lines.push([x, start - x]);
                        lines.end();
                        begin = None;
                    }
                    _ => {}
                }
                x += step;
            }
            start += HATCHING;
        }
        lines
    }

    /// The number of each component, in the middle of what is seen of it.
    fn component_labels(&self, overlay: &Overlay) -> Vec<Label> {
        let Overlay::Components { of_vertex } = overlay else { return Vec::new() };
        let count = component_count(of_vertex);
        if !(2..=MOST_LABELLED).contains(&count) {
            return Vec::new();
        }
        let (columns, density) = (self.buffer.columns(), self.buffer.density() as f64);
        let component = |owner: u32| component_of_face(&self.mesh, of_vertex, FaceId(owner));
        let seen = || {
            let samples = self.buffer.owners().iter().enumerate().filter(|(_, owner)| **owner != NOTHING);
            samples.filter_map(move |(sample, &owner)| {
                let at = [(sample % columns) as f64 + 0.5, (sample / columns) as f64 + 0.5];
                Some((component(owner)? as usize, at))
            })
        };
        let mut sums = vec![([0.0; 2], 0_usize); count];
        seen().for_each(|(k, at)| sums[k] = ([sums[k].0[0] + at[0], sums[k].0[1] + at[1]], sums[k].1 + 1));
        let mut best = vec![(f64::INFINITY, [0.0; 2]); count];
        for (k, at) in seen() {
            let middle = sums[k].0.map(|sum| sum / sums[k].1 as f64);
            let distance = (at[0] - middle[0]).hypot(at[1] - middle[1]);
            if distance < best[k].0 {
                best[k] = (distance, at);
            }
        }
        let labelled = (0..count).filter(|&k| sums[k].1 >= LEAST_LABELLED);
        labelled.map(|k| Label { at: best[k].1.map(|x| x / density), text: k.to_string() }).collect()
    }

    fn make_entries(&self, scene: &Scene) -> Vec<Entry> {
        let mut all: Vec<Entry> = scene.overlays.iter().flat_map(entries).collect();
        all.extend(loose_entries(&self.mesh));
        if self.layers.iter().any(|layer| !layer.lines.hidden.is_empty()) {
            all.push(behind_entry());
        }
        if !self.hatching.is_empty() {
            all.push(back_entry());
        }
        all
    }
}

fn loose_entries(mesh: &PolygonMesh) -> Vec<Entry> {
    let mut all = Vec::new();
    if !mesh.loose_edges().is_empty() {
        all.push(Entry::new(Swatch::Line(appearance::LOOSE_EDGE), "loose edges"));
    }
    if !mesh.loose_points().is_empty() {
        all.push(Entry::new(Swatch::Mark(Shape::Disc, appearance::LOOSE_EDGE.colour), "loose points"));
    }
    all
}

fn behind_entry() -> Entry {
    Entry::new(Swatch::Line(appearance::BEHIND.behind()), "behind faces")
}

fn back_entry() -> Entry {
    Entry::new(Swatch::Back, "back of a face")
}

/// Everything that the legend of a scene may come to say, to leave room for it.
pub(crate) fn possible_entries(scene: &Scene) -> Vec<Entry> {
    let mut all: Vec<Entry> =
        scene.overlays.iter().flat_map(entries).chain(loose_entries(&scene.mesh)).collect();
    if !all.is_empty() {
        all.push(behind_entry());
    }
    if scene.mesh.complex().faces().corner_count() > 0 {
        all.push(back_entry());
    }
    all
}

/// The box around what a scene shows, in space.
pub(crate) fn bounds(scene: &Scene) -> Bounds {
    Bounds::of(shown_vertices(scene).map(|v| scene.mesh.position(v)))
}
