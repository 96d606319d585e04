//! `meshmend convert`: the same mesh in another format.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use meshmend::formats::{ColorElements, NoteKind, decode_stl_colors};
use meshmend::{Format, PolygonMesh, ReadFile, WriteOptions};

use crate::console::Console;
use crate::failure::{Failure, Status};
use crate::output_words::OutputWords;
use crate::outputs::{Content, Files};
use crate::render;
use crate::streams::{InputWords, Report, name, output_name, reserve, write_mesh};

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
        let mut file = self.from.read(&self.input, console)?;
        let options = self.words.options_for(&self.output, &file)?;
        self.check_colors(options.format)?;
        file.mesh = self.decoded(&file, &options)?;
        progress.step("write");
        let losses = write_mesh(&self.output, &file.mesh, &options, console)?;
        drop(progress);
        let text = render::conversion(&name(&self.input), &output_name(&self.output), &file, &losses);
        console.write(&(text + self.hint(&file, &options)))?;
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

    /// The mesh with colours where an STL file has attribute bytes: of the faces, or in OBJ, which has no colours of faces, of the vertices.
    fn decoded(&self, file: &ReadFile, options: &WriteOptions) -> Result<PolygonMesh, Failure> {
        if self.stl_colors == StlColors::Keep || file.format != Format::Stl {
            return Ok(file.mesh.clone());
        }
        let elements = match options.format {
            Some(Format::Obj) => ColorElements::Vertices,
            _ => ColorElements::Faces,
        };
        decode_stl_colors(&file.mesh, elements)
            .map_err(|error| Failure::unwritable(&output_name(&self.output), error))
    }

    /// A line about attribute bytes that might have become colours.
    fn hint(&self, file: &ReadFile, options: &WriteOptions) -> &'static str {
        let may_be_colors = file.notes.iter().any(|note| note.kind == NoteKind::PerhapsColors);
        let are_kept = self.stl_colors == StlColors::Keep && options.format != Some(Format::Stl);
        if may_be_colors && are_kept {
            "\nthe attribute bytes are written as numbers; --stl-colors decode makes colours of them\n"
        } else {
            ""
        }
    }
}
