//! What the PLY reader and writer promise.

mod elements;
mod refusals;
mod writing;

use crate::common::{assert_kept, read as read_as, refused as refused_as};
use meshmend_core::PolygonMesh;
use meshmend_io::{Format, Place, ReadFile};

pub(super) fn read(bytes: impl AsRef<[u8]>) -> ReadFile {
    read_as(Format::Ply, bytes)
}

pub(super) fn refused(bytes: impl AsRef<[u8]>) -> (Place, String) {
    refused_as(Format::Ply, bytes)
}

pub(super) fn ascii(header: &str, body: &str) -> String {
    format!("ply\nformat ascii 1.0\n{header}end_header\n{body}")
}

pub(super) const XYZ: &str = "property float x\nproperty float y\nproperty float z\n";
pub(super) const LIST: &str = "property list uchar int vertex_indices\n";

/// Three vertices and one triangle with more properties of each.
pub(super) fn triangle(vertex: &str, face: &str, rows: [&str; 4]) -> String {
    let header = format!("element vertex 3\n{XYZ}{vertex}element face 1\n{LIST}{face}");
    let [a, b, c, f] = rows;
    ascii(&header, &format!("0 0 0 {a}\n1 0 0 {b}\n0 1 0 {c}\n3 0 1 2 {f}\n"))
}

pub(super) fn assert_kept_in_all(mesh: &PolygonMesh) {
    for &encoding in Format::Ply.encodings() {
        assert_kept(mesh, Format::Ply, encoding);
    }
}
