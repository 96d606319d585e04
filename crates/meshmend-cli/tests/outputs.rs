//! No command replaces a file by something of another kind, and no two outputs are one file.

#![allow(clippy::unwrap_used, reason = "a test stops where it fails")]

mod common;

use std::fs;

use common::{Folder, example, meshmend};

/// A folder with a mesh under several names, and what the mesh's file holds.
fn meshes() -> (Folder, String, Vec<String>) {
    let folder = Folder::new();
    let text = fs::read_to_string(example("broken.obj")).unwrap();
    let mesh = folder.with("mesh.obj", &text);
    let mut names = vec![mesh.clone(), folder.at("./mesh.obj"), folder.at("nothing/../mesh.obj")];
    fs::create_dir(folder.at("nothing")).unwrap();
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("mesh.obj", folder.at("link.svg")).unwrap();
        std::os::unix::fs::symlink("link.svg", folder.at("link-to-link.json")).unwrap();
        fs::hard_link(&mesh, folder.at("hard.svg")).unwrap();
        names.extend(["link.svg", "link-to-link.json", "hard.svg"].map(|name| folder.at(name)));
    }
    (folder, text, names)
}

#[test]
fn nothing_but_a_mesh_takes_the_place_of_the_input() {
    let (folder, text, names) = meshes();
    let mesh = folder.at("mesh.obj");
    for name in &names {
        meshmend(&["incremental", &mesh, "--plot", name]).fails(2, "mesh");
        meshmend(&["matrix", &mesh, "--matrix-market", name]).fails(2, "mesh");
        meshmend(&["repair", &mesh, "-o", &folder.at("out.ply"), "--report", name]).fails(2, "mesh");
        meshmend(&["repair", &mesh, "--dry-run", "--report", name]).fails(2, "mesh");
        let picture = meshmend(&["render", &mesh, "-o", name]);
        assert_eq!(picture.status, 2, "{name}: {}", picture.stderr);
        if name.ends_with(".svg") {
            meshmend(&["flatten", &mesh, "-o", name]).fails(2, "overwrite");
        }
        assert_eq!(fs::read_to_string(&mesh).unwrap(), text, "{name}");
    }
    assert!(!folder.names().contains(&"out.ply".to_owned()));
}

#[test]
fn nothing_but_a_mesh_takes_the_place_of_another_mesh() {
    let (folder, text, _) = meshes();
    let other = folder.with("other.obj", &text);
    let nameless = folder.with("nameless", "ply\nformat ascii 1.0\nelement vertex 0\nend_header\n");
    let input = folder.at("mesh.obj");
    for victim in [&other, &nameless, &folder.at("new.stl"), &folder.at("new.PLY")] {
        meshmend(&["incremental", &input, "--plot", victim]).fails(2, "mesh");
        meshmend(&["matrix", &input, "--matrix-market", victim]).fails(2, "mesh");
        meshmend(&["repair", &input, "--dry-run", "--report", victim]).fails(2, "mesh");
    }
    assert_eq!(fs::read_to_string(&other).unwrap(), text);
}

#[test]
fn a_mesh_may_take_the_place_of_a_mesh() {
    let (folder, _, names) = meshes();
    let mesh = folder.at("mesh.obj");
    for name in &names {
        meshmend(&["repair", &mesh, "-o", name, "--to", "obj"]).succeeds();
        meshmend(&["convert", &mesh, name, "--to", "obj"]).succeeds();
        meshmend(&["cut", &mesh, "-o", name, "--to", "obj"]).succeeds();
    }
    meshmend(&["make", "cube", "-o", &mesh]).succeeds();
}

#[test]
fn a_mesh_does_not_take_the_place_of_a_plan() {
    let folder = Folder::new();
    let plan = folder.with("plan.toml", "passes = ['weld']\n");
    let arguments = ["repair", &example("broken.obj"), "--plan", &plan, "-o", &plan, "--to", "obj"];
    meshmend(&arguments).fails(2, "would overwrite --plan");
    assert_eq!(fs::read_to_string(&plan).unwrap(), "passes = ['weld']\n");
}

#[test]
fn two_outputs_are_two_files() {
    let (folder, text, _) = meshes();
    let (input, out) = (folder.at("mesh.obj"), folder.at("out.json"));
    let mut names =
        vec![out.clone(), folder.at("./out.json"), folder.at("nothing/../out.json"), folder.at("OUT.json")];
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("out.json", folder.at("to-out.json")).unwrap();
        std::os::unix::fs::symlink("nothing", folder.at("folder")).unwrap();
        names.extend(["to-out.json", "folder/../out.json"].map(|name| folder.at(name)));
    }
    for name in &names {
        let arguments = ["repair", &input, "-o", &out, "--to", "obj", "--report", name];
        meshmend(&arguments).fails(2, "are one file");
    }
    #[cfg(unix)]
    {
        fs::write(&out, "{}").unwrap();
        fs::hard_link(&out, folder.at("hard.json")).unwrap();
        let arguments = ["repair", &input, "-o", &out, "--to", "obj", "--report", &folder.at("hard.json")];
        meshmend(&arguments).fails(2, "are one file");
    }
    let report = folder.at("report.json");
    meshmend(&["repair", &input, "-o", &folder.at("out.obj"), "--report", &report]).succeeds();
    assert_eq!(fs::read_to_string(&input).unwrap(), text);
}

#[cfg(unix)]
#[test]
fn devices_take_whatever_is_written_to_them() {
    let (folder, _, _) = meshes();
    let input = folder.at("mesh.obj");
    meshmend(&["repair", &input, "-o", "/dev/null", "--to", "obj", "--report", "/dev/null"]).succeeds();
    meshmend(&["incremental", &input, "--plot", "/dev/null"]).succeeds();
    meshmend(&["repair", &input, "-o", "/dev/full", "--to", "obj"]).fails(4, "/dev/full");
    meshmend(&["convert", &input, &folder.at("nothing"), "--to", "ply"]).fails(4, "nothing");
}

#[test]
fn what_an_output_names_stands_beside_it_and_no_other_file_is_overwritten() {
    let folder = Folder::new();
    for name in ["in", "out"] {
        fs::create_dir(folder.at(name)).unwrap();
    }
    folder.with("in/a.mtl", "newmtl red\nmap_Kd red.png\n");
    folder.with("in/red.png", "pixels");
    let input = folder.with("in/a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n");
    let names = || {
        let mut names: Vec<String> = fs::read_dir(folder.at("out"))
            .unwrap()
            .map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned())
            .collect();
        names.sort();
        names
    };
    let output = folder.at("out/b.obj");
    assert_eq!(meshmend(&["repair", &input, "-o", &output, "--companions", "skip"]).status, 0);
    assert_eq!(names(), ["b.obj"]);
    // A dry run writes nothing.
    assert_eq!(meshmend(&["repair", &input, "-o", &output, "--dry-run"]).status, 0);
    assert_eq!(names(), ["b.obj"]);
    assert_eq!(meshmend(&["convert", &input, &output]).status, 0);
    assert_eq!(names(), ["a.mtl", "b.obj", "red.png"]);
    assert_eq!(meshmend(&["repair", &input, "-o", &output]).status, 0);
    folder.with("out/red.png", "other pixels");
    folder.with("out/b.obj", "old");
    for command in [&["convert", &input, &output][..], &["repair", &input, "-o", &output]] {
        meshmend(command).fails(4, "`red.png` beside it is another file");
        assert_eq!(fs::read_to_string(&output).unwrap(), "old");
    }
    assert_eq!(fs::read_to_string(folder.at("out/red.png")).unwrap(), "other pixels");
}
