//! Textures by number, as MeshLab writes them to PLY, and materials by name, as OBJ has them.
//!
//! The `texnumber` n of a face is the material `texture_n`. MeshLab names the pictures in comments, `TextureFile
//! NAME`. They stay comments; no material library is written.

use meshmend_core::{Carry, Domain, DraftError, Layer, NO_VALUE, Values, counted};

use crate::layers::{layer_of, number};
use crate::{Loss, LossKind, Prepared, WriteErrorKind};

const NUMBER: &str = "texnumber";
const MATERIAL: &str = "material";
const NAME: &[u8] = b"texture_";

impl Prepared {
    /// Replaces the texture numbers of faces by materials, if the faces have no materials.
    ///
    /// *Cost*: linear in the faces, if they have texture numbers.
    pub(crate) fn name_textures(&mut self) -> Result<(), WriteErrorKind> {
        let has_materials = self.mesh.layer(MATERIAL, Domain::Face).is_some();
        let numbers = layer_of(&self.mesh, NUMBER, Domain::Face, is_whole).filter(|_| !has_materials);
        let Some(names) = numbers.map(names_of) else { return Ok(()) };
        self.replace_layer(NUMBER, is_whole, names)?;
        let files = self.mesh.metadata().iter().filter(|m| m.kind() == "comment" && names_file(&m.value));
        self.losses.extend(Loss::if_any(LossKind::Converted, files.count(), |count| {
            let files = counted(count, "texture file");
            format!("{files} named in comments alone, as no material library is written")
        }));
        Ok(())
    }

    /// Replaces the materials of faces by texture numbers, if every material stands for one.
    ///
    /// *Cost*: linear in the names, and in the faces if all are texture numbers.
    pub(crate) fn number_textures(&mut self) -> Result<(), WriteErrorKind> {
        let has_numbers = self.mesh.layer(NUMBER, Domain::Face).is_some();
        let materials = layer_of(&self.mesh, MATERIAL, Domain::Face, is_text).filter(|_| !has_numbers);
        match materials.and_then(numbers_of) {
            Some(numbers) => self.replace_layer(MATERIAL, is_text, numbers),
            None => Ok(()),
        }
    }

    /// Replaces the first layer of faces with a name that meets a condition.
    fn replace_layer(
        &mut self,
        name: &str,
        is_fit: fn(&Layer) -> bool,
        new: Layer,
    ) -> Result<(), WriteErrorKind> {
        let is_old = |layer: &Layer| layer.name() == name && layer.domain() == Domain::Face && is_fit(layer);
        let mut layers = self.mesh.layers().to_vec();
        if let Some(old) = layers.iter_mut().find(|layer| is_old(layer)) {
            *old = new;
        }
        self.mesh = self.mesh.clone().with_layers(layers).map_err(DraftError::from)?;
        Ok(())
    }
}

fn is_text(layer: &Layer) -> bool {
    matches!(layer.values(), Values::Text(_)) && layer.width() == 1
}

fn is_whole(layer: &Layer) -> bool {
    use Values::{I8, I16, I32, U8, U16, U32};
    let is_integer = matches!(layer.values(), I8(_) | U8(_) | I16(_) | U16(_) | I32(_) | U32(_));
    is_integer && layer.width() == 1
}

/// Whether a comment names the picture of a texture.
fn names_file(comment: &[u8]) -> bool {
    comment.trim_ascii_start().starts_with(b"TextureFile ")
}

fn names_of(numbers: &Layer) -> Layer {
    let of_face = |face| numbers.value_of(face).map(|value| number(numbers.values(), value) as i64);
    let numbers: Vec<Option<i64>> =
        (0..numbers.element_count()).map(|face| of_face(face).filter(|&number| number >= 0)).collect();
    let mut pool: Vec<i64> = numbers.iter().flatten().copied().collect();
    pool.sort_unstable();
    pool.dedup();
    let place = |number: &Option<i64>| {
        number.and_then(|number| pool.binary_search(&number).ok()).map_or(NO_VALUE, |at| at as u32)
    };
    let uses = numbers.iter().map(place).collect();
    let name = |number: &i64| [NAME, number.to_string().as_bytes()].concat();
    let values = Values::Text(pool.iter().map(name).collect());
    Layer::indexed(MATERIAL, Domain::Face, 1, Carry::Copy, values, uses)
}

/// The texture numbers of materials; −1 where a face has none. Returns `None` if a name does not stand for a number.
fn numbers_of(materials: &Layer) -> Option<Layer> {
    let Values::Text(names) = materials.values() else { return None };
    let number_of = |name: &Vec<u8>| {
        let digits = name.strip_prefix(NAME)?;
        let number: i32 = std::str::from_utf8(digits).ok()?.parse().ok()?;
        (number >= 0 && number.to_string().as_bytes() == digits).then_some(number)
    };
    let numbers: Vec<i32> = names.iter().map(number_of).collect::<Option<_>>()?;
    let of_face = |face| materials.value_of(face).map_or(-1, |value| numbers[value]);
    let values = Values::I32((0..materials.element_count()).map(of_face).collect());
    Some(Layer::direct(NUMBER, Domain::Face, 1, Carry::Copy, values))
}
