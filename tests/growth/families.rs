//! Meshes on which careless code is quadratic.

use meshmend_core::PolygonMesh;
use meshmend_testkit::Soup;
use meshmend_testkit::shapes::{
    Tiles, annulus, book, duplicate_chain, fan, foam, nested_pages, out_and_back, polygon, strip, umbrellas,
};

/// Meshes of one kind in any size.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Family {
    pub(crate) name: &'static str,
    make: fn(usize) -> Soup,
}

impl Family {
    /// The mesh of about so many faces, or corners of one face.
    pub(crate) fn mesh(&self, size: usize) -> PolygonMesh {
        (self.make)(size).mesh()
    }
}

/// Every family.
pub(crate) const FAMILIES: &[Family] = &[
    Family { name: "book", make: |n| book(n).soup },
    Family { name: "nested pages", make: |n| nested_pages(n / 3).soup },
    Family { name: "fan", make: |n| fan(n).soup },
    Family { name: "umbrellas", make: |n| umbrellas(n / 4).soup },
    Family { name: "strip", make: |n| strip(n).soup },
    Family { name: "every face twice", make: |n| repeated(strip(n / 2).soup, 2) },
    Family { name: "one face many times", make: |n| repeated(strip(1).soup, n) },
    Family { name: "chain of duplicates", make: |n| duplicate_chain(n / 5).soup },
    Family { name: "huge face", make: |n| polygon(n).soup },
    Family { name: "comb", make: comb },
    Family { name: "face that crosses itself", make: |n| one_face(scattered(n)) },
    Family { name: "face that comes back", make: flower },
    Family { name: "out and back", make: |n| out_and_back(n / 2).soup },
    Family { name: "huge holes", make: |n| annulus(n / 2, 1, Tiles::Triangles).soup },
    Family { name: "foam", make: |n| cubic_foam(n) },
];

fn repeated(soup: Soup, times: usize) -> Soup {
    let faces = soup.faces.iter().flat_map(|face| std::iter::repeat_n(face.clone(), times)).collect();
    Soup { faces, ..soup }
}

fn one_face(positions: Vec<[f64; 3]>) -> Soup {
    Soup { faces: vec![(0..positions.len() as u32).collect()], positions }
}

/// One face with long thin teeth.
fn comb(corners: usize) -> Soup {
    let teeth = corners / 2;
    let tooth = |i: usize| [[i as f64, 0.0, 0.0], [i as f64 + 0.5, corners as f64, 0.0]];
    let back = [[teeth as f64, -1.0, 0.0], [0.0, -1.0, 0.0]];
    one_face((0..teeth).flat_map(tooth).chain(back).collect())
}

/// Points of a plane in no order.
fn scattered(count: usize) -> Vec<[f64; 3]> {
    let part = |i: usize, root: f64| (i as f64 * root).fract();
    (1..=count).map(|i| [part(i, 2.0f64.sqrt()), part(i, 3.0f64.sqrt()), 0.0]).collect()
}

/// One face that comes back to its first vertex after every two others.
fn flower(corners: usize) -> Soup {
    let petals = corners as u32 / 3;
    let face = (0..petals).flat_map(|petal| [0, 2 * petal + 1, 2 * petal + 2]).collect();
    Soup { positions: scattered(2 * petals as usize + 1), faces: vec![face] }
}

/// A block of as many cells each way as makes about so many walls.
fn cubic_foam(walls: usize) -> Soup {
    let cells = (walls as f64 / 3.0).cbrt().round() as usize;
    foam(cells, cells, cells).soup
}
