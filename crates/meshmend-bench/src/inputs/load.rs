//! Loads an input without taking more memory than the mesh, so that what an operation takes at its peak can be told.
//!
//! Only the binary PLY files are read that this program wrote: `float x y z`, then three `int` a face.

use std::fs::File;
use std::io::{BufRead, BufReader, Read};
use std::path::Path;

use meshmend::{FaceTable, PolygonMesh, VertexId};

use crate::failure::Failure;

/// The mesh in a file that this program wrote.
pub(crate) fn load(path: &Path) -> Result<PolygonMesh, Failure> {
    let failed = |error| Failure::io(path, error);
    let file = File::open(path).map_err(failed)?;
    let mut rows = BufReader::with_capacity(1 << 16, file);
    let [vertex_count, face_count] = counts(&mut rows).map_err(failed)?;
    let mut positions = Vec::with_capacity(vertex_count);
    for _ in 0..vertex_count {
        let point = numbers(&mut rows).map_err(failed)?;
        positions.push(point.map(|bytes| f64::from(f32::from_le_bytes(bytes))));
    }
    let mut corners = Vec::with_capacity(3 * face_count);
    for _ in 0..face_count {
        let mut size = [0];
        rows.read_exact(&mut size).map_err(failed)?;
        if size != [3] {
            return Err(Failure::NotAnInput(path.to_owned()));
        }
        corners.extend(numbers(&mut rows).map_err(failed)?.map(|bytes| VertexId(u32::from_le_bytes(bytes))));
    }
    let faces = FaceTable::triangles(vertex_count, corners)?;
    Ok(PolygonMesh::new(positions, faces)?)
}

/// How many vertices and faces the header declares.
fn counts(rows: &mut impl BufRead) -> std::io::Result<[usize; 2]> {
    let mut counts = [0, 0];
    let mut line = String::new();
    while line != "end_header\n" {
        line.clear();
        if rows.read_line(&mut line)? == 0 {
            return Err(std::io::ErrorKind::UnexpectedEof.into());
        }
        let count = |element: &str| line.strip_prefix(element).and_then(|count| count.trim().parse().ok());
        if let Some(vertices) = count("element vertex ") {
            counts[0] = vertices;
        } else if let Some(faces) = count("element face ") {
            counts[1] = faces;
        }
    }
    Ok(counts)
}

fn numbers(rows: &mut impl Read) -> std::io::Result<[[u8; 4]; 3]> {
    let mut numbers = [[0; 4]; 3];
    rows.read_exact(numbers.as_flattened_mut())?;
    Ok(numbers)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::inputs::{Content, Folder, Form, Input, Order};

    #[test]
    fn what_was_written_is_loaded_as_it_was() {
        let folder = Folder::temporary().unwrap();
        for content in Content::ALL {
            let input = Input { content, order: Order::Shuffled, faces: 5_000 };
            let (mesh, loaded) =
                (input.mesh().unwrap(), load(&folder.file(&input, Form::PlyBinary).unwrap()).unwrap());
            assert!(loaded.positions() == mesh.positions() && loaded.faces() == mesh.faces(), "{content:?}");
        }
        let other = folder.path().join("other.ply");
        std::fs::write(&other, "ply\nelement vertex 0\nelement face 1\nend_header\n\u{4}").unwrap();
        assert!(matches!(load(&other), Err(Failure::NotAnInput(_))));
        std::fs::write(&other, "ply\nelement vertex 1\nend_header\n\u{4}").unwrap();
        assert!(matches!(load(&other), Err(Failure::Io { .. })));
        std::fs::write(&other, "ply\n").unwrap();
        assert!(matches!(load(&other), Err(Failure::Io { .. })));
    }
}
