//! Plans for common purposes, as texts that can be printed, changed and given back.

use toml::Table;

use crate::{Passes, Plan, PlanError};

/// A plan for a common purpose.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Preset {
    /// Its name.
    pub name: &'static str,
    /// What it is for, in a few words.
    pub purpose: &'static str,
    /// The plan, with its reasons as comments.
    pub toml: &'static str,
}

/// All presets.
pub const PRESETS: [Preset; 4] = [
    Preset {
        name: "asset",
        purpose: "Assets of games and films: nothing that a model shows may change",
        toml: include_str!("presets/asset.toml"),
    },
    Preset {
        name: "print",
        purpose: "Solids for printing: closed, triangles alone, turned outward",
        toml: include_str!("presets/print.toml"),
    },
    Preset {
        name: "scan",
        purpose: "Scans: seams are closed where a tolerance stands out, holes stay",
        toml: include_str!("presets/scan.toml"),
    },
    Preset {
        name: "teaching",
        purpose: "Courses: one pass, and all of what it did",
        toml: include_str!("presets/teaching.toml"),
    },
];

impl Preset {
    /// A preset by its name.
    pub fn from_name(name: &str) -> Option<Self> {
        PRESETS.into_iter().find(|preset| preset.name == name)
    }

    /// The plan, with what another plan file says in place of what it says itself. An option of a pass overrides that option, and
    /// a list that list.
    ///
    /// ```
    /// use meshmend_repair::{Distance, Passes, Preset};
    ///
    /// let print = Preset::from_name("print").ok_or("it is one")?;
    /// let plan = print.plan(Some("[weld]\ndistance = \"exact\""), Passes::builtin())?;
    /// assert_eq!(plan.weld.distance, Distance::Exact);
    /// assert_eq!(plan.passes.len(), 11);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`Plan::from_toml`].
    pub fn plan(self, over: Option<&str>, passes: Passes) -> Result<Plan, PlanError> {
        let Some(over) = over else { return Plan::from_toml_with(self.toml, passes) };
        // Read by itself first: its mistakes have lines.
        Plan::read(over, passes)?;
        let table = |text: &str| text.parse::<Table>().map_err(|error| PlanError::new(error.to_string()));
        let merged = merged(table(self.toml)?, table(over)?);
        Plan::from_toml_with(&merged.to_string(), passes)
    }
}

/// A table in which what another one says takes the place of what was there.
fn merged(mut base: Table, over: Table) -> Table {
    for (key, value) in over {
        let value = match (base.remove(&key), value) {
            (Some(toml::Value::Table(base)), toml::Value::Table(over)) => merged_options(base, over).into(),
            (_, value) => value,
        };
        base.insert(key, value);
    }
    base
}

/// The options of a pass; each has one value, also where that is a table.
fn merged_options(mut base: Table, over: Table) -> Table {
    base.extend(over);
    base
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Distance, NonOrientable, PassKind};

    fn plan(name: &str, over: Option<&str>) -> Result<Plan, PlanError> {
        Preset::from_name(name).unwrap().plan(over, Passes::builtin())
    }

    #[test]
    fn every_preset_is_a_plan_that_reads_back_the_same() {
        for preset in PRESETS {
            let plan = preset.plan(None, Passes::builtin()).unwrap();
            assert_eq!(Plan::from_toml(&plan.to_toml().unwrap()).unwrap(), plan, "{}", preset.name);
        }
        assert_eq!(Preset::from_name("prnt"), None);
    }

    #[test]
    fn passes_stand_at_their_usual_places() {
        for preset in PRESETS {
            let passes = preset.plan(None, Passes::builtin()).unwrap().passes;
            let place = |kind: &PassKind| PassKind::ALL.iter().position(|known| known == kind);
            assert!(passes.is_sorted_by_key(place), "{}: {passes:?}", preset.name);
        }
    }

    #[test]
    fn a_plan_overrides_option_by_option() {
        let changed =
            plan("print", Some("fail-on = []\n[weld]\ndistance = { absolute = 0.5 }\n[fill]\nby = \"fan\""))
                .unwrap();
        assert_eq!(changed.weld.distance, Distance::Absolute(0.5));
        assert_eq!(changed.fill.loops, plan("print", None).unwrap().fill.loops);
        assert_eq!((changed.orient.non_orientable, changed.files.fail_on.len()), (NonOrientable::Cut, 0));
        let wrong = plan("print", Some("\n[weld]\ndistnace = 1")).unwrap_err().to_string();
        assert!(wrong.contains("line 3") && wrong.contains("distnace"), "{wrong}");
        // Together they break a rule that each of them keeps.
        assert!(plan("print", Some("[split]\nedges = \"pinch-only\"")).is_err());
    }
}
