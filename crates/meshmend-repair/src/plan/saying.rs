//! Options of passes as words, as a command line and other programs give them, and the plan that follows.

use serde::Serialize;
use thiserror::Error;

use crate::{
    Distance, FillLoops, OptionValues, PassKind, PassOption, Plan, PlanError, Reach, SmallComponents,
};

/// The word that leaves a pass out.
const OFF: &str = "off";

/// An option of a pass, and the word that is given for it.
///
/// ```
/// use meshmend_repair::{Passes, Plan, Said};
///
/// let said: Result<Vec<Said>, _> = [("weld", "0.5"), ("triangulate", "off")]
///     .into_iter()
///     .map(|(option, word)| Said::new(Passes::builtin(), option, word))
///     .collect();
/// let plan = Plan::default().saying(&said?)?;
/// assert_eq!(plan.weld.distance, meshmend_repair::Distance::Absolute(0.5));
/// assert!(!plan.passes.iter().any(|pass| pass.name() == "triangulate"));
/// # Ok::<(), meshmend_repair::SayingError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Said {
    /// The pass that has the option.
    pub pass: PassKind,
    /// The option.
    pub option: &'static PassOption,
    /// The word; for an option without words that of [`OptionValues::Flag`].
    word: String,
}

/// Why words make no plan.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum SayingError {
    /// No pass has the option.
    #[error("there is no option `{0}`")]
    NoSuchOption(String),
    /// The option can't be that.
    #[error("{option} can't be `{word}`: {reason}")]
    Word {
        /// The option.
        option: &'static str,
        /// The word that was given.
        word: String,
        /// What is expected.
        reason: String,
    },
    /// An option of a pass that is left out.
    #[error("{option} has no meaning when {pass} is off")]
    Idle {
        /// The option.
        option: &'static str,
        /// The pass that is left out.
        pass: &'static str,
    },
    /// The pass can't be what is asked for.
    #[error(transparent)]
    Plan(#[from] PlanError),
}

impl Said {
    /// A word for an option of one of these passes.
    ///
    /// # Errors
    /// When no pass has the option, or it can't be that.
    pub fn new(passes: crate::Passes, option: &str, word: &str) -> Result<Self, SayingError> {
        let (pass, option) = passes
            .options()
            .find(|(_, known)| known.name == option)
            .ok_or_else(|| SayingError::NoSuchOption(option.to_owned()))?;
        Said::of(pass, option, word)
    }

    /// A word for an option of a pass.
    ///
    /// # Errors
    /// When it can't be that.
    pub fn of(pass: PassKind, option: &'static PassOption, word: &str) -> Result<Self, SayingError> {
        let said = Said { pass, option, word: word.to_owned() };
        if said.is_off() || said.value().is_ok() {
            return Ok(said);
        }
        let reason = said.value().err().unwrap_or_default();
        Err(SayingError::Word { option: option.name, word: said.word, reason })
    }

    /// Whether this leaves the pass out.
    pub fn is_off(&self) -> bool {
        let is_distance = self.option.values == OptionValues::Distance;
        self.option.name == self.pass.name() && (self.word == OFF || (is_distance && self.word == "none"))
    }

    /// What a plan file has for the word.
    fn value(&self) -> Result<Value, String> {
        let (word, told) = (self.word.as_str(), |error: PlanError| error.to_string());
        Ok(match self.option.values {
            OptionValues::Distance => Value::Distance(word.parse().map_err(told)?),
            OptionValues::Limits => Value::Loops(word.parse().map_err(told)?),
            OptionValues::ComponentLimit => Value::Components(word.parse().map_err(told)?),
            OptionValues::Reach => Value::Reach(word.parse().map_err(told)?),
            OptionValues::Aspect => Value::Number(aspect(word)?),
            OptionValues::Flag(expected) if word == expected => Value::Word(expected),
            OptionValues::Flag(_) => return Err("it takes no word".to_owned()),
            OptionValues::Words(words) => {
                let known = words.iter().find(|known| known.name == word);
                Value::Word(known.map(|known| known.value).ok_or_else(|| self.option.words(self.pass))?)
            }
        })
    }

    /// The plan with the pass, and the option set.
    fn added_to(&self, plan: Plan) -> Result<Plan, SayingError> {
        let mut plan = plan.with(self.pass);
        let value = self.value().map_err(|reason| SayingError::Word {
            option: self.option.name,
            word: self.word.clone(),
            reason,
        })?;
        for key in self.option.sets {
            plan.set(self.pass, key, &value)?;
        }
        Ok(plan)
    }
}

impl PassOption {
    /// The words that the option of a pass takes, in a sentence.
    fn words(&self, pass: PassKind) -> String {
        let OptionValues::Words(words) = self.values else { return String::new() };
        let off = (self.name == pass.name()).then_some(OFF);
        let names: Vec<&str> = words.iter().map(|word| word.name).chain(off).collect();
        format!("expected {}", names.join(", "))
    }
}

impl Plan {
    /// The plan with these options, in their order.
    ///
    /// # Errors
    /// When an option belongs to a pass that another one leaves out, when the pass can't be what is asked for, or when the passes
    /// that result are refused by [`check_order`](Self::check_order).
    pub fn saying(mut self, said: &[Said]) -> Result<Self, SayingError> {
        for one in said {
            self = if one.is_off() { self.left_out(one, said)? } else { one.added_to(self)? };
        }
        self.check_order()?;
        Ok(self)
    }

    /// The plan without a pass; another option of a pass that does not run is a mistake of the user.
    fn left_out(self, off: &Said, said: &[Said]) -> Result<Self, SayingError> {
        let is_idle = |other: &&Said| other.pass == off.pass && other.option.name != off.option.name;
        match said.iter().find(is_idle) {
            None => Ok(self.without(off.pass)),
            Some(idle) => Err(SayingError::Idle { option: idle.option.name, pass: off.pass.name() }),
        }
    }
}

/// What a plan file has for an option.
#[derive(Clone, Debug, Serialize)]
#[serde(untagged)]
enum Value {
    Word(&'static str),
    Number(f64),
    Distance(Distance),
    Reach(Reach),
    Loops(FillLoops),
    Components(SmallComponents),
}

/// From how many times its height on a triangle is a sliver.
fn aspect(word: &str) -> Result<f64, String> {
    let number = word.parse::<f64>().ok().filter(|number| number.is_finite() && *number >= 1.0);
    number.ok_or_else(|| "expected off, or a number of 1 or more such as 1000".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Passes;

    fn plan(words: &[(&str, &str)]) -> Result<Plan, SayingError> {
        let said = words.iter().map(|(option, word)| Said::new(Passes::builtin(), option, word));
        Plan::default().saying(&said.collect::<Result<Vec<_>, _>>()?)
    }

    #[test]
    fn a_word_that_no_option_takes_is_answered_with_those_it_takes() {
        let message = |words| plan(words).unwrap_err().to_string();
        assert_eq!(message(&[("spilt", "cut")]), "there is no option `spilt`");
        assert_eq!(
            message(&[("split", "cuts")]),
            "split can't be `cuts`: expected sheets, cut, pinch-only, off"
        );
        assert_eq!(
            message(&[("duplicates", "off")]),
            "duplicates can't be `off`: expected keep, remove-pair, keep-first"
        );
        assert!(message(&[("weld", "near")]).starts_with("weld can't be `near`: expected none, exact"));
        assert_eq!(
            message(&[("slivers", "0.5")]),
            "slivers can't be `0.5`: expected off, or a number of 1 or more such as 1000"
        );
        assert_eq!(message(&[("fill-rims", "yes")]), "fill-rims can't be `yes`: it takes no word");
    }

    #[test]
    fn an_option_of_a_pass_that_is_off_is_refused() {
        let refused = plan(&[("non-finite", "fail"), ("clean", "off")]).unwrap_err();
        assert_eq!(refused, SayingError::Idle { option: "non-finite", pass: "clean" });
        assert!(matches!(plan(&[("heal", "exact"), ("orient", "off")]), Err(SayingError::Plan(_))));
    }

    #[test]
    fn aspects_are_numbers_from_1_on() {
        assert_eq!((aspect("1"), aspect("1e3")), (Ok(1.0), Ok(1000.0)));
        for wrong in ["", "0.5", "-1000", "nan", "inf", "5%"] {
            assert!(aspect(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn off_leaves_a_pass_out() {
        for (pass, word) in [("weld", "none"), ("weld", "off"), ("split", "off")] {
            assert!(plan(&[(pass, word)]).unwrap().passes.iter().all(|kind| kind.name() != pass));
        }
    }
}
