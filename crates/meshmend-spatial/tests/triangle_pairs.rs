//! Pairs of triangles of small whole coordinates, with the answers of the executable specification.

#![allow(clippy::unwrap_used, reason = "a case that does not fit is a failed test")]

use meshmend_core::PolygonMesh;
use meshmend_spatial::{Contact, IntersectionOptions, Surface, intersections};

const PAIRS: &str = include_str!("data/triangle_pairs.txt");

/// Two triangles, and how they meet: the contact's name, and whether in one plane; `None` if they are apart or meet properly.
struct Row {
    corners: Vec<[f64; 3]>,
    meeting: Option<(&'static str, bool)>,
}

fn rows() -> impl Iterator<Item = Row> {
    PAIRS.lines().filter(|line| !line.starts_with('#')).map(|line| {
        let words: Vec<&str> = line.split(' ').collect();
        let corner = |word: &&str| {
            let digits: Vec<f64> = word.bytes().map(|digit| f64::from(digit - b'0')).collect();
            [digits[0], digits[1], digits[2]]
        };
        let is_flat = words.get(7).is_some_and(|&word| word == "flat");
        let meeting = Some((words[6], is_flat)).filter(|&(name, _)| name != "apart" && name != "proper");
        Row { corners: words[..6].iter().map(corner).collect(), meeting }
    })
}

/// How two triangles meet, each corner with a vertex of its own.
fn meeting(corners: &[[f64; 3]], faces: [[u32; 3]; 2]) -> Option<(&'static str, bool)> {
    let mesh = PolygonMesh::from_triangles(corners, &faces).unwrap();
    let surface = Surface::of(&mesh).unwrap();
    let found = intersections(&surface, IntersectionOptions::default()).unwrap();
    let contacts: Vec<Option<Contact>> = found.contacts.values().to_vec();
    assert!(contacts.iter().all(|&contact| contact == found.pairs.first().map(|pair| pair.contact)));
    found.pairs.first().map(|pair| (pair.contact.name(), pair.is_coplanar))
}

#[test]
fn pairs_meet_as_the_specification_says_at_any_scale_and_by_any_names() {
    let orders = [[[0, 1, 2], [3, 4, 5]], [[4, 5, 3], [0, 2, 1]], [[2, 0, 1], [5, 4, 3]]];
    let mut count = 0;
    for Row { corners, meeting: expected } in rows() {
        for scale in [1.0, 5e-324, 2.0_f64.powi(-600), 2.0_f64.powi(600), 2.0_f64.powi(1020)] {
            let corners: Vec<[f64; 3]> =
                corners.iter().map(|corner| corner.map(|x| (x - 4.0) * scale)).collect();
            for faces in orders {
                assert_eq!(meeting(&corners, faces), expected, "{corners:?} {faces:?}");
            }
        }
        count += 1;
    }
    assert!(count > 200);
}
