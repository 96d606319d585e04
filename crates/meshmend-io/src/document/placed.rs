//! The parts of a document as one mesh.

use meshmend_core::{Domain, FaceTable, FaceTableBuilder, MAX_CORNERS, PolygonMesh, VertexId};
use thiserror::Error;

use crate::document::merged_layers::{Elements, MergedLayers};
use crate::document::{Document, Placement, Placing};
use crate::{ReadFile, Shell};

/// How many times as many vertices and corners as its parts have a placed mesh may have, once it is large.
const MOST_TIMES: u64 = 1000;

/// From how many vertices and corners on it is large.
const LARGE: u64 = 1 << 24;

/// A file places its parts so often that one mesh of them would be out of proportion to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error(
    "its meshes have {present} vertices and corners, but {placed} as often as they are placed: too many for one mesh"
)]
pub struct TooMuchPlaced {
    /// How many vertices and corners the parts have together.
    pub present: u64,
    /// How many the mesh would have.
    pub placed: u64,
}

/// One mesh of all parts of a document.
pub(super) fn file_of(document: Document, placing: Placing) -> Result<ReadFile, TooMuchPlaced> {
    let is_whole = document.is_whole();
    let Document { mut parts, format, variant, notes, shell } = document;
    if is_whole {
        let mesh = parts.remove(0).mesh;
        return Ok(ReadFile { mesh, format, variant, notes, shell });
    }
    let each_once = || parts.iter().enumerate().map(|(at, part)| Placement::still(at, part.name.clone()));
    let placements = match placing {
        Placing::Scene => shell.placements(),
        Placing::Parts => None,
    };
    let placements = placements.unwrap_or_else(|| each_once().collect());
    let mesh = match &placements[..] {
        [only] if only.matrix == Placement::STILL && only.part < parts.len() => {
            alone(parts.swap_remove(only.part).mesh, only)?
        }
        _ => placed(&parts.iter().map(|part| &part.mesh).collect::<Vec<_>>(), &placements)?,
    };
    Ok(ReadFile { mesh, format, variant, notes, shell: Shell::of_scene(&shell) })
}

/// A mesh that stays where it is, with the layers that a mesh of several parts has.
fn alone(mesh: PolygonMesh, placement: &Placement) -> Result<PolygonMesh, TooMuchPlaced> {
    let mut layers = MergedLayers::default();
    layers.add(&mesh, placement, &Elements { before: &|_| 0, corners: None });
    let layers = layers.finish(|domain| mesh.element_count(domain));
    let present = mesh.positions().len() as u64 + mesh.faces().corner_count() as u64;
    mesh.with_layers(layers).map_err(|_| TooMuchPlaced { present, placed: present })
}

/// Meshes where they are placed, as one.
fn placed(meshes: &[&PolygonMesh], placements: &[Placement]) -> Result<PolygonMesh, TooMuchPlaced> {
    let size = |mesh: &PolygonMesh| (mesh.positions().len() + mesh.faces().corner_count()) as u64;
    let is_there = |placement: &&Placement| placement.part < meshes.len();
    let placements: Vec<&Placement> = placements.iter().filter(is_there).collect();
    let present: u64 = meshes.iter().map(|mesh| size(mesh)).sum();
    let total: u64 = placements.iter().map(|placement| size(meshes[placement.part])).sum();
    let too_much = TooMuchPlaced { present, placed: total };
    if total > LARGE && total / MOST_TIMES > present || total >= MAX_CORNERS as u64 {
        return Err(too_much);
    }
    let mut merge = Merge::default();
    placements.iter().for_each(|placement| merge.add(meshes[placement.part], placement));
    merge.finish().ok_or(too_much)
}

/// A mesh that is put together.
#[derive(Default)]
struct Merge {
    positions: Vec<[f64; 3]>,
    faces: FaceTableBuilder,
    loose_edges: Vec<[VertexId; 2]>,
    loose_points: Vec<VertexId>,
    layers: MergedLayers,
}

impl Merge {
    fn add(&mut self, mesh: &PolygonMesh, placement: &Placement) {
        let first = self.positions.len() as u32;
        let moved = |vertex: &VertexId| VertexId(vertex.0 + first);
        let before = |domain| match domain {
            Domain::Vertex => first as usize,
            Domain::Corner => self.faces.corner_count(),
            Domain::Face => self.faces.face_count(),
            Domain::LooseEdge => self.loose_edges.len(),
            Domain::LoosePoint => self.loose_points.len(),
        };
        let corners = corner_order(mesh.faces(), placement.mirrors());
        self.layers.add(mesh, placement, &Elements { before: &before, corners: corners.as_deref() });
        self.positions.extend(mesh.positions().iter().map(|&point| placement.moved(point)));
        for face in mesh.faces().faces() {
            let vertices = mesh.faces().face_vertices(face);
            if placement.mirrors() {
                let (head, rest) = vertices.split_at(vertices.len().min(1));
                self.faces.push_face(head.iter().chain(rest.iter().rev()).map(moved));
            } else {
                self.faces.push_face(vertices.iter().map(moved));
            }
        }
        self.loose_edges.extend(mesh.loose_edges().iter().map(|ends| ends.map(|vertex| moved(&vertex))));
        self.loose_points.extend(mesh.loose_points().iter().map(moved));
    }

    /// The mesh, if it is as small as a mesh has to be.
    fn finish(self) -> Option<PolygonMesh> {
        let count = self.positions.len();
        let faces = self.faces.build(count).ok()?;
        let mesh = PolygonMesh::new(self.positions, faces).ok()?;
        let mesh = mesh.with_loose(self.loose_edges, self.loose_points).ok()?;
        let layers = self.layers.finish(|domain| mesh.element_count(domain));
        mesh.with_layers(layers).ok()
    }
}

/// The old corner of each corner where faces are turned, each about its first corner.
fn corner_order(faces: &FaceTable, is_turned: bool) -> Option<Vec<u32>> {
    let turned = || {
        faces.faces().flat_map(|face| {
            let range = faces.corner_range(face);
            let rest = (range.start + 1..range.end).rev();
            (range.start..range.end.min(range.start + 1)).chain(rest).map(|corner| corner as u32)
        })
    };
    is_turned.then(|| turned().collect())
}

#[cfg(test)]
mod tests {
    use meshmend_core::{Carry, CornerId, FaceId, Layer, Role, Values};

    use super::*;

    fn triangle() -> PolygonMesh {
        let faces = FaceTable::triangles(3, [0, 1, 2].map(VertexId).to_vec()).unwrap();
        let mesh = PolygonMesh::new(vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], faces).unwrap();
        let up = Layer::direct(
            "normal",
            Domain::Vertex,
            3,
            Carry::Interpolate,
            Values::F32([0.0, 0.0, 1.0].repeat(3)),
        );
        let uv = Layer::direct("texcoord", Domain::Corner, 1, Carry::Copy, Values::U8(vec![10, 11, 12]));
        let row = Layer::direct("row", Domain::Vertex, 1, Carry::Clear, Values::U32(vec![0, 1, 2]));
        mesh.with_layers(vec![up.with_role(Role::Normal), uv, row.with_role(Role::Identity)]).unwrap()
    }

    #[test]
    fn a_mirrored_copy_keeps_its_front_and_its_corners_values() {
        let mirrored = Placement {
            matrix: [[-1.0, 0.0, 0.0, 9.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 2.0, 0.0]],
            ..Placement::still(0, b"twin".to_vec())
        };
        let mesh = triangle();
        let placements = [Placement::still(0, Vec::new()), mirrored, Placement::still(7, Vec::new())];
        let both = placed(&[&mesh], &placements).unwrap();
        assert_eq!(both.positions()[3..], [[9.0, 0.0, 0.0], [8.0, 0.0, 0.0], [9.0, 1.0, 0.0]]);
        assert_eq!(both.faces().face_vertices(FaceId(1)), [3, 5, 4].map(VertexId));
        let uv = both.layer("texcoord", Domain::Corner).unwrap();
        let value = |corner| uv.values().number(uv.value_of(CornerId(corner).0 as usize).unwrap());
        assert_eq!([3, 4, 5].map(value), [Some(10.0), Some(12.0), Some(11.0)]);
        let normal = both.layer("normal", Domain::Vertex).unwrap();
        let z = normal.value_of(4).map(|value| normal.values().number(value * 3 + 2));
        assert_eq!(z, Some(Some(1.0)), "the front of a mirrored face stays on its side, and the length is 1");
        let object = both.layer("object", Domain::Face).unwrap();
        assert_eq!((object.value_of(0), object.value_of(1)), (None, Some(0)));
        assert!(both.layers().iter().all(|layer| layer.role() != Role::Identity));
    }

    #[test]
    fn a_mesh_that_stays_where_it_is_is_what_a_placed_one_is() {
        let placement = Placement::still(0, b"body".to_vec());
        let moved = placed(&[&triangle()], std::slice::from_ref(&placement)).unwrap();
        let alone = alone(triangle(), &placement).unwrap();
        assert_eq!((alone.positions(), alone.faces()), (moved.positions(), moved.faces()));
        assert_eq!(alone.layers(), moved.layers());
    }

    #[test]
    fn a_mesh_that_is_placed_out_of_proportion_is_refused() {
        let mesh = triangle();
        let often = vec![Placement::still(0, Vec::new()); 3_000_000];
        let error = placed(&[&mesh], &often).unwrap_err();
        assert_eq!(error, TooMuchPlaced { present: 6, placed: 18_000_000 });
        assert!(placed(&[&mesh], &often[..1000]).is_ok());
    }
}
