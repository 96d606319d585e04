//! Cuts, judged by what they must leave as it was and by what glues them together again.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "these are tests")]

use std::collections::BTreeSet;

use meshmend_core::{
    Build, Carry, Column, Defect, DefectKind, Domain, EdgeId, EdgeUse, Layer, PolygonMesh, Values, VertexId,
};
use meshmend_cut::{CutAlong, CutError, CutOpen, Discs, cut_open, cut_to_discs};
use meshmend_geometry::edge_lengths;
use meshmend_testkit::Soup;
use meshmend_testkit::shapes::{self, Closed, Shape, Tiles};
use meshmend_topology::{
    CoTree, GeneratorError, GeneratorKind, GeneratorOptions, Roots, Surface, generators, surface_name,
    topology,
};

const GREEDY: GeneratorOptions<'static> =
    GeneratorOptions { lengths: None, co_tree: CoTree::Greedy, roots: Roots::Lowest, watch: None };
const DISC: Surface = Surface::Orientable { genus: 0, holes: 1 };

fn kernel(mesh: &PolygonMesh) -> EdgeUse {
    EdgeUse::build(mesh.complex()).unwrap()
}

fn edge(mesh: &PolygonMesh, one: u32, other: u32) -> EdgeId {
    let edges = mesh.complex().edges();
    edges.edges().find(|&edge| edges.ends(edge) == [VertexId(one), VertexId(other)]).unwrap()
}

/// The surfaces of a catalogue of shapes, and some with long ways round.
fn surfaces() -> Vec<Shape> {
    let mut surfaces = shapes::catalogue();
    surfaces.retain(|shape| shape.truth.manifold);
    surfaces.push(shapes::surface(Closed::Handles(3), 0, 2));
    surfaces.push(shapes::surface(Closed::CrossCaps(3), 2, 2));
    surfaces
}

/// Everything that a cut may not change: with the added vertices called by their sources it is the mesh that it was.
fn assert_same_but_for_the_cut(before: &PolygonMesh, cut: &CutOpen) {
    let (after, sources) = (&cut.mesh, &cut.provenance.vertices);
    let old = |vertex: &VertexId| sources.of(*vertex).unwrap();
    assert!(
        after.faces().corner_vertices().iter().map(old).eq(before.faces().corner_vertices().iter().copied())
    );
    assert_eq!(after.faces().starts(), before.faces().starts());
    for (new, source) in sources.iter() {
        assert_eq!(after.position(new), before.position(source.unwrap()));
    }
    let [edges_before, edges_after] = [before, after].map(|mesh| mesh.complex().edges().edge_count());
    assert_eq!(edges_after, edges_before + cut.seams.len());
    for seam in &cut.seams {
        for (side, ends) in seam.sides.into_iter().zip(seam.side_ends) {
            assert_eq!(ends.map(|end| old(&end)), seam.ends);
            let vertex = after.faces().corner_vertex(side);
            assert!(ends.contains(&vertex));
            let edge = edge(after, ends[0].0.min(ends[1].0), ends[0].0.max(ends[1].0));
            assert_eq!(after.complex().edges().edge_corners(edge).len(), 1, "a seam is open");
        }
        assert_eq!(before.complex().edges().ends(seam.edge), seam.ends);
    }
}

#[test]
fn every_surface_opens_into_a_disc_whose_rim_says_what_it_was() {
    for shape in surfaces() {
        let mesh = shape.soup.mesh();
        for co_tree in [CoTree::Lowest, CoTree::Greedy] {
            let options = GeneratorOptions { co_tree, ..GREEDY };
            let open = cut_to_discs(&mesh, CutAlong::CutGraph, &options).unwrap();
            let [piece] = &open.pieces[..] else { panic!("{}", shape.name) };
            let kind = match (shape.truth.genus, shape.truth.cross_caps) {
                (Some(genus), _) => Surface::Orientable { genus: genus as u64, holes: 0 },
                (None, cross_caps) => {
                    Surface::NonOrientable { cross_caps: cross_caps.unwrap() as u64, holes: 0 }
                }
            };
            let holes = shape.truth.boundary_loops.unwrap() as u64;
            let word = piece.word.as_ref().unwrap();
            assert_eq!(word.surface(), Some(piece.before), "{}: {word}", shape.name);
            assert_eq!((piece.before.holes(), piece.before.genus()), (holes, kind.genus()), "{}", shape.name);
            assert_eq!(piece.before.cross_caps(), kind.cross_caps(), "{}", shape.name);
            assert_eq!(piece.after, DISC);
            assert_disc(&shape, &mesh, open);
        }
    }
}

/// The figures of the disc, counted afresh: χ = 1 and a rim of two sides for each seam beside the boundary that was.
fn assert_disc(shape: &Shape, before: &PolygonMesh, open: Discs) {
    let Discs { mesh, provenance, seams, .. } = open;
    let reports = [before, &mesh].map(|mesh| topology(&kernel(mesh), mesh));
    let [was, is] = &reports;
    assert_eq!((is.euler_characteristic, is.boundary_loops), (1, Some(1)), "{}", shape.name);
    assert_eq!(is.component_kinds[0].name.as_deref(), Some("disc"));
    assert_eq!(is.boundary_edges, was.boundary_edges + 2 * seams.len() as u64, "{}", shape.name);
    let closed = Vec::new();
    assert_same_but_for_the_cut(before, &CutOpen { mesh, provenance, seams, closed });
}

#[test]
fn words_are_as_short_as_the_cut_has_junctions() {
    let word = |shape: Shape| {
        let open = cut_to_discs(&shape.soup.mesh(), CutAlong::CutGraph, &GREEDY).unwrap();
        open.pieces[0].word.as_ref().unwrap().to_string()
    };
    assert_eq!(word(shapes::tetrahedron()), "a a⁻¹");
    assert_eq!(word(shapes::disc(3, 4, Tiles::Quads)), "a");
    assert_eq!(word(shapes::projective_plane()), "a a");
    // The two loops of a torus meet in a vertex or run together for a while.
    let torus = word(shapes::torus(5, 4, Tiles::Quads));
    assert!(["a b a⁻¹ b⁻¹", "a b c a⁻¹ b⁻¹ c⁻¹"].contains(&&torus[..]), "{torus}");
    assert_eq!(word(shapes::annulus(5, 3, Tiles::Quads)).split(' ').count(), 4);
}

#[test]
fn closed_surfaces_hang_together_and_have_no_handle_when_cut_along_their_generators() {
    for shape in surfaces().iter().filter(|shape| shape.truth.boundary_loops == Some(0)) {
        for co_tree in [CoTree::Lowest, CoTree::Greedy] {
            let options = GeneratorOptions { co_tree, ..GREEDY };
            let open = cut_to_discs(&shape.soup.mesh(), CutAlong::Generators, &options).unwrap();
            let report = topology(&kernel(&open.mesh), &open.mesh);
            assert_eq!((report.components, report.patches), (1, 1), "{}", shape.name);
            assert!(matches!(open.pieces[0].after, Surface::Orientable { genus: 0, .. }), "{}", shape.name);
            assert_eq!(Some(open.pieces[0].after.holes()), report.boundary_loops);
            assert_eq!(open.pieces[0].word.is_some(), open.pieces[0].after == DISC, "{}", shape.name);
        }
    }
}

/// Cut along a path with two sides, a closed surface has two new rims; along one with one side, a single one.
#[test]
fn a_path_has_as_many_sides_as_a_cut_along_it_has_rims() {
    let mut seen = [0, 0];
    for shape in surfaces().iter().filter(|shape| shape.truth.boundary_loops == Some(0)) {
        let mesh = shape.soup.mesh();
        let found = generators(&kernel(&mesh), &GREEDY).unwrap();
        for generator in &found.components()[0].generators {
            assert_ne!(generator.kind, GeneratorKind::Boundary);
            let path = found.vertices(generator);
            let sides = path.iter().zip(path.iter().cycle().skip(1));
            let edges: Vec<EdgeId> = sides.map(|(a, b)| edge(&mesh, a.0.min(b.0), a.0.max(b.0))).collect();
            let cut = cut_open(&mesh, &edges).unwrap();
            let rims = topology(&kernel(&cut.mesh), &cut.mesh).boundary_loops;
            assert_eq!(rims, Some(if generator.is_two_sided { 2 } else { 1 }), "{}", shape.name);
            seen[usize::from(generator.is_two_sided)] += 1;
        }
    }
    assert!(seen.iter().all(|&count| count > 10), "{seen:?}");
}

/// Numbers that look random.
fn number(seed: u64) -> u64 {
    let z = seed.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z ^ (z >> 27)
}

#[test]
fn any_set_of_edges_can_be_cut() {
    for (index, shape) in surfaces().iter().enumerate() {
        let mesh = shape.soup.mesh();
        let edges = mesh.complex().edges();
        for round in 0..6 {
            let chosen = |edge: &EdgeId| {
                number((index as u64) << 40 | round << 32 | u64::from(edge.0)) % 8 < round + 1
            };
            let list: Vec<EdgeId> = edges.edges().filter(chosen).collect();
            let cut = cut_open(&mesh, &list).unwrap();
            assert_same_but_for_the_cut(&mesh, &cut);
            let opened: BTreeSet<EdgeId> = cut.seams.iter().map(|seam| seam.edge).chain(cut.closed).collect();
            let interior = list.iter().copied().filter(|&edge| edges.edge_corners(edge).len() == 2);
            assert_eq!(opened, interior.collect());
            let report = topology(&kernel(&cut.mesh), &cut.mesh);
            assert!(report.manifold, "{}", shape.name);
        }
    }
}

#[test]
fn an_edge_alone_within_the_surface_stays_closed_and_is_named() {
    let mesh = shapes::torus(5, 5, Tiles::Quads).soup.mesh();
    let cut = cut_open(&mesh, &[edge(&mesh, 0, 1)]).unwrap();
    assert_eq!((cut.closed, cut.seams.len()), (vec![edge(&mesh, 0, 1)], 0));
    assert!(cut.provenance.is_same());
    let mesh = shapes::disc(2, 2, Tiles::Quads).soup.mesh();
    let rim = edge(&mesh, 0, 1);
    let cut = cut_open(&mesh, &[rim, rim]).unwrap();
    assert!(cut.closed.is_empty() && cut.seams.is_empty() && cut.provenance.is_same());
}

#[test]
fn what_is_no_surface_is_refused() {
    let fan = shapes::three_triangles_on_an_edge().soup.mesh();
    let shared = fan.complex().edges().edges().find(|&e| fan.complex().edges().edge_corners(e).len() == 3);
    let refused = cut_open(&fan, &[shared.unwrap()]).unwrap_err();
    assert!(
        matches!(refused, CutError::NotManifold(Defect { kind: DefectKind::NonManifoldEdge, count: 3, .. })),
        "{refused}"
    );
    let other = fan.complex().edges().edges().find(|&e| fan.complex().edges().edge_corners(e).len() == 1);
    let refused = cut_open(&fan, &[other.unwrap()]).unwrap_err();
    assert!(
        matches!(refused, CutError::NotManifold(Defect { kind: DefectKind::SingularVertex, .. })),
        "{refused}"
    );
    let bow_tie = shapes::bow_tie().soup.mesh();
    let all: Vec<EdgeId> = bow_tie.complex().edges().edges().collect();
    let refused = cut_open(&bow_tie, &all).unwrap_err();
    assert!(
        matches!(refused, CutError::NotManifold(Defect { kind: DefectKind::PinchedVertex, .. })),
        "{refused}"
    );
    for along in [CutAlong::CutGraph, CutAlong::Generators] {
        let refused = cut_to_discs(&bow_tie, along, &GREEDY).unwrap_err();
        assert!(
            matches!(refused, CutError::NotManifold(Defect { kind: DefectKind::PinchedVertex, .. })),
            "{refused}"
        );
    }
    let beyond = EdgeId(all.len() as u32);
    assert_eq!(cut_open(&bow_tie, &[beyond]).unwrap_err(), CutError::NoSuchEdge(beyond));
    let disc = shapes::disc(2, 2, Tiles::Quads).soup.mesh();
    let refused = cut_to_discs(&disc, CutAlong::Generators, &GREEDY).unwrap_err();
    assert_eq!(
        refused.to_string(),
        "only a closed surface is cut along its generators: component 0 has a boundary"
    );
    let no_root = GeneratorOptions { roots: Roots::At(VertexId(99)), ..GREEDY };
    let refused = cut_to_discs(&disc, CutAlong::CutGraph, &no_root).unwrap_err();
    assert_eq!(refused, CutError::Generators(GeneratorError::NoSuchRoot(VertexId(99))));
}

#[test]
fn components_become_discs_one_by_one() {
    let parts = [
        shapes::torus(4, 5, Tiles::Quads),
        shapes::klein_bottle(3, 4, Tiles::Triangles),
        shapes::surface(Closed::Handles(1), 3, 0),
        shapes::tetrahedron(),
    ];
    let mesh = Soup::beside(&parts.map(|shape| shape.soup), 10.0).mesh();
    let open = cut_to_discs(&mesh, CutAlong::CutGraph, &GREEDY).unwrap();
    let names: Vec<String> = open.pieces.iter().map(|piece| surface_name(piece.before)).collect();
    assert_eq!(names, ["torus", "Klein bottle", "torus with 3 holes", "sphere"]);
    for piece in &open.pieces {
        assert_eq!(piece.word.as_ref().and_then(|word| word.surface()), Some(piece.before));
    }
}

#[test]
fn attributes_stay_with_their_corners_faces_and_vertices() {
    let mesh = shapes::torus(4, 5, Tiles::Quads).soup.mesh();
    let numbers = |count: usize| Values::F64((0..count).map(|i| i as f64).collect());
    let counts = mesh.counts();
    let layer =
        |name: &str, domain, count| Layer::direct(name, domain, 1, Carry::Interpolate, numbers(count));
    let layers = vec![
        layer("texcoord", Domain::Corner, counts.corners),
        layer("colour", Domain::Vertex, counts.vertices),
        layer("quality", Domain::Face, counts.faces),
    ];
    let mesh = mesh
        .with_layers(layers)
        .unwrap()
        .with_loose(vec![[VertexId(0), VertexId(9)]], vec![VertexId(3)])
        .unwrap();
    let open = cut_to_discs(&mesh, CutAlong::CutGraph, &GREEDY).unwrap();
    assert!(open.mesh.counts().vertices > counts.vertices);
    assert_eq!(open.mesh.layer("texcoord", Domain::Corner), mesh.layer("texcoord", Domain::Corner));
    assert_eq!(open.mesh.layer("quality", Domain::Face), mesh.layer("quality", Domain::Face));
    let colour = open.mesh.layer("colour", Domain::Vertex).unwrap();
    for (new, old) in open.provenance.vertices.iter() {
        let old = mesh.layer("colour", Domain::Vertex).unwrap().value_of(old.unwrap().0 as usize);
        assert_eq!(colour.value_of(new.0 as usize), old);
    }
    assert_eq!(open.mesh.loose_edges(), mesh.loose_edges());
    assert_eq!(open.mesh.loose_points(), mesh.loose_points());
}

/// A corner that repeats another goes with it, also round the end of the face, and a degenerate face stays.
#[test]
fn corners_that_the_complex_leaves_out_go_with_those_that_they_repeat() {
    let faces: [&[u32]; 5] =
        [&[0, 2, 2, 1, 1], &[1, 3, 3, 0, 0, 1], &[1, 2, 3], &[0, 0, 3, 2, 0, 0], &[0, 1]];
    let mesh = Soup::generic(4, faces).mesh();
    for (one, other) in [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)] {
        for (first, second) in [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)] {
            let cut = cut_open(&mesh, &[edge(&mesh, one, other), edge(&mesh, first, second)]).unwrap();
            assert_same_but_for_the_cut(&mesh, &cut);
            let report = topology(&kernel(&cut.mesh), &cut.mesh);
            let joined = [one, other].contains(&first) != [one, other].contains(&second);
            let expected = if joined { (1, Some(1)) } else { (2, Some(0)) };
            assert_eq!((report.euler_characteristic, report.boundary_loops), expected);
            assert_eq!(report.degenerate_faces, 1);
        }
    }
}

#[test]
fn a_face_that_is_glued_to_itself_opens_too() {
    // A torus of one face, and a sphere of one face that goes out and back.
    for faces in [&[0, 1, 2, 0, 3, 4, 0, 2, 1, 0, 4, 3][..], &[0, 1, 2, 1]] {
        let mesh = Soup::generic(5, [faces]).mesh();
        let open = cut_to_discs(&mesh, CutAlong::CutGraph, &GREEDY).unwrap();
        assert_eq!(open.pieces[0].after, DISC);
        assert_eq!(open.pieces[0].word.as_ref().unwrap().surface(), Some(open.pieces[0].before));
    }
}

#[test]
fn lengths_are_measured_in_space() {
    let mesh = Soup::generic(3, [[0, 1, 2]]).mesh();
    let positions = vec![[0.0; 3], [3.0, 4.0, 0.0], [0.0, 0.0, 2.0]];
    let lengths: Column<EdgeId, f64> = edge_lengths(&mesh.with_positions(positions).unwrap());
    assert_eq!(lengths.values(), [5.0, 2.0, 29f64.sqrt()]);
}
