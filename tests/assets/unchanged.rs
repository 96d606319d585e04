//! What is clean comes out to the byte, and no output has an error that its input did not have.

use meshmend_io::Format;
use meshmend_repair::Repaired;
use meshmend_tests::gltf_judges::{inspected, validated};
use meshmend_tests::program;
use meshmend_tests::scratch::Scratch;

use serde_json::Value;

use crate::documents::{document, repaired, scenes, stored, written};

#[test]
fn a_file_in_which_only_seams_were_joined_comes_out_to_the_byte() {
    let Some(scenes) = scenes() else { return };
    let mut same = 0;
    for (entry, bytes, document) in scenes {
        let (result, records) = repaired(&document);
        let joins_alone = |record: &Option<Repaired>| {
            let passes = record.as_ref().map(|record| record.passes.iter().filter(|pass| pass.is_changed));
            passes.is_none_or(|mut passes| passes.all(|pass| pass.pass.name() == "weld"))
        };
        if records.iter().all(joins_alone) {
            assert!(written(&result, document.format) == bytes, "{}", entry.name);
            same += 1;
        }
    }
    assert!(same > 15, "only {same} files are clean");
}

#[test]
fn the_program_copies_a_clean_file() {
    let Some(scenes) = scenes() else { return };
    let clean =
        ["synthetic/solids/cube.glb", "synthetic/assets/cube_split.glb", "real/assimp/BoxTextured.gltf"];
    for (entry, bytes, _) in scenes.iter().filter(|(entry, ..)| clean.contains(&entry.name.as_str())) {
        let scratch = Scratch::new();
        let out = scratch.path().join(entry.path.file_name().unwrap());
        let run = program::run(["repair".as_ref(), entry.path.as_os_str(), "-o".as_ref(), out.as_os_str()]);
        assert!(run.status.success(), "{}: {}", entry.name, String::from_utf8_lossy(&run.stderr));
        assert!(std::fs::read(&out).unwrap() == *bytes, "{}", entry.name);
    }
}

#[test]
fn a_second_repair_changes_no_byte() {
    let Some(scenes) = scenes() else { return };
    for (entry, _, first) in scenes {
        let once = written(&repaired(&first).0, first.format);
        let twice = written(&repaired(&document(&once)).0, first.format);
        assert!(once == twice, "{}", entry.name);
    }
}

#[test]
fn no_output_has_an_error_that_its_input_did_not_have() {
    let Some(scenes) = scenes() else { return };
    let scratch = Scratch::new();
    let mut files = Vec::new();
    let mut names = Vec::new();
    for (number, (entry, bytes, document)) in scenes.iter().enumerate() {
        let (result, _) = repaired(document);
        let suffix = document.format.extensions()[0];
        files.push(stored(scratch.path(), &format!("{number}-in.{suffix}"), bytes));
        for format in [Format::Glb, Format::Gltf] {
            let suffix = format.extensions()[0];
            files.push(stored(scratch.path(), &format!("{number}-out.{suffix}"), &written(&result, format)));
        }
        names.push(&entry.name);
    }
    let Some(answers) = validated(&files) else { return };
    let code = |error: &String| error.split(' ').next().unwrap_or_default().to_owned();
    for (name, answers) in names.iter().zip(answers.chunks(3)) {
        let before: Vec<String> = answers[0].errors.iter().map(code).collect();
        for after in &answers[1..] {
            let new: Vec<&String> =
                after.errors.iter().filter(|error| !before.contains(&code(error))).collect();
            assert!(new.is_empty(), "{name}: {new:?}");
        }
    }
}

/// What stands round the meshes is what it was in the eyes of another program, and the triangles are those of the parts.
#[test]
fn another_program_reads_what_was_mended() {
    let Some(scenes) = scenes() else { return };
    let scratch = Scratch::new();
    let (mut files, mut expected) = (Vec::new(), Vec::new());
    for (number, (entry, bytes, document)) in scenes.iter().enumerate() {
        // Other files stand beside where the input is.
        if bytes.windows(6).any(|text| text == b"\"uri\":") && !bytes.starts_with(b"glTF") {
            continue;
        }
        let (result, _) = repaired(document);
        let suffix = document.format.extensions()[0];
        files.push(stored(scratch.path(), &format!("{number}-in.{suffix}"), bytes));
        files.push(stored(
            scratch.path(),
            &format!("{number}-out.{suffix}"),
            &written(&result, document.format),
        ));
        let corners =
            result.parts.iter().filter(|part| part.seal().is_none()).map(|part| part.mesh.counts().corners);
        expected.push((
            &entry.name,
            result.parts.iter().all(|part| part.seal().is_none()),
            corners.collect::<Vec<_>>(),
        ));
    }
    let Some(answers) = inspected(&files) else { return };
    let mut read = 0;
    for ((name, is_open, corners), answers) in expected.iter().zip(answers.chunks(2)) {
        let [before, after] = [&answers[0], &answers[1]];
        assert_eq!((&before["round"], &before["error"]), (&after["round"], &after["error"]), "{name}");
        let has_faces_alone = before["error"].is_null() && *is_open;
        if has_faces_alone {
            let triangles = after["corners"].as_array().unwrap().iter().filter_map(Value::as_u64);
            assert_eq!(
                triangles.collect::<Vec<_>>(),
                corners.iter().map(|&n| n as u64).collect::<Vec<_>>(),
                "{name}"
            );
            read += 1;
        }
    }
    assert!(read > 15, "only {read} files were read");
}
