//! Words of the command line that stand for values of the library.

use meshmend::shapes::{NAMED_SHAPES, NamedShape};
use meshmend::{AnyKernel, DefectKind, Distance, KernelKind, Kernels, Rules, View};

use crate::failure::Failure;

/// What `--weld` can say: not to weld, or within which distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Welding {
    Off,
    Within(Distance),
}

impl Welding {
    /// The view of a check that welds so.
    pub(crate) fn view(self) -> View {
        match self {
            Welding::Off => View::Indexed,
            Welding::Within(distance) => View::Welded(distance),
        }
    }
}

/// Reads `none`, `off`, `exact`, `single`, a length, or a percentage of the bounding box's diagonal.
pub(crate) fn welding(word: &str) -> Result<Welding, String> {
    match word {
        "none" | "off" => return Ok(Welding::Off),
        "exact" => return Ok(Welding::Within(Distance::Exact)),
        "single" => return Ok(Welding::Within(Distance::Single)),
        _ => {}
    }
    let (number, is_percentage) = match word.strip_suffix('%') {
        Some(number) => (number, true),
        None => (word, false),
    };
    match number.trim().parse::<f64>() {
        Ok(length) if length.is_finite() && length >= 0.0 => Ok(Welding::Within(if is_percentage {
            Distance::Relative(length / 100.0)
        } else {
            Distance::Absolute(length)
        })),
        _ => {
            Err("expected none, exact, single, a length such as 0.001, or a percentage such as 0.01%"
                .to_owned())
        }
    }
}

/// Reads the name of one of these kernels.
pub(crate) fn any_kernel(kernels: Kernels, word: &str) -> Result<AnyKernel, Failure> {
    kernels.named(word).ok_or_else(|| {
        let names: Vec<&str> = kernels.all().map(|kernel| kernel.name).collect();
        Failure::usage(format!("there is no kernel `{word}`; the kernels are {}", names.join(", ")))
    })
}

/// Reads the name of a kernel of meshmend's own, on which a repair computes.
pub(crate) fn kernel(word: &str) -> Result<KernelKind, Failure> {
    KernelKind::from_name(word).ok_or_else(|| {
        let names: Vec<&str> = KernelKind::ALL.iter().map(|kernel| kernel.name()).collect();
        Failure::usage(format!("a repair has no kernel `{word}`; its kernels are {}", names.join(", ")))
    })
}

/// Reads the code of a kind of defect.
pub(crate) fn defect_kind(rules: Rules, word: &str) -> Result<DefectKind, Failure> {
    rules.kind(word).ok_or_else(|| {
        let codes: Vec<&str> = rules.kinds().map(DefectKind::code).collect();
        Failure::usage(format!("there is no kind of defect `{word}`; the kinds are {}", codes.join(", ")))
    })
}

/// Reads the name of a shape.
pub(crate) fn shape(word: &str) -> Result<&'static NamedShape, String> {
    NamedShape::from_name(word).ok_or_else(|| {
        let names: Vec<&str> = NAMED_SHAPES.iter().map(|shape| shape.name).collect();
        format!("the shapes are {}", names.join(", "))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_are_lengths_or_percentages() {
        assert_eq!(welding("exact"), Ok(Welding::Within(Distance::Exact)));
        assert_eq!(welding("single"), Ok(Welding::Within(Distance::Single)));
        assert_eq!(welding("1e-3"), Ok(Welding::Within(Distance::Absolute(1e-3))));
        assert_eq!(welding("50%"), Ok(Welding::Within(Distance::Relative(0.5))));
        for off in ["none", "off"] {
            assert_eq!(welding(off), Ok(Welding::Off));
        }
        for wrong in ["", "%", "-1", "nan", "inf", "1e999", "Exact", "3 mm"] {
            assert!(welding(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn an_unknown_word_is_answered_with_the_known_ones() {
        let unknown = kernel("edge").unwrap_err();
        assert!(unknown.message.contains("its kernels are edge-use, "));
        let unknown = defect_kind(Rules::builtin(), "hole").unwrap_err();
        assert!(unknown.message.contains("the kinds are degenerate-face, "));
        assert_eq!(kernel("edge-use").unwrap(), KernelKind::EdgeUse);
        let unknown = any_kernel(Kernels::builtin(), "edge").unwrap_err();
        assert!(unknown.message.starts_with("there is no kernel `edge`; the kernels are edge-use, "));
    }
}
