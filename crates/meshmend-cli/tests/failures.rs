//! Every way in which a command ends without having done its work: its exit status, and what it says.

mod common;

use common::{Folder, example, meshmend};

#[test]
fn every_status_comes_with_its_reason() {
    let folder = Folder::new();
    let (broken, pinched, band) = (example("broken.obj"), example("pinched.ply"), example("moebius.off"));
    let (out, lost, nameless) = (folder.at("out.obj"), folder.at("missing/out.obj"), folder.at("out.xyz"));
    let no_distance = folder.with("no_distance.toml", "[weld]\ndistance = { absolute = -1 }\n");
    let no_plan = folder.with("no_plan.toml", "[weld]\ndistnace = \"exact\"\n");
    let endless = folder.with("endless.toml", &" ".repeat(1 << 20));
    let cut_off = folder.with("cut_off.obj", "v 0 0 0\nf 1 2 3\n");
    let repair = |options: &[&str]| meshmend(&[&["repair", &broken, "-o", &out], options].concat());

    meshmend(&["check", &broken]).fails(1, "");
    meshmend(&["mend"]).fails(2, "unrecognized subcommand 'mend'");
    repair(&["--weld", "near"]).fails(2, "expected none, exact, single, auto, a length");
    repair(&["--clean", "off", "--non-finite", "fail"])
        .fails(2, "--non-finite has no meaning with --clean off");
    repair(&["--plan", &no_plan]).fails(2, "unknown field `distnace`");
    repair(&["--plan", &folder.at("missing.toml")]).fails(2, "missing.toml: ");
    repair(&["--plan", &endless]).fails(2, "endless.toml: too long for a plan");
    repair(&["--plan", &no_distance])
        .fails(2, "weld: a tolerance must be a finite number of 0 or more, not -1");
    meshmend(&["convert", &broken, &nameless]).fails(2, "out.xyz: the name tells no format");
    meshmend(&["convert", &broken, &out, "--encoding", "binary"]).fails(2, "OBJ has no such encoding");
    meshmend(&["check", &folder.at("missing.obj")]).fails(3, "missing.obj: ");
    meshmend(&["check", &cut_off]).fails(3, "cut_off.obj:2: vertex 3 does not exist");
    meshmend(&["convert", &broken, &lost]).fails(4, "out.obj: ");
    meshmend(&["repair", &pinched, "--kernel", "half-edge", "-o", &out])
        .fails(5, "half-edge kernel can't hold");
    meshmend(&["repair", &band, "--non-orientable", "fail", "-o", &out])
        .fails(5, "orient: the policy is `fail`, and the mesh has non-orientable patches: 1 (");
    assert!(!folder.names().contains(&"out.obj".to_owned()), "what fails writes nothing");
}
