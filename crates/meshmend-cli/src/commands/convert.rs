//! `meshmend convert`: the same mesh in another format.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use meshmend::formats::{
    ColorElements, Document, Loss, NoteKind, PreparedDocument, WriteError, decode_stl_colors,
};
use meshmend::{
    CheckOptions, Criterion, Failing, Format, Gate, GeometryOptions, Question, Questions, Rules, View,
    WriteOptions, check,
};

use crate::console::Console;
use crate::failure::{Failure, Status};
use crate::gate_words::{self, GateWords};
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
    #[command(flatten)]
    gate: GateWords,
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
    pub(crate) fn run(self, rules: Rules, console: &mut Console<'_>) -> Result<Status, Failure> {
        let gate = self.gate.conversion(rules)?;
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
        let losses = prepared.losses();
        let failing = self.failing(&gate, rules, &document, &losses)?;
        let is_withheld = self.gate.withholds(&failing);
        if !is_withheld {
            write_document(&self.output, &prepared, console)?;
        }
        drop(progress);
        let (input, output) = (name(&self.input), output_name(&self.output));
        if !is_withheld {
            let text = render::conversion(&input, &output, &document, &losses);
            console.write(&(text + self.hint(&document, &options)))?;
        }
        Ok(gate_words::judged(&input, &failing, !is_withheld, console))
    }

    /// What of the file fails the run: the defects that a check of it counts, and the losses.
    fn failing(
        &self,
        gate: &Gate,
        rules: Rules,
        document: &Document,
        losses: &[Loss],
    ) -> Result<Vec<Failing>, Failure> {
        let kinds = gate.defects();
        let mut found = vec![0; kinds.len()];
        if !kinds.is_empty() {
            let needed: Questions = kinds.iter().filter_map(|&kind| Question::about(kind)).collect();
            let geometry = (!needed.is_empty()).then(|| GeometryOptions::default().asking(needed));
            for part in document.parts.iter().filter(|part| part.seal().is_none()) {
                let view = View::usual_for_part(document.format, part);
                let options =
                    CheckOptions::default().with_rules(rules).with_view(view).with_geometry(geometry);
                let report = check(&part.mesh, &options)
                    .map_err(|error| Failure::of_pass(&name(&self.input), &error))?;
                found.iter_mut().zip(&kinds).for_each(|(found, &kind)| *found += report.count(kind) as u64);
            }
        }
        let of_kind = |kind| kinds.iter().position(|&known| known == kind).map_or(0, |place| found[place]);
        Ok(gate.failing(|criterion| match criterion {
            Criterion::Defect(kind) => of_kind(kind),
            other => other.count_in(losses),
        }))
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
