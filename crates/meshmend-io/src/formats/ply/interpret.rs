//! Columns of vertices, faces and edges become attribute layers.

use meshmend_core::{Carry, Domain, Layer, Metadata, NO_VALUE, Values};

use crate::formats::ply::columns::Columns;
use crate::formats::ply::header::Element;
use crate::formats::ply::layers::{interleaved, is_usual};
use crate::formats::ply::property_names::{CORNER_PREFIX, GROUPS, Group, PROPERTY_NAMES};
use crate::formats::ply::scalar::Scalar;
use crate::input::assemble::Parts;

/// The list of faces that is a corner layer though its name does not begin so.
const TEXCOORD: &str = "texcoord";

/// The rows of an element that became vertices, faces or edges.
pub(super) struct ElementRows<'a> {
    pub(super) element: &'a Element,
    pub(super) columns: Columns,
    /// Which columns are not layers, or belong to a layer already.
    pub(super) is_taken: Vec<bool>,
    /// The face that the first row became.
    pub(super) first: usize,
    /// Where the corners of each row begin, and where those of the last row end. It is empty if no list can belong to
    /// corners.
    pub(super) corner_starts: Vec<u32>,
}

pub(super) fn vertex_layers(rows: ElementRows<'_>, parts: &mut Parts) {
    direct_layers(rows, Domain::Vertex, parts);
}

pub(super) fn edge_layers(rows: ElementRows<'_>, parts: &mut Parts) {
    direct_layers(rows, Domain::LooseEdge, parts);
}

/// Adds layers in which each row has its own value.
fn direct_layers(mut rows: ElementRows<'_>, domain: Domain, parts: &mut Parts) {
    for column in 0..rows.element.properties.len() {
        if let Some((name, width, values)) = rows.next_layer(column, domain, parts) {
            let carry = if domain == Domain::Vertex { carry(&values) } else { Carry::Copy };
            parts.layers.push(Layer::direct(name, domain, width, carry, values));
        }
    }
}

pub(super) fn face_layers(mut rows: ElementRows<'_>, parts: &mut Parts) {
    for column in 0..rows.element.properties.len() {
        if let Some(layer) = rows.corner_layer(column, parts) {
            parts.layers.push(layer);
            continue;
        }
        let Some((name, width, values)) = rows.next_layer(column, Domain::Face, parts) else { continue };
        let (faces, count) = (parts.faces.face_count(), rows.element.count as usize);
        let layer = if count == faces {
            Layer::direct(name, Domain::Face, width, Carry::Copy, values)
        } else {
            // Other faces come from triangle strips.
            let row = |face: usize| face.checked_sub(rows.first).filter(|&row| row < count);
            let uses = (0..faces).map(|face| row(face).map_or(NO_VALUE, |row| row as u32)).collect();
            Layer::indexed(name, Domain::Face, width, Carry::Copy, values, uses)
        };
        parts.layers.push(layer);
    }
}

fn carry(values: &Values) -> Carry {
    match values {
        Values::F32(_) | Values::F64(_) => Carry::Interpolate,
        _ => Carry::Copy,
    }
}

impl ElementRows<'_> {
    /// The layer that begins with a column: name, width and values. Returns `None` if the column belongs to a layer
    /// already.
    fn next_layer(
        &mut self,
        column: usize,
        domain: Domain,
        parts: &mut Parts,
    ) -> Option<(String, usize, Values)> {
        if self.is_taken[column] {
            return None;
        }
        // Two layers of one name would be ambiguous: then the numbers stay single, under their own names. Only few
        // names belong to a group, so all properties are searched for few of them.
        let name = self.element.properties[column].name.as_str();
        let mut groups = GROUPS.iter().filter(|group| {
            group.members.contains(&name)
                && !self.has_property(group.layer, domain)
                && !has_layer(parts, group.layer, domain)
        });
        let Some((group, members)) = groups.find_map(|group| Some((group, self.members(group, column)?)))
        else {
            let values = std::mem::replace(&mut self.columns.values[column], Values::U8(Vec::new()));
            return Some((self.element.properties[column].name.clone(), 1, values));
        };
        if !is_usual(group) {
            let domain = domain.name();
            let value = format!("{domain} {} {}", group.layer, group.members.join(" ")).into_bytes();
            parts.metadata.push(Metadata { key: PROPERTY_NAMES.to_owned(), value });
        }
        let columns: Vec<Values> = members
            .iter()
            .map(|&member| std::mem::replace(&mut self.columns.values[member], Values::U8(Vec::new())))
            .collect();
        members.iter().for_each(|&member| self.is_taken[member] = true);
        Some((group.layer.to_owned(), members.len(), interleaved(&columns)))
    }

    /// Whether a property of this name becomes a layer of this domain.
    fn has_property(&self, name: &str, domain: Domain) -> bool {
        let mut columns =
            self.element.properties.iter().zip(0..).filter(|(property, _)| property.name == name);
        columns.any(|(_, column)| domain != Domain::Face || self.corner_list(column).is_none())
    }

    /// The columns of a group to which this column belongs, if all exist, are free, and have one type.
    fn members(&self, group: &Group, column: usize) -> Option<Vec<usize>> {
        let properties = &self.element.properties;
        let first = &properties[column];
        if !group.members.contains(&first.name.as_str()) {
            return None;
        }
        let of_name = |name: &&str| {
            properties.iter().position(|p| p.name == *name && p.length.is_none() && p.item == first.item)
        };
        let members: Vec<usize> = group.members.iter().map(of_name).collect::<Option<_>>()?;
        members.iter().all(|member| !self.is_taken[*member]).then_some(members)
    }

    /// The corner layer of a list property of faces, if no other one has its name.
    fn corner_layer(&mut self, column: usize, parts: &Parts) -> Option<Layer> {
        let (name, width) = self.corner_list(column)?;
        // Names of properties differ, but this layer can come from two names.
        let may_be_there = name == TEXCOORD;
        if self.is_taken[column] || (may_be_there && has_layer(parts, name, Domain::Corner)) {
            return None;
        }
        let name = name.to_owned();
        let Values::Lists { starts, items } = &mut self.columns.values[column] else { return None };
        let values = std::mem::replace(items.as_mut(), Scalar::U8.empty());
        let uses = corner_uses(starts, &self.corner_starts, parts.faces.corner_count());
        let carry = carry(&values);
        self.is_taken[column] = true;
        Some(match uses {
            None => Layer::direct(name, Domain::Corner, width, carry, values),
            Some(uses) => Layer::indexed(name, Domain::Corner, width, carry, values, uses),
        })
    }

    /// The name and width of the corner layer of a list property of faces, if it has such a name and its lengths fit.
    fn corner_list(&self, column: usize) -> Option<(&str, usize)> {
        let property = &self.element.properties[column];
        let is_texcoord = property.name == TEXCOORD;
        let name = match property.name.strip_prefix(CORNER_PREFIX) {
            None if is_texcoord => TEXCOORD,
            name => name?,
        };
        let Values::Lists { starts, .. } = &self.columns.values[column] else { return None };
        let width = corner_width(starts, &self.corner_starts)?;
        (!is_texcoord || width == 2).then_some((name, width))
    }
}

fn has_layer(parts: &Parts, name: &str, domain: Domain) -> bool {
    parts.layers.iter().any(|layer| layer.name() == name && layer.domain() == domain)
}

/// How many numbers each corner has, if that is the same in all lists that are not empty.
fn corner_width(starts: &[u32], corner_starts: &[u32]) -> Option<usize> {
    let lengths = starts.windows(2).map(|pair| pair[1] - pair[0]);
    let degrees = corner_starts.windows(2).map(|pair| pair[1] - pair[0]);
    let mut full = lengths.zip(degrees).filter(|&(length, _)| length > 0);
    let (length, degree) = full.next()?;
    let width = length.checked_div(degree).filter(|&width| width * degree == length)?;
    full.all(|(length, degree)| u64::from(degree) * u64::from(width) == u64::from(length))
        .then_some(width as usize)
}

/// Which value each corner uses. Returns `None` if corner `i` uses value `i`.
fn corner_uses(starts: &[u32], corner_starts: &[u32], corners: usize) -> Option<Vec<u32>> {
    let mut uses = vec![NO_VALUE; corners];
    let mut next = 0;
    for (list, face) in starts.windows(2).zip(corner_starts.windows(2)) {
        if list[0] == list[1] {
            continue;
        }
        for slot in &mut uses[face[0] as usize..face[1] as usize] {
            *slot = next;
            next += 1;
        }
    }
    (next as usize != corners).then_some(uses)
}
