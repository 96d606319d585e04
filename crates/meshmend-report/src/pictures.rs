//! Still pictures of a mesh: what the page shows where there is no 3D, and on paper.

use std::io;

use meshmend::PolygonMesh;
use meshmend::formats::base64;
use meshmend_render::{Outlines, Picture, Scene, Size};

/// Up to so many faces a picture is one of lines, which stays sharp however it is printed.
const MOST_LINES: usize = 2_000;
/// Up to so many faces the edges are drawn.
const MOST_OUTLINED: usize = 20_000;
const SIZE: (u32, u32) = (720, 480);

/// The pictures of a mesh with what may be wrong on it, as URIs of their data. A mesh that can't be drawn has none.
pub(crate) fn pictures(mesh: &PolygonMesh) -> Vec<String> {
    drawn(mesh).into_iter().collect()
}

fn drawn(mesh: &PolygonMesh) -> Option<String> {
    let faces = mesh.faces().face_count();
    let overlays = vec![
        meshmend_render::boundary(mesh),
        meshmend_render::non_manifold(mesh),
        meshmend_render::inconsistent(mesh),
        meshmend_render::witness(mesh),
    ];
    let outlines = if faces <= MOST_OUTLINED { Outlines::Drawn } else { Outlines::Omitted };
    let scene = Scene { overlays, outlines, ..Scene::of(mesh.clone()) };
    let picture = meshmend_render::render(&scene, Size::new(SIZE.0, SIZE.1).ok()?).ok()?;
    uri(&picture, faces <= MOST_LINES).ok()
}

fn uri(picture: &Picture, is_of_lines: bool) -> io::Result<String> {
    let mut bytes = Vec::new();
    let kind = if is_of_lines {
        picture.write_svg(&mut bytes)?;
        "svg+xml"
    } else {
        picture.write_png(&mut bytes)?;
        "png"
    };
    Ok(format!("data:image/{kind};base64,{}", base64(&bytes)))
}
