//! Whatever is parsed ahead, and wherever chunks end: the answer is that of the reader alone.

use std::fmt::Write;

use super::*;
use crate::formats::drivers::driver;
use crate::input::source::Source;
use crate::{Format, Limits};

/// Numbers in an order that is the same every time.
struct Random(u64);

impl Random {
    fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) % bound as u64) as usize
    }

    fn one_in(&mut self, count: usize) -> bool {
        count > 0 && self.below(count) == 0
    }

    fn of<'a>(&mut self, list: &[&'a str]) -> &'a str {
        list[self.below(list.len())]
    }

    fn number(&mut self) -> String {
        match self.below(8) {
            0 => self
                .of(&["0", "-0", "1e3", "-1.5E-3", "+2", ".5", "3.", "12345678901234567890.25"])
                .to_owned(),
            1 => format!("{}", self.below(1000)),
            _ => format!("{:.3}", self.below(200_000) as f64 / 100.0 - 1000.0),
        }
    }

    fn numbers(&mut self, count: usize) -> String {
        let numbers: Vec<String> = (0..count).map(|_| self.number()).collect();
        numbers.join(self.of(&[" ", " ", " ", "  ", "\t"]))
    }

    /// Lines that are put together as some system does, or as several do, the last one with or without its end.
    fn joined(&mut self, lines: &[String]) -> String {
        let ends = ["\n", "\r\n", "\r"];
        let (usual, mixes) = (self.of(&ends[..2]), self.one_in(4));
        let mut text = String::new();
        for line in lines {
            text += line;
            text += if mixes { self.of(&ends) } else { usual };
            text += if self.one_in(40) { "\n" } else { "" };
        }
        if self.one_in(3) {
            text.truncate(text.trim_end_matches(['\n', '\r']).len());
        }
        text
    }
}

/// How often, once in so many lines, there is something that is not plain, and something that is wrong.
#[derive(Clone, Copy)]
struct Oddity {
    rare: usize,
    wrong: usize,
}

const ODDITIES: [Oddity; 5] = [
    Oddity { rare: 0, wrong: 0 },
    Oddity { rare: 12, wrong: 0 },
    Oddity { rare: 2, wrong: 0 },
    Oddity { rare: 12, wrong: 30 },
    Oddity { rare: 0, wrong: 40 },
];

/// What a reader says, down to the bits of each number.
fn outcome(format: Format, text: &str, pace: Pace, limits: &Limits) -> String {
    let source = Source { bytes: text.as_bytes(), length: text.len(), name: "text", pace };
    match (driver(format).read)(&source, limits) {
        Ok(parsed) => {
            format!("{:?} {:?} {:?}", parsed.mesh, parsed.shell.encoding(), parsed.notes.into_list())
        }
        Err(error) => format!("{error:?}"),
    }
}

fn assert_as_alone(format: Format, text: &str, chunks: &[usize]) {
    for limits in limits_of(format, text) {
        let alone = outcome(format, text, Pace::NONE, &limits);
        for &chunk in chunks {
            for chunks in [1, 3] {
                let ahead = outcome(format, text, Pace { chunk, chunks }, &limits);
                assert_eq!(ahead, alone, "{chunks} chunks of {chunk} bytes, {limits:?}: {text:?}");
            }
        }
    }
}

/// The usual limits, and for each count what a text has, and one less.
fn limits_of(format: Format, text: &str) -> Vec<Limits> {
    let usual = Limits::default();
    let source = Source { bytes: text.as_bytes(), length: text.len(), name: "text", pace: Pace::NONE };
    let Ok(parsed) = (driver(format).read)(&source, &usual) else { return vec![usual] };
    let counts = parsed.mesh.counts();
    let corners = parsed.mesh.faces().corner_count() as u64;
    let [vertices, faces] = [counts.vertices, counts.faces].map(|count| count as u64);
    let exact = Limits { max_vertices: vertices, max_faces: faces, max_corners: corners, ..usual };
    let limits = [
        usual,
        exact,
        Limits { max_vertices: vertices.saturating_sub(1), ..usual },
        Limits { max_faces: faces.saturating_sub(1), ..usual },
        Limits { max_corners: corners.saturating_sub(1), ..usual },
        Limits { max_comments: 1, ..usual },
    ];
    limits.to_vec()
}

/// Texts of every oddity, small ones in tiny chunks and larger ones in small chunks.
fn assert_all_as_alone(format: Format, text: impl Fn(&mut Random, usize, Oddity) -> String) {
    let (small, large) = (120, 8);
    let mut random = Random(1);
    for oddity in ODDITIES {
        for _ in 0..small {
            let lines = 1 + random.below(40);
            let text = text(&mut random, lines, oddity);
            assert_as_alone(format, &text, &[1, 2, 5, 17, 64, 300]);
        }
        for _ in 0..large {
            let text = text(&mut random, 1500, oddity);
            assert_as_alone(format, &text, &[1000, 10_000]);
        }
    }
}

fn obj(random: &mut Random, lines: usize, oddity: Oddity) -> String {
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
        let plain = if line % 3 == 0 {
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
        all.push(format!("{before}{plain}{after}"));
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

/// Plain rows are `x`; any other line is not plain, and `skip` goes on for two lines.
#[derive(Default)]
struct Crosses(usize);

impl UsualRows for Crosses {
    fn none(&self) -> Self {
        Crosses(0)
    }

    fn clear(&mut self) {
        self.0 = 0;
    }

    fn add(&mut self, text: &[u8], at: usize) -> Option<usize> {
        let row = text[at..].starts_with(b"x\n");
        self.0 += usize::from(row);
        row.then_some(at + 2)
    }
}

#[derive(Default)]
struct Counting<'a> {
    text: &'a [u8],
    at: usize,
    /// Lines that it was given, and those that it has read itself.
    given: usize,
    read: Vec<&'a [u8]>,
}

impl SequentialReader<Crosses> for Counting<'_> {
    fn at(&self) -> usize {
        self.at
    }

    fn read_to(&mut self, end: usize) -> Result<(), ReadError> {
        while self.at < end {
            let line_end = text::line_end(self.text, self.at);
            self.read.push(&self.text[self.at..line_end]);
            self.at = text::after_line_end(self.text, line_end);
            if self.read.last() == Some(&&b"skip"[..]) {
                self.at = text::after_line_end(self.text, text::line_end(self.text, self.at));
            }
        }
        Ok(())
    }

    fn take(&mut self, rows: &Crosses, end: usize) {
        self.given += rows.0;
        self.at = end;
    }

    fn is_done(&self) -> bool {
        false
    }
}

fn counted(text: &[u8], chunk: usize, chunks: usize) -> (usize, Vec<&[u8]>) {
    let mut reader = Counting { text, ..Counting::default() };
    read_speculatively(text, Pace { chunk, chunks }, &Crosses(0), &mut reader).unwrap();
    assert_eq!(reader.at, text.len());
    (reader.given, reader.read)
}

#[test]
fn a_reader_is_given_all_that_is_plain_and_reads_the_rest() {
    let text = b"x\nx\na\nx\nb\nc\nx\nx\n";
    for chunk in 1..20 {
        for chunks in 1..4 {
            assert_eq!(counted(text, chunk, chunks), (5, vec![&b"a"[..], b"b", b"c"]));
        }
    }
    assert_eq!(counted(b"", 1, 2), (0, vec![]));
}

#[test]
fn what_a_reader_has_passed_over_is_not_given_to_it() {
    let text = b"x\nskip\nx\nx\nx\n";
    for chunk in 1..20 {
        let (given, read) = counted(text, chunk, 2);
        // The rows of the piece in whose first row it would stand are read.
        assert_eq!(given + read.len(), 4, "{chunk}");
        assert_eq!(read[0], b"skip");
    }
}

#[test]
fn a_chunk_that_is_hardly_plain_is_left_to_the_reader() {
    let few = b"x\na\n".repeat(1000);
    let (given, read) = counted(&few, 1 << 20, 1);
    assert_eq!(given + read.len(), 2000);
    assert!((10..30).contains(&given), "{given}");
    let often = [&b"x\n".repeat(1000)[..], b"a\n"].concat().repeat(100);
    assert_eq!(counted(&often, 1 << 20, 1).0, 100_000);
}

#[test]
fn small_texts_start_no_thread() {
    assert_eq!(Pace::of(1000).chunks, 1);
}
