//! Faces that repeat another one but differ from it: a decal, a second object over the same vertices.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test stops where it fails")]

use meshmend_core::{
    Aspect, Carry, Connectivity, Defect, DefectKind, Differences, Domain, EdgeUse, FaceId, Id, Layer,
    PolygonMesh, Values,
};
use meshmend_kernels::KernelKind;
use meshmend_repair::{PassKind, Pipeline, Plan, Repaired, Repeated, Session, SplitEdges};
use meshmend_testkit::{Soup, worlds};
use meshmend_topology::topology;
use proptest::prelude::*;

fn material(uses: &[u32]) -> Layer {
    let names = ["red", "blue", "green"].map(|name| name.as_bytes().to_vec());
    Layer::indexed("material", Domain::Face, 1, Carry::Copy, Values::Text(names.to_vec()), uses.to_vec())
}

fn texcoord(uses: Vec<u32>) -> Layer {
    let values = Values::F64((0..8).map(f64::from).collect());
    Layer::indexed("texcoord", Domain::Corner, 2, Carry::Interpolate, values, uses)
}

fn painted(soup: &Soup, uses: &[u32]) -> PolygonMesh {
    soup.mesh().with_layers(vec![material(uses)]).unwrap()
}

/// A tetrahedron that looks outward.
const TETRAHEDRON: [[u32; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];

fn positions() -> Vec<[f64; 3]> {
    [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]].map(|p: [i32; 3]| p.map(f64::from)).to_vec()
}

fn soup(faces: impl IntoIterator<Item = [u32; 3]>) -> Soup {
    Soup { positions: positions(), faces: faces.into_iter().map(Vec::from).collect() }
}

/// The same with vertices of its own for each face, as STL has them.
fn apart(soup: &Soup) -> Soup {
    let positions = soup.faces.iter().flatten().map(|&v| soup.positions[v as usize]).collect();
    let mut next = 0..;
    let faces = soup.faces.iter().map(|face| next.by_ref().take(face.len()).collect());
    Soup { positions, faces: faces.collect() }
}

fn kinds_left(repaired: &Repaired, pass: PassKind) -> Vec<Defect> {
    let records = repaired.passes.iter().filter(|record| record.pass == pass);
    records.flat_map(|record| record.left.clone()).collect()
}

/// The names of the components, in order.
fn components(repaired: &Repaired) -> Vec<(u64, Option<String>)> {
    let report = topology(&EdgeUse::assemble(repaired.mesh.complex()), &repaired.mesh);
    report.component_kinds.into_iter().map(|kind| (kind.count, kind.name)).collect()
}

fn named(names: &[(u64, &str)]) -> Vec<(u64, Option<String>)> {
    names.iter().map(|&(count, name)| (count, Some(name.to_owned()))).collect()
}

#[track_caller]
fn assert_final(repaired: &Repaired, pipeline: &Pipeline) {
    let again = pipeline.run(&repaired.mesh).unwrap();
    assert_eq!(again.mesh.faces(), repaired.mesh.faces());
    assert_eq!(again.mesh.positions(), repaired.mesh.positions());
    assert!(again.removed_faces.is_empty());
}

#[test]
fn a_decal_stays_a_sheet_of_its_own_and_the_body_stays_closed() {
    for (lying, face) in TETRAHEDRON.into_iter().enumerate() {
        for stored in [soup, (|faces: Vec<[u32; 3]>| apart(&soup(faces))) as fn(Vec<[u32; 3]>) -> Soup] {
            let mut faces = TETRAHEDRON.to_vec();
            faces.push(face);
            faces[4].rotate_left(lying % 3);
            let mesh = painted(&stored(faces), &[0, 0, 0, 0, 1]);
            let repaired = Pipeline::default().run(&mesh).unwrap();
            assert_eq!(repaired.mesh.counts().faces, 5);
            assert_eq!(components(&repaired), named(&[(1, "sphere"), (1, "disc")]), "face {lying}");
            let differs: Differences = [Aspect::Material].into_iter().collect();
            let defect = Defect::differing_face(FaceId(4), FaceId::new(lying), differs);
            assert_eq!(kinds_left(&repaired, PassKind::Orient), [defect]);
            assert!(repaired.provenance.flipped.is_empty());
            assert_final(&repaired, &Pipeline::default());
        }
    }
}

#[test]
fn a_decal_alone_on_its_face_is_not_sewn_to_it() {
    let mesh = painted(&soup([[0, 1, 2], [1, 2, 0]]), &[0, 1]);
    let repaired = Pipeline::default().run(&mesh).unwrap();
    assert_eq!(components(&repaired), named(&[(2, "disc")]));
    assert_eq!((repaired.mesh.counts().vertices, repaired.provenance.flipped.len()), (6, 0));
    assert_eq!(kinds_left(&repaired, PassKind::Clean).len(), 1);
    assert_final(&repaired, &Pipeline::default());
}

#[test]
fn objects_over_one_list_of_vertices_stay_whole() {
    for copies in 2..5 {
        let faces = TETRAHEDRON.repeat(copies);
        let names = Values::Text((0..copies as u8).map(|object| vec![b'a' + object]).collect());
        let uses = (0..faces.len()).map(|face| (face / 4) as u32).collect();
        let layer = Layer::indexed("object", Domain::Face, 1, Carry::Copy, names, uses);
        for stored in [soup(faces.clone()), apart(&soup(faces.clone()))] {
            let mesh = stored.mesh().with_layers(vec![layer.clone()]).unwrap();
            let repaired = Pipeline::default().run(&mesh).unwrap();
            assert_eq!(components(&repaired), named(&[(copies as u64, "sphere")]));
            assert_final(&repaired, &Pipeline::default());
        }
    }
}

#[test]
fn of_three_the_two_that_are_alike_are_one() {
    let mesh = painted(&soup([[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 1, 2]]), &[0, 1, 1, 0]);
    let repaired = Pipeline::default().run(&mesh).unwrap();
    let removed: Vec<u32> = repaired.removed_faces.iter().map(|removed| removed.face.0).collect();
    assert_eq!((repaired.mesh.counts().faces, removed), (2, vec![2, 3]));
    assert!(repaired.removed_faces.iter().all(|removed| removed.differed.is_empty()));
}

#[test]
fn texture_coordinates_count_at_each_corner_however_the_face_begins() {
    let faces = soup([[0, 1, 2], [1, 2, 0]]);
    let run = |uses: [u32; 6]| {
        let mesh = faces.mesh().with_layers(vec![texcoord(uses.to_vec())]).unwrap();
        Pipeline::default().run(&mesh).unwrap().mesh.counts().faces
    };
    assert_eq!(run([0, 1, 2, 1, 2, 0]), 1);
    assert_eq!(run([0, 1, 2, 0, 1, 2]), 2);
    assert_eq!(run([0, 1, 2, 1, 2, u32::MAX]), 2);
}

#[test]
fn equal_values_are_equal_wherever_they_are_in_the_pool() {
    let pool = Values::Text(vec![b"red".to_vec(), b"red".to_vec()]);
    let layer = Layer::indexed("material", Domain::Face, 1, Carry::Copy, pool, vec![0, 1]);
    let mesh = soup([[0, 1, 2], [0, 1, 2]]).mesh().with_layers(vec![layer]).unwrap();
    assert_eq!(Pipeline::default().run(&mesh).unwrap().mesh.counts().faces, 1);
}

#[test]
fn layers_that_do_not_count_make_no_difference() {
    let layer = |name: &str, domain, count: u32| {
        Layer::direct(name, domain, 1, Carry::Copy, Values::U32((0..count).collect()))
    };
    let layers = vec![layer("normal", Domain::Corner, 6), layer("quality", Domain::Face, 2)];
    let mesh = soup([[0, 1, 2], [0, 1, 2]]).mesh().with_layers(layers).unwrap();
    assert_eq!(Pipeline::default().run(&mesh).unwrap().mesh.counts().faces, 1);
}

#[test]
fn vertex_colours_count_where_vertices_of_several_colours_are_welded() {
    let stored = apart(&soup([[0, 1, 2], [0, 1, 2]]));
    let colors = |values: [u8; 6]| {
        let layer = Layer::direct("color", Domain::Vertex, 1, Carry::Copy, Values::U8(values.to_vec()));
        let mesh = stored.mesh().with_layers(vec![layer]).unwrap();
        Pipeline::default().run(&mesh).unwrap().mesh.counts().faces
    };
    assert_eq!([colors([7, 8, 9, 7, 8, 9]), colors([7, 8, 9, 7, 8, 1])], [1, 2]);
}

#[test]
fn what_the_policy_or_the_output_drops_is_named_with_what_it_had() {
    let mesh = painted(&soup(TETRAHEDRON.into_iter().chain([TETRAHEDRON[2]])), &[0, 0, 0, 0, 1]);
    let mut plan = Plan::default();
    plan.clean.repeated = Repeated::Drop;
    for pipeline in [plan.pipeline(), Pipeline::default().for_layers(vec![false])] {
        let repaired = pipeline.run(&mesh).unwrap();
        let [removed] = repaired.removed_faces[..] else { panic!("{:?}", repaired.removed_faces) };
        assert_eq!((removed.face, removed.reason), (FaceId(4), DefectKind::DuplicateFace));
        assert_eq!(removed.differed.to_string(), "material");
        assert_final(&repaired, &pipeline);
    }
    let whole = apart(&soup(TETRAHEDRON.repeat(2)));
    let whole = painted(&whole, &[0, 0, 0, 0, 1, 1, 1, 1]);
    let repaired = Pipeline::default().for_layers(vec![false]).run(&whole).unwrap();
    assert!(repaired.removed_faces.iter().all(|removed| removed.differed.to_string() == "material"));
    assert_eq!(repaired.removed_faces.len(), 4);
}

#[test]
fn a_duplicate_patch_that_differs_in_one_face_stays() {
    let stored = apart(&soup(TETRAHEDRON.repeat(2)));
    let with = |last| painted(&stored, &[0, 0, 0, 0, 0, 0, 0, last]);
    let faces = |mesh| Pipeline::default().run(&mesh).unwrap().mesh.counts().faces;
    // As stored each face of a soup is a patch of its own.
    assert_eq!([faces(with(0)), faces(with(1))], [4, 5]);
    // With shared vertices the second tetrahedron is one patch, and stays whole.
    let mut shared = soup(TETRAHEDRON);
    shared.positions.extend(positions());
    shared.faces.extend(TETRAHEDRON.map(|face| face.map(|v| v + 4).to_vec()));
    let with = |last| painted(&shared, &[0, 0, 0, 0, 0, 0, 0, last]);
    assert_eq!([faces(with(0)), faces(with(1))], [4, 8]);
}

#[test]
fn two_materials_on_a_wall_with_two_sides_are_no_repeats() {
    let mesh = painted(&soup([[0, 1, 2], [0, 2, 1]]), &[0, 1]);
    let repaired = Pipeline::default().run(&mesh).unwrap();
    assert_eq!(components(&repaired), named(&[(1, "sphere")]));
    let left: Vec<DefectKind> = kinds_left(&repaired, PassKind::Orient).iter().map(Defect::kind).collect();
    assert_eq!(left, [DefectKind::OppositeFace]);
    let mut plan = Plan::default();
    plan.orient.duplicates = meshmend_repair::Duplicates::KeepFirst;
    let one = plan.pipeline().run(&mesh).unwrap();
    assert_eq!((one.mesh.counts().faces, one.removed_faces[0].differed.to_string()), (1, "material".into()));
    // A decal that runs as the first face does is no opposite of it.
    let mesh = painted(&soup([[0, 1, 2], [0, 2, 1], [1, 2, 0]]), &[0, 1, 2]);
    assert_eq!(plan.pipeline().run(&mesh).unwrap().mesh.counts().faces, 2);
}

#[test]
fn polygons_and_decals_over_several_faces() {
    // Two squares side by side, and both again in another material.
    let positions = [[0, 0], [1, 0], [2, 0], [0, 1], [1, 1], [2, 1]];
    let positions = positions.map(|[x, y]: [i32; 2]| [f64::from(x), f64::from(y), 0.0]).to_vec();
    let squares = [[0, 1, 4, 3], [1, 2, 5, 4]];
    let faces: Vec<Vec<u32>> = squares.iter().chain(&squares).map(|face| face.to_vec()).collect();
    let soup = Soup { positions, faces };
    // Under `cut` the edge of four sides is left unmatched, so that each square comes apart.
    for (edges, discs) in [(SplitEdges::Sheets, 2), (SplitEdges::Cut, 4)] {
        let mut plan = Plan::default();
        plan.split.edges = edges;
        let pipeline = plan.pipeline();
        let repaired = pipeline.run(&painted(&soup, &[0, 0, 1, 1])).unwrap();
        assert_eq!(components(&repaired), named(&[(discs, "disc")]));
        assert_final(&repaired, &pipeline);
    }
}

#[test]
fn many_decals_on_one_place_take_no_longer_than_sorting() {
    let count = 20_000;
    let soup = soup(std::iter::repeat_n([0, 1, 2], count));
    let names = Values::Text((0..count).map(|name| name.to_string().into_bytes()).collect());
    let layer = Layer::direct("material", Domain::Face, 1, Carry::Copy, names);
    let repaired = Pipeline::default().run(&soup.mesh().with_layers(vec![layer]).unwrap()).unwrap();
    assert_eq!((repaired.mesh.counts().faces, repaired.mesh.counts().vertices), (count, 3 * count));
}

/// A random soup with a material and a texture coordinate at each corner, few of each, and some faces there again.
fn painted_soup() -> impl Strategy<Value = PolygonMesh> {
    let repeats = prop::collection::vec((any::<prop::sample::Index>(), 0..4usize), 0..6);
    let uses = prop::collection::vec(0..3u32, 64);
    (worlds::any_table(7), repeats, uses).prop_map(|(mut soup, repeats, uses)| {
        for (which, turn) in repeats {
            if soup.faces.is_empty() {
                break;
            }
            let mut face = which.get(&soup.faces).clone();
            if !face.is_empty() {
                let turn = turn % face.len();
                face.rotate_left(turn);
            }
            soup.faces.push(face);
        }
        let faces: Vec<u32> = (0..soup.faces.len()).map(|face| uses[face % uses.len()]).collect();
        let corners: usize = soup.faces.iter().map(Vec::len).sum();
        let corners = (0..corners).map(|corner| uses[(7 * corner) % uses.len()] / 2).collect();
        soup.mesh().with_layers(vec![material(&faces), texcoord(corners)]).unwrap()
    })
}

/// Whether two faces over the same places in the same direction share an edge by index.
fn has_sewn_copies(mesh: &PolygonMesh) -> bool {
    let kernel = EdgeUse::assemble(mesh.complex());
    let cycle = |face| {
        let bits = |v| mesh.position(v).map(|x| (x + 0.0).to_bits());
        let mut places: Vec<_> = kernel.face_vertices(face).map(bits).collect();
        let least = (0..places.len()).min_by_key(|&at| (places[at], at)).unwrap_or(0);
        places.rotate_left(least);
        places
    };
    kernel.edges().any(|edge| {
        let faces: Vec<FaceId> = kernel.edge_faces(edge).collect();
        faces.len() == 2 && faces[0] != faces[1] && cycle(faces[0]) == cycle(faces[1])
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn laws(mesh in painted_soup()) {
        let allow = |plan: Plan| plan.pipeline().on_emptying(meshmend_repair::Emptying::Allow);
        let pipeline = allow(Plan::default());
        let repaired = pipeline.run(&mesh).unwrap();
        prop_assert!(!has_sewn_copies(&repaired.mesh));
        let again = pipeline.run(&repaired.mesh).unwrap();
        prop_assert_eq!(again.mesh.faces(), repaired.mesh.faces());
        prop_assert!(again.removed_faces.is_empty() && again.provenance.flipped.is_empty());
        for kernel in [KernelKind::FaceVertex, KernelKind::AdjacencyLists] {
            let other = pipeline.run_in(Session::begin(&mesh).with_kernel(kernel)).unwrap();
            prop_assert_eq!(other.mesh.faces(), repaired.mesh.faces());
        }
        prop_assert!(repaired.removed_faces.iter().all(|removed| removed.differed.is_empty()));

        // Dropped are the faces that would be repeats if they all looked alike.
        let plain = mesh.clone().with_layers(Vec::new()).unwrap();
        let plain = pipeline.run(&plain).unwrap();
        let mut dropping = Plan::default();
        dropping.clean.repeated = Repeated::Drop;
        for dropping in [allow(dropping), pipeline.clone().for_layers(vec![false; 2])] {
            let dropped = dropping.run(&mesh).unwrap();
            prop_assert_eq!(dropped.mesh.faces(), plain.mesh.faces());
            prop_assert_eq!(dropped.mesh.positions().len(), plain.mesh.positions().len());
        }
    }
}
