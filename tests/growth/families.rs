//! Meshes on which careless code is quadratic.

use meshmend_core::{Carry, Domain, Layer, Metadata, PolygonMesh, Values};
use meshmend_io::{Format, Limits, ReadFile, ReadOptions, Shell, read_bytes};
use meshmend_testkit::Soup;
use meshmend_testkit::shapes::{
    Tiles, annulus, book, duplicate_chain, fan, foam, nested_pages, out_and_back, polygon, strip, umbrellas,
};

/// Meshes of one kind in any size.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Family {
    pub(crate) name: &'static str,
    make: Make,
}

/// What the meshes of a family come from.
#[derive(Clone, Copy, Debug)]
enum Make {
    Mesh(fn(usize) -> PolygonMesh),
    /// A PLY file, whose shape is kept beside the mesh.
    Ply(fn(usize) -> String),
}

impl Family {
    /// The mesh of about so many faces, or corners of one face, and what the file that it comes from has round it.
    pub(crate) fn mesh(&self, size: usize) -> (PolygonMesh, Shell) {
        match self.make {
            Make::Mesh(make) => (make(size), Shell::default()),
            Make::Ply(make) => {
                let file = read_any(make(size).as_bytes(), Format::Ply);
                (file.mesh, file.shell)
            }
        }
    }
}

/// Reads a file of any number of names and comments.
pub(crate) fn read_any(bytes: &[u8], format: Format) -> ReadFile {
    let limits = Limits::default().with_max_declarations(u64::MAX).with_max_comments(usize::MAX);
    let options = ReadOptions::default().with_format(format).with_limits(limits);
    read_bytes(bytes, "mesh", &options).expect("what was written can be read")
}

/// Every family.
pub(crate) const FAMILIES: &[Family] = &[
    Family { name: "book", make: Make::Mesh(|n| book(n).soup.mesh()) },
    Family { name: "nested pages", make: Make::Mesh(|n| nested_pages(n / 3).soup.mesh()) },
    Family { name: "fan", make: Make::Mesh(|n| fan(n).soup.mesh()) },
    Family { name: "umbrellas", make: Make::Mesh(|n| umbrellas(n / 4).soup.mesh()) },
    Family { name: "strip", make: Make::Mesh(|n| strip(n).soup.mesh()) },
    Family { name: "every face twice", make: Make::Mesh(|n| repeated(strip(n / 2).soup, 2).mesh()) },
    Family { name: "one face many times", make: Make::Mesh(|n| repeated(strip(1).soup, n).mesh()) },
    Family { name: "chain of duplicates", make: Make::Mesh(|n| duplicate_chain(n / 5).soup.mesh()) },
    Family { name: "huge face", make: Make::Mesh(|n| polygon(n).soup.mesh()) },
    Family { name: "comb", make: Make::Mesh(|n| comb(n).mesh()) },
    Family { name: "face that crosses itself", make: Make::Mesh(|n| one_face(scattered(n)).mesh()) },
    Family { name: "face that comes back", make: Make::Mesh(|n| flower(n).mesh()) },
    Family { name: "out and back", make: Make::Mesh(|n| out_and_back(n / 2).soup.mesh()) },
    Family { name: "huge holes", make: Make::Mesh(|n| annulus(n / 2, 1, Tiles::Triangles).soup.mesh()) },
    Family { name: "foam", make: Make::Mesh(|n| cubic_foam(n).mesh()) },
    Family { name: "shells apart", make: Make::Mesh(|n| shells(n / 4, apart).mesh()) },
    Family { name: "shells in a row", make: Make::Mesh(|n| shells(n / 4, in_a_row).mesh()) },
    Family { name: "shells one in the other", make: Make::Mesh(|n| shells(n / 4, nested).mesh()) },
    Family { name: "bubbles", make: Make::Mesh(|n| bubbles(n).mesh()) },
    Family { name: "triangles apart", make: Make::Mesh(|n| triangles_apart(n).mesh()) },
    Family { name: "stack", make: Make::Mesh(|n| stack(n).mesh()) },
    Family { name: "layers of vertices", make: Make::Mesh(|n| layered(n, Domain::Vertex)) },
    Family { name: "layers of faces", make: Make::Mesh(|n| layered(n, Domain::Face)) },
    Family { name: "names of faces", make: Make::Mesh(named_faces) },
    Family { name: "comments", make: Make::Mesh(commented) },
    Family { name: "properties of vertices", make: Make::Ply(|n| declared(n, "vertex")) },
    Family { name: "properties of faces", make: Make::Ply(|n| declared(n, "face")) },
    Family { name: "properties of rows", make: Make::Ply(|n| declared(n, "thing")) },
    Family { name: "elements", make: Make::Ply(elements) },
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

/// The header of a triangle, up to where more may be declared of an element.
const TRIANGLE: [(&str, &str); 3] = [
    ("vertex", "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"),
    ("face", "element face 1\nproperty list uchar int vertex_indices\n"),
    ("thing", "element thing 1\nproperty int first\n"),
];

/// A triangle with so many properties of one of its elements, each after a comment.
fn declared(count: usize, element: &str) -> String {
    let properties: String =
        (0..count).map(|at| format!("comment {at}\nproperty uchar quality{at}\n")).collect();
    let head = TRIANGLE.map(|(name, declaration)| {
        let more = if name == element { &properties[..] } else { "" };
        format!("{declaration}{more}")
    });
    let values = " 7".repeat(count);
    let of = |name: &str| if name == element { &values[..] } else { "" };
    let (vertex, face, thing) = (of("vertex"), of("face"), of("thing"));
    format!(
        "ply\nformat ascii 1.0\n{}end_header\n0 0 0{vertex}\n1 0 0{vertex}\n0 1 0{vertex}\n3 0 1 2{face}\n5{thing}\n",
        head.concat()
    )
}

/// A triangle and so many elements of unknown meaning, each after a comment.
fn elements(count: usize) -> String {
    let elements: String = (0..count)
        .map(|at| format!("comment {at}\nelement thing{at} 1\nproperty int face_index\n"))
        .collect();
    let head = TRIANGLE.map(|(_, declaration)| declaration).concat();
    let rows = "0\n".repeat(count);
    format!("ply\nformat ascii 1.0\n{head}{elements}end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n5\n{rows}")
}
