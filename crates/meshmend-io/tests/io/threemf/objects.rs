//! Objects: their meshes, attributes, components and places.

use super::*;
use crate::common::{faces, layer, names};
use meshmend_core::{Domain, Layer, Values};
use meshmend_io::{NoteKind, ObjectKind, Part, PartSource, Placing};

fn values(layer: &Layer) -> Vec<Option<u32>> {
    let Values::U32(pool) = layer.values() else { panic!("no numbers") };
    (0..layer.element_count()).map(|element| layer.value_of(element).map(|value| pool[value])).collect()
}

fn parts_of(resources: &str) -> Vec<Part> {
    document(&package(resources)).parts
}

#[test]
fn an_object_is_a_part_with_the_rows_of_its_mesh() {
    let parts = parts_of(&tetrahedron("name=\"A &amp; B\" type=\"model\"", ""));
    let [part] = &parts[..] else { panic!("{parts:?}") };
    assert_eq!(part.name, b"A & B");
    assert_eq!(
        part.source,
        PartSource::ThreeMfObject { entry: "3D/3dmodel.model".into(), id: 1, kind: ObjectKind::Model }
    );
    assert_eq!(part.seal(), None);
    assert_eq!(part.mesh.positions(), [[0.0; 3], [1.5, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
    assert_eq!(faces(&part.mesh), [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    let some = |count: u32| (0..count).map(Some).collect::<Vec<_>>();
    assert_eq!(values(layer(&part.mesh, "row", Domain::Vertex)), some(4));
    assert_eq!(values(layer(&part.mesh, "row", Domain::Face)), some(4));
    assert_eq!(part.mesh.layers().len(), 2);
}

#[test]
fn properties_have_the_defaults_of_their_object() {
    let materials = "<basematerials id=\"5\"><base name=\"Steel\" displaycolor=\"#fff\"/><base name=\"Glass\"/></basematerials>\n\
                     <m:colorgroup id=\"6\"><m:color color=\"#fff\"/></m:colorgroup>";
    let with = |attributes: &str, from: &str, to: &str| {
        let object = tetrahedron(attributes, "").replacen(from, to, 1);
        parts_of(&format!("{materials}{object}")).remove(0).mesh
    };
    // One triangle has a group of its own, and one member of it for all corners.
    let mesh = with("", "paint_color", "pid=\"6\" p1=\"3\" paint_color");
    assert_eq!(values(layer(&mesh, "pid", Domain::Face)), [Some(6), None, None, None]);
    let members = values(layer(&mesh, "property", Domain::Corner));
    assert_eq!((&members[..3], members[3..].iter().flatten().count()), (&[Some(3); 3][..], 0));
    assert!(mesh.layer("material", Domain::Face).is_none());
    // The object has a default, one triangle a member of it, and the second corner another one.
    let mesh = with("pid=\"5\" pindex=\"1\"", "paint_color", "p1=\"0\" p2=\"1\" paint_color");
    assert_eq!(values(layer(&mesh, "pid", Domain::Face)), [Some(5); 4]);
    let members = values(layer(&mesh, "property", Domain::Corner));
    assert_eq!(&members[..6], [Some(0), Some(1), Some(0), Some(1), Some(1), Some(1)]);
    let glass = Some("Glass".to_owned());
    let of_faces = names(layer(&mesh, "material", Domain::Face));
    assert_eq!(of_faces, [Some("Steel".to_owned()), glass.clone(), glass.clone(), glass]);
    // Members and groups that do not exist are no material.
    let mesh = with("pid=\"5\" pindex=\"9\"", "paint_color", "pid=\"77\" paint_color");
    assert!(mesh.layer("material", Domain::Face).is_none());
    assert_eq!(values(layer(&mesh, "pid", Domain::Face))[0], Some(77));
}

#[test]
fn rows_that_say_too_little_are_refused_at_their_object() {
    for (from, to, reason) in [
        ("x=\"0\" y=\"0.0\"", "y=\"0.0\"", "vertex 0: `x` is missing"),
        ("z=\"0e0\"", "", "vertex 0: `z` is missing"),
        ("z=\"0e0\"", "z=\"zero\"", "vertex 0: `z` is no number: `zero`"),
        ("z=\"0e0\"", "z=\"1 2\"", "vertex 0: `z` is no number: `1 2`"),
        ("z=\"0e0\"", "z=\"\"", "vertex 0: `z` is no number: ``"),
        ("z=\"0e0\"", "z=\"1\" z=\"1\"", "vertex 0: `z` stands twice"),
        ("z=\"0e0\"", "z", "vertex 0: what stands there are no attributes"),
        ("v3=\"1\"", "", "triangle 0: `v3` is missing"),
        ("v3=\"1\"", "v3=\"-1\"", "triangle 0: `v3` is no number: `-1`"),
        ("v3=\"1\"", "v3=\"1.0\"", "triangle 0: `v3` is no number: `1.0`"),
        ("v3=\"1\"", "v3=\"4294967295\"", "triangle 0: `v3` is no number: `4294967295`"),
        ("v3=\"1\"", "v3=\"4\"", "triangle 0: vertex 4 does not exist: the object has 4 vertices"),
        ("v3=\"1\"", "v3=\"1\" p1=\"x\"", "triangle 0: `p1` is no number: `x`"),
        ("</mesh>", "<vertices/></mesh>", "`vertices` stands twice"),
        ("</mesh>", "</mesh><components/>", "the object has more than one content"),
    ] {
        let found = refused(&package(&tetrahedron("", "").replacen(from, to, 1)));
        assert_eq!(found, format!("test.3mf: 3D/3dmodel.model#1: {reason}"));
    }
    for (from, to, reason) in [
        ("id=\"1\"", "", "an object without an id"),
        ("id=\"1\"", "id=\"-1\"", "`-1` is no id"),
        ("<object", "<m:colorgroup id=\"1\"/><object", "two resources have the id 1"),
    ] {
        let found = refused(&package(&tetrahedron("", "").replacen(from, to, 1)));
        assert_eq!(found, format!("test.3mf: 3D/3dmodel.model: {reason}"));
    }
    let spaced = tetrahedron("", "").replacen("v3=\"1\"", "v3=\" &#49;\t\"", 1).replacen(
        "\"0e0\"",
        "\" 0&#x30; \"",
        1,
    );
    assert_eq!(parts_of(&spaced)[0].mesh.counts().faces, 4);
}

#[test]
fn what_numbers_vertices_in_an_unknown_way_seals_its_object() {
    let other = "<object id=\"2\"><x:boolean/></object>";
    let sealed = tetrahedron("", "<x:strain v=\"1\"/>\n");
    let document = document(&package(&format!("{sealed}{other}")));
    let seals: Vec<Option<&str>> = document.parts.iter().map(Part::seal).collect();
    let expected =
        "object 1 holds `x:strain`, which numbers its vertices or triangles in a way not known here";
    assert_eq!(seals, [Some(expected), Some("object 2 is a `x:boolean`, which is not known here")]);
    assert_eq!(document.parts[0].mesh.counts().faces, 4);
    let notes: Vec<NoteKind> = document.notes.iter().map(|note| note.kind).collect();
    assert_eq!(notes, [NoteKind::SealedPart; 2]);
    // A row that is none seals too; known children, and metadata of the object, do not.
    let odd_row = tetrahedron("", "").replacen("</triangles>", "<x:row/></triangles>", 1);
    assert!(parts_of(&odd_row)[0].seal().is_some());
    let known = tetrahedron("", "<t:trianglesets/><trianglesets/><b:beamlattice/>");
    assert_eq!(parts_of(&known.replacen("<mesh>", "<metadatagroup/><mesh>", 1))[0].seal(), None);
}

#[test]
fn the_type_of_an_object_says_whether_it_must_be_closed() {
    for (kind, expected) in [
        ("", true),
        ("type=\"model\"", true),
        ("type=\"solidsupport\"", true),
        ("type=\"support\"", false),
        ("type=\"surface\"", false),
        ("type=\"other\"", false),
        ("type=\"of a later version\"", false),
    ] {
        assert_eq!(parts_of(&tetrahedron(kind, ""))[0].must_be_closed(), expected, "{kind}");
    }
}

#[test]
fn components_and_items_place_parts() {
    let assembly = "<object id=\"2\" name=\"pair\"><components><component objectid=\"1\"/>\
                    <component objectid=\"1\" transform=\"0 1 0 -1 0 0 0 0 1 10 0 0\"/></components></object>";
    let resources = format!("{}{assembly}", tetrahedron("", ""));
    let items = "<item objectid=\"2\" transform=\"2 0 0 0 2 0 0 0 -2 0 0 5\"/><item objectid=\"1\" partnumber=\"nine\"/>";
    let bytes = package_of(model(&resources, items).as_bytes());
    let file = document(&bytes).into_mesh(Placing::Scene).unwrap();
    assert_eq!(file.mesh.counts().vertices, 12);
    // Vertex 1, at (1.5, 0, 0): scaled; turned, moved and scaled; as it is.
    let at = |vertex: usize| file.mesh.positions()[vertex];
    assert_eq!([at(1), at(5), at(9)], [[3.0, 0.0, 5.0], [20.0, 3.0, 5.0], [1.5, 0.0, 0.0]]);
    let objects = names(layer(&file.mesh, "object", Domain::Face));
    assert_eq!(objects.first(), Some(&Some("pair".to_owned())));
    assert_eq!(objects.last(), Some(&Some("nine".to_owned())));
    assert_eq!(document(&bytes).into_mesh(Placing::Parts).unwrap().mesh.counts().vertices, 4);
    // Without items each part stands once.
    let nothing = package_of(model(&tetrahedron("", ""), "").as_bytes());
    assert_eq!(document(&nothing).into_mesh(Placing::Scene).unwrap().mesh.counts().faces, 4);
}

#[test]
fn objects_that_do_not_exist_and_circles_are_refused() {
    let components = |id: u32, of: &[u32]| {
        let components: String = of.iter().map(|of| format!("<component objectid=\"{of}\"/>")).collect();
        format!("<object id=\"{id}\"><components>{components}</components></object>")
    };
    let circle = components(1, &[2]) + &components(2, &[3]) + &components(3, &[1]);
    assert_eq!(refused(&package(&circle)), "test.3mf: 3D/3dmodel.model#1: object 1 is a component of itself");
    assert!(refused(&package(&components(1, &[1]))).ends_with("#1: object 1 is a component of itself"));
    assert!(refused(&package(&components(1, &[9]))).ends_with("#1: object 9 does not exist"));
    assert_eq!(
        refused(&package_of(model("", "<item objectid=\"4\"/>").as_bytes())),
        "test.3mf: 3D/3dmodel.model: object 4 does not exist"
    );
    assert!(refused(&package_of(model("", "<item/>").as_bytes())).ends_with("`item` names no object"));
    let bent = model(&tetrahedron("", ""), "<item objectid=\"1\" transform=\"1 0 0\"/>");
    assert!(
        refused(&package_of(bent.as_bytes())).contains("a transform of object 1 that is not twelve numbers")
    );
    // Each object has the one before it twice.
    let doubled: String = (2..60).map(|id| components(id, &[id - 1, id - 1])).collect();
    let text = model(&format!("{}{doubled}", tetrahedron("", "")), "<item objectid=\"59\"/>");
    let error = try_document(&package_of(text.as_bytes())).unwrap_err().to_string();
    assert!(error.ends_with("nodes are more than the limit of 10000000 (max_nodes)"), "{error}");
    // A long chain is no circle, and each may use what others use.
    let chain: String = (2..5000).map(|id| components(id, &[id - 1, 1])).collect();
    assert_eq!(parts_of(&format!("{}{chain}", tetrahedron("", ""))).len(), 1);
}

#[test]
fn other_models_are_read_where_they_are_named() {
    let object = tetrahedron("name=\"far\"", "");
    let far = model(&object, "");
    let near = "<object id=\"2\"><components><component p:path=\"/3D/Objects/a.model\" objectid=\"1\"/></components></object>";
    let with = |path: &str, far: &[u8]| {
        archive(&[
            ("_rels/.rels", RELATIONS.as_bytes()),
            ("3D/3dmodel.model", model(near, "<item objectid=\"2\"/>").as_bytes()),
            (path, far),
        ])
    };
    let bytes = with("3D/Objects/a.model", far.as_bytes());
    let read = document(&bytes);
    assert_eq!(
        read.parts[0].source,
        PartSource::ThreeMfObject { entry: "3D/Objects/a.model".into(), id: 1, kind: ObjectKind::Model }
    );
    assert_eq!(read.clone().into_mesh(Placing::Scene).unwrap().mesh.counts().faces, 4);
    let missing = refused(&with("3D/Objects/b.model", far.as_bytes()));
    assert_eq!(
        missing,
        "test.3mf: 3D/3dmodel.model: object 1 is in `/3D/Objects/a.model`, which does not exist"
    );
    let lacking = refused(&with("3D/Objects/a.model", model("", "").as_bytes()));
    assert!(lacking.ends_with("#2: object 1 of `/3D/Objects/a.model` does not exist"), "{lacking}");
    // An encrypted model has parts that are sealed.
    let bytes = with("3D/Objects/a.model", b"%3McF\0\0\0 what follows is encrypted");
    let read = document(&bytes);
    assert_eq!(read.parts[0].seal(), Some("object 1 is in an encrypted model"));
    assert_eq!(spliced(&read).0, bytes);
    let root = package_of(b"%3McF");
    assert_eq!(refused(&root), "test.3mf: 3D/3dmodel.model: the model is encrypted");
}

#[test]
fn materials_of_one_name_that_look_different_stay_two() {
    let resources = |second: &str| {
        format!(
            "<basematerials id=\"5\"><base name=\"Red\" displaycolor=\"#FF0000\"/></basematerials>\n\
             <basematerials id=\"6\"><base name=\"Red\" displaycolor=\"{second}\"/></basematerials>\n{}",
            tetrahedron("pid=\"5\" pindex=\"0\"", "").replacen(
                "paint_color",
                "pid=\"6\" p1=\"0\" paint_color",
                1
            )
        )
    };
    let converted = |second: &str| {
        let document = document(&package(&resources(second)));
        let prepared = PreparedDocument::new(&document, &WriteOptions::of(Format::Obj)).unwrap();
        let losses = prepared.losses().into_iter().filter(|loss| loss.kind == meshmend_io::LossKind::Names);
        let mut text = Vec::new();
        prepared.encode(&mut text).unwrap();
        let text = String::from_utf8(text).unwrap();
        let used: Vec<String> =
            text.lines().filter_map(|line| Some(line.strip_prefix("usemtl ")?.to_owned())).collect();
        (used, losses.map(|loss| loss.message).collect::<Vec<_>>())
    };
    let told = "1 material shares its name with another and is called `Red_1`".to_owned();
    assert_eq!(converted("#800000"), (vec!["Red_1".to_owned(), "Red".to_owned()], vec![told]));
    assert_eq!(converted("#FF0000"), (vec!["Red".to_owned(); 2], Vec::new()));
}
