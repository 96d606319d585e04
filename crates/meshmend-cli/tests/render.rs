//! Pictures, as a user asks for them.

#![cfg(feature = "render")]

mod common;

use std::fs;

use common::{Folder, example, meshmend};

#[test]
fn a_picture_is_written_in_the_format_of_its_name() {
    let folder = Folder::new();
    let (svg, png) = (folder.at("a.svg"), folder.at("a.png"));
    meshmend(&["render", &example("moebius.off"), "-o", &svg, "--overlay", "boundary,witness"]).succeeds();
    let text = fs::read_to_string(&svg).unwrap();
    assert!(
        text.starts_with("<svg")
            && text.contains(">boundary</text>")
            && text.contains(">one-sided strip</text>")
    );
    meshmend(&["render", &example("moebius.off"), "-o", &png, "--size", "64x48", "--perspective", "--edges"])
        .succeeds();
    let bytes = fs::read(&png).unwrap();
    assert_eq!((&bytes[1..4], &bytes[16..24]), (&b"PNG"[..], &[0, 0, 0, 64, 0, 0, 0, 48][..]));
    meshmend(&["render", &example("moebius.off"), "-o", &folder.at("a.gif")]).fails(2, ".svg or .png");
}

#[test]
fn before_and_after_are_side_by_side_and_counted() {
    let folder = Folder::new();
    let svg = folder.at("a.svg");
    let told = meshmend(&["render", &example("broken.obj"), "-o", &svg, "--before-after"]).succeeds().stdout;
    let (before, after) = told.split_once("after\n").unwrap();
    assert!(before.contains("non-manifold: 4") && after.contains("non-manifold: 0"), "{told}");
    let text = fs::read_to_string(&svg).unwrap();
    assert!(text.contains(">before</text>") && text.contains(">after</text>"));
}

#[test]
fn what_may_be_wrong_is_shown_unless_something_else_is_asked_for() {
    let folder = Folder::new();
    let (svg, broken) = (folder.at("a.svg"), example("broken.obj"));
    let told = meshmend(&["render", &broken, "-o", &svg]).succeeds().stdout;
    for shown in ["boundary: ", "non-manifold: ", "inconsistent: ", "witness: "] {
        assert!(told.contains(shown), "{told}");
    }
    assert!(fs::read_to_string(&svg).unwrap().contains(">non-manifold edges</text>"));
    let told = meshmend(&["render", &broken, "-o", &svg, "--overlay", "none"]).succeeds().stdout;
    assert!(!told.contains("non-manifold"), "{told}");
    assert!(!fs::read_to_string(&svg).unwrap().contains(">non-manifold edges</text>"));
    let told = meshmend(&["render", &broken, "-o", &svg, "--overlay", "components"]).succeeds().stdout;
    assert!(!told.contains("non-manifold") && told.contains("components: "), "{told}");
}

#[test]
fn a_contact_sheet_has_a_picture_for_each_generator() {
    let folder = Folder::new();
    let svg = folder.at("a.svg");
    let band = &example("moebius.off");
    meshmend(&["render", band, "-o", &svg, "--contact-sheet", "generators"]).succeeds();
    assert!(fs::read_to_string(&svg).unwrap().contains(">generator 0: 9 edges</text>"));
    let pinched = &example("pinched.ply");
    meshmend(&["render", pinched, "-o", &svg, "--contact-sheet", "generators"]).succeeds();
    assert!(fs::read_to_string(&svg).unwrap().contains(">no generators</text>"));
}

#[test]
fn views_that_are_none_are_refused() {
    let folder = Folder::new();
    let (file, svg) = (example("pinched.ply"), folder.at("a.svg"));
    let render = |arguments: &[&str]| meshmend(&[&["render", &file, "-o", &svg], arguments].concat());
    render(&["--view", "0,0,0"]).fails(2, "direction");
    render(&["--view", "1,2"]).fails(2, "three numbers");
    render(&["--size", "9x9"]).fails(2, "9x9");
    render(&["--view", "-1,-2,0.5", "--azimuth", "3"]).fails(2, "cannot be used with");
    render(&["--view", "-1,-2,0.5", "--up", "0,1,0"]).succeeds();
    render(&["--azimuth", "-30", "--elevation", "90", "--overlay", "components,non-manifold"]).succeeds();
    render(&["--overlay", "nothing"]).fails(2, "invalid value");
}
