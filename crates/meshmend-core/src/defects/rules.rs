//! Which kinds of defect there are: meshmend's own, and those of whoever uses it.

use std::fmt;

use super::{DefectKind, Rule};

/// The kinds of defect that a check looks for.
///
/// ```
/// use meshmend_core::{DefectKind, Rules};
///
/// let rules = Rules::builtin();
/// assert_eq!(rules.kind("loose-edge"), Some(DefectKind::LooseEdge));
/// assert_eq!(rules.kind("no-such-kind"), None);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Rules {
    own: &'static [&'static Rule],
}

/// Two kinds of defect have the same code.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RuleError {
    /// The code.
    pub code: &'static str,
}

impl Rules {
    /// The kinds that meshmend has.
    pub fn builtin() -> Self {
        Rules::default()
    }

    /// The kinds that meshmend has, and others.
    ///
    /// # Errors
    /// When two kinds have the same code.
    ///
    /// *Cost*: quadratic in the number of other kinds.
    pub fn with(own: &'static [&'static Rule]) -> Result<Self, RuleError> {
        for (place, rule) in own.iter().enumerate() {
            if own[..place].contains(rule) || DefectKind::from_code(rule.code).is_some() {
                return Err(RuleError { code: rule.code });
            }
        }
        Ok(Rules { own })
    }

    /// All kinds, in the order in which reports list them.
    pub fn kinds(self) -> impl Iterator<Item = DefectKind> {
        DefectKind::ALL.iter().copied().chain(self.own())
    }

    /// The kinds that meshmend does not have of itself.
    pub fn own(self) -> impl Iterator<Item = DefectKind> {
        self.own.iter().map(|&rule| DefectKind::Own(rule))
    }

    /// The kind with a code.
    ///
    /// *Cost*: linear in the number of kinds.
    pub fn kind(self, code: &str) -> Option<DefectKind> {
        self.kinds().find(|kind| kind.code() == code)
    }
}

impl fmt::Display for RuleError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "two kinds of defect have the code `{}`", self.code)
    }
}

impl std::error::Error for RuleError {}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Found, Listed, Severity};

    const RULE: Rule = Rule {
        code: "odd-face",
        title: "odd faces",
        severity: Severity::Note,
        explanation: "The number of the face is odd.",
        found: Found::InMesh(|_| Box::new(std::iter::empty())),
        listed: Listed::Unasked,
        counts: None,
        sentence: "{at} is odd",
    };

    #[test]
    fn a_rule_of_ones_own_comes_after_the_others() {
        let rules = Rules::with(&[&RULE]).unwrap();
        assert_eq!(rules.kind("odd-face"), Some(DefectKind::Own(&RULE)));
        assert_eq!(rules.kinds().count(), DefectKind::ALL.len() + 1);
        assert!(rules.kinds().is_sorted());
    }

    #[test]
    fn no_two_rules_have_one_code() {
        const TAKEN: Rule = Rule { code: "loose-edge", ..RULE };
        let twice = Rules::with(&[&RULE, &RULE]).unwrap_err();
        assert_eq!(twice.to_string(), "two kinds of defect have the code `odd-face`");
        assert_eq!(Rules::with(&[&TAKEN]), Err(RuleError { code: "loose-edge" }));
    }
}
