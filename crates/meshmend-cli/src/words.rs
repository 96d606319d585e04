//! Words of the command line that stand for values of the library.

use meshmend::matrices::{Field, Prime};
use meshmend::mesh::Cell;
use meshmend::passes::{FillLimits, FillLoops, Reach, SmallComponents};
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

/// Reads `none`, `off`, `exact`, `single`, a length, or a percentage of the bounding box's diagonal; the last two also behind
/// `boundary:`.
pub(crate) fn welding(word: &str) -> Result<Welding, String> {
    match word {
        "none" | "off" => return Ok(Welding::Off),
        "exact" => return Ok(Welding::Within(Distance::Exact)),
        "single" => return Ok(Welding::Within(Distance::Single)),
        "auto" => return Ok(Welding::Within(Distance::Auto)),
        _ => {}
    }
    let (length, is_boundary) = match word.strip_prefix("boundary:") {
        Some(length) => (length, true),
        None => (word, false),
    };
    let expected = |_| {
        "expected none, exact, single, auto, a length such as 0.001, a percentage such as 0.01%, or boundary: with either of these".to_owned()
    };
    Ok(Welding::Within(match (reach(length).map_err(expected)?, is_boundary) {
        (Reach::Absolute(length), false) => Distance::Absolute(length),
        (Reach::Relative(part), false) => Distance::Relative(part),
        (Reach::Absolute(length), true) => Distance::Boundary(length),
        (Reach::Relative(part), true) => Distance::BoundaryRelative(part),
    }))
}

/// Reads which holes are filled: `all`, or limits such as `edges:12,length:5%,area:0.5`.
pub(crate) fn fill_loops(word: &str) -> Result<FillLoops, String> {
    if word == "all" {
        return Ok(FillLoops::All);
    }
    let mut limits = FillLimits::default();
    let mut named: Vec<&str> = Vec::new();
    for limit in word.split(',') {
        let (name, size) = limit.split_once(':').ok_or_else(no_limit)?;
        if named.contains(&name) {
            return Err(format!("{name} is limited twice"));
        }
        named.push(name);
        match name {
            "edges" => limits.edges = Some(size.parse().map_err(|_| no_limit())?),
            "length" => limits.length = Some(reach(size).map_err(|_| no_limit())?),
            "area" => limits.area = Some(reach(size).map_err(|_| no_limit())?),
            _ => return Err(no_limit()),
        }
    }
    Ok(FillLoops::Within(limits))
}

/// Reads which components are too small: `faces:12`, `area:0.5` or `volume:0.1`.
pub(crate) fn small_components(word: &str) -> Result<SmallComponents, String> {
    let expected = || "expected a limit such as faces:12, area:0.5 or volume:0.1".to_owned();
    let (name, limit) = word.split_once(':').ok_or_else(expected)?;
    let number = || match limit.parse::<f64>() {
        Ok(number) if number.is_finite() && number >= 0.0 => Ok(number),
        _ => Err(expected()),
    };
    match name {
        "faces" => limit.parse().map(SmallComponents::Faces).map_err(|_| expected()),
        "area" => number().map(SmallComponents::Area),
        "volume" => number().map(SmallComponents::Volume),
        _ => Err(expected()),
    }
}

fn no_limit() -> String {
    "expected all, off, or limits such as edges:12,length:5%,area:0.5".to_owned()
}

/// Reads a length such as `0.001`, or a percentage such as `0.01%`.
pub(crate) fn reach(word: &str) -> Result<Reach, String> {
    let number = word.strip_suffix('%').unwrap_or(word).trim().parse::<f64>();
    match (number.ok().filter(|number| number.is_finite() && *number >= 0.0), word.ends_with('%')) {
        (None, _) => Err("expected a length such as 0.001, or a percentage such as 0.01%".to_owned()),
        (Some(length), false) => Ok(Reach::Absolute(length)),
        (Some(percentage), true) => Ok(Reach::Relative(percentage / 100.0)),
    }
}

/// Reads from how many times its height on a triangle is a sliver.
pub(crate) fn aspect(word: &str) -> Result<f64, String> {
    let number = word.parse::<f64>().ok().filter(|number| number.is_finite() && *number >= 1.0);
    number.ok_or_else(|| "expected off, or a number of 1 or more such as 1000".to_owned())
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
    fn limits_of_holes_are_a_list() {
        assert_eq!(fill_loops("all"), Ok(FillLoops::All));
        let limits = FillLimits {
            edges: Some(12),
            length: Some(Reach::Relative(0.5)),
            area: Some(Reach::Absolute(0.25)),
        };
        assert_eq!(fill_loops("edges:12,length:50%,area:0.25"), Ok(FillLoops::Within(limits)));
        for wrong in
            ["", "edges", "edges:-1", "edges:1%", "length:nan", "area:-2", "depth:1", "edges:1,edges:2"]
        {
            assert!(fill_loops(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_component_is_too_small_by_one_figure() {
        assert_eq!(small_components("faces:12"), Ok(SmallComponents::Faces(12)));
        assert_eq!(small_components("area:0.5"), Ok(SmallComponents::Area(0.5)));
        assert_eq!(small_components("volume:1e-3"), Ok(SmallComponents::Volume(1e-3)));
        for wrong in ["", "faces", "faces:-1", "faces:0.5", "area:nan", "volume:-1", "length:1", "area:5%"] {
            assert!(small_components(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn aspects_and_lengths_are_numbers() {
        assert_eq!((aspect("1"), aspect("1e3")), (Ok(1.0), Ok(1000.0)));
        assert_eq!((reach("0"), reach("0.5%")), (Ok(Reach::Absolute(0.0)), Ok(Reach::Relative(0.005))));
        for wrong in ["", "0.5", "-1000", "nan", "inf", "5%"] {
            assert!(aspect(wrong).is_err(), "{wrong}");
        }
        for wrong in ["", "%", "-1", "nan", "inf", "1 mm"] {
            assert!(reach(wrong).is_err(), "{wrong}");
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
