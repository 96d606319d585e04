//! Words of the command line that stand for values of the library.

use std::path::Path;

use clap::ValueEnum;
use meshmend::formats::AttributePrecision;
use meshmend::shapes::{NAMED_SHAPES, NamedShape};
use meshmend::{
    DefectKind, Distance, Encoding, Format, KernelKind, ReadFile, Rules, Seams, View, WriteOptions,
};

use crate::failure::Failure;
use crate::streams::{format_is_not_told, is_stream, output_name};

/// What `--weld` can say: nothing is welded, or within which distance.
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

/// Reads the name of a kernel.
pub(crate) fn kernel(word: &str) -> Result<KernelKind, String> {
    KernelKind::from_name(word).ok_or_else(|| {
        let names: Vec<&str> = KernelKind::ALL.iter().map(|kernel| kernel.name()).collect();
        format!("the kernels are {}", names.join(", "))
    })
}

/// Reads the code of a kind of defect.
pub(crate) fn defect_kind(rules: Rules, word: &str) -> Result<DefectKind, Failure> {
    rules.kind(word).ok_or_else(|| {
        let codes: Vec<&str> = rules.kinds().map(DefectKind::code).collect();
        Failure::usage(format!("`{word}` is no kind of defect; the kinds are {}", codes.join(", ")))
    })
}

/// Reads the name of a shape.
pub(crate) fn shape(word: &str) -> Result<&'static NamedShape, String> {
    NamedShape::from_name(word).ok_or_else(|| {
        let names: Vec<&str> = NAMED_SHAPES.iter().map(|shape| shape.name).collect();
        format!("the shapes are {}", names.join(", "))
    })
}

/// Reads the extension of a format that is written.
pub(crate) fn format(word: &str) -> Result<Format, String> {
    Format::from_extension(word).ok_or_else(|| {
        let extensions = Format::ALL.iter().flat_map(|format| format.extensions());
        format!("the formats are {}", extensions.copied().collect::<Vec<&str>>().join(", "))
    })
}

/// What the help of a command says of its input.
pub(crate) fn input_help() -> String {
    format!("The mesh file: {}; `-` is standard input", formats_that_are_read())
}

/// What the help of a command says of its inputs.
pub(crate) fn inputs_help() -> String {
    format!("The mesh files: {}; `-` is standard input", formats_that_are_read())
}

/// `OBJ, PLY, … or OFF`.
fn formats_that_are_read() -> String {
    let names: Vec<&str> = Format::ALL.iter().map(|format| format.name()).collect();
    match names.split_last() {
        Some((last, others)) if !others.is_empty() => format!("{} or {last}", others.join(", ")),
        _ => names.concat(),
    }
}

/// How an output file spells its numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum EncodingWord {
    /// As text
    Ascii,
    /// As binary numbers, in the byte order that is usual for the format
    Binary,
    /// As binary numbers, the lowest byte first
    #[value(alias = "le")]
    LittleEndian,
    /// As binary numbers, the highest byte first
    #[value(alias = "be")]
    BigEndian,
}

/// In which format a mesh is written; by default in that of the file's name, for standard output in that of the input.
#[derive(Clone, Copy, Debug, clap::Args)]
pub(crate) struct OutputWords {
    /// The format of the output, whatever its name
    #[arg(long = "to", value_name = "FORMAT", value_parser = format)]
    format: Option<Format>,
    /// How the output spells its numbers; by default as the input does, if it has the same format
    #[arg(long, value_enum)]
    encoding: Option<EncodingWord>,
    /// How a vertex is written whose attributes differ from face to face
    #[arg(long, value_enum, default_value = "split")]
    seams: SeamsWord,
    /// Write texture coordinates, normals and colours of another format in double precision, though many programs don't
    /// read that
    #[arg(long)]
    keep_double: bool,
}

/// How a vertex is written whose attributes differ from face to face, where the format has them at the vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum SeamsWord {
    /// As several vertices at one place, as other programs expect it
    Split,
    /// As one vertex, with lists of values for the corners in PLY, which few other programs read
    Corners,
    /// Give up
    Fail,
}

impl OutputWords {
    /// The format of a file to write; for standard output that may be the one of the input.
    pub(crate) fn format(self, path: &Path, input: Option<Format>) -> Result<Format, Failure> {
        let named = if is_stream(path) { input } else { Format::from_path(path) };
        self.format.or(named).ok_or_else(|| format_is_not_told(path))
    }

    /// Whether it can be known only from the input in which format a file is written.
    fn waits_for_input(self, path: &Path) -> bool {
        is_stream(path) && self.format.is_none()
    }

    /// An error if a file can't be written so, as far as that can be known before the input is read.
    pub(crate) fn check(self, path: &Path) -> Result<(), Failure> {
        if self.waits_for_input(path) { Ok(()) } else { self.options(path).map(drop) }
    }

    /// How to write a file that comes from no other.
    pub(crate) fn options(self, path: &Path) -> Result<WriteOptions, Failure> {
        self.in_format(path, self.format(path, None)?)
    }

    /// How to write a file that comes from another one.
    pub(crate) fn options_for(self, path: &Path, file: &ReadFile) -> Result<WriteOptions, Failure> {
        Ok(self.in_format(path, self.format(path, Some(file.format))?)?.as_read(file))
    }

    fn in_format(self, path: &Path, format: Format) -> Result<WriteOptions, Failure> {
        let failed = |reason: String| Failure::usage(format!("{}: {reason}", output_name(path)));
        let encoding = match self.encoding {
            // That of the input, if that is known and has the same format.
            None => None,
            Some(word) => Some(word.of(format).ok_or_else(|| {
                let known: Vec<&str> = format.encodings().iter().map(|encoding| encoding.name()).collect();
                failed(format!("{format} has no such encoding; it has {}", known.join(", ")))
            })?),
        };
        let seams = match self.seams {
            SeamsWord::Split => Seams::Split,
            SeamsWord::Corners => Seams::Corners,
            SeamsWord::Fail => Seams::Fail,
        };
        let precision = match self.keep_double {
            true => AttributePrecision::Double,
            false => AttributePrecision::AsExpected,
        };
        let mut options = WriteOptions::of(format).with_seams(seams).with_precision(precision);
        options.encoding = encoding;
        // In which folder a stream ends can't be known.
        Ok(if is_stream(path) { options } else { options.for_path(path) })
    }
}

impl EncodingWord {
    fn of(self, format: Format) -> Option<Encoding> {
        let mut known = format.encodings().iter().copied();
        match self {
            EncodingWord::Ascii => known.find(|&encoding| encoding == Encoding::Ascii),
            EncodingWord::Binary => known.find(|&encoding| encoding != Encoding::Ascii),
            EncodingWord::LittleEndian => known.find(|&encoding| encoding == Encoding::LittleEndian),
            EncodingWord::BigEndian => known.find(|&encoding| encoding == Encoding::BigEndian),
        }
    }
}

/// What readers call a file that is written so.
pub(crate) fn variant(options: &WriteOptions) -> Option<&'static str> {
    let (format, encoding) = options.resolved().ok()?;
    Some(format.variant(encoding))
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
        assert!(kernel("edge").unwrap_err().starts_with("the kernels are "));
        let unknown = defect_kind(Rules::builtin(), "hole").unwrap_err();
        assert!(unknown.message.contains("the kinds are degenerate-face, "));
        assert!(format("glb").unwrap_err().starts_with("the formats are obj, ply"));
        assert_eq!((kernel("edge-use"), format("PLY")), (Ok(KernelKind::EdgeUse), Ok(Format::Ply)));
    }

    #[test]
    fn what_is_written_has_the_name_that_its_reader_gives_it() {
        for &format in Format::ALL {
            for &encoding in format.encodings() {
                let options = WriteOptions::of(format).with_encoding(encoding);
                let faces = meshmend::FaceTable::triangles(3, [0, 1, 2].map(meshmend::VertexId).to_vec());
                let mesh = meshmend::PolygonMesh::new(vec![[0.0; 3]; 3], faces.unwrap()).unwrap();
                let mut bytes = Vec::new();
                meshmend::encode(&mesh, &options, &mut bytes).unwrap();
                let name = format!("a.{}", format.extensions()[0]);
                let file = meshmend::read_bytes(&bytes, &name, &Default::default()).unwrap();
                assert_eq!(Some(file.variant), variant(&options));
            }
        }
    }
}
