//! Draws surfaces with their loops, witnesses and components into the folder that is its argument.

use std::error::Error;
use std::fs::File;
use std::path::Path;

use meshmend_core::{FaceTableBuilder, PolygonMesh, VertexId};
use meshmend_render::{
    Camera, Fit, Outlines, Overlay, Picture, Scene, Size, boundary, components, contact_sheet, loops, render,
    witness,
};
use meshmend_shapes::{
    Closed, cube, dodecahedron, icosahedron, moebius_band, octahedron, surface, tetrahedron, torus,
};

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args_os().nth(1).ok_or("give a folder to draw into")?;
    let save = |name: &str, picture: Picture| -> Result<(), Box<dyn Error>> {
        let mut file = File::create(Path::new(&folder).join(name))?;
        if name.ends_with(".png") {
            picture.write_png(&mut file)?;
        } else {
            picture.write_svg(&mut file)?;
        }
        Ok(())
    };
    save("torus-loops.svg", loops_of_a_torus()?)?;
    save("genus-4-generators.png", generators_of_genus_four()?)?;
    save("moebius-witness.svg", witness_of_a_band()?)?;
    save("components.svg", solids_by_component()?)
}

/// A torus with its two generators, the tree that they come from, and the tree of the faces.
fn loops_of_a_torus() -> Result<Picture, Box<dyn Error>> {
    let mesh = torus(24, 12)?.mesh;
    let found = loops(&mesh)?;
    let overlays = vec![found.generators, found.tree, found.cotree];
    let scene = Scene { camera: Camera::from_angles(-60.0, 50.0)?, overlays, ..Scene::of(mesh) };
    Ok(render(&scene, Size::new(640, 480)?)?)
}

/// A surface with four handles, once for each of its eight generators.
fn generators_of_genus_four() -> Result<Picture, Box<dyn Error>> {
    let mesh = surface(Closed::Handles(4), 0, 2)?.mesh;
    let Overlay::Generators { loops: paths, .. } = loops(&mesh)?.generators else {
        return Err("no loops".into());
    };
    let camera = Camera::from_angles(-60.0, 50.0)?;
    let scene = |(number, path): (usize, Vec<VertexId>)| Scene {
        camera,
        outlines: Outlines::Drawn,
        caption: Some(format!("generator {number}: {} edges", path.len())),
        overlays: vec![Overlay::Generators { loops: vec![path], more: 0 }],
        ..Scene::of(mesh.clone())
    };
    let scenes: Vec<Scene> = paths.into_iter().enumerate().map(scene).collect();
    Ok(contact_sheet(&scenes, Fit::Together, Size::new(900, 680)?)?)
}

/// A Möbius band with a strip of faces that comes back mirrored.
fn witness_of_a_band() -> Result<Picture, Box<dyn Error>> {
    let mesh = moebius_band(48, 6)?.mesh;
    let overlays = vec![boundary(&mesh), witness(&mesh)];
    let scene = Scene { outlines: Outlines::Drawn, overlays, ..Scene::of(mesh) };
    Ok(render(&scene, Size::new(640, 480)?)?)
}

/// The five regular solids in one mesh.
fn solids_by_component() -> Result<Picture, Box<dyn Error>> {
    let solids = [tetrahedron(), cube(), octahedron(), dodecahedron(), icosahedron()];
    let (mut positions, mut builder) = (Vec::new(), FaceTableBuilder::default());
    for (place, solid) in solids.into_iter().enumerate() {
        let solid = solid?.mesh;
        let (first, shift) = (positions.len() as u32, 3.2 * place as f64);
        let reach = solid.positions().iter().flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
        positions.extend(solid.positions().iter().map(|[x, y, z]| [x / reach + shift, y / reach, z / reach]));
        let faces = solid.faces();
        let vertices = faces.faces().map(|face| faces.face_vertices(face));
        vertices.for_each(|face| builder.push_face(face.iter().map(|v| VertexId(v.0 + first))));
    }
    let faces = builder.build(positions.len())?;
    let mesh = PolygonMesh::new(positions, faces)?;
    let overlays = vec![components(&mesh)];
    let camera = Camera::from([0.4, -1.0, 0.5], [0.0, 0.0, 1.0])?;
    Ok(render(
        &Scene { camera, overlays, outlines: Outlines::Drawn, ..Scene::of(mesh) },
        Size::new(640, 240)?,
    )?)
}
