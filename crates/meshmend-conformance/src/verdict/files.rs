//! The files of verdicts.

use std::fmt::Write;
use std::fs;
use std::path::PathBuf;

use super::document::law_document;
use super::verdicts::Verdicts;
use crate::Soup;
use crate::laws::Law;
use crate::run::{Example, file_name, output};

/// Where the mesh is that breaks a law.
pub(super) fn picture(verdicts: &Verdicts, law: &Law) -> PathBuf {
    folder(verdicts).join(format!("{}.obj", law.id))
}

fn folder(verdicts: &Verdicts) -> PathBuf {
    output().join(file_name(verdicts.kernel))
}

impl Verdicts {
    /// Writes each verdict as JSON, and each mesh that breaks a law as OBJ; a mesh of an earlier run goes.
    pub(crate) fn write(&self) {
        write(self);
    }
}

fn write(verdicts: &Verdicts) {
    let folder = folder(verdicts);
    // Verdicts are told whether or not there is room for files.
    let _ = fs::create_dir_all(&folder);
    for verdict in &verdicts.each {
        let (law, obj) = (verdict.law, picture(verdicts, verdict.law));
        let _ = fs::write(folder.join(format!("{}.json", law.id)), law_document(verdicts, verdict));
        let example = verdict.finding.as_ref().map(|finding| &finding.example);
        let _ = match example.filter(|example| example.is_mesh()) {
            Some(example) => fs::write(obj, wavefront(example)),
            None => fs::remove_file(obj),
        };
    }
}

/// The mesh as OBJ, its vertices in general position.
fn wavefront(example: &Example) -> String {
    let soup = Soup::generic(example.vertex_count, &example.faces);
    let mut text = String::new();
    for [x, y, z] in &soup.positions {
        // Writing to a string can't fail.
        let _ = writeln!(text, "v {x} {y} {z}");
    }
    for face in &soup.faces {
        let corners: Vec<String> = face.iter().map(|vertex| (vertex + 1).to_string()).collect();
        let _ = writeln!(text, "f {}", corners.join(" "));
    }
    text
}
