//! Which vertices at one place stay together when a model moves: those whose morph targets move them alike, and that
//! the same joints move by the same weights. A closed mouth is two lips.

use meshmend_core::{CornerId, Domain, Id, Layer, PolygonMesh, Role, VertexId};

use crate::proximity::{NoClasses, proximity_classes};
use crate::vector::{Point, place_bits};

/// The lowest vertex near each of some points.
type Near<'a> = dyn Fn(&[Point]) -> Result<Vec<VertexId>, NoClasses> + 'a;

/// How often classes are parted in each space in turn before they are parted by equal poses.
const MOST_ROUNDS: usize = 8;

/// Classes of vertices, each named by its lowest one, parted until all vertices of a class have equal poses: equal
/// displacements in every morph target, and the same joints with the same weights. In a mesh without such layers the
/// classes stay as they are.
///
/// *Cost*: constant without such layers; else linear, and sorting the vertices of classes of more than one.
pub fn equal_in_pose(mesh: &PolygonMesh, lowest: Vec<VertexId>) -> Vec<VertexId> {
    let Some(poses) = Poses::of(mesh) else { return lowest };
    let mut parted = lowest;
    for class in classes(&parted) {
        poses.part_equal(&class, &mut parted);
    }
    parted
}

/// The same, until the displacements of a class are in one connected component of "distance ≤ ε" in every morph
/// target, as the positions are. Joints and weights are the same.
///
/// # Errors
/// As [`proximity_classes`].
pub fn near_in_pose(
    mesh: &PolygonMesh,
    lowest: Vec<VertexId>,
    epsilon: f64,
    goes_on: &dyn Fn() -> bool,
) -> Result<Vec<VertexId>, NoClasses> {
    let Some(poses) = Poses::of(mesh) else { return Ok(lowest) };
    let mut parted = lowest;
    for class in classes(&parted) {
        poses.part_near(class, &mut parted, &|points| proximity_classes(points, epsilon, goes_on))?;
    }
    Ok(parted)
}

/// The classes of more than one vertex, each ascending.
fn classes(lowest: &[VertexId]) -> Vec<Vec<VertexId>> {
    let mut joined: Vec<(VertexId, VertexId)> = lowest
        .iter()
        .enumerate()
        .map(|(v, &low)| (low, VertexId::new(v)))
        .filter(|(low, v)| low != v)
        .collect();
    joined.sort_unstable();
    let of_one_class = joined.chunk_by(|one, other| one.0 == other.0);
    of_one_class
        .map(|class| std::iter::once(class[0].0).chain(class.iter().map(|&(_, v)| v)).collect())
        .collect()
}

/// What moves the vertices of a mesh.
struct Poses<'a> {
    positions: &'a [Point],
    displacements: Vec<&'a Layer>,
    /// By set: joints and weights.
    joints: Vec<[&'a Layer; 2]>,
    /// A corner of each vertex that has one, if a layer is at the corners.
    corners: Vec<Option<CornerId>>,
}

impl<'a> Poses<'a> {
    fn of(mesh: &'a PolygonMesh) -> Option<Self> {
        let is_of_vertices = |layer: &&Layer| matches!(layer.domain(), Domain::Vertex | Domain::Corner);
        let layers: Vec<&Layer> = mesh.layers().iter().filter(is_of_vertices).collect();
        let with = |is_fit: &dyn Fn(Role) -> bool| -> Vec<&Layer> {
            layers.iter().copied().filter(|layer| is_fit(layer.role())).collect()
        };
        let displacements = with(&|role| matches!(role, Role::MorphPosition(_)));
        let of_set = |joints: &'a Layer| {
            let Role::Joints(set) = joints.role() else { return Vec::new() };
            with(&|role| role == Role::Weights(set)).into_iter().map(|weights| [joints, weights]).collect()
        };
        let joints: Vec<[&Layer; 2]> =
            with(&|role| matches!(role, Role::Joints(_))).into_iter().flat_map(of_set).collect();
        if displacements.is_empty() && joints.is_empty() {
            return None;
        }
        let mut corners = Vec::new();
        if displacements.iter().chain(joints.iter().flatten()).any(|layer| layer.domain() == Domain::Corner) {
            corners = vec![None; mesh.counts().vertices];
            for corner in mesh.faces().corners().rev() {
                corners[mesh.faces().corner_vertex(corner).index()] = Some(corner);
            }
        }
        Some(Poses { positions: mesh.positions(), displacements, joints, corners })
    }

    /// The number at a place of the value that a vertex has.
    fn number(&self, layer: &Layer, vertex: VertexId, place: usize) -> Option<f64> {
        let element = match layer.domain() {
            Domain::Corner => self.corners.get(vertex.index()).copied().flatten()?.index(),
            _ => vertex.index(),
        };
        let value = layer.value_of(element)?;
        layer.values().number(value * layer.width() + place)
    }

    fn displacement(&self, layer: &Layer, vertex: VertexId) -> Point {
        std::array::from_fn(|axis| self.number(layer, vertex, axis).unwrap_or(0.0))
    }

    /// The joints that move a vertex with their weights, as bits, ascending.
    fn joints(&self, vertex: VertexId) -> Vec<[u64; 2]> {
        let of_set = |&[joints, weights]: &[&'a Layer; 2]| {
            let one = if weights.is_normalized() { weights.values().largest().unwrap_or(1.0) } else { 1.0 };
            (0..joints.width().min(weights.width())).filter_map(move |place| {
                let weight = self.number(weights, vertex, place).filter(|weight| *weight > 0.0)?;
                Some([self.number(joints, vertex, place)?.to_bits(), (weight / one).to_bits()])
            })
        };
        let mut joints: Vec<[u64; 2]> = self.joints.iter().flat_map(of_set).collect();
        joints.sort_unstable();
        joints
    }

    /// Parts a class by equal poses.
    fn part_equal(&self, class: &[VertexId], lowest: &mut [VertexId]) {
        let pose = |&vertex: &VertexId| {
            let displaced =
                self.displacements.iter().map(|layer| place_bits(self.displacement(layer, vertex)));
            (self.joints(vertex), displaced.collect::<Vec<_>>())
        };
        parted_by(class, pose).iter().for_each(|class| name(class, lowest));
    }

    /// Parts a class until it is near in every space.
    fn part_near(
        &self,
        class: Vec<VertexId>,
        lowest: &mut [VertexId],
        near: &Near<'_>,
    ) -> Result<(), NoClasses> {
        let mut classes = parted_by(&class, |&vertex| self.joints(vertex));
        for _ in 0..MOST_ROUNDS {
            let before = classes.len();
            for layer in &self.displacements {
                classes = self.parted_near(classes, near, &|vertex| self.displacement(layer, vertex))?;
            }
            if classes.len() == before && before == 1 {
                break;
            }
            classes = self.parted_near(classes, near, &|vertex| self.positions[vertex.index()])?;
            if classes.len() == before {
                break;
            }
        }
        classes.iter().for_each(|class| name(class, lowest));
        Ok(())
    }

    fn parted_near(
        &self,
        classes: Vec<Vec<VertexId>>,
        near: &Near<'_>,
        point: &dyn Fn(VertexId) -> Point,
    ) -> Result<Vec<Vec<VertexId>>, NoClasses> {
        let mut parted = Vec::with_capacity(classes.len());
        for class in classes {
            if class.len() == 1 {
                parted.push(class);
                continue;
            }
            let points: Vec<Point> = class.iter().map(|&vertex| point(vertex)).collect();
            let lowest = near(&points)?;
            let place = |at: usize| lowest[at];
            let mut order: Vec<usize> = (0..class.len()).collect();
            order.sort_by_key(|&at| place(at));
            let same = order.chunk_by(|&one, &other| place(one) == place(other));
            parted.extend(same.map(|places| places.iter().map(|&at| class[at]).collect::<Vec<_>>()));
        }
        Ok(parted)
    }
}

/// The vertices of a class by a key; each part is ascending.
fn parted_by<K: Ord>(class: &[VertexId], key: impl Fn(&VertexId) -> K) -> Vec<Vec<VertexId>> {
    let mut keyed: Vec<(K, VertexId)> = class.iter().map(|vertex| (key(vertex), *vertex)).collect();
    keyed.sort_unstable();
    let same = keyed.chunk_by(|one, other| one.0 == other.0);
    same.map(|part| part.iter().map(|&(_, vertex)| vertex).collect()).collect()
}

/// Names each vertex of a class by the lowest one.
fn name(class: &[VertexId], lowest: &mut [VertexId]) {
    let low = class.iter().copied().min();
    class.iter().for_each(|vertex| lowest[vertex.index()] = low.unwrap_or(*vertex));
}

#[cfg(test)]
mod tests {
    use meshmend_core::{Carry, FaceTable, Values};

    use super::*;
    use crate::coincident::coincident_vertices;

    /// Points without faces, with some layers of vertices.
    fn cloud(positions: &[Point], layers: Vec<Layer>) -> PolygonMesh {
        let mesh = PolygonMesh::new(positions.to_vec(), FaceTable::empty(positions.len())).unwrap();
        mesh.with_layers(layers).unwrap()
    }

    fn layer(role: Role, width: usize, values: Values) -> Layer {
        Layer::direct("pose", Domain::Vertex, width, Carry::Copy, values).with_role(role)
    }

    fn ids(lowest: Vec<VertexId>) -> Vec<u32> {
        lowest.into_iter().map(|vertex| vertex.0).collect()
    }

    fn exact(layers: Vec<Layer>) -> Vec<u32> {
        let mesh = cloud(&[[0.0; 3]; 4], layers);
        ids(equal_in_pose(&mesh, coincident_vertices(&mesh)))
    }

    #[test]
    fn vertices_that_move_apart_are_apart() {
        assert_eq!(exact(Vec::new()), [0, 0, 0, 0]);
        let morph = |y: [f32; 4]| {
            let values = y.iter().flat_map(|&y| [0.0, y, 0.0]).collect();
            layer(Role::MorphPosition(0), 3, Values::F32(values))
        };
        assert_eq!(exact(vec![morph([1.0, 0.0, 1.0, -0.0])]), [0, 1, 0, 1]);
        assert_eq!(exact(vec![morph([2.0; 4]), morph([0.0, 0.0, 5.0, 0.0])]), [0, 0, 2, 0]);
    }

    #[test]
    fn joints_count_as_a_set_and_without_weight_not_at_all() {
        let joints = layer(Role::Joints(0), 2, Values::U8(vec![1, 2, 2, 1, 1, 9, 1, 2]));
        let weights = layer(Role::Weights(0), 2, Values::U8(vec![155, 100, 100, 155, 255, 0, 154, 101]));
        let weights = weights.with_normalized(true);
        assert_eq!(exact(vec![joints.clone(), weights]), [0, 0, 2, 3]);
        // A set without weights moves no vertex.
        assert_eq!(exact(vec![joints]), [0, 0, 0, 0]);
    }

    #[test]
    fn a_tolerance_holds_in_every_space() {
        let positions = [0.0, 0.5, 1.0, 1.5, 9.0].map(|x| [x, 0.0, 0.0]);
        let morph = [0.0, 7.0, 0.25, 0.5, 0.0].iter().flat_map(|&z| [0.0, 0.0, z]).collect();
        let mesh = cloud(&positions, vec![layer(Role::MorphPosition(0), 3, Values::F64(morph))]);
        let near = |epsilon: f64| {
            let lowest = proximity_classes(mesh.positions(), epsilon, &|| true).unwrap();
            ids(near_in_pose(&mesh, lowest, epsilon, &|| true).unwrap())
        };
        // The vertex in between moves away, so the first is not within the distance of the third any more.
        assert_eq!(near(0.6), [0, 1, 2, 2, 4]);
        assert_eq!(near(1.1), [0, 1, 0, 0, 4]);
    }

    #[test]
    fn layers_that_moved_to_the_corners_speak_for_their_vertices() {
        let faces = FaceTable::triangles(6, (0..6).map(VertexId).collect()).unwrap();
        let positions = vec![[0.0; 3]; 6];
        let uses = vec![0, 0, 1, 0, 1, 1];
        let values = Values::F32(vec![0.0, 0.0, 0.0, 1.0, 0.0, 0.0]);
        let morph = Layer::indexed("pose", Domain::Corner, 3, Carry::Copy, values, uses);
        let morph = morph.with_role(Role::MorphPosition(0)).at_home_on_vertices(6);
        let mesh = PolygonMesh::new(positions, faces).unwrap().with_layers(vec![morph]).unwrap();
        assert_eq!(ids(equal_in_pose(&mesh, coincident_vertices(&mesh))), [0, 0, 2, 0, 2, 2]);
    }
}
