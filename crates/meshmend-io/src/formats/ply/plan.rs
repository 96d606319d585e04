//! Which elements and properties a file gets: those of the file that the mesh comes from, if there was one, and those
//! that the layers need.

use std::collections::BTreeSet;

use meshmend_core::{Domain, Layer, PolygonMesh, Values};

use crate::formats::ply::layers::usual;
use crate::formats::ply::property::{Property, Source};
use crate::formats::ply::property_names::{CORNER_PREFIX, PROPERTY_NAMES};
use crate::formats::ply::scalar::Scalar;
use crate::formats::ply::shape::{Declared, DeclaredProperty, PlyShape};
use crate::formats::ply::types::{coordinate_types, corners_at_most, counting, fitting};
use crate::output::layer_losses::{absent, absent_loss, layer_losses, losses_in, point_loss};
use crate::output::statements::{metadata_losses, one_line};
use crate::text::one_or_many;
use crate::{Loss, LossKind, Prepared};

/// The elements of a file to be written.
pub(super) struct Plan<'a> {
    pub(super) elements: Vec<Element<'a>>,
    losses: Vec<Loss>,
}

/// An element to be written.
pub(super) struct Element<'a> {
    pub(super) name: &'a str,
    pub(super) count: usize,
    pub(super) properties: Vec<Property<'a>>,
}

/// The keys of metadata that are written.
const KEYS: [&str; 3] = ["comment", "obj_info", PROPERTY_NAMES];

pub(super) fn losses(prepared: &Prepared) -> Vec<Loss> {
    let mesh = &prepared.mesh;
    let plan = Plan::of(prepared);
    let mut losses = layer_losses(mesh, &plan.layers());
    losses.extend(losses_in(mesh, &plan.layers(), &[Domain::LooseEdge]));
    losses.extend(plan.losses);
    losses.extend(prepared.shape::<PlyShape>().map(|shape| shape.stale_losses(mesh)).unwrap_or_default());
    losses.extend(point_loss(mesh));
    losses.extend(metadata_losses(mesh, &KEYS));
    let statements = mesh.metadata().iter().filter(|m| KEYS.contains(&m.kind()));
    let other = statements.filter(|m| header_line(&m.value) != m.value).count();
    losses.extend(Loss::if_any(LossKind::Names, other, |n| {
        one_or_many(n, "comment is spelled differently", "comments are spelled differently")
    }));
    losses
}

/// A statement as a line of a header. `end_header` is changed in it, as only the end may have that word.
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
        let (mesh, shape) = (&prepared.mesh, prepared.shape::<PlyShape>());
        let mut planner = Planner::new(mesh, shape);
        mesh.layers().iter().for_each(|layer| planner.add(layer));
        let Planner { vertex, face, edge, losses, .. } = planner;
        let (faces, edges) = (mesh.counts().faces, mesh.loose_edges().len());
        let is_declared = |name: &str| shape.is_some_and(|shape| shape.element(name).is_some());
        let mut known = vec![Element { name: "vertex", count: mesh.counts().vertices, properties: vertex }];
        // A cloud of points does not declare faces.
        if faces > 0 || is_declared("face") || mesh.counts().vertices == 0 {
            known.push(Element { name: "face", count: faces, properties: face });
        }
        if edges > 0 || is_declared("edge") && !is_table(shape, "edge") {
            known.push(Element { name: "edge", count: edges, properties: edge });
        }
        Plan { elements: in_declared_order(known, shape), losses }
    }

    fn layers(&self) -> Vec<&'a Layer> {
        let properties = self.elements.iter().flat_map(|element| &element.properties);
        properties.filter_map(|property| property.source.layer()).collect()
    }
}

/// Whether the file that the mesh comes from has an element of this name that is carried unchanged.
fn is_table(shape: Option<&PlyShape>, name: &str) -> bool {
    shape.and_then(|shape| shape.element(name)).is_some_and(|element| element.table.is_some())
}

/// The elements of a mesh and those that are carried unchanged, in the order of the file that the mesh comes from.
///
/// *Cost*: linear, except for sorting the properties of vertices, faces and edges.
fn in_declared_order<'a>(mut known: Vec<Element<'a>>, shape: Option<&'a PlyShape>) -> Vec<Element<'a>> {
    let Some(shape) = shape else { return known };
    known.iter_mut().for_each(|element| sort_as_declared(element, shape));
    let mut all = Vec::with_capacity(shape.elements.all().len());
    for declared in shape.elements.all() {
        match &declared.table {
            Some(rows) => all.push(Element {
                name: &declared.name,
                count: rows.count,
                properties: table_properties(declared, &rows.columns),
            }),
            None => {
                let at = known.iter().position(|element| element.name == declared.name);
                all.extend(at.map(|at| known.remove(at)));
            }
        }
    }
    // If the file did not declare vertices, they come first.
    let rest_is_first = known.first().is_some_and(|element| element.name == "vertex");
    if rest_is_first {
        all.insert(0, known.remove(0));
    }
    all.extend(known);
    all
}

fn sort_as_declared(element: &mut Element<'_>, shape: &PlyShape) {
    if let Some(declared) = shape.element(element.name) {
        let place =
            |property: &Property<'_>| declared.property(&property.name).map_or(usize::MAX, |(at, _)| at);
        element.properties.sort_by_cached_key(place);
    }
}

fn table_properties<'a>(declared: &'a Declared, columns: &'a [Layer]) -> Vec<Property<'a>> {
    let property = |(property, layer): (&'a DeclaredProperty, &'a Layer)| Property {
        name: property.name.clone(),
        item: property.item,
        source: property.length.map_or(Source::Component(layer, 0), |length| Source::List(layer, length)),
    };
    declared.properties.all().iter().zip(columns).map(property).collect()
}

/// The ends of loose edges.
fn ends<'a>(mesh: &PolygonMesh, shape: Option<&PlyShape>) -> Vec<Property<'a>> {
    let highest = mesh.counts().vertices.saturating_sub(1);
    let declared = shape.and_then(|shape| shape.element("edge"));
    let end = |(end, name): (usize, &str)| {
        let item = declared.and_then(|declared| Some(declared.property(name)?.1.item));
        Property {
            name: name.to_owned(),
            item: fitting(item, highest, Scalar::I32),
            source: Source::End(end),
        }
    };
    ["vertex1", "vertex2"].into_iter().enumerate().map(end).collect()
}

/// Collects the properties of vertices and faces.
struct Planner<'a> {
    mesh: &'a PolygonMesh,
    shape: Option<&'a PlyShape>,
    most_corners: usize,
    vertex: Vec<Property<'a>>,
    face: Vec<Property<'a>>,
    edge: Vec<Property<'a>>,
    names: BTreeSet<(Domain, String)>,
    losses: Vec<Loss>,
}

impl<'a> Planner<'a> {
    fn new(mesh: &'a PolygonMesh, shape: Option<&'a PlyShape>) -> Self {
        let (vertex, names) = (Vec::new(), reserved_names());
        let most_corners = corners_at_most(mesh.faces());
        let mut planner = Planner {
            mesh,
            shape,
            most_corners,
            vertex,
            face: Vec::new(),
            edge: ends(mesh, shape),
            names,
            losses: Vec::new(),
        };
        let types = coordinate_types(mesh, shape.and_then(|shape| shape.element("vertex")));
        let axes = ["x", "y", "z"].into_iter().zip(types).enumerate();
        let coordinate = |(axis, (name, item)): (usize, (&str, Scalar))| Property {
            name: name.to_owned(),
            item,
            source: Source::Coordinate(axis),
        };
        planner.vertex.extend(axes.map(coordinate));
        planner.face.push(planner.indices());
        planner
    }

    /// The list of the vertices of a face, as declared in the file that the mesh comes from if its types are wide
    /// enough.
    fn indices(&self) -> Property<'a> {
        let face = self.shape.and_then(|shape| shape.element("face"));
        let names = ["vertex_indices", "vertex_index"];
        let named = names.iter().filter_map(|name| face?.property(name));
        let lists = named.filter(|(_, property)| property.length.is_some());
        let declared = lists.min_by_key(|&(at, _)| at).map(|(_, property)| property);
        let highest = self.mesh.counts().vertices.saturating_sub(1);
        Property {
            name: declared.map_or(names[0], |property| property.name.as_str()).to_owned(),
            item: fitting(declared.map(|property| property.item), highest, Scalar::I32),
            source: Source::Indices(counting(
                declared.and_then(|property| property.length),
                self.most_corners,
            )),
        }
    }

    fn add(&mut self, layer: &'a Layer) {
        match (layer.domain(), layer.values()) {
            (_, Values::Text(_)) | (Domain::LoosePoint, _) => {}
            (Domain::Corner, Values::Lists { .. }) => {}
            // A property with only empty lists would be read as one of the faces.
            (Domain::Corner, _) if absent(layer) == layer.element_count() => {}
            (Domain::Corner, values) => {
                let Some(item) = Scalar::of(values) else { return };
                let is_usual = layer.name() == "texcoord" && layer.width() == 2;
                let name = format!("{}{}", if is_usual { "" } else { CORNER_PREFIX }, layer.name());
                let most = self.most_corners.saturating_mul(layer.width());
                let length = counting(self.declared_length(Domain::Face, &name), most);
                self.push(layer, name, item, Source::Corners(layer, length));
                self.losses.extend(absent_loss(layer, partly_absent(self.mesh, layer)));
            }
            (domain, Values::Lists { starts, items }) if layer.width() == 1 => {
                let Some(item) = Scalar::of(items) else { return };
                let most = starts.windows(2).map(|pair| (pair[1] - pair[0]) as usize).max().unwrap_or(0);
                let length = counting(self.declared_length(domain, layer.name()), most);
                self.push(layer, layer.name().to_owned(), item, Source::List(layer, length));
                self.losses.extend(absent_loss(layer, absent(layer)));
            }
            (_, Values::Lists { .. }) => {}
            (_, values) => {
                let Some(item) = Scalar::of(values) else { return };
                self.losses.extend(spread_loss(layer));
                for (component, name) in names(self.mesh, layer).into_iter().enumerate() {
                    self.push(layer, name, item, Source::Component(layer, component));
                }
                self.losses.extend(absent_loss(layer, absent(layer)));
            }
        }
    }

    fn declared_length(&self, domain: Domain, name: &str) -> Option<Scalar> {
        let element = match domain {
            Domain::Vertex => "vertex",
            Domain::LooseEdge => "edge",
            _ => "face",
        };
        self.shape?.element(element)?.property(name)?.1.length
    }

    fn push(&mut self, layer: &'a Layer, name: String, item: Scalar, source: Source<'a>) {
        let (element, properties) = match layer.domain() {
            Domain::Vertex => (Domain::Vertex, &mut self.vertex),
            Domain::LooseEdge => (Domain::LooseEdge, &mut self.edge),
            _ => (Domain::Face, &mut self.face),
        };
        let is_blank = |c: char| c.is_whitespace() || c.is_control();
        let mut spelled: String = name.chars().map(|c| if is_blank(c) { '_' } else { c }).collect();
        while spelled.is_empty() || !self.names.insert((element, spelled.clone())) {
            spelled.push('_');
        }
        if spelled != name {
            let message = format!("property `{name}` is called `{spelled}`");
            self.losses.push(Loss::new(LossKind::Names, 1, message));
        }
        properties.push(Property { name: spelled, item, source });
    }
}

/// The names of positions and indices.
fn reserved_names() -> BTreeSet<(Domain, String)> {
    let of_vertices = ["x", "y", "z"].map(|name| (Domain::Vertex, name.to_owned()));
    let of_faces = ["vertex_indices", "vertex_index"].map(|name| (Domain::Face, name.to_owned()));
    let of_edges = ["vertex1", "vertex2"].map(|name| (Domain::LooseEdge, name.to_owned()));
    of_vertices.into_iter().chain(of_faces).chain(of_edges).collect()
}

/// The names of the properties over which a layer is spread.
fn names(mesh: &PolygonMesh, layer: &Layer) -> Vec<String> {
    let width = layer.width();
    match usual(layer.name(), width) {
        Some(usual) => stated_names(mesh, layer)
            .unwrap_or_else(|| usual.members.iter().map(|&name| name.to_owned()).collect()),
        None if width == 1 => vec![layer.name().to_owned()],
        None => (0..width).map(|i| format!("{}_{i}", layer.name())).collect(),
    }
}

/// The loss when each number of a value is a property of its own, which a reader does not put together.
fn spread_loss(layer: &Layer) -> Option<Loss> {
    let (domain, name, width) = (layer.domain().name(), layer.name(), layer.width());
    (width > 1 && usual(name, width).is_none()).then(|| {
        let message = format!(
            "{domain} attribute `{name}` is spread over {width} properties: `{name}_0` to `{name}_{}`",
            width - 1
        );
        Loss::new(LossKind::Converted, layer.element_count(), message)
    })
}

/// The names that the file had for the properties of a layer.
fn stated_names(mesh: &PolygonMesh, layer: &Layer) -> Option<Vec<String>> {
    let prefix = format!("{} {} ", layer.domain().name(), layer.name());
    mesh.metadata().iter().filter(|m| m.key == PROPERTY_NAMES).find_map(|m| {
        let names = m.value.strip_prefix(prefix.as_bytes())?;
        let names: Vec<String> = String::from_utf8_lossy(names).split(' ').map(str::to_owned).collect();
        (names.len() == layer.width()).then_some(names)
    })
}

/// How many corners lack a value while another corner of their face has one.
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
