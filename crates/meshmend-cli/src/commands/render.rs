//! `meshmend render`: a picture of a mesh.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use meshmend::PolygonMesh;
use meshmend::mesh::counted;
use meshmend_render::{
    Camera, Fit, LoopOverlays, Outlines, Overlay, OverlayKind, Picture, Placed, Projection, RenderError,
    Scene, Size,
};

use super::placed_overlays::placed_overlays;
use crate::console::Console;
use crate::failure::{Failure, Status};
use crate::format_words;
use crate::outputs::{Content, Files};
use crate::render;
use crate::streams::{InputWords, Report, is_stream, name, output_name, reserve, write_with};
use crate::words::{self, Welding};

/// Draw a mesh, and on it what is wrong with it or how it hangs together, as SVG or PNG
///
/// What passes behind faces is drawn pale and thin. Backs of faces are bluish and hatched.
#[derive(Debug, Args)]
pub(crate) struct Render {
    #[arg(help = format_words::input_help(), value_name = "FILE")]
    pub(super) input: PathBuf,
    /// The file to write, named `.svg` or `.png`; `-` is standard output
    #[arg(short, long, value_name = "PICTURE")]
    output: PathBuf,
    #[command(flatten)]
    from: InputWords,
    /// The format of the picture, whatever its name
    #[arg(long, value_name = "FORMAT", value_enum)]
    to: Option<PictureFormat>,
    /// What to show on the faces [default: what may be wrong]
    #[arg(long, value_name = "KIND", value_delimiter = ',', value_enum)]
    overlay: Vec<OverlayWord>,
    /// How large the picture is, in pixels [default: 800x600, or 1200x900 for several]
    #[arg(long, value_name = "WxH", value_parser = size)]
    size: Option<Size>,
    /// From where to look: a direction from the mesh to the eye
    #[arg(long, value_name = "X,Y,Z", value_parser = vector, allow_hyphen_values = true)]
    view: Option<[f64; 3]>,
    /// Which direction is up in the picture
    #[arg(long, value_name = "X,Y,Z", value_parser = vector, allow_hyphen_values = true, default_value = "0,0,1")]
    up: Vector,
    /// From where to look: degrees about the z axis, counter-clockwise from the x axis [default: -45]
    #[arg(long, value_name = "DEGREES", allow_hyphen_values = true, conflicts_with_all = ["view", "up"])]
    azimuth: Option<f64>,
    /// From where to look: degrees above the xy plane [default: 30]
    #[arg(long, value_name = "DEGREES", allow_hyphen_values = true, conflicts_with_all = ["view", "up"])]
    elevation: Option<f64>,
    /// Draw what is nearer larger
    #[arg(long)]
    perspective: bool,
    /// Draw the edges of the faces
    #[arg(long)]
    edges: bool,
    /// Draw a picture for each item of a kind
    #[arg(long, value_name = "KIND", value_enum, conflicts_with = "before_after")]
    contact_sheet: Option<SheetWord>,
    /// Draw the mesh beside what the default repair makes of it
    #[arg(long)]
    before_after: bool,
    /// Draw as welded: none, exact, single, a length, or a percentage of the bounding box's diagonal; by default exact for
    /// STL, which has no indices, and none for others
    #[arg(long, value_name = "DISTANCE", value_parser = words::welding)]
    weld: Option<Welding>,
}

type Vector = [f64; 3];

/// What a contact sheet has a picture of each.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum SheetWord {
    /// Closed paths that can't be shrunk
    Generators,
}

/// What can be shown on faces.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum OverlayWord {
    /// Edges with one face
    Boundary,
    /// Edges with three faces or more, and vertices that join several umbrellas
    NonManifold,
    /// Edges along which two faces run the same way
    Inconsistent,
    /// Strips of faces that come back mirrored
    Witness,
    /// What hangs together, by colour and number
    Components,
    /// Closed paths that can't be shrunk
    Generators,
    /// The shortest paths from which the generators come
    Tree,
    /// The tree of faces across the other edges
    Cotree,
    /// Where to cut what has one side only
    Seam,
    /// Faces that cross or overlap
    Crossings,
    /// Vertices on open edges that they are not joined to, and those edges
    TJunctions,
    /// Boundary loops that are not the outer borders of sheets
    Holes,
    /// Faces that are too thin, or have no area
    Slivers,
    /// Closed components that look inward
    InsideOut,
    /// Faces inside of what others enclose
    Internal,
    /// No overlay: the faces alone
    None,
}

impl OverlayWord {
    fn kind(self) -> Option<OverlayKind> {
        Some(match self {
            OverlayWord::Boundary => OverlayKind::Boundary,
            OverlayWord::NonManifold => OverlayKind::NonManifold,
            OverlayWord::Inconsistent => OverlayKind::Inconsistent,
            OverlayWord::Witness => OverlayKind::Witness,
            OverlayWord::Components => OverlayKind::Components,
            OverlayWord::Generators => OverlayKind::Generators,
            OverlayWord::Tree => OverlayKind::Tree,
            OverlayWord::Cotree => OverlayKind::Cotree,
            OverlayWord::Seam => OverlayKind::Seam,
            OverlayWord::Crossings => OverlayKind::Placed(Placed::Crossings),
            OverlayWord::TJunctions => OverlayKind::Placed(Placed::TJunctions),
            OverlayWord::Holes => OverlayKind::Placed(Placed::Holes),
            OverlayWord::Slivers => OverlayKind::Placed(Placed::Slivers),
            OverlayWord::InsideOut => OverlayKind::Placed(Placed::InsideOut),
            OverlayWord::Internal => OverlayKind::Placed(Placed::Internal),
            OverlayWord::None => return None,
        })
    }
}

/// What is shown unless something else is asked for.
const WRONG: [OverlayKind; 4] =
    [OverlayKind::Boundary, OverlayKind::NonManifold, OverlayKind::Inconsistent, OverlayKind::Witness];

/// The formats of pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum PictureFormat {
    /// Lines and areas, as text
    Svg,
    /// Pixels
    Png,
}

impl Render {
    pub(crate) fn run(self, console: &mut Console<'_>) -> Result<Status, Failure> {
        let format = self.to.map_or_else(|| format_of(&self.output), Ok)?;
        Files::of_mesh(&self.input).writing("--output", Some(&self.output), Content::Picture).check()?;
        reserve(&self.output, Report::Text, console)?;
        let camera = self.camera()?;
        let progress = console.progress(3);
        progress.step("read");
        let file = self.from.read(&self.input, console)?;
        let failed = |error| Failure::of_pass(&name(&self.input), &error);
        let view = words::view(self.weld, &file);
        let mesh = view.of(&file.mesh).map_err(failed)?;
        progress.step("draw");
        let scenes = if self.before_after {
            let repaired = meshmend::repair(&file.mesh).map_err(failed)?;
            vec![
                self.scene(&mesh, camera, Some("before"))?,
                self.scene(&repaired.mesh, camera, Some("after"))?,
            ]
        } else if self.contact_sheet.is_some() {
            self.sheet(&mesh, camera)?
        } else {
            vec![self.scene(&mesh, camera, None)?]
        };
        let picture = self.draw(&scenes)?;
        progress.step("write");
        write(&self.output, format, &picture, console)?;
        drop(progress);
        console.write(&render::picture(&name(&self.input), &output_name(&self.output), &scenes, &picture))?;
        Ok(Status::Done)
    }

    fn camera(&self) -> Result<Camera, Failure> {
        let angles = (self.azimuth.unwrap_or(-45.0), self.elevation.unwrap_or(30.0));
        let camera = match self.view {
            Some(view) => Camera::from(view, self.up),
            None => Camera::from_angles(angles.0, angles.1),
        };
        let projection = if self.perspective { Projection::Perspective } else { Projection::Orthographic };
        let camera = camera.map_err(|error| Failure::usage(error.to_string()))?;
        Ok(camera.with_projection(projection))
    }

    fn kinds(&self) -> Vec<OverlayKind> {
        // A sheet shows one thing a picture.
        if self.overlay.is_empty() && self.contact_sheet.is_none() {
            return WRONG.to_vec();
        }
        self.overlay.iter().filter_map(|word| word.kind()).collect()
    }

    /// A mesh with what is to be shown on it.
    fn scene(&self, mesh: &PolygonMesh, camera: Camera, caption: Option<&str>) -> Result<Scene, Failure> {
        let outlines = if self.edges { Outlines::Drawn } else { Outlines::Omitted };
        let overlays = overlays(mesh, &self.kinds())?;
        let caption = caption.map(str::to_owned);
        Ok(Scene { mesh: mesh.clone(), camera, outlines, overlays, caption })
    }

    /// A picture for each generator; of a mesh without any, one that says so.
    fn sheet(&self, mesh: &PolygonMesh, camera: Camera) -> Result<Vec<Scene>, Failure> {
        let plain = self.scene(mesh, camera, Some("no generators"))?;
        let found = loops(mesh)?;
        let Overlay::Generators { loops, more } = found.generators else { return Ok(vec![plain]) };
        if more > 0 {
            let count = loops.len() + more;
            return Err(Failure::usage(format!(
                "a sheet of {count} generators would be too large to look at"
            )));
        }
        let scene = |(number, path): (usize, &Vec<_>)| {
            let mut scene = plain.clone();
            scene.overlays.push(Overlay::Generators { loops: vec![path.clone()], more: 0 });
            scene.caption = Some(format!("generator {number}: {}", counted(path.len(), "edge")));
            scene
        };
        let scenes: Vec<Scene> = loops.iter().enumerate().map(scene).collect();
        Ok(if scenes.is_empty() { vec![plain] } else { scenes })
    }

    fn draw(&self, scenes: &[Scene]) -> Result<Picture, Failure> {
        let (width, height) = if scenes.len() > 1 { (1200, 900) } else { (800, 600) };
        let (width, height) = if self.before_after { (width, 560) } else { (width, height) };
        let failed = |error: RenderError| Failure::usage(error.to_string());
        let size = self.size.map_or_else(|| Size::new(width, height), Ok).map_err(failed)?;
        meshmend_render::contact_sheet(scenes, Fit::Together, size).map_err(failed)
    }
}

/// The overlays of some kinds.
fn overlays(mesh: &PolygonMesh, kinds: &[OverlayKind]) -> Result<Vec<Overlay>, Failure> {
    let of_loops = [OverlayKind::Generators, OverlayKind::Tree, OverlayKind::Cotree];
    let found = if kinds.iter().any(|kind| of_loops.contains(kind)) { Some(loops(mesh)?) } else { None };
    let asked =
        kinds.iter().filter_map(|kind| if let OverlayKind::Placed(what) = kind { Some(*what) } else { None });
    let placed = placed_overlays(mesh, &asked.collect::<Vec<_>>())?;
    let overlay = |kind: &OverlayKind| match kind {
        OverlayKind::Placed(_) => placed.iter().find(|overlay| overlay.kind() == *kind).cloned(),
        OverlayKind::Boundary => Some(meshmend_render::boundary(mesh)),
        OverlayKind::NonManifold => Some(meshmend_render::non_manifold(mesh)),
        OverlayKind::Inconsistent => Some(meshmend_render::inconsistent(mesh)),
        OverlayKind::Witness => Some(meshmend_render::witness(mesh)),
        OverlayKind::Components => Some(meshmend_render::components(mesh)),
        OverlayKind::Seam => Some(meshmend_render::seam(mesh)),
        OverlayKind::Generators => found.as_ref().map(|found| found.generators.clone()),
        OverlayKind::Tree => found.as_ref().map(|found| found.tree.clone()),
        OverlayKind::Cotree => found.as_ref().map(|found| found.cotree.clone()),
    };
    Ok(kinds.iter().filter_map(overlay).collect())
}

fn loops(mesh: &PolygonMesh) -> Result<LoopOverlays, Failure> {
    meshmend_render::loops(mesh)
        .map_err(|error| Failure { status: Status::Refused, message: error.to_string() })
}

fn format_of(path: &Path) -> Result<PictureFormat, Failure> {
    let extension = path.extension().and_then(|extension| extension.to_str()).map(str::to_ascii_lowercase);
    match extension.as_deref() {
        Some("svg") => Ok(PictureFormat::Svg),
        Some("png") => Ok(PictureFormat::Png),
        _ if is_stream(path) => Err(Failure::usage("standard output: --to must tell the format, svg or png")),
        _ => Err(Failure::usage(format!("{}: a picture's name ends in .svg or .png", path.display()))),
    }
}

fn write(
    path: &Path,
    format: PictureFormat,
    picture: &Picture,
    console: &mut Console<'_>,
) -> Result<(), Failure> {
    write_with(path, console, |out| match format {
        PictureFormat::Svg => picture.write_svg(out),
        PictureFormat::Png => picture.write_png(out),
    })
}

/// Reads a size such as `800x600`.
fn size(word: &str) -> Result<Size, String> {
    let sides = word.split_once(['x', 'X', '×']).map(|(width, height)| (width.parse(), height.parse()));
    let Some((Ok(width), Ok(height))) = sides else {
        return Err("expected a width and a height in pixels, such as 800x600".to_owned());
    };
    Size::new(width, height).map_err(|error| error.to_string())
}

/// Reads three numbers with commas between them.
fn vector(word: &str) -> Result<[f64; 3], String> {
    let numbers: Vec<f64> = word.split(',').map_while(|number| number.trim().parse().ok()).collect();
    match *numbers {
        [x, y, z] if word.split(',').count() == 3 && numbers.iter().all(|x| x.is_finite()) => Ok([x, y, z]),
        _ => Err("expected three numbers, such as 1,-2,0.5".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_read_or_refused() {
        assert_eq!(size("800x600"), Ok(Size::new(800, 600).unwrap()));
        assert!(["800", "800x", "0x10", "-1x5", "99999x20"].iter().all(|word| size(word).is_err()));
        assert_eq!(vector("1, -2,0.5"), Ok([1.0, -2.0, 0.5]));
        assert!(["1,2", "1,2,3,4", "a,b,c", "1,,2", "1,nan,2"].iter().all(|word| vector(word).is_err()));
        assert_eq!(format_of(Path::new("a.PNG")).ok(), Some(PictureFormat::Png));
        assert!(format_of(Path::new("a.gif")).is_err() && format_of(Path::new("svg")).is_err());
    }

    #[test]
    fn every_kind_of_overlay_has_a_word() {
        let words = OverlayWord::value_variants().iter().filter_map(|word| {
            Some((word.kind()?, word.to_possible_value().map(|value| value.get_name().to_owned())))
        });
        for ((kind, word), expected) in words.zip(OverlayKind::ALL) {
            assert_eq!((kind, word.as_deref()), (*expected, Some(expected.name())));
        }
    }
}
