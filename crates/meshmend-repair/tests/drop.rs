//! What `drop` takes away, and what it says of that.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test stops where it fails")]

use meshmend_core::{DefectKind, PolygonMesh};
use meshmend_repair::{Context, DropParts, Internal, Outcome, Pass, PassKind, Pipeline, SmallComponents};

/// Boxes of two triangles a side, each given by its least and its greatest corner.
fn boxes(all: &[[[f64; 3]; 2]]) -> PolygonMesh {
    let (mut points, mut faces) = (Vec::new(), Vec::new());
    for [low, high] in all {
        let first = points.len() as u32;
        let ends = [low, high];
        points
            .extend((0..8usize).map(|code| [ends[code >> 2][0], ends[code >> 1 & 1][1], ends[code & 1][2]]));
        for [a, b, c, d] in
            [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
                .map(|side| side.map(|corner: u32| first + corner))
        {
            faces.extend([[a, b, c], [a, c, d]]);
        }
    }
    PolygonMesh::from_triangles(&points, &faces).unwrap()
}

fn cube(at: f64, side: f64) -> [[f64; 3]; 2] {
    [[at; 3], [at + side; 3]]
}

fn dropped(mesh: &PolygonMesh, components: SmallComponents, internal: Internal) -> Outcome {
    DropParts { components, internal }.apply(mesh, &Context::default()).unwrap()
}

#[test]
fn components_under_a_limit_go_whole_and_are_named() {
    let mesh = boxes(&[cube(0.0, 4.0), cube(5.0, 0.5), cube(7.0, 1.0)]);
    let small = |limit| dropped(&mesh, limit, Internal::Keep);
    let faces = |limit| small(limit).mesh.counts().faces;
    assert_eq!([12, 13].map(|limit| faces(SmallComponents::Faces(limit))), [36, 0], "what is under it goes");
    assert_eq!([1.5, 1.6, 6.5].map(|limit| faces(SmallComponents::Area(limit))), [36, 24, 12]);
    assert_eq!([0.125, 0.2, 1.1].map(|limit| faces(SmallComponents::Volume(limit))), [36, 24, 12]);
    let outcome = small(SmallComponents::Volume(0.2));
    let record = outcome.dropped.unwrap();
    let [component] = &record.components[..] else { panic!("{record:?}") };
    assert_eq!(
        component.to_string(),
        "component of f12: 12 faces, area 1.500000, volume 0.125000: dropped, under the limit"
    );
    assert_eq!((record.opened_edges, record.mixed_faces), (0, 0));
    let fixed: Vec<(DefectKind, Option<u32>)> =
        outcome.fixed.iter().map(|defect| (defect.kind(), defect.at.face().map(|face| face.0))).collect();
    assert_eq!(fixed, (12..24).map(|face| (DefectKind::SmallComponent, Some(face))).collect::<Vec<_>>());
}

#[test]
fn an_open_component_has_no_volume_to_be_under_a_limit() {
    let mut mesh = boxes(&[cube(0.0, 1.0), cube(2.0, 1.0)]);
    let faces: Vec<[u32; 3]> =
        mesh.faces().corner_vertices().chunks(3).map(|face| [face[0].0, face[1].0, face[2].0]).collect();
    mesh = PolygonMesh::from_triangles(mesh.positions(), &faces[1..]).unwrap();
    let outcome = dropped(&mesh, SmallComponents::Volume(9.0), Internal::Keep);
    assert_eq!(outcome.mesh.counts().faces, 11);
}

#[test]
fn what_is_inside_goes_when_asked_for() {
    let mesh = boxes(&[cube(0.0, 4.0), cube(3.0, 0.5), [[-1.0, 1.0, 1.0], [2.0, 3.0, 3.0]]]);
    assert!(dropped(&mesh, SmallComponents::Keep, Internal::Keep).provenance.is_same());
    let whole = dropped(&mesh, SmallComponents::Keep, Internal::RemoveComponents);
    let record = whole.dropped.unwrap();
    assert_eq!(whole.mesh.counts().faces, 24);
    assert_eq!((record.components.len(), record.components[0].lowest_face.0), (1, 12));
    assert!(record.mixed_faces > 0 && record.opened_edges == 0, "two boxes cross: {record:?}");
    let faces = dropped(&mesh, SmallComponents::Keep, Internal::RemoveFaces);
    let record = faces.dropped.unwrap();
    assert_eq!(faces.mesh.counts().faces, 22, "the end of the bar within the large box goes too");
    assert_eq!(record.opened_edges, 4);
    assert!(faces.fixed.iter().all(|defect| defect.kind() == DefectKind::InternalFace));
}

#[test]
fn a_pipeline_drops_before_it_turns_and_says_why_nothing_would_be_left() {
    let mesh = boxes(&[cube(0.0, 4.0), cube(5.0, 0.5)]);
    let drop = |limit| DropParts { components: SmallComponents::Volume(limit), internal: Internal::Keep };
    let pipeline = Pipeline::default().with(drop(1.0));
    let repaired = pipeline.run(&mesh).unwrap();
    assert_eq!((repaired.mesh.counts().faces, repaired.mesh.counts().vertices), (12, 8));
    let reasons = repaired.removed_faces.iter().map(|gone| (gone.pass, gone.reason));
    assert!(reasons.eq(std::iter::repeat_n((PassKind::DropParts, DefectKind::SmallComponent), 12)));
    assert!(!pipeline.run(&repaired.mesh).unwrap().is_changed());
    let refused = Pipeline::default().with(drop(100.0)).run(&mesh).unwrap_err().to_string();
    assert_eq!(
        refused,
        "the repair would remove all 24 faces: faces of small components: 24, because of --drop-components volume:100"
    );
    let nonsense = Pipeline::default().with(drop(f64::NAN)).run(&mesh).unwrap_err().to_string();
    assert_eq!(nonsense, "drop: a limit must be a number of 0 or more, not NaN");
}
