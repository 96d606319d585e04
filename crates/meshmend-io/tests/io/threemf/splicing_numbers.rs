//! Sets of triangles, beams, balls and slices, where their object gets another mesh.

use super::*;
use meshmend_io::LossKind;

const SETS: &str = "<t:trianglesets>\n<t:triangleset name=\"lid\" identifier=\"a\"><t:ref index=\"0\" /><t:ref index=\"3\"></t:ref></t:triangleset>\n\
                    <t:triangleset name=\"all\" identifier=\"b\">\n<t:refrange startindex=\"0\" endindex=\"3\"/>\n</t:triangleset></t:trianglesets>\n";

const LATTICE: &str = "<b:beamlattice radius=\"1\" minlength=\"0.1\"><b:beams><b:beam v1=\"0\" v2=\"4\" r1=\"2\"/>\
                       <b:beam v1=\"5\" v2=\"3\"></b:beam></b:beams><b:balls><b:ball vindex=\"5\"/></b:balls>\
                       <b:beamsets><b:beamset><b:ref index=\"1\"/></b:beamset></b:beamsets></b:beamlattice>\n";

fn changed(bytes: &[u8], change: impl Fn(&PolygonMesh) -> PolygonMesh) -> (String, Vec<Loss>) {
    let read = document(bytes);
    let mesh = change(&read.parts[0].mesh);
    let (written, losses) = spliced(&read.with_mesh(0, mesh));
    assert_eq!(spliced(&document(&written)), (written.clone(), Vec::new()));
    (model_text(&written), losses)
}

#[test]
fn sets_of_triangles_follow_the_triangles() {
    let bytes = package(&tetrahedron("", SETS));
    let all: [(u32, [usize; 3]); 4] = [0, 1, 2, 3].map(|face| (face, [0, 1, 2]));
    // The second goes.
    let (text, losses) = changed(&bytes, |mesh| rearranged(mesh, &[all[0], all[2], all[3]], &[]));
    let expected = SETS
        .replace("index=\"3\"></t:ref>", "index=\"2\"></t:ref>")
        .replace("endindex=\"3\"", "endindex=\"2\"");
    assert!(text.contains(&expected), "{text}");
    assert_eq!((losses.len(), losses[0].kind, losses[0].count), (1, LossKind::StaleData, 1));
    assert_eq!(losses[0].message, "object 1: 1 member of a set of triangles is gone with the triangles");
    // The first and the last go: a set becomes empty.
    let (text, losses) = changed(&bytes, |mesh| rearranged(mesh, &all[1..3], &[]));
    assert!(text.contains("<t:triangleset name=\"lid\" identifier=\"a\"></t:triangleset>"), "{text}");
    assert!(text.contains("<t:refrange startindex=\"0\" endindex=\"1\"/>"), "{text}");
    assert_eq!(losses[0].count, 4);
    // Another order, and one twice: what was one run becomes several.
    let one_twice = [all[3], all[1], all[2], all[0], (1, [0, 2, 1])];
    let (text, _) =
        changed(&package(&tetrahedron("", &SETS.replace("endindex=\"3\"", "endindex=\"1\""))), |mesh| {
            rearranged(mesh, &one_twice, &[4])
        });
    let runs = "<t:refrange startindex=\"1\" endindex=\"1\"/><t:refrange startindex=\"3\" endindex=\"4\"/>";
    assert!(text.contains(runs), "{text}");
    assert!(text.contains("<t:ref index=\"3\" /><t:ref index=\"0\"></t:ref>"), "{text}");
}

#[test]
fn members_beyond_the_last_triangle_end_with_the_change() {
    let sets =
        SETS.replace("endindex=\"3\"", "endindex=\"4000000000\"").replace(" index=\"0\"", " index=\"77\"");
    let bytes = package(&tetrahedron("", &sets));
    let (text, losses) = changed(&bytes, |mesh| rearranged(mesh, &[(0, [0, 1, 2])], &[]));
    assert!(text.contains("<t:refrange startindex=\"0\" endindex=\"0\"/>"), "{text}");
    assert!(!text.contains("77"), "{text}");
    assert_eq!(losses[0].kind, LossKind::StaleData);
}

/// The tetrahedron with two more vertices that only beams use, one of them between the others.
fn with_beams() -> Vec<u8> {
    let more =
        "<vertex x=\"9\" y=\"9\" z=\"9\" x:id=\"beam\"/>\n<vertex x=\"8\" y=\"8\" z=\"8\"/>\n</vertices>";
    package(&tetrahedron("", LATTICE).replacen("</vertices>", more, 1))
}

/// A mesh without the vertices that no face uses, and without some faces.
fn compacted(mesh: &PolygonMesh, faces: &[u32]) -> PolygonMesh {
    let faces: Vec<(u32, [usize; 3])> = faces.iter().map(|&face| (face, [0, 1, 2])).collect();
    let mesh = rearranged(mesh, &faces, &[]);
    let mut used: Vec<VertexId> = mesh.faces().corner_vertices().to_vec();
    used.sort_unstable();
    used.dedup();
    let number = |vertex: &VertexId| VertexId(used.binary_search(vertex).unwrap() as u32);
    let corners: Vec<VertexId> = mesh.faces().corner_vertices().iter().map(number).collect();
    let count = mesh.counts();
    let table = FaceTable::triangles(used.len(), corners).unwrap();
    let draft = Draft::of_faces(&mesh, table, Sources::same(count.faces), Sources::same(count.corners));
    let vertex_sources = Sources::listed(used.iter().map(|&vertex| Some(vertex)));
    mesh.rebuild(Draft { vertex_sources, ..draft }).unwrap().0
}

#[test]
fn vertices_of_beams_stay_where_they_were() {
    let bytes = with_beams();
    // Only they went: the file is what it was.
    let read = document(&bytes);
    let mesh = compacted(&read.parts[0].mesh, &[0, 1, 2, 3]);
    assert_eq!(mesh.counts().vertices, 4);
    let (written, losses) = spliced(&read.with_mesh(0, mesh));
    assert_eq!(written, bytes);
    assert_eq!((losses.len(), losses[0].kind, losses[0].count), (1, LossKind::TextLayout, 2));
    assert_eq!(
        losses[0].message,
        "object 1: 2 vertices that no triangle uses stay in the file, as beams need them"
    );
}

#[test]
fn beams_and_balls_name_the_new_numbers() {
    // The third face has the vertices 1, 2 and 3; the beams need 0, 3, 4 and 5.
    let (text, _) = changed(&with_beams(), |mesh| compacted(mesh, &[2]));
    assert_eq!(text.matches("<vertex ").count(), 6);
    assert!(text.contains(LATTICE), "{text}");
    // Without a need of 0 all numbers are one less.
    let other = LATTICE.replace("v1=\"0\" v2=\"4\"", "v1=\"4\" v2=\"3\"");
    let bytes = {
        let more = "<vertex x=\"9\" y=\"9\" z=\"9\"/>\n<vertex x=\"8\" y=\"8\" z=\"8\"/>\n</vertices>";
        package(&tetrahedron("", &other).replacen("</vertices>", more, 1))
    };
    let (text, _) = changed(&bytes, |mesh| compacted(mesh, &[2]));
    let expected = other
        .replace("v1=\"4\" v2=\"3\"", "v1=\"3\" v2=\"2\"")
        .replace("v1=\"5\" v2=\"3\"", "v1=\"4\" v2=\"2\"")
        .replace("vindex=\"5\"", "vindex=\"4\"");
    assert!(text.contains(&expected), "{text}");
}

#[test]
fn slices_of_an_object_that_changed_are_named() {
    let bytes = package(&tetrahedron("s:slicestackid=\"9\"", ""));
    let (text, losses) = changed(&bytes, |mesh| rearranged(mesh, &[(0, [0, 1, 2])], &[]));
    assert!(text.contains("s:slicestackid=\"9\""));
    assert_eq!(losses[0].message, "object 1: the slices were made of its mesh as it was before");
}
