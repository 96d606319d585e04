//! Words of the Python side that stand for values of the library, each with those that could have been said.

use std::path::Path;

use meshmend::formats::{AttributePrecision, Companions, ManifoldExtension, ReadOptions};
use meshmend::topology::Witness;
use meshmend::{AnyKernel, Distance, Encoding, Format, Kernels, Question, Seams, View, WriteOptions};
use pyo3::prelude::*;

use crate::errors::{Done, Problem};

/// What one of these words stands for.
pub(crate) fn chosen<T: Copy>(what: &str, word: &str, known: &[(&str, T)]) -> Done<T> {
    let found = known.iter().find(|(name, _)| *name == word).map(|(_, value)| *value);
    found.ok_or_else(|| unknown(what, word, known.iter().map(|(name, _)| *name)))
}

/// A word that is none of those that are known.
pub(crate) fn unknown<'a>(what: &str, word: &str, known: impl Iterator<Item = &'a str>) -> Problem {
    let known: Vec<&str> = known.collect();
    Problem::Value(format!("{what} can't be `{word}`; it can be {}", known.join(", ")))
}

pub(crate) fn format(word: &str) -> Done<Format> {
    let names = || Format::ALL.iter().flat_map(|format| format.extensions()).copied();
    Format::from_extension(word).ok_or_else(|| unknown("format", word, names()))
}

pub(crate) fn kernel(word: &str) -> Done<AnyKernel> {
    let kernels = Kernels::builtin();
    kernels.named(word).ok_or_else(|| unknown("kernel", word, kernels.all().map(|kernel| kernel.name)))
}

pub(crate) fn witness(word: &str) -> Done<Witness> {
    chosen("witness", word, &WITNESSES)
}

pub(crate) const WITNESSES: [(&str, Witness); 2] =
    [("breadth-first", Witness::BreadthFirst), ("shortest", Witness::Shortest)];

pub(crate) fn question(word: &str) -> Done<Question> {
    let known: Vec<(&str, Question)> = Question::ALL.iter().map(|&asked| (asked.name(), asked)).collect();
    chosen("geometry", word, &known)
}

/// A distance, or none for `none` and `off`.
pub(crate) fn distance(what: &str, word: &str) -> Done<Option<Distance>> {
    match word {
        "none" | "off" => Ok(None),
        word => word
            .parse()
            .map(Some)
            .map_err(|error| Problem::Value(format!("{what} can't be `{word}`: {error}"))),
    }
}

/// The view of a check: as `weld` says, or as `view` does, or the usual one.
pub(crate) fn view(view: Option<&str>, weld: Option<&str>, usual: View) -> Done<View> {
    let welded = |word| Ok(distance("weld", word)?.map_or(View::Indexed, View::Welded));
    match (view, weld) {
        (None, None) => Ok(usual),
        (None, Some(word)) => welded(word),
        (Some("indexed"), None | Some("none" | "off")) => Ok(View::Indexed),
        (Some("welded"), weld) => welded(weld.unwrap_or("exact")),
        (Some("indexed"), Some(_)) => {
            Err(Problem::Value("weld has no meaning in the view `indexed`".to_owned()))
        }
        (Some(other), _) => Err(unknown("view", other, ["indexed", "welded"].into_iter())),
    }
}

/// How to read.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct ReadWords {
    format: Option<String>,
    max_bytes: Option<u64>,
    max_vertices: Option<u64>,
    max_faces: Option<u64>,
}

impl ReadWords {
    pub(crate) fn options(&self) -> Done<ReadOptions> {
        let mut options = ReadOptions::default().with_format(self.format.as_deref().map(format).transpose()?);
        if let Some(most) = self.max_bytes {
            options.limits = options.limits.with_max_file_bytes(most).with_max_stream_bytes(most);
        }
        if let Some(most) = self.max_vertices {
            options.limits = options.limits.with_max_vertices(most);
        }
        if let Some(most) = self.max_faces {
            options.limits = options.limits.with_max_faces(most);
        }
        Ok(options)
    }
}

/// How to write.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct WriteWords {
    format: Option<String>,
    encoding: Option<String>,
    seams: String,
    manifold_extension: bool,
    keep_double: bool,
    companions: String,
    pub(crate) strict: bool,
}

impl WriteWords {
    /// How to write to a path, or to bytes.
    pub(crate) fn options(&self, path: Option<&Path>) -> Done<WriteOptions> {
        let format = self.format.as_deref().map(format).transpose()?;
        let named = || path.and_then(Format::from_path);
        let Some(format) = format.or_else(named) else { return Err(format_is_not_told(path)) };
        let seams = [("split", Seams::Split), ("corners", Seams::Corners), ("fail", Seams::Fail)];
        let companions = [("copy", Companions::Copy), ("skip", Companions::Skip)];
        let precision = match self.keep_double {
            true => AttributePrecision::Double,
            false => AttributePrecision::AsExpected,
        };
        let mut options = WriteOptions::of(format)
            .with_seams(chosen("seams", &self.seams, &seams)?)
            .with_companions(chosen("companions", &self.companions, &companions)?)
            .with_precision(precision);
        if self.manifold_extension {
            options = options.with_manifold_extension(ManifoldExtension::Add);
        }
        options.encoding = self.encoding.as_deref().map(|word| encoding(format, word)).transpose()?;
        Ok(path.map_or(options.clone(), |path| options.for_path(path)))
    }
}

/// An encoding of a format; `binary` is the usual one in binary numbers.
fn encoding(format: Format, word: &str) -> Done<Encoding> {
    let known = format.encodings();
    let found = match word {
        "binary" => known.iter().find(|&&encoding| encoding != Encoding::Ascii),
        word => known.iter().find(|encoding| encoding.name() == word),
    };
    let what = format!("encoding of {format}");
    found.copied().ok_or_else(|| unknown(&what, word, known.iter().map(|encoding| encoding.name())))
}

fn format_is_not_told(path: Option<&Path>) -> Problem {
    let names: Vec<&str> = Format::ALL.iter().map(|format| format.name()).collect();
    let name = path.map_or("the output".to_owned(), |path| path.display().to_string());
    Problem::Value(format!(
        "{name}: the name tells no format that can be written; known are {}",
        names.join(", ")
    ))
}
