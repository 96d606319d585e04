//! What is done with files, as the command line does it.

use std::path::Path;

use meshmend::mesh::{Build, EdgeUse};
use meshmend::topology::topology;
use meshmend::{Distance, Plan, PolygonMesh, ReadOptions, View, WriteOptions, read, write};

use super::{Answer, figures};
use crate::failure::Failure;
use crate::inputs::Form;

pub(super) fn read_file(file: &Path, _: &Path) -> Result<Answer, Failure> {
    let mesh = read(file, &ReadOptions::default())?.mesh;
    Ok(counts(mesh))
}

pub(super) fn read_welded(file: &Path, _: &Path) -> Result<Answer, Failure> {
    let mesh = View::Welded(Distance::Exact).of(&read(file, &ReadOptions::default())?.mesh)?;
    Ok(counts(mesh))
}

pub(super) fn write_file(mesh: &PolygonMesh, form: Form, scratch: &Path) -> Result<Answer, Failure> {
    let file = scratch.join(format!("written.{}", form.extension()));
    write(&file, mesh, &form.options())?;
    Ok(Box::new(move || counts(read(&file, &ReadOptions::default())?.mesh)()))
}

/// `meshmend repair --quiet IN -o OUT.ply`.
pub(super) fn process(file: &Path, scratch: &Path) -> Result<Answer, Failure> {
    let output = scratch.join("processed.ply");
    let stored = read(file, &ReadOptions::default())?.mesh;
    let repaired = Plan::default().pipeline().run(&stored)?;
    write(&output, &repaired.mesh, &WriteOptions::default())?;
    Ok(Box::new(move || {
        let mesh = read(&output, &ReadOptions::default())?.mesh;
        let found = topology(&EdgeUse::build(mesh.complex())?, &mesh);
        Ok(figures([
            ("vertices", mesh.counts().vertices as u64),
            ("faces", mesh.counts().faces as u64),
            ("inconsistent_edges", found.inconsistent_edges),
            ("non_manifold_edges", found.non_manifold_edges),
        ]))
    }))
}

fn counts(mesh: PolygonMesh) -> Answer {
    Box::new(move || {
        let counts = mesh.counts();
        Ok(figures([("vertices", counts.vertices as u64), ("faces", counts.faces as u64)]))
    })
}
