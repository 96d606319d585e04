//! What has been found in a run so far.

use meshmend_core::Complex;

use super::event::{Event, Example, Finding, Manner};
use super::needs::needed;
use crate::guard::{At, Stopped};
use crate::laws::Breach;

/// What came of asking a law.
pub(crate) type Answer = Result<Result<(), Breach>, Stopped>;

/// What has been found, and who is told.
pub(crate) struct Findings<'a> {
    tell: &'a mut dyn FnMut(Event),
    /// The laws that are known to be broken, and those that are not asked any more, one bit each.
    known: u32,
    shut: u32,
    /// The capabilities that every mesh so far needed that breaks a law.
    needed_by_all: u8,
}

impl<'a> Findings<'a> {
    /// None so far; some laws are not asked, and a kernel claims some capabilities.
    pub(crate) fn new(tell: &'a mut dyn FnMut(Event), shut: &[u32], claimed: u8) -> Self {
        let shut = shut.iter().fold(0, |all, law| all | 1 << law);
        Findings { tell, known: 0, shut, needed_by_all: claimed }
    }

    pub(crate) fn tell(&mut self, event: Event) {
        (self.tell)(event);
    }

    /// Whether a law is not asked any more.
    pub(crate) fn is_shut(&self, law: u32) -> bool {
        self.shut >> law & 1 == 1
    }

    /// Takes in what came of a law, and returns whether it is the first time that it is broken.
    pub(crate) fn judge(
        &mut self,
        at: At,
        answer: Answer,
        complex: Option<&Complex>,
        example: impl Fn() -> Example,
    ) -> bool {
        if matches!(answer, Ok(Ok(()))) {
            return false;
        }
        if let (Some(complex), 1..) = (complex, self.needed_by_all) {
            let needed = self.needed_by_all & needed(complex);
            if needed != self.needed_by_all || self.known == 0 {
                self.needed_by_all = needed;
                let example = example();
                (self.tell)(Event::Needs { capabilities: needed, law: at.law, example });
            }
        }
        if self.known >> at.law & 1 == 1 {
            return false;
        }
        self.known |= 1 << at.law;
        if matches!(answer, Err(Stopped::Closed(_))) {
            self.shut |= 1 << at.law;
        }
        if let Some(finding) = finding(at, answer, example()) {
            (self.tell)(Event::Found(finding));
        }
        true
    }
}

/// How a law is broken by an answer; `None` where it is kept.
pub(crate) fn finding(at: At, answer: Answer, example: Example) -> Option<Finding> {
    let question = at.query.about(at.element).to_string();
    let (law, expected) = (at.law, None);
    match answer {
        Ok(Ok(())) => None,
        Ok(Err(breach)) => Some(Finding::wrong(law, example, breach)),
        Err(Stopped::Panicked(words)) => {
            let found = format!("panics: {words}");
            Some(Finding { law, manner: Manner::Panics, example, question, found, expected })
        }
        Err(Stopped::Closed(_)) => {
            let found = "is not asked, since it has not come back before".to_owned();
            Some(Finding { law, manner: Manner::Hangs, example, question, found, expected })
        }
    }
}
