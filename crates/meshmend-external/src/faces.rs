//! The faces of a file: each is looked at alone, joined to its component, and put in the parts of its vertices.

use std::path::Path;

use fixedbitset::FixedBitSet;
use meshmend_core::{Cancelled, Classes, Defect, FaceId, VertexId, normalised};
use meshmend_io::{ReadOptions, Streamed};
use meshmend_topology::FaceShapes;

use crate::budget::{Budget, FaceBudget};
use crate::error::ExternalError;
use crate::face_parts::FaceParts;
use crate::lists::Lists;
use crate::places::{Places, VertexMap};
use crate::ranked::RankedSet;
use crate::sinks::{Rows, read_rows};
use crate::spill::Spill;

/// The faces of a mesh in parts, and its components.
pub(crate) struct Faces {
    /// What there is to say about the file.
    pub(crate) streamed: Streamed,
    pub(crate) parts: FaceParts,
    /// How many faces are proper.
    pub(crate) proper: u64,
    /// How many components there are.
    pub(crate) components: u32,
    /// The component of each vertex, in the same parts; `NO_COMPONENT` for an unreferenced one.
    pub(crate) labels: Spill,
}

/// Stands for the component of a vertex that no face uses.
pub(crate) const NO_COMPONENT: u32 = u32::MAX;

/// Reads the faces of a file into parts.
pub(crate) fn faces(
    path: &Path,
    read: &ReadOptions,
    places: &mut Places,
    (budget, for_faces): (&Budget<'_>, FaceBudget),
    lists: &mut Lists,
) -> Result<Faces, ExternalError> {
    let count = places.vertex_count as usize;
    let mut sink = FaceSink {
        vertices: &mut places.vertices,
        infinite: places.infinite.as_ref(),
        components: Classes::new(count),
        is_referenced: FixedBitSet::with_capacity(count),
        parts: FaceParts::new(budget, for_faces.parts, places.vertex_count)?,
        lists,
        shapes: FaceShapes::default(),
        next: 0,
        proper: 0,
        face: Vec::new(),
        normal: Vec::new(),
    };
    let streamed = read_rows(path, read, &mut sink)?.ok_or(Cancelled)?;
    let FaceSink { mut components, is_referenced, parts, proper, .. } = sink;
    let mut labels = budget.spill(parts.spill.part_count())?;
    let components = number(&mut components, &is_referenced, |vertex, label| {
        labels.push(parts.part_of(vertex), &[label])
    })?;
    Ok(Faces { streamed, parts, proper, components, labels })
}

/// Numbers the components by lowest vertex, and hands over that of each vertex.
fn number(
    components: &mut Classes,
    is_referenced: &FixedBitSet,
    mut take: impl FnMut(u32, u32) -> Result<(), ExternalError>,
) -> Result<u32, ExternalError> {
    let vertices = || 0..is_referenced.len() as u32;
    let mut roots = RankedSet::new(is_referenced.len());
    for vertex in vertices().filter(|&vertex| is_referenced.contains(vertex as usize)) {
        // The root of a class is its lowest vertex.
        if components.root(vertex) == vertex {
            roots.insert(vertex);
        }
    }
    let (roots, count) = roots.ranked();
    for vertex in vertices() {
        let is_referenced = is_referenced.contains(vertex as usize);
        let label = if is_referenced { roots.rank(components.root(vertex)) } else { NO_COMPONENT };
        take(vertex, label)?;
    }
    Ok(count)
}

struct FaceSink<'a> {
    vertices: &'a mut VertexMap,
    infinite: Option<&'a FixedBitSet>,
    components: Classes,
    is_referenced: FixedBitSet,
    parts: FaceParts,
    lists: &'a mut Lists,
    shapes: FaceShapes,
    next: u32,
    proper: u64,
    /// The face by vertices of the view, and in normal form.
    face: Vec<VertexId>,
    normal: Vec<VertexId>,
}

impl Rows for FaceSink<'_> {
    #[inline]
    fn take_face(&mut self, stored: &[VertexId]) -> Result<(), ExternalError> {
        let face = self.next;
        self.next += 1;
        self.face.clear();
        for vertex in stored {
            self.face.push(VertexId(self.vertices.vertex(vertex.0)?));
        }
        if let Some(infinite) = self.infinite
            && let Some(&vertex) = self.face.iter().find(|vertex| infinite.contains(vertex.0 as usize))
        {
            self.lists.add(Defect::non_finite_face(FaceId(face), vertex));
        }
        if !normalised(&self.face, &mut self.normal) {
            self.lists.add(Defect::degenerate_face(FaceId(face)));
            return Ok(());
        }
        self.proper += 1;
        if self.face.len() > 3 {
            self.look_at_polygon(FaceId(face));
        }
        let first = self.normal[0];
        for &vertex in &self.normal {
            self.components.join(first.0, vertex.0);
            self.is_referenced.insert(vertex.0 as usize);
        }
        self.parts.push(face, &self.normal)
    }
}

impl FaceSink<'_> {
    #[cold]
    fn look_at_polygon(&mut self, face: FaceId) {
        if self.normal.len() > 3 {
            self.lists.add(Defect::polygon_face(face, self.normal.len() as u32));
            if let Some(vertex) = self.shapes.recurring(&self.normal) {
                self.lists.add(Defect::non_simple_face(face, vertex));
            }
        }
        if let Some(vertex) = FaceShapes::repeated(&self.face, &self.normal) {
            self.lists.add(Defect::repeated_corner(face, vertex));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn components_are_numbered_by_lowest_vertex() {
        let mut classes = Classes::new(7);
        [(5, 2), (2, 4), (6, 1)].into_iter().for_each(|(one, other)| {
            classes.join(one, other);
        });
        let mut is_referenced = FixedBitSet::with_capacity(7);
        [1, 2, 4, 5, 6].into_iter().for_each(|vertex| is_referenced.insert(vertex));
        let mut labels = Vec::new();
        let count = number(&mut classes, &is_referenced, |vertex, label| {
            labels.push((vertex, label));
            Ok(())
        });
        assert_eq!(count.unwrap(), 2);
        let none = NO_COMPONENT;
        assert_eq!(labels, [(0, none), (1, 0), (2, 1), (3, none), (4, 1), (5, 1), (6, 0)]);
    }
}
