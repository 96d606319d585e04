//! A mesh as a new glTF file.
//!
//! | the mesh has | the file has |
//! |---|---|
//! | faces | triangles, in one primitive for each material; larger faces are cut as for STL |
//! | loose edges, loose points | a primitive of lines, a primitive of points |
//! | vertices alone | a primitive of points |
//! | `object` of faces | a node with a mesh for each; without it one node with one mesh |
//! | `material` of faces | a material for each name, as the libraries of an OBJ describe it |
//! | positions | `POSITION` in single precision |
//! | roles normal, tangent, texture coordinate, colour | `NORMAL`, `TANGENT`, `TEXCOORD_n`, `COLOR_n`, if the values are those that the format allows |
//! | any other numbers of vertices or corners | `_NAME`, with one to four numbers |
//!
//! No colour is converted: glTF means linear numbers, and many programs write those of the screen (sRGB) to MTL.
//!
//! Everything else is a named loss. Attributes belong to vertices, so a vertex whose corners differ is written several
//! times. All primitives of a mesh share its vertices. A mesh without vertices makes a file without meshes, as an
//! accessor must not be empty.

mod accessors;
mod arrange;
mod attributes;
mod buffer;
mod container;
mod json;
mod looks;
mod losses;
mod materials;
mod normals;
mod objects;
mod plan;
mod prepare;
mod root;
mod values;

pub(super) use container::{encode_glb, encode_gltf};
pub(super) use losses::losses;
pub(super) use prepare::prepare;

#[cfg(test)]
mod tests;
