//! The faces and vertices that lists name, with all that is round them, as a mesh in memory.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use fixedbitset::FixedBitSet;
use meshmend_core::{
    Connectivity, Defect, EdgeId, EdgeUse, Element, FaceId, FaceTableBuilder, Id, PolygonMesh, VertexId,
};
use meshmend_io::ReadOptions;
use meshmend_topology::{orientability, patches};

use crate::error::ExternalError;
use crate::part::first_not;
use crate::places::VertexMap;
use crate::sinks::{Rows, read_rows};

/// A part of a mesh: some faces in the same order, and some vertices in the same order.
#[derive(Debug)]
pub struct Excerpt {
    /// The mesh of these faces.
    pub mesh: PolygonMesh,
    /// The vertex of the view that each vertex is, ascending.
    vertices: Vec<u32>,
    /// The vertex as stored that each vertex is: of those that were joined, the lowest.
    stored: Vec<VertexId>,
    /// The face as stored that each face is, ascending.
    faces: Vec<FaceId>,
    /// The edges of the whole mesh that some edges are.
    edges: BTreeMap<EdgeId, EdgeId>,
}

/// What an excerpt is to hold.
pub(crate) struct Wanted {
    /// Vertices of the view all of whose faces are held.
    pub(crate) round: FixedBitSet,
    /// Other vertices of the view.
    pub(crate) vertices: BTreeSet<u32>,
    /// Faces that are held whatever is round them.
    pub(crate) faces: BTreeSet<u32>,
}

impl Wanted {
    pub(crate) fn nothing(vertices: u32) -> Self {
        let round = FixedBitSet::with_capacity(vertices as usize);
        Wanted { round, vertices: BTreeSet::new(), faces: BTreeSet::new() }
    }

    /// Wants what is listed with a defect.
    pub(crate) fn add(&mut self, defect: &Defect) {
        for element in [Some(&defect.at), defect.beside.as_ref()].into_iter().flatten() {
            match element {
                Element::Vertex(vertex) => {
                    self.round.insert(vertex.index());
                    self.vertices.insert(vertex.0);
                }
                // The faces along an edge are round its ends.
                Element::Edge { ends, .. } => self.round.insert(ends[0].index()),
                Element::LooseEdge { ends, .. } => self.vertices.extend(ends.map(|end| end.0)),
                Element::LoosePoint { vertex, .. } => {
                    self.vertices.insert(vertex.0);
                }
                element => self.faces.extend(element.face().map(|face| face.0)),
            }
        }
    }

    /// Wants all that is round the vertices of some faces.
    pub(crate) fn add_faces(
        &mut self,
        (path, read): (&Path, &ReadOptions),
        map: &mut VertexMap,
        faces: &FixedBitSet,
    ) -> Result<(), ExternalError> {
        let round = &mut self.round;
        each_face((path, read), map, |face, vertices| {
            if faces.contains(face as usize) {
                vertices.iter().for_each(|vertex| round.insert(vertex.index()));
            }
        })
    }
}

impl Excerpt {
    /// What is wanted of the mesh of a file, read twice for it.
    pub(crate) fn of(
        (path, read): (&Path, &ReadOptions),
        map: &mut VertexMap,
        wanted: Wanted,
    ) -> Result<Self, ExternalError> {
        let Wanted { round, vertices: mut all, faces: listed } = wanted;
        let (mut faces, mut held): (Vec<FaceId>, Vec<Vec<VertexId>>) = (Vec::new(), Vec::new());
        each_face((path, read), map, |face, vertices| {
            let is_round = vertices.iter().any(|vertex| round.contains(vertex.index()));
            if is_round || listed.contains(&face) {
                faces.push(FaceId(face));
                held.push(vertices.to_vec());
            }
        })?;
        all.extend(held.iter().flatten().map(|vertex| vertex.0));
        let vertices: Vec<u32> = all.into_iter().collect();
        let stored: Vec<VertexId> = vertices.iter().map(|&vertex| VertexId(map.stored(vertex))).collect();
        let positions = positions((path, read), &stored)?;
        let mut table = FaceTableBuilder::default();
        let here = |vertex: &VertexId| VertexId::new(vertices.partition_point(|&known| known < vertex.0));
        held.iter().for_each(|face| table.push_face(face.iter().map(here)));
        let table = table.build(vertices.len()).map_err(|_| too_much(vertices.len()))?;
        let mesh = PolygonMesh::new(positions, table).map_err(|_| too_much(vertices.len()))?;
        Ok(Excerpt { mesh, vertices, stored, faces, edges: BTreeMap::new() })
    }

    /// A defect of the whole mesh, by the numbers of the excerpt.
    pub(crate) fn of_whole(&mut self, defect: Defect) -> Defect {
        let vertex =
            |vertex: VertexId| VertexId::new(self.vertices.partition_point(|&known| known < vertex.0));
        let face = |face: FaceId| FaceId::new(self.faces.partition_point(|&known| known < face));
        let defect = defect.with_vertices(vertex).with_faces(face);
        let Element::Edge { edge, ends } = defect.at else { return defect };
        let here = self.edge(ends);
        self.edges.insert(here, edge);
        defect.with_edges(|_| here)
    }

    /// The edge of the excerpt with these ends.
    fn edge(&self, ends: [VertexId; 2]) -> EdgeId {
        let edges = self.mesh.complex().edges();
        EdgeId::new(first_not(edges.edge_count(), |edge| edges.ends(EdgeId::new(edge)) < ends))
    }

    /// What shows that the patches with these lowest faces, all of which are held with what is round them, are not orientable.
    pub(crate) fn strips(&self, lowest: &[u32]) -> Vec<Defect> {
        let kernel = EdgeUse::assemble(self.mesh.complex());
        let patches = patches(&kernel);
        let is_wanted = |patch| {
            let first = patches.faces(patch).first();
            first.is_some_and(|face| lowest.binary_search(&self.faces[face.index()].0).is_ok())
        };
        let strips = orientability(&kernel, &patches).one_sided.into_iter();
        strips.filter(|strip| is_wanted(strip.patch)).map(Defect::from).collect()
    }

    /// The ends in the view of the edges that strips cross, ascending.
    pub(crate) fn crossed(&self, strips: &[Defect]) -> BTreeMap<[u32; 2], EdgeId> {
        let strips = strips.iter().filter_map(|defect| match &defect.at {
            Element::Strip(strip) => Some(&strip.edges),
            _ => None,
        });
        let ends =
            |edge: EdgeId| self.mesh.complex().edges().ends(edge).map(|end| self.vertices[end.index()]);
        strips.flatten().map(|&edge| (ends(edge), edge)).collect()
    }

    /// Says which edge of the whole mesh an edge is.
    pub(crate) fn name(&mut self, edge: EdgeId, whole: EdgeId) {
        self.edges.insert(edge, whole);
    }

    /// The vertex as stored that a vertex of the excerpt is.
    pub fn stored_vertex(&self, vertex: VertexId) -> VertexId {
        self.stored.get(vertex.index()).copied().unwrap_or(vertex)
    }

    /// The face as stored that a face of the excerpt is.
    pub fn stored_face(&self, face: FaceId) -> FaceId {
        self.faces.get(face.index()).copied().unwrap_or(face)
    }

    /// The edge of the whole mesh that an edge of the excerpt is, if a list names it.
    pub fn whole_edge(&self, edge: EdgeId) -> EdgeId {
        self.edges.get(&edge).copied().unwrap_or(edge)
    }
}

fn too_much(vertices: usize) -> ExternalError {
    let needed = 100 * vertices as u64;
    ExternalError::Memory { what: "what is listed", needed, allowed: needed / 2 }
}

/// Hands over the faces of a file by vertices of a view.
fn each_face(
    (path, read): (&Path, &ReadOptions),
    map: &mut VertexMap,
    take: impl FnMut(u32, &[VertexId]) + Send,
) -> Result<(), ExternalError> {
    struct Mapped<'a, F> {
        map: &'a mut VertexMap,
        take: F,
        next: u32,
        face: Vec<VertexId>,
    }
    impl<F: FnMut(u32, &[VertexId]) + Send> Rows for Mapped<'_, F> {
        fn take_face(&mut self, stored: &[VertexId]) -> Result<(), ExternalError> {
            self.face.clear();
            for vertex in stored {
                self.face.push(VertexId(self.map.vertex(vertex.0)?));
            }
            (self.take)(self.next, &self.face);
            self.next += 1;
            Ok(())
        }
    }
    let mut sink = Mapped { map, take, next: 0, face: Vec::new() };
    read_rows(path, read, &mut sink).map(drop)
}

/// The positions of some vertices as stored, which ascend.
fn positions(
    (path, read): (&Path, &ReadOptions),
    stored: &[VertexId],
) -> Result<Vec<[f64; 3]>, ExternalError> {
    struct Chosen<'a> {
        stored: &'a [VertexId],
        next: u32,
        found: Vec<[f64; 3]>,
    }
    impl Rows for Chosen<'_> {
        fn take_vertices(&mut self, positions: &[[f64; 3]]) -> Result<(), ExternalError> {
            let (first, end) = (self.next, self.next + positions.len() as u32);
            while let Some(vertex) = self.stored.get(self.found.len()).filter(|vertex| vertex.0 < end) {
                self.found.push(positions[(vertex.0 - first) as usize]);
            }
            self.next = end;
            Ok(())
        }
        fn has_all(&self) -> bool {
            self.found.len() == self.stored.len()
        }
    }
    let mut sink = Chosen { stored, next: 0, found: Vec::new() };
    read_rows(path, read, &mut sink)?;
    Ok(sink.found)
}
