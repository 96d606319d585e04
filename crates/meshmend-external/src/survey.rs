//! The parts of a mesh, looked at one after the other: edges, vertices, repeated faces, and what joins faces into patches.

use meshmend_core::{
    Connectivity, CornerId, Defect, EdgeId, FaceId, Id, VertexClass, VertexId, Watch, vertex_classes_in,
};
use meshmend_topology::{AlikeFace, Likeness, alike_faces, repeats};

use crate::budget::{Budget, FaceBudget};
use crate::components::Tally;
use crate::error::ExternalError;
use crate::face_parts::FaceParts;
use crate::faces::NO_COMPONENT;
use crate::lists::Lists;
use crate::part::Part;
use crate::sides::PatchSides;
use crate::spill::Spill;

/// What is gathered from the parts.
pub(crate) struct Survey<'a> {
    pub(crate) budget: &'a Budget<'a>,
    pub(crate) faces: FaceBudget,
    pub(crate) watch: &'a Watch,
    pub(crate) lists: &'a mut Lists,
    pub(crate) sides: PatchSides,
    pub(crate) tally: Tally,
    /// How many vertices some face uses.
    pub(crate) vertices: u64,
    /// How many edges there are.
    pub(crate) edges: u64,
    /// The uses of each edge of degree 3 or more: how many, and of each the face, doubled, plus one where it runs from the lower to
    /// the higher vertex.
    pub(crate) branches: Spill,
    /// The ends of each edge of degree 1, and the component, by ascending edge.
    pub(crate) boundary: Spill,
    /// How many bytes were written for parts that were put in parts again.
    pub(crate) written: u64,
}

impl Survey<'_> {
    /// Looks at all parts. Returns the number of the first edge of each.
    pub(crate) fn all(&mut self, parts: &FaceParts, labels: &Spill) -> Result<Vec<u64>, ExternalError> {
        let count = parts.spill.part_count();
        let (budget, faces_a_part, mut first_edges) = (self.budget, self.faces.faces_a_part, Vec::new());
        for part in 0..count {
            self.watch.look("topology", part, count)?;
            first_edges.push(self.edges);
            let (labels, start) = (labels.load(part)?, parts.range(part).0);
            self.written += parts.look_at(part, (budget, faces_a_part), &mut |part| {
                let [first, end] = part.range().map(|vertex| (vertex - start) as usize);
                self.look_at(part, &labels[first..end])
            })?;
        }
        Ok(first_edges)
    }

    fn look_at(&mut self, part: &Part, labels: &[u32]) -> Result<(), ExternalError> {
        let lowest = self.lowest_of_faces(part);
        self.repeated_faces(part);
        let classes = vertex_classes_in(&part.kernel, part.own());
        let mut edges = part.own_edges().peekable();
        for (((here, class), &label), faces) in
            part.own().map(VertexId::new).zip(classes).zip(labels).zip(lowest)
        {
            let vertex = part.vertex(here);
            if label == NO_COMPONENT {
                self.lists.add(Defect::unreferenced_vertex(vertex));
                continue;
            }
            self.vertices += 1;
            let facts = self.tally.at(label, vertex)?;
            facts.vertices += 1;
            facts.faces += faces;
            facts.is_manifold &= class.is_manifold();
            match class {
                VertexClass::Pinched { umbrellas, boundary_only } => {
                    self.lists.add(Defect::pinched_vertex(vertex, umbrellas, boundary_only));
                }
                VertexClass::Singular => self.lists.add(Defect::singular_vertex(vertex)),
                _ => {}
            }
            while let Some(edge) = edges.next_if(|&edge| part.kernel.edge_ends(edge)[0] == here) {
                self.edge(part, edge, label)?;
            }
        }
        Ok(())
    }

    /// How many faces have each vertex of the range as their lowest.
    fn lowest_of_faces(&self, part: &Part) -> Vec<u32> {
        let own = part.own();
        let mut count = vec![0; own.len()];
        for face in part.kernel.faces() {
            let lowest = part.kernel.face_vertices(face).min();
            if let Some(lowest) = lowest.filter(|lowest| own.contains(&lowest.index())) {
                count[lowest.index() - own.start] += 1;
            }
        }
        count
    }

    /// Lists the faces that repeat another one and whose lowest vertex is in the range.
    fn repeated_faces(&mut self, part: &Part) {
        let own = part.own();
        let lowest = |alike: &AlikeFace| part.kernel.face_vertices(alike.face).min().map(Id::index);
        for group in alike_faces(&part.kernel) {
            if !group.first().and_then(lowest).is_some_and(|lowest| own.contains(&lowest)) {
                continue;
            }
            for repeat in repeats(&group) {
                let (face, original) = (part.face(repeat.face), part.face(repeat.original));
                self.lists.add(match repeat.likeness {
                    Likeness::Same => Defect::duplicate_face(face, original),
                    Likeness::Opposite => Defect::opposite_face(face, original),
                });
            }
        }
    }

    /// Looks at an edge of a component.
    fn edge(&mut self, part: &Part, edge: EdgeId, label: u32) -> Result<(), ExternalError> {
        let ends = part.kernel.edge_ends(edge).map(|end| part.vertex(end));
        // There are no more edges than corners, which are fewer than 2³².
        let number = EdgeId(self.edges as u32);
        self.edges += 1;
        let face = |corner: CornerId| part.face(part.kernel.corner_face(corner));
        let facts = self.tally.at(label, ends[0])?;
        facts.edges += 1;
        let mut uses = part.kernel.edge_sides(edge);
        match (uses.next(), uses.next(), uses.next()) {
            (Some((one, _)), None, _) => {
                facts.is_closed = false;
                self.sides.open(face(one).0);
                self.boundary.push(0, &[ends[0].0, ends[1].0, label])?;
                self.lists.add(Defect::boundary_edge(number, ends));
            }
            (Some((one, way)), Some((other, back)), None) => {
                if way == back {
                    self.lists.add(Defect::inconsistent_edge(number, ends));
                }
                facts.is_orientable &= !self.sides.join(face(one).0, face(other).0, way == back);
            }
            _ => {
                facts.is_manifold = false;
                let degree = part.kernel.edge_degree(edge) as u32;
                self.lists.add(Defect::non_manifold_edge(number, ends, degree));
                self.branches.push(0, &[degree])?;
                for (corner, _) in part.kernel.edge_sides(edge) {
                    let FaceId(face) = face(corner);
                    self.branches.push(0, &[face << 1 | u32::from(part.kernel.is_forward(corner))])?;
                }
            }
        }
        Ok(())
    }
}
