//! The policies of a repair, from a plan file and from options, which override it.

use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use meshmend::passes::{
    Duplicates, Emptying, LooseElements, NonFinite, NonOrientable, Repeated, Side, SplitEdges,
    TriangulateFaces,
};
use meshmend::{FlippedNormals, PassKind, Plan};

use crate::failure::Failure;
use crate::words::{self, Welding};

/// A plan is far shorter than this many bytes.
const LONGEST_PLAN: u64 = 1 << 20;

/// What each pass does.
#[derive(Clone, Debug, Args)]
#[command(next_help_heading = "Policies")]
pub(crate) struct Policies {
    /// Read passes, their order and options from a TOML file; the options below override it
    #[arg(long, value_name = "FILE")]
    plan: Option<PathBuf>,
    /// Which vertices are joined: none, exact, single (equal in single precision), within a length, or within a percentage
    /// of the bounding box's diagonal
    #[arg(long, value_name = "DISTANCE", value_parser = words::welding)]
    weld: Option<Welding>,
    /// Whether faces are made simple, and degenerate, non-finite and repeated ones removed
    #[arg(long, value_enum)]
    clean: Option<OnOff>,
    /// Faces with a corner that is infinite or no number
    #[arg(long, value_enum)]
    non_finite: Option<NonFiniteWord>,
    /// Faces that repeat another one but differ in material, object, group, colour or texture coordinates
    #[arg(long, value_enum)]
    repeated: Option<RepeatedWord>,
    /// Which side of a patch is the front
    #[arg(long, value_enum)]
    orient: Option<OrientWord>,
    /// Patches that have no consistent side
    #[arg(long, value_enum)]
    non_orientable: Option<NonOrientableWord>,
    /// Faces that are there once in each direction
    #[arg(long, value_enum)]
    duplicates: Option<DuplicatesWord>,
    /// Stored normals of faces that are turned round
    #[arg(long, value_enum)]
    flipped_normals: Option<FlippedNormalsWord>,
    /// Edges with three faces or more, and pinched vertices
    #[arg(long, value_enum)]
    split: Option<SplitWord>,
    /// Which faces are cut into triangles; by default all of them where the output's format holds nothing else
    #[arg(long, value_enum)]
    triangulate: Option<TriangulateWord>,
    /// What happens to vertices, edges and points that no face uses
    #[arg(long, value_enum)]
    compact: Option<CompactWord>,
    /// Go on when no face would be left, in place of giving up
    #[arg(long)]
    allow_empty: bool,
}

/// Whether a pass runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum OnOff {
    /// Run the pass
    On,
    /// Leave it out
    Off,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum NonFiniteWord {
    /// Remove them, and say which
    Drop,
    /// Keep them
    Keep,
    /// Give up
    Fail,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum RepeatedWord {
    /// Keep them, and say in what they differ; what the output's format can't hold is no difference
    KeepDifferent,
    /// Keep the first alone, and say what went with the others
    Drop,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum OrientWord {
    /// That of most of its faces
    Majority,
    /// The outer one where the patch is closed
    Outward,
    /// The same, but shells inside others alternate, as the walls of hollows do
    OutwardNested,
    /// Turn nothing
    Off,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum NonOrientableWord {
    /// Leave them as they are, and name them
    Report,
    /// Cut them open along a seam
    Cut,
    /// Give up
    Fail,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum DuplicatesWord {
    /// Keep both: a double-sided wall
    Keep,
    /// Remove as many of each direction as there are pairs
    RemovePair,
    /// Keep the first of each group
    KeepFirst,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum FlippedNormalsWord {
    /// Turn them too, and the handedness of tangents with them
    Negate,
    /// Keep them
    Keep,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum SplitWord {
    /// Take them apart into sheets
    Sheets,
    /// Take them apart wherever it is not beyond doubt what belongs together
    Cut,
    /// Split pinched vertices alone
    PinchOnly,
    /// Split nothing
    Off,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum TriangulateWord {
    /// Those that were triangles before and are no longer, if all were
    Auto,
    /// All
    All,
    /// None
    Off,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum CompactWord {
    /// Remove them, and say which
    On,
    /// Keep loose edges and points with their vertices; remove other vertices
    KeepLoose,
    /// Keep them all
    Off,
}

impl Policies {
    /// The file that the plan is read from.
    pub(crate) fn plan_file(&self) -> Option<&Path> {
        self.plan.as_deref()
    }

    /// The plan that they make.
    pub(crate) fn plan(&self) -> Result<Plan, Failure> {
        let mut plan = self.plan.as_deref().map_or(Ok(Plan::default()), read_plan)?;
        match self.weld {
            Some(Welding::Off) => plan = plan.without(PassKind::Weld),
            Some(Welding::Within(distance)) => with(&mut plan, PassKind::Weld).weld.distance = distance,
            None => {}
        }
        plan = self.clean_into(plan)?;
        plan = self.orient_into(plan)?;
        if let Some(word) = self.split {
            plan = split_into(plan, word);
        }
        if let Some(word) = self.triangulate {
            plan = triangulate_into(plan, word);
        }
        if let Some(word) = self.compact {
            plan = compact_into(plan, word);
        }
        if self.allow_empty {
            plan.empty = Emptying::Allow;
        }
        Ok(plan)
    }

    /// Their plan for an output that holds triangles alone: polygons are cut by the pass, which never repeats an edge,
    /// unless a plan or an option says otherwise.
    pub(crate) fn for_triangles(&self, plan: Plan) -> Plan {
        let is_said = self.plan.is_some() || self.triangulate.is_some();
        if is_said { plan } else { triangulate_into(plan, TriangulateWord::All) }
    }

    fn clean_into(&self, mut plan: Plan) -> Result<Plan, Failure> {
        if self.clean == Some(OnOff::Off) {
            let idle = self.non_finite.map(|_| "--non-finite");
            return left_out(plan, PassKind::Clean, idle.or(self.repeated.map(|_| "--repeated")));
        }
        if self.clean == Some(OnOff::On) {
            with(&mut plan, PassKind::Clean);
        }
        if let Some(word) = self.non_finite {
            with(&mut plan, PassKind::Clean).clean.non_finite = match word {
                NonFiniteWord::Drop => NonFinite::Drop,
                NonFiniteWord::Keep => NonFinite::Keep,
                NonFiniteWord::Fail => NonFinite::Fail,
            };
        }
        if let Some(word) = self.repeated {
            with(&mut plan, PassKind::Clean).clean.repeated = match word {
                RepeatedWord::KeepDifferent => Repeated::KeepDifferent,
                RepeatedWord::Drop => Repeated::Drop,
            };
        }
        Ok(plan)
    }

    fn orient_into(&self, mut plan: Plan) -> Result<Plan, Failure> {
        let side = match self.orient {
            Some(OrientWord::Off) => {
                let idle = self.non_orientable.map(|_| "--non-orientable");
                let idle = idle.or(self.duplicates.map(|_| "--duplicates"));
                let idle = idle.or(self.flipped_normals.map(|_| "--flipped-normals"));
                return left_out(plan, PassKind::Orient, idle);
            }
            Some(OrientWord::Majority) => Some(Side::Majority),
            Some(OrientWord::Outward) => Some(Side::Outward),
            Some(OrientWord::OutwardNested) => Some(Side::OutwardNested),
            None => None,
        };
        if let Some(side) = side {
            with(&mut plan, PassKind::Orient).orient.side = side;
        }
        if let Some(word) = self.non_orientable {
            with(&mut plan, PassKind::Orient).orient.non_orientable = match word {
                NonOrientableWord::Report => NonOrientable::Report,
                NonOrientableWord::Cut => NonOrientable::Cut,
                NonOrientableWord::Fail => NonOrientable::Fail,
            };
        }
        if let Some(word) = self.flipped_normals {
            with(&mut plan, PassKind::Orient).orient.flipped_normals = match word {
                FlippedNormalsWord::Negate => FlippedNormals::Negate,
                FlippedNormalsWord::Keep => FlippedNormals::Keep,
            };
        }
        if let Some(word) = self.duplicates {
            with(&mut plan, PassKind::Orient).orient.duplicates = match word {
                DuplicatesWord::Keep => Duplicates::Keep,
                DuplicatesWord::RemovePair => Duplicates::RemovePair,
                DuplicatesWord::KeepFirst => Duplicates::KeepFirst,
            };
        }
        Ok(plan)
    }
}

fn split_into(mut plan: Plan, word: SplitWord) -> Plan {
    let edges = match word {
        SplitWord::Off => return plan.without(PassKind::Split),
        SplitWord::Sheets => SplitEdges::Sheets,
        SplitWord::Cut => SplitEdges::Cut,
        SplitWord::PinchOnly => SplitEdges::PinchOnly,
    };
    with(&mut plan, PassKind::Split).split.edges = edges;
    plan
}

fn triangulate_into(mut plan: Plan, word: TriangulateWord) -> Plan {
    let faces = match word {
        TriangulateWord::Off => return plan.without(PassKind::Triangulate),
        TriangulateWord::Auto => TriangulateFaces::Auto,
        TriangulateWord::All => TriangulateFaces::All,
    };
    with(&mut plan, PassKind::Triangulate).triangulate.faces = faces;
    plan
}

fn compact_into(mut plan: Plan, word: CompactWord) -> Plan {
    let loose = match word {
        CompactWord::Off => return plan.without(PassKind::Compact),
        CompactWord::On => LooseElements::Remove,
        CompactWord::KeepLoose => LooseElements::Keep,
    };
    let compact = &mut with(&mut plan, PassKind::Compact).compact;
    (compact.loose_edges, compact.loose_points) = (loose, loose);
    plan
}

/// The plan without a pass; an option of a pass that does not run is a mistake of the user.
fn left_out(plan: Plan, pass: PassKind, idle_option: Option<&str>) -> Result<Plan, Failure> {
    match idle_option {
        None => Ok(plan.without(pass)),
        Some(option) => Err(Failure::usage(format!("{option} has no meaning with --{pass} off"))),
    }
}

/// The plan with a pass: where it is, or at its usual place.
fn with(plan: &mut Plan, pass: PassKind) -> &mut Plan {
    if !plan.passes.contains(&pass) {
        let at = plan.passes.iter().position(|&other| other > pass).unwrap_or(plan.passes.len());
        plan.passes.insert(at, pass);
    }
    plan
}

fn read_plan(path: &Path) -> Result<Plan, Failure> {
    let failed = |reason: String| Failure::usage(format!("{}: {reason}", path.display()));
    let mut text = String::new();
    let file = File::open(path).map_err(|error| failed(error.to_string()))?;
    let length =
        file.take(LONGEST_PLAN).read_to_string(&mut text).map_err(|error| failed(error.to_string()))?;
    if length as u64 == LONGEST_PLAN {
        return Err(failed("too long for a plan".to_owned()));
    }
    Plan::from_toml(&text).map_err(|error| failed(error.to_string()))
}

#[cfg(test)]
mod tests {
    use clap::Parser;
    use meshmend::Distance;

    use super::*;

    #[derive(Parser)]
    struct Line {
        #[command(flatten)]
        policies: Policies,
    }

    fn plan(options: &[&str]) -> Result<Plan, Failure> {
        Line::parse_from(std::iter::once("meshmend").chain(options.iter().copied())).policies.plan()
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
        assert_eq!(plan.passes, PassKind::ALL);
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
        assert_eq!(with("--clean", "on").passes, PassKind::ALL);
    }

    #[test]
    fn off_leaves_a_pass_out() {
        let options = ["weld", "clean", "orient", "split", "triangulate", "compact"];
        let options: Vec<String> =
            options.iter().flat_map(|pass| [format!("--{pass}"), "off".into()]).collect();
        let options: Vec<&str> = options.iter().map(String::as_str).collect();
        assert_eq!(plan(&options).unwrap().passes, [PassKind::Recompute]);
    }

    #[test]
    fn an_option_of_a_pass_that_is_off_is_refused() {
        assert!(plan(&["--clean", "off", "--non-finite", "fail"]).is_err());
        assert!(plan(&["--clean", "off", "--repeated", "drop"]).is_err());
        assert!(plan(&["--orient", "off", "--duplicates", "keep"]).is_err());
        assert!(plan(&["--orient", "off", "--flipped-normals", "keep"]).is_err());
    }

    #[test]
    fn a_pass_that_a_plan_leaves_out_comes_back_at_its_place() {
        let mut plan = Plan::from_toml("passes = ['weld', 'compact']").unwrap();
        with(&mut plan, PassKind::Orient);
        with(&mut plan, PassKind::Recompute);
        with(&mut plan, PassKind::Weld);
        let expected = [PassKind::Weld, PassKind::Orient, PassKind::Compact, PassKind::Recompute];
        assert_eq!(plan.passes, expected);
    }
}
