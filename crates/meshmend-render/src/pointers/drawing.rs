//! The laid out faces with arrows, as SVG.

use std::collections::BTreeSet;
use std::fmt::Write;

use meshmend_core::{Cell, Connectivity, CornerId, EdgeId, EdgeUse, FaceId, Pointer, Target, VertexId};

use super::flat::{Flat, Place, mirrored};
use super::patch::Patch;
use crate::output::svg::escaped;

const WIDTH: f64 = 760.0;
const HEIGHT: f64 = 600.0;
const MARGIN: f64 = 90.0;

/// How far a half-edge lies from its edge, as a part of the way to the centre of its face.
const INWARD: f64 = 0.3;

/// What does not depend on the mesh: sizes, the head of an arrow, and how texts and lines look.
const STYLE: &str = "<defs><marker id=\"head\" viewBox=\"0 0 8 8\" refX=\"7\" refY=\"4\" markerWidth=\"7\" markerHeight=\"7\" orient=\"auto\">\
    <path d=\"M0 0L8 4L0 8Z\" fill=\"#b3541e\"/></marker></defs>\n\
    <style>.paper{fill:#fff;fill-opacity:0.75}.face{fill:#eef2f6}.edge{stroke:#555;stroke-width:1.2;fill:none}\
    .id{fill:#555;text-anchor:middle}.half{stroke:#1b6ca8;stroke-width:1.5;fill:none}.arrow{stroke:#b3541e;stroke-width:1.4;fill:none}\
    .field{fill:#b3541e;text-anchor:middle;font-style:italic}.at{fill:none;stroke:#b3541e;stroke-width:2}</style>\n";

/// The drawing, as SVG.
pub(super) fn drawing(
    kernel: &EdgeUse,
    patch: &Patch,
    flat: &Flat,
    at: Cell,
    arrows: &[Pointer],
    title: &str,
) -> String {
    let sheet = Sheet { kernel, patch, places: on_paper(flat) };
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" font-family=\"Helvetica, Arial, sans-serif\" \
         font-size=\"13\">\n<rect width=\"{WIDTH}\" height=\"{HEIGHT}\" fill=\"#fff\"/>\n{STYLE}\
         <text x=\"20\" y=\"28\" font-size=\"15\">{}</text>\n",
        escaped(title)
    );
    sheet.mesh(&mut svg);
    let cells = arrows.iter().filter_map(|arrow| match arrow.to {
        Target::Cell(cell) => Some(cell),
        _ => None,
    });
    let halves: BTreeSet<CornerId> = std::iter::once(at).chain(cells).filter_map(corner_of).collect();
    halves.into_iter().for_each(|half| sheet.half_edge(half, &mut svg));
    let [x, y] = sheet.anchor(at);
    // Writing to a text can't fail.
    let _ = writeln!(svg, "<circle class=\"at\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"9\"/>");
    for (place, arrow) in arrows.iter().enumerate() {
        let same = arrows[..place].iter().filter(|other| other.to == arrow.to).count();
        sheet.arrow(at, arrow, same, &mut svg);
    }
    svg.push_str("</svg>\n");
    svg
}

fn corner_of(cell: Cell) -> Option<CornerId> {
    match cell {
        Cell::Corner(corner) => Some(corner),
        _ => None,
    }
}

/// The places scaled to fill the paper, y going down.
fn on_paper(flat: &Flat) -> Flat {
    let reach = |axis: usize| {
        let values = || flat.values().map(move |place| place[axis]);
        [values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max)]
    };
    let ([left, right], [low, high]) = (reach(0), reach(1));
    let fit =
        |room: f64, extent: f64| if extent > 0.0 { (room - 2.0 * MARGIN) / extent } else { f64::INFINITY };
    let scale = fit(WIDTH, right - left).min(fit(HEIGHT, high - low));
    let scale = if scale.is_finite() { scale } else { 1.0 };
    let place = |[x, y]: Place| {
        [WIDTH / 2.0 + scale * (x - (left + right) / 2.0), HEIGHT / 2.0 - scale * (y - (low + high) / 2.0)]
    };
    flat.iter().map(|(&vertex, &at)| (vertex, place(at))).collect()
}

struct Sheet<'a> {
    kernel: &'a EdgeUse,
    patch: &'a Patch,
    places: Flat,
}

impl Sheet<'_> {
    /// Faces, edges and vertices with their ids.
    fn mesh(&self, svg: &mut String) {
        for &face in &self.patch.faces {
            let points: Vec<String> =
                self.outline(face).into_iter().map(|[x, y]| format!("{x:.1},{y:.1}")).collect();
            let _ = writeln!(svg, "<polygon class=\"face\" points=\"{}\"/>", points.join(" "));
            text(svg, "id", self.centre(face), Cell::Face(face));
        }
        let edges: BTreeSet<EdgeId> =
            self.patch.corners(self.kernel).map(|corner| self.kernel.corner_edge(corner)).collect();
        for edge in edges {
            let [[x, y], [to_x, to_y]] = self.ends(edge);
            let _ = writeln!(svg, "<path class=\"edge\" d=\"M{x:.1} {y:.1}L{to_x:.1} {to_y:.1}\"/>");
            text(svg, "id", self.middle(edge), Cell::Edge(edge));
        }
        for (&vertex, &[x, y]) in &self.places {
            let _ = writeln!(svg, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"3.5\"/>");
            text(svg, "id", [x, y - 10.0], Cell::Vertex(vertex));
        }
    }

    /// A half-edge on the left of its edge.
    fn half_edge(&self, half: CornerId, svg: &mut String) {
        let inward = |vertex: VertexId| {
            let (from, centre) = (self.place(vertex), self.centre(self.kernel.corner_face(half)));
            between(from, centre, INWARD)
        };
        let (from, to) = (inward(self.kernel.corner_vertex(half)), inward(self.kernel.corner_target(half)));
        let barb = between(to, self.centre(self.kernel.corner_face(half)), 0.18);
        let barb = between(barb, from, 0.12);
        let _ = writeln!(
            svg,
            "<path class=\"half\" d=\"M{:.1} {:.1}L{:.1} {:.1}L{:.1} {:.1}\"/>",
            from[0], from[1], to[0], to[1], barb[0], barb[1]
        );
        text(
            svg,
            "id",
            between(self.anchor(Cell::Corner(half)), self.centre(self.kernel.corner_face(half)), 0.2),
            Cell::Corner(half),
        );
    }

    /// An arrow with its field's name; `same` others go to the same target.
    fn arrow(&self, at: Cell, arrow: &Pointer, same: usize, svg: &mut String) {
        let from = self.anchor(at);
        let to = match arrow.to {
            Target::Cell(cell) => self.anchor(cell),
            _ => self.outside(at),
        };
        let (across, length) = normal(from, to);
        let bend = 16.0 + 18.0 * same as f64;
        // A pointer to the record itself goes out and comes back.
        let control = if length < 1.0 {
            [from[0] + 40.0 + bend, from[1] - 40.0 - bend]
        } else {
            let middle = between(from, to, 0.5);
            [middle[0] + bend * across[0], middle[1] + bend * across[1]]
        };
        let start = between(from, control, (9.0 / distance(from, control)).min(0.4));
        let end = between(to, control, (7.0 / distance(to, control)).min(0.4));
        let _ = writeln!(
            svg,
            "<path class=\"arrow\" marker-end=\"url(#head)\" d=\"M{:.1} {:.1}Q{:.1} {:.1} {:.1} {:.1}\"/>",
            start[0], start[1], control[0], control[1], end[0], end[1]
        );
        // The name of a short arrow stands beside it: there is no room on it.
        let aside = if length < 60.0 { 36.0 } else { 0.55 * bend };
        let middle = between(from, to, 0.5);
        let label = [middle[0] + aside * across[0], middle[1] + aside * across[1]];
        text(svg, "field", label, escaped(arrow.field));
        if let Target::Dart(_) | Target::Hole = arrow.to {
            text(svg, "id", [to[0], to[1] + 16.0], arrow.to);
        }
    }

    /// Where the record of an element stands.
    fn anchor(&self, cell: Cell) -> Place {
        match cell {
            Cell::Vertex(vertex) => self.place(vertex),
            Cell::Edge(edge) => self.middle(edge),
            Cell::Face(face) => self.centre(face),
            Cell::Corner(corner) => {
                let middle = self.middle(self.kernel.corner_edge(corner));
                between(middle, self.centre(self.kernel.corner_face(corner)), INWARD)
            }
        }
    }

    /// A place beyond an element, outside of the mesh.
    fn outside(&self, cell: Cell) -> Place {
        let anchor = self.anchor(cell);
        let edge = match cell {
            Cell::Corner(corner) => Some(self.kernel.corner_edge(corner)),
            Cell::Edge(edge) => Some(edge),
            _ => None,
        };
        let inside = match (cell, edge) {
            (Cell::Corner(_), _) => anchor,
            (_, Some(edge)) => self.kernel.edge_faces(edge).next().map_or(anchor, |face| self.centre(face)),
            _ => [WIDTH / 2.0, HEIGHT / 2.0],
        };
        match edge {
            Some(edge) => between(
                self.middle(edge),
                mirrored(inside, self.ends(edge)),
                1.0_f64.min(60.0 / distance(self.middle(edge), inside).max(1.0)),
            ),
            None => {
                let (_, length) = normal(inside, anchor);
                if length < 1.0 {
                    [anchor[0], anchor[1] + 60.0]
                } else {
                    between(inside, anchor, 1.0 + 50.0 / length)
                }
            }
        }
    }

    fn place(&self, vertex: VertexId) -> Place {
        self.places.get(&vertex).copied().unwrap_or([WIDTH / 2.0, HEIGHT / 2.0])
    }

    fn ends(&self, edge: EdgeId) -> [Place; 2] {
        self.kernel.edge_ends(edge).map(|end| self.place(end))
    }

    fn middle(&self, edge: EdgeId) -> Place {
        let [one, other] = self.ends(edge);
        between(one, other, 0.5)
    }

    fn outline(&self, face: FaceId) -> Vec<Place> {
        self.kernel.face_vertices(face).map(|vertex| self.place(vertex)).collect()
    }

    fn centre(&self, face: FaceId) -> Place {
        let outline = self.outline(face);
        let count = outline.len().max(1) as f64;
        outline.iter().fold([0.0; 2], |sum, [x, y]| [sum[0] + x / count, sum[1] + y / count])
    }
}

/// Words on a piece of paper, so that lines behind them do not disturb.
fn text(svg: &mut String, class: &str, [x, y]: Place, words: impl std::fmt::Display) {
    let words = words.to_string();
    let width = 7.0 * words.chars().count() as f64;
    let _ = writeln!(
        svg,
        "<rect class=\"paper\" x=\"{:.1}\" y=\"{:.1}\" width=\"{width}\" height=\"14\"/>",
        x - width / 2.0,
        y - 7.0
    );
    let _ = writeln!(svg, "<text class=\"{class}\" x=\"{x:.1}\" y=\"{:.1}\">{words}</text>", y + 4.0);
}

fn between(from: Place, to: Place, part: f64) -> Place {
    [from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1])]
}

fn distance(from: Place, to: Place) -> f64 {
    (to[0] - from[0]).hypot(to[1] - from[1]).max(1e-9)
}

/// The direction across a way, and how long the way is.
fn normal(from: Place, to: Place) -> (Place, f64) {
    let length = distance(from, to);
    ([(to[1] - from[1]) / length, (from[0] - to[0]) / length], length)
}
