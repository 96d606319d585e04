//! What was done to a sound mesh is found, and nothing else, and is mended.

use std::collections::BTreeSet;

use meshmend_core::{Defect, DefectKind, Element, FaceId};
use meshmend_repair::Pipeline;
use meshmend_testkit::damage::{Damage, Unreal, Way};
use meshmend_testkit::shapes::{self, Tiles};
use meshmend_testkit::{Soup, Surgery, worlds};
use proptest::prelude::*;
use proptest::sample::{Index, select};
use serde_json::Value;

use crate::figures::{figures, report};
use crate::names::inside_out;

/// A defect by its kind and the ids that it names: faces, or vertices.
type Place = (DefectKind, Vec<u32>);

/// A sound closed surface to which something was done.
#[derive(Clone, Debug)]
struct Part {
    harmed: Soup,
    /// What a check must find.
    planted: BTreeSet<Place>,
    /// The mesh that a repair must come back to.
    mended: Soup,
    /// The faces that a repair must turn, and those that it must remove.
    flipped: BTreeSet<u32>,
    removed: BTreeSet<u32>,
}

/// Closed, consistently oriented, each two vertices in places of their own.
fn sound() -> impl Strategy<Value = Soup> {
    select(vec![
        shapes::icosahedron().soup,
        shapes::dodecahedron().soup,
        shapes::torus(5, 4, Tiles::Quads).soup,
        shapes::torus(6, 5, Tiles::Triangles).soup,
        shapes::torus(6, 5, Tiles::Quads).soup.with_handle(7),
    ])
}

/// A sound surface, and something done to it.
fn part() -> impl Strategy<Value = Part> {
    (sound(), 0..8u8, any::<[Index; 2]>(), proptest::collection::vec(any::<Index>(), 1..6)).prop_map(
        |(soup, kind, at, many)| {
            let face = at[0].index(soup.faces.len());
            let vertex = at[0].index(soup.vertex_count()) as u32;
            match kind {
                0 => flipped(soup, &many),
                1 => duplicated(soup, face, Way::Same),
                2 if soup.faces[face].len() == 3 => duplicated(soup, face, Way::Opposite),
                3 => pinched(soup, vertex, at[1]),
                4 => torn(soup, face, at[1]),
                5 => without_finite(soup, vertex),
                6 => with_noise(soup, many.len()),
                _ => welded_apart(soup),
            }
        },
    )
}

impl Part {
    /// What comes back to the mesh that it was.
    fn new(soup: Soup, damage: &Damage, planted: impl IntoIterator<Item = Place>) -> Self {
        Part {
            harmed: damage.apply(&soup),
            planted: planted.into_iter().collect(),
            mended: soup,
            flipped: BTreeSet::new(),
            removed: BTreeSet::new(),
        }
    }
}

fn sides(face: &[u32]) -> impl Iterator<Item = [u32; 2]> {
    (0..face.len()).map(|i| [face[i], face[(i + 1) % face.len()]]).map(|[a, b]| [a.min(b), a.max(b)])
}

/// A few faces, less than half of twelve: every edge between one of them and another face is inconsistent.
fn flipped(soup: Soup, many: &[Index]) -> Part {
    let faces: BTreeSet<u32> = many.iter().map(|face| face.index(soup.faces.len()) as u32).collect();
    let inside: Vec<[u32; 2]> = faces.iter().flat_map(|&f| sides(&soup.faces[f as usize])).collect();
    let is_rim = |ends: &&[u32; 2]| inside.iter().filter(|other| other == ends).count() == 1;
    let rim: Vec<Place> =
        inside.iter().filter(is_rim).map(|ends| (DefectKind::InconsistentEdge, ends.to_vec())).collect();
    let damage = Damage::Flip { faces: faces.iter().map(|&f| f as usize).collect() };
    Part { flipped: faces, ..Part::new(soup, &damage, rim) }
}

/// A copy at the end: its edges have three sides. An opposite copy is kept, and only of a triangle is it certain to stay a
/// wall of its own: larger faces in one place have the same angle but for rounding.
fn duplicated(soup: Soup, face: usize, way: Way) -> Part {
    let copy = soup.faces.len() as u32;
    let rim = soup.faces[face].clone();
    let kind = if way == Way::Same { DefectKind::DuplicateFace } else { DefectKind::OppositeFace };
    let edges = sides(&rim).map(|ends| (DefectKind::NonManifoldEdge, ends.to_vec()));
    let vertices = rim.iter().map(|&v| (DefectKind::SingularVertex, vec![v]));
    let planted: Vec<Place> =
        [(kind, vec![copy, face as u32])].into_iter().chain(edges).chain(vertices).collect();
    let part = Part::new(soup, &Damage::Duplicate { face, way }, planted);
    match way {
        Way::Same => Part { removed: [copy].into(), ..part },
        Way::Opposite => Part { mended: with_wall(&part.mended, &rim), ..part },
    }
}

/// A face apart from all others: where two faces run against each other, one of them takes the other's place.
fn with_wall(soup: &Soup, rim: &[u32]) -> Soup {
    let wall = Soup {
        positions: rim.iter().map(|&v| soup.positions[v as usize]).collect(),
        faces: vec![(0..rim.len() as u32).rev().collect()],
    };
    Soup::beside(&[soup.clone(), wall], 0.0)
}

/// Two vertices that have no neighbour in common become one.
fn pinched(soup: Soup, kept: u32, other: Index) -> Part {
    let neighbours = |v: u32| -> BTreeSet<u32> {
        soup.faces.iter().filter(|face| face.contains(&v)).flatten().copied().collect()
    };
    let near = neighbours(kept);
    let far: Vec<u32> =
        (0..soup.vertex_count() as u32).filter(|&v| neighbours(v).is_disjoint(&near)).collect();
    if far.is_empty() {
        return with_noise(soup, 1);
    }
    let lost = far[other.index(far.len())];
    let planted = [(DefectKind::PinchedVertex, vec![kept]), (DefectKind::UnreferencedVertex, vec![lost])];
    Part::new(soup, &Damage::Pinch { kept, lost }, planted)
}

/// One corner gets a vertex of its own: its two sides and those of its neighbours become boundary.
fn torn(soup: Soup, face: usize, at: Index) -> Part {
    let rim = soup.faces[face].clone();
    let (n, corner) = (rim.len(), at.index(rim.len()));
    let (here, new) = (rim[corner], soup.vertex_count() as u32);
    let beside = [rim[(corner + 1) % n], rim[(corner + n - 1) % n]];
    let edges = beside.into_iter().flat_map(|v| [[v.min(here), v.max(here)], [v, new]]);
    let planted: Vec<Place> = edges.map(|ends| (DefectKind::BoundaryEdge, ends.to_vec())).collect();
    Part::new(soup, &Damage::Tear { face, corner }, planted)
}

/// A vertex is nowhere: the faces round it go.
fn without_finite(soup: Soup, vertex: u32) -> Part {
    let is_there = |f: &usize| soup.faces[*f].contains(&vertex);
    let removed = (0..soup.faces.len()).filter(is_there).map(|f| f as u32).collect();
    let mut mended = soup.clone();
    mended.faces.retain(|face| !face.contains(&vertex));
    let damage = Damage::NonFinite { vertex, value: Unreal::Infinity };
    let part = Part::new(soup, &damage, [(DefectKind::NonFiniteVertex, vec![vertex])]);
    Part { mended, removed, ..part }
}

fn with_noise(soup: Soup, count: usize) -> Part {
    let base = soup.vertex_count() as u32;
    let planted = (base..base + count as u32).map(|v| (DefectKind::UnreferencedVertex, vec![v]));
    Part::new(soup, &Damage::Noise { count }, planted.collect::<Vec<_>>())
}

/// Every edge is boundary, once for each of its sides.
fn welded_apart(soup: Soup) -> Part {
    let harmed = Damage::WeldApart.apply(&soup);
    let edges = harmed.faces.iter().flat_map(|face| sides(face));
    let planted: Vec<Place> = edges.map(|ends| (DefectKind::BoundaryEdge, ends.to_vec())).collect();
    Part::new(soup, &Damage::WeldApart, planted)
}

/// What a defect names, for the kinds that are planted.
fn place(defect: &Defect) -> Place {
    let ids = match (&defect.at, &defect.beside) {
        (Element::Face(face), Some(Element::Face(original))) => vec![face.0, original.0],
        (Element::Edge { ends, .. }, None) => ends.map(|v| v.0).to_vec(),
        (Element::Vertex(vertex), None) => vec![vertex.0],
        _ => Vec::new(),
    };
    (defect.kind, ids)
}

/// The parts beside one another: each one's vertices and faces after those of the ones before.
fn beside(parts: &[Part]) -> Part {
    let join = |mesh: fn(&Part) -> &Soup| {
        Soup::beside(&parts.iter().map(|p| mesh(p).clone()).collect::<Vec<_>>(), 64.0)
    };
    let (mut vertices, mut faces) = (0, 0);
    let mut all =
        Part { harmed: join(|p| &p.harmed), mended: join(|p| &p.mended), ..part_without_anything() };
    for part in parts {
        let moved = |(kind, ids): &Place| {
            let names_faces = matches!(kind, DefectKind::DuplicateFace | DefectKind::OppositeFace);
            let by = if names_faces { faces } else { vertices };
            (*kind, ids.iter().map(|id| id + by).collect())
        };
        all.planted.extend(part.planted.iter().map(moved));
        all.flipped.extend(part.flipped.iter().map(|f| f + faces));
        all.removed.extend(part.removed.iter().map(|f| f + faces));
        vertices += part.harmed.vertex_count() as u32;
        faces += part.harmed.faces.len() as u32;
    }
    all
}

fn part_without_anything() -> Part {
    Part::new(Soup::default(), &Damage::Noise { count: 0 }, [])
}

/// Sound surfaces to which something was done, beside one another.
fn parts() -> impl Strategy<Value = Part> {
    proptest::collection::vec(part(), 1..5).prop_map(|parts| beside(&parts))
}

/// The figures that a repair must come back to.
fn expected(all: &Part) -> Value {
    let mut expected = figures(&all.mended);
    expected["unreferenced_vertices"] = 0.into();
    expected
}

fn ids(faces: impl IntoIterator<Item = FaceId>) -> BTreeSet<u32> {
    faces.into_iter().map(|face| face.0).collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn what_is_planted_is_found_and_mended(all in parts()) {
        let found: BTreeSet<Place> = report(&all.harmed).defects.iter().map(|defect| place(&defect)).collect();
        prop_assert_eq!(&found, &all.planted);
        let repaired = Pipeline::default().run(&all.harmed.mesh()).unwrap();
        prop_assert_eq!(figures(&Soup::of_mesh(&repaired.mesh)), expected(&all));
        let record = &repaired.provenance;
        prop_assert_eq!(ids(record.flipped.iter().filter_map(|&face| record.faces.of(face))), all.flipped);
        prop_assert_eq!(ids(repaired.removed_faces.iter().map(|removed| removed.face)), all.removed);
    }

    /// The same comes out whatever the vertices are called, in whatever order the faces are listed and wherever they
    /// begin, and from both sides.
    #[test]
    fn it_is_mended_under_any_name(
        (all, names, faces) in parts().prop_flat_map(|all| {
            let names = worlds::names(all.harmed.vertex_count());
            let faces = Just(all.harmed.faces.clone()).prop_shuffle();
            (Just(all), names, faces)
        }),
        by in 0..5usize,
        is_turned in any::<bool>(),
    ) {
        let mut soup = Soup { positions: all.harmed.positions.clone(), faces }.renamed(&names).rotated(by);
        if is_turned {
            soup = inside_out(&soup);
        }
        let repaired = Pipeline::default().run(&soup.mesh()).unwrap();
        prop_assert_eq!(figures(&Soup::of_mesh(&repaired.mesh)), expected(&all));
        prop_assert_eq!(repaired.removed_faces.len(), all.removed.len());
        prop_assert_eq!(repaired.provenance.flipped.len(), all.flipped.len());
    }
}
