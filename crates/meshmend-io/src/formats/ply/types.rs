//! The types in which values are written: those that were declared if they hold every value, else the smallest that
//! do.

use meshmend_core::{FaceTable, PolygonMesh};

use crate::formats::ply::scalar::Scalar;
use crate::formats::ply::shape::Declared;

/// The types of the three coordinates: the declared type if it holds every value to the bit; else `float` if all
/// coordinates are single numbers, and `double` if not.
pub(super) fn coordinate_types(mesh: &PolygonMesh, declared: Option<&Declared>) -> [Scalar; 3] {
    let is_single = |x: &f64| f64::from(*x as f32).to_bits() == x.to_bits();
    // Within a block all numbers are compared, so that the processor can compare several at a time.
    let is_block_single = |block: &[[f64; 3]]| block.iter().flatten().fold(true, |all, x| all & is_single(x));
    let all_single = mesh.positions().chunks(256).all(is_block_single);
    let usual = if all_single { Scalar::F32 } else { Scalar::F64 };
    let mut types = [usual; 3];
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        let Some((_, property)) = declared.and_then(|declared| declared.property(name)) else { continue };
        let (low, high) = property.item.range();
        let is_whole = |x: f64| {
            let whole = x as i64;
            (whole as f64).to_bits() == x.to_bits() && (low..=high).contains(&whole)
        };
        let holds_all = match property.item {
            Scalar::F64 => true,
            Scalar::F32 => all_single || mesh.positions().iter().all(|point| is_single(&point[axis])),
            _ => mesh.positions().iter().all(|point| is_whole(point[axis])),
        };
        if holds_all {
            types[axis] = property.item;
        }
    }
    types
}

/// The most corners of a face.
pub(super) fn corners_at_most(faces: &FaceTable) -> usize {
    match faces.is_all_triangles() {
        true => 3,
        false => faces.faces().map(|face| faces.corner_range(face).len()).max().unwrap_or(0),
    }
}

/// The declared type of the lengths of lists, if it can count so far; else the smallest that can.
pub(super) fn counting(declared: Option<Scalar>, most: usize) -> Scalar {
    fitting(declared, most, Scalar::counting(most))
}

/// The declared type, if it is a type of whole numbers with so large a range; else another one.
pub(super) fn fitting(declared: Option<Scalar>, most: usize, otherwise: Scalar) -> Scalar {
    let goes_so_far = |scalar: &Scalar| !scalar.has_fractions() && scalar.range().1 as u64 >= most as u64;
    declared.filter(goes_so_far).unwrap_or(otherwise)
}
