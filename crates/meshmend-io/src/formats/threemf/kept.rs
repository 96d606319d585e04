//! A package as it was read: what its shape and its writer are made of.

use std::fmt;
use std::sync::Arc;

use crate::Material;
use crate::document::DistinctNames;
use crate::formats::threemf::assembly::Assembly;
use crate::formats::threemf::extras::Extras;
use crate::formats::threemf::model::Model;
use crate::formats::threemf::package::Directory;
use crate::formats::threemf::parts::Origin;

/// A package as it was read.
pub(super) struct Package {
    /// The file.
    pub(super) bytes: Arc<[u8]>,
    pub(super) directory: Directory,
    /// The models whose objects are parts.
    pub(super) models: Vec<ModelText>,
    /// What is to be known of each part.
    pub(super) origins: Vec<Origin>,
    pub(super) assembly: Assembly,
    /// The base materials of all models, those of one name and look once.
    pub(super) materials: Vec<Material>,
    pub(super) material_names: DistinctNames,
    pub(super) extras: Extras,
}

/// Where the text of a model is.
#[derive(Debug)]
pub(super) struct ModelText {
    pub(super) entry: Arc<str>,
    /// The place of its entry in the directory.
    pub(super) place: usize,
    pub(super) was_utf16: bool,
}

impl ModelText {
    pub(super) fn of(model: &Model) -> Self {
        ModelText { entry: Arc::clone(&model.entry), place: model.place, was_utf16: model.was_utf16 }
    }
}

impl fmt::Debug for Package {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut shown = f.debug_struct("Package");
        shown.field("bytes", &self.bytes.len()).field("models", &self.models);
        shown.finish_non_exhaustive()
    }
}
