//! A layout as a picture.

use std::fmt::Write;

use meshmend_core::PolygonMesh;

use crate::Layout;

/// How many units the unit square is wide.
const WIDTH: f64 = 1000.0;

/// The layout as a drawing of its faces, flipped ones red and collapsed ones orange; v runs up.
///
/// *Cost*: linear; about 25 bytes a corner.
pub fn svg(mesh: &PolygonMesh, layout: &Layout) -> String {
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-10 -10 {0} {0}\">\n\
         <style>path{{fill:#dde6f0;stroke:#234;stroke-width:.4;stroke-linejoin:round;vector-effect:non-scaling-stroke}}\
         .flipped{{fill:#d33}}.collapsed{{fill:#e90;stroke:#e90}}</style>\n",
        WIDTH + 20.0
    );
    let faces = mesh.complex().faces();
    for face in faces.faces() {
        let vertices = faces.face_vertices(face);
        if vertices.is_empty() {
            continue;
        }
        let class = if layout.flipped.binary_search(&face).is_ok() {
            " class=\"flipped\""
        } else if layout.collapsed.binary_search(&face).is_ok() {
            " class=\"collapsed\""
        } else {
            ""
        };
        let points = vertices.iter().map(|v| layout.points[v.0 as usize]);
        let places: Vec<String> =
            points.map(|[u, v]| format!("{:.3} {:.3}", u * WIDTH, (1.0 - v) * WIDTH)).collect();
        // Writing to a string does not fail.
        let _ = writeln!(text, "<path{class} d=\"M{}Z\"/>", places.join("L"));
    }
    text + "</svg>\n"
}
