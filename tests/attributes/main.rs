//! What a mesh carries beside its shape goes through repair and conversion: each corner keeps its texture coordinate
//! and each face its material, and what a format can't carry is named.

use meshmend_core::Domain;
use meshmend_io::{Encoding, Format, LossKind, Seams};
use meshmend_repair::{PassError, PassKind, Pipeline};
use meshmend_tests::corpus::corpus;
use meshmend_tests::each::assert_each;

mod conversions;
mod values;

use values::{TWO_TETRAHEDRA, Target, appearance, converted, first_changed_value, read, readable};

#[test]
fn welding_and_splitting_keep_every_texture_coordinate_and_material() {
    let stored = read(TWO_TETRAHEDRA.as_bytes(), "two.obj");
    let repaired = Pipeline::default().run(&stored).unwrap();
    let changed: Vec<PassKind> =
        repaired.passes.iter().filter(|pass| pass.is_changed).map(|pass| pass.pass).collect();
    assert_eq!(changed, [PassKind::Weld, PassKind::Split]);
    assert_eq!(repaired.mesh.counts().vertices, 8);
    assert_eq!(appearance(&repaired.mesh), appearance(&stored));
    let target = Target { format: Format::Obj, encoding: Encoding::Ascii, seams: Seams::Split };
    let (again, losses) = converted(&repaired.mesh, target);
    assert_eq!(losses, []);
    assert_eq!(appearance(&again), appearance(&stored));
    assert_eq!(again.metadata(), stored.metadata());
}

/// Normals turn with their faces; all else stays as it is.
#[test]
fn flipped_faces_keep_their_values_corner_by_corner() {
    let turned = TWO_TETRAHEDRA.replace("f 1/1/1 2/2/1 3/3/2", "f 1/1/1 3/3/2 2/2/1");
    let opposite = TWO_TETRAHEDRA
        .replace("vn 0 1 0\n", "vn 0 1 0\nvn -0 -0 -1\nvn -0 -1 -0\n")
        .replace("f 1/1/1 2/2/1 3/3/2", "f 1/1/3 2/2/3 3/3/4");
    let [stored, straight] = [turned, opposite].map(|text| read(text.as_bytes(), "two.obj"));
    let repaired = Pipeline::default().run(&stored).unwrap();
    assert_eq!(repaired.provenance.flipped.len(), 1);
    assert_eq!(appearance(&repaired.mesh), appearance(&straight));
}

/// A cube's face of three strips with properties of every kind, two of its vertices stored twice.
const RICH_PLY: &str = "\
ply
format ascii 1.0
comment made by hand
element vertex 7
property double x
property double y
property double z
property uchar red
property uchar green
property uchar blue
property float quality
property short flags
element face 3
property list uchar int vertex_indices
property uchar red
property uchar green
property uchar blue
property list uchar float weights
property int region
end_header
0 0 0 255 0 0 0.5 1
1 0 0 0 255 0 0.25 -2
1 1 0 0 0 255 0.125 3
0 1 0 9 9 9 1e-9 4
1 0 0 0 255 0 0.25 -2
1 1 0 77 0 255 0.125 3
2 0 0 1 2 3 7 5
3 0 1 2 10 20 30 2 0.5 0.75 -1
3 0 2 3 40 50 60 0 70000
3 4 6 5 7 8 9 1 3 5
";

#[test]
fn custom_properties_and_colours_of_a_ply_file_go_through_a_repair() {
    let stored = read(RICH_PLY.as_bytes(), "rich.ply");
    let repaired = Pipeline::default().run(&stored).unwrap();
    assert_eq!(repaired.mesh.counts().vertices, 5, "the strips are stitched");
    assert_eq!(appearance(&repaired.mesh), appearance(&stored));
    let home =
        |name: &str| repaired.mesh.layers().iter().find(|layer| layer.name() == name).unwrap().domain();
    assert_eq!(home("color"), Domain::Corner, "the two vertices that are joined have different colours");
    assert_eq!(home("quality"), Domain::Vertex, "they have the same quality");
    for target in Target::all().filter(|target| target.format == Format::Ply) {
        let Target { encoding, seams, .. } = target;
        let (again, losses) = converted(&repaired.mesh, target);
        let losses: Vec<_> = losses.iter().map(|loss| (loss.kind, loss.count)).collect();
        let (named, vertices) = match seams {
            Seams::Corners => (vec![], 5),
            _ => (vec![(LossKind::SeamVertices, 1)], 6),
        };
        assert_eq!((losses, again.counts().vertices), (named, vertices), "{encoding} {seams:?}");
        assert_eq!(appearance(&again), appearance(&stored), "{encoding} {seams:?}");
    }
}

#[test]
fn every_value_in_the_corpus_follows_its_corner_or_face_through_a_repair() {
    let Some(entries) = corpus() else { return };
    let mut meshes = readable(&entries);
    meshes.retain(|(_, mesh)| !mesh.layers().is_empty());
    assert!(meshes.len() > 100, "only {} files have attributes", meshes.len());
    assert_each(&meshes, |(entry, stored)| {
        let repaired = match Pipeline::default().run(stored) {
            Ok(repaired) => repaired,
            Err(PassError::Emptied(_)) => return Vec::new(),
            Err(error) => return vec![format!("{}: {error}", entry.name)],
        };
        let changed = first_changed_value(stored, &repaired, &repaired.mesh);
        changed.map(|changed| format!("{}: {changed}", entry.name)).into_iter().collect()
    });
}
