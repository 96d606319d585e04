//! Triangles that meet in every way.

use meshmend_geometry::vector::{Point, place_bits};

use super::{Contact, Pair, shown_point};

type Triangle = [Point; 3];

const FLAT: Triangle = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];

fn contact(f: Triangle, g: Triangle) -> Option<(Contact, bool)> {
    let points = [&f, &g];
    let pair = Pair::named(points, points.map(|triangle| triangle.map(place_bits)));
    let meeting = pair.meeting()?;
    if pair.is_coincident() {
        return Some((Contact::Coincident, true));
    }
    if pair.is_proper(meeting.cells) {
        return None;
    }
    Contact::of_cells(meeting.cells).map(|contact| (contact, meeting.is_coplanar))
}

/// The contact, which is the same for every order of the triangles and of their corners.
fn contact_by_all_names(f: Triangle, g: Triangle) -> Option<(Contact, bool)> {
    let expected = contact(f, g);
    let orders = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]];
    for one in orders.map(|order| order.map(|at: usize| f[at])) {
        for other in orders.map(|order| order.map(|at: usize| g[at])) {
            assert_eq!(contact(one, other), expected, "{one:?} {other:?}");
            assert_eq!(contact(other, one), expected, "{other:?} {one:?}");
        }
    }
    expected
}

#[test]
fn triangles_in_two_planes() {
    use Contact::*;
    let cases: [(Triangle, Option<Contact>); 12] = [
        ([[1.0, 1.0, -1.0], [1.0, 1.0, 1.0], [9.0, 9.0, 1.0]], Some(FaceFace)),
        ([[1.0, 1.0, 0.0], [1.0, 1.0, 1.0], [2.0, 1.0, 1.0]], Some(VertexFace)),
        ([[2.0, 0.0, 0.0], [1.0, 1.0, 1.0], [2.0, 1.0, 1.0]], Some(VertexEdge)),
        ([[1.0, 1.0, 0.0], [1.0, 2.0, 0.0], [1.0, 1.0, 1.0]], Some(EdgeFace)),
        ([[1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [1.0, 0.0, 1.0]], Some(EdgeEdge)),
        ([[1.0, 0.0, -1.0], [1.0, 0.0, 1.0], [1.0, -3.0, 0.0]], Some(EdgeEdge)),
        ([[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [1.0, 1.0, 1.0]], Some(EdgeFace)),
        ([[0.0, 0.0, 0.0], [1.0, 1.0, -1.0], [1.0, 1.0, 1.0]], Some(FaceFace)),
        ([[0.0, 0.0, 0.0], [1.0, 1.0, 2.0], [1.0, 1.0, 1.0]], None),
        ([[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [1.0, 1.0, 1.0]], None),
        ([[0.0, 0.0, 0.0], [8.0, 0.0, 0.0], [1.0, 1.0, 1.0]], Some(EdgeEdge)),
        ([[0.0, 0.0, 1.0], [8.0, 0.0, 1.0], [1.0, 1.0, 1.0]], None),
    ];
    for (other, expected) in cases {
        let expected = expected.map(|contact| (contact, false));
        assert_eq!(contact_by_all_names(FLAT, other), expected, "{other:?}");
    }
}

#[test]
fn triangles_in_one_plane() {
    use Contact::*;
    let at = |x: f64, y: f64| [x, y, 0.0];
    let cases: [(Triangle, Option<Contact>); 9] = [
        ([at(1.0, 1.0), at(5.0, 1.0), at(5.0, 5.0)], Some(FaceFace)),
        ([at(1.0, 1.0), at(2.0, 1.0), at(1.0, 2.0)], Some(FaceFace)),
        (FLAT, Some(Coincident)),
        ([at(0.0, 0.0), at(4.0, 0.0), at(1.0, 9.0)], Some(FaceFace)),
        ([at(0.0, 0.0), at(4.0, 0.0), at(1.0, -9.0)], None),
        ([at(0.0, 0.0), at(5.0, 0.0), at(1.0, -9.0)], Some(EdgeEdge)),
        ([at(1.0, 0.0), at(2.0, -1.0), at(1.0, -9.0)], Some(VertexEdge)),
        ([at(4.0, 0.0), at(6.0, -1.0), at(5.0, 9.0)], None),
        ([at(5.0, 0.0), at(6.0, -1.0), at(5.0, 9.0)], None),
    ];
    for (other, expected) in cases {
        let expected = expected.map(|contact| (contact, true));
        assert_eq!(contact_by_all_names(FLAT, other), expected, "{other:?}");
    }
}

#[test]
fn a_common_point_is_shown_at_any_scale() {
    let through = [[1.0, 1.0, -1.0], [1.0, 1.0, 1.0], [9.0, 9.0, 1.0]];
    let beside = [[1.0, 1.0, 0.0], [3.0, 1.0, 0.0], [1.0, 3.0, 0.0]];
    for scale in [1.0, 2.0_f64.powi(-1060), 2.0_f64.powi(1019)] {
        let [flat, through, beside] =
            [FLAT, through, beside].map(|triangle| triangle.map(|corner| corner.map(|x| x * scale)));
        assert_eq!(shown_point([flat, through], false), [1.5, 1.5, 0.0].map(|x| x * scale));
        assert_eq!(shown_point([through, flat], false), [1.5, 1.5, 0.0].map(|x| x * scale));
        let [x, y, z] = shown_point([flat, beside], true).map(|x| x / scale);
        assert!((x - 5.0 / 3.0).abs() < 1e-4 && (y - 5.0 / 3.0).abs() < 1e-4 && z == 0.0, "{x} {y} {z}");
    }
}
