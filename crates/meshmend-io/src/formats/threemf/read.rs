//! The reader of a package: its models, from the root on, and their objects as parts.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use meshmend_core::printable;

use crate::document::{DistinctNames, ObjectKind};
use crate::formats::driver::ReadResult;
use crate::formats::threemf::assembly::Assembly;
use crate::formats::threemf::counts::Counts;
use crate::formats::threemf::extras::Extras;
use crate::formats::threemf::kept::{ModelText, Package};
use crate::formats::threemf::model::{self, Content, Model, Object, Use};
use crate::formats::threemf::package::{Budget, Directory, Fault};
use crate::formats::threemf::parts;
use crate::formats::threemf::relations::{self, entry_name};
use crate::formats::threemf::xml::Text;
use crate::input::notes::Notes;
use crate::input::source::{Parsed, Source};
use crate::text::shown;
use crate::{Encoding, Format, Limits, Material, NoteKind, Place, Shell};

/// How an encrypted model begins.
const ENCRYPTED: &[u8] = b"%3McF";

pub(super) fn read(source: &Source<'_>, limits: &Limits) -> ReadResult {
    found(source, limits).map_err(|fault| fault.in_file(source))
}

fn found(source: &Source<'_>, limits: &Limits) -> Result<Parsed, Fault> {
    if source.bytes.is_empty() {
        return Err(Fault::at_byte(0, "the file is empty"));
    }
    let directory = Directory::of(source.bytes)?;
    let mut reader = Reader {
        bytes: source.bytes,
        directory: &directory,
        budget: Budget::of(limits.max_inflated_bytes).watched(source.watch),
        counts: Counts::of(limits, source.watch),
        models: Vec::new(),
        extras: Extras::default(),
    };
    reader.read_models()?;
    let Reader { mut models, extras, .. } = reader;
    let assembly = Assembly::of(&models, limits)?;
    let texts = models.iter().map(ModelText::of).collect();
    let (materials, material_names) = told_apart(&mut models);
    let (parts, origins) = parts::of(models)?;
    let notes = notes_of(&parts);
    let bytes = Arc::from(source.bytes);
    let package =
        Package { bytes, directory, models: texts, origins, assembly, materials, material_names, extras };
    Ok(Parsed { parts, notes, shell: Shell::of_file(Format::ThreeMf, Encoding::Ascii, package) })
}

fn members(models: &mut [Model]) -> impl Iterator<Item = &mut Material> {
    models.iter_mut().flat_map(|model| &mut model.materials).flat_map(|group| &mut group.members)
}

/// The base materials of all models, each that looks like one of its name before it left out. Others of that name have
/// numbers from now on.
fn told_apart(models: &mut [Model]) -> (Vec<Material>, DistinctNames) {
    let look = |material: &Material| {
        let color = material.base_color.map(|color| color.map(f64::to_bits));
        (material.name.clone(), color, material.opacity.map(f64::to_bits))
    };
    let mut places = BTreeMap::new();
    let mut materials: Vec<Material> = Vec::new();
    for material in members(models) {
        places.entry(look(material)).or_insert_with(|| {
            materials.push(material.clone());
            materials.len() - 1
        });
    }
    let given: Vec<_> = materials.iter().map(|material| Some(material.name.clone())).collect();
    let names = DistinctNames::of(&given);
    for material in members(models) {
        let name = places.get(&look(material)).map(|&place| names.name(place).to_vec());
        material.name = name.unwrap_or_default();
    }
    for (place, material) in materials.iter_mut().enumerate() {
        material.name = names.name(place).to_vec();
    }
    (materials, names)
}

fn notes_of(parts: &[crate::Part]) -> Notes {
    let mut notes = Notes::default();
    for part in parts {
        let place = || match &part.source {
            crate::PartSource::ThreeMfObject { entry, id, .. } => {
                Place::Entry(printable(&format!("{entry}#{id}")))
            }
            _ => Place::File,
        };
        if let Some(reason) = part.seal() {
            notes.add(NoteKind::SealedPart, reason, place);
        }
        let is_finite = |position: &&[f64; 3]| position.iter().all(|x| x.is_finite());
        let infinite = part.mesh.positions().iter().filter(|position| !is_finite(position)).count() as u64;
        notes.add_many(NoteKind::NonFinite, "vertices whose position is not finite", infinite, place);
    }
    if parts.iter().all(|part| part.mesh.positions().is_empty()) {
        notes.add(NoteKind::Empty, "the file holds no vertex", || Place::File);
    }
    notes
}

struct Reader<'a, 'l> {
    bytes: &'a [u8],
    directory: &'a Directory,
    budget: Budget<'l>,
    counts: Counts<'l>,
    models: Vec<Model>,
    extras: Extras,
}

impl Reader<'_, '_> {
    /// Reads the root model, and each model that one of those before it names.
    fn read_models(&mut self) -> Result<(), Fault> {
        let root = self.root()?;
        let mut noted = BTreeSet::new();
        let mut known = BTreeMap::from([(root.to_ascii_lowercase(), 0)]);
        self.read_model(&root)?;
        let mut at = 0;
        while at < self.models.len() {
            for (path, object) in outside(&self.models[at]) {
                let entry = &self.models[at].entry;
                let Some(name) = entry_name(&path).filter(|name| self.directory.entry(name).is_some()) else {
                    let path = shown(path.as_bytes());
                    return Err(Fault::of_entry(
                        entry,
                        format!("object {object} is in `{path}`, which does not exist"),
                    ));
                };
                let number = *known.entry(name.to_ascii_lowercase()).or_insert(self.models.len());
                if number == self.models.len() {
                    self.read_model(&name)?;
                }
                if noted.insert((number, object)) {
                    self.models[number].note_use(object);
                }
            }
            at += 1;
        }
        Ok(())
    }

    /// The name of the entry that is the root model.
    fn root(&mut self) -> Result<String, Fault> {
        let Some((_, entry)) = self.directory.entry(relations::OF_PACKAGE) else {
            return Err(Fault::of_entry(
                relations::OF_PACKAGE,
                "no model part: the package has no such entry",
            ));
        };
        let text = Text::of(self.budget.content(self.bytes, entry)?, &entry.name)?;
        let targets = relations::models(&text, &entry.name)?;
        let target = match targets.as_slice() {
            [target] => target,
            [] => return Err(Fault::of_entry(&entry.name, "no model part: no relation names one")),
            several => {
                let count = several.len();
                return Err(Fault::of_entry(
                    &entry.name,
                    format!("the relations name {count} model parts, not one"),
                ));
            }
        };
        match entry_name(target).filter(|name| self.directory.entry(name).is_some()) {
            Some(name) => Ok(name),
            None => {
                let target = shown(target.as_bytes());
                Err(Fault::of_entry(&entry.name, format!("no model part: `{target}` is not in the package")))
            }
        }
    }

    fn read_model(&mut self, name: &str) -> Result<(), Fault> {
        let Some((place, entry)) = self.directory.entry(name) else {
            return Err(Fault::of_entry(name, "the entry is not in the package"));
        };
        let content = self.budget.content(self.bytes, entry)?;
        let name = Arc::from(entry.name.as_str());
        if content.starts_with(ENCRYPTED) {
            if self.models.is_empty() {
                return Err(Fault::of_entry(&entry.name, "the model is encrypted"));
            }
            self.models.push(Model::encrypted(name, place));
            return Ok(());
        }
        let text = Text::of(content, &entry.name)?;
        let model = model::read(&text, &name, place, &mut self.counts, &mut self.extras)?;
        self.models.push(model);
        Ok(())
    }
}

/// The objects of other models that a model names.
fn outside(model: &Model) -> Vec<(String, u32)> {
    let components = model.objects.iter().flat_map(|object| match &object.content {
        Content::Components(uses) => uses.as_slice(),
        Content::Mesh(_) | Content::Other(_) => &[],
    });
    let uses = model.items.iter().chain(components);
    uses.filter_map(|used: &Use| Some((used.path.clone()?, used.object))).collect()
}

impl Model {
    /// A model that can't be read. Its objects are those that others name.
    fn encrypted(entry: Arc<str>, place: usize) -> Self {
        Model {
            entry,
            place,
            was_utf16: false,
            is_encrypted: true,
            objects: Vec::new(),
            items: Vec::new(),
            materials: Vec::new(),
        }
    }

    /// Takes in that another model names an object of this one, which was not named before.
    fn note_use(&mut self, id: u32) {
        if self.is_encrypted {
            let content = Content::Other("is in an encrypted model".to_owned());
            self.objects.push(Object {
                id,
                name: String::new(),
                kind: ObjectKind::Other,
                content,
                has_slices: false,
            });
        }
    }
}
