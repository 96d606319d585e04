//! Meshes on which careless code is quadratic.

use meshmend_core::{Carry, Domain, Layer, Metadata, PolygonMesh, Values};
use meshmend_testkit::Soup;
use meshmend_testkit::shapes::{
    Tiles, annulus, book, duplicate_chain, fan, foam, nested_pages, out_and_back, polygon, strip, umbrellas,
};

/// Meshes of one kind in any size.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Family {
    pub(crate) name: &'static str,
    make: fn(usize) -> PolygonMesh,
}

impl Family {
    /// The mesh of about so many faces, or corners of one face.
    pub(crate) fn mesh(&self, size: usize) -> PolygonMesh {
        (self.make)(size)
    }
}

/// Every family.
pub(crate) const FAMILIES: &[Family] = &[
    Family { name: "book", make: |n| book(n).soup.mesh() },
    Family { name: "nested pages", make: |n| nested_pages(n / 3).soup.mesh() },
    Family { name: "fan", make: |n| fan(n).soup.mesh() },
    Family { name: "umbrellas", make: |n| umbrellas(n / 4).soup.mesh() },
    Family { name: "strip", make: |n| strip(n).soup.mesh() },
    Family { name: "every face twice", make: |n| repeated(strip(n / 2).soup, 2).mesh() },
    Family { name: "one face many times", make: |n| repeated(strip(1).soup, n).mesh() },
    Family { name: "chain of duplicates", make: |n| duplicate_chain(n / 5).soup.mesh() },
    Family { name: "huge face", make: |n| polygon(n).soup.mesh() },
    Family { name: "comb", make: |n| comb(n).mesh() },
    Family { name: "face that crosses itself", make: |n| one_face(scattered(n)).mesh() },
    Family { name: "face that comes back", make: |n| flower(n).mesh() },
    Family { name: "out and back", make: |n| out_and_back(n / 2).soup.mesh() },
    Family { name: "huge holes", make: |n| annulus(n / 2, 1, Tiles::Triangles).soup.mesh() },
    Family { name: "foam", make: |n| cubic_foam(n).mesh() },
    Family { name: "shells apart", make: |n| shells(n / 4, apart).mesh() },
    Family { name: "shells in a row", make: |n| shells(n / 4, in_a_row).mesh() },
    Family { name: "shells one in the other", make: |n| shells(n / 4, nested).mesh() },
    Family { name: "bubbles", make: |n| bubbles(n).mesh() },
    Family { name: "triangles apart", make: |n| triangles_apart(n).mesh() },
    Family { name: "stack", make: |n| stack(n).mesh() },
    Family { name: "layers of vertices", make: |n| layered(n, Domain::Vertex) },
    Family { name: "layers of faces", make: |n| layered(n, Domain::Face) },
    Family { name: "names of faces", make: named_faces },
    Family { name: "comments", make: commented },
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

/// Tetrahedra of a size and at a place each.
fn shells(count: usize, place: fn(usize, usize) -> (f64, [f64; 3])) -> Soup {
    let tetrahedron = |at: usize| {
        let (size, corner) = place(at, count);
        let mut positions = vec![corner; 4];
        (0..3).for_each(|axis| positions[axis + 1][axis] += size);
        Soup { positions, faces: [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]].map(Vec::from).to_vec() }
    };
    Soup::beside(&(0..count).map(tetrahedron).collect::<Vec<_>>(), 0.0)
}

/// On a grid.
fn apart(at: usize, count: usize) -> (f64, [f64; 3]) {
    let side = (count as f64).cbrt().ceil() as usize;
    (1.0, [at % side, at / side % side, at / side / side].map(|place| 2.0 * place as f64))
}

fn in_a_row(at: usize, _: usize) -> (f64, [f64; 3]) {
    (1.0, [2.0 * at as f64, 0.0, 0.0])
}

/// The smallest first.
fn nested(at: usize, _: usize) -> (f64, [f64; 3]) {
    let size = (at + 1) as f64;
    (size, [-size / 5.0; 3])
}

/// A sphere of about half of the faces, and small tetrahedra in it.
fn bubbles(faces: usize) -> Soup {
    let around = ((faces / 4) as f64).sqrt().ceil() as usize;
    let turn = |part: usize, parts: usize| std::f64::consts::TAU * part as f64 / parts as f64;
    let point = |ring: usize, place: usize| {
        let (down, round) = (turn(ring, 2 * around), turn(place, around));
        [down.sin() * round.cos(), down.sin() * round.sin(), down.cos()]
    };
    let mut positions = vec![[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]];
    positions.extend(
        (1..around).flat_map(|ring| (0..around).map(move |place| (ring, place))).map(|(r, p)| point(r, p)),
    );
    let at = |ring: usize, place: usize| match ring {
        0 => 0,
        ring if ring == around => 1,
        ring => (2 + (ring - 1) * around + place % around) as u32,
    };
    let mut sphere = Soup { positions, faces: Vec::new() };
    for (ring, place) in (0..around).flat_map(|ring| (0..around).map(move |place| (ring, place))) {
        let [a, b, c, d] =
            [at(ring, place), at(ring + 1, place), at(ring + 1, place + 1), at(ring, place + 1)];
        let face = if ring == 0 {
            vec![a, b, c]
        } else if ring + 1 == around {
            vec![a, b, d]
        } else {
            vec![a, b, c, d]
        };
        sphere.faces.push(face);
    }
    let inside = |at: usize, count: usize| {
        let side = (count as f64).cbrt().ceil();
        let (_, place) = apart(at, count);
        (0.2 / side, place.map(|x| 0.5 * x / side - 0.5))
    };
    Soup::beside(&[sphere, shells(faces / 8, inside)], 0.0)
}

/// Each with a hole of its own.
fn triangles_apart(count: usize) -> Soup {
    let triangle = |at: usize| {
        let (_, [x, y, z]) = apart(at, count);
        [[x, y, z], [x + 1.0, y, z], [x, y + 1.0, z]]
    };
    let faces = (0..count as u32).map(|at| vec![3 * at, 3 * at + 1, 3 * at + 2]).collect();
    Soup { positions: (0..count).flat_map(triangle).collect(), faces }
}

/// Squares one over the other.
fn stack(count: usize) -> Soup {
    let square = |at: usize| {
        let height = at as f64 / count as f64;
        [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|[x, y]| [x, y, height])
    };
    let faces = (0..count as u32).map(|at| (4 * at..4 * at + 4).collect()).collect();
    Soup { positions: (0..count).flat_map(square).collect(), faces }
}

/// One triangle with so many layers of numbers.
fn layered(count: usize, domain: Domain) -> PolygonMesh {
    let elements = if domain == Domain::Vertex { 3 } else { 1 };
    let layer = |at: usize| {
        Layer::direct(format!("layer{at}"), domain, 1, Carry::Copy, Values::U8(vec![at as u8; elements]))
    };
    strip(1).soup.mesh().with_layers((0..count).map(layer).collect()).expect("layers of the mesh")
}

/// Triangles with an object, a group and a material of its own each.
fn named_faces(count: usize) -> PolygonMesh {
    let names = |what: &str| Values::Text((0..count).map(|at| format!("{what}{at}").into_bytes()).collect());
    let layer = |what: &str| Layer::direct(what.to_owned(), Domain::Face, 1, Carry::Copy, names(what));
    let layers = ["object", "group", "material"].map(layer).to_vec();
    strip(count).soup.mesh().with_layers(layers).expect("layers of the mesh")
}

fn commented(count: usize) -> PolygonMesh {
    let comment =
        |at: usize| Metadata { key: "comment".to_owned(), value: format!("comment {at}").into_bytes() };
    strip(count).soup.mesh().with_metadata((0..count).map(comment).collect())
}
