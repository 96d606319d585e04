//! What an overlay becomes in a panel: lines, marks, labels, and what the legend says of them.

use meshmend_core::{EdgeId, FaceId, Id, PolygonMesh, VertexId};
use meshmend_topology::OneSidedStrip;

use crate::depth::buffer::DepthBuffer;
use crate::depth::visibility::{Sighted, length_in_panel, places_along, places_every, step_length};
use crate::look::appearance::{self, Colour, Fill, Ink};
use crate::look::legend::{Entry, Shape, Swatch};
use crate::panels::edge_chains::{Chains, Direction};
use crate::scenes::overlay::{Overlay, component_count};
use crate::vector::{Vector, add, mean, scaled};

/// A mesh as it lies in a panel.
pub(crate) struct View<'a> {
    pub(crate) mesh: &'a PolygonMesh,
    /// The vertices in the panel's pixels; no numbers for those that are not finite.
    pub(crate) placed: &'a [Vector],
    pub(crate) buffer: &'a DepthBuffer,
}

/// Lines of one ink, with the marks and labels that belong to them.
#[derive(Clone, Debug)]
pub(crate) struct Layer {
    pub(crate) ink: Ink,
    pub(crate) lines: Sighted,
    pub(crate) marks: Vec<Mark>,
    pub(crate) labels: Vec<Label>,
}

/// A sign at a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Mark {
    pub(crate) shape: Shape,
    pub(crate) at: [f64; 2],
    /// Half its width, in pixels.
    pub(crate) reach: f64,
    pub(crate) colour: Colour,
}

/// A number on the picture.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Label {
    pub(crate) at: [f64; 2],
    pub(crate) text: String,
}

/// Arrowheads along a strip are this far apart, in pixels.
const ARROW_SPACING: f64 = 56.0;

/// Labels are this far apart if there is room, in pixels.
const LABEL_DISTANCE: f64 = 20.0;

/// A legend names no more than this many of the same sort.
const NAMED: usize = 6;

impl Layer {
    pub(crate) fn empty(ink: Ink) -> Self {
        Layer { ink, lines: Sighted::default(), marks: Vec::new(), labels: Vec::new() }
    }

    /// A line along paths.
    pub(crate) fn of_paths(ink: Ink, buffer: &DepthBuffer, paths: &[Vec<Vector>]) -> Self {
        let mut layer = Layer::empty(ink);
        layer.lines = Sighted::of_length(length_in_panel(paths.iter().map(Vec::as_slice)));
        paths.iter().for_each(|path| layer.lines.add(buffer, path));
        layer
    }
}

/// The lines, marks and labels of an overlay.
pub(crate) fn layers(overlay: &Overlay, view: &View<'_>) -> Vec<Layer> {
    let along = |ink, edges: &[EdgeId]| vec![view.along_edges(ink, edges)];
    match overlay {
        Overlay::Boundary { edges } => along(appearance::BOUNDARY, edges),
        Overlay::Inconsistent { edges } => along(appearance::INCONSISTENT, edges),
        Overlay::Tree { edges } => along(appearance::TREE, edges),
        Overlay::Seam { edges } => along(appearance::SEAM, edges),
        Overlay::NonManifold { edges, vertices } => {
            let mut layer = view.along_edges(appearance::NON_MANIFOLD, edges);
            layer.marks = view.squares(vertices);
            vec![layer]
        }
        Overlay::Placed { what, edges, vertices } => {
            let mut layer = view.along_edges(appearance::placed(*what), edges);
            layer.marks = view.squares(vertices);
            vec![layer]
        }
        Overlay::Cotree { edges } => vec![view.across_edges(edges)],
        Overlay::Witness { strips } => strips.iter().map(|strip| view.along_strip(strip)).collect(),
        Overlay::Generators { loops, .. } => view.loops(loops),
        Overlay::Components { .. } => Vec::new(),
    }
}

/// What the legend says of an overlay; nothing of one that shows nothing.
pub(crate) fn entries(overlay: &Overlay) -> Vec<Entry> {
    let line = |ink, text: &str| Entry::new(Swatch::Line(ink), text);
    let of_edges =
        |edges: &[EdgeId], ink, text| if edges.is_empty() { vec![] } else { vec![line(ink, text)] };
    match overlay {
        Overlay::Boundary { edges } => of_edges(edges, appearance::BOUNDARY, "boundary"),
        Overlay::Inconsistent { edges } => of_edges(edges, appearance::INCONSISTENT, "inconsistent edges"),
        Overlay::Tree { edges } => of_edges(edges, appearance::TREE, "tree"),
        Overlay::Cotree { edges } => of_edges(edges, appearance::COTREE, "co-tree"),
        Overlay::Seam { edges } => of_edges(edges, appearance::SEAM, "seam"),
        Overlay::Placed { what, edges, vertices } => {
            let ink = appearance::placed(*what);
            if !edges.is_empty() {
                return vec![line(ink, what.title())];
            }
            let square = Entry::new(Swatch::Mark(Shape::Square, ink.colour), what.title());
            if vertices.is_empty() { vec![] } else { vec![square] }
        }
        Overlay::NonManifold { edges, vertices } => {
            let mut entries = of_edges(edges, appearance::NON_MANIFOLD, "non-manifold edges");
            if !vertices.is_empty() {
                let square = Swatch::Mark(Shape::Square, appearance::NON_MANIFOLD.colour);
                entries.push(Entry::new(square, "non-manifold vertices"));
            }
            entries
        }
        Overlay::Witness { strips } if strips.is_empty() => vec![],
        Overlay::Witness { .. } => vec![Entry::new(Swatch::Arrow(appearance::WITNESS), "one-sided strip")],
        Overlay::Generators { loops, more } => {
            let name =
                |k: usize| if loops.len() == 1 { "generator".into() } else { format!("generator {k}") };
            let entry = |k: usize| Entry::new(Swatch::Line(appearance::generator(k)), name(k));
            named(loops.len(), *more, "generators", entry)
        }
        Overlay::Components { of_vertex } => {
            let count = component_count(of_vertex);
            let colour = |k: usize| Swatch::Face(Fill::Component(k as u32).colour());
            named(count, 0, "components", |k| Entry::new(colour(k), format!("component {k}")))
        }
    }
}

/// An entry for each of some things of a sort, or the first of them and how many more there are, drawn and not drawn.
fn named(count: usize, not_drawn: usize, sort: &str, entry: impl Fn(usize) -> Entry) -> Vec<Entry> {
    let mut entries: Vec<Entry> = (0..count.min(NAMED)).map(entry).collect();
    if count > NAMED {
        entries.push(Entry::new(Swatch::None, format!("and {} more {sort}", count - NAMED)));
    }
    if not_drawn > 0 {
        entries.push(Entry::new(Swatch::None, format!("not drawn: {not_drawn} {sort}")));
    }
    entries
}

impl View<'_> {
    /// A line along edges, joined to paths.
    fn along_edges(&self, ink: Ink, edges: &[EdgeId]) -> Layer {
        let ends = edges.iter().map(|&edge| self.mesh.complex().edges().ends(edge));
        let ends: Vec<[VertexId; 2]> = ends.filter(|ends| ends.iter().all(|v| self.is_placed(*v))).collect();
        let links: Vec<[u32; 2]> = ends.iter().map(|ends| ends.map(|v| v.0)).collect();
        let chains = Chains::of(&links);
        let path = |path: &[(u32, Direction)]| {
            let mut points = Vec::with_capacity(path.len() + 1);
            for &(link, direction) in path {
                let [from, to] = directed(ends[link as usize], direction);
                if points.is_empty() {
                    points.push(self.placed[from.index()]);
                }
                points.push(self.placed[to.index()]);
            }
            points
        };
        Layer::of_paths(ink, self.buffer, &chains.iter().map(path).collect::<Vec<_>>())
    }

    /// A line through the middles of faces and of the edges that join them.
    fn across_edges(&self, edges: &[EdgeId]) -> Layer {
        let complex = self.mesh.complex();
        let faces_along = |edge: EdgeId| {
            let corners = complex.edges().edge_corners(edge);
            let faces = corners.take(2).map(|corner| complex.faces().corner_face(corner));
            faces.collect::<Vec<FaceId>>()
        };
        let mut layer = Layer::empty(appearance::COTREE);
        // A face may have as many corners as there are edges to it, and its middle is found once.
        let mut middles: Vec<Option<Option<Vector>>> = vec![None; complex.faces().face_count()];
        for &edge in edges {
            let Some(middle) = self.edge_middle(edge) else { continue };
            for face in faces_along(edge) {
                let centre = middles[face.index()].get_or_insert_with(|| self.face_middle(face));
                if let Some(centre) = *centre {
                    layer.lines.add_on(self.buffer, &[centre, middle], &[face.0]);
                }
            }
        }
        layer
    }

    /// A line with arrows once round a strip of faces.
    fn along_strip(&self, strip: &OneSidedStrip) -> Layer {
        let places = strip.faces.iter().zip(&strip.edges).cycle().take(strip.faces.len() + 1);
        let (mut points, mut faces) = (Vec::new(), Vec::new());
        for (&face, &edge) in places {
            // A path begins and ends in the middle of an edge, and goes through the middle of a face in between.
            let middle = self.face_middle(face).filter(|_| !points.is_empty());
            for point in middle.into_iter().chain(self.edge_middle(edge)) {
                points.push(point);
                faces.push(face.0);
            }
        }
        let mut layer = Layer::empty(appearance::WITNESS);
        // The face of each piece is that of the point at its end.
        layer.lines.add_on(self.buffer, &points, faces.get(1..).unwrap_or_default());
        let head = |(at, direction)| Mark {
            shape: Shape::Arrow(direction),
            at,
            reach: 5.5,
            colour: appearance::WITNESS.colour,
        };
        let places = layer.lines.seen.iter().flat_map(|path| places_every(path, ARROW_SPACING));
        layer.marks = places.map(head).collect();
        layer
    }

    /// A line of its own for each loop, numbered where there are several.
    fn loops(&self, loops: &[Vec<VertexId>]) -> Vec<Layer> {
        let mut taken: Vec<[f64; 2]> = Vec::new();
        let layer = |(number, vertices): (usize, &Vec<VertexId>)| {
            let round = vertices.iter().chain(vertices.first());
            let points = round.filter(|&&v| self.is_placed(v)).map(|v| self.placed[v.index()]);
            let mut layer = Layer::of_paths(appearance::generator(number), self.buffer, &[points.collect()]);
            if let Some(at) = label_place(&layer.lines, &taken).filter(|_| loops.len() > 1) {
                taken.push(at);
                layer.labels.push(Label { at, text: number.to_string() });
            }
            layer
        };
        loops.iter().enumerate().map(layer).collect()
    }

    fn squares(&self, vertices: &[VertexId]) -> Vec<Mark> {
        let colour = appearance::NON_MANIFOLD.colour;
        let placed = vertices.iter().filter(|&&v| self.is_placed(v)).map(|v| self.placed[v.index()]);
        let mark = |place: Vector| {
            let is_seen = self.buffer.is_seen(place);
            let colour = if is_seen { colour } else { appearance::NON_MANIFOLD.behind().colour };
            let reach = if is_seen { 5.0 } else { 3.5 };
            Mark { shape: Shape::Square, at: [place[0], place[1]], reach, colour }
        };
        placed.map(mark).collect()
    }

    pub(crate) fn is_placed(&self, vertex: VertexId) -> bool {
        self.placed[vertex.index()][0].is_finite()
    }

    fn edge_middle(&self, edge: EdgeId) -> Option<Vector> {
        let [a, b] = self.mesh.complex().edges().ends(edge);
        let middle = scaled(add(self.placed[a.index()], self.placed[b.index()]), 0.5);
        middle[0].is_finite().then_some(middle)
    }

    fn face_middle(&self, face: FaceId) -> Option<Vector> {
        let vertices = self.mesh.complex().faces().face_vertices(face);
        mean(vertices.iter().map(|v| self.placed[v.index()])).filter(|middle| middle[0].is_finite())
    }
}

/// A place on lines for a label that is away from those that are taken: if possible in the middle of a part that is
/// seen, else elsewhere on one, else on a part that is hidden; the first one tried where all are taken.
fn label_place(lines: &Sighted, taken: &[[f64; 2]]) -> Option<[f64; 2]> {
    let tries = [1, 2, 4, 8, 16].into_iter();
    let places = [&lines.seen, &lines.hidden].into_iter().flat_map(|lines| {
        let longest = lines.longest();
        tries.clone().flat_map(move |count| places_along(longest, count))
    });
    let places: Vec<[f64; 2]> = places.map(|(at, _)| at).collect();
    let is_free = |at: &&[f64; 2]| taken.iter().all(|label| step_length(&[**at, *label]) > LABEL_DISTANCE);
    places.iter().find(is_free).or(places.first()).copied()
}

fn directed(ends: [VertexId; 2], direction: Direction) -> [VertexId; 2] {
    match direction {
        Direction::Forward => ends,
        Direction::Backward => [ends[1], ends[0]],
    }
}
