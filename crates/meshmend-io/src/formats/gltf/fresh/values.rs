//! Values in types of the format: bytes and 16-bit integers as they are, all other numbers in single precision.

use meshmend_core::{Layer, Values, counted};

use super::attributes::{Kind, UNIT_SLACK};
use crate::text::one_or_many;
use crate::{Loss, LossKind};

/// A layer in a type of the format, and what that changes.
///
/// *Cost*: linear in the pool of the layer, unless it consists of bytes or 16-bit integers.
pub(super) fn converted(layer: &Layer, kind: Kind) -> (Layer, Vec<Loss>) {
    let (mut losses, name) = (Vec::new(), layer.name());
    let mut single = match layer.values() {
        Values::F32(values) => values.clone(),
        Values::F64(values) => rounded(values.iter().copied(), name, &mut losses),
        Values::I32(values) => of_integers(values.iter().map(|&x| f64::from(x)), name, &mut losses),
        Values::U32(values) => of_integers(values.iter().map(|&x| f64::from(x)), name, &mut losses),
        Values::I8(values) if kind == Kind::Normal => fractions(values, 127.0),
        Values::I16(values) if kind == Kind::Normal => fractions(values, 32767.0),
        _ => return (layer.clone(), losses),
    };
    losses.extend(match kind {
        Kind::Normal => as_directions(&mut single, name),
        _ => without_others(&mut single, name).into_iter().collect(),
    });
    let is_wide = matches!(kind, Kind::TexCoord(_)) && layer.width() == 3;
    let (width, values) = if is_wide {
        let count = layer.value_count();
        losses.extend(Loss::if_any(LossKind::Converted, count, |count| {
            format!("the third number, 0, of {}", counted(count, "texture coordinate"))
        }));
        (2, single.chunks_exact(3).flat_map(|value| [value[0], value[1]]).collect())
    } else {
        (layer.width(), single)
    };
    (layer.clone().with_pool(width, Values::F32(values)).with_normalized(false), losses)
}

/// Directions that are stored as integers.
fn fractions<T: Copy + Into<f32>>(values: &[T], one: f32) -> Vec<f32> {
    values.iter().map(|&x| (x.into() / one).max(-1.0)).collect()
}

fn rounded(values: impl ExactSizeIterator<Item = f64>, name: &str, losses: &mut Vec<Loss>) -> Vec<f32> {
    let (count, mut moved) = (values.len(), 0);
    let single = values.map(|x| {
        moved += usize::from(f64::from(x as f32) != x && !x.is_nan());
        x as f32
    });
    let single = single.collect();
    losses.extend(Loss::if_any(LossKind::Converted, moved, |moved| {
        format!("numbers of `{name}` rounded to single precision: {moved} of {count}")
    }));
    single
}

/// Integers of 32 bits, which the format does not have for vertices.
fn of_integers(values: impl ExactSizeIterator<Item = f64>, name: &str, losses: &mut Vec<Loss>) -> Vec<f32> {
    losses.extend(Loss::if_any(LossKind::Converted, values.len(), |count| {
        format!("{} of `{name}` kept in single precision, not as integers", counted(count, "number"))
    }));
    rounded(values, name, losses)
}

/// Replaces numbers that are not finite, which the format forbids, by 0.
fn without_others(values: &mut [f32], name: &str) -> Option<Loss> {
    let mut replaced = 0;
    for x in values.iter_mut().filter(|x| !x.is_finite()) {
        *x = 0.0;
        replaced += 1;
    }
    Loss::if_any(LossKind::Converted, replaced, |n| {
        let are = if n == 1 { "is" } else { "are" };
        format!("{} of `{name}` that {are} not finite: written as 0", counted(n, "number"))
    })
}

/// Gives directions unit length, unless they almost have it. Those without a direction become zeros, which stand for
/// no value.
fn as_directions(values: &mut [f32], name: &str) -> Vec<Loss> {
    let (mut scaled, mut without) = (0, 0);
    for value in values.chunks_exact_mut(3) {
        let wide = [0, 1, 2].map(|i| f64::from(value[i]));
        let length = wide.iter().map(|x| x * x).sum::<f64>().sqrt();
        if !length.is_normal() {
            value.fill(0.0);
            without += 1;
        } else if (length - 1.0).abs() >= UNIT_SLACK {
            value.iter_mut().zip(wide).for_each(|(slot, x)| *slot = (x / length) as f32);
            scaled += 1;
        }
    }
    let scaled = Loss::if_any(LossKind::Converted, scaled, |n| {
        one_or_many(
            n,
            &format!("value of `{name}` is given unit length"),
            &format!("values of `{name}` are given unit length"),
        )
    });
    let without = Loss::if_any(LossKind::Converted, without, |n| {
        let (one, many) =
            ("has no direction: that of a face is written", "have no direction: those of faces are written");
        one_or_many(n, &format!("value of `{name}` {one}"), &format!("values of `{name}` {many}"))
    });
    scaled.into_iter().chain(without).collect()
}
