//! Plans: passes, their order and options.

use std::sync::Arc;

use meshmend::passes::{Emptying, PRESETS, Passes, Preset, Said, SayingError};
use meshmend::{PassKind, Plan};
use pyo3::prelude::*;

use crate::errors::{self, Done, Problem};
use crate::{repair, words};

/// A plan.
#[pyclass(frozen, module = "meshmend._native")]
pub(crate) struct PlanHandle {
    pub(crate) plan: Arc<Plan>,
}

#[pymethods]
impl PlanHandle {
    /// The plan of some passes, each with its defaults; else of those that usually run.
    #[new]
    #[pyo3(signature = (passes=None))]
    fn new(py: Python<'_>, passes: Option<Vec<String>>) -> PyResult<Self> {
        let Some(passes) = passes else { return Ok(PlanHandle::of(Plan::default())) };
        let kinds = passes.iter().map(|word| pass(word)).collect::<Done<Vec<_>>>();
        let plan = Plan { passes: errors::raise(py, kinds)?, ..Plan::default() };
        errors::raise(py, plan.check_order().map_err(Problem::Plan))?;
        Ok(PlanHandle::of(plan))
    }

    /// The plan that a TOML text says.
    #[staticmethod]
    fn from_toml(py: Python<'_>, text: &str) -> PyResult<Self> {
        errors::raise(py, Plan::from_toml(text).map(PlanHandle::of).map_err(Problem::Plan))
    }

    /// The plan for a purpose, with what a TOML text says in place of what it says itself.
    #[staticmethod]
    fn preset(py: Python<'_>, name: &str, over: Option<&str>) -> PyResult<Self> {
        let known = PRESETS.iter().map(|preset| preset.name);
        let preset = Preset::from_name(name).ok_or_else(|| words::unknown("preset", name, known));
        let preset = errors::raise(py, preset)?;
        let plan = preset.plan(over, Passes::builtin()).map(PlanHandle::of);
        errors::raise(py, plan.map_err(Problem::Plan))
    }

    /// The plan with options, as words of the command line.
    fn saying(&self, py: Python<'_>, said: Vec<(String, String)>, allow_empty: bool) -> PyResult<Self> {
        let plan = saying(&self.plan, &said, allow_empty);
        errors::raise(py, plan.map(PlanHandle::of))
    }

    fn to_toml(&self, py: Python<'_>) -> PyResult<String> {
        let text = self.plan.to_toml();
        errors::written(py, text)
    }

    /// How vertices are written whose attributes differ from face to face, if the plan says it.
    fn seams(&self) -> Option<&'static str> {
        self.plan.files.seams.and_then(repair::seams).map(|(word, _)| word)
    }

    fn passes(&self) -> Vec<&'static str> {
        self.plan.passes.iter().map(|pass| pass.name()).collect()
    }

    #[pyo3(name = "is_")]
    fn is(&self, other: &PlanHandle) -> bool {
        self.plan == other.plan
    }
}

impl PlanHandle {
    fn of(plan: Plan) -> Self {
        PlanHandle { plan: Arc::new(plan) }
    }
}

/// A plan with options.
pub(crate) fn saying(plan: &Plan, said: &[(String, String)], allow_empty: bool) -> Done<Plan> {
    let said = said.iter().map(|(option, word)| Said::new(Passes::builtin(), option, word));
    let said = said.collect::<Result<Vec<_>, SayingError>>()?;
    let mut plan = plan.clone();
    if allow_empty {
        plan.empty = Emptying::Allow;
    }
    Ok(plan.saying(&said)?)
}

fn pass(word: &str) -> Done<PassKind> {
    let kinds = Passes::builtin().kinds();
    let found = kinds.iter().copied().find(|kind| kind.name() == word);
    found.ok_or_else(|| words::unknown("a pass", word, kinds.iter().map(|kind| kind.name())))
}
