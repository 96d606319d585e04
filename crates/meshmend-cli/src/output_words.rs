//! What the command line says of a mesh that is written: its format, its encoding, and how attributes are stored.

use std::path::Path;

use clap::ValueEnum;
use meshmend::formats::{AttributePrecision, Companions, ManifoldExtension, Shell};
use meshmend::passes::WrittenSeams;
use meshmend::{Encoding, Format, Plan, ReadFile, Seams, WriteOptions};

use crate::failure::{Failure, Status};
use crate::format_words;
use crate::streams::{STREAM, is_stream, output_name};

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
    #[arg(long = "to", value_name = "FORMAT", value_parser = format_words::format)]
    format: Option<Format>,
    /// How the output spells its numbers; by default as the input does, if it has the same format
    #[arg(long, value_enum)]
    encoding: Option<EncodingWord>,
    /// How a vertex is written whose attributes differ from face to face; by default split, or as the plan says
    #[arg(long, value_enum)]
    seams: Option<SeamsWord>,
    /// Say in each mesh of a glTF that is a closed manifold which of its vertices are one (EXT_mesh_manifold), so that
    /// vertices that were split stay apart
    #[arg(long)]
    manifold_extension: bool,
    /// Write texture coordinates, normals and colours of another format in double precision, though many programs don't
    /// read that
    #[arg(long)]
    keep_double: bool,
    /// What becomes of the files that the output names, such as material libraries and pictures, in another folder
    #[arg(long, value_enum, default_value = "copy")]
    companions: CompanionsWord,
}

/// What becomes of the files that the output names when it is written into another folder.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum CompanionsWord {
    /// They are copied, and made where the input holds them; no other file is ever overwritten
    Copy,
    /// They stay where they are, and none is made
    Skip,
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
    /// These words, and where they say nothing those of a plan.
    pub(crate) fn planned(self, plan: &Plan) -> Self {
        let planned = plan.files.seams.and_then(|seams| match seams {
            WrittenSeams::Split => Some(SeamsWord::Split),
            WrittenSeams::Corners => Some(SeamsWord::Corners),
            WrittenSeams::Fail => Some(SeamsWord::Fail),
            _ => None,
        });
        OutputWords { seams: self.seams.or(planned), ..self }
    }

    /// The format of a file to write; for standard output that may be the one of the input.
    pub(crate) fn format(self, path: &Path, input: Option<Format>) -> Result<Format, Failure> {
        let named = if is_stream(path) { input } else { Format::from_path(path) };
        self.format.or(named).ok_or_else(|| format_is_not_told(path))
    }

    /// These words with another format, where a job names one.
    pub(crate) fn in_format_named(self, word: Option<&str>) -> Result<Self, Failure> {
        let Some(word) = word else { return Ok(self) };
        Ok(OutputWords { format: Some(format_words::format(word).map_err(Failure::usage)?), ..self })
    }

    /// How to write the bytes of a file of this name that comes from no other, and that stands nowhere yet.
    pub(crate) fn options_of_bytes(self, name: &Path) -> Result<WriteOptions, Failure> {
        self.in_format(Path::new(STREAM), self.format(name, None)?)
    }

    /// The format that was named.
    pub(crate) fn format_named(self) -> Option<Format> {
        self.format
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
        self.options_of(path, file.format, &file.shell)
    }

    /// How to write a file that comes from one of this format with this shell.
    pub(crate) fn options_of(
        self,
        path: &Path,
        format: Format,
        shell: &Shell,
    ) -> Result<WriteOptions, Failure> {
        Ok(self.in_format(path, self.format(path, Some(format))?)?.with_shell(shell.clone()))
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
            None | Some(SeamsWord::Split) => Seams::Split,
            Some(SeamsWord::Corners) => Seams::Corners,
            Some(SeamsWord::Fail) => Seams::Fail,
        };
        let precision = match self.keep_double {
            true => AttributePrecision::Double,
            false => AttributePrecision::AsExpected,
        };
        let companions = match self.companions {
            CompanionsWord::Copy => Companions::Copy,
            CompanionsWord::Skip => Companions::Skip,
        };
        let options = WriteOptions::of(format).with_seams(seams).with_precision(precision);
        let mut options = options.with_companions(companions);
        if self.manifold_extension {
            options = options.with_manifold_extension(ManifoldExtension::Add);
        }
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

/// The failure when an output's format is not told.
fn format_is_not_told(output: &Path) -> Failure {
    let names: Vec<&str> = Format::ALL.iter().map(|format| format.name()).collect();
    let why = match is_stream(output) {
        true => "--to must tell the format",
        false => "the name tells no format that can be written",
    };
    let message = format!("{}: {why}; known are {}", output_name(output), names.join(", "));
    Failure { status: Status::Usage, message }
}
