//! The elements in the order of the file: object by object, in each of them material by material, and each object with
//! vertices of its own.
//!
//! Loose edges and points belong to the only object if there is one. Else they are a mesh of their own, which is the
//! first one.

use std::collections::BTreeMap;

use meshmend_core::{CornerId, Draft, FaceId, FaceTable, Id, Loose, PolygonMesh, Sources, VertexId, counted};

use super::objects::{FaceNames, Key};
use crate::text::one_or_many;
use crate::{Loss, LossKind, Prepared, WriteErrorKind};

/// Puts the elements in order, and leaves out what the format can't hold: faces of fewer than three corners, elements
/// with coordinates that are not finite, and vertices that no element uses, unless there is no element at all.
///
/// *Cost*: linear where all is in order; else n log n.
pub(super) fn arrange(prepared: &mut Prepared) -> Result<(), WriteErrorKind> {
    let mesh = prepared.mesh.clone();
    let kept = Kept::of(&mesh);
    prepared.losses.extend(kept.losses());
    let order = Order::of(&mesh, &kept);
    prepared.losses.extend(order.losses(&mesh));
    if !order.is_as_it_was(&mesh) || kept.drops_loose() {
        let (arranged, record) = mesh.rebuild(order.draft(&mesh, &kept)?)?;
        prepared.become_mesh(arranged, record);
    }
    Ok(())
}

/// The elements that the format can hold.
struct Kept {
    faces: Vec<FaceId>,
    drop_loose: Loose,
    short: usize,
    not_finite: usize,
    loose_edges: usize,
    loose_points: usize,
}

impl Kept {
    fn of(mesh: &PolygonMesh) -> Self {
        let (mut short, mut not_finite) = (0, 0);
        let is_kept = |&face: &FaceId| {
            let vertices = mesh.faces().face_vertices(face);
            let is_short = vertices.len() < 3;
            let is_finite = vertices.iter().all(|&vertex| mesh.is_finite(vertex));
            short += usize::from(is_short);
            not_finite += usize::from(!is_short && !is_finite);
            !is_short && is_finite
        };
        let faces = mesh.faces().faces().filter(is_kept).collect();
        let edges = mesh.loose_edges().iter().flatten().all(|&vertex| mesh.is_finite(vertex));
        let points = mesh.loose_points().iter().all(|&vertex| mesh.is_finite(vertex));
        let count = |are_kept: bool, count: usize| if are_kept { 0 } else { count };
        Kept {
            faces,
            drop_loose: Loose { edges: !edges, points: !points },
            short,
            not_finite,
            loose_edges: count(edges, mesh.loose_edges().len()),
            loose_points: count(points, mesh.loose_points().len()),
        }
    }

    fn drops_loose(&self) -> bool {
        self.drop_loose != Loose::default()
    }

    fn losses(&self) -> impl Iterator<Item = Loss> {
        const WHY: &str = "as a coordinate is not finite in single precision";
        let of_kind = |kind, count, what: &'static str| {
            Loss::if_any(kind, count, |count| format!("{}, {WHY}", counted(count, what)))
        };
        let losses = [
            Loss::if_any(LossKind::ShortFaces, self.short, |n| {
                format!("{} of fewer than three corners", counted(n, "face"))
            }),
            of_kind(LossKind::NonFiniteFaces, self.not_finite, "face"),
            of_kind(LossKind::LooseEdges, self.loose_edges, "loose edge"),
            of_kind(LossKind::LoosePoints, self.loose_points, "loose point"),
        ];
        losses.into_iter().flatten()
    }
}

/// The order of the file.
struct Order {
    /// The old faces.
    faces: Vec<FaceId>,
    /// The old vertices; those of several objects are there for each.
    vertices: Vec<VertexId>,
    /// For each new face the number of the first vertex of its object, and how many faces have it.
    objects: Vec<Object>,
}

/// The part of an order that one object has.
struct Object {
    faces: usize,
    vertices: std::ops::Range<usize>,
}

impl Order {
    fn of(mesh: &PolygonMesh, kept: &Kept) -> Self {
        let (faces, counts) = sorted(mesh, &kept.faces);
        let mut order = Order { faces, vertices: Vec::new(), objects: Vec::new() };
        let mut taken = Taken::new(mesh.counts().vertices);
        let loose = || {
            let edges = mesh.loose_edges().iter().flatten().filter(|_| !kept.drop_loose.edges);
            edges.chain(mesh.loose_points().iter().filter(|_| !kept.drop_loose.points)).copied()
        };
        if counts.len() != 1 {
            loose().for_each(|vertex| taken.take(vertex));
            order.add(0, taken.in_order());
        }
        let mut first = 0;
        for &count in &counts {
            let faces = &order.faces[first..first + count];
            let corners = faces.iter().flat_map(|&face| mesh.faces().face_vertices(face));
            corners.for_each(|&vertex| taken.take(vertex));
            if counts.len() == 1 {
                loose().for_each(|vertex| taken.take(vertex));
            }
            order.add(count, taken.in_order());
            first += count;
        }
        let is_cloud = mesh.faces().face_count() == 0 && order.vertices.is_empty();
        if is_cloud {
            let vertices = (0..mesh.counts().vertices).map(VertexId::new);
            order.vertices = vertices.filter(|&vertex| mesh.is_finite(vertex)).collect();
        }
        order
    }

    fn add(&mut self, faces: usize, vertices: Vec<VertexId>) {
        let first = self.vertices.len();
        self.vertices.extend(vertices);
        self.objects.push(Object { faces, vertices: first..self.vertices.len() });
    }

    fn is_as_it_was(&self, mesh: &PolygonMesh) -> bool {
        let (faces, vertices) = (mesh.counts().faces, mesh.counts().vertices);
        self.faces.len() == faces
            && self.vertices.len() == vertices
            && self.faces.iter().zip(0..).all(|(face, at)| face.index() == at)
            && self.vertices.iter().zip(0..).all(|(vertex, at)| vertex.index() == at)
    }

    fn losses(&self, mesh: &PolygonMesh) -> impl Iterator<Item = Loss> {
        let mut times = vec![0_u32; mesh.counts().vertices];
        self.vertices.iter().for_each(|vertex| times[vertex.index()] += 1);
        let unused = times.iter().filter(|&&times| times == 0).count();
        let several = times.iter().filter(|&&times| times > 1);
        let (shared, written) = (several.clone().count(), several.sum::<u32>());
        let losses = [
            Loss::if_any(LossKind::UnusedVertices, unused, |n| {
                format!("{} that no written element uses", counted(n, "vertex"))
            }),
            Loss::if_any(LossKind::SeamVertices, shared, |n| {
                let vertices = one_or_many(n, "vertex is", "vertices are");
                let them = if n == 1 { "it" } else { "them" };
                format!(
                    "{vertices} written {written} times, as several objects use {them}: the file is manifold by place, \
                     not by index"
                )
            }),
        ];
        losses.into_iter().flatten()
    }

    fn draft(&self, mesh: &PolygonMesh, kept: &Kept) -> Result<Draft, WriteErrorKind> {
        let mut place = vec![0; mesh.counts().vertices];
        let (mut corners, mut sources) = (Vec::new(), Vec::new());
        let mut faces = self.faces.iter();
        for object in &self.objects {
            let vertices = object.vertices.clone().zip(&self.vertices[object.vertices.clone()]);
            vertices.for_each(|(new, old)| place[old.index()] = new);
            for face in faces.by_ref().take(object.faces) {
                for corner in mesh.faces().face_corners(*face) {
                    corners.push(VertexId::new(place[mesh.faces().corner_vertex(corner).index()]));
                    sources.push(corner);
                }
            }
        }
        let table =
            FaceTable::triangles(self.vertices.len(), corners).map_err(meshmend_core::DraftError::from)?;
        let corner_sources: Sources<CornerId> = sources.into();
        let draft = Draft::of_faces(mesh, table, self.faces.clone().into(), corner_sources);
        Ok(Draft { vertex_sources: self.vertices.clone().into(), drop_loose: kept.drop_loose, ..draft })
    }
}

/// Faces object by object and material by material, in the order in which those come first, and how many faces each
/// object has.
fn sorted(mesh: &PolygonMesh, faces: &[FaceId]) -> (Vec<FaceId>, Vec<usize>) {
    let names = FaceNames::of(mesh);
    if names.are_absent() || faces.is_empty() {
        return (faces.to_vec(), if faces.is_empty() { Vec::new() } else { vec![faces.len()] });
    }
    let (mut objects, mut materials) = (Ranks::default(), Ranks::default());
    let rank = |&face: &FaceId| {
        let (object, material): Key = names.key(face.index());
        (objects.rank(object), materials.rank(material), face)
    };
    let mut ranked: Vec<(usize, usize, FaceId)> = faces.iter().map(rank).collect();
    ranked.sort_unstable();
    let counts = ranked.chunk_by(|a, b| a.0 == b.0).map(<[_]>::len).collect();
    (ranked.into_iter().map(|(_, _, face)| face).collect(), counts)
}

/// The order in which values come first.
#[derive(Default)]
struct Ranks(BTreeMap<Option<usize>, usize>);

impl Ranks {
    fn rank(&mut self, value: Option<usize>) -> usize {
        let next = self.0.len();
        *self.0.entry(value).or_insert(next)
    }
}

/// A set of vertices that is emptied again and again.
struct Taken {
    /// The round in which each vertex was taken last.
    rounds: Vec<u32>,
    round: u32,
    vertices: Vec<VertexId>,
}

impl Taken {
    fn new(count: usize) -> Self {
        Taken { rounds: vec![0; count], round: 1, vertices: Vec::new() }
    }

    fn take(&mut self, vertex: VertexId) {
        if self.rounds[vertex.index()] != self.round {
            self.rounds[vertex.index()] = self.round;
            self.vertices.push(vertex);
        }
    }

    /// The vertices that were taken, ascending. The set is empty then.
    fn in_order(&mut self) -> Vec<VertexId> {
        self.round += 1;
        self.vertices.sort_unstable();
        std::mem::take(&mut self.vertices)
    }
}
