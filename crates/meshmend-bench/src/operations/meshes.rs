//! What is done with a mesh in memory, as the library does it when asked for just that.

use meshmend::mesh::{Build, Connectivity, EdgeUse};
use meshmend::passes::{Clean, Compact, Context, Orient, Split, Weld};
use meshmend::topology::topology;
use meshmend::{CutOptions, Distance, LoopOptions, Pass, Pipeline, PolygonMesh};

use super::{Answer, figures};
use crate::failure::Failure;
use crate::inputs::JITTER;

pub(super) fn weld(mesh: &PolygonMesh) -> Result<Answer, Failure> {
    weld_within(mesh, Distance::Exact)
}

pub(super) fn weld_with_tolerance(mesh: &PolygonMesh) -> Result<Answer, Failure> {
    weld_within(mesh, Distance::Absolute(JITTER))
}

fn weld_within(mesh: &PolygonMesh, distance: Distance) -> Result<Answer, Failure> {
    let welded = Weld::within(distance).apply(mesh, &Context::default())?;
    Ok(Box::new(move || Ok(figures([("vertices", welded.mesh.counts().vertices as u64)]))))
}

pub(super) fn connectivity(mesh: &PolygonMesh) -> Result<Answer, Failure> {
    let kernel = EdgeUse::build(mesh.complex())?;
    Ok(Box::new(move || Ok(figures([("edges", kernel.edge_count() as u64)]))))
}

/// Lists the edges with one face, and those with three or more.
pub(super) fn edges(mesh: &PolygonMesh) -> Result<Answer, Failure> {
    let table = mesh.complex().edges();
    let [mut boundary, mut non_manifold] = [Vec::new(), Vec::new()];
    for edge in table.edges() {
        match table.edge_corners(edge).len() {
            1 => boundary.push(edge),
            2 => {}
            _ => non_manifold.push(edge),
        }
    }
    let counts = [boundary, non_manifold];
    Ok(Box::new(move || {
        let [boundary, non_manifold] = counts.map(|edges| edges.len() as u64);
        Ok(figures([("boundary_edges", boundary), ("non_manifold_edges", non_manifold)]))
    }))
}

pub(super) fn report(mesh: &PolygonMesh) -> Result<Answer, Failure> {
    let found = topology(&EdgeUse::build(mesh.complex())?, mesh);
    Ok(Box::new(move || {
        let genus = found.genus.unwrap_or(u64::MAX);
        Ok(figures([("edges", found.edges), ("components", found.components), ("genus", genus)]))
    }))
}

pub(super) fn orient(mesh: &PolygonMesh) -> Result<Answer, Failure> {
    let oriented = Orient::default().apply(mesh, &Context::default())?.mesh;
    Ok(Box::new(move || {
        let found = topology(&EdgeUse::build(oriented.complex())?, &oriented);
        Ok(figures([("faces", found.faces), ("inconsistent_edges", found.inconsistent_edges)]))
    }))
}

pub(super) fn split(mesh: &PolygonMesh) -> Result<Answer, Failure> {
    let apart = Split::default().apply(mesh, &Context::default())?.mesh;
    Ok(Box::new(move || {
        let found = topology(&EdgeUse::build(apart.complex())?, &apart);
        let vertices = found.non_manifold_vertices;
        Ok(figures([
            ("faces", found.faces),
            ("non_manifold_edges", found.non_manifold_edges),
            ("non_manifold_vertices", vertices.pinched + vertices.singular),
        ]))
    }))
}

pub(super) fn clean(mesh: &PolygonMesh) -> Result<Answer, Failure> {
    let cleaned = Pipeline::new([Clean::default().into(), Compact::default().into()]).run(mesh)?.mesh;
    Ok(Box::new(move || {
        let counts = cleaned.counts();
        Ok(figures([("vertices", counts.vertices as u64), ("faces", counts.faces as u64)]))
    }))
}

pub(super) fn generators(mesh: &PolygonMesh) -> Result<Answer, Failure> {
    let found = meshmend::loops(mesh, &LoopOptions::default())?.generators;
    Ok(Box::new(move || {
        let count: usize = found.components().iter().map(|component| component.generators.len()).sum();
        Ok(figures([("generators", count as u64)]))
    }))
}

pub(super) fn cut(mesh: &PolygonMesh) -> Result<Answer, Failure> {
    let disc = meshmend::cut(mesh, &CutOptions::default())?.discs.mesh;
    Ok(Box::new(move || {
        let found = topology(&EdgeUse::build(disc.complex())?, &disc);
        let euler_characteristic = u64::try_from(found.euler_characteristic).unwrap_or(u64::MAX);
        let boundary_loops = found.boundary_loops.unwrap_or(u64::MAX);
        Ok(figures([
            ("faces", found.faces),
            ("euler_characteristic", euler_characteristic),
            ("boundary_loops", boundary_loops),
        ]))
    }))
}
