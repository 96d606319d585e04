//! Values in the types that other programs expect in a PLY: `float` normals and texture coordinates, `uchar` colours.
//!
//! As measured, MeshLab reads texture coordinates neither from lists of `double` nor from `double s t`, and only
//! bytes as colours. VTK shows any colour but bytes as black. What was read from PLY keeps its types.

use meshmend_core::{DraftError, Layer, Role, Values, counted};

use crate::formats::ply::shape::PlyShape;
use crate::output::layer_losses::elements;
use crate::{AttributePrecision, Loss, LossKind, Prepared, WriteErrorKind};

/// Which layers are to be converted: doubles, as text formats have them, in a known role, unless the file that the
/// mesh comes from declares them as doubles.
pub(super) fn to_be_expected(prepared: &Prepared) -> Vec<bool> {
    let shape = prepared.shape::<PlyShape>();
    let is_declared = |layer: &Layer| shape.is_some_and(|shape| shape.declares(layer));
    let has_value = |layer: &Layer| (0..layer.element_count()).any(|at| layer.value_of(at).is_some());
    let is_known = |layer: &Layer| {
        let is_of_role = matches!(layer.role(), Role::TexCoord | Role::Normal | Role::Color);
        is_of_role && matches!(layer.values(), Values::F64(_)) && !is_declared(layer) && has_value(layer)
    };
    prepared.mesh.layers().iter().map(is_known).collect()
}

/// Converts layers to the types that other programs expect, and names what is rounded.
///
/// *Cost*: linear in the pools of the layers concerned; O(1) without any.
pub(super) fn as_expected(prepared: &mut Prepared, is_concerned: &[bool]) -> Result<(), WriteErrorKind> {
    if prepared.options.precision == AttributePrecision::Double || !is_concerned.contains(&true) {
        return Ok(());
    }
    let mut losses = Vec::new();
    let layers = prepared.mesh.layers().iter().zip(is_concerned);
    let layers = layers.map(|(layer, &is_concerned)| match layer.role() {
        _ if !is_concerned => layer.clone(),
        Role::TexCoord => in_single(two_numbers(layer.clone(), &mut losses), &mut losses),
        Role::Color => as_bytes(layer, &mut losses).unwrap_or_else(|| in_single(layer.clone(), &mut losses)),
        _ => in_single(layer.clone(), &mut losses),
    });
    let mesh = prepared.mesh.clone().with_layers(layers.collect());
    prepared.mesh = mesh.map_err(DraftError::from)?;
    prepared.losses.extend(losses);
    Ok(())
}

/// Texture coordinates of three numbers as two numbers if the third is always 0, as other programs read only two.
fn two_numbers(layer: Layer, losses: &mut Vec<Loss>) -> Layer {
    let Values::F64(values) = layer.values() else { return layer };
    if layer.width() != 3 || values.chunks_exact(3).any(|value| value[2] != 0.0) {
        return layer;
    }
    let count = layer.value_count();
    let narrow = values.chunks_exact(3).flat_map(|value| [value[0], value[1]]).collect();
    losses.extend(Loss::if_any(LossKind::Converted, count, |count| {
        format!("the third number, 0, of {}", counted(count, "texture coordinate"))
    }));
    layer.with_pool(2, Values::F64(narrow))
}

/// Doubles in single precision, unless one of them is out of its range.
fn in_single(layer: Layer, losses: &mut Vec<Loss>) -> Layer {
    let Values::F64(values) = layer.values() else { return layer };
    let single: Vec<f32> = values.iter().map(|&x| x as f32).collect();
    if values.iter().zip(&single).any(|(double, single)| double.is_finite() && !single.is_finite()) {
        return layer;
    }
    let is_rounded = |(double, single): (&f64, &f32)| f64::from(*single).to_bits() != double.to_bits();
    let rounded = values.iter().zip(&single).filter(|&pair| is_rounded(pair)).count();
    let name = layer.name().to_owned();
    losses.extend(Loss::if_any(LossKind::Converted, rounded, |rounded| {
        format!("numbers of `{name}` rounded to single precision: {rounded} of {}", single.len())
    }));
    let width = layer.width();
    layer.with_pool(width, Values::F32(single))
}

/// Fractions that come from bytes, as bytes. Returns `None` if one of them does not come from a byte.
fn as_bytes(layer: &Layer, losses: &mut Vec<Loss>) -> Option<Layer> {
    let Values::F64(fractions) = layer.values() else { return None };
    let bytes: Vec<u8> = fractions.iter().map(|&x| byte(x)).collect::<Option<_>>()?;
    let is_exact = |(x, byte): (&f64, &u8)| *x == f64::from(*byte) / 255.0;
    let width = layer.width();
    let pairs = fractions.chunks_exact(width).zip(bytes.chunks_exact(width));
    let is_moved: Vec<bool> = pairs.map(|(x, b)| !x.iter().zip(b).all(is_exact)).collect();
    let uses = (0..layer.element_count()).filter_map(|element| layer.value_of(element));
    let moved = uses.filter(|&value| is_moved[value]).count();
    losses.extend(Loss::if_any(LossKind::Converted, moved, |moved| {
        let of = elements(layer);
        format!(
            "colours of {of} rounded to the bytes that they come from: {moved} of {}",
            layer.element_count()
        )
    }));
    Some(layer.clone().with_pool(width, Values::U8(bytes)))
}

/// The byte n that a fraction comes from: n / 255, exact or printed with six decimals, or n / 256.
fn byte(x: f64) -> Option<u8> {
    if !(0.0..=1.0).contains(&x) {
        return None;
    }
    let of_255 = (x * 255.0).round();
    if (x - of_255 / 255.0).abs() <= 0.51e-6 {
        return Some(of_255 as u8);
    }
    let of_256 = x * 256.0;
    (of_256.fract() == 0.0 && of_256 < 256.0).then_some(of_256 as u8)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fractions_of_bytes_are_told_from_others() {
        for n in 0..=255_u8 {
            assert_eq!(byte(f64::from(n) / 255.0), Some(n));
            let printed: f64 = format!("{:.6}", f64::from(n) / 255.0).parse().unwrap();
            assert_eq!(byte(printed), Some(n), "{printed}");
        }
        assert_eq!([0.5, 0.25, 0.0, 1.0, 0.00390625].map(byte), [128, 64, 0, 255, 1].map(Some));
        for other in [0.3, 0.123456, -0.0001, 1.0001, f64::NAN, 2.0] {
            assert_eq!(byte(other), None, "{other}");
        }
    }
}
