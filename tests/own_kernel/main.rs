//! A kernel of one's own, outside the crates of meshmend: one file and one row. The laws of kernels hold for it, and every
//! question gives the answer that it gives on meshmend's own.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "these are tests")]

use meshmend_core::{Build, Connectivity, EdgeUse};
use meshmend_testkit::{Soup, laws, shapes, worlds};
use meshmend_tests::contributing::Example;
use meshmend_topology::topology;
use proptest::prelude::*;

/// What is done with each kernel.
trait Task {
    fn run<K: Connectivity>(&self) -> Result<(), String>;
}

macro_rules! own_kernels {
    ($($file:ident)*) => {
        $(mod $file;)*

        fn with_each(task: &impl Task) -> Result<(), String> {
            $(task.run::<$file::Kernel>()?;)*
            Ok(())
        }
    };
}

own_kernels! {
    corner_scan
}

/// The laws, and the topology of a mesh, which is to the letter that of the default kernel.
struct Questions<'a>(&'a Soup);

impl Task for Questions<'_> {
    fn run<K: Connectivity>(&self) -> Result<(), String> {
        let mesh = self.0.mesh();
        laws::kernel_laws::<K>(mesh.complex())?;
        let Ok(kernel) = K::build(mesh.complex()) else { return Ok(()) };
        let [own, usual] = [
            format!("{:?}", topology(&kernel, &mesh)),
            format!("{:?}", topology(&EdgeUse::assemble(mesh.complex()), &mesh)),
        ];
        if own == usual { Ok(()) } else { Err(format!("{}: {own}\nis not\n{usual}", K::NAME)) }
    }
}

#[test]
fn shapes_with_known_answers() {
    for shape in shapes::catalogue().iter().filter(|shape| shape.soup.faces.len() < 200) {
        assert_eq!(with_each(&Questions(&shape.soup)), Ok(()), "{}", shape.name);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(300) })]
    #[test]
    fn random_meshes(soup in worlds::any_table(8)) {
        prop_assert_eq!(with_each(&Questions(&soup)), Ok(()));
    }
}

fn example() -> Example {
    Example::beside_main("tests/own_kernel", "own_kernels")
}

#[test]
fn the_diff_that_is_shown_is_true() {
    example().assert_shown();
}

#[test]
fn a_kernel_is_one_file_and_one_row() {
    example().assert_said_nowhere_else(&[]);
}
