//! What the text of a kernel says of its bytes is what its arrays come to, and every kernel has a text of the same form.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test stops where it fails")]

use meshmend_core::{Array, Connectivity};
use meshmend_kernels::{KernelKind, KernelTask};
use meshmend_testkit::shapes::{self, Tiles};

/// Bytes a face, by the arrays and by the kernel's own sum.
struct Bytes;

impl KernelTask for Bytes {
    type Output = [f64; 2];
    fn run<K: Connectivity>(self, kernel: &K) -> [f64; 2] {
        let arrays = kernel.arrays();
        assert!(arrays.len() > 1, "{} names its arrays", K::NAME);
        let mut names: Vec<&str> = arrays.iter().map(|array| array.name).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), arrays.len(), "{} gives two arrays one name", K::NAME);
        [arrays.iter().map(Array::bytes).sum(), kernel.heap_bytes()]
            .map(|bytes| bytes as f64 / kernel.face_count() as f64)
    }
}

/// Why a text says that a kind of defect is refused.
fn whys(text: &str) -> Vec<&str> {
    let items = text.lines().filter_map(|line| line.strip_prefix("* `"));
    items.filter_map(|item| Some(item.split_once("`: ")?.0)).collect()
}

#[test]
fn a_text_says_of_each_kind_that_is_refused_why() {
    for kind in KernelKind::ALL {
        let refused: Vec<&str> = kind.capabilities().refused_kinds().map(|refused| refused.code()).collect();
        assert_eq!(whys(kind.lesson()), refused, "{kind}");
    }
}

/// The paragraph of a text that begins with a word.
fn paragraph<'a>(text: &'a str, word: &str) -> Option<&'a str> {
    text.split("\n\n").find(|paragraph| paragraph.starts_with(word))
}

/// The numbers in parentheses, with or without a unit.
fn in_parentheses(text: &str) -> Vec<f64> {
    let after = text.split('(').skip(1);
    after.filter_map(|rest| rest.split([' ', ')']).next()?.parse().ok()).collect()
}

#[test]
#[cfg_attr(miri, ignore = "ten kernels of thousands of faces take an interpreter too long")]
fn the_bytes_of_a_text_are_those_of_the_arrays() {
    let complex = shapes::torus(60, 50, Tiles::Triangles).soup.complex();
    for kind in KernelKind::ALL {
        let [by_arrays, by_kernel] = kind.run(&complex, Bytes).unwrap();
        assert_eq!(by_arrays, by_kernel, "{kind}");
        let layout = paragraph(kind.lesson(), "*Layout*: ").unwrap();
        let total = layout.split(" bytes a triangle in all").next().unwrap().split(' ').next_back().unwrap();
        let parts: f64 = in_parentheses(layout).iter().sum();
        assert_eq!((total.parse(), parts), (Ok(parts), parts), "{kind}");
        // The starts of a list are one more than the lists, and this torus has 6000 faces.
        assert!((by_kernel - parts).abs() < 0.01, "{kind}: {by_kernel} and {parts}");
    }
}

#[test]
fn the_table_of_the_crate_has_the_bytes_of_the_texts() {
    let table = include_str!("../README.md");
    for kind in KernelKind::ALL {
        let row = table.lines().find(|line| line.starts_with(&format!("| {kind} "))).unwrap();
        let bytes = row.trim_end_matches(" |").rsplit(' ').next().unwrap();
        assert!(kind.lesson().contains(&format!(" {bytes} bytes a triangle in all")), "{kind}: {bytes}");
    }
}

#[test]
#[cfg_attr(miri, ignore = "shapes of thousands of faces take an interpreter too long")]
fn arrays_come_to_the_heap_on_meshes_of_all_kinds() {
    for shape in shapes::catalogue() {
        let (complex, faces) = (shape.soup.complex(), shape.soup.faces.len());
        for kind in KernelKind::ALL.iter().filter(|_| faces > 0) {
            if let Ok([by_arrays, by_kernel]) = kind.run(&complex, Bytes) {
                assert_eq!(by_arrays, by_kernel, "{kind}: {}", shape.name);
            }
        }
    }
}

#[test]
fn a_text_has_a_title_a_figure_and_all_that_is_to_be_said() {
    for kind in KernelKind::ALL {
        let text = kind.lesson();
        let title = text.lines().next().unwrap().strip_prefix("# ").unwrap();
        assert!(title.to_lowercase().starts_with(&kind.name().replace('-', " ")[..4]), "{kind}: {title}");
        assert!(text.contains("\n```text\n"), "{kind} has a figure");
        for word in ["*Layout*: ", "*Admits* ", "*Cost*: ", "*Choose it* ", "*Source*: ", "*Try*:"] {
            assert!(paragraph(text, word).is_some(), "{kind} lacks {word}");
        }
        let commands = text.lines().filter(|line| line.starts_with("$ meshmend ")).count();
        assert_eq!(commands, 3, "{kind}");
        assert!(text.lines().all(|line| line == line.trim_end()), "{kind}: a line ends in spaces");
    }
}
