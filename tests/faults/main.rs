//! What goes wrong around meshmend: sinks that fail, kills in the middle of writing, too little memory, calls of the
//! system that fail, and which files it touches at all.
//!
//! `MESHMEND_KILLS` is the number of kills, 50 by default; `MESHMEND_SEED` chooses other instants.
//!
//! * [`sinks`]: a writer over a sink that fails at its n-th operation.
//! * [`kills`]: runs that are killed.
//! * [`memory`]: runs in a small address space.
//! * [`calls`]: which files a run touches, and runs whose n-th call of the system fails, or is their last.

#[cfg(target_os = "linux")]
mod calls;
#[cfg(target_os = "linux")]
mod endless;
#[cfg(unix)]
mod kills;
#[cfg(target_os = "linux")]
mod memory;
#[cfg(target_os = "linux")]
mod signals;
mod sinks;

#[cfg(unix)]
use std::process::{Command, Output, Stdio};

use meshmend_core::PolygonMesh;
use meshmend_io::{Encoding, Format, ReadOptions, WriteOptions, encode, read_bytes};

/// A sheet of squares with corner attributes, groups and a comment, as OBJ; its numbers are not spelled as they are
/// written here, so that writing it again gives other bytes.
fn sheet(squares: usize) -> String {
    let mut text = String::from("# a sheet\nmtllib sheet.mtl\n");
    for i in 0..=squares {
        for j in 0..=squares {
            text += &format!("v {i}.50 {j}.250 {}.0\nvt 0.{i:04} 0.{j:04}0\n", i * j % 7);
        }
    }
    for i in 0..squares {
        text += &format!("g row{}\nusemtl paint{}\n", i % 5, i % 3);
        for j in 0..squares {
            let (a, b) = (i * (squares + 1) + j + 1, (i + 1) * (squares + 1) + j + 1);
            text += &format!("f {a}/{a} {b}/{b} {}/{} {}/{}\n", b + 1, b + 1, a + 1, a + 1);
        }
    }
    text
}

fn sheet_mesh(squares: usize) -> PolygonMesh {
    read_bytes(sheet(squares).as_bytes(), "sheet.obj", &ReadOptions::default()).unwrap().mesh
}

/// Every way to write.
fn forms() -> impl Iterator<Item = (Format, Encoding)> {
    Format::ALL.iter().flat_map(|&format| format.encodings().iter().map(move |&encoding| (format, encoding)))
}

fn encoded(mesh: &PolygonMesh, form: (Format, Encoding)) -> Vec<u8> {
    let mut bytes = Vec::new();
    encode(mesh, &WriteOptions::of(form.0).with_encoding(form.1), &mut bytes).unwrap();
    bytes
}

/// The status of a panic.
#[cfg(target_os = "linux")]
const PANIC: i32 = 101;

#[cfg(unix)]
fn wait(command: &mut Command) -> Output {
    command.stdin(Stdio::null()).output().expect("it starts")
}

#[cfg(unix)]
fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}
