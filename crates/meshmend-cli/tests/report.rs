//! Pages, as a user asks for them. What a browser makes of them is tested in `report/viewer/tests`.

#![cfg(feature = "report")]

mod common;

use std::fs;

use common::{Folder, example, meshmend};
use serde_json::Value;

/// The data of a page; null where it is none.
fn data(path: &str) -> Value {
    let html = fs::read_to_string(path).unwrap_or_default();
    assert!(html.starts_with("<!doctype html>") && html.ends_with("</html>\n"));
    let data = html.split(r#"<script type="application/json" id="data">"#).nth(1).unwrap_or_default();
    serde_json::from_str(data.split("</script>").next().unwrap_or_default()).unwrap_or_default()
}

#[test]
fn a_page_has_the_report_of_a_repair_and_the_meshes_and_is_the_same_every_time() {
    let folder = Folder::new();
    let (page, again) = (folder.at("a.html"), folder.at("b.html"));
    let told = meshmend(&["report", &example("broken.obj"), "-o", &page]).succeeds().stdout;
    assert!(
        told.contains("broken.obj: Mended: 12 defects before, none left; one face was removed."),
        "{told}"
    );
    meshmend(&["report", &example("broken.obj"), "-o", &again]).succeeds();
    assert_eq!(fs::read(&page).unwrap(), fs::read(&again).unwrap());

    let data = data(&page);
    let entry = &data["entries"][0];
    let report = ["repair", &example("broken.obj"), "--dry-run", "--json", "--limit", "1000"];
    let told: Value = serde_json::from_str(&meshmend(&report).succeeds().stdout).unwrap();
    for key in ["passes", "removed_faces", "stored", "flipped_faces"] {
        assert_eq!(entry["report"][key], told[key], "{key}");
    }
    assert_eq!(entry["report"]["before"]["defects"], told["before"]["defects"]);
    assert_eq!(
        (&entry["before"]["mesh"]["faces"], &entry["after"]["mesh"]["faces"]),
        (&13.into(), &12.into())
    );
    assert_eq!(entry["before"]["mesh"]["origin"], entry["after"]["mesh"]["origin"]);
    assert_eq!((&data["title"], &data["date"]), (&"broken.obj".into(), &Value::Null));
}

#[test]
fn a_check_writes_the_page_that_a_report_writes() {
    let folder = Folder::new();
    let (page, checked) = (folder.at("a.html"), folder.at("b.html"));
    meshmend(&["report", &example("moebius.off"), "--check-only", "-o", &page]).fails(1, "");
    let told = meshmend(&["check", &example("moebius.off"), "--html", &checked]).fails(1, "").stdout;
    assert!(told.contains("Möbius band"), "{told}");
    assert_eq!(fs::read(&page).unwrap(), fs::read(&checked).unwrap());
    let entry = &data(&page)["entries"][0];
    assert_eq!((&entry["command"], entry["after"].is_null()), (&"check".into(), true));
    assert!(entry["before"]["marks"]["non-orientable-patch"]["strips"][0]["faces"].is_array());
}

#[test]
fn files_that_cant_be_read_are_in_the_page_of_a_folder_too() {
    let folder = Folder::new();
    fs::copy(example("broken.obj"), folder.at("broken.obj")).unwrap();
    fs::write(folder.at("bad.ply"), "this is no mesh\n").unwrap();
    fs::write(folder.at("notes.txt"), "nor is this\n").unwrap();
    let page = folder.at("all.html");
    meshmend(&["report", &folder.at(""), "-o", &page, "--title", "all"]).fails(3, "bad.ply");
    let data = data(&page);
    let states: Vec<&Value> =
        data["entries"].as_array().unwrap().iter().map(|entry| &entry["verdict"]["state"]).collect();
    assert_eq!((states, &data["title"]), (vec![&"unread".into(), &"mended".into()], &"all".into()));
}

#[test]
fn a_large_mesh_is_shown_by_its_defects_and_its_shape() {
    let folder = Folder::new();
    let page = folder.at("a.html");
    meshmend(&["report", &example("broken.obj"), "-o", &page, "--check-only", "--max-faces", "4"])
        .fails(1, "");
    let before = &data(&page)["entries"][0]["before"];
    assert_eq!(before["mesh"]["faces"], 13);
    assert!(before["mesh"]["face_ids"].is_string() && before["shape"]["faces"].is_u64());
}

#[test]
fn a_page_takes_the_place_of_no_mesh() {
    let folder = Folder::new();
    let mesh = folder.at("broken.obj");
    fs::copy(example("broken.obj"), &mesh).unwrap();
    meshmend(&["report", &mesh, "-o", &mesh]).fails(2, "mesh");
    meshmend(&["check", &mesh, "--html", &mesh]).fails(2, "mesh");
    assert_eq!(fs::read(&mesh).unwrap(), fs::read(example("broken.obj")).unwrap());
}
