//! The writer of a package that was read: what changed is put into its text.
//!
//! Each layer `row` says which row of the file an element of the mesh is. Rows that stay are copied as text; all else
//! in a model, and all other entries of the package, are copied as they are.

mod losses;
mod numbers;
mod object;
mod rows;
mod triangles;
mod vertices;

use std::io;

use meshmend_core::PolygonMesh;

use self::numbers::Edit;
use self::object::{edited, edits, is_as_read};
use crate::document::{Document, Part};
use crate::formats::threemf::kept::{ModelText, Package};
use crate::formats::threemf::package::{Budget, with_contents};
use crate::formats::threemf::parts::Origin;
use crate::formats::threemf::xml::{Text, declared_as_utf8};
use crate::shell::Spliced;
use crate::{Format, Loss, Prepared, WriteErrorKind, WriteOptions};

/// The package with the meshes that the parts of a document have now.
///
/// # Errors
/// If a mesh can't be cut into triangles.
///
/// *Cost*: linear in the package, and in the texts of models that change.
pub(super) fn spliced(package: &Package, document: &Document) -> Result<Spliced, WriteErrorKind> {
    let (mut contents, mut losses) = (Vec::new(), Vec::new());
    for (number, model) in package.models.iter().enumerate() {
        let parts = document.parts.iter().zip(&package.origins).filter(|(part, origin)| {
            origin.model == number && part.seal().is_none() && !is_as_read(&part.mesh, origin)
        });
        let parts: Vec<(&Part, &Origin)> = parts.collect();
        if !parts.is_empty() {
            contents.extend(changed_model(package, model, &parts, &mut losses)?);
        }
    }
    contents.sort_by_key(|(place, _)| *place);
    let bytes = if contents.is_empty() {
        package.bytes.to_vec()
    } else {
        with_contents(&package.bytes, &package.directory, &contents)?
    };
    Ok(Spliced { bytes, losses, companions: Vec::new() })
}

/// The place of a model in the package and its new text, if that is another one.
fn changed_model(
    package: &Package,
    model: &ModelText,
    parts: &[(&Part, &Origin)],
    losses: &mut Vec<Loss>,
) -> Result<Option<(usize, Vec<u8>)>, WriteErrorKind> {
    let Some((_, entry)) = package.directory.entry(&model.entry) else { return Ok(None) };
    let content = Budget::of(u64::MAX).content(&package.bytes, entry);
    let text = content.and_then(|content| Text::of(content, &model.entry));
    let text = text.map_err(|fault| io::Error::other(fault.to_string()))?.text;
    let mut all = Vec::new();
    for (part, origin) in parts {
        all.extend(object_edits(&text, part, origin, losses)?);
    }
    all.retain(|edit: &Edit| text[edit.place.clone()] != edit.text);
    if all.is_empty() {
        return Ok(None);
    }
    let text = edited(&text, all);
    if !model.was_utf16 {
        return Ok(Some((model.place, text.into_bytes())));
    }
    losses.push(losses::encoding(&model.entry));
    Ok(Some((model.place, declared_as_utf8(&text).into_bytes())))
}

fn object_edits(
    text: &str,
    part: &Part,
    origin: &Origin,
    losses: &mut Vec<Loss>,
) -> Result<Vec<Edit>, WriteErrorKind> {
    let (mesh, cut) = in_triangles(&part.mesh)?;
    let has_triangles = mesh.faces().faces().any(|face| mesh.faces().corner_range(face).len() == 3);
    if !has_triangles && origin.mesh.counts().faces > 0 {
        losses.push(losses::kept(part, origin, "nothing would be left of it"));
        return Ok(Vec::new());
    }
    let Some((edits, told)) = edits(text, origin, &mesh) else {
        losses.push(losses::kept(part, origin, "it has no lists of vertices and triangles to be changed"));
        return Ok(Vec::new());
    };
    losses.extend(cut);
    losses.extend(losses::of_object(part, origin, &told));
    losses.extend(losses::not_of_the_file(&mesh, &origin.mesh));
    Ok(edits)
}

/// A mesh with its polygons cut, and what that loses.
fn in_triangles(mesh: &PolygonMesh) -> Result<(PolygonMesh, Vec<Loss>), WriteErrorKind> {
    let prepared = Prepared::new(mesh, &WriteOptions::of(Format::ThreeMf))?;
    Ok((prepared.mesh, prepared.losses))
}
