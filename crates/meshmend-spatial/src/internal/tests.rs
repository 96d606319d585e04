//! Boxes in boxes, beside the definition.

use meshmend_core::PolygonMesh;
use meshmend_geometry::vector::Point;

use super::{InternalFaces, internal_faces};
use crate::{IntersectionOptions, Surface, intersections, nesting};

/// A mesh of boxes, each from its lowest corner to its highest, and whether it looks outward.
fn boxes(all: &[([i32; 3], [i32; 3], bool)]) -> PolygonMesh {
    let (mut points, mut faces): (Vec<Point>, Vec<[u32; 3]>) = (Vec::new(), Vec::new());
    for &(low, high, is_outward) in all {
        let first = points.len() as u32;
        points.extend((0..8).map(|code| {
            std::array::from_fn(|i| f64::from(if code >> (2 - i) & 1 == 0 { low[i] } else { high[i] }))
        }));
        for [a, b, c, d] in
            [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
        {
            for face in [[a, b, c], [a, c, d]] {
                let [a, b, c] = face.map(|corner| first + corner);
                faces.push(if is_outward { [a, b, c] } else { [a, c, b] });
            }
        }
    }
    PolygonMesh::from_triangles(&points, &faces).unwrap()
}

fn found(mesh: &PolygonMesh) -> InternalFaces {
    let surface = Surface::of(mesh).unwrap();
    let met = intersections(&surface, IntersectionOptions::default()).unwrap();
    internal_faces(&surface, &met, &nesting(&surface).unwrap()).unwrap().unwrap()
}

#[test]
fn a_solid_in_a_solid_is_internal_and_a_cavity_is_not() {
    let outer = ([0; 3], [5; 3], true);
    for (low, high, is_outward, count) in
        [([1; 3], [2; 3], true, 12), ([1; 3], [2; 3], false, 0), ([7; 3], [8; 3], true, 0)]
    {
        let InternalFaces { internal, mixed } = found(&boxes(&[outer, (low, high, is_outward)]));
        assert_eq!((internal.len(), mixed.len()), (count, 0));
        assert!(internal.iter().all(|face| face.0 >= 12));
    }
}

#[test]
fn what_lies_on_a_wall_is_mixed_and_the_rest_internal() {
    // A box that stands on the floor of another, within it: its floor overlaps that one.
    let mesh = boxes(&[([0; 3], [5; 3], true), ([1, 1, 0], [2; 3], true)]);
    let InternalFaces { internal, mixed } = found(&mesh);
    assert_eq!(mixed.iter().filter(|face| face.0 >= 12).count() + internal.len(), 12);
    assert!(internal.iter().all(|face| face.0 >= 12) && mixed.iter().any(|face| face.0 < 12));
}
