//! The document of what each kernel costs on a mesh.

use std::collections::BTreeMap;

use meshmend_core::Refusal;
use meshmend_kernels::KernelKind;
use serde::Serialize;

use super::SCHEMA;
use crate::{KernelCost, KernelQuestion};

/// What each kernel costs on a mesh, or why it refuses.
#[derive(Clone, Debug, Serialize)]
pub struct KernelsDocument {
    /// The number of this form.
    pub schema: u32,
    /// The file that the mesh is from, if it is from one.
    pub file: Option<String>,
    /// How many proper faces the mesh has.
    pub faces: usize,
    /// Of how many runs each time is the least.
    pub runs: usize,
    /// The kernels, in the order of the registry.
    pub kernels: Vec<KernelTrial>,
}

/// What a kernel costs on a mesh, or why it refuses.
#[derive(Clone, Debug, Serialize)]
pub struct KernelTrial {
    /// The kernel's name.
    pub name: &'static str,
    /// Bytes on the heap for each proper face; absent where it refuses.
    pub bytes_a_face: Option<f64>,
    /// The least time for each question; empty if the kernel refuses the mesh.
    pub seconds: BTreeMap<KernelQuestion, f64>,
    /// Why it refuses, if it does.
    pub refusal: Option<String>,
}

impl KernelTrial {
    /// What came of measuring a kernel on a mesh of so many proper faces.
    pub fn new(kernel: KernelKind, faces: usize, result: &Result<KernelCost, Refusal>) -> Self {
        let seconds = |cost: &KernelCost| {
            KernelQuestion::ALL.map(|question| (question, cost.time(question).as_secs_f64())).into()
        };
        KernelTrial {
            name: kernel.name(),
            bytes_a_face: result.as_ref().ok().map(|cost| cost.heap_bytes as f64 / faces.max(1) as f64),
            seconds: result.as_ref().map(seconds).unwrap_or_default(),
            refusal: result.as_ref().err().map(ToString::to_string),
        }
    }
}

impl KernelsDocument {
    /// The document of some trials.
    pub fn new(faces: usize, runs: usize, kernels: Vec<KernelTrial>) -> Self {
        KernelsDocument { schema: SCHEMA, file: None, faces, runs, kernels }
    }
}
