//! A mesh taken apart by a name that its faces have, such as that of their object, and put together again.
//!
//! Each part is a mesh of its own, so that a pass sees its faces alone. A vertex that several parts use is one vertex
//! again in the whole, unless a repair made several of it within one part.

use std::collections::BTreeMap;
use std::sync::Arc;

use meshmend_core::{
    Blend, CornerId, Domain, Draft, DraftError, FaceId, FaceTableBuilder, Id, Layer, Loose, PolygonMesh,
    Provenance, Sources, Values, VertexDraft, VertexId,
};

/// The faces of a mesh that have one name, as a mesh of its own.
#[derive(Clone, Debug)]
pub struct NamedPart {
    /// The name; empty for faces without one.
    pub name: Vec<u8>,
    /// Its faces and the vertices that they use, in the order of the whole mesh. Loose elements are in no part.
    pub mesh: PolygonMesh,
    /// Where its elements are in the whole mesh.
    pub record: Provenance,
}

/// The parts of a mesh by the names that faces have in a layer, in the order of their first faces. `None` if faces have
/// no names of this kind.
///
/// # Errors
/// If a part would have more elements than a mesh holds.
///
/// *Cost*: linear in the mesh, and for each part in the vertices.
pub fn named_parts(mesh: &PolygonMesh, layer: &str) -> Result<Option<Vec<NamedPart>>, DraftError> {
    let Some((layer, names)) = mesh.layer(layer, Domain::Face).and_then(names) else { return Ok(None) };
    let mut places: BTreeMap<&[u8], usize> = BTreeMap::new();
    let mut parts: Vec<(&[u8], Vec<FaceId>)> = Vec::new();
    for face in mesh.faces().faces() {
        let name = layer.value_of(face.index()).map_or(&[][..], |value| &names[value]);
        let place = *places.entry(name).or_insert_with(|| {
            parts.push((name, Vec::new()));
            parts.len() - 1
        });
        parts[place].1.push(face);
    }
    let mut new_id = vec![None; mesh.counts().vertices];
    let part = |(name, faces): (&[u8], Vec<FaceId>)| part(mesh, name, &faces, &mut new_id);
    parts.into_iter().map(part).collect::<Result<Vec<_>, _>>().map(Some)
}

fn names(layer: &Layer) -> Option<(&Layer, &[Vec<u8>])> {
    match layer.values() {
        Values::Text(names) if layer.width() == 1 => Some((layer, names)),
        _ => None,
    }
}

/// The part of some faces. `new_id` has no vertex, before and after.
fn part(
    mesh: &PolygonMesh,
    name: &[u8],
    faces: &[FaceId],
    new_id: &mut [Option<VertexId>],
) -> Result<NamedPart, DraftError> {
    let mut used: Vec<VertexId> =
        faces.iter().flat_map(|&face| mesh.faces().face_vertices(face)).copied().collect();
    used.sort_unstable();
    used.dedup();
    used.iter().enumerate().for_each(|(new, old)| new_id[old.index()] = Some(VertexId::new(new)));
    let mut table = FaceTableBuilder::default();
    let mut corners = Vec::new();
    for &face in faces {
        table.push_face(mesh.faces().face_vertices(face).iter().filter_map(|v| new_id[v.index()]));
        corners.extend(mesh.faces().face_corners(face).map(Some));
    }
    used.iter().for_each(|old| new_id[old.index()] = None);
    let table = table.build(used.len())?;
    let draft = Draft {
        vertex_sources: Sources::listed(used.into_iter().map(Some)),
        drop_loose: Loose { edges: true, points: true },
        ..Draft::of_faces(
            mesh,
            table,
            Sources::listed(faces.iter().copied().map(Some)),
            Sources::listed(corners),
        )
    };
    let (mesh, record) = mesh.rebuild(draft)?;
    Ok(NamedPart { name: name.to_vec(), mesh, record })
}

/// The whole mesh with what its parts have become: for each part its mesh now, and where that was in the part. Faces stand
/// in the order of the whole mesh; loose elements stay.
///
/// # Errors
/// If the mesh would have more elements than a mesh holds.
///
/// *Cost*: linear in the mesh and the parts, and sorting the faces.
pub fn joined_parts(
    whole: &PolygonMesh,
    parts: &[(&NamedPart, &PolygonMesh, &Provenance)],
) -> Result<(PolygonMesh, Provenance), DraftError> {
    let seen = |&(part, mesh, record): &(&NamedPart, &'_ PolygonMesh, &Provenance)| {
        part.record.then(record, whole.faces(), mesh.faces())
    };
    let records: Vec<Provenance> = parts.iter().map(seen).collect();
    let mut join = Join::new(whole);
    for ((_, mesh, _), record) in parts.iter().zip(&records) {
        join.add_vertices(mesh, record);
    }
    join.number();
    let mut order: Vec<(Option<FaceId>, usize, FaceId)> = Vec::new();
    for (part, record) in records.iter().enumerate() {
        order.extend(record.faces.iter().map(|(face, source)| (source, part, face)));
    }
    // Faces that were created come last.
    order.sort_unstable_by_key(|&(source, part, face)| (source.is_none(), source, part, face));
    let mut draft = Faces::default();
    for (source, part, face) in order {
        draft.add(source, face, (parts[part].1, &records[part]), &join.new_ids[part]);
    }
    whole.rebuild(join.draft(draft)?)
}

/// The vertices of a whole that is put together.
struct Join<'a> {
    whole: &'a PolygonMesh,
    /// The position of each vertex of the whole that a part still uses or that no part knew.
    kept: Vec<Option<[f64; 3]>>,
    /// Further vertices made of one of the whole.
    further: Vec<(VertexId, [f64; 3])>,
    created: Vec<VertexDraft>,
    /// For each part and vertex of it, which vertex of the whole it becomes.
    places: Vec<Vec<Place>>,
    new_ids: Vec<Vec<VertexId>>,
}

#[derive(Clone, Copy)]
enum Place {
    Kept(VertexId),
    Further(usize),
    Created(usize),
}

impl<'a> Join<'a> {
    fn new(whole: &'a PolygonMesh) -> Self {
        let mut is_used = vec![false; whole.counts().vertices];
        whole.faces().corner_vertices().iter().for_each(|v| is_used[v.index()] = true);
        let loose = whole.loose_edges().iter().flatten().chain(whole.loose_points());
        let mut kept: Vec<Option<[f64; 3]>> =
            is_used.iter().zip(whole.positions()).map(|(&used, &point)| (!used).then_some(point)).collect();
        loose.for_each(|v| kept[v.index()] = Some(whole.position(*v)));
        Join {
            whole,
            kept,
            further: Vec::new(),
            created: Vec::new(),
            places: Vec::new(),
            new_ids: Vec::new(),
        }
    }

    fn add_vertices(&mut self, mesh: &PolygonMesh, record: &Provenance) {
        let mut is_taken: Vec<VertexId> = Vec::new();
        let mut places = Vec::with_capacity(mesh.counts().vertices);
        let mut sources: Vec<(VertexId, VertexId)> =
            record.vertices.iter().filter_map(|(new, old)| Some((old?, new))).collect();
        sources.sort_unstable();
        // The first vertex of a part that is made of one of the whole is that one.
        is_taken.extend(sources.chunk_by(|one, other| one.0 == other.0).map(|same| same[0].1));
        is_taken.sort_unstable();
        let created: BTreeMap<VertexId, Option<Blend>> = record.created.iter().copied().collect();
        for (vertex, source) in record.vertices.iter() {
            let position = mesh.position(vertex);
            let is_first = is_taken.binary_search(&vertex).is_ok();
            places.push(match source {
                Some(old) if is_first && self.take(old, position) => Place::Kept(old),
                Some(old) => {
                    self.further.push((old, position));
                    Place::Further(self.further.len() - 1)
                }
                None => {
                    let place = created.get(&vertex).copied().flatten();
                    self.created.push(VertexDraft { position, place });
                    Place::Created(self.created.len() - 1)
                }
            });
        }
        self.places.push(places);
    }

    /// Keeps a vertex of the whole at a position, unless it is kept at another one.
    fn take(&mut self, old: VertexId, position: [f64; 3]) -> bool {
        let slot = &mut self.kept[old.index()];
        let bits = |point: [f64; 3]| point.map(f64::to_bits);
        let at = *slot.get_or_insert(position);
        bits(at) == bits(position)
    }

    /// Gives all vertices their numbers.
    fn number(&mut self) {
        let mut count = 0;
        let mut kept_id = vec![VertexId(0); self.kept.len()];
        for (old, _) in self.kept.iter().enumerate().filter(|(_, position)| position.is_some()) {
            kept_id[old] = VertexId::new(count);
            count += 1;
        }
        let further = self.further.len();
        let id = |place: &Place| match *place {
            Place::Kept(old) => kept_id[old.index()],
            Place::Further(at) => VertexId::new(count + at),
            Place::Created(at) => VertexId::new(count + further + at),
        };
        self.new_ids = self.places.iter().map(|places| places.iter().map(id).collect()).collect();
    }

    fn draft(self, faces: Faces) -> Result<Draft, DraftError> {
        let kept =
            || self.kept.iter().enumerate().filter_map(|(old, point)| Some((VertexId::new(old), (*point)?)));
        let all = || kept().chain(self.further.iter().copied());
        let sources = all().map(|(old, _)| Some(old)).chain(self.created.iter().map(|_| None));
        let vertex_sources = Sources::listed(sources);
        let table = faces.table.build(vertex_sources.len())?;
        let face_sources = Sources::listed(faces.sources);
        Ok(Draft {
            vertex_sources,
            kept_positions: Some(Arc::new(all().map(|(_, point)| point).collect())),
            flipped: faces.flipped,
            created_corners: faces.created_corners,
            created_vertices: self.created,
            ..Draft::of_faces(self.whole, table, face_sources, Sources::listed(faces.corners))
        })
    }
}

/// The faces of a whole that is put together.
#[derive(Default)]
struct Faces {
    table: FaceTableBuilder,
    sources: Vec<Option<FaceId>>,
    corners: Vec<Option<CornerId>>,
    created_corners: Vec<(CornerId, Blend)>,
    flipped: Vec<FaceId>,
}

impl Faces {
    fn add(
        &mut self,
        source: Option<FaceId>,
        face: FaceId,
        (mesh, record): (&PolygonMesh, &Provenance),
        new_ids: &[VertexId],
    ) {
        if record.flipped.binary_search(&face).is_ok() {
            self.flipped.push(FaceId::new(self.sources.len()));
        }
        self.sources.push(source);
        for corner in mesh.faces().face_corners(face) {
            let old = record.corners.of(corner);
            let vertex = mesh.faces().corner_vertex(corner);
            if let (None, Ok(at)) = (old, record.created.binary_search_by_key(&vertex, |created| created.0)) {
                let new = CornerId::new(self.corners.len());
                self.created_corners.extend(record.created[at].1.map(|place| (new, place)));
            }
            self.corners.push(old);
            self.table.push_corner(new_ids[vertex.index()]);
        }
        self.table.end_face();
    }
}

#[cfg(test)]
mod tests {
    use meshmend_core::{Carry, FaceTable};

    use super::*;
    use crate::Pipeline;

    /// Two triangles that share a side, in two objects, of which the first is there twice; and a vertex in no face.
    fn mesh() -> PolygonMesh {
        let corners = [0, 1, 2, 2, 1, 3, 1, 2, 0].map(VertexId).to_vec();
        let positions = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0], [5.0, 5.0, 5.0]];
        let names = Values::Text(vec![b"one".to_vec(), b"two".to_vec()]);
        let object = Layer::indexed("object", Domain::Face, 1, Carry::Copy, names, vec![0, 1, 0]);
        let uv = Layer::direct(
            "texcoord",
            Domain::Corner,
            1,
            Carry::Copy,
            Values::U8(vec![0, 1, 2, 3, 4, 5, 1, 2, 0]),
        );
        let faces = FaceTable::triangles(5, corners).unwrap();
        PolygonMesh::new(positions, faces).unwrap().with_layers(vec![object, uv]).unwrap()
    }

    #[test]
    fn parts_are_the_faces_of_a_name_with_their_vertices() {
        let mesh = mesh();
        assert!(named_parts(&mesh, "material").unwrap().is_none());
        let parts = named_parts(&mesh, "object").unwrap().unwrap();
        let names: Vec<&[u8]> = parts.iter().map(|part| &part.name[..]).collect();
        assert_eq!(names, [b"one", b"two"]);
        assert_eq!((parts[0].mesh.counts().vertices, parts[0].mesh.counts().faces), (3, 2));
        assert_eq!(parts[1].mesh.positions()[0], [1.0, 0.0, 0.0]);
    }

    #[test]
    fn unchanged_parts_make_the_whole_again() {
        let mesh = mesh();
        let parts = named_parts(&mesh, "object").unwrap().unwrap();
        let records: Vec<Provenance> =
            parts.iter().map(|part| Provenance::same(part.mesh.counts())).collect();
        let same: Vec<_> =
            parts.iter().zip(&records).map(|(part, record)| (part, &part.mesh, record)).collect();
        let (joined, record) = joined_parts(&mesh, &same).unwrap();
        assert!(record.is_same());
        assert_eq!((joined.positions(), joined.faces()), (mesh.positions(), mesh.faces()));
    }

    #[test]
    fn a_repair_sees_the_faces_of_one_part_alone() {
        let mesh = mesh();
        let parts = named_parts(&mesh, "object").unwrap().unwrap();
        let repaired: Vec<_> =
            parts.iter().map(|part| Pipeline::default().run(&part.mesh).unwrap()).collect();
        let now: Vec<_> =
            parts.iter().zip(&repaired).map(|(part, r)| (part, &r.mesh, &r.provenance)).collect();
        let (joined, record) = joined_parts(&mesh, &now).unwrap();
        // The repeated face goes; the side between the objects stays one side of shared vertices.
        assert_eq!((joined.counts().vertices, joined.counts().faces), (5, 2));
        assert_eq!(record.removed_faces(), [FaceId(2)]);
        let sides = joined.complex().edges().edge_count();
        assert_eq!(sides, 5);
        let uv = joined.layer("texcoord", Domain::Corner).unwrap();
        let values: Vec<_> = (0..6).map(|corner| uv.values().number(uv.value_of(corner).unwrap())).collect();
        assert_eq!(values, [0.0, 1.0, 2.0, 3.0, 4.0, 5.0].map(Some));
    }
}
