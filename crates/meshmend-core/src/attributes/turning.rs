//! What becomes of the values of a layer when a face is turned round.

use crate::{CornerId, Domain, FaceId, FaceTable, Id, Layer, NO_VALUE, PolygonMesh, Provenance, Role};

/// The values of a layer, turned with the faces that were flipped, by element of the layer's domain: as many uses as
/// before, and the pool has one value more for each different one that was turned.
pub(crate) struct Turned {
    /// The layer with its new pool and its old uses.
    pub(crate) layer: Layer,
    /// What each corner uses now; for a layer of faces what each face uses.
    pub(crate) uses: Vec<u32>,
}

/// Turns the values of a layer at the corners of flipped faces. `None` where there is nothing to turn.
///
/// *Cost*: linear in the corners, for layers that turn where faces are flipped; else O(1).
pub(crate) fn turned(layer: &Layer, faces: &FaceTable, flipped: &[FaceId]) -> Option<Turned> {
    let turn = layer.role().turn().filter(|_| !flipped.is_empty())?;
    let mut layer = layer.clone();
    let mut uses: Vec<u32> = match layer.domain() {
        Domain::Vertex => faces.corner_vertices().iter().map(|v| layer.element_use(v.index())).collect(),
        _ => (0..layer.element_count()).map(|element| layer.element_use(element)).collect(),
    };
    let mut turned_uses = vec![NO_VALUE; layer.value_count()];
    for &face in flipped {
        let elements = match layer.domain() {
            Domain::Face => face.index()..face.index() + 1,
            _ => faces.corner_range(face),
        };
        for slot in &mut uses[elements] {
            let Some(known) = turned_uses.get_mut(*slot as usize) else { continue };
            if *known == NO_VALUE {
                *known = layer.push_turned(*slot, turn);
            }
            *slot = *known;
        }
    }
    Some(Turned { layer, uses })
}

/// How many stored normals of a mesh that came of another were turned with their faces: one a corner of a flipped
/// face, or one a face where the layer is one of faces. The values show it, whatever the policy was.
///
/// *Cost*: linear in the corners of flipped faces, times the layers of normals.
pub fn turned_normals(before: &PolygonMesh, after: &PolygonMesh, record: &Provenance) -> usize {
    let layers = before.layers().iter().zip(after.layers());
    let normals = layers.filter(|(old, _)| old.role() == Role::Normal);
    normals.map(|(old, new)| turned_in(old, new, [before, after], record)).sum()
}

fn turned_in(old: &Layer, new: &Layer, meshes: [&PolygonMesh; 2], record: &Provenance) -> usize {
    let [before, after] = meshes.map(PolygonMesh::faces);
    let is_turned = |from: usize, to: usize| match (old.value_of(from), new.value_of(to)) {
        (Some(from), Some(to)) => new.is_opposite(to, old, from),
        _ => false,
    };
    let of_corner = |corner: CornerId| {
        let Some(source) = record.corners.of(corner) else { return false };
        let element = |layer: &Layer, faces: &FaceTable, corner: CornerId| match layer.domain() {
            Domain::Vertex => faces.corner_vertex(corner).index(),
            _ => corner.index(),
        };
        is_turned(element(old, before, source), element(new, after, corner))
    };
    let of_face = |face: FaceId| match new.domain() {
        Domain::Face => {
            usize::from(record.faces.of(face).is_some_and(|source| is_turned(source.index(), face.index())))
        }
        _ => after.face_corners(face).filter(|&corner| of_corner(corner)).count(),
    };
    record.flipped.iter().map(|&face| of_face(face)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Carry, Draft, FlippedNormals, Sources, Values, VertexId};

    /// Two triangles on one edge, the second of which runs the wrong way round.
    fn pair(layer: Layer) -> PolygonMesh {
        let corners = [0, 1, 2, 1, 2, 3].map(VertexId).to_vec();
        let faces = FaceTable::triangles(4, corners).unwrap();
        let points = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]];
        PolygonMesh::new(points.to_vec(), faces).unwrap().with_layers(vec![layer]).unwrap()
    }

    /// The pair with its second face turned.
    fn turned_pair(mesh: &PolygonMesh, flipped_normals: FlippedNormals) -> (PolygonMesh, Provenance) {
        let faces = FaceTable::triangles(4, [0, 1, 2, 1, 3, 2].map(VertexId).to_vec()).unwrap();
        let corners = [0, 1, 2, 3, 5, 4].map(|c| Some(CornerId(c)));
        let draft = Draft {
            flipped: vec![FaceId(1)],
            flipped_normals,
            ..Draft::of_faces(mesh, faces, Sources::same(2), Sources::listed(corners))
        };
        mesh.rebuild(draft).unwrap()
    }

    fn normals(domain: Domain, values: Values) -> Layer {
        Layer::direct("normal", domain, 1, Carry::Interpolate, values).with_role(Role::Normal)
    }

    fn numbers(layer: &Layer) -> Vec<Option<f64>> {
        let number = |value: usize| match layer.values() {
            Values::F32(v) => f64::from(v[value]),
            Values::F64(v) => v[value],
            Values::I8(v) => f64::from(v[value]),
            other => panic!("{other:?}"),
        };
        (0..layer.element_count()).map(|element| layer.value_of(element).map(number)).collect()
    }

    #[test]
    fn normals_of_corners_turn_with_their_face_and_equal_ones_share_a_value() {
        let layer = Layer::indexed(
            "normal",
            Domain::Corner,
            1,
            Carry::Interpolate,
            Values::F64(vec![1.0, 0.0]),
            vec![0, 0, 1, 0, 0, NO_VALUE],
        );
        let mesh = pair(layer.with_role(Role::Normal));
        let (after, record) = turned_pair(&mesh, FlippedNormals::Negate);
        let found = numbers(&after.layers()[0]);
        assert_eq!(found, [Some(1.0), Some(1.0), Some(0.0), Some(-1.0), None, Some(-1.0)]);
        assert_eq!(after.layers()[0].value_count(), 3);
        assert_eq!(turned_normals(&mesh, &after, &record), 2);
    }

    #[test]
    fn a_vertex_normal_stays_with_its_vertex_unless_a_face_there_is_not_turned() {
        let mesh = pair(normals(Domain::Vertex, Values::F32(vec![1.0, 2.0, 3.0, 4.0])));
        let (after, record) = turned_pair(&mesh, FlippedNormals::Negate);
        let layer = &after.layers()[0];
        assert_eq!((layer.domain(), layer.home()), (Domain::Corner, Domain::Vertex));
        assert_eq!(numbers(layer), [1.0, 2.0, 3.0, -2.0, -4.0, -3.0].map(Some));
        assert_eq!(turned_normals(&mesh, &after, &record), 3);
        // Where all faces turn, all normals do, and stay where they were.
        let faces = FaceTable::triangles(4, [0, 2, 1, 1, 3, 2].map(VertexId).to_vec()).unwrap();
        let corners = [0, 2, 1, 3, 5, 4].map(|c| Some(CornerId(c)));
        let draft = Draft {
            flipped: vec![FaceId(0), FaceId(1)],
            ..Draft::of_faces(&mesh, faces, Sources::same(2), Sources::listed(corners))
        };
        let (after, _) = mesh.rebuild(draft).unwrap();
        assert_eq!(after.layers()[0].domain(), Domain::Vertex);
        assert_eq!(numbers(&after.layers()[0]), [-1.0, -2.0, -3.0, -4.0].map(Some));
    }

    #[test]
    fn normals_of_faces_turn_too() {
        let mesh = pair(normals(Domain::Face, Values::F64(vec![1.0, 2.0])));
        let (after, record) = turned_pair(&mesh, FlippedNormals::Negate);
        assert_eq!(numbers(&after.layers()[0]), [Some(1.0), Some(-2.0)]);
        assert_eq!(turned_normals(&mesh, &after, &record), 1);
    }

    #[test]
    fn the_least_whole_number_turns_to_the_greatest() {
        let mesh = pair(normals(Domain::Corner, Values::I8(vec![1, 1, 1, -128, 127, 0])));
        let (after, record) = turned_pair(&mesh, FlippedNormals::Negate);
        assert_eq!(numbers(&after.layers()[0]), [1.0, 1.0, 1.0, 127.0, 0.0, -127.0].map(Some));
        assert_eq!(turned_normals(&mesh, &after, &record), 3);
    }

    #[test]
    fn normals_stay_where_the_policy_says_so_and_other_roles_always() {
        let mesh = pair(normals(Domain::Vertex, Values::F64(vec![1.0, 2.0, 3.0, 4.0])));
        let (after, record) = turned_pair(&mesh, FlippedNormals::Keep);
        assert_eq!(after.layers()[0], mesh.layers()[0]);
        assert_eq!(turned_normals(&mesh, &after, &record), 0);
        let colors = Layer::direct("color", Domain::Vertex, 1, Carry::Copy, Values::U8(vec![1, 2, 3, 4]));
        let mesh = pair(colors.with_role(Role::Color));
        assert_eq!(turned_pair(&mesh, FlippedNormals::Negate).0.layers()[0], mesh.layers()[0]);
    }

    #[test]
    fn a_tangent_keeps_its_way_and_changes_its_hand() {
        let values = Values::F32([1.0, 2.0, 3.0, 1.0].repeat(6));
        let layer = Layer::direct("tangent", Domain::Corner, 4, Carry::Interpolate, values);
        let mesh = pair(layer.with_role(Role::Tangent));
        let (after, _) = turned_pair(&mesh, FlippedNormals::Negate);
        let Values::F32(values) = after.layers()[0].values() else { panic!("another type") };
        let at = |corner| after.layers()[0].value_of(corner).map(|v| &values[4 * v..4 * v + 4]);
        assert_eq!(at(0), Some(&[1.0, 2.0, 3.0, 1.0][..]));
        assert_eq!(at(5), Some(&[1.0, 2.0, 3.0, -1.0][..]));
    }

    #[test]
    fn turning_twice_gives_back_each_value() {
        let mesh = pair(normals(Domain::Vertex, Values::F64(vec![1.0, 0.0, f64::NAN, -4.0])));
        let (once, _) = turned_pair(&mesh, FlippedNormals::Negate);
        let faces = mesh.faces().clone();
        let corners = [0, 1, 2, 3, 5, 4].map(|c| Some(CornerId(c)));
        let draft = Draft {
            flipped: vec![FaceId(1)],
            ..Draft::of_faces(&once, faces, Sources::same(2), Sources::listed(corners))
        };
        let (twice, _) = once.rebuild(draft).unwrap();
        let layer = &twice.layers()[0];
        assert_eq!(layer.domain(), Domain::Vertex);
        let bits = |layer: &Layer| -> Vec<_> { numbers(layer).iter().map(|x| x.map(f64::to_bits)).collect() };
        assert_eq!(bits(layer), bits(&mesh.layers()[0]));
    }
}
