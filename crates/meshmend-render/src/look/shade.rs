//! How faces look: which side of them is seen, in which colour, and how light it is.

use meshmend_core::{FaceId, Id, PolygonMesh};

use crate::look::appearance::{Fill, Side, Tone};
use crate::panels::frame::Frame;
use crate::scenes::overlay::Overlay;
use crate::scenes::scene::Scene;
use crate::vector::{Vector, add, cross, direction, dot, subtract};

/// The light comes from the eye's upper left.
const LIGHT: Vector = [-0.4, 0.55, 0.75];

/// The look of each face.
pub(crate) fn tones(scene: &Scene, frame: &Frame, placed: &[Vector]) -> Vec<Tone> {
    let faces = scene.mesh.complex().faces();
    let fills = fills(scene);
    let light = direction(LIGHT).unwrap_or(LIGHT);
    let (mut corners, mut turned) = (Vec::new(), Vec::new());
    let tone = |face: FaceId| {
        let vertices = faces.face_vertices(face);
        corners.clear();
        corners.extend(vertices.iter().map(|v| placed[v.index()]));
        turned.clear();
        turned.extend(vertices.iter().map(|&v| frame.turned(scene.mesh.position(v))));
        let side = side_of(&corners);
        let normal = direction(area_vector(&turned)).unwrap_or([0.0; 3]);
        let facing = if side == Side::Front { dot(normal, light) } else { -dot(normal, light) };
        // What is turned away from the light is not all black.
        Tone::new(fills[face.index()], side, (1.0 + facing) / 2.0)
    };
    faces.faces().map(tone).collect()
}

/// Which side of a face is seen, by the way its corners go round in the picture.
pub(crate) fn side_of(corners: &[Vector]) -> Side {
    let Some(&origin) = corners.first() else { return Side::Front };
    let from_origin = |corner: Vector| [corner[0] - origin[0], corner[1] - origin[1]];
    let twice = corners.windows(2).map(|pair| {
        let (one, other) = (from_origin(pair[0]), from_origin(pair[1]));
        one[0] * other[1] - other[0] * one[1]
    });
    // As y goes down, what runs counter-clockwise has a negative area.
    if twice.sum::<f64>() < 0.0 { Side::Front } else { Side::Back }
}

/// The component of a face: that of its first vertex, as all its vertices are of one.
pub(crate) fn component_of_face(mesh: &PolygonMesh, of_vertex: &[Option<u32>], face: FaceId) -> Option<u32> {
    let first = mesh.complex().faces().face_vertices(face).first()?;
    of_vertex.get(first.index()).copied().flatten()
}

/// Twice the area of a face, at a right angle to it.
fn area_vector(corners: &[Vector]) -> Vector {
    let Some(&origin) = corners.first() else { return [0.0; 3] };
    let fan = corners.windows(2).map(|pair| cross(subtract(pair[0], origin), subtract(pair[1], origin)));
    fan.fold([0.0; 3], add)
}

/// What colours each face; strips are over components.
fn fills(scene: &Scene) -> Vec<Fill> {
    let faces = scene.mesh.complex().faces();
    let mut fills = vec![Fill::Plain; faces.face_count()];
    for overlay in &scene.overlays {
        if let Overlay::Components { of_vertex } = overlay {
            for face in faces.faces() {
                if let Some(component) = component_of_face(&scene.mesh, of_vertex, face) {
                    fills[face.index()] = Fill::Component(component);
                }
            }
        }
    }
    for overlay in &scene.overlays {
        if let Overlay::Witness { strips } = overlay {
            strips.iter().flat_map(|strip| &strip.faces).for_each(|face| fills[face.index()] = Fill::Strip);
        }
    }
    fills
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_face_is_seen_from_the_front_where_it_runs_counter_clockwise() {
        // y goes down.
        let face = [[0.0, 8.0, 0.0], [8.0, 8.0, 0.0], [0.0, 0.0, 0.0]];
        assert_eq!(side_of(&face), Side::Front);
        let [a, b, c] = face;
        assert_eq!(side_of(&[c, b, a]), Side::Back);
    }

    #[test]
    fn the_area_of_a_hollow_face_points_to_its_front() {
        let face = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [3.0, 1.0]].map(|[x, y]| [x, y, 7.0]);
        assert_eq!(area_vector(&face), [0.0, 0.0, 8.0]);
        assert_eq!(area_vector(&[]), [0.0; 3]);
    }
}
