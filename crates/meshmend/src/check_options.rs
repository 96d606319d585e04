//! How a mesh is checked.

use meshmend_core::{Rules, Watch};
use meshmend_topology::Witness;

use crate::geometry_questions::GeometryOptions;
use crate::{AnyKernel, Kernels, View};

/// How to check.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct CheckOptions {
    /// Whether the mesh is judged as stored or as welded.
    pub view: View,
    /// The kernel to compute on.
    pub kernel: AnyKernel,
    /// Of which kernels it is told whether they hold the mesh.
    pub kernels: Kernels,
    /// Which strip of faces shows that a patch is not orientable.
    pub witness: Witness,
    /// Which kinds of defect are looked for.
    pub rules: Rules,
    /// What is asked about where the faces lie, if anything is.
    pub geometry: Option<GeometryOptions>,
    /// Who watches, and may stop it.
    pub watch: Watch,
}

impl CheckOptions {
    /// These options with this view of the mesh.
    #[must_use]
    pub fn with_view(self, view: View) -> Self {
        CheckOptions { view, ..self }
    }

    /// These options with this kernel to compute on.
    #[must_use]
    pub fn with_kernel(self, kernel: impl Into<AnyKernel>) -> Self {
        CheckOptions { kernel: kernel.into(), ..self }
    }

    /// These options with these kernels, of which it is told whether they hold the mesh.
    #[must_use]
    pub fn with_kernels(self, kernels: Kernels) -> Self {
        CheckOptions { kernels, ..self }
    }

    /// These options with this strip of faces as a witness.
    #[must_use]
    pub fn with_witness(self, witness: Witness) -> Self {
        CheckOptions { witness, ..self }
    }

    /// These options with these kinds of defect.
    #[must_use]
    pub fn with_rules(self, rules: Rules) -> Self {
        CheckOptions { rules, ..self }
    }

    /// These options with questions about where the faces lie; with `None` nothing is asked about that.
    #[must_use]
    pub fn with_geometry(self, geometry: impl Into<Option<GeometryOptions>>) -> Self {
        CheckOptions { geometry: geometry.into(), ..self }
    }

    /// These options for a check that is watched.
    #[must_use]
    pub fn with_watch(self, watch: &Watch) -> Self {
        CheckOptions { watch: watch.clone(), ..self }
    }
}
