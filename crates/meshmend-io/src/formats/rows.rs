//! The registry: one row a format.

/// Hands the rows to another macro. From a row follow the enum's variant, the folder's module, and the format's place
/// in sniffing, help texts, messages and tests.
macro_rules! with_formats {
    ($make:ident) => {
        $make! {
            /// Wavefront OBJ.
            Obj => obj,
            /// Polygon file format, also called Stanford triangle format.
            Ply => ply,
            /// Stereolithography: triangles without indices.
            Stl => stl,
            /// Object file format of Geomview.
            Off => off,
            /// GLB: glTF in one binary file.
            Glb => glb,
            /// glTF: JSON, with the bytes of its buffers within it or beside it.
            Gltf => gltf,
            /// 3D Manufacturing Format.
            ThreeMf => threemf,
            /// The example of CONTRIBUTING.
            #[cfg(test)]
            Toy => toy,
        }
    };
}
