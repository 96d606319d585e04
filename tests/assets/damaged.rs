//! Damaged copies come back with the topology and all attributes that the undamaged file has.

use meshmend_core::{Draft, FaceId, FaceTable, PolygonMesh, Sources, VertexId};

use meshmend_tests::judge::assert_attributes_kept;
use meshmend_tests::scratch::Scratch;

use crate::documents::{document, repaired, scenes, stored, triangles, written};

/// A mesh with a face turned round and another one that is there twice.
fn damaged(mesh: &PolygonMesh) -> PolygonMesh {
    let old = mesh.faces();
    let turned = FaceId(2);
    let faces: Vec<FaceId> = old.faces().chain([FaceId(1)]).collect();
    let corners = faces.iter().flat_map(|&face| {
        let mut corners: Vec<_> = old.face_corners(face).collect();
        if face == turned {
            corners.reverse();
        }
        corners
    });
    let corners: Vec<_> = corners.collect();
    let vertices: Vec<VertexId> = corners.iter().map(|&corner| old.corner_vertex(corner)).collect();
    let table = FaceTable::triangles(old.vertex_count(), vertices).unwrap();
    let draft = Draft {
        flipped: vec![turned],
        ..Draft::of_faces(
            mesh,
            table,
            Sources::listed(faces.into_iter().map(Some)),
            Sources::listed(corners.into_iter().map(Some)),
        )
    };
    mesh.rebuild(draft).unwrap().0
}

/// Files of more parts are not given to the independent checker, which is slow.
const LARGEST: usize = 10;

/// The independent checker finds no other difference than the face that was there twice.
fn judge(broken: &[u8], mended: &[u8], name: &str) {
    let scratch = Scratch::new();
    let suffix = if broken.starts_with(b"glTF") { "glb" } else { "gltf" };
    let [before, after] = [("before", broken), ("after", mended)]
        .map(|(name, bytes)| stored(scratch.path(), &format!("{name}.{suffix}"), bytes));
    assert_attributes_kept(&before, &after, &["--flipped-normals", "negate", "--allow-created", "0"], name);
}

#[test]
fn turned_and_repeated_faces_are_mended_and_all_attributes_are_as_before() {
    let Some(scenes) = scenes() else { return };
    let mut count = 0;
    for (entry, _, original) in scenes {
        let (undamaged, records) = repaired(&original);
        let mut judged = original.parts.len() > LARGEST;
        for (at, part) in original.parts.iter().enumerate().take(4) {
            let Some(topology) = records[at].as_ref().and_then(|record| record.topology.as_ref()) else {
                continue;
            };
            let is_simple =
                topology.components == 1 && topology.patches == 1 && topology.consistently_oriented;
            if !is_simple || topology.faces < 12 {
                continue;
            }
            let broken = written(&original.clone().with_mesh(at, damaged(&part.mesh)), original.format);
            let broken = document(&broken);
            assert_eq!(broken.parts[at].mesh.counts().faces, part.mesh.counts().faces + 1, "{}", entry.name);
            let mended = document(&written(&repaired(&broken).0, original.format));
            let expected = triangles(&undamaged.parts[at].mesh);
            assert!(triangles(&mended.parts[at].mesh) == expected, "{} part {at}", entry.name);
            if !std::mem::replace(&mut judged, true) {
                judge(&written(&broken, original.format), &written(&mended, original.format), &entry.name);
            }
            count += 1;
        }
    }
    assert!(count > 8, "only {count} parts were damaged");
}
