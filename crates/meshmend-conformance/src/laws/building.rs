//! `refusal`, `assembly` and `capacity`: which meshes a kernel holds.

use meshmend_core::{Build, Capabilities, Complex, Connectivity, Defect, Refusal, admission};

use super::law::{Breach, Law};

pub(super) const REFUSAL: Law = Law {
    id: "refusal",
    sentence: "a kernel builds exactly when admission lists nothing against its capabilities, and else refuses with exactly \
        that list",
    why: "what a kernel can't hold is said beforehand, with every reason, and never found out by a wrong answer",
    often: Some("capabilities that say more than the pointers can hold"),
};

pub(super) const ASSEMBLY: Law = Law {
    id: "assembly",
    sentence: "a mesh that is admitted is assembled, without a panic and within the patience",
    why: "assemble is called for admitted meshes alone, so it can't fail",
    often: Some(
        "the boundary has no wing, twin or opposite; a degenerate face has no corner, so the face is not corner / 3",
    ),
};

pub(super) const CAPACITY: Law = Law {
    id: "capacity",
    sentence: "a kernel holds at least what `at_least` says",
    why: "a kernel that refuses everything keeps all other laws",
    often: Some("a capability that is left out, so that the meshes that are hard are refused"),
};

/// What a kernel says when it refuses a complex: its name, and everything that stands against it, which is something.
///
/// # Errors
/// What is wrong with the refusal.
pub fn refusal_law(
    refusal: &Refusal,
    name: &str,
    capabilities: &Capabilities,
    complex: &Complex,
) -> Result<(), String> {
    refusal_breach(refusal, name, &admission(complex, capabilities)).map_err(|breach| breach.to_string())
}

fn refusal_breach(refusal: &Refusal, name: &str, against: &[Defect]) -> Result<(), Breach> {
    if refusal.kernel != name {
        let question = "the kernel that the refusal names".to_owned();
        return Err(Breach { question, found: refusal.kernel.to_owned(), expected: name.to_owned() });
    }
    if refusal.defects == against && !against.is_empty() {
        return Ok(());
    }
    let said = |defects: &[Defect]| match defects {
        [] => "without a reason".to_owned(),
        [first, ..] => format!("for {} reasons, the first of which is that {first}", defects.len()),
    };
    let expected = if against.is_empty() { "no refusal".to_owned() } else { said(against) };
    Err(Breach { question: "the refusal".to_owned(), found: said(&refusal.defects), expected })
}

/// A kernel over a complex, or `None` where it refuses as it should.
///
/// # Errors
/// What is wrong with the refusal, or with building.
pub(crate) fn built<K: Connectivity>(complex: &Complex) -> Result<Option<K>, Breach> {
    match K::build(complex) {
        Err(refusal) => {
            refusal_breach(&refusal, K::NAME, &admission(complex, &K::CAPABILITIES)).map(|()| None)
        }
        Ok(kernel) => match admission(complex, &K::CAPABILITIES).as_slice() {
            [] => Ok(Some(kernel)),
            [first, ..] => Err(Breach {
                question: "the answer of build".to_owned(),
                found: "a kernel".to_owned(),
                expected: format!("a refusal, since {first}"),
            }),
        },
    }
}

/// Whether a kernel's capabilities are enough.
///
/// # Errors
/// The first kind of mesh that is asked for and not held.
pub(crate) fn capacity<K: Connectivity>(at_least: &Capabilities) -> Result<(), Breach> {
    let holds: Vec<_> = at_least.refused_kinds().collect();
    let missing = K::CAPABILITIES.refused_kinds().find(|kind| !holds.contains(kind));
    missing.map_or(Ok(()), |kind| {
        Err(Breach {
            question: format!("what CAPABILITIES say of {}", kind.title()),
            found: "that they are refused".to_owned(),
            expected: "that they are held".to_owned(),
        })
    })
}
