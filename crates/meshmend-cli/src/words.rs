//! Words of the command line that stand for values of the library.

use meshmend::matrices::{Field, Prime};
use meshmend::mesh::Cell;
use meshmend::passes::PlanError;
use std::path::Path;

use meshmend::shapes::{NAMED_SHAPES, NamedShape};
use meshmend::{
    AnyKernel, Distance, EdgeId, FaceId, Format, KernelKind, Kernels, PolygonMesh, ReadFile, VertexId, View,
};

use crate::failure::Failure;
use crate::streams::name;

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

/// How a file is looked at: as `--weld` says, else as files of its format usually are.
pub(crate) fn view(weld: Option<Welding>, file: &ReadFile) -> View {
    view_of(weld, file.format)
}

/// How a document of a format is looked at.
pub(crate) fn view_of(weld: Option<Welding>, format: Format) -> View {
    weld.map_or(View::usual_for(format), Welding::view)
}

/// The mesh of a file as it is looked at.
pub(crate) fn viewed(weld: Option<Welding>, file: &ReadFile, path: &Path) -> Result<PolygonMesh, Failure> {
    view(weld, file).of(&file.mesh).map_err(|error| Failure::of_pass(&name(path), &error))
}

/// Reads `none`, `off`, or a [`Distance`].
pub(crate) fn welding(word: &str) -> Result<Welding, String> {
    match word {
        "none" | "off" => Ok(Welding::Off),
        _ => word.parse().map(Welding::Within).map_err(|error: PlanError| error.to_string()),
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

/// Reads the name of a vertex, an edge or a face, such as `v3`, `e7` or `f0`.
pub(crate) fn cell(word: &str) -> Result<Cell, String> {
    let expected = || "expected the name of a cell, such as v3, e7 or f0".to_owned();
    let (letter, digits) = word.split_at_checked(1).ok_or_else(expected)?;
    let number = number(digits).ok_or_else(expected)?;
    match letter {
        "v" => Ok(VertexId(number).into()),
        "e" => Ok(EdgeId(number).into()),
        "f" => Ok(FaceId(number).into()),
        _ => Err(expected()),
    }
}

/// Reads the name of a vertex, such as `v3`.
pub(crate) fn vertex(word: &str) -> Result<VertexId, String> {
    let number = word.strip_prefix('v').and_then(number);
    number.map(VertexId).ok_or_else(|| "expected the name of a vertex, such as v3".to_owned())
}

/// Digits and nothing else.
fn number(word: &str) -> Option<u32> {
    word.bytes().all(|byte| byte.is_ascii_digit()).then(|| word.parse().ok()).flatten()
}

/// Reads a field: a prime, or `Q` for the rationals.
pub(crate) fn field(word: &str) -> Result<Field, String> {
    if word.eq_ignore_ascii_case("q") {
        return Ok(Field::Rationals);
    }
    match number(word) {
        Some(number) => {
            let prime = Prime::new(number).ok_or_else(|| format!("{number} is not a prime number"))?;
            Ok(Field::Modulo(prime))
        }
        None => Err("expected a prime number below 2^32, or Q for the rationals".to_owned()),
    }
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
        assert_eq!(welding("boundary:0.5"), Ok(Welding::Within(Distance::Boundary(0.5))));
        assert_eq!(welding("boundary:1%"), Ok(Welding::Within(Distance::BoundaryRelative(0.01))));
        for off in ["none", "off"] {
            assert_eq!(welding(off), Ok(Welding::Off));
        }
        for wrong in
            ["", "%", "-1", "nan", "inf", "1e999", "Exact", "3 mm", "boundary", "boundary:", "boundary:exact"]
        {
            assert!(welding(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn cells_are_a_letter_and_digits() {
        assert_eq!(cell("v3"), Ok(VertexId(3).into()));
        assert_eq!((cell("e0"), cell("f4294967295")), (Ok(EdgeId(0).into()), Ok(FaceId(u32::MAX).into())));
        for wrong in ["", "v", "3", "c3", "v-1", "v+1", "v3 ", "V3", "f4294967296", "vv3", "v٣"] {
            assert!(cell(wrong).is_err() && vertex(wrong).is_err(), "{wrong}");
        }
        assert_eq!(vertex("v7"), Ok(VertexId(7)));
        assert!(vertex("e7").is_err());
    }

    #[test]
    fn fields_are_primes_or_q() {
        assert_eq!((field("2"), field("Q")), (Ok(Field::Modulo(Prime::TWO)), Ok(Field::Rationals)));
        assert_eq!(field("4"), Err("4 is not a prime number".to_owned()));
        assert!(field("2147483647").is_ok() && field("2147483648").is_err());
        for wrong in ["", "R", "-2", "1", "0", "4294967311", "2.0"] {
            assert!(field(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn an_unknown_word_is_answered_with_the_known_ones() {
        let unknown = kernel("edge").unwrap_err();
        assert!(unknown.message.contains("its kernels are edge-use, "));
        assert_eq!(kernel("edge-use").unwrap(), KernelKind::EdgeUse);
        let unknown = any_kernel(Kernels::builtin(), "edge").unwrap_err();
        assert!(unknown.message.starts_with("there is no kernel `edge`; the kernels are edge-use, "));
    }
}
