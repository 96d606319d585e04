//! Small meshes and their surfaces.

use meshmend_core::{FaceId, PolygonMesh, VertexId};

use super::Surface;

fn corners(surface: &Surface<'_>, face: u32) -> Vec<[u32; 3]> {
    let triangles = surface.triangles_of(FaceId(face)).iter();
    triangles.map(|triangle| triangle.corners.map(|VertexId(corner)| corner)).collect()
}

#[test]
fn corners_are_known_by_their_positions() {
    let points =
        [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, -0.0, -0.0], [0.0, 1.0, 0.0], [1.0; 3]];
    let mesh = PolygonMesh::from_triangles(&points, &[[0, 1, 2], [4, 3, 5]]).unwrap();
    let surface = Surface::of(&mesh).unwrap();
    assert_eq!((corners(&surface, 0), corners(&surface, 1)), (vec![[0, 1, 2]], vec![[2, 1, 5]]));
}

#[test]
fn faces_without_a_surface_are_told_apart() {
    let points = [
        [0.0, 0.0, 0.0],
        [1.0, 1.0, 1.0],
        [3.0, 3.0, 3.0],
        [7.0, 7.0, 7.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, f64::NAN],
        [1.0, 0.0, 0.0],
    ];
    let faces: [&[u32]; 6] = [&[0, 1, 2], &[0, 1, 4], &[0, 1, 5], &[1, 4, 6], &[0, 2, 1, 3], &[0, 4, 2, 6]];
    let all: Vec<u32> = faces.concat();
    let mesh = PolygonMesh::from_polygons(&points, &all, &[0, 3, 6, 9, 12, 16, 20]).unwrap();
    let surface = Surface::of(&mesh).unwrap();
    assert_eq!(surface.zero_area(), [FaceId(0), FaceId(4)]);
    assert_eq!(surface.unfit(), [FaceId(2), FaceId(3), FaceId(5)]);
    assert_eq!(surface.triangles().len(), 1);
    assert_eq!(corners(&surface, 1), [[0, 1, 4]]);
}

#[test]
fn the_diagonal_of_a_square_lies_inside_it() {
    let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    let mesh = PolygonMesh::from_polygons(&points, &[0, 1, 2, 3, 2, 1, 0, 3], &[0, 4, 8]).unwrap();
    let surface = Surface::of(&mesh).unwrap();
    for triangle in surface.triangles_of(FaceId(0)) {
        let sides = [0b011, 0b110, 0b101];
        assert_eq!(sides.into_iter().filter(|&side| triangle.cell_of_face(side) == 0b111).count(), 1);
        assert!([0b001, 0b010, 0b100].into_iter().all(|corner| triangle.cell_of_face(corner) == corner));
    }
    assert!(surface.is_same_cycle(FaceId(0), FaceId(1)));
}
