//! `meshmend make`: meshes whose topology is known beforehand.

use std::path::PathBuf;

use clap::Args;
use meshmend::shapes::{NamedShape, Shape, ShapeError, Sizes};

use crate::console::Console;
use crate::failure::{Failure, Status};
use crate::output_words::OutputWords;
use crate::render;
use crate::streams::{Report, output_name, reserve, write_mesh};
use crate::words;

/// Write a mesh whose every figure is known: surfaces of any kind, and complexes that branch
///
/// What is known of it is printed, from closed forms, not from looking at it.
#[derive(Debug, Args)]
pub(crate) struct Make {
    /// Which shape; `--list` names them all
    #[arg(value_name = "SHAPE", value_parser = words::shape, required_unless_present = "list")]
    shape: Option<&'static NamedShape>,
    /// The file to write; `-` is standard output
    #[arg(short, long, value_name = "OUT", required_unless_present = "list")]
    output: Option<PathBuf>,
    /// List the shapes with their sizes, and make nothing
    #[arg(long, conflicts_with_all = ["shape", "output"])]
    list: bool,
    #[command(flatten)]
    sizes: SizeWords,
    /// Cut each face of n corners into n quads, so many times
    #[arg(long, value_name = "TIMES", default_value_t = 0)]
    refine: usize,
    /// Cut each face into triangles; always done for STL
    #[arg(long)]
    triangles: bool,
    #[command(flatten)]
    words: OutputWords,
}

/// How large a shape is.
#[derive(Clone, Copy, Debug, Args)]
#[command(next_help_heading = "Sizes")]
struct SizeWords {
    /// How finely it is divided
    #[arg(long, value_name = "N")]
    resolution: Option<usize>,
    /// How many pages, tubes, triangles or turns it has
    #[arg(long, value_name = "N")]
    count: Option<usize>,
    /// How many handles a surface has
    #[arg(long, value_name = "G")]
    genus: Option<usize>,
    /// How many cross-caps a surface has, in place of handles
    #[arg(long, value_name = "M", conflicts_with = "genus")]
    cross_caps: Option<usize>,
    /// How many holes a surface has
    #[arg(long, value_name = "B")]
    holes: Option<usize>,
}

impl Make {
    pub(crate) fn run(self, console: &mut Console<'_>) -> Result<Status, Failure> {
        let (Some(named), Some(output)) = (self.shape, &self.output) else {
            console.write(&render::shapes(console.style()))?;
            return Ok(Status::Done);
        };
        let options = self.words.options(output)?;
        reserve(output, Report::Text, console)?;
        let needs_triangles = self.triangles || options.format.is_some_and(|format| !format.holds_polygons());
        let progress = console.progress(2);
        progress.step("make");
        let shape = self.shape(named, needs_triangles).map_err(|error| Failure::usage(error.to_string()))?;
        progress.step("write");
        let losses = write_mesh(output, &shape.mesh, &options, console)?;
        drop(progress);
        console.write(&render::shape(&output_name(output), &shape, &losses))?;
        Ok(Status::Done)
    }

    fn shape(&self, named: &NamedShape, in_triangles: bool) -> Result<Shape, ShapeError> {
        let SizeWords { resolution, count, genus, cross_caps, holes } = self.sizes;
        let shape = named.make(&Sizes { resolution, count, genus, cross_caps, holes })?;
        let shape = shape.refined_times(self.refine)?;
        if in_triangles { shape.triangulated() } else { Ok(shape) }
    }
}
