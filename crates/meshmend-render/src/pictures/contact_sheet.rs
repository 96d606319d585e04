//! Scenes drawn side by side, over one legend.

use meshmend_core::FaceId;

use crate::look::legend::{Entry, Swatch, merged};
use crate::panels::frame::{Bounds, Frame, Unit};
use crate::panels::panel::{Panel, bounds, possible_entries, shown_vertices};
use crate::pictures::error::RenderError;
use crate::pictures::layout::{GAP, LINE, Layout, arranged};
use crate::pictures::picture::Picture;
use crate::pictures::size::Size;
use crate::scenes::scene::Scene;

/// How the pictures of a sheet are scaled.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Fit {
    /// Each fills its own place.
    #[default]
    Each,
    /// All to one scale and from one middle, so that what did not move is in the same place in all of them.
    Together,
}

/// A picture in a sheet is no smaller than this, in pixels.
const SMALLEST_PANEL: f64 = 24.0;

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
        let (width, height) = (size.width(), size.height());
        return Err(RenderError::Crowded { count: scenes.len(), width, height });
    }
    let draw = |((scene, (unit, seen)), place): ((&Scene, (Unit, Bounds)), _)| {
        let frame = Frame::new(scene.camera, unit, seen, place, GAP);
        Panel::draw(scene, &frame, place, size.density())
    };
    let panels: Vec<Panel> = scenes.iter().zip(seen).zip(layout.panels).map(draw).collect();
    let entries = merged(panels.iter().flat_map(|panel| &panel.entries));
    let legend = fitting(entries, f64::from(size.width()), layout.legend_height);
    Ok(Picture {
        size,
        panels,
        captions,
        caption_height: layout.caption_height,
        legend_height: layout.legend_height,
        legend,
    })
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
    let rows = (height / LINE).round();
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
