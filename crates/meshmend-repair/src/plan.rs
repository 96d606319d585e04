//! A plan file: which passes, in which order, with which options, in TOML.
//!
//! ```toml
//! passes = ["weld", "clean", "orient", "split", "triangulate", "compact", "verify"]
//! empty = "refuse"                    # allow: a result without a face
//! fail-on = ["boundary-edge"]         # what fails a run of the command line; by default nothing
//! seams = "split"                     # corners, fail: how the command line writes vertices whose attributes differ
//! limit = 10                          # how many items each list of its report shows
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
//! [heal]                              # only where `passes` names it
//! within = "exact"                    # { absolute = 0.01 }, { relative = 1e-6 }
//!
//! [split]
//! edges = "sheets"                    # cut, pinch-only
//!
//! [triangulate]
//! faces = "auto"                      # all
//!
//! [slivers]                           # only where `passes` names it
//! aspect = 1000.0                     # a triangle so many times as long as it is high
//! max-move = { relative = 1e-6 }      # { absolute = 0.01 }
//!
//! [compact]
//! loose-edges = "remove"              # keep
//! ```
//!
//! What is not said has its default. A word that is not known is an error, with its line.

mod files;
mod form;
mod order;
mod saying;
mod words;

pub use self::files::{FilePolicies, WrittenSeams};
pub use self::saying::{Said, SayingError};

use serde::Serialize;
use serde::de::DeserializeSeed;
use thiserror::Error;
use toml::Value;

use self::form::PlanOf;
use crate::{AnyPass, PassKind, Passes, Pipeline, Plan};

impl Default for Plan {
    fn default() -> Self {
        Plan::of(Passes::builtin())
    }
}

/// Why a text is not a plan, or a pass can't be what is asked for. The message of a text names the line and the word.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{0}")]
pub struct PlanError(String);

impl PlanError {
    pub(crate) fn new(reason: String) -> Self {
        PlanError(reason)
    }
}

impl Plan {
    /// The plan of the passes that run by default, with their defaults.
    pub fn of(passes: Passes) -> Self {
        let kinds = passes.kinds();
        Plan::running(kinds.into_iter().filter(|kind| kind.row().is_default).collect())
    }

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
    /// When the text is not TOML, says something that no pass knows, or is refused by [`check_order`](Self::check_order).
    pub fn from_toml(text: &str) -> Result<Self, PlanError> {
        Plan::from_toml_with(text, Passes::builtin())
    }

    /// Reads a plan that may name these passes.
    ///
    /// # Errors
    /// As [`from_toml`](Self::from_toml).
    pub fn from_toml_with(text: &str, passes: Passes) -> Result<Self, PlanError> {
        let plan = Plan::read(text, passes)?;
        plan.check_order()?;
        Ok(plan)
    }

    /// Reads what a plan says, whether its passes may stand together or not.
    pub(crate) fn read(text: &str, passes: Passes) -> Result<Self, PlanError> {
        let read =
            toml::Deserializer::parse(text).and_then(|deserializer| PlanOf(passes).deserialize(deserializer));
        read.map_err(|error| PlanError(error.to_string().trim_end().to_owned()))
    }

    /// The plan as a TOML text, which [`from_toml`](Self::from_toml) reads back as the same plan.
    ///
    /// # Errors
    /// When an option of a pass of another crate is no TOML.
    pub fn to_toml(&self) -> Result<String, PlanError> {
        toml::to_string(self).map_err(|error| PlanError(error.to_string()))
    }

    /// Leaves a pass out.
    pub fn without(mut self, pass: PassKind) -> Self {
        self.passes.retain(|&kind| kind != pass);
        self
    }

    /// Has a pass run: where it does, or at its usual place.
    pub fn with(mut self, pass: PassKind) -> Self {
        if !self.passes.contains(&pass) {
            self.passes.insert(pass.usual_place(self.passes.iter().copied()), pass);
        }
        self
    }

    /// Sets an option of a pass to what a plan file would say.
    ///
    /// # Errors
    /// When the pass does not have the option, or the option can't be that.
    pub fn set(&mut self, kind: PassKind, key: &str, value: impl Serialize) -> Result<(), PlanError> {
        let form = kind.row().form;
        let read = || {
            let mut options = form.write(self.pass(kind).as_pass())?;
            options.insert(key.to_owned(), Value::try_from(value).map_err(|error| error.to_string())?);
            form.read(options)
        };
        let pass = read().map_err(|reason| PlanError(format!("{kind}: {reason}")))?;
        self.put(pass);
        Ok(())
    }

    /// The pipeline that the plan describes.
    pub fn pipeline(&self) -> Pipeline {
        Pipeline::new(self.passes.iter().map(|&kind| self.pass(kind))).on_emptying(self.empty)
    }

    /// A pass with its options.
    fn pass(&self, kind: PassKind) -> AnyPass {
        let own = || self.own.iter().find(|pass| pass.kind() == kind).cloned().map(AnyPass::Own);
        self.builtin(kind).or_else(own).unwrap_or_else(|| kind.with_defaults())
    }

    fn put(&mut self, pass: AnyPass) {
        if let Some(own) = self.set_builtin(pass) {
            self.own.retain(|pass| pass.kind() != own.kind());
            self.own.push(own);
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
        assert!(pass.contains("line 1") && pass.contains("there is no pass `mend`"), "{pass}");
        let key = failure("empty = \"allow\"\n[mend]\n");
        assert!(key.contains("line 2") && key.contains("there is no pass `mend`"), "{key}");
        assert!(failure("passes = [").contains("line 1"));
    }

    #[test]
    fn the_former_name_of_verify_is_still_read() {
        let plan = Plan::from_toml("passes = ['weld', 'recompute']\n[recompute]").unwrap();
        assert_eq!(plan.passes, [PassKind::Weld, PassKind::Verify]);
        assert!(plan.to_toml().unwrap().contains("\"verify\""));
        assert_eq!(Plan::from_toml(&plan.to_toml().unwrap()), Ok(plan));
    }

    #[test]
    fn a_pass_that_a_plan_leaves_out_comes_back_at_its_place() {
        let plan = Plan::from_toml("passes = ['weld', 'compact']").unwrap();
        let plan = plan.with(PassKind::Orient).with(PassKind::Verify).with(PassKind::Weld);
        let expected = [PassKind::Weld, PassKind::Orient, PassKind::Compact, PassKind::Verify];
        assert_eq!(plan.passes, expected);
    }

    #[test]
    fn a_pass_that_needs_another_one_before_it_is_refused_without_it() {
        let failure = |passes: &str| Plan::from_toml(&format!("passes = {passes}")).unwrap_err().to_string();
        assert!(failure("['weld', 'heal']").starts_with("`heal` needs `orient` before it"));
        assert!(failure("['heal', 'orient']").starts_with("`heal` needs `orient` before it"));
        assert!(failure("['orient', 'heal', 'heal']").starts_with("`heal` stands in a plan once"));
        assert!(Plan::from_toml("passes = ['orient', 'heal']").is_ok());
        let opened = "passes = ['fill', 'drop']\n[drop]\ninternal = 'remove-faces'";
        assert!(Plan::from_toml(opened).unwrap_err().to_string().starts_with("`fill` would close again"));
        assert!(Plan::from_toml(&opened.replace("faces'", "components'")).is_ok());
        let crowded = "passes = ['split', 'fill']\n[split]\nedges = 'pinch-only'";
        assert!(
            Plan::from_toml(crowded).unwrap_err().to_string().starts_with("`fill` needs edges of two sides")
        );
        assert!(failure("['orient', 'apart']").starts_with("`apart` needs `weld` before it"));
        assert!(failure("['slivers', 'triangulate']").starts_with("`slivers` mends triangles"));
        assert!(Plan::from_toml("passes = ['triangulate', 'slivers']").is_ok());
        assert!(Plan::from_toml("passes = ['slivers', 'compact']").is_ok());
    }

    #[test]
    fn an_option_is_set_as_a_file_would() {
        let mut plan = Plan::default();
        plan.set(PassKind::Orient, "side", "outward").unwrap();
        assert_eq!(plan, Plan::from_toml("[orient]\nside = 'outward'").unwrap());
        let unknown = plan.set(PassKind::Orient, "side", "inward").unwrap_err().to_string();
        assert!(unknown.starts_with("orient: unknown variant `inward`"), "{unknown}");
        let unknown = plan.set(PassKind::Verify, "side", "outward").unwrap_err().to_string();
        assert!(unknown.starts_with("verify: unknown field `side`"), "{unknown}");
    }
}
