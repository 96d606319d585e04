//! A package that was read, written again with other meshes.

use super::*;
use meshmend_core::{Blend, Carry, Domain, Layer, PolygonMesh, Values, VertexDraft};
use meshmend_io::LossKind;

fn tetrahedron_package() -> Vec<u8> {
    package(&tetrahedron("name=\"T\"", ""))
}

/// The package with another mesh in its only part, its model, and what is lost.
#[track_caller]
fn with_mesh(bytes: &[u8], change: impl Fn(&PolygonMesh) -> PolygonMesh) -> (String, Vec<Loss>) {
    let read = document(bytes);
    let mesh = change(&read.parts[0].mesh);
    let (written, losses) = spliced(&read.with_mesh(0, mesh));
    // What was written is a package that reads and is written the same.
    assert_eq!(spliced(&document(&written)), (written.clone(), Vec::new()));
    (model_text(&written), losses)
}

const ALL: [(u32, [usize; 3]); 4] = [(0, [0, 1, 2]), (1, [0, 1, 2]), (2, [0, 1, 2]), (3, [0, 1, 2])];

#[test]
fn a_package_of_which_nothing_changed_is_the_same_to_the_byte() {
    let bytes = tetrahedron_package();
    let read = document(&bytes);
    assert_eq!(spliced(&read), (bytes.clone(), Vec::new()));
    // Also where a mesh was made anew and is the same.
    let mesh = rearranged(&read.parts[0].mesh, &ALL, &[]);
    assert!(!mesh.is_copy_of(&read.parts[0].mesh));
    assert_eq!(spliced(&read.with_mesh(0, mesh)), (bytes, Vec::new()));
}

#[test]
fn a_flipped_triangle_changes_its_vertices_and_nothing_else() {
    let bytes = tetrahedron_package();
    let (text, losses) = with_mesh(&bytes, |mesh| {
        rearranged(mesh, &[(0, [0, 2, 1]), ALL[1], ALL[2], (3, [0, 2, 1])], &[0, 3])
    });
    let expected = model_text(&bytes)
        .replace(
            "v1=\"0\" v2=\"2\" v3=\"1\" paint_color=\"8\"",
            "v1=\"0\" v2=\"1\" v3=\"2\" paint_color=\"8\"",
        )
        .replace("v2='0' v1='2' v3='3'", "v2='3' v1='2' v3='0'");
    assert_eq!((text, losses), (expected, Vec::new()));
}

#[test]
fn all_other_entries_keep_their_bytes() {
    let bytes = tetrahedron_package();
    let read = document(&bytes);
    let mesh = rearranged(&read.parts[0].mesh, &[(0, [0, 2, 1]), ALL[1], ALL[2], ALL[3]], &[0]);
    let (written, _) = spliced(&read.with_mesh(0, mesh));
    let entries = |bytes: &[u8]| -> Vec<(Vec<u8>, Vec<u8>, u32)> {
        let archive = ZipArchive::from_slice(bytes).unwrap();
        let entries = archive.entries().map(|record| {
            let record = record.unwrap();
            let entry = archive.get_entry(record.wayfinder()).unwrap();
            (record.file_path().as_bytes().to_vec(), entry.data().to_vec(), record.crc32())
        });
        entries.collect()
    };
    let (old, new) = (entries(&bytes), entries(&written));
    assert_eq!(old.len(), new.len());
    for (old, new) in old.iter().zip(&new) {
        assert_eq!(old == new, old.0 != b"3D/3dmodel.model", "{}", String::from_utf8_lossy(&old.0));
    }
}

#[test]
fn what_a_zip_says_of_an_entry_stays_with_it() {
    // A stub before the archive, a comment behind it, and names, dates and attributes in between.
    let (mut writer, text) = (ZipArchiveWriter::new(Vec::new()), model(&tetrahedron("", ""), ""));
    writer.set_comment(&b"made by hand"[..]);
    for (name, content) in [("3D/3dmodel.model", text.as_bytes()), ("_rels/.rels", RELATIONS.as_bytes())] {
        let file = writer.new_file(name).unix_permissions(0o640).comment(&b"of an entry"[..]);
        let file = file.last_modified(rawzip::time::UtcDateTime::from_unix(1_600_000_000));
        let (mut entry, config) = file.start().unwrap();
        let mut data = config.wrap(&mut entry);
        data.write_all(content).unwrap();
        let (_, descriptor) = data.finish().unwrap();
        entry.finish(descriptor).unwrap();
    }
    let bytes = writer.finish().unwrap();
    let read = document(&bytes);
    let mesh = rearranged(&read.parts[0].mesh, &ALL[1..], &[]);
    let (written, _) = spliced(&read.with_mesh(0, mesh));
    let [old, new] = [&bytes, &written].map(|bytes| ZipArchive::from_slice(bytes).unwrap());
    assert_eq!(old.comment().as_bytes(), new.comment().as_bytes());
    for (old, new) in old.entries().zip(new.entries()) {
        let (old, new) = (old.unwrap(), new.unwrap());
        assert_eq!(old.file_path().as_bytes(), new.file_path().as_bytes());
        assert_eq!((old.last_modified(), old.mode()), (new.last_modified(), new.mode()));
        assert_eq!(old.comment().as_bytes(), new.comment().as_bytes());
        assert_eq!(old.compression_method(), new.compression_method());
    }
    assert_eq!(document(&written).parts[0].mesh.counts().faces, 3);
}

#[test]
fn removed_rows_are_gone_and_others_are_copied() {
    let (text, losses) = with_mesh(&tetrahedron_package(), |mesh| rearranged(mesh, &ALL[1..], &[]));
    let row = "<triangle v1=\"0\" v2=\"2\" v3=\"1\" paint_color=\"8\"/>\n";
    let expected = model_text(&tetrahedron_package()).replace(row, "");
    assert_eq!((text, losses), (expected, Vec::new()));
    // A vertex that goes renumbers those behind it.
    let without_first = |mesh: &PolygonMesh| {
        let faces = FaceTable::triangles(3, [0, 1, 2].map(VertexId).to_vec()).unwrap();
        let corners = Sources::listed([6, 7, 8].map(|corner| Some(CornerId(corner))));
        let draft = Draft::of_faces(mesh, faces, Sources::listed([Some(FaceId(2))]), corners);
        let vertex_sources = Sources::listed([1, 2, 3].map(|vertex| Some(VertexId(vertex))));
        mesh.rebuild(Draft { vertex_sources, ..draft }).unwrap().0
    };
    let (text, _) = with_mesh(&tetrahedron_package(), without_first);
    let (_, rows) = text.split_once("<vertices>").unwrap();
    let (vertices, rest) = rows.split_once("</vertices>\n<triangles>").unwrap();
    let expected = "\n <vertex y=\"0\" x=\"1.50\" z=\"0\" x:note=\"a &gt; b\" />\n<vertex x='0' y='1' z='0'></vertex>\n\
                    <vertex x=\"0\" y=\"0\" z=\"+1\"/>\n";
    assert_eq!(vertices, expected);
    assert!(
        rest.starts_with("\n<!-- two more --><triangle v1=\"0\" v2=\"1\" v3=\"2\"/>\n</triangles>"),
        "{rest}"
    );
}

#[test]
fn an_object_of_which_nothing_would_be_left_is_given_back() {
    let bytes = tetrahedron_package();
    let (text, losses) = with_mesh(&bytes, |mesh| rearranged(mesh, &[], &[]));
    assert_eq!(text, model_text(&bytes));
    assert_eq!(losses[0].kind, LossKind::ScenePart);
    assert_eq!(losses[0].message, "object 1 `T` is as it was: nothing would be left of it");
}

/// The tetrahedron whose first face has a new vertex on its first edge.
fn subdivided(mesh: &PolygonMesh) -> PolygonMesh {
    let corners = [0, 4, 1, 4, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3].map(VertexId).to_vec();
    let faces = FaceTable::triangles(5, corners).unwrap();
    let old = [
        Some(0),
        None,
        Some(2),
        None,
        Some(1),
        Some(2),
        Some(3),
        Some(4),
        Some(5),
        Some(6),
        Some(7),
        Some(8),
        Some(9),
        Some(10),
        Some(11),
    ];
    let face_sources = Sources::listed([0, 0, 1, 2, 3].map(|face| Some(FaceId(face))));
    let corner_sources = Sources::listed(old.map(|corner: Option<u32>| corner.map(CornerId)));
    let place = Blend::Along { from: CornerId(0), to: CornerId(1), numerator: 1, denominator: 4 };
    let created = VertexDraft { position: [0.0, 0.25, 0.0], place: Some(place) };
    let sources = (0..4).map(|vertex| Some(VertexId(vertex))).chain([None]);
    let draft = Draft {
        vertex_sources: Sources::listed(sources),
        created_vertices: vec![created],
        created_corners: vec![(CornerId(1), place), (CornerId(3), place)],
        ..Draft::of_faces(mesh, faces, face_sources, corner_sources)
    };
    mesh.rebuild(draft).unwrap().0
}

#[test]
fn created_vertices_are_short_and_parts_of_a_triangle_keep_its_attributes() {
    let (text, losses) = with_mesh(&tetrahedron_package(), subdivided);
    assert!(text.contains("z=\"+1\"/>\n<vertex x=\"0\" y=\"0.25\" z=\"0\"/>\n</vertices>"), "{text}");
    let parts = "<triangle v1=\"0\" v2=\"4\" v3=\"1\" paint_color=\"8\"/>\n<triangle v1=\"4\" v2=\"2\" v3=\"1\" paint_color=\"8\"/>\n";
    assert!(text.contains(parts), "{text}");
    assert_eq!(losses.len(), 1);
    assert_eq!((losses[0].kind, losses[0].count), (LossKind::StaleData, 2));
    assert_eq!(
        losses[0].message,
        "object 1 `T`: 2 triangles that were cut keep what was said of the whole triangle"
    );
}

#[test]
fn properties_follow_their_corners() {
    let group = "<m:colorgroup id=\"6\"><m:color color=\"#fff\"/></m:colorgroup>";
    let with = |properties: &str| {
        let object = tetrahedron("", "").replacen(" paint_color=\"8\"", properties, 1);
        package(&format!("{group}{object}"))
    };
    let flipped = |mesh: &PolygonMesh| rearranged(mesh, &[(0, [0, 2, 1]), ALL[1], ALL[2], ALL[3]], &[0]);
    for (properties, expected) in [
        (" pid=\"6\" p1=\"7\" p2=\"8\" p3=\"9\"", " pid=\"6\" p1=\"7\" p2=\"9\" p3=\"8\""),
        (" pid=\"6\" p1=\"7\" p3=\"9\"", " pid=\"6\" p1=\"7\" p3=\"7\" p2=\"9\""),
        (" pid=\"6\" p1=\"7\"", " pid=\"6\" p1=\"7\""),
        (" p3=\"8\" p2=\"8\" p1=\"8\"", " p3=\"8\" p2=\"8\" p1=\"8\""),
    ] {
        let (text, losses) = with_mesh(&with(properties), flipped);
        assert!(text.contains(&format!("v1=\"0\" v2=\"1\" v3=\"2\"{expected}/>")), "{properties}: {text}");
        assert_eq!(losses, []);
    }
    // A face that begins at another corner.
    let turned = |mesh: &PolygonMesh| rearranged(mesh, &[(0, [2, 0, 1]), ALL[1], ALL[2], ALL[3]], &[]);
    let (text, _) = with_mesh(&with(" pid=\"6\" p1=\"7\" p2=\"8\" p3=\"9\""), turned);
    assert!(text.contains("v1=\"1\" v2=\"0\" v3=\"2\" pid=\"6\" p1=\"9\" p2=\"7\" p3=\"8\""), "{text}");
    // A created corner copies the nearest one.
    let (text, losses) = with_mesh(&with(" pid=\"6\" p1=\"7\" p2=\"8\" p3=\"9\""), subdivided);
    assert!(text.contains("v1=\"0\" v2=\"4\" v3=\"1\" pid=\"6\" p1=\"7\" p2=\"7\" p3=\"9\""), "{text}");
    assert!(text.contains("v1=\"4\" v2=\"2\" v3=\"1\" pid=\"6\" p1=\"7\" p2=\"8\" p3=\"9\""), "{text}");
    assert_eq!((losses.len(), losses[0].kind, losses[0].count), (1, LossKind::CopiedProperty, 2));
}

#[test]
fn a_mesh_that_is_not_of_the_file_is_written_anew() {
    let faces = FaceTable::polygons(4, vec![0, 4], [0, 1, 2, 3].map(VertexId).to_vec()).unwrap();
    let positions = vec![[0.0; 3], [0.1, 0.0, 0.0], [1.0 / 3.0, 1.0, 0.0], [0.0, 1e-30, 0.0]];
    let mesh = PolygonMesh::new(positions, faces).unwrap();
    let layer = Layer::direct("quality", Domain::Face, 1, Carry::Copy, Values::F32(vec![1.0]));
    let mesh = mesh.with_layers(vec![layer]).unwrap();
    let (text, losses) = with_mesh(&tetrahedron_package(), |_| mesh.clone());
    assert!(text.contains("<vertex x=\"0.3333333333333333\" y=\"1\" z=\"0\"/>"), "{text}");
    assert_eq!(text.matches("<triangle ").count(), 2);
    assert_eq!(
        losses.iter().map(|loss| loss.kind).collect::<Vec<_>>(),
        [LossKind::Polygons, LossKind::Layer]
    );
    // An object that has no lists to change.
    let (_, losses) =
        with_mesh(&package("<object id=\"1\"><mesh><vertices/><triangles/></mesh></object>"), |_| {
            mesh.clone()
        });
    assert_eq!(
        losses[0].message,
        "object 1 is as it was: it has no lists of vertices and triangles to be changed"
    );
}

#[test]
fn a_prefix_of_rows_is_that_of_created_rows() {
    let text = model(&tetrahedron("", ""), "<item objectid=\"1\"/>");
    let (mut prefixed, mut rest) = (String::new(), text.as_str());
    while let Some(at) = rest.find('<') {
        let (before, tag) = rest.split_at(at + 1);
        prefixed.push_str(before);
        let (slash, name) = tag.strip_prefix('/').map_or(("", tag), |name| ("/", name));
        prefixed.push_str(slash);
        let is_name = name.starts_with(|c: char| c.is_ascii_alphabetic());
        prefixed.push_str(if is_name { "c:" } else { "" });
        rest = name;
    }
    prefixed.push_str(rest);
    let prefixed = prefixed.replacen("xmlns=", "xmlns:c=", 1);
    let (text, _) = with_mesh(&package_of(prefixed.as_bytes()), subdivided);
    assert!(text.contains("\n<c:vertex x=\"0\" y=\"0.25\" z=\"0\"/>"), "{text}");
}

#[test]
fn a_model_in_utf16_that_changes_is_written_in_utf8() {
    let text = model(&tetrahedron("", ""), "").replace("UTF-8", "UTF-16");
    let wide: Vec<u8> = [0xfeff].into_iter().chain(text.encode_utf16()).flat_map(u16::to_le_bytes).collect();
    let (written, losses) = with_mesh(&package_of(&wide), |mesh| rearranged(mesh, &ALL[1..], &[]));
    assert!(written.starts_with("<?xml version=\"1.0\" encoding=\"UTF-8\"?>"), "{written}");
    assert_eq!((losses.len(), losses[0].kind), (1, LossKind::TextLayout));
    assert_eq!(losses[0].message, "`3D/3dmodel.model` is written in UTF-8; it was in UTF-16");
}
