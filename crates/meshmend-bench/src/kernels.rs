//! What each kernel costs on an indexed mesh, each measured in a process of its own.

use std::collections::BTreeMap;
use std::path::Path;

use cpu_time::ProcessTime;
use meshmend::report::KernelTrial;
use meshmend::{AnyKernel, KernelKind, KernelQuestion};
use serde::{Deserialize, Serialize};

use crate::chart::{Bar, Chart, Group};
use crate::failure::Failure;
use crate::inputs::{Content, Folder, Form, Input, Order, load};
use crate::rows::{own_process, told};

/// What a kernel costs, as a process told.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Trial {
    /// The kernel.
    pub(crate) name: String,
    pub(crate) bytes_a_face: Option<f64>,
    /// For each question, of processor time.
    pub(crate) seconds: BTreeMap<String, f64>,
    pub(crate) refusal: Option<String>,
}

/// The kernels on a mesh in some order.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct Trials {
    pub(crate) order: &'static str,
    pub(crate) faces: u64,
    pub(crate) kernels: Vec<Trial>,
}

/// Measures a kernel on the mesh in a file, in this process.
pub(crate) fn measure(kernel: KernelKind, file: &Path, runs: usize) -> Result<KernelTrial, Failure> {
    let (mesh, start) = (load(file)?, ProcessTime::now());
    let result = AnyKernel::from(kernel).cost(&mesh, runs, &|| start.elapsed());
    Ok(KernelTrial::new(kernel.name(), mesh.complex().proper_face_count(), &result))
}

/// Measures every kernel, each in a process of its own.
pub(crate) fn trials(order: Order, size: usize, runs: usize, folder: &Folder) -> Result<Trials, Failure> {
    let input = Input { content: Content::Indexed, order, faces: size };
    let file = folder.file(&input, Form::PlyBinary)?;
    let trial = |kernel: &KernelKind| {
        let mut child = own_process(1)?;
        child.args(["measure-kernel", kernel.name()]).arg(&file).args(["--runs", &runs.to_string()]);
        told(child, kernel.name())
    };
    let kernels = KernelKind::ALL.iter().map(trial).collect::<Result<_, Failure>>()?;
    Ok(Trials { order: order.name(), faces: input.known().faces, kernels })
}

impl Trials {
    /// As a table in Markdown, times in nanoseconds a face.
    pub(crate) fn table(&self) -> String {
        let names = KernelQuestion::ALL.map(KernelQuestion::name);
        let mut lines = vec![
            format!("{} order, {} faces, ns of processor time a face:", self.order, self.faces),
            String::new(),
            format!("| kernel | B/f | {} |", names.join(" | ")),
            format!("|---|--:|{}", "--:|".repeat(names.len())),
        ];
        lines.extend(self.kernels.iter().map(|trial| {
            let times = names.map(|name| self.nanoseconds(trial, name).map_or("–".to_owned(), short));
            let bytes = trial.bytes_a_face.map_or("refuses".to_owned(), short);
            format!("| {} | {bytes} | {} |", trial.name, times.join(" | "))
        }));
        lines.join("\n") + "\n"
    }

    fn nanoseconds(&self, trial: &Trial, question: &str) -> Option<f64> {
        trial.seconds.get(question).map(|seconds| seconds * 1e9 / self.faces as f64)
    }
}

fn short(figure: f64) -> String {
    format!("{figure:.1}")
}

/// All trials as bars, in a group for each question.
pub(crate) fn chart(trials: &[Trials]) -> Chart {
    let group = |question: &str| {
        let bars = trials.iter().flat_map(|of_order| {
            of_order.kernels.iter().map(move |trial| {
                let value = of_order.nanoseconds(trial, question);
                Bar {
                    label: format!("{}, {}", trial.name, of_order.order),
                    text: value.map_or("refuses".to_owned(), short),
                    is_dark: of_order.order == Order::Mesh.name(),
                    value,
                }
            })
        });
        Group { title: question.to_owned(), bars: bars.collect() }
    };
    let groups = KernelQuestion::ALL.iter().map(|question| group(question.name())).collect();
    let faces = trials.first().map_or(0, |trials| trials.faces);
    Chart { title: format!("ns of processor time a face, {faces} faces"), groups }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_and_the_chart_have_every_kernel_and_question() {
        let folder = Folder::temporary().unwrap();
        let input = Input { content: Content::Indexed, order: Order::Mesh, faces: 5_000 };
        let file = folder.file(&input, Form::PlyBinary).unwrap();
        let kernels = KernelKind::ALL.iter().map(|&kernel| {
            let json = serde_json::to_value(measure(kernel, &file, 1).unwrap()).unwrap();
            serde_json::from_value(json).unwrap()
        });
        let trials = Trials { order: "mesh", faces: 5_000, kernels: kernels.collect() };
        let (table, chart) = (trials.table(), chart(&[trials]));
        for kernel in KernelKind::ALL {
            assert!(table.contains(&format!("\n| {kernel} |")), "{table}");
        }
        assert!(!table.contains('–') && !table.contains("refuses"), "{table}");
        assert_eq!(chart.groups.len(), KernelQuestion::ALL.len());
        assert!(chart.groups.iter().all(|group| group.bars.len() == KernelKind::ALL.len()));
    }
}
