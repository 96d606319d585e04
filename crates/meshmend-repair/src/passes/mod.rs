//! The passes by name: meshmend's own, each of which is one file and one row here, and those of whoever uses it.

use std::any::Any;
use std::cmp::Ordering;
use std::fmt;
use std::sync::Arc;

use serde::de::MapAccess;
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

use crate::{Emptying, FilePolicies, Pass, PassOption, PassRow, PlanError};

macro_rules! passes {
    ($($file:ident: $variant:ident $(, $option:ident)*;)*) => {
        $(
            mod $file;
            pub use $file::{$variant $(, $option)*};
        )*

        /// Which pass, without its options.
        #[derive(Clone, Copy)]
        pub enum PassKind {
            $(#[doc = concat!("The pass `", stringify!($file), "`.")] $variant,)*
            /// A pass of another crate.
            Own(&'static PassRow),
        }

        /// A pass with its options.
        #[derive(Clone, Debug, PartialEq)]
        pub enum AnyPass {
            $(#[doc = concat!("The pass `", stringify!($file), "`.")] $variant($variant),)*
            /// A pass of another crate.
            Own(OwnPass),
        }

        impl PassKind {
            /// Every pass of meshmend's own, in their usual order.
            pub const ALL: &'static [Self] = &[$(PassKind::$variant,)*];

            /// All that is said of the pass.
            pub fn row(self) -> &'static PassRow {
                match self {
                    $(PassKind::$variant => &$file::ROW,)*
                    PassKind::Own(row) => row,
                }
            }
        }

        impl AnyPass {
            /// Which pass it is.
            pub fn kind(&self) -> PassKind {
                match self {
                    $(AnyPass::$variant(_) => PassKind::$variant,)*
                    AnyPass::Own(pass) => pass.kind(),
                }
            }

            /// The pass itself.
            pub fn as_pass(&self) -> &dyn Pass {
                match self {
                    $(AnyPass::$variant(pass) => pass,)*
                    AnyPass::Own(pass) => pass.as_pass(),
                }
            }
        }

        impl<P: Pass> From<P> for AnyPass {
            fn from(pass: P) -> Self {
                let any: &dyn Any = &pass;
                $(if let Some(options) = any.downcast_ref::<$variant>() {
                    return AnyPass::$variant(options.clone());
                })*
                AnyPass::Own(OwnPass(Arc::new(pass)))
            }
        }

        /// The passes of a pipeline with their options, as a [file](Plan::from_toml) says them.
        #[derive(Clone, Debug, PartialEq)]
        pub struct Plan {
            /// The passes, in order.
            pub passes: Vec<PassKind>,
            /// What happens when no face would be left.
            pub empty: Emptying,
            $(#[doc = concat!("Options of `", stringify!($file), "`.")] pub $file: $variant,)*
            /// The passes of other crates whose options are not the defaults, each once.
            pub own: Vec<OwnPass>,
            /// What is said beside the passes, for whoever reads and writes the files.
            pub files: FilePolicies,
        }

        impl Plan {
            /// A plan of these passes with their defaults.
            pub(crate) fn running(passes: Vec<PassKind>) -> Self {
                Plan { passes, empty: Emptying::default(), $($file: $variant::default(),)* own: Vec::new(), files: FilePolicies::default() }
            }

            /// The options of one of meshmend's own passes.
            pub(crate) fn builtin(&self, kind: PassKind) -> Option<AnyPass> {
                match kind {
                    $(PassKind::$variant => Some(AnyPass::$variant(self.$file.clone())),)*
                    PassKind::Own(_) => None,
                }
            }

            /// The plan with other options for one of meshmend's own passes; gives back any other pass.
            pub(crate) fn set_builtin(&mut self, pass: AnyPass) -> Option<OwnPass> {
                match pass {
                    $(AnyPass::$variant(options) => self.$file = options,)*
                    AnyPass::Own(pass) => return Some(pass),
                }
                None
            }

            /// Reads the options of one of meshmend's own passes.
            pub(crate) fn read_builtin<'de, M: MapAccess<'de>>(
                &mut self,
                kind: PassKind,
                map: &mut M,
            ) -> Result<(), M::Error> {
                match kind {
                    $(PassKind::$variant => self.$file = map.next_value()?,)*
                    PassKind::Own(_) => {}
                }
                Ok(())
            }

            /// Writes the options of meshmend's own passes, but for those of passes that do not run unasked and have none of
            /// their own.
            pub(crate) fn write_builtin<M: SerializeMap>(&self, map: &mut M) -> Result<(), M::Error> {
                $(if self.says(PassKind::$variant) || self.$file != $variant::default() {
                    map.serialize_entry(stringify!($file), &self.$file)?;
                })*
                Ok(())
            }
        }
    };
}

passes! {
    weld: Weld, Distance, WeldBy;
    clean: Clean, NonFinite, Repeated;
    orient: Orient, Duplicates, NonOrientable, Side;
    heal: Heal, HealWithin, TJunctionFate, TJunctionRecord;
    split: Split, SeamFigures, Seams, SplitEdges;
    fill: Fill, Crossed, CrossingFills, FillCrossing, FillLimits, FillLoops, FillRims, FillShape, FillWith, LeftOpen, LoopFate, LoopRecord, Reach;
    triangulate: Triangulate, TriangulateFaces;
    slivers: Slivers, SliverFate, SliverMend, SliverRecord;
    drop: DropParts, DropRecord, DroppedComponent, Internal, SmallComponents;
    outward: Outward, Turn;
    compact: Compact, LooseElements;
    apart: KeepApart, ApartBy, ApartFate, ApartRecord, NotMoved;
    verify: Verify;
}

pub(crate) use weld::{NearPair, OpenEdges, diagonal};

/// What `verify` was called before. Plans may still say so.
const FORMER_VERIFY: &str = "recompute";

impl Plan {
    /// Whether a plan has a table for a pass although all its options are the defaults.
    fn says(&self, kind: PassKind) -> bool {
        kind.row().is_default || self.passes.contains(&kind)
    }
}

impl PassKind {
    /// One of meshmend's own passes by its name.
    pub fn from_name(name: &str) -> Option<Self> {
        let name = if name == FORMER_VERIFY { PassKind::Verify.name() } else { name };
        Self::ALL.iter().copied().find(|kind| kind.name() == name)
    }

    /// The pass's name.
    pub fn name(self) -> &'static str {
        self.row().name
    }

    /// What it does, why and how.
    pub fn explanation(self) -> &'static str {
        self.row().explanation
    }

    /// The pass with its default options.
    pub fn with_defaults(self) -> AnyPass {
        self.row().form.defaults()
    }

    /// Whether it is a pass of another crate.
    pub fn is_own(self) -> bool {
        matches!(self, PassKind::Own(_))
    }

    /// Its usual place among passes that run in some order: before the first that usually comes later.
    pub(crate) fn usual_place(self, mut among: impl ExactSizeIterator<Item = PassKind>) -> usize {
        let count = among.len();
        among.position(|other| other > self).unwrap_or(count)
    }

    /// What orders passes as they usually run.
    fn place(self) -> (usize, &'static str) {
        let at = |kind: PassKind| Self::ALL.iter().position(|other| other.name() == kind.name());
        match self {
            PassKind::Own(row) => (row.before.and_then(at).map_or(usize::MAX, |at| 2 * at), row.name),
            _ => (at(self).map_or(usize::MAX, |at| 2 * at + 1), self.name()),
        }
    }
}

impl PartialEq for PassKind {
    fn eq(&self, other: &Self) -> bool {
        self.name() == other.name()
    }
}

impl Eq for PassKind {}

impl Ord for PassKind {
    fn cmp(&self, other: &Self) -> Ordering {
        self.place().cmp(&other.place())
    }
}

impl PartialOrd for PassKind {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl fmt::Debug for PassKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl fmt::Display for PassKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl Serialize for PassKind {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

/// A pass of another crate with its options.
#[derive(Clone, Debug)]
pub struct OwnPass(Arc<dyn Pass>);

impl OwnPass {
    /// Which pass it is.
    pub fn kind(&self) -> PassKind {
        self.0.kind()
    }

    /// The pass itself.
    pub fn as_pass(&self) -> &dyn Pass {
        &*self.0
    }
}

impl PartialEq for OwnPass {
    fn eq(&self, other: &Self) -> bool {
        let options = |pass: &OwnPass| pass.kind().row().form.write(pass.as_pass());
        self.kind() == other.kind() && options(self) == options(other)
    }
}

impl From<&AnyPass> for AnyPass {
    fn from(pass: &AnyPass) -> Self {
        pass.clone()
    }
}

/// Which passes there are: meshmend's own, and those of whoever uses it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Passes {
    own: &'static [&'static PassRow],
}

impl Passes {
    /// The passes that meshmend has.
    pub fn builtin() -> Self {
        Passes::default()
    }

    /// The passes that meshmend has, and others.
    ///
    /// # Errors
    /// When two passes, or two options, have the same name.
    ///
    /// *Cost*: quadratic in the number of passes and options.
    pub fn with(own: &'static [&'static PassRow]) -> Result<Self, PlanError> {
        let passes = Passes { own };
        let mut names = vec![FORMER_VERIFY, "passes", "empty", "plan", "allow-empty"];
        for kind in passes.kinds() {
            let others =
                kind.row().options.iter().map(|option| option.name).filter(|name| *name != kind.name());
            for name in std::iter::once(kind.name()).chain(others) {
                if names.contains(&name) {
                    return Err(PlanError::new(format!("two passes or options have the name `{name}`")));
                }
                names.push(name);
            }
        }
        Ok(passes)
    }

    /// All passes, in their usual order.
    pub fn kinds(self) -> Vec<PassKind> {
        let mut kinds: Vec<PassKind> = PassKind::ALL.iter().copied().chain(self.own()).collect();
        kinds.sort();
        kinds
    }

    /// The options of all passes, each with its pass.
    pub fn options(self) -> impl Iterator<Item = (PassKind, &'static PassOption)> {
        self.kinds().into_iter().flat_map(|kind| kind.row().options.iter().map(move |option| (kind, option)))
    }

    /// The passes that meshmend does not have of itself.
    pub fn own(self) -> impl Iterator<Item = PassKind> {
        self.own.iter().map(|&row| PassKind::Own(row))
    }

    /// The pass with a name.
    ///
    /// *Cost*: linear in the number of passes.
    pub fn kind(self, name: &str) -> Option<PassKind> {
        PassKind::from_name(name).or_else(|| self.own().find(|kind| kind.name() == name))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Form, OptionValues, Word};

    #[test]
    fn a_pass_has_one_name_everywhere() {
        for &kind in PassKind::ALL {
            let pass = kind.with_defaults();
            assert_eq!((pass.kind(), pass.as_pass().name()), (kind, kind.name()));
            assert_eq!(
                (PassKind::from_name(kind.name()), kind.to_string().as_str()),
                (Some(kind), kind.name())
            );
        }
        assert_eq!(PassKind::from_name("mend"), None);
        assert!(PassKind::ALL.is_sorted());
    }

    #[test]
    fn every_word_of_an_option_is_one_of_a_plan() {
        let mut count = 0;
        for (kind, option) in Passes::builtin().options() {
            let OptionValues::Words(words) = option.values else { continue };
            for (key, word) in option.sets.iter().flat_map(|key| words.iter().map(move |word| (key, word))) {
                let mut plan = Plan::default();
                plan.set(kind, key, word.value).unwrap();
                let table = kind.row().form.write(plan.builtin(kind).unwrap().as_pass()).unwrap();
                assert_eq!(table[*key].as_str(), Some(word.value), "{kind} {key}");
                count += 1;
            }
        }
        assert!(count > 20, "{count}");
    }

    const NOTHING: PassRow = PassRow {
        name: "nothing",
        explanation: "Does nothing.",
        is_default: false,
        before: Some(PassKind::Split),
        options: &[],
        form: Form::of::<Verify>(),
    };

    #[test]
    fn a_pass_of_ones_own_has_its_place() {
        let passes = Passes::with(&[&NOTHING]).unwrap();
        let names: Vec<&str> = passes.kinds().into_iter().map(PassKind::name).collect();
        let expected = [
            "weld",
            "clean",
            "orient",
            "heal",
            "nothing",
            "split",
            "fill",
            "triangulate",
            "slivers",
            "drop",
            "outward",
            "compact",
            "apart",
            "verify",
        ];
        assert_eq!(names, expected);
        assert_eq!(Plan::of(passes), Plan::default());
        assert_eq!(passes.kind("nothing"), Some(PassKind::Own(&NOTHING)));
        assert_eq!(Passes::builtin().kind("nothing"), None);
    }

    #[test]
    fn no_two_passes_or_options_have_one_name() {
        const WELD: PassRow = PassRow { name: "weld", ..NOTHING };
        const FORMER: PassRow = PassRow { name: "recompute", ..NOTHING };
        const OPTION: PassRow = PassRow {
            options: &[crate::PassOption {
                name: "non-finite",
                help: "",
                sets: &[],
                values: OptionValues::Words(&[Word::new("on", "")]),
            }],
            ..NOTHING
        };
        let failure = |rows| Passes::with(rows).unwrap_err().to_string();
        assert_eq!(failure(&[&WELD]), "two passes or options have the name `weld`");
        assert_eq!(failure(&[&FORMER]), "two passes or options have the name `recompute`");
        assert_eq!(failure(&[&NOTHING, &NOTHING]), "two passes or options have the name `nothing`");
        assert_eq!(failure(&[&OPTION]), "two passes or options have the name `non-finite`");
    }
}
