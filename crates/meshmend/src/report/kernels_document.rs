//! The document of what each kernel costs on a mesh.

use std::collections::BTreeMap;

use meshmend_core::{Array, Refusal};
use serde::Serialize;

use super::SCHEMA;
use crate::{AnyView, KernelCost, KernelQuestion, Rung};

/// What each structure costs on a mesh, or why it refuses.
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
    /// The structures that say less than a kernel.
    pub views: Vec<KernelTrial>,
}

/// What a structure costs on a mesh, or why it refuses.
#[derive(Clone, Debug, Serialize)]
pub struct KernelTrial {
    /// The structure's name.
    pub name: &'static str,
    /// How much it can say.
    pub rung: Rung,
    /// The questions that it answers.
    pub answers: Vec<KernelQuestion>,
    /// Bytes on the heap for each proper face; absent where it refuses.
    pub bytes_a_face: Option<f64>,
    /// The arrays that it consists of.
    pub arrays: Vec<Array>,
    /// The least time for each question that was asked; empty if the structure refuses the mesh.
    pub seconds: BTreeMap<KernelQuestion, f64>,
    /// The questions that were not asked, since they take it quadratic time and the mesh is large.
    pub linear: Vec<KernelQuestion>,
    /// Why it refuses, if it does.
    pub refusal: Option<String>,
}

impl KernelTrial {
    /// What came of measuring a kernel on a mesh of so many proper faces.
    pub fn new(name: &'static str, faces: usize, result: &Result<KernelCost, Refusal>) -> Self {
        let trial = Self::unmeasured(name, Rung::Connectivity);
        match result {
            Err(refusal) => KernelTrial { refusal: Some(refusal.to_string()), ..trial },
            Ok(cost) => trial.measured(faces, cost),
        }
    }

    /// What came of measuring a view on a mesh of so many proper faces.
    pub fn of_view(view: &AnyView, faces: usize, cost: &KernelCost) -> Self {
        Self::unmeasured(view.name, view.rung).measured(faces, cost)
    }

    fn unmeasured(name: &'static str, rung: Rung) -> Self {
        KernelTrial {
            name,
            rung,
            answers: KernelQuestion::ALL.into_iter().filter(|question| question.rung() <= rung).collect(),
            bytes_a_face: None,
            arrays: Vec::new(),
            seconds: BTreeMap::new(),
            linear: Vec::new(),
            refusal: None,
        }
    }

    fn measured(self, faces: usize, cost: &KernelCost) -> Self {
        let seconds = |question| Some((question, cost.time(question)?.as_secs_f64()));
        KernelTrial {
            bytes_a_face: Some(cost.heap_bytes as f64 / faces.max(1) as f64),
            arrays: cost.arrays.clone(),
            seconds: KernelQuestion::ALL.into_iter().filter_map(seconds).collect(),
            linear: self.answers.iter().copied().filter(|&question| cost.time(question).is_none()).collect(),
            ..self
        }
    }
}

impl KernelsDocument {
    /// The document of some trials.
    pub fn new(faces: usize, runs: usize, kernels: Vec<KernelTrial>, views: Vec<KernelTrial>) -> Self {
        KernelsDocument { schema: SCHEMA, file: None, faces, runs, kernels, views }
    }
}
