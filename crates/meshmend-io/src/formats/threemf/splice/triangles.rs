//! The rows of the triangles that an object has after a change.

use meshmend_core::{CornerId, FaceId, FaceTable, Id, PolygonMesh};

use super::rows::{Rows, attributes_of, value, with_values};
use super::vertices::{Sources, Vertices};

/// What became of triangles beside their corners.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Stretched {
    /// Created corners that have the property of another corner.
    pub(super) copied: usize,
    /// Triangles that are a part of an old one and keep what was said of the whole.
    pub(super) cut: usize,
}

/// Writes triangles as rows.
pub(super) struct Triangles<'a> {
    pub(super) rows: &'a Rows<'a>,
    pub(super) mesh: &'a PolygonMesh,
    /// The mesh that the old rows say.
    pub(super) before: &'a PolygonMesh,
    pub(super) sources: &'a Sources<'a>,
    pub(super) vertices: &'a Vertices,
}

const NAMES: [&str; 3] = ["v1", "v2", "v3"];
const MEMBERS: [&str; 3] = ["p1", "p2", "p3"];

impl Triangles<'_> {
    /// The rows of all triangles.
    pub(super) fn text(&self) -> (String, Stretched) {
        let (mut text, mut stretched) = (String::new(), Stretched::default());
        let mut is_copied = vec![false; self.rows.len()];
        let mut last = 0;
        let is_triangle = |face: &FaceId| self.mesh.faces().corner_range(*face).len() == 3;
        for face in self.mesh.faces().faces().filter(is_triangle) {
            let number = self.sources.triangle(face.index());
            let source = number.and_then(|number| Some((number, self.rows.row(number)?)));
            let Some((number, row)) = source else {
                text.push_str(self.rows.blank_gap(last));
                let empty = format!("<{}/>", self.rows.name("triangle"));
                text.push_str(&with_values(&empty, &self.corners(face)));
                continue;
            };
            last = number;
            let is_again =
                is_copied.get_mut(number as usize).is_some_and(|slot| std::mem::replace(slot, true));
            text.push_str(if is_again { self.rows.blank_gap(number) } else { self.rows.gap(number) });
            let (row, found) = self.changed(row, face, number, is_again);
            text.push_str(&row);
            stretched.copied += found.copied;
            stretched.cut += found.cut;
        }
        (text + self.rows.rest(), stretched)
    }

    fn corners(&self, face: FaceId) -> Vec<(&'static str, String)> {
        let vertices = self.mesh.faces().face_vertices(face);
        let numbers = vertices.iter().map(|&vertex| self.vertices.number(vertex).to_string());
        NAMES.into_iter().zip(numbers).collect()
    }

    /// The row of a triangle with its new vertices, and its properties where its corners are other ones.
    fn changed(&self, row: &str, face: FaceId, number: u32, is_again: bool) -> (String, Stretched) {
        let mut values = self.corners(face);
        let places = self.places(face, FaceId(number));
        let created = places.iter().filter(|place| place.is_none()).count();
        let mut stretched = Stretched::default();
        let members = MEMBERS.map(|name| value(row, name));
        if let [Some(first), second, third] = members
            && (second.is_some() || third.is_some())
        {
            let old = [first, second.unwrap_or(first), third.unwrap_or(first)];
            let corners: Vec<CornerId> = self.mesh.faces().face_corners(face).collect();
            let new: Vec<&str> = places
                .iter()
                .zip(corners)
                .map(|(place, corner)| old[place.unwrap_or_else(|| self.nearest(corner, FaceId(number)))])
                .collect();
            if new != old {
                let new = new.iter().map(|value| (*value).to_owned());
                values.extend(MEMBERS.into_iter().zip(new));
            }
            let is_uniform = old.iter().all(|value| *value == first);
            stretched.copied = if is_uniform { 0 } else { created };
        }
        let is_part = is_again || created > 0;
        stretched.cut = usize::from(is_part && attributes_of(row).any(|attribute| !is_known(attribute.name)));
        (with_values(row, &values), stretched)
    }

    /// For each corner which corner of an old triangle it is.
    fn places(&self, face: FaceId, old: FaceId) -> [Option<usize>; 3] {
        let mut is_taken = [false; 3];
        let vertices = self.old_vertices(old);
        let mut places = [None; 3];
        for (slot, corner) in places.iter_mut().zip(self.mesh.faces().face_corners(face)) {
            let Some(row) = self.sources.corner(corner) else { continue };
            let place =
                vertices.iter().zip(is_taken).position(|(&vertex, is_taken)| vertex == row && !is_taken);
            if let Some(place) = place {
                is_taken[place] = true;
                *slot = Some(place);
            }
        }
        places
    }

    fn old_vertices(&self, old: FaceId) -> Vec<u32> {
        let faces: &FaceTable = self.before.faces();
        let is_there = old.index() < faces.face_count();
        let vertices = if is_there { faces.face_vertices(old) } else { &[] };
        vertices.iter().map(|vertex| vertex.0).collect()
    }

    /// Which corner of an old triangle is nearest to a created one.
    fn nearest(&self, corner: CornerId, old: FaceId) -> usize {
        let [x, y, z] = self.mesh.position(self.mesh.faces().corner_vertex(corner));
        let distance = |vertex: &u32| {
            let position = self.before.positions().get(*vertex as usize).copied();
            let [a, b, c] = position.unwrap_or([f64::INFINITY; 3]);
            (a - x).powi(2) + (b - y).powi(2) + (c - z).powi(2)
        };
        let distances: Vec<f64> = self.old_vertices(old).iter().map(distance).collect();
        let nearest = distances.iter().enumerate().min_by(|one, other| one.1.total_cmp(other.1));
        nearest.map_or(0, |(place, _)| place)
    }
}

fn is_known(name: &str) -> bool {
    name == "pid" || NAMES.contains(&name) || MEMBERS.contains(&name)
}
