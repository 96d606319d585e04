//! How the rows of text PLY may stand on lines: what is read, and which line an error names.

use crate::common::{faces, note, read as read_as, refused as refused_as};
use meshmend_core::counted;
use meshmend_io::{Format, NoteKind, Place, ReadFile};

const XYZ: &str = "property float x\nproperty float y\nproperty float z\n";
const LIST: &str = "property list uchar int vertex_indices\n";

/// A file of three vertices and one face, with other elements after them; its first row stands on line 10 if there
/// are none.
fn file(others: &str, body: &str) -> String {
    format!("ply\nformat ascii 1.0\nelement vertex 3\n{XYZ}element face 1\n{LIST}{others}end_header\n{body}")
}

fn read(others: &str, body: &str) -> ReadFile {
    read_as(Format::Ply, file(others, body))
}

/// The line that an error names, counted from the first one of the body, and the reason.
fn refused(others: &str, body: &str) -> (u64, String) {
    let header = file(others, "").lines().count() as u64;
    match refused_as(Format::Ply, file(others, body)) {
        (Place::Line(line), reason) => (line - header, reason),
        other => panic!("{other:?}"),
    }
}

fn assert_is_the_triangle(file: &ReadFile, body: &str) {
    assert_eq!(file.mesh.positions(), [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], "{body:?}");
    assert_eq!(faces(&file.mesh), [[0, 1, 2]], "{body:?}");
}

#[test]
fn rows_on_lines_of_their_own_are_read_without_a_word() {
    for body in [
        "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
        "0 0 0\r\n1 0 0\r\n0 1 0\r\n3 0 1 2\r\n",
        "0 0 0\r1 0 0\r0 1 0\r3 0 1 2",
        "\n  0 0\t0 \n\n\n1 0 0\n \n0 1 0\n3 0 1 2\n\n",
        "-0 0 0\n1e0 +0 0\n0 1.0 0\n3 0 1 2.0",
    ] {
        let file = read("", body);
        assert_is_the_triangle(&file, body);
        assert_eq!(file.notes, [], "{body:?}");
    }
}

#[test]
fn rows_that_are_wrapped_evenly_are_read_and_noted() {
    for (body, count, first) in [
        ("0\n0\n0\n1 0\n0\n0 1 0\n3 0\n1 2\n", 3, 10),
        ("0 0 0 1 0 0\n0 1 0\n3 0 1 2\n", 1, 10),
        ("0 0 0\n1 0 0 0 1 0\n3 0 1 2\n", 1, 11),
        ("0 0 0 1\n0 0 0 1\n0\n3\n0 1 2\n", 4, 10),
        ("0 0 0\r\n1 0 0\r\n0 1 0\r\n3 0\r\n1 2\r\n", 1, 13),
        ("0 0 0 1 0 0 0 1 0\n3 0 1 2", 2, 10),
        // All on one line, and elements of a line each that share one.
        ("0 0 0 1 0 0 0 1 0 3 0 1 2", 3, 10),
        ("\n0 0 0 1 0 0 0 1 0 3 0 1 2\n\n", 3, 11),
    ] {
        let file = read("", body);
        assert_is_the_triangle(&file, body);
        let wrapped = note(&file, NoteKind::WrappedRows);
        assert_eq!((wrapped.count, wrapped.first.clone()), (count, Place::Line(first)), "{body:?}");
        assert_eq!(file.notes.len(), 1, "{body:?}");
    }
}

#[test]
fn a_wrong_number_of_values_is_refused_with_its_line() {
    let vertex = |row: u64, found: u64| {
        format!("row {row} of 3 of element `vertex` announces 3 values, its line has {found}")
    };
    let face = |announced: u64, found: u64| {
        let values = if announced == 1 { "value" } else { "values" };
        format!("row 1 of 1 of element `face` announces {announced} {values}, its line has {found}")
    };
    for (body, line, reason) in [
        // A value too many: in the first row, in the middle, in the last one, in all of them, in a face.
        ("0 0 0 9\n1 0 0\n0 1 0\n3 0 1 2\n", 1, vertex(1, 4)),
        ("0 0 0\n1 0 0 9\n0 1 0\n3 0 1 2\n", 2, vertex(2, 4)),
        ("0 0 0\n1 0 0\n0 1 0 9\n3 0 1 2\n", 3, vertex(3, 4)),
        ("0 0 0\n1 0 0\n0 1 0 3\n3 0 1 2\n", 3, vertex(3, 4)),
        ("0 0 0 9\n1 0 0 9\n0 1 0 9\n3 0 1 2\n", 1, vertex(1, 4)),
        ("0 0 0 # a\n1 0 0\n0 1 0\n3 0 1 2\n", 1, vertex(1, 5)),
        ("0 0 0\n1 0 0\n0 1 0\n3 0 1 2 9\n", 4, face(4, 5)),
        ("0 0 0\n1 0 0\n0 1 0\n3 0 1 2 0\n", 4, face(4, 5)),
        ("0 0 0\n1 0 0\n0 1 0\n2 0 1 2\n", 4, face(3, 4)),
        // A value too few.
        ("0 0\n1 0 0\n0 1 0\n3 0 1 2\n", 1, vertex(1, 2)),
        ("0 0 0\n1 0\n0 1 0\n3 0 1 2\n", 2, vertex(2, 2)),
        ("0 0 0\n1 0 0\n0 1\n3 0 1 2\n", 3, vertex(3, 2)),
        ("0 0\n1 0\n0 1\n3 0 1 2\n", 1, vertex(1, 2)),
        ("0 0 0\n1 0 0\n0 1 0\n3 0 1\n", 4, face(4, 3)),
        ("0 0 0\n1 0 0\n0 1 0\n4 0 1 2", 4, face(5, 4)),
        ("0 0 0\n1 0 0\n0 1 0\n200 0 1 2", 4, face(201, 4)),
        ("0 0 0\r\n1 0\r\n0 1 0\r\n3 0 1 2\r\n", 2, vertex(2, 2)),
        ("\n\n0 0 0\n\n1 0\n0 1 0\n3 0 1 2\n", 5, vertex(2, 2)),
        // Rows too many are those of the next element, rows too few have those of the next one.
        ("0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n", 4, face(1, 3)),
        ("0 0 0\n1 0 0\n3 0 1 2\n", 3, vertex(3, 4)),
        // All on one line.
        ("0 0 0 9 1 0 0 0 1 0 3 0 1 2", 1, vertex(1, 14)),
        ("0 0 1 0 0 0 1 0 3 0 1 2", 1, vertex(1, 12)),
    ] {
        let (found, why) = refused("", body);
        assert_eq!(found, line, "{body:?}: {why}");
        assert!(why == reason || why.starts_with(&(reason.clone() + "; ")), "{body:?}: {why}, not {reason}");
    }
}

#[test]
fn rows_that_are_missing_at_the_end_are_counted() {
    let missing = |row: u64, count: u64, name: &str| {
        let verb = if row == 1 || count == 1 { "is" } else { "are" };
        let rows = counted(count, "row");
        format!("the file ends early: {row} of {rows} of element `{name}` {verb} there")
    };
    for (body, line, reason) in [
        ("", 1, missing(0, 3, "vertex")),
        ("\n\n", 3, missing(0, 3, "vertex")),
        ("0 0 0\n", 2, missing(1, 3, "vertex")),
        ("0 0 0\n1 0 0\n", 3, missing(2, 3, "vertex")),
        ("0 0 0\n1 0 0\n0 1 0", 3, missing(0, 1, "face")),
    ] {
        assert_eq!(refused("", body), (line, reason), "{body:?}");
    }
}

/// What is read across lines may fail anywhere: the first line with a wrong number is the reason.
#[test]
fn what_fails_further_on_is_told_with_the_first_odd_line() {
    let (line, why) = refused("", "0 0\n1 0 0\n0 x 0\n3 0 1 2\n");
    let first = "row 1 of 3 of element `vertex` announces 3 values, its line has 2";
    assert_eq!(
        (line, why),
        (1, format!("{first}; read across lines, it fails at line 12: `x` where a number belongs"))
    );
    let (_, why) = refused("", "0 0\n0\n1 0 0\n0 1 0\n3 0 1 2\n 7\n8\n");
    assert_eq!(why, format!("{first}; read across lines, 2 values are left at the end of the file"));
    let (_, why) = refused("", "0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    assert_eq!(why, format!("{first}; read across lines, element `vertex` does not end with line 13"));
    let (_, why) = refused("", "0 0\n0 1 0 0\n0 1 0\n");
    assert_eq!(
        why,
        format!("{first}; read across lines, the file ends early: 0 of 1 row of element `face` is there")
    );
    // A value that is wrong in a line with the right number of them is the reason itself.
    assert_eq!(refused("", "0 0 0\n1 x 0\n0 1 0\n3 0 1 2\n"), (2, "`x` where a number belongs".to_owned()));
}

#[test]
fn rows_of_every_element_are_judged() {
    let camera = "element camera 2\nproperty float fov\nproperty list uchar int ids\n";
    let edge = "element edge 1\nproperty int vertex1\nproperty int vertex2\n";
    let strips = "element tristrips 1\nproperty list int int vertex_indices\n";
    let triangle = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    for (others, good, wrapped, bad, reason) in [
        (
            camera,
            "1 2 7 8\n1 0\n",
            "1 2\n7 8 1 0\n",
            "1 2 7 8 9\n0 0\n",
            "row 1 of 2 of element `camera` announces 4 values, its line has 5",
        ),
        (
            camera,
            "1 0\n1 0\n",
            "1 0 1 0\n",
            "1 0\n1 2 7\n",
            "row 2 of 2 of element `camera` announces 4 values, its line has 3",
        ),
        (
            camera,
            "1 0\n1 1 5\n",
            "1\n0\n1\n1\n5\n",
            "1\n1 0\n",
            "row 1 of 2 of element `camera` announces at least 2 values, its line has 1",
        ),
        (
            edge,
            "0 1\n",
            "0\n1\n",
            "0 1 2\n",
            "row 1 of 1 of element `edge` announces 2 values, its line has 3",
        ),
        (edge, "0 1", "\n0\n1", "0", "row 1 of 1 of element `edge` announces 2 values, its line has 1"),
        (
            strips,
            "3 2 1 0\n",
            "3 2\n1 0\n",
            "3 2 1 0 1\n",
            "row 1 of 1 of element `tristrips` announces 4 values, its line has 5",
        ),
        (
            strips,
            "3 2 1 0\n",
            "3 2\n1 0\n",
            "4 2 1 0\n",
            "row 1 of 1 of element `tristrips` announces 5 values, its line has 4",
        ),
    ] {
        let of_wrapping = |file: ReadFile| file.notes.iter().any(|note| note.kind == NoteKind::WrappedRows);
        assert!(!of_wrapping(read(others, &format!("{triangle}{good}"))), "{good:?}");
        assert!(of_wrapping(read(others, &format!("{triangle}{wrapped}"))), "{wrapped:?}");
        let (_, why) = refused(others, &format!("{triangle}{bad}"));
        assert!(why.starts_with(reason), "{bad:?}: {why}");
    }
}

/// An element may be there without a row, or a row without a value.
#[test]
fn elements_without_values_are_even_anywhere() {
    let others = "element camera 0\nproperty float fov\nelement nothing 7\n";
    for body in
        ["0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "0 0 0 1 0 0 0 1 0 3 0 1 2", "0 0 0\n1 0\n0\n0 1 0\n3 0 1 2"]
    {
        assert_is_the_triangle(&read(others, body), body);
    }
}

#[test]
fn lines_after_the_rows_are_no_rows() {
    let file = read("", "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n\nthe end\n");
    assert_eq!(note(&file, NoteKind::SurplusData).first, Place::Line(15));
    assert_is_the_triangle(&file, "");
}

/// Comments may stand anywhere in the header, with or without text.
#[test]
fn comments_stand_anywhere_in_a_header() {
    let text = format!(
        "ply\r\ncomment first\r\ncomment\r\nformat ascii 1.0\r\n\r\nobj_info x\r\nelement vertex 1\r\ncomment between\r\n{}comment last\r\nend_header\r\n1 2 3\r\n",
        XYZ.replace('\n', "\r\ncomment of an axis\r\n")
    );
    let file = read_as(Format::Ply, text);
    assert_eq!(file.mesh.positions(), [[1.0, 2.0, 3.0]]);
    assert_eq!(file.mesh.metadata().len(), 8);
    assert_eq!(file.notes, []);
}

fn strips(lists: &str) -> ReadFile {
    let rows = lists.lines().count();
    let vertices = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n";
    read_as(
        Format::Ply,
        format!(
            "ply\nformat ascii 1.0\nelement vertex 6\n{XYZ}element tristrips {rows}\nproperty list int int vertex_indices\nend_header\n{vertices}{lists}\n"
        ),
    )
}

#[test]
fn stitches_of_strips_are_no_faces_and_are_counted() {
    for (lists, expected, stitches) in [
        ("4 0 1 2 3", &[[0, 1, 2], [2, 1, 3]][..], 0),
        // Led on with two more vertices, from an even and from an odd place.
        ("8 0 1 2 3 3 2 2 3", &[[0, 1, 2], [2, 1, 3]], 4),
        ("8 0 1 2 2 3 3 4 5", &[[0, 1, 2], [4, 3, 5]], 4),
        ("9 0 1 2 3 3 2 2 3 4", &[[0, 1, 2], [2, 1, 3], [2, 3, 4]], 4),
        ("9 0 1 2 2 2 3 3 4 5", &[[0, 1, 2], [3, 4, 5]], 5),
        ("5 0 1 0 2 3", &[[0, 1, 2], [0, 2, 3]], 1),
        ("3 0 0 0", &[], 1),
        ("7 0 1 2 -1 2 1 3", &[[0, 1, 2], [2, 1, 3]], 0),
        ("9 0 1 2 2 -1 2 2 1 3", &[[0, 1, 2], [1, 2, 3]], 2),
        ("3 0 1 2\n4 2 2 1 3", &[[0, 1, 2], [1, 2, 3]], 1),
        ("2 0 1\n0\n1 5\n3 1 1 -1", &[], 0),
    ] {
        let file = strips(lists);
        assert_eq!(faces(&file.mesh), expected, "{lists}");
        let found: u64 =
            file.notes.iter().filter(|note| note.kind == NoteKind::Stitches).map(|note| note.count).sum();
        assert_eq!(found, stitches, "{lists}");
    }
    assert_eq!(note(&strips("5 0 1 0 2 3"), NoteKind::Stitches).first, Place::Line(16));
}

/// What a strip names exists, also where it only leads on.
#[test]
fn a_stitch_names_vertices_that_exist() {
    let text = format!(
        "ply\nformat ascii 1.0\nelement vertex 1\n{XYZ}element tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n3 0 7 7\n"
    );
    assert_eq!(refused_as(Format::Ply, text).1, "vertex 7 does not exist: the file has 1 vertex");
}
