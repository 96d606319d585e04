//! GLB: glTF in one binary file. All but its facts is in the folder of glTF.

pub(crate) mod facts;

use crate::formats::gltf;

pub(crate) use gltf::GLB_DRIVER as DRIVER;
