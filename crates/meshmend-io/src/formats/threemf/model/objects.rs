//! The reader of a model, but for its meshes.

use std::collections::BTreeSet;
use std::sync::Arc;

use super::colors::material;
use super::rows::whole;
use super::{BaseMaterials, Content, Model, Object, Use, mesh};
use crate::document::{Material, ObjectKind};
use crate::formats::threemf::counts::Counts;
use crate::formats::threemf::extras::Extras;
use crate::formats::threemf::package::Fault;
use crate::formats::threemf::xml::{Scanner, Space, Tag, Text};
use crate::text::{real, shown};

/// Reads the text of a model.
///
/// # Errors
/// If it is no well-formed XML, breaks the rules of 3MF, or has more than the limits allow.
pub(in crate::formats::threemf) fn read(
    text: &Text,
    entry: &Arc<str>,
    place: usize,
    counts: &mut Counts<'_>,
    extras: &mut Extras,
) -> Result<Model, Fault> {
    let mut model = Model {
        entry: Arc::clone(entry),
        place,
        was_utf16: text.was_utf16,
        is_encrypted: false,
        objects: Vec::new(),
        items: Vec::new(),
        materials: Vec::new(),
    };
    let mut reader = Reader { scanner: Scanner::of(&text.text, entry), counts, extras, ids: BTreeSet::new() };
    let root = reader.scanner.root()?;
    if !root.is(Space::Core, "model") {
        return Err(reader.scanner.wrong(format!("no model, but `{}`", shown(root.name().as_bytes()))));
    }
    while let Some(tag) = reader.scanner.child(&root)? {
        match (tag.space, tag.local) {
            (Space::Core, "resources") => reader.resources(&tag, &mut model)?,
            (Space::Core, "build") => reader.build(&tag, &mut model)?,
            _ => {
                reader.extras.metadata += usize::from(tag.is(Space::Core, "metadata"));
                reader.scanner.skip(&tag)?;
            }
        }
    }
    reader.scanner.finish()?;
    Ok(model)
}

struct Reader<'a, 'c, 'l> {
    scanner: Scanner<'a>,
    counts: &'c mut Counts<'l>,
    extras: &'c mut Extras,
    /// The ids of all resources.
    ids: BTreeSet<u32>,
}

impl<'a> Reader<'a, '_, '_> {
    fn resources(&mut self, resources: &Tag<'a>, model: &mut Model) -> Result<(), Fault> {
        while let Some(tag) = self.scanner.child(resources)? {
            let id = self.resource_id(&tag)?;
            match (tag.space, tag.local, id) {
                (Space::Core, "object", Some(id)) => {
                    let object = self.object(&tag, id, &model.entry)?;
                    model.objects.push(object);
                }
                (Space::Core, "object", None) => return Err(self.scanner.wrong("an object without an id")),
                (Space::Core, "basematerials", Some(id)) => {
                    let members = self.base_materials(&tag)?;
                    model.materials.push(BaseMaterials { id, members });
                }
                _ => {
                    self.extras.properties += 1;
                    self.scanner.skip(&tag)?;
                }
            }
        }
        Ok(())
    }

    /// The id of a resource, which no other one may have.
    fn resource_id(&mut self, tag: &Tag<'a>) -> Result<Option<u32>, Fault> {
        let Some(text) = self.scanner.value(tag, "id")? else { return Ok(None) };
        let Some(id) = whole(&text) else {
            return Err(self.scanner.wrong(format!("`{}` is no id", shown(text.as_bytes()))));
        };
        if self.ids.insert(id) {
            Ok(Some(id))
        } else {
            Err(self.scanner.wrong(format!("two resources have the id {id}")))
        }
    }

    fn base_materials(&mut self, group: &Tag<'a>) -> Result<Vec<Material>, Fault> {
        let mut members = Vec::new();
        while let Some(tag) = self.scanner.child(group)? {
            if tag.is(Space::Core, "base") {
                let name = self.scanner.value(&tag, "name")?.unwrap_or_default();
                members.push(material(name, self.scanner.value(&tag, "displaycolor")?.as_deref()));
            }
            self.scanner.skip(&tag)?;
        }
        Ok(members)
    }

    fn object(&mut self, object: &Tag<'a>, id: u32, entry: &str) -> Result<Object, Fault> {
        self.counts.object(entry)?;
        let name = self.scanner.value(object, "name")?.unwrap_or_default();
        let has_slices = self.scanner.value_in(object, Space::Slice, "slicestackid")?.is_some();
        let kind = kind(self.scanner.value(object, "type")?.as_deref());
        let default = [self.number(object, "pid")?, self.number(object, "pindex")?];
        let mut content = None;
        while let Some(tag) = self.scanner.child(object)? {
            let found = match (tag.space, tag.local) {
                (Space::Core, "mesh") => {
                    let mut reader =
                        mesh::Reader { scanner: &mut self.scanner, counts: self.counts, entry, id };
                    Content::Mesh(Box::new(reader.mesh(&tag, default)?))
                }
                (Space::Core, "components") => Content::Components(self.uses(&tag, "component")?),
                // Metadata of the object.
                (Space::Core, _) => {
                    self.scanner.skip(&tag)?;
                    continue;
                }
                _ => {
                    self.scanner.skip(&tag)?;
                    let name = shown(tag.name().as_bytes());
                    Content::Other(format!("is a `{name}`, which is not known here"))
                }
            };
            if content.replace(found).is_some() {
                return Err(Fault::of_object(entry, id, "the object has more than one content"));
            }
        }
        let content = content.unwrap_or(Content::Components(Vec::new()));
        self.extras.sliced += usize::from(has_slices);
        if let Content::Mesh(mesh) = &content {
            self.extras.lattices += mesh.places.lattices.len();
            self.extras.sets += mesh.places.sets.len();
        }
        Ok(Object { id, name, kind, content, has_slices })
    }

    fn build(&mut self, build: &Tag<'a>, model: &mut Model) -> Result<(), Fault> {
        let items = self.uses(build, "item")?;
        model.items.extend(items);
        Ok(())
    }

    /// The objects that are named in a tag.
    fn uses(&mut self, parent: &Tag<'a>, local: &str) -> Result<Vec<Use>, Fault> {
        let mut uses = Vec::new();
        while let Some(tag) = self.scanner.child(parent)? {
            if tag.is(Space::Core, local) {
                uses.push(self.used(&tag)?);
            }
            self.scanner.skip(&tag)?;
        }
        Ok(uses)
    }

    fn used(&mut self, tag: &Tag<'a>) -> Result<Use, Fault> {
        let name = shown(tag.name().as_bytes());
        let Some(object) = self.number(tag, "objectid")? else {
            return Err(self.scanner.wrong(format!("`{name}` names no object")));
        };
        let path = self.scanner.value_in(tag, Space::Production, "path")?;
        let matrix = match self.scanner.value(tag, "transform")? {
            None => IDENTITY,
            Some(text) => matrix(&text).ok_or_else(|| {
                let text = shown(text.as_bytes());
                self.scanner
                    .wrong(format!("a transform of object {object} that is not twelve numbers: `{text}`"))
            })?,
        };
        let part_number = self.scanner.value(tag, "partnumber")?.unwrap_or_default();
        Ok(Use { path, object, matrix, part_number })
    }

    /// A whole number among the attributes of a tag.
    fn number(&self, tag: &Tag<'a>, name: &str) -> Result<Option<u32>, Fault> {
        let Some(text) = self.scanner.value(tag, name)? else { return Ok(None) };
        let wrong = || {
            let (text, tag) = (shown(text.as_bytes()), shown(tag.name().as_bytes()));
            self.scanner.wrong(format!("`{name}` of a `{tag}` is no number: `{text}`"))
        };
        whole(&text).map(Some).ok_or_else(wrong)
    }
}

const IDENTITY: [[f64; 4]; 3] = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];

/// The kind of an object by its name. A name of a later version is some other kind.
fn kind(name: Option<&str>) -> ObjectKind {
    match name.map(str::trim) {
        None | Some("model") => ObjectKind::Model,
        Some("solidsupport") => ObjectKind::SolidSupport,
        Some("support") => ObjectKind::Support,
        Some("surface") => ObjectKind::Surface,
        Some(_) => ObjectKind::Other,
    }
}

/// Four rows of three numbers that stand to the right of a row of coordinates, as three rows of four.
fn matrix(text: &str) -> Option<[[f64; 4]; 3]> {
    let mut rows = [[0.0; 4]; 3];
    let mut numbers = text.split_ascii_whitespace();
    for from in 0..4 {
        for row in &mut rows {
            let word = numbers.next()?.as_bytes();
            let (number, length) = real::<f64>(word)?;
            row[from] = Some(number).filter(|number| length == word.len() && number.is_finite())?;
        }
    }
    numbers.next().is_none().then_some(rows)
}
