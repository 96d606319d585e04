//! Pictures: scenes in a grid with a legend, ready to be written as SVG or PNG.

use std::io::{self, Write};

use meshmend_core::FaceId;
use thiserror::Error;

use crate::frame::{Bounds, Frame, Unit};
use crate::layout::{GAP, Layout, arranged};
use crate::legend::{Entry, Swatch, merged};
use crate::overlay::NoSuchElement;
use crate::panel::{Panel, bounds, possible_entries, shown_vertices};
use crate::scene::Scene;
use crate::{raster, svg};

/// How large a picture is, in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    width: u32,
    height: u32,
}

/// How the pictures of a sheet are scaled.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Fit {
    /// Each fills its own place.
    #[default]
    Each,
    /// All to one scale and from one middle, so that what did not move is in the same place in all of them.
    Together,
}

/// Why there is no picture.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum RenderError {
    /// A picture can't have that size.
    #[error("a picture of {width}x{height} pixels: each side must be from {SMALLEST} to {LARGEST}")]
    Size {
        /// The width asked for.
        width: u32,
        /// The height asked for.
        height: u32,
    },
    /// The pictures of a sheet would be too small to show anything.
    #[error("{count} pictures do not fit into {width}x{height} pixels")]
    Crowded {
        /// How many there are.
        count: usize,
        /// The width of the sheet.
        width: u32,
        /// The height of the sheet.
        height: u32,
    },
    /// An overlay is for another mesh.
    #[error(transparent)]
    NoSuchElement(#[from] NoSuchElement),
}

/// Neither side of a picture is shorter than this, in pixels.
const SMALLEST: u32 = 32;

/// Neither side of a picture is longer than this, in pixels.
const LARGEST: u32 = 8192;

/// A picture in a sheet is no smaller than this, in pixels.
const SMALLEST_PANEL: f64 = 24.0;

/// A picture has no more samples than this, unless it has more pixels.
const MOST_SAMPLES: usize = 40_000_000;

/// Samples a pixel along each axis, at most.
const FINEST: usize = 3;

impl Size {
    /// A width and a height.
    ///
    /// # Errors
    /// When one of them is below 32 or above 8192 pixels.
    pub fn new(width: u32, height: u32) -> Result<Self, RenderError> {
        let allowed = SMALLEST..=LARGEST;
        if allowed.contains(&width) && allowed.contains(&height) {
            Ok(Size { width, height })
        } else {
            Err(RenderError::Size { width, height })
        }
    }

    /// The width in pixels.
    pub fn width(self) -> u32 {
        self.width
    }

    /// The height in pixels.
    pub fn height(self) -> u32 {
        self.height
    }

    /// Samples a pixel along each axis.
    fn density(self) -> usize {
        let pixels = self.width as usize * self.height as usize;
        (1..=FINEST).rev().find(|density| pixels * density * density <= MOST_SAMPLES).unwrap_or(1)
    }
}

/// One scene or several, drawn.
#[derive(Clone, Debug)]
pub struct Picture {
    pub(crate) size: Size,
    pub(crate) panels: Vec<Panel>,
    /// What is above each panel.
    pub(crate) captions: Vec<String>,
    pub(crate) caption_height: f64,
    pub(crate) legend_height: f64,
    /// The entries of the legend with their places: to the right in pixels, and the row.
    pub(crate) legend: Vec<(Entry, (f64, f64))>,
}

/// Draws one scene.
///
/// Faces are shaded by their slope to the light; their backs are bluish and hatched. Lines that pass behind faces are
/// drawn on, pale and thin. Faces with a corner that is not finite are left out, see [`Picture::left_out`].
///
/// # Errors
/// When an overlay names an element that the mesh does not have.
///
/// *Cost*: linear in the mesh, in the samples (up to nine a pixel) that its faces cover, and in the length of all lines
/// in pixels; about 8 bytes a sample and 28 a vertex or face.
pub fn render(scene: &Scene, size: Size) -> Result<Picture, RenderError> {
    contact_sheet(std::slice::from_ref(scene), Fit::Each, size)
}

/// Draws scenes side by side, each with its caption, over one legend.
///
/// # Errors
/// When an overlay names an element that its mesh does not have, or there are too many scenes for the size.
///
/// *Cost*: as [`render`], for each scene.
pub fn contact_sheet(scenes: &[Scene], fit: Fit, size: Size) -> Result<Picture, RenderError> {
    for scene in scenes {
        scene.overlays.iter().try_for_each(|overlay| overlay.check(&scene.mesh))?;
    }
    let possible: Vec<Entry> = scenes.iter().flat_map(possible_entries).collect();
    let captions: Vec<String> = scenes.iter().map(caption).collect();
    let has_captions = captions.iter().any(|caption| !caption.is_empty());
    let seen = extents(scenes, fit);
    let shape = seen.iter().fold([0.0_f64; 2], |most, (_, seen)| {
        let [width, height] = seen.extent();
        [most[0].max(width), most[1].max(height)]
    });
    let layout = Layout::new(size, scenes.len(), shape, &merged(possible.iter()), has_captions);
    if layout.smallest_side() < SMALLEST_PANEL {
        let Size { width, height } = size;
        return Err(RenderError::Crowded { count: scenes.len(), width, height });
    }
    let draw = |((scene, (unit, seen)), place): ((&Scene, (Unit, Bounds)), _)| {
        let frame = Frame::new(scene.camera, unit, seen, place, GAP);
        Panel::draw(scene, &frame, place, size.density())
    };
    let panels: Vec<Panel> = scenes.iter().zip(seen).zip(layout.panels).map(draw).collect();
    let entries = merged(panels.iter().flat_map(|panel| &panel.entries));
    let legend = fitting(entries, f64::from(size.width), layout.legend_height);
    Ok(Picture {
        size,
        panels,
        captions,
        caption_height: layout.caption_height,
        legend_height: layout.legend_height,
        legend,
    })
}

impl Picture {
    /// Its size.
    pub fn size(&self) -> Size {
        self.size
    }

    /// What the legend says.
    pub fn legend(&self) -> Vec<&str> {
        self.legend.iter().map(|(entry, _)| entry.text.as_str()).collect()
    }

    /// For each scene, the faces that are not drawn because a corner of theirs is not finite, ascending.
    pub fn left_out(&self) -> impl ExactSizeIterator<Item = &[FaceId]> {
        self.panels.iter().map(|panel| panel.left_out.as_slice())
    }

    /// The colours of the pixels, row by row: red, green and blue.
    ///
    /// *Cost*: the samples, and the pixels that lines cover.
    pub fn pixels(&self) -> Vec<[u8; 3]> {
        raster::pixels(self)
    }

    /// Writes the picture as PNG.
    ///
    /// # Errors
    /// When writing fails.
    ///
    /// *Cost*: as [`pixels`](Self::pixels), and compressing them.
    pub fn write_png(&self, out: &mut dyn Write) -> io::Result<()> {
        raster::write_png(self, out)
    }

    /// Writes the picture as SVG, of the same content. Faces of which no sample is seen are left out, and the others
    /// are drawn from the farthest middle to the nearest, so that where a large face passes over and under its
    /// neighbours a wrong one may cover the other; PNG has no such limit. Lines are cut as in PNG.
    ///
    /// # Errors
    /// When writing fails.
    ///
    /// *Cost*: O(n log n) for n seen faces, and what the lines have of points.
    pub fn write_svg(&self, out: &mut dyn Write) -> io::Result<()> {
        svg::write_svg(self, out)
    }
}

/// How each scene is brought near one, and what it then covers in the plane of the picture.
fn extents(scenes: &[Scene], fit: Fit) -> Vec<(Unit, Bounds)> {
    let together = scenes.iter().fold(Bounds::EMPTY, |all, scene| match fit {
        Fit::Each => all,
        Fit::Together => all.and(bounds(scene)),
    });
    let unit = |scene: &Scene| match fit {
        Fit::Each => Unit::of(bounds(scene)),
        Fit::Together => Unit::of(together),
    };
    let seen = |scene: &Scene| {
        let unit = unit(scene);
        let projected = |v| Frame::projected(&scene.camera, &unit, scene.mesh.position(v));
        (unit, Bounds::of(shown_vertices(scene).map(projected)))
    };
    let mut extents: Vec<(Unit, Bounds)> = scenes.iter().map(seen).collect();
    if fit == Fit::Together {
        let all = extents.iter().fold(Bounds::EMPTY, |all, (_, seen)| all.and(*seen));
        extents.iter_mut().for_each(|(_, seen)| *seen = all);
    }
    extents
}

/// What is above a scene: its caption, and what is not drawn.
fn caption(scene: &Scene) -> String {
    let mesh = &scene.mesh;
    let faces = mesh.complex().faces();
    let is_finite = |face: &FaceId| faces.face_vertices(*face).iter().all(|&v| mesh.is_finite(v));
    let left_out = faces.faces().filter(|face| !is_finite(face)).count();
    let caption = scene.caption.clone().unwrap_or_default();
    match left_out {
        0 => caption,
        count => format!("{caption} (not finite, left out: {count})").trim_start().to_owned(),
    }
}

/// The entries that fit into the legend's height; where not all do, the last one says how many more there are. In no
/// row there is none.
fn fitting(mut entries: Vec<Entry>, width: f64, height: f64) -> Vec<(Entry, (f64, f64))> {
    let rows = (height / crate::layout::LINE).round();
    let whole = entries.len();
    loop {
        let places = arranged(&entries, width);
        if places.last().is_none_or(|place| place.1 < rows) {
            return entries.into_iter().zip(places).collect();
        }
        if rows < 1.0 {
            return Vec::new();
        }
        entries.truncate(entries.len().saturating_sub(2));
        entries.push(Entry::new(Swatch::None, format!("and {} more", whole - entries.len())));
    }
}
