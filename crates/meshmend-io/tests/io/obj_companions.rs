//! Material libraries, their images, and what other programs misread: what is left behind is named.

use std::fs;
use std::path::Path;

use crate::common::{Folder, read as read_as, with_mesh};
use meshmend_core::{Carry, Domain, Layer, Values};
use meshmend_io::{
    Companions, Format, Loss, LossKind, NoteKind, ReadFile, ReadOptions, WriteErrorKind, WriteOptions,
    encode, losses, read, write,
};

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n";

/// A folder with an OBJ that has these statements, and with these other files.
fn folder(name: &str, statements: &str, files: &[(&str, &str)]) -> Folder {
    let folder = Folder::new(name);
    for (file, text) in files {
        let path = folder.0.join(file);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }
    fs::write(folder.0.join("a.obj"), format!("{statements}\n{TRIANGLE}")).unwrap();
    folder
}

fn read_in(folder: &Folder) -> ReadFile {
    read(&folder.0.join("a.obj"), &ReadOptions::default()).unwrap()
}

fn notes(file: &ReadFile) -> Vec<(NoteKind, &str)> {
    file.notes.iter().map(|note| (note.kind, &note.message[..])).collect()
}

fn left_behind(file: &ReadFile, path: &Path) -> Vec<String> {
    let options = WriteOptions::default().with_companions(Companions::Skip);
    let losses = losses(&file.mesh, &options.as_read(file).for_path(path));
    let companions = losses.into_iter().filter(|loss| loss.kind == LossKind::Companion);
    companions.map(|loss| format!("{} {}", loss.count, loss.message)).collect()
}

#[test]
fn a_library_or_an_image_that_is_not_there_is_noted() {
    let library = "newmtl red\nmap_Kd red.png\nmap_Bump -bm 0.5 sub\\\\bump.png\nmap_Ks my image.png\n"
        .replace("\\\\", "\\");
    let files = [("a.mtl", &library[..]), ("my lib.mtl", ""), ("sub/bump.png", "x"), ("image.png", "x")];
    let given = folder("missing", "mtllib a.mtl none.mtl\nmtllib my lib.mtl\nmtllib a.mtl", &files);
    let missing = |what: &'static str| (NoteKind::CompanionMissing, what);
    let expected =
        [missing("image `red.png` is not there"), missing("material library `none.mtl` is not there")];
    assert_eq!(notes(&read_in(&given)), expected);
    // A file that is read from memory has no folder.
    assert_eq!(read_as(Format::Obj, format!("mtllib a.mtl\n{TRIANGLE}")).notes, []);
    assert_eq!(read_in(&folder("none", "", &[])).notes, []);
}

#[test]
fn what_is_outside_the_folder_is_not_opened() {
    let given = folder(
        "outside",
        "mtllib /etc/hostname ../x.mtl sub/../../y.mtl . sub\nmtllib in/../a.mtl",
        &[("a.mtl", "map_Kd ../z.png\n")],
    );
    fs::create_dir_all(given.0.join("in")).unwrap();
    fs::create_dir_all(given.0.join("sub")).unwrap();
    let file = read_in(&given);
    let kinds: Vec<NoteKind> = file.notes.iter().map(|note| note.kind).collect();
    let (missing, outside) = (NoteKind::CompanionMissing, NoteKind::CompanionOutside);
    assert_eq!(kinds, [missing, outside, outside, outside, outside, outside], "{:?}", file.notes);
}

#[cfg(unix)]
#[test]
fn a_link_that_leads_out_and_a_pipe_are_not_opened() {
    let other = folder("elsewhere", "", &[("b.mtl", "")]);
    let given = folder("links", "mtllib out.mtl in.mtl", &[("real.mtl", "map_Kd out.png\n")]);
    std::os::unix::fs::symlink(other.0.join("b.mtl"), given.0.join("out.mtl")).unwrap();
    std::os::unix::fs::symlink("real.mtl", given.0.join("in.mtl")).unwrap();
    let file = read_in(&given);
    let expected = [
        (NoteKind::CompanionMissing, "image `out.png` is not there"),
        (
            NoteKind::CompanionOutside,
            "material library `out.mtl` is outside the folder of the file and was not opened",
        ),
    ];
    assert_eq!(notes(&file), expected);
}

#[test]
fn what_is_not_copied_and_what_the_output_does_not_name_is_a_loss() {
    let files = [("a.mtl", "newmtl red\nmap_Kd red.png\n"), ("red.png", "pixels")];
    let given = folder("left", "mtllib a.mtl", &files);
    let other = Folder::new("left-output");
    let file = read_in(&given);
    let none: [&str; 0] = [];
    assert_eq!(left_behind(&file, &given.0.join("b.obj")), none);
    let both = ["2 2 files, which the output names, stay in the folder of the input: `a.mtl`, `red.png`"];
    assert_eq!(left_behind(&file, &other.0.join("b.obj")), both);
    // One that is there already, and one that is another file of that name.
    fs::copy(given.0.join("a.mtl"), other.0.join("a.mtl")).unwrap();
    fs::write(other.0.join("red.png"), "others").unwrap();
    let image = ["1 `red.png`, which the output names, stays in the folder of the input"];
    assert_eq!(left_behind(&file, &other.0.join("b.obj")), image);
    let other_format = ["2 2 files, which the input names and the output does not: `a.mtl`, `red.png`"];
    assert_eq!(left_behind(&file, &given.0.join("b.ply")), other_format);
    // What is missing was noted, and is not lost.
    let missing = read_in(&folder("left-none", "mtllib none.mtl", &[]));
    assert_eq!(left_behind(&missing, &other.0.join("b.obj")), none);
}

#[test]
fn a_colour_has_a_fourth_number_only_where_it_was_read_with_one() {
    let written = |file: &ReadFile, options: &WriteOptions| -> (String, Vec<Loss>) {
        let mut bytes = Vec::new();
        let losses = encode(&file.mesh, options, &mut bytes).unwrap();
        (String::from_utf8(bytes).unwrap(), losses)
    };
    let options = WriteOptions::of(Format::Obj);
    let text = "v 0 0 0 1 1 1 0.5\nv 1 0 0 1 0 0 1\n";
    let file = read_as(Format::Obj, text);
    assert_eq!(written(&file, &options.clone().as_read(&file)), (text.to_owned(), Vec::new()));
    let (bytes, losses) = written(&file, &options);
    assert_eq!(bytes, "v 0 0 0 1 1 1\nv 1 0 0 1 0 0\n");
    let named: Vec<&str> = losses.iter().map(|loss| &loss.message[..]).collect();
    assert_eq!(named, ["the alpha of the colours of 1 vertex: other programs misread it"]);
    // From bytes that are all opaque nothing is lost but the type.
    let bytes = Values::U8(vec![255, 0, 0, 255, 0, 255, 0, 255]);
    let color = Layer::direct("color", Domain::Vertex, 4, Carry::Interpolate, bytes);
    let mesh = file.mesh.clone().with_layers(vec![color]).unwrap();
    let (text, losses) = written(&with_mesh(file, mesh), &options);
    assert_eq!(text, "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\n");
    assert_eq!(losses.iter().map(|loss| loss.kind).collect::<Vec<_>>(), [LossKind::Converted]);
}

/// The files of a folder and those below it, with their content.
fn files(folder: &Path) -> Vec<(String, String)> {
    let mut found = Vec::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(next) = folders.pop() {
        for entry in fs::read_dir(next).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else {
                let name = path.strip_prefix(folder).unwrap().to_string_lossy().into_owned();
                found.push((name, String::from_utf8_lossy(&fs::read(path).unwrap()).into_owned()));
            }
        }
    }
    found.sort();
    found
}

fn names_in(folder: &Path) -> Vec<String> {
    files(folder).into_iter().map(|(name, _)| name).collect()
}

/// A mesh with a library and two maps, one of them in a folder.
fn textured(name: &str) -> Folder {
    let library = "newmtl red\nmap_Kd red.png\nmap_Ks maps\\shine.png\nnewmtl unused\nmap_Kd ../out.png\n";
    folder(name, "mtllib a.mtl", &[("a.mtl", library), ("red.png", "pixels"), ("maps/shine.png", "light")])
}

#[test]
fn what_an_output_names_is_copied_into_its_folder() {
    let (given, other) = (textured("copied"), Folder::new("copied-output"));
    let file = read_in(&given);
    let options = WriteOptions::default().as_read(&file);
    let output = other.0.join("b.obj");
    for _ in 0..2 {
        // The second time all of it is there already.
        assert_eq!(write(&output, &file.mesh, &options).unwrap(), []);
        assert_eq!(names_in(&other.0), ["a.mtl", "b.obj", "maps/shine.png", "red.png"]);
    }
    assert_eq!(fs::read(other.0.join("a.mtl")).unwrap(), fs::read(given.0.join("a.mtl")).unwrap());
    // Into the same folder nothing is copied, and the same file by another way is the same folder.
    let before = names_in(&given.0);
    write(&given.0.join("maps/../b.obj"), &file.mesh, &options).unwrap();
    assert_eq!(names_in(&given.0).len(), before.len() + 1);
    // Asked to skip, or in another format, nothing is copied.
    let skipped = Folder::new("copied-skipped");
    let losses =
        write(&skipped.0.join("b.obj"), &file.mesh, &options.clone().with_companions(Companions::Skip));
    assert_eq!(losses.unwrap()[0].kind, LossKind::Companion);
    write(&skipped.0.join("b.ply"), &file.mesh, &options).unwrap();
    assert_eq!(names_in(&skipped.0), ["b.obj", "b.ply"]);
}

#[test]
fn a_different_file_is_never_overwritten_and_then_nothing_is_written() {
    let (given, other) = (textured("occupied"), Folder::new("occupied-output"));
    let file = read_in(&given);
    fs::create_dir(other.0.join("maps")).unwrap();
    fs::write(other.0.join("maps/shine.png"), "other").unwrap();
    fs::write(other.0.join("b.obj"), "old").unwrap();
    let before = files(&other.0);
    let error =
        write(&other.0.join("b.obj"), &file.mesh, &WriteOptions::default().as_read(&file)).unwrap_err();
    assert!(matches!(&error.kind, WriteErrorKind::Occupied { name } if name == "maps\\shine.png"), "{error}");
    assert_eq!(files(&other.0), before);
}

#[cfg(unix)]
#[test]
fn no_link_leads_a_copy_out_of_the_folder_of_the_output() {
    let (given, other, away) = (textured("led"), Folder::new("led-output"), Folder::new("led-away"));
    let file = read_in(&given);
    let options = WriteOptions::default().as_read(&file);
    std::os::unix::fs::symlink(&away.0, other.0.join("maps")).unwrap();
    let error = write(&other.0.join("b.obj"), &file.mesh, &options).unwrap_err();
    assert!(matches!(&error.kind, WriteErrorKind::Occupied { .. }), "{error}");
    // A link under the very name is not followed either, not even to nothing.
    fs::remove_file(other.0.join("maps")).unwrap();
    std::os::unix::fs::symlink(away.0.join("x.png"), other.0.join("red.png")).unwrap();
    assert!(write(&other.0.join("b.obj"), &file.mesh, &options).is_err());
    assert_eq!((names_in(&away.0).len(), other.0.join("b.obj").exists()), (0, false));
    // A device has nothing beside it.
    write(Path::new("/dev/null"), &file.mesh, &WriteOptions::of(Format::Obj).as_read(&file)).unwrap();
    assert!(!Path::new("/dev/a.mtl").exists());
}
