//! The bounds that accessors state of their numbers.

use crate::NoteKind;
use crate::formats::gltf::accessor::{Accessor, Component};
use crate::formats::gltf::asset::Asset;
use crate::formats::gltf::fault::{Fault, Pointer};
use crate::formats::gltf::json::{Object, Value};
use crate::input::notes::Notes;

/// Remarks on positions whose stated bounds are not theirs. Nothing else depends on bounds.
///
/// # Errors
/// If the accessor is malformed.
pub(super) fn note_bounds(
    asset: &Asset<'_>,
    accessor: &Accessor,
    positions: &[[f64; 3]],
    notes: &mut Notes,
) -> Result<(), Fault> {
    if accessor.form.component != Component::F32 {
        return Ok(());
    }
    let object = Object::of(asset.accessors[accessor.index], Pointer::item("accessors", accessor.index))?;
    let (Some(least), Some(most)) = (stated(&object, "min"), stated(&object, "max")) else { return Ok(()) };
    let [found_least, found_most] = bounds(positions);
    let is_same = |one: [f64; 3], other: [f64; 3]| one.map(|x| x as f32) == other.map(|x| x as f32);
    if !is_same(least, found_least) || !is_same(most, found_most) {
        let message = "accessors whose `min` and `max` are not those of their positions";
        notes.add(NoteKind::BoundsWrong, message, || object.pointer.place());
    }
    Ok(())
}

fn stated(object: &Object<'_>, name: &str) -> Option<[f64; 3]> {
    let numbers: Option<Vec<f64>> = object.get(name)?.items()?.into_iter().map(Value::as_number).collect();
    numbers?.try_into().ok()
}

/// The least and the greatest of each coordinate.
pub(super) fn bounds(positions: &[[f64; 3]]) -> [[f64; 3]; 2] {
    let none = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
    positions.iter().fold(none, |[least, most], point| {
        [0, 1].map(|side| {
            [0, 1, 2].map(|axis| match side {
                0 => least[axis].min(point[axis]),
                _ => most[axis].max(point[axis]),
            })
        })
    })
}
