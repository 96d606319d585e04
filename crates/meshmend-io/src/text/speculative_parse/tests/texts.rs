//! Random texts of each format.

use std::fmt::Write;

use super::alone::{Oddity, assert_all_as_alone};
use super::random::Random;
use crate::Format;

/// Statements that the reader has to read by itself.
const RARE: [&str; 24] = [
    "# a comment",
    "g name",
    "usemtl steel",
    "o",
    "s off",
    "f -1 -2 -3",
    "f 1 2",
    "f",
    "l 1 2",
    "p 1",
    "unknown 1 2",
    "v 0 0 0 1 1 1",
    "v 1 1 1 2",
    "v 0 0 0 1 1 1 1 1",
    "v nan 0 -inf",
    "f 1 2 3 # triangle",
    "v 1 2 \\",
    "f 1/1 2/2 3",
    "g x \\",
    "\\",
    "vt 1 2 3 4",
    "vt 1",
    "v 0 0 0 1 1 1 0.5",
    "mtllib x.mtl",
];

/// Statements that are wrong, or may be.
const WRONG: [&str; 12] = [
    "v 0 0-1",
    "f 1 2+3",
    "v 1 2",
    "v 1 2 x",
    "f 0 1 2",
    "f 1 2 a",
    "f 1 2 99",
    "f -99 1 2",
    "f 1/2/3/4 1 2",
    "vn 1 2",
    "f 1 2 5000000000",
    "f 4294967295 1 2",
];

fn obj(random: &mut Random, lines: usize, oddity: Oddity) -> String {
    let mut forms = ["", "/1", "//1", "/2/1"][random.below(4)];
    let mut all = vec!["v 0 0 0".to_owned(), "v 1 0 0".to_owned(), "v 0 1 0".to_owned()];
    let mut vertices = 3;
    let colored = [3, 3, 6, 7][random.below(4)];
    for line in 0..lines {
        let before = random.of(&["", "", "", " ", "\t"]);
        let after = random.of(&["", "", "", " ", "\t "]);
        if random.one_in(10) {
            forms = random.of(&["", "/1", "//1", "/2/1", "//9", "/7"]);
        }
        let usual = if line % 3 == 0 {
            vertices += 1;
            let count = [3, colored][random.below(2)];
            format!("v {}", random.numbers(count))
        } else if random.one_in(5) {
            let count = [2, 2, 2, 3][random.below(4)];
            if random.one_in(2) {
                format!("vt {}", random.numbers(count))
            } else {
                format!("vn {}", random.numbers(3))
            }
        } else {
            let degree = [3, 3, 3, 3, 4, 5][random.below(6)];
            (0..degree).fold("f".to_owned(), |mut face, _| {
                write!(face, " {}{forms}", 1 + random.below(vertices)).unwrap();
                face
            })
        };
        all.push(format!("{before}{usual}{after}"));
        if random.one_in(oddity.rare) {
            all.push(random.of(&RARE).to_owned());
        }
        if random.one_in(oddity.wrong) {
            all.push(random.of(&WRONG).to_owned());
        }
    }
    random.joined(&all)
}

#[test]
fn obj_is_read_as_by_its_reader_alone() {
    assert_all_as_alone(Format::Obj, obj);
}

fn off(random: &mut Random, lines: usize, oddity: Oddity) -> String {
    const RARE_FACES: [&str; 8] = [
        "2 0 1",
        "1 2",
        "0",
        "3 0 1 2 255 0 0",
        "3 0 1 2 0.5 0.5 1.0",
        "3 +0 01 2",
        "3 0 1 2 # a face",
        "4 0 1 2 0",
    ];
    const WRONG: [&str; 11] = [
        "3 0 1",
        "0 0-1",
        "3 0 1+2",
        "3 0 1 99",
        "3 0 1 2 99",
        "3 0 1 -1",
        "x",
        "3 0 1 x",
        "1 2",
        "900000000 1 2",
        "3 0 1 4294967296",
    ];
    let (vertices, faces) = (3 + lines / 2, lines);
    let announced = [vertices, faces]
        .map(|count| if random.one_in(8) { (count + random.below(5)).saturating_sub(2) } else { count });
    let head = if oddity.rare > 0 { random.of(&["OFF", "COFF", "NOFF", "STOFF"]) } else { "OFF" };
    let beside = match head {
        "COFF" => 4,
        "NOFF" => 3,
        "STOFF" => 2,
        _ => 0,
    };
    let mut all = vec![format!("{head}\n{} {} 0", announced[0], announced[1])];
    for line in 0..vertices + faces {
        if random.one_in(oddity.rare) {
            all.push(random.of(&["# a comment", "", " ", "#"]).to_owned());
        }
        if random.one_in(oddity.wrong) {
            all.push(random.of(&WRONG).to_owned());
        } else if line < vertices {
            let surplus = if random.one_in(oddity.rare) { " 1 2" } else { "" };
            all.push(format!("{}{surplus}", random.numbers(3 + beside)));
        } else if random.one_in(oddity.rare) {
            all.push(random.of(&RARE_FACES).to_owned());
        } else {
            let corners: Vec<String> = (0..3).map(|_| random.below(vertices).to_string()).collect();
            all.push(format!("3 {}{}", corners.join(" "), random.of(&["", "", " "])));
        }
    }
    all.push(random.of(&["", "", "3 0 1 99 2"]).to_owned());
    random.joined(&all)
}

#[test]
fn off_is_read_as_by_its_reader_alone() {
    assert_all_as_alone(Format::Off, off);
}

fn stl(random: &mut Random, lines: usize, oddity: Oddity) -> String {
    const RARE: [&str; 8] = [
        "endsolid a\nsolid b",
        "endsolid\nsolid",
        "",
        "FACET NORMAL 0 0 1 OUTER LOOP VERTEX 0 0 0",
        "endsolid facet\nsolid",
        "facet normal 0 0 1\nouter loop\nvertex 0 0 0 vertex 1 0 0\nvertex 0 1 0\nvertex 1 1 0\nendloop endfacet",
        "facet outer loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 nan 0\nendloop\nendfacet",
        "facet normal 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 inf 0\nendloop\nendfacet",
    ];
    const WRONG: [&str; 7] = [
        "facet normal 0 0 1 2\nouter loop",
        "vertex 0 0 0",
        "facet",
        "solid x",
        "endfacet",
        "endsolid",
        "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0 1 1\nendloop\nendfacet",
    ];
    let mut all = vec![format!("solid{}", random.of(&["", " name", " a facet"]))];
    let indent = random.of(&["", "  "]);
    for _ in 0..lines {
        if random.one_in(oddity.rare) {
            all.push(random.of(&RARE).to_owned());
        }
        if random.one_in(oddity.wrong) {
            all.push(random.of(&WRONG).to_owned());
        }
        let normal = if random.one_in(20) { "outer 0 0".to_owned() } else { random.numbers(3) };
        all.push(format!("{indent}facet normal {normal}"));
        all.push(format!("{indent}outer loop"));
        all.extend((0..3).map(|_| format!("{indent}vertex {}", random.numbers(3))));
        all.push(format!("{indent}endloop"));
        all.push(format!("{indent}endfacet"));
    }
    if !random.one_in(6) {
        all.push("endsolid".to_owned());
    }
    random.joined(&all)
}

#[test]
fn stl_is_read_as_by_its_reader_alone() {
    assert_all_as_alone(Format::Stl, stl);
}

/// A number of a type as it is usually written, or not so usually.
fn ply_number(random: &mut Random, scalar: &str, oddity: Oddity) -> String {
    match scalar {
        "float" | "double" if random.one_in(oddity.rare.saturating_mul(4)) => "nan".to_owned(),
        "float" | "double" => random.number(),
        _ if random.one_in(oddity.rare.saturating_mul(4)) => {
            random.of(&["12.0", "+3", "0000000012", "-1"]).to_owned()
        }
        _ if random.one_in(oddity.wrong.saturating_mul(4)) => {
            random.of(&["1.5", "300", "x", "5000000000"]).to_owned()
        }
        _ => random.below(120).to_string(),
    }
}

fn ply_face(random: &mut Random, vertices: usize, oddity: Oddity) -> String {
    let degree = [3, 3, 3, 3, 4, 0][random.below(6)];
    let wrong = random.one_in(oddity.wrong);
    let beyond = if wrong { random.of(&[" 99", " -1", " 4294967295", " 1.5", " x", ""]) } else { "" };
    let corners: String = (0..degree).map(|_| format!(" {}", random.below(vertices))).collect();
    format!("{}{corners}{beyond}", degree + usize::from(!beyond.is_empty()))
}

fn ply(random: &mut Random, lines: usize, oddity: Oddity) -> String {
    let scalars = ["float", "double", "uchar", "char", "short", "ushort", "int", "uint"];
    let beside: Vec<&str> = (0..[0, 0, 1, 3][random.below(4)]).map(|_| random.of(&scalars)).collect();
    let axes = [random.of(&scalars[..2]), random.of(&["float", "double", "int"])];
    let index = random.of(&["int", "int", "uint", "ushort", "float"]);
    let (vertices, faces) = (3 + lines / 2, lines);
    let has_lists = random.one_in(oddity.rare);
    let announced = [vertices, faces]
        .map(|count| if random.one_in(12) { (count + random.below(5)).saturating_sub(2) } else { count });
    let mut head =
        format!("ply\nformat ascii 1.0\nelement vertex {}\nproperty {} x\n", announced[0], axes[0]);
    for (name, scalar) in ["p", "q", "r"].iter().zip(&beside) {
        writeln!(head, "property {scalar} {name}").unwrap();
    }
    write!(head, "property {} y\nproperty {} z\nelement face {}\n", axes[0], axes[1], announced[1]).unwrap();
    writeln!(head, "property list uchar {index} vertex_indices").unwrap();
    for (name, scalar) in ["p", "q", "r"].iter().zip(&beside) {
        writeln!(head, "property {scalar} {name}").unwrap();
    }
    head += if has_lists { "property list uchar float texcoord\n" } else { "" };
    head += random.of(&[
        "",
        "",
        "element edge 1\nproperty int vertex1\nproperty int vertex2\n",
        "element odd 2\nproperty int x\n",
    ]);
    let mut all = vec![head + "end_header"];
    for line in 0..vertices + faces + 1 {
        let others: String =
            beside.iter().map(|scalar| format!(" {}", ply_number(random, scalar, oddity))).collect();
        let row = if line < vertices {
            let [x, y] = [axes[0]; 2].map(|scalar| ply_number(random, scalar, oddity));
            format!("{x}{others} {y} {}", ply_number(random, axes[1], oddity))
        } else if line < vertices + faces {
            let texcoord = if has_lists { random.of(&[" 0", " 2 0.5 1", " 6 0 0 1 0 1 1"]) } else { "" };
            ply_face(random, vertices, oddity) + &others + texcoord
        } else {
            random.of(&["", "0 1", "3 0 1 99 7"]).to_owned()
        };
        if line > 0 && random.one_in(oddity.rare) {
            let words: Vec<&str> = row.split(' ').collect();
            all.push(words.join(random.of(&["\n", "  "])));
        } else {
            all.push(row);
        }
        if line > 0 && random.one_in(oddity.rare) {
            let last = all.pop().unwrap();
            write!(all.last_mut().unwrap(), " {last}").unwrap();
        }
    }
    random.joined(&all)
}

#[test]
fn ply_is_read_as_by_its_reader_alone() {
    assert_all_as_alone(Format::Ply, ply);
}
