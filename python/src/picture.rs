//! A picture of a mesh, with what is wrong with it marked.

use meshmend::PassError;
use meshmend_render::{
    Camera, Outlines, Overlay, RenderError, Scene, Size, boundary, inconsistent, non_manifold, render,
    witness,
};
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::errors::{self, Done, Problem};
use crate::how::How;
use crate::mesh::MeshHandle;
use crate::words;

/// From where a mesh is seen, as by the command.
const AZIMUTH: f64 = -45.0;
const ELEVATION: f64 = 30.0;

#[derive(Clone, Copy)]
enum Form {
    Png,
    Svg,
}

/// Draws a mesh; the bytes of a PNG or an SVG.
#[pyfunction]
pub(crate) fn picture<'py>(
    py: Python<'py>,
    mesh: &Bound<'py, MeshHandle>,
    with_defects: bool,
    size: (u32, u32),
    format: &str,
    how: How<'py>,
) -> PyResult<Bound<'py, PyBytes>> {
    let form = errors::raise(py, words::chosen("format", format, &[("png", Form::Png), ("svg", Form::Svg)]))?;
    let mesh = &mesh.get().mesh;
    let drawn = how.watched(py)?.run(|watch| -> Done<Vec<u8>> {
        let look = || watch.look("picture", 0, 0).map_err(PassError::from);
        let mut overlays: Vec<Overlay> = Vec::new();
        if with_defects {
            for overlay in [boundary, non_manifold, inconsistent, witness] {
                look()?;
                overlays.push(overlay(mesh));
            }
        }
        look()?;
        let failed = |error: RenderError| Problem::Value(error.to_string());
        let camera =
            Camera::from_angles(AZIMUTH, ELEVATION).map_err(|error| Problem::Value(error.to_string()))?;
        let scene =
            Scene { mesh: mesh.clone(), camera, outlines: Outlines::Omitted, overlays, caption: None };
        let picture = render(&scene, Size::new(size.0, size.1).map_err(failed)?).map_err(failed)?;
        look()?;
        let mut bytes = Vec::new();
        let written = match form {
            Form::Png => picture.write_png(&mut bytes),
            Form::Svg => picture.write_svg(&mut bytes),
        };
        written.map_err(|error| Problem::Value(error.to_string()))?;
        Ok(bytes)
    })?;
    Ok(PyBytes::new(py, &errors::raise(py, drawn)?))
}
