//! `repair --maps`: where each element came from, as arrays.

mod common;

use std::process::Command;

use common::{Folder, example, json_file as read, meshmend};
use serde_json::{Value, json};

const SQUARE: &str =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 9 9 9\nf 1 2 3\nf 4 5 6\nf 1 1 2\nf 2 3 1\n";

#[test]
fn maps_are_written_as_json() {
    let folder = Folder::new();
    let (input, output, maps) = (folder.with("a.obj", SQUARE), folder.at("b.obj"), folder.at("maps.json"));
    meshmend(&["repair", &input, "-o", &output, "--maps", &maps]).succeeds();
    let maps = read(&maps);
    assert_eq!(maps["vertices_new_to_old"], json!([0, 1, 2, 5]));
    assert_eq!(maps["vertices_old_to_new_starts"], json!([0, 1, 2, 3, 4, 5, 6, 6]));
    assert_eq!(maps["vertices_old_to_new_items"], json!([0, 1, 2, 1, 2, 3]));
    assert_eq!(maps["faces_new_to_old"], json!([0, 1]));
    let cause = |kind: &str| -> Vec<&str> {
        let causes = maps[kind].as_array().unwrap().iter();
        causes.map(|cause| maps["causes"][cause.as_u64().unwrap() as usize].as_str().unwrap()).collect()
    };
    assert_eq!(cause("cause_old_face"), ["kept", "kept", "degenerate", "repeated-same"]);
    assert_eq!(cause("cause_old_vertex")[3..], ["welded", "welded", "kept", "compacted"]);
    assert_eq!(cause("cause_old_corner").len(), 12);
    assert_eq!((&maps["created_vertices"], &maps["created_from"]), (&json!([]), &json!([])));
}

#[test]
fn created_vertices_say_where_they_lie() {
    let folder = Folder::new();
    let (output, maps) = (folder.at("b.obj"), folder.at("maps.json"));
    let band = example("moebius.off");
    meshmend(&["repair", &band, "-o", &output, "--maps", &maps, "--non-orientable", "cut"]).succeeds();
    let maps = read(&maps);
    let created =
        maps["vertices_new_to_old"].as_array().unwrap().iter().filter(|old| **old == json!(-1)).count();
    for key in ["created_vertices", "created_from", "created_in_face"] {
        assert_eq!(maps[key].as_array().unwrap().len(), created, "{key}");
    }
    assert!(maps["created_from"].as_array().unwrap().iter().all(|row| row.as_array().unwrap().len() == 4));
}

#[test]
fn parts_have_maps_of_their_own() {
    let folder = Folder::new();
    let (two, output, maps) = (folder.at("two.glb"), folder.at("out.glb"), folder.at("maps.json"));
    let solids =
        "o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no b\nv 0 0 5\nv 1 0 5\nv 0 1 5\nf 4 5 6\nf 4 5 6\n";
    meshmend(&["convert", &folder.with("two.obj", solids), &two]).succeeds();
    meshmend(&["repair", &two, "-o", &output, "--maps", &maps]).succeeds();
    let maps = read(&maps);
    assert_eq!(
        (&maps["part0/faces_new_to_old"], &maps["part1/cause_old_face"]),
        (&json!([0]), &json!([0, 6]))
    );
    assert_eq!(maps["causes"][6], "repeated-same");
}

#[test]
fn numpy_reads_the_arrays() {
    let python = "import sys, json, numpy as np\n\
                  f = np.load(sys.argv[1], allow_pickle=False)\n\
                  print(json.dumps({k: [str(f[k].dtype), list(f[k].shape), f[k].tolist()] for k in f.files}))";
    let has_numpy =
        Command::new("python3").args(["-c", "import numpy"]).output().is_ok_and(|run| run.status.success());
    if !has_numpy {
        eprintln!("skipped: there is no python3 with numpy");
        return;
    }
    let folder = Folder::new();
    let (output, maps, same) = (folder.at("b.obj"), folder.at("maps.npz"), folder.at("maps.json"));
    let band = example("moebius.off");
    for maps in [&maps, &same] {
        meshmend(&["repair", &band, "-o", &output, "--maps", maps, "--non-orientable", "cut"]).succeeds();
    }
    let run = Command::new("python3").args(["-c", python, &maps]).output().unwrap();
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    let read_back: Value = serde_json::from_slice(&run.stdout).unwrap();
    let same = read(&same);
    let (read_back, same) = (read_back.as_object().unwrap(), same.as_object().unwrap());
    assert_eq!(read_back.keys().collect::<Vec<_>>(), same.keys().collect::<Vec<_>>());
    for (name, array) in read_back {
        assert_eq!(array[2], same[name], "{name}");
        let kind = match name.as_str() {
            "causes" => "<U17",
            "faces_flipped" => "uint8",
            name if name.starts_with("cause_") => "uint8",
            _ => "int64",
        };
        assert_eq!(array[0], kind, "{name}");
    }
}

#[test]
fn maps_are_written_with_the_mesh_or_not_at_all() {
    let folder = Folder::new();
    let (input, output) = (folder.with("a.obj", SQUARE), folder.at("b.obj"));
    let repair = |maps: &str| meshmend(&["repair", &input, "-o", &output, "--maps", maps]);
    repair(&folder.at("maps.txt")).fails(2, ".npz or .json");
    repair("-").fails(2, "--maps writes a file");
    repair(&input).fails(2, "a.obj");
    repair(&folder.at("none/maps.json")).fails(4, "maps.json");
    assert_eq!(folder.names(), ["a.obj"]);
    let maps = folder.at("maps.npz");
    meshmend(&["repair", &input, "--dry-run", "--maps", &maps]).succeeds();
    assert_eq!(folder.names(), ["a.obj", "maps.npz"]);
}
