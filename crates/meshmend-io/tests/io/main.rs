//! What the readers and writers promise, format by format, and on every file of the shared corpus.

#![allow(clippy::unwrap_used, clippy::panic)]

mod blocks;
mod common;
mod conversions;
mod corpus;
mod formats;
mod gltf_corpus;
mod gltf_rules;
mod gltf_splice;
mod materials;
mod messages;
mod obj;
mod obj_companions;
mod obj_kept;
mod off;
mod ply;
mod ply_elsewhere;
mod ply_rows;
mod stl;
mod stl_data;
mod stl_polygons;
mod streamed;
mod threemf;
