//! Components that repeat others once some are turned.

use meshmend_core::{Defect, FaceId, Id, PolygonMesh, VertexId, canonical_rotation};
use meshmend_geometry::coincident::coincident_vertices;
use meshmend_spatial::Nesting;

use crate::Context;
use crate::telling::{Looks, Telling};

/// The faces of components each of whose faces repeats, by position and direction, one of another component that stays, where
/// one of the two was turned and no layer tells the faces apart. Of components that repeat each other the one with the
/// lowest face stays.
///
/// *Cost*: constant if none is turned; else linear, and O(n log n) in the faces all of whose corners have others at
/// their places.
pub(super) fn repeated_components(
    mesh: &PolygonMesh,
    context: &Context<'_>,
    nesting: &Nesting,
    turns: &[bool],
) -> Vec<Defect> {
    if !turns.contains(&true) {
        return Vec::new();
    }
    let cycles = Cycles::of(mesh, nesting, turns);
    let telling = Telling::of(mesh, context.telling);
    let mut is_gone = vec![false; turns.len()];
    let mut gone = Vec::new();
    for part in (0..turns.len()).rev().filter(|&part| cycles.are_all_shared(nesting, part)) {
        let may_be_it = |other: usize| other != part && !is_gone[other] && (turns[part] || turns[other]);
        let repeated = cycles.others_of(part).into_iter().filter(|&other| may_be_it(other));
        let mut originals =
            repeated.filter_map(|other| cycles.originals(mesh, telling.as_ref(), part, other));
        if let Some(originals) = originals.next() {
            is_gone[part] = true;
            gone.extend(originals.into_iter().map(|(face, original)| Defect::duplicate_face(face, original)));
        }
    }
    gone
}

/// The faces that run round the same places in the same direction as others do.
struct Cycles {
    /// The faces of each component that share their cycle with others, each with its class.
    of_part: Vec<Vec<(FaceId, u32)>>,
    /// The faces of each class with their components, ascending by component.
    classes: Vec<Vec<(usize, FaceId)>>,
    /// The places of vertices: the lowest one at each.
    lowest: Vec<VertexId>,
}

impl Cycles {
    fn of(mesh: &PolygonMesh, nesting: &Nesting, turns: &[bool]) -> Self {
        let lowest = coincident_vertices(mesh);
        let mut is_shared = vec![false; lowest.len()];
        for (vertex, low) in lowest.iter().enumerate().filter(|(vertex, low)| low.index() != *vertex) {
            (is_shared[vertex], is_shared[low.index()]) = (true, true);
        }
        let faces = mesh.complex().faces();
        let mut rows: Vec<(Vec<VertexId>, usize, FaceId)> = Vec::new();
        for face in faces.faces() {
            let Some(part) = nesting.component_of(face) else { continue };
            let vertices = faces.face_vertices(face);
            if vertices.iter().all(|vertex| is_shared[vertex.index()]) {
                let mut cycle: Vec<VertexId> = vertices.iter().map(|v| lowest[v.index()]).collect();
                if turns[part] {
                    cycle.reverse();
                }
                let first = canonical_rotation(&cycle);
                cycle.rotate_left(first);
                rows.push((cycle, part, face));
            }
        }
        rows.sort_unstable();
        let mut cycles = Cycles { of_part: vec![Vec::new(); turns.len()], classes: Vec::new(), lowest };
        for class in rows.chunk_by(|one, other| one.0 == other.0).filter(|class| class.len() > 1) {
            for &(_, part, face) in class {
                cycles.of_part[part].push((face, cycles.classes.len() as u32));
            }
            cycles.classes.push(class.iter().map(|&(_, part, face)| (part, face)).collect());
        }
        cycles
    }

    /// Whether all faces of a component share their cycles with others.
    fn are_all_shared(&self, nesting: &Nesting, part: usize) -> bool {
        self.of_part[part].len() == nesting.components[part].faces as usize
    }

    /// The components that share the cycle of one of a component's faces, ascending.
    fn others_of(&self, part: usize) -> Vec<usize> {
        let classes = self.of_part[part].iter().map(|&(_, class)| &self.classes[class as usize]);
        let rarest = classes.min_by_key(|class| class.len());
        let mut others: Vec<usize> = rarest.into_iter().flatten().map(|&(part, _)| part).collect();
        others.dedup();
        others
    }

    /// For each face of a component the one of another that it repeats; `None` if there is a face that repeats none.
    fn originals(
        &self,
        mesh: &PolygonMesh,
        telling: Option<&Telling<'_>>,
        part: usize,
        other: usize,
    ) -> Option<Vec<(FaceId, FaceId)>> {
        let original = |&(face, class): &(FaceId, u32)| {
            let class = &self.classes[class as usize];
            let first = class.partition_point(|&(part, _)| part < other);
            let mut of_other = class[first..].iter().take_while(|&&(part, _)| part == other);
            let is_alike = |&&(_, original): &&(usize, FaceId)| {
                telling.is_none_or(|telling| {
                    telling.differences(&self.looks(mesh, face), &self.looks(mesh, original)).is_empty()
                })
            };
            of_other.find(is_alike).map(|&(_, original)| (face, original))
        };
        self.of_part[part].iter().map(original).collect()
    }

    /// A face as it is compared, its corners known by their places.
    fn looks(&self, mesh: &PolygonMesh, face: FaceId) -> Looks {
        let complex = mesh.complex();
        let faces = complex.faces();
        let corners = faces
            .face_corners(face)
            .map(|corner| (self.lowest[faces.corner_vertex(corner).index()], complex.stored_corner(corner)));
        Looks::new(face, corners.collect())
    }
}
