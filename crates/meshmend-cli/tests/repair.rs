//! `meshmend repair`, as a user runs it.

mod common;

use std::fs;

use common::{Folder, example, group, meshmend};
use serde_json::{Value, json};

const OPEN: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

#[test]
fn a_broken_mesh_is_mended_and_all_is_named() {
    let folder = Folder::new();
    let output = folder.at("mended.obj");
    let run = meshmend(&["repair", &example("broken.obj"), "-o", &output]).succeeds();
    for line in [
        "21 → 16 vertices, 13 → 12 faces, faces removed: 1, faces flipped: 1",
        "clean       duplicate faces: 1  [Δχ -1, Δs 0, Δb –]",
        "f6 by clean: duplicate-face",
        "compact     unreferenced vertices: 1",
        "2 × sphere",
    ] {
        assert!(run.stdout.contains(line), "{line}\n{}", run.stdout);
    }
    let text = fs::read_to_string(&output).unwrap();
    let count = |start: &str| text.lines().filter(|line| line.starts_with(start)).count();
    assert_eq!((count("v "), count("vt "), count("f ")), (16, 4, 12));
    assert!(text.contains("usemtl red") && text.contains("usemtl blue") && text.contains("mtllib paint.mtl"));
    meshmend(&["check", &output]).succeeds();
    assert_eq!(folder.names(), ["mended.obj"]);
}

#[test]
fn the_json_report_has_before_after_and_every_pass() {
    let folder = Folder::new();
    let (input, output) = (example("broken.obj"), folder.at("mended.ply"));
    // Vertices split for texture coordinates are another mesh by index than the one that is reported on.
    let arguments = ["repair", &input, "-o", &output, "--json", "--report-maps", "--seams", "corners"];
    let run = meshmend(&arguments).succeeds();
    assert_eq!(run.stdout, meshmend(&arguments).stdout);
    let report = run.json();
    assert_eq!(report.to_string() + "\n", run.stdout, "a sorted map gives the same text");
    assert_eq!((&report["schema"], &report["before"]["file"]), (&json!(2), &json!(input)));
    assert_eq!((&report["before"]["manifold"], &report["after"]["manifold"]), (&json!(false), &json!(true)));
    assert_eq!(report["after"]["file"], output.as_str());
    let passes: Vec<&Value> = report["passes"].as_array().unwrap().iter().map(|pass| &pass["pass"]).collect();
    assert_eq!(passes, ["weld", "clean", "orient", "split", "triangulate", "compact", "verify"]);
    let weld = &report["passes"][0];
    assert_eq!(weld["changed"], true);
    assert_eq!(weld["mended"]["coincident-vertex"]["count"], 6);
    assert_eq!(weld["delta"], json!({"euler_characteristic": -1, "components": -2, "boundary_loops": null}));
    let gone = json!([{"face": 6, "pass": "clean", "reason": "duplicate-face"}]);
    assert_eq!(report["removed_faces"]["items"], gone);
    assert_eq!(report["removed_faces"]["by_reason"], json!({"duplicate-face": 1}));
    let maps = &report["provenance"];
    assert_eq!(maps["vertex_sources"].as_array().unwrap().len(), 16);
    assert_eq!(maps["face_sources"], json!([0, 1, 2, 3, 4, 5, 7, 8, 9, 10, 11, 12]));
    assert_eq!(maps["flipped"], json!([1]));
    let checked = meshmend(&["check", "--json", &output]).succeeds().json();
    assert_eq!(checked["format"], report["after"]["format"]);
    assert_eq!(checked["betti"], report["after"]["betti"]);
}

#[test]
fn a_report_file_has_the_bytes_that_are_printed() {
    let folder = Folder::new();
    let (output, report) = (folder.at("out.off"), folder.at("report.json"));
    let arguments = ["repair", &example("pinched.ply"), "-o", &output, "--json", "--report", &report];
    let run = meshmend(&arguments).succeeds();
    assert_eq!(fs::read_to_string(&report).unwrap(), run.stdout);
    assert_eq!(folder.names(), ["out.off", "report.json"]);
}

#[test]
fn a_report_that_cant_be_written_leaves_no_mesh() {
    let folder = Folder::new();
    let (input, output) = (example("pinched.ply"), folder.at("out.off"));
    let report = folder.at("missing/report.json");
    meshmend(&["repair", &input, "-o", &output, "--report", &report]).fails(4, "report.json");
    assert!(folder.names().is_empty());
    let both = folder.at("mesh.obj");
    meshmend(&["repair", &input, "-o", &both, "--report", &both]).fails(2, "overwrite");
    let input = folder.with("in.obj", OPEN);
    meshmend(&["repair", &input, "--dry-run", "--report", &input]).fails(2, "overwrite");
    assert_eq!(fs::read_to_string(&input).unwrap(), OPEN);
    meshmend(&["repair", &input, "--dry-run", "--report-maps"]).fails(2, "--report-maps");
}

#[test]
fn input_and_output_may_be_one_file_and_twice_is_once() {
    let folder = Folder::new();
    let file = folder.with("mesh.obj", &fs::read_to_string(example("broken.obj")).unwrap());
    meshmend(&["repair", &file, "-o", &file]).succeeds();
    let once = fs::read(&file).unwrap();
    let again = meshmend(&["repair", &file, "-o", &file]).succeeds();
    assert_eq!(fs::read(&file).unwrap(), once);
    assert!(again.stdout.contains("faces, 12 → 12") || again.stdout.contains("12 → 12 faces"));
    assert_eq!(folder.names(), ["mesh.obj"]);
}

#[test]
fn a_dry_run_writes_nothing() {
    let folder = Folder::new();
    let run = meshmend(&["repair", &example("broken.obj"), "--dry-run"]).succeeds();
    assert!(run.stdout.contains("nothing written: 21 → 16 vertices"), "{}", run.stdout);
    let target = folder.at("out.stl");
    let report =
        meshmend(&["repair", &example("broken.obj"), "-o", &target, "--dry-run", "--json"]).succeeds();
    assert!(folder.names().is_empty());
    assert_eq!(report.json()["output"], Value::Null);
    assert!(!report.json()["losses"].as_array().unwrap().is_empty());
    meshmend(&["repair", &example("broken.obj")]).fails(2, "--output");
}

#[test]
fn a_plan_is_followed_and_options_override_it() {
    let folder = Folder::new();
    let (band, out) = (example("moebius.off"), folder.at("out.off"));
    let repaired = |options: &[&str]| {
        meshmend(&[&["repair", &band, "-o", &out, "--json"], options].concat()).succeeds().json()
    };
    let usual = repaired(&[]);
    assert_eq!(usual["after"]["orientable"], false);
    assert_eq!(usual["passes"][2]["left"]["non-orientable-patch"]["count"], 1);
    let plan = example("plan.toml");
    let cut = repaired(&["--plan", &plan]);
    assert_eq!(
        (&cut["after"]["orientable"], &cut["after"]["consistently_oriented"]),
        (&json!(true), &json!(true))
    );
    assert_eq!(cut["after"]["component_kinds"][0]["name"], "disc");
    let passes: Vec<&Value> = cut["passes"].as_array().unwrap().iter().map(|pass| &pass["pass"]).collect();
    assert_eq!(passes, ["weld", "clean", "orient", "split", "orient", "compact", "verify"]);
    let overridden = repaired(&["--plan", &plan, "--non-orientable", "report", "--triangulate", "all"]);
    assert_eq!(overridden["after"]["orientable"], false);
    assert_eq!(
        (&overridden["passes"][5]["pass"], &overridden["after"]["faces"]),
        (&json!("triangulate"), &json!(16))
    );
}

#[test]
fn a_bad_plan_is_a_usage_error_with_its_line() {
    let folder = Folder::new();
    let out = folder.at("out.off");
    let plan = folder.with("plan.toml", "passes = [\"weld\"]\n\n[weld]\ndistnace = \"exact\"\n");
    meshmend(&["repair", &example("soup.stl"), "-o", &out, "--plan", &plan]).fails(2, "line 4");
    meshmend(&["repair", &example("soup.stl"), "-o", &out, "--plan", &folder.at("none")]).fails(2, "none");
    meshmend(&["repair", &example("soup.stl"), "-o", &out, "--orient", "off", "--duplicates", "keep"])
        .fails(2, "--orient off");
    assert_eq!(folder.names(), ["plan.toml"]);
}

#[test]
fn a_policy_that_says_fail_leaves_the_old_output() {
    let folder = Folder::new();
    let out = folder.with("out.off", "old");
    let band = example("moebius.off");
    meshmend(&["repair", &band, "-o", &out, "--non-orientable", "fail"]).fails(5, "non-orientable patches");
    let nan = folder.with("nan.off", "OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n");
    meshmend(&["repair", &nan, "-o", &out, "--non-finite", "fail"]).fails(5, "nan.off");
    meshmend(&["repair", &example("pinched.ply"), "-o", &out, "--kernel", "half-edge"])
        .fails(5, "pinched vertices");
    assert_eq!(fs::read_to_string(&out).unwrap(), "old");
    assert_eq!(folder.names(), ["nan.off", "out.off"]);
}

#[test]
fn an_input_that_cant_be_read_leaves_no_output() {
    let folder = Folder::new();
    let out = folder.at("out.off");
    let wrong = folder.with("wrong.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n");
    let run = meshmend(&["repair", &wrong, "-o", &out]).fails(3, ":6: ");
    assert_eq!((run.stdout.as_str(), run.stderr.lines().count()), ("", 1));
    for name in ["scene.fbx", "scene.obj", "part.3mf"] {
        let foreign = folder.with(name, "Kaydara FBX Binary");
        meshmend(&["repair", &foreign, "-o", &out]).fails(3, "looks like binary FBX");
    }
    assert!(!folder.names().contains(&"out.off".to_owned()));
}

#[test]
fn an_output_that_cant_be_written_is_told_from_one_that_makes_no_sense() {
    let folder = Folder::new();
    let input = folder.with("in.obj", OPEN);
    meshmend(&["repair", &folder.at("missing.obj"), "-o", "out.xyz"]).fails(2, "out.xyz");
    let odd = folder.at("out.off");
    meshmend(&["repair", &input, "-o", &odd, "--encoding", "binary"]).fails(2, "no such encoding");
    meshmend(&["repair", &input, "-o", &folder.at("missing/out.off")]).fails(4, "out.off");
    meshmend(&["repair", &input, "-o", &folder.at("")]).fails(2, "format");
    assert_eq!(folder.names(), ["in.obj"]);
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_an_error() {
    if fs::metadata("/dev/full").is_ok() {
        meshmend(&["repair", &example("soup.stl"), "-o", "/dev/full", "--to", "off"]).fails(4, "/dev/full");
    }
}

#[test]
fn formats_and_encodings_can_be_chosen() {
    let folder = Folder::new();
    for (options, variant) in [
        (["--encoding", "ascii"].as_slice(), "ply-ascii"),
        (&["--encoding", "le"], "ply-le"),
        (&["--encoding", "big-endian"], "ply-be"),
    ] {
        let out = folder.at("out.ply");
        let report =
            meshmend(&[&["repair", &example("soup.stl"), "-o", &out, "--json"], options].concat()).json();
        assert_eq!(report["after"]["format"], variant);
        assert_eq!(meshmend(&["check", "--json", &out]).json()["format"], variant);
    }
    let out = folder.at("unnamed");
    meshmend(&["repair", &example("soup.stl"), "-o", &out, "--to", "obj"]).succeeds();
    assert!(fs::read_to_string(&out).unwrap().contains("f 1 2 3"));
}

#[test]
fn an_empty_result_is_announced() {
    let folder = Folder::new();
    let out = folder.at("out.off");
    let slivers = folder.with("slivers.obj", "v 0 0 0\nv 1 0 0\nv 0 0 0\nf 1 2 3\n");
    let run = meshmend(&["repair", &slivers, "-o", &out, "--allow-empty"]).succeeds();
    assert!(run.stdout.contains("the result is empty: no face is left"), "{}", run.stdout);
    assert!(run.stdout.contains("f0 by clean: degenerate-face"), "{}", run.stdout);
    assert_eq!(fs::read_to_string(&out).unwrap(), "OFF\n0 0 0\n");
}

#[test]
fn quiet_is_one_line_that_hides_no_loss() {
    let folder = Folder::new();
    let out = folder.at("out.stl");
    let run = meshmend(&["repair", "-q", &example("broken.obj"), "-o", &out]).succeeds();
    assert_eq!(run.stdout.lines().count(), 1);
    assert!(run.stdout.contains("faces removed: 1") && run.stdout.contains("losses in the output"));
    let report = meshmend(&["repair", "-q", "--json", &example("broken.obj"), "-o", &out]).succeeds().json();
    assert_eq!((&report["before"], &report["passes"][0]["delta"]), (&Value::Null, &Value::Null));
    assert_eq!(report["after"]["manifold"], true);
}

#[test]
fn loose_elements_go_by_name_or_stay_when_asked() {
    let folder = Folder::new();
    let input = folder.with("loose.obj", &format!("{OPEN}v 5 5 5\nv 6 6 6\nl 4 5\n"));
    let out = folder.at("out.obj");
    let report = meshmend(&["repair", &input, "-o", &out, "--json"]).succeeds().json();
    assert_eq!(report["passes"][5]["mended"]["loose-edge"]["items"][0]["ends"], json!([3, 4]));
    assert_eq!(report["stored"]["after"]["loose_edges"], 0);
    meshmend(&["repair", &input, "-o", &out, "--compact", "keep-loose"]).succeeds();
    assert!(fs::read_to_string(&out).unwrap().contains("l 4 5"));
}

#[test]
fn threads_and_kernels_make_no_difference() {
    let folder = Folder::new();
    let result = |options: &[&str]| {
        let out = folder.at("out.obj");
        meshmend(&[&["repair", &example("broken.obj"), "-o", &out], options].concat()).succeeds();
        fs::read(out).unwrap()
    };
    let usual = result(&[]);
    for options in
        [["--threads", "1"], ["--threads", "3"], ["--kernel", "face-vertex"], ["--kernel", "adjacency-lists"]]
    {
        assert_eq!(result(&options), usual, "{options:?}");
    }
    assert_eq!(meshmend(&["repair", "--threads", "0", "a.obj", "--dry-run"]).status, 2);
}

#[test]
fn what_is_left_has_its_place() {
    let report = meshmend(&["repair", &example("moebius.off"), "--dry-run", "--json"]).succeeds().json();
    let strip = &group(&report["after"], "non-orientable-patch")["items"][0];
    assert_eq!(
        (strip["faces"].as_array().unwrap().len(), strip["positions"].as_array().unwrap().len()),
        (8, 8)
    );
    assert_eq!(strip["edge_ends"][0].as_array().unwrap().len(), 2);
}

#[test]
fn a_report_that_can_not_be_written_leaves_no_mesh() {
    let folder = Folder::new();
    let output = folder.at("mended.obj");
    if !std::path::Path::new("/dev/full").exists() {
        println!("skipped: there is no /dev/full");
        return;
    }
    meshmend(&["repair", &example("broken.obj"), "-o", &output, "--report", "/dev/full"])
        .fails(4, "/dev/full");
    assert!(folder.names().is_empty());
}

/// A pyramid on a concave base: a fan from the base's first corner would leave the base and repeat an edge.
#[test]
fn polygons_are_cut_by_the_pass_where_the_format_holds_triangles_alone() {
    let folder = Folder::new();
    let input = folder.at("dart.obj");
    let points = "v 2 2 0\nv 0 1 0\nv -2 2 0\nv 0 0 0\nv 0 1 3\n";
    fs::write(&input, format!("{points}f 1 2 3 4\nf 2 1 5\nf 3 2 5\nf 4 3 5\nf 1 4 5\n")).unwrap();
    let run = meshmend(&["repair", &input, "-o", &folder.at("dart.stl"), "--json"]).succeeds().json();
    assert_eq!(run["passes"][4]["mended"]["polygon-face"]["count"], 1);
    assert_eq!(run["losses"], json!([]));
    let told = meshmend(&["repair", &input, "-o", &folder.at("told.stl"), "--triangulate", "off", "--json"]);
    assert_eq!(told.succeeds().json()["losses"][0]["kind"], "polygons");
    let kept = meshmend(&["repair", &input, "-o", &folder.at("dart.ply"), "--json"]).succeeds().json();
    assert_eq!(kept["passes"][4]["changed"], false);
}

/// Two triangles that touch along an edge, red and blue.
const SEAM: &str = "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\nv 1 0 0 0 0 1\nv 1 1 0 0 0 1\nv 0 1 0 0 0 1\n\
                    v 0 0 9 1 0 0\nf 1 2 3\nf 4 5 6\n";

#[test]
fn vertices_that_are_written_as_several_are_named_with_what_to_do_about_it() {
    let folder = Folder::new();
    let (input, output) = (folder.with("seam.obj", SEAM), folder.at("seam.ply"));
    let run = meshmend(&["repair", &input, "-o", &output]).succeeds();
    assert!(run.stdout.contains("2 vertices are written 4 times"), "{}", run.stdout);
    assert!(run.stdout.contains("--seams corners"), "{}", run.stdout);
    let json = meshmend(&["repair", &input, "-o", &output, "--json"]).succeeds().json();
    let is_seam = |loss: &&Value| loss["kind"] == "seam-vertices";
    assert_eq!(json["losses"].as_array().unwrap().iter().find(is_seam).unwrap()["count"], 2);
    let again = folder.at("again.ply");
    meshmend(&["repair", &output, "-o", &again]).succeeds();
    assert_eq!(fs::read(&output).unwrap(), fs::read(&again).unwrap());
    let corners = meshmend(&["repair", &input, "-o", &output, "--seams", "corners"]).succeeds();
    assert!(!corners.stdout.contains("are written"), "{}", corners.stdout);
    meshmend(&["repair", &input, "-o", &output, "--seams", "fail"]).fails(5, "2 vertices have attributes");
    meshmend(&["convert", &input, &output, "--seams", "fail"]).succeeds();
}

#[test]
fn normals_turn_with_their_faces_unless_the_policy_says_otherwise() {
    let folder = Folder::new();
    let turned = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nv 3 0 0\nv 3 1 0\nvn 0 0 1\nvn 0 0 -1\n\
                  f 1//1 2//1 3//1 4//1\nf 2//1 5//1 6//1 3//1\nf 5//2 6//2 8//2 7//2\n";
    let (input, output) = (folder.with("turned.obj", turned), folder.at("mended.obj"));
    let run = meshmend(&["repair", &input, "-o", &output]).succeeds();
    assert!(run.stdout.contains("normals turned with their faces: 4"), "{}", run.stdout);
    assert!(fs::read_to_string(&output).unwrap().contains("f 5//3 7//3 8//3 6//3\n"));
    let json = meshmend(&["repair", &output, "-o", &folder.at("again.obj"), "--json"]).succeeds().json();
    assert_eq!((&json["turned_normals"], &json["flipped_faces"]["count"]), (&json!(0), &json!(0)));
    let json = meshmend(&["repair", &input, "-o", &output, "--json", "--flipped-normals", "keep"]).json();
    assert_eq!((&json["turned_normals"], &json["flipped_faces"]["count"]), (&json!(0), &json!(1)));
    let plan = folder.with("plan.toml", "[orient]\nflipped-normals = \"keep\"\n");
    let json = meshmend(&["repair", &input, "-o", &output, "--json", "--plan", &plan]).json();
    assert_eq!(json["turned_normals"], 0);
}

#[test]
fn a_file_of_the_same_format_is_written_as_it_was_read() {
    let folder = Folder::new();
    let text = "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n\
                element face 1\nproperty list uint8 uint vertex_index\nelement camera 1\nproperty float yaw\nend_header\n\
                0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n0.5\n";
    let (input, output) = (folder.with("in.ply", text), folder.at("out.ply"));
    let written = text.replace("uint8", "uchar");
    for command in [&["convert", &input, &output][..], &["repair", &input, "-o", &output]] {
        meshmend(command).succeeds();
        assert_eq!(fs::read_to_string(&output).unwrap(), written);
    }
    let run = meshmend(&["convert", &input, &folder.at("out.obj")]).succeeds();
    assert!(run.stdout.contains("element `camera` of 1 row"), "{}", run.stdout);
}

/// The library repairs files as the program does, and says the same of it.
#[test]
fn the_report_of_the_library_is_that_of_the_program_to_the_byte() {
    use meshmend::files::{FileRepair, FileTarget};
    use meshmend::mesh::Watch;
    use meshmend::{ReadOptions, WriteOptions};

    for (name, suffix) in [("broken.obj", "ply"), ("soup.stl", "obj"), ("box.glb", "glb"), ("box.glb", "stl")]
    {
        let folder = Folder::new();
        let (input, output) = (example(name), folder.at(&format!("mended.{suffix}")));
        let printed = meshmend(&["repair", &input, "-o", &output, "--json"]).succeeds().stdout;
        let written = fs::read(&output).unwrap();
        let document = meshmend::formats::read_document(input.as_ref(), &ReadOptions::default()).unwrap();
        let options = WriteOptions::default().with_shell(document.shell.clone()).for_path(output.as_ref());
        let target = FileTarget::new(output, options);
        let repaired = FileRepair::default().run(&input, document, Some(&target), &Watch::NOBODY).unwrap();
        assert_eq!(repaired.report_json().unwrap() + "\n", printed);
        let mut bytes = Vec::new();
        repaired.prepared().unwrap().encode(&mut bytes).unwrap();
        assert!(bytes == written, "{name} as {suffix}");
    }
}
