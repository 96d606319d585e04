//! What a PLY file's writer chose: the types that its header declares.

use crate::Prepared;
use crate::ply::header::Header;
use crate::ply::scalar::Scalar;
use crate::shell::Shape;

/// What a PLY file's writer chose.
#[derive(Debug, PartialEq)]
pub(crate) struct PlyShape {
    /// The type of the coordinates; the widest where they differ.
    pub(super) position: Scalar,
}

impl PlyShape {
    /// What a header declares.
    pub(super) fn of_header(header: &Header) -> Self {
        let vertices = header.elements.iter().find(|element| element.name == "vertex");
        let of_axis = |name: &str| vertices?.properties.iter().find(|property| property.name == name);
        let is_double =
            ["x", "y", "z"].iter().any(|axis| of_axis(axis).is_some_and(|p| p.item == Scalar::F64));
        PlyShape { position: if is_double { Scalar::F64 } else { Scalar::F32 } }
    }

    /// The shape of the file that a mesh comes from, if that was a PLY.
    pub(super) fn of(prepared: &Prepared) -> Option<&PlyShape> {
        match prepared.shape() {
            Some(Shape::Ply(shape)) => Some(shape),
            _ => None,
        }
    }
}
