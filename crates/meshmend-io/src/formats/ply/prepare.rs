//! What happens to a mesh before it is written as PLY: layers move to where other programs look for them.

use meshmend_core::{Domain, Id, Layer, PolygonMesh, Role, Values};

use crate::formats::ply::expected::{as_expected, to_be_expected};
use crate::{Prepared, WriteErrorKind};

/// Converts values to the types that other programs read, and moves normals to the vertices. Texture coordinates move
/// there, too, if no vertex must be split for them or some face is not a triangle.
pub(super) fn prepare(prepared: &mut Prepared) -> Result<(), WriteErrorKind> {
    prepared.number_textures()?;
    let is_concerned = to_be_expected(prepared);
    as_expected(prepared, &is_concerned)?;
    let places = |prepared: &Prepared, is_wanted: &dyn Fn(&Layer, bool) -> bool| -> Vec<usize> {
        let layers = prepared.mesh.layers().iter().zip(&is_concerned).enumerate();
        layers.filter(|(_, (layer, concerned))| is_wanted(layer, **concerned)).map(|(at, _)| at).collect()
    };
    let is_at_home =
        |layer: &Layer| layer.home() == Domain::Vertex && !matches!(layer.values(), Values::Text(_));
    let is_normal = |layer: &Layer| layer.role() == Role::Normal && layer.domain() == Domain::Corner;
    let first = places(prepared, &|layer, concerned| is_at_home(layer) || concerned && is_normal(layer));
    prepared.bring_to_vertices(&first)?;
    let is_texcoord = |layer: &Layer| layer.role() == Role::TexCoord && layer.width() == 2;
    let texcoords = places(prepared, &|layer, concerned| concerned && is_texcoord(layer));
    if has_polygons(&prepared.mesh) || texcoords.iter().all(|&at| is_smooth(&prepared.mesh, at)) {
        prepared.bring_to_vertices(&texcoords)?;
    }
    Ok(())
}

fn has_polygons(mesh: &PolygonMesh) -> bool {
    let faces = mesh.faces();
    !faces.is_all_triangles() && faces.faces().any(|face| faces.corner_range(face).len() > 3)
}

/// Whether the corners of each vertex agree in a layer.
fn is_smooth(mesh: &PolygonMesh, layer: usize) -> bool {
    let layer = &mesh.layers()[layer];
    let mut first = vec![None; mesh.counts().vertices];
    layer.domain() != Domain::Corner
        || mesh.faces().corners().all(|corner| {
            let first = first[mesh.faces().corner_vertex(corner).index()].get_or_insert(corner);
            layer.agree(first.index(), corner.index())
        })
}
