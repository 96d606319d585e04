//! What passes say that they fixed and left, and which elements of the mesh as stored are behind those of the result.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test stops where it fails")]

use meshmend_core::{Defect, DefectKind, EdgeId, FaceId, VertexId};
use meshmend_repair::{
    Clean, Context, Distance, Duplicates, Orient, Outcome, Pass, PassKind, Plan, Repaired, Split, SplitEdges,
    Triangulate, TriangulateFaces,
};
use meshmend_testkit::laws::{DefectCounts, Promise};
use meshmend_testkit::{Soup, shapes};

/// What a pass does to a mesh to which nothing was done before.
fn alone(pass: &impl Pass, soup: &Soup) -> Outcome {
    pass.apply(&soup.mesh(), &Context::default()).unwrap()
}

/// What some passes do with the options of a plan.
fn in_a_row(passes: &[PassKind], plan: Plan, soup: &Soup) -> Repaired {
    Plan { passes: passes.to_vec(), ..plan }.pipeline().run(&soup.mesh()).unwrap()
}

fn fixed(outcome: &Outcome) -> Vec<Defect> {
    outcome.fixed.iter().collect()
}

#[test]
fn clean_names_a_repeated_triangle_with_the_first_of_its_kind() {
    let soup = Soup::generic(6, [[3, 4, 5], [0, 1, 2], [0, 2, 1], [1, 2, 0]]);
    let cleaned = alone(&Clean::default(), &soup);
    assert_eq!(fixed(&cleaned), [Defect::duplicate_face(FaceId(3), FaceId(1))]);
    assert_eq!(Soup::of_mesh(&cleaned.mesh).faces, soup.faces[..3]);
}

#[test]
fn orient_has_nothing_to_say_of_a_mesh_that_is_oriented() {
    for shape in [shapes::tetrahedron(), shapes::fan(5), shapes::torus(5, 4, shapes::Tiles::Quads)] {
        let outcome = alone(&Orient::default(), &shape.soup);
        assert_eq!((fixed(&outcome), outcome.left), (vec![], vec![]), "{}", shape.name);
    }
}

/// Two triangles whose common edge both run the same way, and another two.
#[test]
fn on_a_tie_the_lowest_face_of_a_patch_stays() {
    let outcome = alone(&Orient::default(), &Soup::generic(8, [[0, 1, 2], [1, 2, 3], [4, 5, 6], [4, 7, 6]]));
    assert_eq!(outcome.provenance.flipped, [1, 3].map(FaceId));
}

/// A triangle apart, a triangle, and another one in the same place.
#[test]
fn orient_names_a_dropped_face_with_the_one_that_stays() {
    let mut soup = Soup::generic(6, [[3, 4, 5], [0, 1, 2], [6, 7, 8]]);
    soup.positions.extend_from_within(..3);
    let repaired = in_a_row(&[PassKind::Weld, PassKind::Orient], Plan::default(), &soup);
    let named: Vec<Defect> = repaired.passes[1].fixed.iter().collect();
    assert_eq!(named, [Defect::duplicate_face(FaceId(2), FaceId(1))]);
}

#[test]
fn opposite_faces_are_called_so_whether_they_stay_or_go() {
    let wall = Soup::generic(6, [[3, 4, 5], [0, 1, 2], [0, 2, 1]]);
    let orient = |duplicates| alone(&Orient { duplicates, ..Orient::default() }, &wall);
    let second = Defect::opposite_face(FaceId(2), FaceId(1));
    let kept = orient(Duplicates::Keep);
    assert_eq!((fixed(&kept), &kept.left[..]), (vec![], &[second.clone()][..]));
    let first = orient(Duplicates::KeepFirst);
    assert_eq!((fixed(&first), &first.left[..]), (vec![second], &[][..]));
    let gone = orient(Duplicates::RemovePair);
    let kinds: Vec<DefectKind> = fixed(&gone).iter().map(Defect::kind).collect();
    assert_eq!((kinds, gone.left), (vec![DefectKind::OppositeFace; 2], vec![]));
}

#[test]
fn split_names_the_edges_that_it_took_apart_or_left() {
    let book = Soup::generic(5, [[0, 1, 2], [0, 1, 3], [0, 1, 4]]);
    let spine = Defect::non_manifold_edge(EdgeId(0), [0, 1].map(VertexId), 3);
    let sheets = alone(&Split::default(), &book);
    assert!(fixed(&sheets).contains(&spine) && sheets.left.is_empty(), "{:?}", sheets.fixed);
    let whole = alone(&Split { edges: SplitEdges::PinchOnly, ..Split::default() }, &book);
    assert!(fixed(&whole).is_empty() && whole.left == [spine], "{:?}", whole.fixed);
}

/// A vertex with a hair's breadth to the next one, in a face that is gone once they are joined: what is left of the two
/// is the other one.
#[test]
fn a_vertex_of_the_result_is_where_the_stored_one_behind_it_is() {
    let [near, x, y, origin] = [[0.01, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0; 3]];
    let in_order = (vec![near, origin, x, y], vec![vec![0, 1, 2], vec![1, 2, 3]]);
    let in_another = (vec![near, x, y, origin], vec![vec![0, 3, 1], vec![3, 1, 2]]);
    let mut plan = Plan::default();
    plan.weld.distance = Distance::Absolute(0.1);
    for (positions, faces) in [in_order, in_another] {
        let soup = Soup { positions, faces };
        let repaired = plan.pipeline().run(&soup.mesh()).unwrap();
        let behind: Vec<_> =
            repaired.provenance.vertices.iter().map(|(_, stored)| stored.unwrap().0).collect();
        assert_eq!(behind, [1, 2, 3]);
        assert_eq!(repaired.mesh.positions(), &soup.positions[1..]);
    }
}

#[test]
fn a_relative_tolerance_is_a_part_of_the_diagonal() {
    // The diagonal is 70 long, a hundredth of it 0.7.
    let positions = vec![[0.0; 3], [0.6, 0.0, 0.0], [1.4, 0.0, 0.0], [20.0, 30.0, 60.0]];
    let soup = Soup { positions, faces: vec![vec![0, 2, 3], vec![1, 2, 3]] };
    let mut plan = Plan::default();
    plan.weld.distance = Distance::Relative(0.01);
    let welded = in_a_row(&[PassKind::Weld], plan, &soup);
    let joined: Vec<Defect> = welded.passes[0].fixed.iter().collect();
    assert_eq!(joined, [Defect::coincident_vertex(VertexId(1), VertexId(0))]);
}

/// Three squares over the same four vertices.
fn hemicube() -> Soup {
    let positions = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[x, y]| [f64::from(x), f64::from(y), 0.0]).to_vec();
    Soup { positions, faces: vec![vec![0, 1, 2, 3], vec![0, 2, 1, 3], vec![0, 1, 3, 2]] }
}

#[test]
fn split_knows_vertices_that_were_created_before() {
    let mut plan = Plan::default();
    plan.triangulate.faces = TriangulateFaces::All;
    let repaired = in_a_row(&[PassKind::Triangulate, PassKind::Split], plan, &hemicube());
    let counts = repaired.mesh.counts();
    assert_eq!((counts.vertices, counts.faces), (4 + 3, 3 * 4));
    assert!(!repaired.passes[1].is_changed);
}

/// The squares lie about the origin, where there is a vertex.
#[test]
fn a_created_vertex_keeps_away_from_one_at_minus_zero() {
    let mut soup = hemicube();
    soup.positions.iter_mut().for_each(|[x, y, _]| (*x, *y) = (2.0 * *x - 1.0, 2.0 * *y - 1.0));
    soup.positions.push([-0.0; 3]);
    let cut = alone(&Triangulate { faces: TriangulateFaces::All }, &soup).mesh;
    assert_eq!(cut.counts().vertices, 5 + 3);
    let lowest = meshmend_geometry::coincident::coincident_vertices(&cut);
    assert!(lowest.iter().zip(0..).all(|(low, v)| low.0 == v), "{:?}", cut.positions());
}

/// A vertex stands at the middle of the squares and halfway from there to each of their corners.
#[test]
fn created_vertices_are_all_in_places_of_their_own_in_a_crowd() {
    let mut soup = hemicube();
    let taken = [[0.5, 0.5], [0.25, 0.25], [0.75, 0.25], [0.75, 0.75], [0.25, 0.75]];
    soup.positions.extend(taken.map(|[x, y]| [x, y, 0.0]));
    soup.faces.extend([vec![4, 5, 6], vec![4, 7, 8]]);
    let pass = Triangulate { faces: TriangulateFaces::All };
    let cut = alone(&pass, &soup).mesh;
    let [before, after] = [&soup.mesh(), &cut].map(DefectCounts::of);
    assert_eq!(after.count(DefectKind::CoincidentVertex), 0);
    let (removes, requires, may_introduce) = (pass.removes(), pass.requires(), pass.may_introduce());
    assert_eq!(Promise { removes, requires, may_introduce }.law(&before, &after), Ok(()));
}
