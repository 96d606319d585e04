//! `meshmend convert`: the same mesh in another format.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use meshmend::formats::{ColorElements, Document, NoteKind, PreparedDocument, WriteError, decode_stl_colors};
use meshmend::{Format, WriteOptions};

use crate::console::Console;
use crate::failure::{Failure, Status};
use crate::output_words::OutputWords;
use crate::outputs::{Content, Files};
use crate::parts::PlacingWord;
use crate::render;
use crate::streams::{InputWords, Report, name, output_name, reserve, write_document};

/// Write a mesh in another format, and say what that format can't carry
///
/// Nothing is repaired: what is wrong with the mesh stays as it is.
#[derive(Debug, Args)]
pub(crate) struct Convert {
    /// The file to read; `-` is standard input
    #[arg(value_name = "IN")]
    pub(super) input: PathBuf,
    /// The file to write; it may be the same; `-` is standard output
    #[arg(value_name = "OUT")]
    output: PathBuf,
    /// What the attribute bytes of a binary STL file become in another format
    #[arg(long, value_enum, default_value_t = StlColors::Keep)]
    stl_colors: StlColors,
    /// How the parts of a file become one mesh, in a format of one mesh
    #[arg(long, value_enum, value_name = "HOW", default_value_t = PlacingWord::Scene)]
    place: PlacingWord,
    #[command(flatten)]
    from: InputWords,
    #[command(flatten)]
    words: OutputWords,
}

/// What attribute bytes of facets become.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum StlColors {
    /// They stay the numbers that they are
    Keep,
    /// Colours: as Materialise Magics has them if the header says `COLOR=`, else as VisCAM has them
    Decode,
}

impl Convert {
    pub(crate) fn run(self, console: &mut Console<'_>) -> Result<Status, Failure> {
        self.words.check(&self.output)?;
        Files::of_mesh(&self.input).writing("the output", Some(&self.output), Content::Mesh).check()?;
        self.check_colors(self.words.format(&self.output, None).ok())?;
        reserve(&self.output, Report::Text, console)?;
        let progress = console.progress(2);
        progress.step("read");
        let mut document = self.from.read_document(&self.input, console)?;
        let options = self.words.options_of(&self.output, document.format, &document.shell)?;
        self.check_colors(options.format)?;
        self.decode_colors(&mut document, &options)?;
        progress.step("write");
        let failed = |kind| WriteError { file: output_name(&self.output), kind };
        let prepared = PreparedDocument::placed(&document, &options, self.place.into()).map_err(failed)?;
        write_document(&self.output, &prepared, console)?;
        drop(progress);
        let (input, output) = (name(&self.input), output_name(&self.output));
        let text = render::conversion(&input, &output, &document, &prepared.losses());
        console.write(&(text + self.hint(&document, &options)))?;
        Ok(Status::Done)
    }

    /// Fails when colours are to be decoded for a format that keeps them as they are.
    fn check_colors(&self, format: Option<Format>) -> Result<(), Failure> {
        if self.stl_colors == StlColors::Decode && format == Some(Format::Stl) {
            let reason = "--stl-colors decode has no meaning for STL, which keeps colours as attribute bytes";
            return Err(Failure::usage(reason));
        }
        Ok(())
    }

    /// Makes colours of the attribute bytes of an STL file: of the faces, or in OBJ, which has no colours of faces, of the vertices.
    fn decode_colors(&self, document: &mut Document, options: &WriteOptions) -> Result<(), Failure> {
        if self.stl_colors == StlColors::Keep || document.format != Format::Stl {
            return Ok(());
        }
        let elements = match options.format {
            Some(Format::Obj) => ColorElements::Vertices,
            _ => ColorElements::Faces,
        };
        for part in &mut document.parts {
            part.mesh = decode_stl_colors(&part.mesh, elements)
                .map_err(|error| Failure::unwritable(&output_name(&self.output), error))?;
        }
        Ok(())
    }

    /// A line about attribute bytes that might have become colours.
    fn hint(&self, document: &Document, options: &WriteOptions) -> &'static str {
        let may_be_colors = document.notes.iter().any(|note| note.kind == NoteKind::PerhapsColors);
        let are_kept = self.stl_colors == StlColors::Keep && options.format != Some(Format::Stl);
        if may_be_colors && are_kept {
            "\nthe attribute bytes are written as numbers; --stl-colors decode makes colours of them\n"
        } else {
            ""
        }
    }
}
