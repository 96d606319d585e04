//! Gates: what of a file fails a run, beside what always does.

use std::fmt;

use meshmend_core::{DefectKind, Rules, counted};
use meshmend_io::{Loss, LossKind};
use serde::de::value::StrDeserializer;
use serde::{Deserialize, Serialize, Serializer};
use thiserror::Error;

/// What fails a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Criterion {
    /// Defects of a kind: in a check those that there are, in a repair those that are left.
    Defect(DefectKind),
    /// What the output does not carry, of one kind or of any.
    Loss(Option<LossKind>),
    /// Stored faces of which nothing is left.
    Removed,
    /// Any change of what was stored.
    Changed,
    /// Whatever is wrong and was not mended.
    Left,
}

/// A word that is no criterion.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{0}")]
pub struct UnknownCriterion(String);

impl Criterion {
    /// Reads a criterion: the code of a kind of defect of these rules, `loss`, `loss:KIND`, `removed`, `changed` or `left`.
    ///
    /// ```
    /// use meshmend::{Criterion, DefectKind, Rules};
    ///
    /// let read = |word| Criterion::of(Rules::builtin(), word);
    /// assert_eq!(read("boundary-edge")?, Criterion::Defect(DefectKind::BoundaryEdge));
    /// assert_eq!(read("loss")?, Criterion::Loss(None));
    /// assert!(read("loss:everything").is_err());
    /// # Ok::<(), meshmend::UnknownCriterion>(())
    /// ```
    ///
    /// # Errors
    /// When the word is none of them. The message lists them.
    pub fn of(rules: Rules, word: &str) -> Result<Self, UnknownCriterion> {
        let of_loss = |kind: &str| {
            let read = LossKind::deserialize(StrDeserializer::<serde::de::value::Error>::new(kind));
            read.map(|kind| Criterion::Loss(Some(kind))).map_err(|error| {
                let reason = error.to_string().replace("unknown variant", "there is no kind of loss");
                UnknownCriterion(reason.replace("expected one of", "the kinds are"))
            })
        };
        match (word, word.strip_prefix("loss:")) {
            ("loss", _) => Ok(Criterion::Loss(None)),
            ("removed", _) => Ok(Criterion::Removed),
            ("changed", _) => Ok(Criterion::Changed),
            ("left", _) => Ok(Criterion::Left),
            (_, Some(kind)) => of_loss(kind),
            _ => rules.kind(word).map(Criterion::Defect).ok_or_else(|| {
                let codes: Vec<&str> = rules.kinds().map(DefectKind::code).collect();
                UnknownCriterion(format!(
                    "there is no kind of defect `{word}`; the kinds are {}; other words are loss, loss:KIND, removed, changed \
                     and left",
                    codes.join(", ")
                ))
            }),
        }
    }

    /// How many elements of losses meet it; 0 where it is not about losses.
    pub fn count_in(self, losses: &[Loss]) -> u64 {
        let Criterion::Loss(asked) = self else { return 0 };
        losses.iter().filter(|loss| asked.is_none_or(|kind| loss.kind == kind)).map(|loss| loss.count).sum()
    }

    /// The kind of defect, if it is about one.
    pub fn defect(self) -> Option<DefectKind> {
        match self {
            Criterion::Defect(kind) => Some(kind),
            _ => None,
        }
    }
}

impl fmt::Display for Criterion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Criterion::Defect(kind) => f.write_str(kind.code()),
            Criterion::Loss(None) => f.write_str("loss"),
            Criterion::Loss(Some(kind)) => write!(f, "loss:{kind}"),
            Criterion::Removed => f.write_str("removed"),
            Criterion::Changed => f.write_str("changed"),
            Criterion::Left => f.write_str("left"),
        }
    }
}

impl Serialize for Criterion {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

/// What fails a run, beside what always does.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Gate(Vec<Criterion>);

/// A criterion that a file meets, and how often.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Failing {
    /// The criterion.
    pub criterion: Criterion,
    /// How many elements meet it.
    pub count: u64,
}

impl Gate {
    /// A gate of these criteria.
    pub fn new(criteria: impl IntoIterator<Item = Criterion>) -> Self {
        let mut gate = Gate::default();
        gate.0.extend(criteria);
        gate
    }

    /// The criteria, in the order in which they were named.
    pub fn criteria(&self) -> &[Criterion] {
        &self.0
    }

    /// The kinds of defect that it is about.
    pub fn defects(&self) -> Vec<DefectKind> {
        self.0.iter().filter_map(|criterion| criterion.defect()).collect()
    }

    /// Whether the result of a repair has to be judged for it.
    pub fn asks_of_result(&self) -> bool {
        self.0.iter().any(|criterion| matches!(criterion, Criterion::Defect(_) | Criterion::Left))
    }

    /// Whether nothing is asked.
    pub fn is_open(&self) -> bool {
        self.0.is_empty()
    }

    /// The criteria that are met, where `count` tells how many elements meet one.
    pub fn failing(&self, mut count: impl FnMut(Criterion) -> u64) -> Vec<Failing> {
        let counted = self.0.iter().map(|&criterion| Failing { criterion, count: count(criterion) });
        counted.filter(|failing| failing.count > 0).collect()
    }
}

impl fmt::Display for Failing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Failing { criterion, count } = *self;
        match criterion {
            Criterion::Defect(_) | Criterion::Loss(_) => write!(f, "{criterion} ({count})"),
            Criterion::Removed => write!(f, "removed ({})", counted(count, "face")),
            Criterion::Changed => f.write_str("changed"),
            Criterion::Left => write!(f, "left ({count})"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(word: &str) -> Result<Criterion, UnknownCriterion> {
        Criterion::of(Rules::builtin(), word)
    }

    #[test]
    fn every_criterion_is_read_as_it_is_shown() {
        for word in ["boundary-edge", "crossing-faces", "loss", "loss:layer", "removed", "changed", "left"] {
            assert_eq!(read(word).unwrap().to_string(), word);
        }
        let every = Rules::builtin().kinds().map(DefectKind::code);
        assert!(every.into_iter().all(|code| read(code).is_ok()));
    }

    #[test]
    fn a_word_that_is_none_is_answered_with_those_that_are() {
        let message = |word| read(word).unwrap_err().to_string();
        assert!(message("hole").contains("boundary-edge"), "{}", message("hole"));
        assert!(
            message("loss:color").starts_with("there is no kind of loss `color`"),
            "{}",
            message("loss:color")
        );
        assert!(message("loss:color").contains("`text-layout`"));
    }

    #[test]
    fn what_is_met_is_told_with_its_count() {
        let gate = Gate::new([Criterion::Removed, Criterion::Loss(None), Criterion::Changed]);
        let failing = gate.failing(|criterion| if criterion == Criterion::Changed { 1 } else { 2 });
        let told: Vec<String> = failing.iter().map(Failing::to_string).collect();
        assert_eq!(told, ["removed (2 faces)", "loss (2)", "changed"]);
        assert!(gate.failing(|_| 0).is_empty());
    }
}
