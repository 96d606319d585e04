//! Single faces: which repeat another, and which come back to a vertex.

mod duplicates;
mod face_shape;

pub use duplicates::{AlikeFace, DuplicateFace, Likeness, alike_faces, duplicate_faces, repeats};
pub use face_shape::{FaceShapes, faces_with_repeated_corners, non_simple_faces};
