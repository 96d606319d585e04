//! The laws of a kernel: each is data, with the function that asks it.
//!
//! What a kernel says is compared with plain lists made from the faces ([`Expected`]); no law trusts another answer of the
//! kernel, but those that say so: they are asked where all the others are kept ([`Basis::Answers`]).

mod asked;
mod building;
mod derived;
mod edges;
mod expected;
mod faces;
mod growth;
mod law;
mod numbering;
mod record;
mod report;
mod size;
mod vertices;

use meshmend_core::{Complex, Connectivity};

pub(crate) use asked::Asked;
pub use building::refusal_law;
pub(crate) use building::{built, capacity};
pub(crate) use expected::Expected;
pub(crate) use growth::{Sizes, growth};
pub use law::{Breach, Law};
pub use size::heap_law;
pub(crate) use size::size;

use building::{ASSEMBLY, CAPACITY, REFUSAL};

/// Every law, in the order in which they are asked.
pub const LAWS: [&Law; 17] = [
    &REFUSAL,
    &ASSEMBLY,
    &numbering::COUNTS,
    &numbering::NUMBERING,
    &faces::NEXT_AND_PREV,
    &faces::FACE_STARS,
    &edges::EDGE_STARS,
    &vertices::VERTEX_STARS,
    &vertices::ROTATION,
    &edges::ACROSS,
    &derived::DERIVED,
    &record::ARRAYS,
    &record::POINTERS,
    &report::REPORT,
    &growth::GROWTH,
    &CAPACITY,
    &size::SIZE,
];

/// What has to hold on a mesh before a law is asked there.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Basis {
    /// Nothing: the law looks at plain lists alone.
    Lists,
    /// Every law of [`Basis::Lists`]: the law is about answers that are made of others.
    Answers,
}

/// A law that is asked on a mesh, with the function that asks it.
pub(crate) struct Check<K> {
    pub(crate) law: &'static Law,
    pub(crate) basis: Basis,
    pub(crate) ask: fn(&Asked<'_, K>) -> Result<(), Breach>,
}

/// The laws that are asked on every mesh that a kernel holds.
pub(crate) fn checks<K: Connectivity>() -> Vec<Check<K>> {
    let of_lists = |law, ask| Check { law, basis: Basis::Lists, ask };
    let of_answers = |law, ask| Check { law, basis: Basis::Answers, ask };
    vec![
        of_lists(&numbering::COUNTS, numbering::counts),
        of_lists(&numbering::NUMBERING, numbering::numbering),
        of_lists(&faces::NEXT_AND_PREV, faces::next_and_prev),
        of_lists(&faces::FACE_STARS, faces::face_stars),
        of_lists(&edges::EDGE_STARS, edges::edge_stars),
        of_lists(&vertices::VERTEX_STARS, vertices::vertex_stars),
        of_lists(&vertices::ROTATION, vertices::rotation),
        of_lists(&edges::ACROSS, edges::across),
        of_answers(&derived::DERIVED, derived::derived),
        of_answers(&record::ARRAYS, record::arrays),
        of_answers(&record::POINTERS, record::pointers),
        of_answers(&report::REPORT, report::report),
    ]
}

/// Whether a law is the one that goes over a mesh with every algorithm, which takes longer than all the others.
pub(crate) fn is_cross_check(law: &Law) -> bool {
    law.id == report::REPORT.id
}

/// The place of a law in the list of all.
pub(crate) fn number(id: &str) -> u32 {
    LAWS.iter().zip(0..).find(|(law, _)| law.id == id).map_or(0, |(_, number)| number)
}

/// The law of a name.
pub fn law(id: &str) -> Option<&'static Law> {
    LAWS.into_iter().find(|law| law.id == id)
}

/// The laws of a kernel over one complex, but for the cross-check and those of cost; a complex that the kernel refuses
/// rightly keeps them all.
///
/// # Errors
/// The law that is broken, and where.
pub fn kernel_laws<K: Connectivity>(complex: &Complex) -> Result<(), String> {
    let told = |law: &Law, breach: Breach| format!("{} breaks `{}`: {breach}", K::NAME, law.id);
    let Some(kernel) = built::<K>(complex).map_err(|breach| told(&REFUSAL, breach))? else { return Ok(()) };
    let expected = Expected::of(complex);
    let asked = Asked { kernel: &kernel, expected: &expected, mesh: None, opposite: None };
    let mut laws = checks::<K>().into_iter().filter(|check| !is_cross_check(check.law));
    laws.try_for_each(|check| (check.ask)(&asked).map_err(|breach| told(check.law, breach)))
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn each_law_has_a_name_of_its_own_and_a_sentence() {
        let ids: BTreeSet<&str> = LAWS.iter().map(|law| law.id).collect();
        assert_eq!(ids.len(), LAWS.len());
        for each in LAWS {
            assert_eq!(law(each.id), Some(each));
            assert!(!each.sentence.ends_with('.') && !each.why.is_empty(), "{}", each.id);
            assert!(!each.sentence.contains("  "), "{}", each.id);
        }
        assert_eq!(law("no-such-law"), None);
    }
}
