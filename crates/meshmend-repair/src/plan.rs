//! A plan file: which passes, in which order, with which options, in TOML.
//!
//! ```toml
//! passes = ["weld", "clean", "orient", "split", "triangulate", "compact", "recompute"]
//! empty = "refuse"                    # allow: a result without a face
//!
//! [weld]
//! distance = { relative = 1e-6 }      # or "exact", "single", { absolute = 0.01 }
//!
//! [clean]
//! non-finite = "drop"                 # keep, fail
//! repeated = "keep-different"         # drop
//!
//! [orient]
//! side = "outward"                    # majority
//! non-orientable = "report"           # cut, fail
//! duplicates = "keep"                 # remove-pair, keep-first
//! flipped-normals = "negate"          # keep
//!
//! [split]
//! edges = "sheets"                    # cut, pinch-only
//!
//! [triangulate]
//! faces = "auto"                      # all
//!
//! [compact]
//! loose-edges = "remove"              # keep
//! ```
//!
//! What is not said has its default. A word that is not known is an error, with its line.

use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::{
    AnyPass, Clean, Compact, Emptying, Orient, PassKind, Pipeline, Recompute, Split, Triangulate, Weld,
};

/// The passes of a pipeline with their options, as a file says them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
pub struct Plan {
    /// The passes, in order.
    pub passes: Vec<PassKind>,
    /// What happens when no face would be left.
    pub empty: Emptying,
    /// Options of `weld`.
    pub weld: Weld,
    /// Options of `clean`.
    pub clean: Clean,
    /// Options of `orient`.
    pub orient: Orient,
    /// Options of `split`.
    pub split: Split,
    /// Options of `triangulate`.
    pub triangulate: Triangulate,
    /// Options of `compact`.
    pub compact: Compact,
    /// Options of `recompute`.
    pub recompute: Recompute,
}

impl Default for Plan {
    fn default() -> Self {
        Plan {
            passes: PassKind::ALL.to_vec(),
            empty: Emptying::default(),
            weld: Weld::default(),
            clean: Clean::default(),
            orient: Orient::default(),
            split: Split::default(),
            triangulate: Triangulate::default(),
            compact: Compact::default(),
            recompute: Recompute::default(),
        }
    }
}

/// Why a text is no plan: the message names the line and the word.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{0}")]
pub struct PlanError(String);

impl Plan {
    /// Reads a plan.
    ///
    /// ```
    /// # use meshmend_repair::{PassKind, Plan};
    /// let plan = Plan::from_toml("passes = [\"weld\", \"compact\"]\n[weld]\ndistance = { absolute = 0.5 }")?;
    /// assert_eq!(plan.passes, [PassKind::Weld, PassKind::Compact]);
    /// assert!(Plan::from_toml("[weld]\ndistnace = \"exact\"").is_err());
    /// # Ok::<(), meshmend_repair::PlanError>(())
    /// ```
    ///
    /// # Errors
    /// When the text is not TOML, or says something that no pass knows.
    pub fn from_toml(text: &str) -> Result<Self, PlanError> {
        toml::from_str(text).map_err(|error| PlanError(error.to_string().trim_end().to_owned()))
    }

    /// Leaves a pass out.
    pub fn without(mut self, pass: PassKind) -> Self {
        self.passes.retain(|&kind| kind != pass);
        self
    }

    /// The pipeline that the plan describes.
    pub fn pipeline(&self) -> Pipeline {
        Pipeline::new(self.passes.iter().map(|&kind| self.pass(kind))).on_emptying(self.empty)
    }

    fn pass(&self, kind: PassKind) -> AnyPass {
        match kind {
            PassKind::Weld => self.weld.clone().into(),
            PassKind::Clean => self.clean.clone().into(),
            PassKind::Orient => self.orient.clone().into(),
            PassKind::Split => self.split.clone().into(),
            PassKind::Triangulate => self.triangulate.clone().into(),
            PassKind::Compact => self.compact.clone().into(),
            PassKind::Recompute => self.recompute.clone().into(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_plan_is_named_with_its_line() {
        let failure = |text| Plan::from_toml(text).unwrap_err().to_string();
        let unknown = failure("passes = [\"weld\"]\n[weld]\ndistnace = \"exact\"");
        assert!(unknown.contains("line 3") && unknown.contains("unknown field `distnace`"), "{unknown}");
        let pass = failure("passes = [\"weld\", \"mend\"]");
        assert!(pass.contains("line 1") && pass.contains("unknown variant `mend`"), "{pass}");
        assert!(failure("passes = [").contains("line 1"));
    }
}
