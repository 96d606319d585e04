//! The policies of a repair, from a plan file and from options, which override it.
//!
//! The options are those of the rows of the passes, so that a pass of another crate has its own.

use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

use clap::builder::{PossibleValue, PossibleValuesParser};
use clap::{Arg, ArgAction, ArgMatches, Args, Command};
use meshmend::files::CutPolygons;
use meshmend::passes::{
    Emptying, OptionValues, PRESETS, PassOption, Passes, PlanError, Preset, Said, SayingError,
};
use meshmend::{PassKind, Plan};

use crate::failure::Failure;

/// A plan is far shorter than this many bytes.
const LONGEST_PLAN: u64 = 1 << 20;
/// The word that leaves a pass out.
const OFF: &str = "off";

/// What each pass does.
#[derive(Clone, Debug, Args)]
#[command(next_help_heading = "Policies")]
pub(crate) struct Policies {
    /// Take the plan for a purpose; `preset` prints it, a plan file and the options below override it
    #[arg(long, value_name = "NAME", value_parser = preset_names())]
    preset: Option<String>,
    /// Read passes, their order and options from a TOML file; the options below override it
    #[arg(long, value_name = "FILE")]
    plan: Option<PathBuf>,
    /// Go on when no face would be left, in place of giving up
    #[arg(long)]
    allow_empty: bool,
    #[arg(skip)]
    said: Vec<Said>,
    #[arg(skip)]
    passes: Passes,
}

/// A command with the options of these passes.
pub(crate) fn with_options(command: Command, passes: Passes) -> Command {
    passes.options().fold(command, |command, (pass, option)| command.arg(argument(pass, option)))
}

fn argument(pass: PassKind, option: &'static PassOption) -> Arg {
    let argument = Arg::new(option.name).long(option.name).help(option.help).help_heading("Policies");
    let checked = move |word: &str| match Said::of(pass, option, word) {
        Ok(_) => Ok(word.to_owned()),
        Err(SayingError::Word { reason, .. }) => Err(reason),
        Err(error) => Err(error.to_string()),
    };
    match option.values {
        OptionValues::Flag(_) => argument.action(ArgAction::SetTrue),
        OptionValues::Limits => argument.value_name("LIMITS").value_parser(checked),
        OptionValues::ComponentLimit => argument.value_name("LIMIT").value_parser(checked),
        OptionValues::Aspect => argument.value_name("R").value_parser(checked),
        OptionValues::Reach => argument.value_name("LENGTH").value_parser(checked),
        OptionValues::Distance => argument.value_name("DISTANCE").value_parser(checked),
        OptionValues::Words(words) => {
            let off =
                (option.name == pass.name()).then(|| PossibleValue::new(OFF).help("Leave the pass out"));
            let words = words.iter().map(|word| PossibleValue::new(word.name).help(word.help));
            argument.value_name("WORD").value_parser(PossibleValuesParser::new(words.chain(off)))
        }
    }
}

impl Policies {
    /// Takes over what a command line says of the options of these passes.
    pub(crate) fn take(&mut self, matches: &ArgMatches, passes: Passes) {
        self.passes = passes;
        let word = |option: &PassOption| match option.values {
            OptionValues::Flag(word) => matches.get_flag(option.name).then(|| word.to_owned()),
            _ => matches.get_one::<String>(option.name).cloned(),
        };
        // The parser has refused each word that is none.
        let said = passes.options().filter_map(|(pass, option)| Said::of(pass, option, &word(option)?).ok());
        self.said.extend(said);
    }

    /// The file that the plan is read from.
    pub(crate) fn plan_file(&self) -> Option<&Path> {
        self.plan.as_deref()
    }

    /// The plan that they make.
    pub(crate) fn plan(&self) -> Result<Plan, Failure> {
        let preset = self.preset.as_deref().and_then(Preset::from_name);
        let plan = match (preset, self.plan.as_deref()) {
            (None, None) => Plan::of(self.passes),
            (None, Some(path)) => read_plan(path, |text| Plan::from_toml_with(text, self.passes))?,
            (Some(preset), None) => {
                preset.plan(None, self.passes).map_err(|error| Failure::usage(error.to_string()))?
            }
            (Some(preset), Some(path)) => read_plan(path, |text| preset.plan(Some(text), self.passes))?,
        };
        let plan = if self.allow_empty { Plan { empty: Emptying::Allow, ..plan } } else { plan };
        plan.saying(&self.said).map_err(|error| {
            Failure::usage(match error {
                SayingError::Idle { option, pass } => {
                    format!("--{option} has no meaning with --{pass} off")
                }
                SayingError::Word { option, reason, .. } => format!("--{option}: {reason}"),
                error => error.to_string(),
            })
        })
    }

    /// Whether their plan is as it is for an output that holds triangles alone too: a plan or an option says what is done to
    /// polygons.
    pub(crate) fn cut_polygons(&self) -> CutPolygons {
        let is_said = self.plan.is_some() || self.said.iter().any(|said| said.pass == PassKind::Triangulate);
        if is_said { CutPolygons::AsPlanned } else { CutPolygons::WhereNeeded }
    }
}

/// The names of the presets.
pub(crate) fn preset_names() -> PossibleValuesParser {
    PossibleValuesParser::new(PRESETS.map(|preset| PossibleValue::new(preset.name).help(preset.purpose)))
}

fn read_plan(path: &Path, read: impl FnOnce(&str) -> Result<Plan, PlanError>) -> Result<Plan, Failure> {
    let failed = |reason: String| Failure::usage(format!("{}: {reason}", path.display()));
    let mut text = String::new();
    let file = File::open(path).map_err(|error| failed(error.to_string()))?;
    let length =
        file.take(LONGEST_PLAN).read_to_string(&mut text).map_err(|error| failed(error.to_string()))?;
    if length as u64 == LONGEST_PLAN {
        return Err(failed("too long for a plan".to_owned()));
    }
    read(&text).map_err(|error| failed(error.to_string()))
}

#[cfg(test)]
mod tests {
    use clap::{CommandFactory, FromArgMatches, Parser};
    use meshmend::passes::{
        DropParts, Duplicates, FillLimits, FillLoops, FillRims, FillWith, HealWithin, Internal,
        LooseElements, NonFinite, NonOrientable, Reach, Repeated, Side, Slivers, SmallComponents, SplitEdges,
        TriangulateFaces, Turn,
    };
    use meshmend::{Distance, FlippedNormals};

    use super::*;

    #[derive(Parser)]
    struct Line {
        #[command(flatten)]
        policies: Policies,
    }

    fn plan(options: &[&str]) -> Result<Plan, Failure> {
        let command = with_options(Line::command(), Passes::builtin());
        let matches = command.get_matches_from(std::iter::once("meshmend").chain(options.iter().copied()));
        let mut policies = Line::from_arg_matches(&matches).unwrap().policies;
        policies.take(&matches, Passes::builtin());
        policies.plan()
    }

    #[test]
    fn no_option_is_the_default_plan() {
        assert_eq!(plan(&[]).unwrap(), Plan::default());
    }

    #[test]
    fn options_reach_their_pass() {
        let options = "--weld 1% --non-finite keep --orient outward --non-orientable cut --duplicates keep-first \
                       --split pinch-only --triangulate all --compact keep-loose";
        let plan = plan(&options.split_whitespace().collect::<Vec<_>>()).unwrap();
        assert_eq!(plan.passes, Plan::default().passes);
        assert_eq!(plan.weld.distance, Distance::Relative(0.01));
        assert_eq!(plan.clean.non_finite, NonFinite::Keep);
        assert_eq!(plan.orient.side, Side::Outward);
        assert_eq!(plan.orient.non_orientable, NonOrientable::Cut);
        assert_eq!(plan.orient.duplicates, Duplicates::KeepFirst);
        assert_eq!(plan.split.edges, SplitEdges::PinchOnly);
        assert_eq!(plan.triangulate.faces, TriangulateFaces::All);
        assert_eq!(plan.compact.loose_edges, LooseElements::Keep);
    }

    #[test]
    fn holes_are_filled_when_asked_for() {
        let plan = plan(&["--fill", "edges:12", "--fill-rims", "--fill-by", "fan"]).unwrap();
        let names: Vec<&str> = plan.passes.iter().map(|pass| pass.name()).collect();
        assert!(names.windows(3).any(|three| three == ["split", "fill", "triangulate"]), "{names:?}");
        let limits = FillLimits { edges: Some(12), ..FillLimits::default() };
        assert_eq!(plan.fill.loops, FillLoops::Within(limits));
        assert_eq!((plan.fill.rims, plan.fill.by), (FillRims::Take, FillWith::Fan));
        assert_eq!(self::plan(&["--fill", "off"]).unwrap(), Plan::default());
    }

    #[test]
    fn every_word_has_its_policy() {
        let with = |option, word| plan(&[option, word]).unwrap();
        let sides = ["majority", "outward", "outward-nested"].map(|word| with("--orient", word).orient.side);
        assert_eq!(sides, [Side::Majority, Side::Outward, Side::OutwardNested]);
        let infinite = ["drop", "keep", "fail"].map(|word| with("--non-finite", word).clean.non_finite);
        assert_eq!(infinite, [NonFinite::Drop, NonFinite::Keep, NonFinite::Fail]);
        let repeated = ["keep-different", "drop"].map(|word| with("--repeated", word).clean.repeated);
        assert_eq!(repeated, [Repeated::KeepDifferent, Repeated::Drop]);
        assert_eq!(plan(&["--allow-empty"]).unwrap().empty, Emptying::Allow);
        let twisted =
            ["report", "cut", "fail"].map(|word| with("--non-orientable", word).orient.non_orientable);
        assert_eq!(twisted, [NonOrientable::Report, NonOrientable::Cut, NonOrientable::Fail]);
        let doubled =
            ["keep", "remove-pair", "keep-first"].map(|word| with("--duplicates", word).orient.duplicates);
        assert_eq!(doubled, [Duplicates::Keep, Duplicates::RemovePair, Duplicates::KeepFirst]);
        let normals = ["negate", "keep"].map(|word| with("--flipped-normals", word).orient.flipped_normals);
        assert_eq!(normals, [FlippedNormals::Negate, FlippedNormals::Keep]);
        let edges = ["sheets", "cut", "pinch-only"].map(|word| with("--split", word).split.edges);
        assert_eq!(edges, [SplitEdges::Sheets, SplitEdges::Cut, SplitEdges::PinchOnly]);
        let faces = ["auto", "all"].map(|word| with("--triangulate", word).triangulate.faces);
        assert_eq!(faces, [TriangulateFaces::Auto, TriangulateFaces::All]);
        let loose = ["on", "keep-loose"].map(|word| with("--compact", word).compact);
        assert_eq!(loose.each_ref().map(|c| c.loose_edges), [LooseElements::Remove, LooseElements::Keep]);
        assert_eq!(loose.each_ref().map(|c| c.loose_points), [LooseElements::Remove, LooseElements::Keep]);
        assert_eq!(with("--clean", "on").passes, Plan::default().passes);
    }

    #[test]
    fn t_junctions_are_healed_when_asked_for_after_orient() {
        let within = |word: &str| plan(&["--heal", word]).map(|plan| plan.heal.within);
        let ways = ["exact", "0.5", "1%"].map(|word| within(word).unwrap());
        assert_eq!(ways, [HealWithin::Exact, HealWithin::Absolute(0.5), HealWithin::Relative(0.01)]);
        let names: Vec<&str> =
            plan(&["--heal", "exact"]).unwrap().passes.iter().map(|pass| pass.name()).collect();
        assert!(names.windows(3).any(|three| three == ["orient", "heal", "split"]), "{names:?}");
        assert_eq!(plan(&["--heal", "off"]).unwrap(), Plan::default());
        assert!(within("single").is_err() && plan(&["--heal", "exact", "--orient", "off"]).is_err());
    }

    #[test]
    fn parts_are_dropped_when_asked_for() {
        let plan = plan(&["--drop-components", "faces:12", "--internal", "remove-faces"]).unwrap();
        let expected = DropParts { components: SmallComponents::Faces(12), internal: Internal::RemoveFaces };
        assert_eq!(plan.drop, expected);
        let names: Vec<&str> = plan.passes.iter().map(|pass| pass.name()).collect();
        assert!(names.windows(3).any(|three| three == ["triangulate", "drop", "compact"]), "{names:?}");
    }

    #[test]
    fn slivers_are_mended_when_asked_for() {
        let plan = plan(&["--slivers", "500", "--max-move", "0.1%"]).unwrap();
        assert_eq!(plan.slivers, Slivers { aspect: 500.0, max_move: Reach::Relative(0.001) });
        let names: Vec<&str> = plan.passes.iter().map(|pass| pass.name()).collect();
        assert!(names.windows(3).any(|three| three == ["triangulate", "slivers", "compact"]), "{names:?}");
        assert_eq!(self::plan(&["--slivers", "off"]).unwrap(), Plan::default());
        assert!(self::plan(&["--slivers", "off", "--max-move", "1"]).is_err());
    }

    #[test]
    fn components_are_turned_when_asked_for() {
        let turns = ["solids", "nested", "visible"].map(|word| plan(&["--outward", word]).unwrap());
        assert_eq!(
            turns.each_ref().map(|plan| plan.outward.turn),
            [Turn::Solids, Turn::Nested, Turn::Visible]
        );
        let names: Vec<&str> = turns[0].passes.iter().map(|pass| pass.name()).collect();
        assert!(names.windows(2).any(|two| two == ["outward", "compact"]), "{names:?}");
        assert_eq!(plan(&["--outward", "off"]).unwrap(), Plan::default());
    }

    #[test]
    fn off_leaves_a_pass_out() {
        let options = ["weld", "clean", "orient", "split", "triangulate", "compact"];
        let options: Vec<String> =
            options.iter().flat_map(|pass| [format!("--{pass}"), "off".into()]).collect();
        let options: Vec<&str> = options.iter().map(String::as_str).collect();
        assert_eq!(plan(&options).unwrap().passes, [PassKind::Verify]);
    }

    #[test]
    fn an_option_of_a_pass_that_is_off_is_refused() {
        assert!(plan(&["--clean", "off", "--non-finite", "fail"]).is_err());
        assert!(plan(&["--clean", "off", "--repeated", "drop"]).is_err());
        assert!(plan(&["--orient", "off", "--duplicates", "keep"]).is_err());
        assert!(plan(&["--orient", "off", "--flipped-normals", "keep"]).is_err());
    }
}
