//! glTF 2.0: as text with its buffers elsewhere, or in one file as GLB.

#[allow(dead_code, unused_imports, reason = "the registry asks for it once there is a reader")]
mod fresh;
