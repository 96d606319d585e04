//! The README's table of kernels is made of what the kernels say of themselves.
//!
//! `MESHMEND_WRITE=1 cargo test -p meshmend --test kernel_table` writes it anew.

#![allow(clippy::expect_used, reason = "a test stops where it fails")]

use std::fs;
use std::path::Path;

use meshmend::mesh::{Array, Capabilities, PolygonMesh};
use meshmend::shapes::torus;
use meshmend::{AnyView, Kernels};

/// Between these lines of the README stands the table.
const BEGIN: &str = "<!-- kernels: made by crates/meshmend/tests/kernel_table.rs -->\n";
const END: &str = "<!-- end of kernels -->\n";

fn table(mesh: &PolygonMesh) -> String {
    let faces = mesh.counts().faces as f64;
    let row = |name: &str, arrays: &[Array], holds: String| {
        let bytes: usize = arrays.iter().map(Array::bytes).sum();
        let mut names: Vec<&str> =
            arrays.iter().filter(|array| array.count > 1).map(|array| array.name).collect();
        names.dedup();
        format!("| {name} | {} | {holds} | {:.0} |\n", names.join(", "), bytes as f64 / faces)
    };
    let kernels = Kernels::builtin().all().map(|kernel| {
        let arrays = kernel.arrays(mesh.complex()).expect("every kernel holds a torus of triangles");
        row(kernel.name, &arrays, holds(&kernel.capabilities))
    });
    let views = AnyView::ALL.into_iter().map(|view| {
        let cost = view.cost(mesh, 1, &|| std::time::Duration::ZERO);
        row(
            view.name,
            &cost.arrays,
            format!("anything, but says less: {}", view.rung.lacks().unwrap_or_default()),
        )
    });
    let heading = "| structure | arrays | holds | bytes a triangle |\n|---|---|---|--:|\n".to_owned();
    std::iter::once(heading).chain(kernels).chain(views).collect()
}

fn holds(able: &Capabilities) -> String {
    let needs = able.needs();
    if needs.is_empty() { "anything".to_owned() } else { needs.join(", ") }
}

#[test]
fn the_readme_has_the_table_of_the_kernels_as_they_are() {
    let quads = torus(120, 100).expect("a torus of that size is made");
    let mesh = quads.triangulated().expect("its faces are convex").mesh;
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../README.md");
    let readme = fs::read_to_string(&path).expect("the README is there");
    let (before, rest) = readme.split_once(BEGIN).expect("the README has a place for the table");
    let (shown, after) = rest.split_once(END).expect("the table has an end");
    let table = format!("\n{}\n", table(&mesh));
    if std::env::var_os("MESHMEND_WRITE").is_some() {
        fs::write(&path, [before, BEGIN, &table, END, after].concat()).expect("the README can be written");
        return;
    }
    assert_eq!(shown, table, "write it anew: MESHMEND_WRITE=1 cargo test -p meshmend --test kernel_table");
}
