//! glTF 2.0 and GLB: meshes placed by nodes, and much round them that stays as it is.

mod accessor;
mod asset;
pub(crate) mod base64;
mod bounds;
mod buffers;
mod container;
pub(crate) mod facts;
mod fault;
mod file;
mod fresh;
mod json;
mod materials;
mod nodes;
mod part;
mod pools;
mod primitives;
mod read;
mod rows;
mod semantic;
mod shape;
mod splice;
mod topology;
mod triangles;
mod uri;

use crate::formats::driver::Driver;

pub(crate) static DRIVER: Driver = Driver {
    read: read::read,
    read_blocks: read::read_blocks,
    stream: Driver::streams_nothing,
    look_beside: Driver::names_no_files,
    prepare: fresh::prepare,
    encode: fresh::encode_gltf,
    losses: fresh::losses,
};

/// The driver of GLB.
pub(crate) static GLB_DRIVER: Driver = Driver { read: read::read_glb, encode: fresh::encode_glb, ..DRIVER };
