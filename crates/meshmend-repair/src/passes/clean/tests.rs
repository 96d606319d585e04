//! What `clean` does to single faces.

use meshmend_testkit::Soup;

use crate::{PassKind, Plan, TriangulateFaces};

/// A vertex that triangulating created has the id of a vertex as stored that welding had joined to another one.
#[test]
fn a_created_vertex_is_no_stored_one() {
    let square = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[x, y]| [f64::from(x), f64::from(y), 0.0]);
    let soup = Soup {
        // Vertex 4 is where vertex 2 is.
        positions: [&square[..], &square[2..3]].concat(),
        // No diagonal of the squares is free, so that the first gets vertex 4 of the welded mesh inside it.
        faces: vec![vec![0, 1, 2, 3], vec![0, 2, 1, 3], vec![0, 1, 3, 2], vec![0, 1, 4]],
    };
    let mut plan =
        Plan { passes: vec![PassKind::Weld, PassKind::Triangulate, PassKind::Clean], ..Plan::default() };
    plan.triangulate.faces = TriangulateFaces::All;
    let repaired = plan.pipeline().run(&soup.mesh()).unwrap();
    assert_eq!(repaired.mesh.counts().faces, 3 * 4 + 1);
}

/// Triangles at the first vertex, and in the same squares as before three vertices that are created after many.
#[test]
fn created_vertices_are_no_stored_ones_however_many_there_are() {
    let mut soup = Soup::generic(4, [[0, 1, 2, 3], [0, 2, 1, 3], [0, 1, 3, 2]]);
    soup.positions.resize(1 << 16, [0.0; 3]);
    soup.faces.extend([[1, 2, 0], [2, 3, 0], [3, 1, 0]].map(Vec::from));
    let mut plan = Plan { passes: vec![PassKind::Triangulate, PassKind::Clean], ..Plan::default() };
    plan.triangulate.faces = TriangulateFaces::All;
    let repaired = plan.pipeline().run(&soup.mesh()).unwrap();
    assert_eq!(repaired.mesh.counts().faces, 3 * 4 + 3);
}
