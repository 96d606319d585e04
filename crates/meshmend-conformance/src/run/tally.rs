//! What is known of a kernel after its runs.

use std::collections::BTreeMap;

use super::event::{Event, Example, Finding, Manner};
use super::needs::{names, needed};
use crate::Soup;
use crate::laws::{LAWS, number};

/// What is known of a kernel.
#[derive(Debug, Default)]
pub(crate) struct Results {
    /// The laws that are broken, by number.
    pub(crate) findings: BTreeMap<u32, Finding>,
    /// How many meshes were tried.
    pub(crate) tried: u32,
    /// How many of them the kernel holds; `None` where no run got through all.
    pub(crate) held: Option<u32>,
    /// The capabilities that every mesh needed that broke a law; with one of the meshes, and the law.
    needs: Option<(u8, u32, Example)>,
}

impl Results {
    /// Takes an event in; the first finding about a law stays, unless one on a smaller mesh comes.
    pub(crate) fn take(&mut self, event: Event) {
        match event {
            Event::Found(finding) => self.find(finding),
            Event::Needs { capabilities, law, example } => self.need(capabilities, law, example),
            Event::Done { tried, held } => (self.tried, self.held) = (tried, Some(held)),
            Event::At(mesh) | Event::Stuck { mesh, .. } => self.tried = self.tried.max(mesh + 1),
        }
    }

    /// Takes in how a law is broken.
    pub(crate) fn find(&mut self, finding: Finding) {
        if finding.manner == Manner::Hangs && finding.example.family.is_none() {
            let example = &finding.example;
            let complex = Soup::generic(example.vertex_count, &example.faces).complex();
            self.need(needed(&complex), finding.law, example.clone());
        }
        if finding.example.is_shrunk || !self.findings.contains_key(&finding.law) {
            self.findings.insert(finding.law, finding);
        }
    }

    fn need(&mut self, capabilities: u8, law: u32, example: Example) {
        match &mut self.needs {
            Some((all, ..)) => *all &= capabilities,
            none => *none = Some((capabilities, law, example)),
        }
    }

    /// When only meshes that need something break a law, the kernel claims that it can hold it, and can't.
    pub(crate) fn blame_capabilities(&mut self, claimed: u8) {
        let Some((all, law, example)) = self.needs.take() else { return };
        let (excess, refusal) = (all & claimed, number("refusal"));
        if excess == 0 || self.findings.contains_key(&refusal) {
            return;
        }
        let broken = LAWS[law as usize].id;
        let (of_them, need) = if excess.is_power_of_two() { ("it", "is") } else { ("them", "are") };
        self.find(Finding {
            law: refusal,
            manner: Manner::Broken,
            example,
            question: names(excess),
            found: "true".to_owned(),
            expected: Some(format!(
                "false: only where {of_them} {need} needed is a law broken, as `{broken}` is on this mesh"
            )),
        });
    }
}
