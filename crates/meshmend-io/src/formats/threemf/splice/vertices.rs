//! Which vertices an object has after a change, and their rows.

use meshmend_core::{CornerId, Domain, FaceTable, Id, Layer, PolygonMesh, Role, Values, VertexId};

use super::rows::{Rows, with_values};
use crate::formats::threemf::parts::ROW;
use crate::output::sink::number_text;

/// The rows from which the elements of a mesh come.
pub(super) struct Sources<'m> {
    faces: &'m FaceTable,
    vertices: Option<(&'m Layer, &'m [u32])>,
    triangles: Option<(&'m Layer, &'m [u32])>,
}

impl<'m> Sources<'m> {
    pub(super) fn of(mesh: &'m PolygonMesh) -> Self {
        let layer = |home: Domain| {
            let is_wanted = |layer: &&Layer| {
                layer.name() == ROW && layer.role() == Role::Identity && layer.home() == home
            };
            let layer = mesh.layers().iter().find(is_wanted)?;
            if let Values::U32(rows) = layer.values() { Some((layer, rows.as_slice())) } else { None }
        };
        Sources { faces: mesh.faces(), vertices: layer(Domain::Vertex), triangles: layer(Domain::Face) }
    }

    /// The row of a vertex.
    pub(super) fn vertex(&self, vertex: VertexId) -> Option<u32> {
        let (layer, rows) = self.vertices?;
        rows.get(layer.value_of_vertex(vertex.index())?).copied()
    }

    /// The row of the vertex that a corner had.
    pub(super) fn corner(&self, corner: CornerId) -> Option<u32> {
        let (layer, rows) = self.vertices?;
        let element = match layer.domain() {
            Domain::Corner => corner.index(),
            _ => self.faces.corner_vertex(corner).index(),
        };
        rows.get(layer.value_of(element)?).copied()
    }

    /// The row of a triangle.
    pub(super) fn triangle(&self, face: usize) -> Option<u32> {
        let (layer, rows) = self.triangles?;
        rows.get(layer.value_of(face)?).copied()
    }
}

/// The vertices that an object will have, in order.
pub(super) struct Vertices {
    list: Vec<Vertex>,
    /// For each vertex of the mesh its number in the object.
    numbers: Vec<u32>,
    /// For each old row the number of the vertex that it is now.
    of_rows: Vec<Option<u32>>,
}

enum Vertex {
    /// One of the mesh, with the row that it comes from.
    OfMesh(VertexId, Option<u32>),
    /// A row that is not in the mesh any more, and that something else needs.
    Needed(u32),
}

impl Vertices {
    /// The vertices of a mesh, and of rows that are needed beside them, which keep their places among the others.
    pub(super) fn of(mesh: &PolygonMesh, sources: &Sources<'_>, is_needed: &[bool]) -> Self {
        let vertices = mesh.counts().vertices;
        let mut found = Vertices {
            list: Vec::with_capacity(vertices),
            numbers: vec![0; vertices],
            of_rows: vec![None; is_needed.len()],
        };
        let mut is_there = vec![false; is_needed.len()];
        let rows = (0..vertices).filter_map(|vertex| sources.vertex(VertexId::new(vertex)));
        let of_corners = mesh.faces().corners().filter_map(|corner| sources.corner(corner));
        rows.chain(of_corners).for_each(|row| mark(&mut is_there, row));
        let mut needed = (0..is_needed.len()).filter(|&row| is_needed[row] && !is_there[row]).peekable();
        for vertex in (0..vertices).map(VertexId::new) {
            let row = sources.vertex(vertex);
            let before = row.map_or(usize::MAX, |row| row as usize);
            while let Some(row) = needed.next_if(|&row| row < before) {
                found.push(Vertex::Needed(row as u32), Some(row as u32));
            }
            found.numbers[vertex.index()] = found.list.len() as u32;
            found.push(Vertex::OfMesh(vertex, row), row);
        }
        for row in needed {
            found.push(Vertex::Needed(row as u32), Some(row as u32));
        }
        for corner in mesh.faces().corners() {
            let number = found.numbers[mesh.faces().corner_vertex(corner).index()];
            found.note(sources.corner(corner), number);
        }
        found
    }

    fn push(&mut self, vertex: Vertex, row: Option<u32>) {
        self.note(row, self.list.len() as u32);
        self.list.push(vertex);
    }

    fn note(&mut self, row: Option<u32>, number: u32) {
        if let Some(slot) = row.and_then(|row| self.of_rows.get_mut(row as usize)) {
            slot.get_or_insert(number);
        }
    }

    /// The number of a vertex of the mesh.
    pub(super) fn number(&self, vertex: VertexId) -> u32 {
        self.numbers[vertex.index()]
    }

    /// The number of the vertex that an old row is now.
    pub(super) fn of_row(&self, row: u32) -> Option<u32> {
        self.of_rows.get(row as usize).copied().flatten()
    }

    /// How many rows are kept that are not in the mesh.
    pub(super) fn needed(&self) -> usize {
        self.list.iter().filter(|vertex| matches!(vertex, Vertex::Needed(_))).count()
    }

    /// The rows of all vertices. `before` is the mesh that the old rows say.
    pub(super) fn text(&self, rows: &Rows<'_>, mesh: &PolygonMesh, before: &PolygonMesh) -> String {
        let mut text = String::new();
        let mut is_copied = vec![false; rows.len()];
        let mut last = 0;
        for vertex in &self.list {
            let (row, moved) = match *vertex {
                Vertex::Needed(row) => (Some(row), None),
                Vertex::OfMesh(vertex, row) => {
                    let position = mesh.position(vertex);
                    let as_before = row.and_then(|row| before.positions().get(row as usize));
                    let is_same =
                        as_before.is_some_and(|old| old.map(f64::to_bits) == position.map(f64::to_bits));
                    (row, (!is_same).then_some(position))
                }
            };
            let source = row.and_then(|row| Some((row, rows.row(row)?)));
            if let Some((number, _)) = source {
                last = number;
                let is_again =
                    is_copied.get_mut(number as usize).is_some_and(|slot| std::mem::replace(slot, true));
                text.push_str(if is_again { rows.blank_gap(number) } else { rows.gap(number) });
            } else {
                text.push_str(rows.blank_gap(last));
            }
            match (source, moved) {
                (Some((_, row)), None) => text.push_str(row),
                (Some((_, row)), Some(position)) => text.push_str(&with_values(row, &coordinates(position))),
                (None, position) => {
                    let empty = format!("<{}/>", rows.name("vertex"));
                    text.push_str(&with_values(&empty, &coordinates(position.unwrap_or_default())));
                }
            }
        }
        text + rows.rest()
    }
}

fn mark(flags: &mut [bool], row: u32) {
    if let Some(flag) = flags.get_mut(row as usize) {
        *flag = true;
    }
}

fn coordinates(position: [f64; 3]) -> [(&'static str, String); 3] {
    let [x, y, z] = position.map(number_text);
    [("x", x), ("y", y), ("z", z)]
}
