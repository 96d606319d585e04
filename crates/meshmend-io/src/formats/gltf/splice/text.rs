//! What changes in the JSON.

use std::collections::BTreeMap;

use crate::Limits;
use crate::formats::gltf::asset::Asset;
use crate::formats::gltf::fault::{Fault, Pointer};
use crate::formats::gltf::json::{Edits, ListEdit, Object, Value, parse};
use crate::formats::gltf::primitives::{MANIFOLD, Mesh};
use crate::formats::gltf::splice::layout::{Layout, Moved, NewView};
use crate::formats::gltf::splice::manifold::ManifoldEdit;
use crate::formats::gltf::splice::part_change::{Change, PartChange};
use crate::formats::gltf::splice::slots::{Member, NewAccessor, Renamed, Slots};

/// An extension on primitives that says which triangles are of one polygon, by their order.
const NGONS: &str = "FB_ngon_encoding";

/// The changes of the JSON, but for its buffers.
///
/// # Errors
/// If the JSON is malformed.
pub(super) fn edits_of(
    asset: &Asset<'_>,
    changes: &[PartChange],
    slots: &Slots,
    layout: &Layout,
    manifolds: &[ManifoldEdit],
) -> Result<Edits, Fault> {
    let mut edits = Edits::default();
    let mut root = ListEdit::of(asset.root.value);
    edit_accessors(asset, slots, layout, &mut root, &mut edits)?;
    edit_views(asset, layout, &mut root, &mut edits)?;
    for change in changes {
        let renamed = slots.renamed.iter().filter(|renamed| renamed.mesh == change.mesh).collect();
        let manifold = manifolds.iter().find(|edit| edit.mesh == change.mesh);
        edit_mesh(&asset.mesh(change.mesh)?, change, renamed, manifold, &mut edits)?;
    }
    edit_extensions_used(asset, changes, manifolds, &mut root, &mut edits)?;
    root.into_edits(&mut edits);
    Ok(edits)
}

fn edit_accessors(
    asset: &Asset<'_>,
    slots: &Slots,
    layout: &Layout,
    root: &mut ListEdit<'_>,
    edits: &mut Edits,
) -> Result<(), Fault> {
    let mut added: Vec<(usize, String)> = Vec::new();
    for (accessor, moved) in slots.accessors.iter().zip(&layout.moved) {
        match accessor.like {
            Some(like) if accessor.keeps_slot => {
                accessor_edit(asset.accessors[like], accessor, moved)?.into_edits(edits);
            }
            Some(like) => added.push((accessor.index, copied(asset.accessors[like], accessor, moved)?)),
            None => added.push((accessor.index, fresh(accessor, moved))),
        }
    }
    added.sort_by_key(|(index, _)| *index);
    append(asset.root.get("accessors"), "accessors", added.into_iter().map(|(_, raw)| raw), root, edits);
    Ok(())
}

/// The changes of an accessor that has other rows.
fn accessor_edit<'a>(old: Value<'a>, new: &NewAccessor, moved: &Moved) -> Result<ListEdit<'a>, Fault> {
    let object = Object::of(old, Pointer::item("accessors", new.index))?;
    let mut edit = ListEdit::of(old);
    edit.set("bufferView", moved.view.to_string());
    match (moved.offset, object.get("byteOffset")) {
        (0, None) => {}
        (offset, _) => edit.set("byteOffset", offset.to_string()),
    }
    edit.set("count", new.rows.count().to_string());
    let component = u64::from(new.rows.form.component.code());
    if object.get("componentType").and_then(Value::as_count) != Some(component) {
        edit.set("componentType", component.to_string());
    }
    edit.remove("sparse");
    let [least, most] = new.rows.bounds();
    for (name, bounds) in [("min", least), ("max", most)] {
        // Numbers that are not finite have no place in JSON.
        match bounds.iter().all(|number| number.is_finite()) {
            true if new.needs_bounds || object.get(name).is_some() => edit.set(name, list(&bounds)),
            true => {}
            false => edit.remove(name),
        }
    }
    Ok(edit)
}

/// The text of a new accessor with the members of another one.
fn copied(old: Value<'_>, new: &NewAccessor, moved: &Moved) -> Result<String, Fault> {
    let limits = Limits::default().with_max_json_bytes(u64::MAX).with_max_json_depth(u64::MAX);
    let alone = parse(old.raw().as_bytes(), &limits)?;
    let mut edits = Edits::default();
    accessor_edit(alone, new, moved)?.into_edits(&mut edits);
    Ok(edits.applied(old.raw()))
}

fn fresh(new: &NewAccessor, moved: &Moved) -> String {
    let (form, count) = (new.rows.form, new.rows.count());
    let (view, component, kind) = (moved.view, form.component.code(), form.kind());
    format!("{{\"bufferView\":{view},\"componentType\":{component},\"count\":{count},\"type\":\"{kind}\"}}")
}

fn list(numbers: &[f64]) -> String {
    let numbers: Vec<String> = numbers.iter().map(|number| number.to_string()).collect();
    format!("[{}]", numbers.join(","))
}

fn edit_views(
    asset: &Asset<'_>,
    layout: &Layout,
    root: &mut ListEdit<'_>,
    edits: &mut Edits,
) -> Result<(), Fault> {
    let first = layout.start;
    let known: BTreeMap<usize, &NewView> = layout.views.iter().map(|view| (view.index, view)).collect();
    for (index, &value) in asset.views.iter().enumerate() {
        let mut edit = ListEdit::of(value);
        match known.get(&index) {
            Some(new) => {
                edit.set("buffer", new.buffer.to_string());
                edit.set("byteOffset", (first + new.offset).to_string());
                edit.set("byteLength", new.length.to_string());
            }
            None => {
                let view = asset.view(index)?;
                let shifted = layout.shifted(view.offset as usize);
                if view.buffer != layout.buffer || shifted as u64 == view.offset {
                    continue;
                }
                edit.set("byteOffset", shifted.to_string());
            }
        }
        edit.into_edits(edits);
    }
    let new = layout.views.iter().filter(|view| view.index >= asset.views.len());
    let new: BTreeMap<usize, &NewView> = new.map(|view| (view.index, view)).collect();
    let text = |view: &NewView| {
        let stride = view.stride.map_or(String::new(), |stride| format!(",\"byteStride\":{stride}"));
        // What a graphics card is told: an array of indices, or one of vertices.
        let target = if view.holds_indices { 34963 } else { 34962 };
        let (buffer, offset, length) = (view.buffer, first + view.offset, view.length);
        format!(
            "{{\"buffer\":{buffer},\"byteOffset\":{offset},\"byteLength\":{length}{stride},\"target\":{target}}}"
        )
    };
    append(asset.root.get("bufferViews"), "bufferViews", new.into_values().map(text), root, edits);
    Ok(())
}

/// Adds items to an array of the root, which is made if it is not there.
fn append<'a>(
    array: Option<Value<'a>>,
    name: &str,
    items: impl Iterator<Item = String>,
    root: &mut ListEdit<'_>,
    edits: &mut Edits,
) {
    let items: Vec<String> = items.collect();
    match array {
        _ if items.is_empty() => {}
        None => root.set(name, format!("[{}]", items.join(","))),
        Some(array) => {
            let mut list = ListEdit::of(array);
            items.into_iter().for_each(|item| list.push(item));
            list.into_edits(edits);
        }
    }
}

fn edit_mesh(
    mesh: &Mesh<'_>,
    change: &PartChange,
    renamed: Vec<&Renamed>,
    manifold: Option<&ManifoldEdit>,
    edits: &mut Edits,
) -> Result<(), Fault> {
    let changes: BTreeMap<usize, &Change> =
        change.primitives.iter().map(|primitive| (primitive.primitive, &primitive.change)).collect();
    if let Some(array) = mesh.object.get("primitives") {
        let mut list = ListEdit::of(array);
        let is_removed = |(_, change): &(&usize, &&Change)| matches!(change, Change::Removed);
        changes.iter().filter(is_removed).for_each(|(&at, _)| list.remove_item(at));
        list.into_edits(edits);
    }
    for (at, primitive) in mesh.primitives.iter().enumerate() {
        let kind = changes.get(&at);
        if matches!(kind, Some(Change::Removed)) {
            continue;
        }
        let own: Vec<&&Renamed> = renamed.iter().filter(|renamed| renamed.primitive == at).collect();
        edit_primitive(&primitive.object, kind.copied(), &own, edits)?;
    }
    match manifold {
        Some(ManifoldEdit { is_new: true, stated: Some((indices, Some(positions))), .. }) => {
            add_manifold(&mesh.object, *indices, *positions, edits)
        }
        Some(ManifoldEdit { stated: Some((indices, positions)), .. }) => {
            edit_manifold(&mesh.object, *indices, *positions, edits)
        }
        Some(_) => remove_extension(&mesh.object, MANIFOLD, None, edits),
        None => Ok(()),
    }
}

fn edit_primitive(
    primitive: &Object<'_>,
    change: Option<&Change>,
    renamed: &[&&Renamed],
    edits: &mut Edits,
) -> Result<(), Fault> {
    let mut edit = ListEdit::of(primitive.value);
    let mut attributes = primitive.get("attributes").map(ListEdit::of);
    let mut targets: BTreeMap<usize, ListEdit<'_>> = BTreeMap::new();
    for (at, target) in primitive.items("targets")?.into_iter().enumerate() {
        targets.insert(at, ListEdit::of(target));
    }
    for renamed in renamed {
        let accessor = renamed.accessor.to_string();
        match &renamed.member {
            Member::Indices => edit.set("indices", accessor),
            Member::Attribute(name) => {
                attributes.iter_mut().for_each(|edit| edit.set(name, accessor.clone()))
            }
            Member::OfTarget(target, name) => {
                targets.get_mut(target).into_iter().for_each(|edit| edit.set(name, accessor.clone()));
            }
        }
    }
    if let Some(Change::Indices { has_other_faces, .. }) = change {
        if *has_other_faces && primitive.count_or("mode", 4)? != 4 {
            edit.set("mode", "4");
        }
        if *has_other_faces {
            remove_extension(primitive, NGONS, Some(&mut edit), edits)?;
        }
    }
    edit.into_edits(edits);
    attributes.into_iter().chain(targets.into_values()).for_each(|edit| edit.into_edits(edits));
    Ok(())
}

/// Takes an extension off an object, and the list of its extensions if that would be empty. The object may have changes
/// of its own.
fn remove_extension(
    object: &Object<'_>,
    name: &str,
    own: Option<&mut ListEdit<'_>>,
    edits: &mut Edits,
) -> Result<(), Fault> {
    let Some(extensions) = object.object("extensions")?.filter(|all| all.get(name).is_some()) else {
        return Ok(());
    };
    let mut list = ListEdit::of(extensions.value);
    list.remove(name);
    if !list.is_emptied() {
        list.into_edits(edits);
        return Ok(());
    }
    match own {
        Some(own) => own.remove("extensions"),
        None => {
            let mut own = ListEdit::of(object.value);
            own.remove("extensions");
            own.into_edits(edits);
        }
    }
    Ok(())
}

/// Gives a mesh the extension for manifolds.
fn add_manifold(mesh: &Object<'_>, indices: usize, positions: usize, edits: &mut Edits) -> Result<(), Fault> {
    let primitive = format!("{{\"attributes\":{{\"POSITION\":{positions}}},\"indices\":{indices}}}");
    let manifold = format!("{{\"manifoldPrimitive\":{primitive}}}");
    match mesh.object("extensions")? {
        Some(extensions) => {
            let mut edit = ListEdit::of(extensions.value);
            edit.set(MANIFOLD, manifold);
            edit.into_edits(edits);
        }
        None => {
            let mut edit = ListEdit::of(mesh.value);
            edit.set("extensions", format!("{{\"{MANIFOLD}\":{manifold}}}"));
            edit.into_edits(edits);
        }
    }
    Ok(())
}

fn edit_manifold(
    mesh: &Object<'_>,
    indices: usize,
    positions: Option<usize>,
    edits: &mut Edits,
) -> Result<(), Fault> {
    let Some(extensions) = mesh.object("extensions")? else { return Ok(()) };
    let Some(manifold) = extensions.object(MANIFOLD)? else { return Ok(()) };
    let mut own = ListEdit::of(manifold.value);
    ["mergeIndices", "mergeValues"].iter().for_each(|name| own.remove(name));
    own.into_edits(edits);
    let Some(primitive) = manifold.object("manifoldPrimitive")? else { return Ok(()) };
    let mut edit = ListEdit::of(primitive.value);
    edit.set("indices", indices.to_string());
    edit.into_edits(edits);
    if let (Some(attributes), Some(positions)) = (primitive.get("attributes"), positions) {
        let mut edit = ListEdit::of(attributes);
        edit.set("POSITION", positions.to_string());
        edit.into_edits(edits);
    }
    Ok(())
}

/// Takes extensions that nothing has any more out of the list of those that are used, and puts one in that is new.
fn edit_extensions_used(
    asset: &Asset<'_>,
    changes: &[PartChange],
    manifolds: &[ManifoldEdit],
    root: &mut ListEdit<'_>,
    edits: &mut Edits,
) -> Result<(), Fault> {
    let (mut ngons, mut stated) = (0, 0);
    for index in 0..asset.meshes.len() {
        let mesh = asset.mesh(index)?;
        let change = changes.iter().find(|change| change.mesh == index);
        for (at, primitive) in mesh.primitives.iter().enumerate() {
            let is_gone = |change: &&PartChange| {
                change.primitives.iter().any(|primitive| {
                    let lost = match &primitive.change {
                        Change::Removed => true,
                        Change::Indices { has_other_faces, .. } => *has_other_faces,
                    };
                    primitive.primitive == at && lost
                })
            };
            ngons +=
                usize::from(change.filter(is_gone).is_none() && has_extension(&primitive.object, NGONS)?);
        }
        let is_taken_off = manifolds.iter().any(|edit| edit.mesh == index && edit.stated.is_none());
        stated += usize::from(!is_taken_off && has_extension(&mesh.object, MANIFOLD)?);
    }
    let is_new = manifolds.iter().any(|edit| edit.is_new);
    let gone = [(NGONS, ngons > 0), (MANIFOLD, stated > 0 || is_new)];
    let gone: Vec<&str> = gone.iter().filter(|(_, is_left)| !is_left).map(|(name, _)| *name).collect();
    for list in ["extensionsUsed", "extensionsRequired"] {
        let adds = is_new && list == "extensionsUsed";
        let Some(array) = asset.root.get(list) else {
            if adds {
                root.set(list, format!("[\"{MANIFOLD}\"]"));
            }
            continue;
        };
        let items = array.items().unwrap_or_default();
        let place = |name: &str| items.iter().position(|item| item.as_text().as_deref() == Some(name));
        let mut edit = ListEdit::of(array);
        gone.iter().filter_map(|name| place(name)).for_each(|at| edit.remove_item(at));
        if adds && place(MANIFOLD).is_none() {
            edit.push(format!("\"{MANIFOLD}\""));
        }
        match edit.is_emptied() {
            true => root.remove(list),
            false => edit.into_edits(edits),
        }
    }
    Ok(())
}

fn has_extension(object: &Object<'_>, name: &str) -> Result<bool, Fault> {
    Ok(object.object("extensions")?.is_some_and(|extensions| extensions.get(name).is_some()))
}
