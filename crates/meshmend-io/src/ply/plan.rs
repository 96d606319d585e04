//! Which layers become which properties, and what can't.

use std::collections::BTreeSet;

use meshmend_core::{Domain, Id, Layer, PolygonMesh, Values};

use crate::layers::{
    absent, absent_loss, domain_name, layer_losses, losses_in, metadata_losses, one_line, point_loss,
};
use crate::ply::layers::usual;
use crate::ply::scalar::Scalar;
use crate::ply::{CORNER_PREFIX, PROPERTY_NAMES, PlyShape};
use crate::{Loss, LossKind, Prepared};

/// The properties of a file to be written.
pub(super) struct Plan<'a> {
    /// The type of the coordinates.
    pub(super) position: Scalar,
    /// The type of the numbers of corners.
    pub(super) degree: Scalar,
    pub(super) vertex: Vec<Column<'a>>,
    pub(super) face: Vec<Column<'a>>,
    names: BTreeSet<(Domain, String)>,
    losses: Vec<Loss>,
}

/// A property to be written.
pub(super) struct Column<'a> {
    pub(super) name: String,
    pub(super) layer: &'a Layer,
    pub(super) item: Scalar,
    pub(super) shape: Shape,
}

/// How a property gets its values from a layer.
#[derive(Clone, Copy)]
pub(super) enum Shape {
    /// One of the numbers of each value.
    Component(usize),
    /// Each value is a list, with its length in this type.
    List(Scalar),
    /// The values of a face's corners, one after the other, with their number in this type.
    Corners(Scalar),
}

/// The keys of metadata that are written.
const KEYS: [&str; 3] = ["comment", "obj_info", PROPERTY_NAMES];

pub(super) fn losses(prepared: &Prepared) -> Vec<Loss> {
    let mesh = &prepared.mesh;
    let plan = Plan::of(prepared);
    let mut losses = layer_losses(mesh, &plan.layers());
    losses.extend(plan.losses);
    losses.extend(losses_in(mesh, &[], &[Domain::LooseEdge]));
    losses.extend(point_loss(mesh));
    losses.extend(metadata_losses(mesh, &KEYS));
    let statements = mesh.metadata().iter().filter(|m| KEYS.contains(&m.kind()));
    let other = statements.filter(|m| header_line(&m.value) != m.value).count();
    losses.extend(Loss::if_any(LossKind::Names, other, |n| format!("{n} comments are spelled otherwise")));
    losses
}

/// A statement as a line of a header, in which `end_header` stands for the end alone.
pub(super) fn header_line(value: &[u8]) -> Vec<u8> {
    const END: &[u8] = b"end_header";
    let mut line = one_line(value).into_owned();
    for at in 0..line.len().saturating_sub(END.len() - 1) {
        if line[at..].starts_with(END) {
            line[at + 3] = b'-';
        }
    }
    line
}

impl<'a> Plan<'a> {
    pub(super) fn of(prepared: &'a Prepared) -> Self {
        let mesh = &prepared.mesh;
        let is_single = |x: &f64| f64::from(*x as f32).to_bits() == x.to_bits();
        let all_single = mesh.positions().iter().flatten().all(is_single);
        let faces = mesh.faces();
        let most = if faces.is_all_triangles() {
            3
        } else {
            faces.faces().map(|f| faces.corner_range(f).len()).max().unwrap_or(0)
        };
        let declared = PlyShape::of(prepared).map(|shape| shape.position);
        let mut plan = Plan {
            position: if all_single && declared != Some(Scalar::F64) { Scalar::F32 } else { Scalar::F64 },
            degree: Scalar::counting(most),
            vertex: Vec::new(),
            face: Vec::new(),
            names: reserved_names(),
            losses: Vec::new(),
        };
        for layer in mesh.layers() {
            plan.add(mesh, layer, most);
        }
        plan
    }

    fn layers(&self) -> Vec<&'a Layer> {
        self.vertex.iter().chain(&self.face).map(|column| column.layer).collect()
    }

    fn add(&mut self, mesh: &'a PolygonMesh, layer: &'a Layer, most_corners: usize) {
        match (layer.domain(), layer.values()) {
            (_, Values::Text(_)) | (Domain::LooseEdge | Domain::LoosePoint, _) => {}
            (Domain::Corner, Values::Lists { .. }) => {}
            // A property of empty lists would be read as one of the faces.
            (Domain::Corner, _) if absent(layer) == layer.element_count() => {}
            (Domain::Corner, values) => {
                let Some(item) = Scalar::of(values) else { return };
                let is_usual = layer.name() == "texcoord" && layer.width() == 2;
                let prefix = if is_usual { "" } else { CORNER_PREFIX };
                let shape = Shape::Corners(Scalar::counting(most_corners.saturating_mul(layer.width())));
                self.push(layer, format!("{prefix}{}", layer.name()), item, shape);
                self.losses.extend(absent_loss(layer, partly_absent(mesh, layer)));
            }
            (_, Values::Lists { starts, items }) if layer.width() == 1 => {
                let Some(item) = Scalar::of(items) else { return };
                let most = starts.windows(2).map(|pair| (pair[1] - pair[0]) as usize).max().unwrap_or(0);
                self.push(layer, layer.name().to_owned(), item, Shape::List(Scalar::counting(most)));
                self.losses.extend(absent_loss(layer, absent(layer)));
            }
            (_, Values::Lists { .. }) => {}
            (_, values) => {
                let Some(item) = Scalar::of(values) else { return };
                for (component, name) in names(mesh, layer).into_iter().enumerate() {
                    self.push(layer, name, item, Shape::Component(component));
                }
                self.losses.extend(absent_loss(layer, absent(layer)));
            }
        }
    }

    fn push(&mut self, layer: &'a Layer, name: String, item: Scalar, shape: Shape) {
        let element = if layer.domain() == Domain::Vertex { Domain::Vertex } else { Domain::Face };
        let is_blank = |c: char| c.is_whitespace() || c.is_control();
        let mut spelled: String = name.chars().map(|c| if is_blank(c) { '_' } else { c }).collect();
        while spelled.is_empty() || !self.names.insert((element, spelled.clone())) {
            spelled.push('_');
        }
        if spelled != name {
            let message = format!("property `{name}` is called `{spelled}`");
            self.losses.push(Loss::new(LossKind::Names, 1, message));
        }
        let columns = if element == Domain::Vertex { &mut self.vertex } else { &mut self.face };
        columns.push(Column { name: spelled, layer, item, shape });
    }
}

/// The names that positions and faces have.
fn reserved_names() -> BTreeSet<(Domain, String)> {
    let of_vertices = ["x", "y", "z"].map(|name| (Domain::Vertex, name.to_owned()));
    let of_faces = ["vertex_indices", "vertex_index"].map(|name| (Domain::Face, name.to_owned()));
    of_vertices.into_iter().chain(of_faces).collect()
}

/// The names of the properties that a layer is spread over.
fn names(mesh: &PolygonMesh, layer: &Layer) -> Vec<String> {
    let width = layer.width();
    match usual(layer.name(), width) {
        Some(usual) => stated_names(mesh, layer)
            .unwrap_or_else(|| usual.members.iter().map(|&name| name.to_owned()).collect()),
        None if width == 1 => vec![layer.name().to_owned()],
        None => (0..width).map(|i| format!("{}_{i}", layer.name())).collect(),
    }
}

/// The names that the file had for a layer's properties.
fn stated_names(mesh: &PolygonMesh, layer: &Layer) -> Option<Vec<String>> {
    let prefix = format!("{} {} ", domain_name(layer.domain()), layer.name());
    mesh.metadata().iter().filter(|m| m.key == PROPERTY_NAMES).find_map(|m| {
        let names = m.value.strip_prefix(prefix.as_bytes())?;
        let names: Vec<String> = String::from_utf8_lossy(names).split(' ').map(str::to_owned).collect();
        (names.len() == layer.width()).then_some(names)
    })
}

/// How many corners have no value while others of their face have one.
fn partly_absent(mesh: &PolygonMesh, layer: &Layer) -> usize {
    if layer.is_direct() {
        return 0;
    }
    let faces = mesh.faces();
    let absent_in = |range: std::ops::Range<usize>| {
        let degree = range.len();
        let absent = range.filter(|&corner| layer.value_of(corner).is_none()).count();
        if absent == degree { 0 } else { absent }
    };
    faces.faces().map(|face| absent_in(faces.corner_range(face))).sum()
}

impl Column<'_> {
    /// Which value an element uses, or for a face of a corner layer whether any of its corners uses one.
    pub(super) fn value_of(&self, element: usize) -> Option<usize> {
        self.layer.value_of(element)
    }

    /// How many numbers a face's list has: none when no corner has a value.
    pub(super) fn corner_values(&self, corners: std::ops::Range<usize>) -> usize {
        let has_any = corners.clone().any(|corner| self.layer.value_of(corner).is_some());
        if has_any { corners.len() * self.layer.width() } else { 0 }
    }
}

/// The index of a vertex as it is written.
pub(super) fn index(vertex: meshmend_core::VertexId) -> i64 {
    vertex.index() as i64
}
