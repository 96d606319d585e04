//! Shapes with known answers, and the tables that they make, as a user runs them.

mod common;

use common::{Folder, meshmend};

#[test]
fn every_shape_is_listed_made_and_what_it_says() {
    let folder = Folder::new();
    let list = meshmend(&["make", "--list"]).succeeds().stdout;
    let names: Vec<&str> = list.lines().skip(1).filter_map(|line| line.split_whitespace().next()).collect();
    assert!(names.len() > 25, "{list}");
    for name in names {
        let file = folder.at(&format!("{name}.off"));
        let said = meshmend(&["make", name, "-o", &file]).succeeds().stdout;
        let found = meshmend(&["check", "--json", &file]).json();
        let row = |label: &str| {
            let line = said.lines().find_map(|line| line.trim_start().strip_prefix(label));
            line.unwrap_or_else(|| panic!("{label}: {said}")).trim().to_owned()
        };
        let figure = |key: &str| match &found[key] {
            serde_json::Value::Null => "–".to_owned(),
            value => value.to_string(),
        };
        for (label, key) in [
            ("vertices", "vertices"),
            ("edges", "edges"),
            ("faces", "faces"),
            ("Euler characteristic", "euler_characteristic"),
            ("components", "components"),
            ("boundary loops", "boundary_loops"),
            ("genus", "genus"),
            ("cross-caps", "cross_caps"),
        ] {
            assert_eq!(row(label), figure(key), "{name}: {label}");
        }
    }
}

#[test]
fn sizes_and_finer_faces_are_as_asked_for() {
    let folder = Folder::new();
    let file = folder.at("a.ply");
    let made =
        ["make", "surface", "--genus", "2", "--holes", "3", "--resolution", "3", "--triangles", "-o", &file];
    meshmend(&made).succeeds();
    let found = meshmend(&["check", "--json", &file]).json();
    assert_eq!((found["genus"].as_u64(), found["boundary_loops"].as_u64()), (Some(2), Some(3)));
    let all_triangles = found["kernels"].as_array().unwrap().iter().all(|kernel| kernel["holds"] == true);
    assert!(all_triangles, "{found}");
    meshmend(&["make", "tetrahedron", "--refine", "2", "-o", &file]).succeeds();
    assert_eq!(meshmend(&["check", "--json", &file]).json()["faces"], 48);
    // STL holds triangles alone, and no indices.
    let stl = folder.at("a.stl");
    meshmend(&["make", "cube", "-o", &stl]).succeeds();
    assert_eq!(meshmend(&["check", "--json", &stl]).json()["faces"], 12);
}

#[test]
fn shapes_that_there_are_not_are_refused() {
    let folder = Folder::new();
    let file = folder.at("a.off");
    meshmend(&["make", "teapot", "-o", &file]).fails(2, "the shapes are tetrahedron");
    meshmend(&["make", "cube", "--genus", "1", "-o", &file]).fails(2, "`cube` has no genus");
    meshmend(&["make", "torus", "--resolution", "2", "-o", &file]).fails(2, "at least 3");
    meshmend(&["make", "torus", "--resolution", "99999999999", "-o", &file]).fails(2, "so large");
    meshmend(&["make", "tetrahedron", "--refine", "40", "-o", &file]).fails(2, "so large");
    let most = usize::MAX.to_string();
    meshmend(&["make", "cube", "--refine", &most, "--triangles", "-o", &file]).fails(2, "so large");
    meshmend(&["make", "surface", "--genus", "1", "--cross-caps", "1", "-o", &file]).fails(2, "--cross-caps");
    meshmend(&["make", "cube"]).fails(2, "--output");
    meshmend(&["make", "cube", "-o", &folder.at("a.gif")]).fails(2, "a.gif");
    assert!(folder.names().is_empty());
}

/// Tables 1 and 2 of the paper, with the icosahedron and the dodecahedron in their places and β₀ = 1 for the hexagon.
#[test]
fn the_tables_of_the_paper() {
    let folder = Folder::new();
    let rows = |shapes: &[&str], table: usize| -> Vec<Vec<String>> {
        let files: Vec<String> = shapes
            .iter()
            .map(|shape| {
                let file = folder.at(&format!("{shape}.off"));
                meshmend(&["make", shape, "-o", &file]).succeeds();
                file
            })
            .collect();
        let line: Vec<&str> =
            ["check", "--table"].into_iter().chain(files.iter().map(String::as_str)).collect();
        let text = meshmend(&line).succeeds().stdout;
        let tables: Vec<&str> = text.split("\n\n").collect();
        let rows = tables[table].lines().skip(2);
        rows.map(|row| row.split_whitespace().skip(1).map(str::to_owned).collect()).collect()
    };
    let numbers = |row: &str| row.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
    let solids = ["tetrahedron", "cube", "octahedron", "dodecahedron", "icosahedron"];
    let figures = ["4 6 4", "8 12 6", "6 12 8", "20 30 12", "12 30 20"];
    assert_eq!(rows(&solids, 0), figures.map(|figures| numbers(&format!("{figures} 2 1 0 0 –"))));
    let expected = ["0 6 5 1 0 1 1 0 0", "0 12 11 7 0 6 1 1 0", "0 4 3 3 1 3 1 0 1", "0 9 8 10 1 8 1 2 1"];
    assert_eq!(rows(&["hexagon", "annulus", "tetrahedron", "torus"], 1), expected.map(numbers));
}

#[test]
fn a_table_has_a_row_for_each_file_that_can_be_read() {
    let folder = Folder::new();
    let (cube, broken) = (folder.at("cube.off"), folder.with("broken.off", "OFF\n1 1 0\n"));
    meshmend(&["make", "cube", "-o", &cube]).succeeds();
    let run = meshmend(&["check", "--table", &broken, &cube]);
    assert_eq!(run.status, 3);
    assert_eq!(run.stdout.matches("cube.off").count(), 2);
    assert!(run.stderr.contains("broken.off"));
    meshmend(&["check", "--table", "--json", &cube]).fails(2, "--json");
}
