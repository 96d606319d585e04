//! What is wrong with packages, and what is not.

use super::*;
use meshmend_io::Place;

fn entries(model: &[u8]) -> Vec<(&'static str, Vec<u8>)> {
    vec![("_rels/.rels", RELATIONS.as_bytes().to_vec()), ("3D/3dmodel.model", model.to_vec())]
}

fn archived(entries: &[(&'static str, Vec<u8>)]) -> Vec<u8> {
    let entries: Vec<(&str, &[u8])> = entries.iter().map(|(name, content)| (*name, &content[..])).collect();
    archive(&entries)
}

fn good() -> Vec<u8> {
    model(&tetrahedron("", ""), "<item objectid=\"1\"/>").into_bytes()
}

#[test]
fn a_package_is_read_whatever_case_and_slashes_its_names_have() {
    for (rels, name) in [
        ("_rels/.rels", "3D/3dmodel.model"),
        ("_Rels/.rels", "3d/3DMODEL.model"),
        ("_rels\\.rels", "3D\\3dmodel.model"),
    ] {
        let bytes = archive(&[(rels, RELATIONS.as_bytes()), (name, &good())]);
        assert_eq!(document(&bytes).parts.len(), 1, "{name}");
    }
    // A relative target, and one with a dot.
    for target in ["3D/3dmodel.model", "./3D/x/../3dmodel.model", "//3D//3dmodel.model"] {
        let relations = RELATIONS.replace("/3D/3dmodel.model", target);
        let bytes = archive(&[("_rels/.rels", relations.as_bytes()), ("3D/3dmodel.model", &good())]);
        assert_eq!(document(&bytes).parts.len(), 1, "{target}");
    }
}

#[test]
fn a_damaged_archive_is_refused_at_the_entry() {
    let whole = archived(&entries(&good()));
    let cut = whole.len() - 30;
    let expected = format!("test.3mf: byte {cut}: no zip archive, or a damaged one: ");
    assert!(refused(&whole[..cut]).starts_with(&expected), "{}", refused(&whole[..cut]));
    assert_eq!(refused(b""), "test.3mf: byte 0: the file is empty");
    let at = whole.windows(16).position(|window| window == b"3D/3dmodel.model").unwrap() + 40;
    let mut bytes = whole.clone();
    bytes[at] ^= 0x55;
    assert!(
        refused(&bytes).starts_with("test.3mf: 3D/3dmodel.model: the entry is damaged"),
        "{}",
        refused(&bytes)
    );
    // An entry whose local header is gone.
    let mut bytes = whole.clone();
    bytes[0] = b'X';
    assert!(refused(&bytes).starts_with("test.3mf: _rels/.rels: the entry is damaged or cut off"));
    // The count of entries at the end is another one.
    let mut bytes = whole;
    let end = bytes.len() - 22;
    bytes[end + 10] = 3;
    assert!(refused(&bytes).contains("says that it has 3 entries, but has 2"), "{}", refused(&bytes));
}

#[test]
fn entries_that_hide_something_are_refused() {
    let with = |name: &'static str| {
        let mut entries = entries(&good());
        entries.push((name, b"x".to_vec()));
        archived(&entries)
    };
    assert_eq!(refused(&with("3D/3DModel.model")), "test.3mf: 3d/3dmodel.model: two entries have this name");
    assert_eq!(refused(&with("a/../../b")), "test.3mf: a/../../b: the name leads out of the package");
    let flagged = |at_local: usize, at_record: usize, value: u8| {
        let mut bytes = archived(&entries(&good()));
        let record = bytes.windows(4).position(|window| window == b"PK\x01\x02").unwrap();
        bytes[at_local] = value;
        bytes[record + at_record] = value;
        refused(&bytes)
    };
    assert_eq!(flagged(6, 8, 9), "test.3mf: _rels/.rels: the entry is encrypted");
    assert!(flagged(8, 10, 12).starts_with("test.3mf: _rels/.rels: the entry is packed with "));
}

#[test]
fn a_package_without_one_root_model_is_refused() {
    let model = good();
    let with = |relations: &str| {
        refused(&archive(&[("_rels/.rels", relations.as_bytes()), ("3D/3dmodel.model", &model)]))
    };
    assert_eq!(
        refused(&archive(&[("3D/3dmodel.model", &model)])),
        "test.3mf: _rels/.rels: no model part: the package has no such entry"
    );
    assert_eq!(with("<Relationships/>"), "test.3mf: _rels/.rels: no model part: no relation names one");
    let elsewhere = RELATIONS.replace("/3D/", "/2D/");
    assert_eq!(
        with(&elsewhere),
        "test.3mf: _rels/.rels: no model part: `/2D/3dmodel.model` is not in the package"
    );
    let outside = RELATIONS.replace("/3D/", "../3D/");
    assert_eq!(
        with(&outside),
        "test.3mf: _rels/.rels: no model part: `../3D/3dmodel.model` is not in the package"
    );
    let one = &RELATIONS[RELATIONS.find("<Relationship T").unwrap()..RELATIONS.find("</").unwrap()];
    let twice = RELATIONS.replace(one, &format!("{one}{one}"));
    assert_eq!(with(&twice), "test.3mf: _rels/.rels: the relations name 2 model parts, not one");
    assert_eq!(with("<x/>"), "test.3mf: _rels/.rels: the text holds no relations");
}

#[test]
fn text_that_is_no_xml_of_3mf_is_refused() {
    let good = String::from_utf8(good()).unwrap();
    let deep = format!("{}{}", "<x:a>".repeat(70), "</x:a>".repeat(70));
    for (from, to, reason) in [
        ("<model", "<!DOCTYPE model [<!ENTITY a \"b\">]><model", "a DOCTYPE, which 3MF does not allow"),
        ("<resources>", "<x:y>&a;</x:y><resources>", "an entity that XML does not know: `&a;`"),
        ("</model>\n", "</model><model/>", "there is a second element behind the first"),
        ("</model>\n", "</model>more", "text outside of the model"),
        ("</model>\n", "", "the text ends within an element"),
        ("</mesh>", "</vertices>", "no well-formed XML"),
        ("UTF-8", "ISO-8859-1", "the text is in `ISO-8859-1`; 3MF has UTF-8 and UTF-16"),
        ("<resources>", &format!("{deep}<resources>"), "elements stand in each other more than 64 deep"),
        ("xmlns=\"http://schemas.microsoft.com", "xmlns=\"http://example.org", "no model, but `model`"),
        ("objectid=\"1\"", "objectid=1", "no attributes: `item objectid=1`"),
        ("objectid=\"1\"", "objectid=\"1\"objectid=\"1\"", "no attributes"),
        ("objectid=\"1\"", "objectid=\"1\" objectid=\"1\"", "`objectid` stands twice in one tag"),
    ] {
        let text = good.replacen(from, to, 1);
        let found = refused(&package_of(text.as_bytes()));
        assert!(found.starts_with(&format!("test.3mf: 3D/3dmodel.model: {reason}")), "{from} {to}: {found}");
    }
    assert!(refused(&package_of(b"<model \xff/>")).ends_with("the text is neither UTF-8 nor UTF-16"));
    assert!(refused(&package_of(b"")).ends_with("the text has no element"));
    let other = good.replacen("<resources>", "<!-- & --><?pi & ?><resources>&#65;&amp;<![CDATA[&x;]]>", 1);
    assert_eq!(document(&package_of(other.as_bytes())).parts.len(), 1);
}

#[test]
fn an_error_is_one_line_whatever_the_text_and_the_names_say() {
    let broken = String::from_utf8(good()).unwrap().replace("</mesh>", "</b\nmesh>");
    assert!(!refused(&package_of(broken.as_bytes())).contains('\n'));
    let named = archive(&[("3D\n/../x", b"x"), ("_rels/.rels", RELATIONS.as_bytes())]);
    assert_eq!(refused(&named), "test.3mf: 3D\u{fffd}/../x: the name leads out of the package");
}

#[test]
fn the_five_encodings_are_read() {
    let text = String::from_utf8(good()).unwrap().replace("UTF-8", "UTF-16");
    let little: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
    let big: Vec<u8> = text.encode_utf16().flat_map(u16::to_be_bytes).collect();
    let marked = |mark: &[u8], text: &[u8]| [mark, text].concat();
    let utf8 = marked(b"\xef\xbb\xbf", &good());
    for bytes in [marked(b"\xff\xfe", &little), marked(b"\xfe\xff", &big), little.clone(), big, utf8] {
        let document = document(&package_of(&bytes));
        assert_eq!(document.parts[0].mesh.counts().faces, 4);
        assert_eq!(spliced(&document).0, package_of(&bytes));
    }
    let odd = marked(b"\xff\xfe", &little[..little.len() - 1]);
    assert!(refused(&package_of(&odd)).ends_with("the text is neither UTF-8 nor UTF-16"));
}

#[test]
fn what_inflates_too_far_is_refused() {
    let bytes = package_of(&good());
    let limits = Limits::default().with_max_inflated_bytes(600);
    let found = read_within(&bytes, limits);
    assert!(found.starts_with("test.3mf: 3D/3dmodel.model: "), "{found}");
    assert!(found.ends_with("inflated bytes are more than the limit of 600 (max_inflated_bytes)"), "{found}");
    let blanks = [good(), vec![b' '; 65 << 20]].concat();
    let found = refused(&package_of(&blanks));
    assert_eq!(found, "test.3mf: 3D/3dmodel.model: inflates to more than 1000 times its size");
    // An entry that is not read may be as large as it likes.
    let zeros = vec![0; 1 << 20];
    let beside = archive(&[
        ("_rels/.rels", RELATIONS.as_bytes()),
        ("3D/3dmodel.model", &good()),
        ("Metadata/zeros", &zeros),
    ]);
    let options = ReadOptions::default().with_limits(Limits::default().with_max_inflated_bytes(1 << 16));
    assert_eq!(read_document_bytes(&beside, "test.3mf", &options).unwrap().parts.len(), 1);
}

#[test]
fn limits_count_all_objects_together() {
    let two = tetrahedron("", "") + &tetrahedron("", "").replace("id=\"1\"", "id=\"2\"");
    let bytes = package(&two);
    let limits = Limits::default();
    for (limits, reason) in [
        (limits.with_max_vertices(7), "8 vertices are more than the limit of 7 (max_vertices)"),
        (limits.with_max_faces(7), "8 faces are more than the limit of 7 (max_faces)"),
        (limits.with_max_corners(23), "24 corners are more than the limit of 23 (max_corners)"),
        (limits.with_max_parts(1), "2 meshes are more than the limit of 1 (max_parts)"),
    ] {
        assert_eq!(read_within(&bytes, limits), format!("test.3mf: 3D/3dmodel.model: {reason}"));
    }
    let place =
        try_document(&package("<object id=\"1\"><mesh><vertices><vertex/></vertices></mesh></object>"));
    assert_eq!(place.unwrap_err().place, Place::Entry("3D/3dmodel.model#1".to_owned()));
}
