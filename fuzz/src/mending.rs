//! Healing and filling never make a mesh worse where positions tell.

use arbitrary::{Arbitrary, Unstructured};
use meshmend_core::{EdgeTable, PolygonMesh, Watch};
use meshmend_repair::{Context, Fill, Heal, HealWithin, Outcome, Pass, TJunctionFate};
use meshmend_spatial::{Contact, IntersectionOptions, Surface, intersections, t_junctions};

use crate::input::SmallMesh;

/// A small mesh, healed and then filled: what was whole stays whole, and no two faces cross that did not before.
pub fn mending(data: &[u8]) {
    let mut bytes = Unstructured::new(data);
    let Ok(SmallMesh(soup)) = SmallMesh::arbitrary(&mut bytes) else { return };
    let mesh = soup.mesh();
    let healed = applied(&Heal { within: HealWithin::Exact }, &mesh);
    assert_healed(&mesh, &healed);
    let filled = applied(&Fill::default(), &healed.mesh);
    assert_filled(&healed.mesh, &filled);
}

fn applied(pass: &impl Pass, mesh: &PolygonMesh) -> Outcome {
    pass.apply(mesh, &Context::default()).expect("these passes take any mesh")
}

fn assert_healed(before: &PolygonMesh, healed: &Outcome) {
    let after = &healed.mesh;
    assert_eq!(before.positions().len(), after.positions().len(), "no vertex is created");
    assert_eq!(before.counts().faces, after.counts().faces, "no face is added or removed");
    let [old, new] = [before, after].map(|mesh| mesh.complex().edges());
    assert!(most_sides(new) <= most_sides(old).max(2), "no edge gets a third side");
    assert!(
        open_edges(new) <= open_edges(old) + healed.fixed.len(),
        "what is put in closes on one side of it"
    );
    let left = |record: &&meshmend_repair::TJunctionRecord| matches!(record.fate, TJunctionFate::Left { .. });
    let named: Vec<_> =
        healed.t_junctions.iter().filter(left).map(|record| (record.vertex, record.ends)).collect();
    for found in t_junctions(after, 0.0, &Watch::NOBODY).expect("nobody stops it") {
        assert!(named.contains(&(found.vertex, found.ends)), "{found:?} is left without a word: {named:?}");
    }
}

fn assert_filled(before: &PolygonMesh, filled: &Outcome) {
    let after = &filled.mesh;
    let [old, new] = [before, after].map(|mesh| mesh.complex().edges());
    assert!(open_edges(new) <= open_edges(old), "no edge is opened");
    assert!(most_sides(new) <= most_sides(old).max(2), "no edge gets a third side");
    // The faces that were there are the first ones, so the pairs have the same names.
    assert_eq!(crossings(before), crossings(after), "a fill crosses nothing");
}

fn open_edges(edges: &EdgeTable) -> usize {
    edges.edges().filter(|&edge| edges.edge_sides(edge).len() == 1).count()
}

fn most_sides(edges: &EdgeTable) -> usize {
    edges.edges().map(|edge| edges.edge_sides(edge).len()).max().unwrap_or(0)
}

/// The pairs of faces that cross.
fn crossings(mesh: &PolygonMesh) -> Vec<[u32; 2]> {
    let surface = Surface::of(mesh).expect("a small mesh has a surface");
    let found = intersections(&surface, IntersectionOptions::default()).expect("nobody stops it").pairs;
    let crossing = found.iter().filter(|pair| pair.contact == Contact::FaceFace);
    crossing.map(|pair| pair.faces.map(|face| face.0)).collect()
}
