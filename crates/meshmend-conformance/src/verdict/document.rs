//! Verdicts as JSON. The fields are in the order of the alphabet, and so are the keys.

use serde::Serialize;

use super::verdicts::{Meshes, Outcome, Verdict, Verdicts};

/// All verdicts on a kernel.
#[derive(Serialize)]
struct Document<'a> {
    kernel: &'a str,
    laws: Vec<LawDocument<'a>>,
    schema: u32,
}

/// The verdict on a law.
#[derive(Serialize)]
struct LawDocument<'a> {
    expected: Option<&'a str>,
    found: Option<&'a str>,
    kernel: &'a str,
    law: &'a str,
    meshes: Meshes,
    message: Option<String>,
    schema: u32,
    smallest: Option<Mesh<'a>>,
    verdict: Outcome,
}

#[derive(Serialize)]
struct Mesh<'a> {
    faces: &'a [Vec<u32>],
    vertex_count: usize,
}

const SCHEMA: u32 = 1;

impl Verdicts {
    /// All verdicts as one JSON document, its keys sorted.
    pub fn document(&self) -> String {
        let laws = self.each.iter().map(|verdict| of_law(self, verdict)).collect();
        printed(&Document { kernel: self.kernel, laws, schema: SCHEMA })
    }
}

/// The verdict on one law as a document.
pub(super) fn law_document(verdicts: &Verdicts, verdict: &Verdict) -> String {
    printed(&of_law(verdicts, verdict))
}

fn of_law<'a>(verdicts: &'a Verdicts, verdict: &'a Verdict) -> LawDocument<'a> {
    let finding = verdict.finding.as_ref();
    let example = finding.map(|finding| &finding.example).filter(|example| example.is_mesh());
    LawDocument {
        expected: finding.and_then(|finding| finding.expected.as_deref()),
        found: finding.map(|finding| finding.found.as_str()),
        kernel: verdicts.kernel,
        law: verdict.law.id,
        meshes: verdicts.meshes,
        message: verdict.message(),
        schema: SCHEMA,
        smallest: example.map(|example| Mesh { faces: &example.faces, vertex_count: example.vertex_count }),
        verdict: verdict.outcome,
    }
}

fn printed(document: &impl Serialize) -> String {
    // Strings, numbers and lists can be written.
    serde_json::to_string_pretty(document).unwrap_or_default() + "\n"
}
