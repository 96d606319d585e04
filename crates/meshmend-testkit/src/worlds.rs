//! Proptest strategies for meshes of any kind, and every small mesh there is.

pub use meshmend_conformance::worlds::{oriented_triangle_sets, triangle_sets};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::subsequence;

use crate::Soup;
use crate::damage::{Damage, Unreal, Way};
use crate::shapes::{Shape, Tiles, catalogue, klein_bottle, torus};

/// Tables of any shape: up to `faces` faces of 0 to 8 corners over up to 9 vertices, corners repeated at will, some
/// vertices unreferenced; positions on a small grid, so that many coincide, and now and then not finite.
pub fn any_table(faces: usize) -> impl Strategy<Value = Soup> {
    (1..10usize).prop_flat_map(move |vertices| {
        let face = prop_oneof![
            3 => distinct_corners(vertices, 3..=4),
            1 => vec(0..vertices as u32, 0..=8),
        ];
        (grid_positions(vertices), vec(face, 0..=faces))
            .prop_map(|(positions, faces)| Soup { positions, faces })
    })
}

/// Triangles with three different corners, over few vertices on a small grid.
pub fn triangle_soup(faces: usize) -> impl Strategy<Value = Soup> {
    (3..10usize).prop_flat_map(move |vertices| {
        (finite_positions(vertices), vec(distinct_corners(vertices, 3..=3), 1..=faces))
            .prop_map(|(positions, faces)| Soup { positions, faces })
    })
}

/// As [`any_table`], over vertices in general position: what is wrong is wrong by index alone.
pub fn generic_table(faces: usize) -> impl Strategy<Value = Soup> {
    any_table(faces).prop_map(|soup| Soup::generic(soup.vertex_count(), soup.faces))
}

/// Points of a grid of one to four points a side, one in fifty with a coordinate that is not finite, and now and
/// then −0 for 0.
pub fn grid_positions(count: usize) -> impl Strategy<Value = Vec<[f64; 3]>> {
    (0..4u32).prop_flat_map(move |side| {
        let number = prop_oneof![
            145 => (0..=side).prop_map(f64::from),
            2 => Just(-0.0),
            1 => unreal().prop_map(Unreal::value),
        ];
        vec([number.clone(), number.clone(), number], count)
    })
}

/// Points of a grid of two to four points a side.
pub fn finite_positions(count: usize) -> impl Strategy<Value = Vec<[f64; 3]>> {
    (1..4u32).prop_flat_map(move |side| {
        let number = (0..=side).prop_map(f64::from);
        vec([number.clone(), number.clone(), number], count)
    })
}

/// A shape of the catalogue.
pub fn any_shape() -> impl Strategy<Value = Shape> {
    let shapes = catalogue();
    (0..shapes.len()).prop_map(move |i| shapes[i].clone())
}

/// A shape, up to four kinds of harm, and the mesh after all of them.
pub fn damaged_shape() -> impl Strategy<Value = (Shape, Vec<Damage>, Soup)> {
    (
        any_shape(),
        vec(any::<[prop::sample::Index; 3]>().prop_flat_map(|at| (Just(at), 0..8u8, unreal())), 0..=4),
    )
        .prop_map(|(shape, seeds)| {
            let (mut harms, mut soup) = (Vec::new(), shape.soup.clone());
            for (at, kind, value) in seeds {
                let harm = harm_to(&soup, at, kind, value);
                soup = harm.apply(&soup);
                harms.push(harm);
            }
            (shape, harms, soup)
        })
}

/// A torus or a Klein bottle of quads with pieces taken out, some turned over on request, and begun at any corner; so
/// that strict structures see more than tidy meshes.
pub fn damaged_grid() -> impl Strategy<Value = Soup> {
    let damage = vec((any::<bool>(), proptest::bool::weighted(0.85), 0usize..4), 30);
    (3..6usize, 3..6usize, any::<bool>(), any::<bool>(), damage).prop_map(
        |(columns, rows, is_mirrored, is_turned, damage)| {
            let glued = if is_mirrored { klein_bottle } else { torus };
            let mut soup = glued(columns, rows, Tiles::Quads).soup;
            for (face, &(turn, _, rotation)) in soup.faces.iter_mut().zip(&damage) {
                if turn && is_turned {
                    face.reverse();
                }
                face.rotate_left(rotation);
            }
            let mut kept = damage.iter().map(|(_, is_kept, _)| *is_kept);
            soup.faces.retain(|_| kept.next() == Some(true));
            soup
        },
    )
}

/// One or two faces with many corners on few vertices, in general position.
pub fn self_touching() -> impl Strategy<Value = Soup> {
    vec(vec(0u32..6, 3..7), 1..3).prop_map(|faces| Soup::generic(6, faces))
}

/// A permutation of the vertices of a mesh, for [`Soup::renamed`].
pub fn names(vertex_count: usize) -> impl Strategy<Value = Vec<u32>> {
    Just((0..vertex_count as u32).collect::<Vec<_>>()).prop_shuffle()
}

fn distinct_corners(
    vertices: usize,
    sizes: std::ops::RangeInclusive<usize>,
) -> impl Strategy<Value = Vec<u32>> + Clone {
    let (low, high) = ((*sizes.start()).min(vertices), (*sizes.end()).min(vertices));
    subsequence((0..vertices as u32).collect::<Vec<_>>(), low..=high).prop_shuffle()
}

fn unreal() -> impl Strategy<Value = Unreal> + Clone {
    prop_oneof![Just(Unreal::Nan), Just(Unreal::Infinity), Just(Unreal::MinusInfinity)]
}

/// A kind of harm at places chosen among those that the mesh has.
fn harm_to(soup: &Soup, at: [prop::sample::Index; 3], kind: u8, value: Unreal) -> Damage {
    let [face, second] = [0, 1].map(|i| at[i].index(soup.faces.len()));
    let vertex = |i: usize| at[i].index(soup.vertex_count()) as u32;
    match kind {
        0 => Damage::Flip { faces: vec![face, second] },
        1 => Damage::Duplicate { face, way: Way::Same },
        2 => Damage::Duplicate { face, way: Way::Opposite },
        3 => Damage::Pinch { kept: vertex(0), lost: vertex(1) },
        4 if !soup.faces[face].is_empty() => {
            Damage::Tear { face, corner: at[2].index(soup.faces[face].len()) }
        }
        5 => Damage::Crack { faces: (face.min(second)..=face.max(second)).collect() },
        6 => Damage::WeldApart,
        7 => Damage::NonFinite { vertex: vertex(0), value },
        _ => Damage::Noise { count: 1 + at[2].index(3) },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    proptest! {
        #[test]
        fn every_world_is_a_mesh(table in any_table(12), soup in triangle_soup(12), harmed in damaged_shape()) {
            prop_assert_eq!(table.mesh().counts().faces, table.faces.len());
            prop_assert!(soup.table().is_all_triangles());
            prop_assert!(soup.positions.iter().flatten().all(|x| x.is_finite()));
            prop_assert_eq!(harmed.2.mesh().counts().vertices, harmed.2.vertex_count());
        }
    }
}
