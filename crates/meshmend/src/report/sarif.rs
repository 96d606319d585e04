//! Checks as SARIF 2.1.0, the form in which code review and CI show the findings of tools.

use meshmend_core::{DefectKind, Element, FaceId, Rules, Severity, VertexId};
use meshmend_io::ElementLines;
use serde_json::{Map, Value, json};

use super::{CheckDocument, PlacedDefect};

/// The findings in some files.
#[derive(Clone, Debug, Default)]
pub struct Sarif {
    results: Vec<Value>,
    counts: Vec<Value>,
    failures: Vec<Value>,
}

impl Sarif {
    /// Adds the report on a file, or on a part of one that has this title.
    ///
    /// Each item of its lists is a result; how many there are of each kind is told in the properties of the run.
    pub fn add(&mut self, file: &str, part: Option<&str>, report: &CheckDocument, lines: &ElementLines) {
        let uri = uri_of(file);
        for group in &report.defects {
            for item in &group.items {
                self.results.push(result(&uri, part, item, group.severity, lines));
            }
            let mut count = Map::new();
            count.insert("file".to_owned(), uri.clone().into());
            count.extend(part.map(|part| ("part".to_owned(), part.into())));
            count.insert("kind".to_owned(), group.kind.code().into());
            count.insert("count".to_owned(), group.count.into());
            self.counts.push(count.into());
        }
    }

    /// Says that a file could not be judged.
    pub fn add_failure(&mut self, message: &str) {
        self.failures.push(json!({ "level": "error", "message": { "text": message } }));
    }

    /// The document: one run, whose rules are the kinds of defect.
    pub fn document(self, rules: Rules) -> Value {
        let rules: Vec<Value> = rules.kinds().map(rule).collect();
        let version = env!("CARGO_PKG_VERSION");
        json!({
            "$schema": "https://json.schemastore.org/sarif-2.1.0.json",
            "version": "2.1.0",
            "runs": [{
                "tool": { "driver": { "name": "meshmend", "version": version, "rules": rules } },
                "invocations": [{
                    "executionSuccessful": self.failures.is_empty(),
                    "toolExecutionNotifications": self.failures,
                }],
                "results": self.results,
                "properties": { "counts": self.counts },
            }],
        })
    }
}

/// The vertices and faces by whose lines the items of a report are placed.
pub fn placing_elements(report: &CheckDocument) -> (Vec<VertexId>, Vec<FaceId>) {
    let items = || report.defects.iter().flat_map(|group| &group.items);
    (
        items().filter_map(|item| item.vertices.first().copied()).collect(),
        items().filter_map(face_of).collect(),
    )
}

fn rule(kind: DefectKind) -> Value {
    json!({
        "id": kind.code(),
        "shortDescription": { "text": kind.title() },
        "help": { "text": kind.explanation() },
        "defaultConfiguration": { "level": level(kind.severity()) },
    })
}

fn level(severity: Severity) -> &'static str {
    match severity {
        Severity::Defect => "error",
        Severity::Note => "note",
    }
}

fn result(
    uri: &str,
    part: Option<&str>,
    item: &PlacedDefect,
    severity: Severity,
    lines: &ElementLines,
) -> Value {
    let mut physical = json!({ "artifactLocation": { "uri": uri } });
    if let Some(line) = line_of(item, lines) {
        physical["region"] = json!({ "startLine": line });
    }
    let (kind, name) = (item.defect.at.name(), place_of(&item.defect.at));
    let qualified = part.map_or(name.clone(), |part| format!("{part}/{name}"));
    let logical = json!([{ "name": name, "kind": kind, "fullyQualifiedName": qualified }]);
    json!({
        "ruleId": item.defect.kind.code(),
        "level": level(severity),
        "message": { "text": item.defect.to_string() },
        "locations": [{ "physicalLocation": physical, "logicalLocations": logical }],
        "partialFingerprints": { "place/v1": fingerprint(item) },
    })
}

/// The face by whose line a defect is placed: its own, or the first along its edge.
fn face_of(item: &PlacedDefect) -> Option<FaceId> {
    match &item.defect.at {
        Element::Face(face)
        | Element::Corner { face, .. }
        | Element::Patch(face)
        | Element::Component(face) => Some(*face),
        Element::Strip(strip) => strip.faces.first().copied(),
        Element::Edge { .. } => item.round.as_ref().and_then(|round| round.faces.first().copied()),
        _ => None,
    }
}

fn line_of(item: &PlacedDefect, lines: &ElementLines) -> Option<u64> {
    let of_face = face_of(item).and_then(|face| lines.face(face));
    of_face.or_else(|| item.vertices.first().and_then(|&vertex| lines.vertex(vertex)))
}

/// What an element is called in a file: `face 12`.
fn place_of(element: &Element) -> String {
    match element {
        Element::Vertex(vertex) => format!("vertex {}", vertex.0),
        Element::Edge { ends: [a, b], .. } => format!("edge {}-{}", a.0, b.0),
        Element::Face(face) => format!("face {}", face.0),
        Element::Corner { face, vertex } => format!("face {} at vertex {}", face.0, vertex.0),
        other => other.to_string(),
    }
}

/// What tells a defect from others when ids change: its kind, and where it is, in single precision.
fn fingerprint(item: &PlacedDefect) -> String {
    let mut places: Vec<[u32; 3]> =
        item.positions.iter().map(|place| place.map(|x| (x as f32 + 0.0).to_bits())).collect();
    places.sort_unstable();
    let places = places.as_flattened().iter().flat_map(|bits| bits.to_le_bytes());
    // FNV-1a.
    let hash =
        item.defect.kind.code().bytes().chain(places).fold(0xcbf2_9ce4_8422_2325u64, |hash, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
        });
    format!("{hash:016x}")
}

/// A path as a URI: relative to the working folder where it leads there, with what can't stand in one escaped.
fn uri_of(path: &str) -> String {
    let folder = std::env::current_dir().ok().and_then(|folder| folder.to_str().map(str::to_owned));
    let within = folder.and_then(|folder| path.strip_prefix(&folder)?.strip_prefix('/'));
    let (prefix, path) = match within {
        Some(path) => ("", path),
        None if path.starts_with('/') => ("file://", path),
        None => ("", path),
    };
    let path = if cfg!(windows) { path.replace('\\', "/") } else { path.to_owned() };
    let mut uri = prefix.to_owned();
    for byte in path.bytes() {
        let is_plain = byte.is_ascii_alphanumeric() || b"-._~/".contains(&byte);
        uri += &if is_plain { char::from(byte).to_string() } else { format!("%{byte:02X}") };
    }
    uri
}

#[cfg(test)]
mod tests {
    use meshmend_io::read_bytes;

    use super::*;
    use crate::{CheckOptions, check};

    fn sarif(obj: &str, limit: usize) -> Value {
        let mesh = read_bytes(obj.as_bytes(), "a.obj", &Default::default()).unwrap().mesh;
        let report = CheckDocument::new(check(&mesh, &CheckOptions::default()).unwrap(), limit);
        let (vertices, faces) = placing_elements(&report);
        let counts = (mesh.counts().vertices, mesh.counts().faces);
        let lines = ElementLines::find(obj.as_bytes(), meshmend_io::Format::Obj, counts, (&vertices, &faces));
        let mut sarif = Sarif::default();
        sarif.add("folder/a b%.obj", None, &report, &lines);
        sarif.document(Rules::builtin())
    }

    const TWICE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 5\nf 1 2 3\nf 2 3 1\n";

    #[test]
    fn every_item_is_a_result_with_its_place() {
        let document = sarif(TWICE, 10);
        let results = document["runs"][0]["results"].as_array().unwrap();
        let of_rule = |rule: &str| results.iter().find(|result| result["ruleId"] == rule).unwrap();
        let twice = of_rule("duplicate-face");
        let place = &twice["locations"][0];
        assert_eq!(
            place["physicalLocation"],
            json!({"artifactLocation": {"uri": "folder/a%20b%25.obj"}, "region": {"startLine": 6}})
        );
        assert_eq!(place["logicalLocations"][0]["fullyQualifiedName"], "face 1");
        assert_eq!(
            (&twice["level"], &of_rule("unreferenced-vertex")["level"]),
            (&json!("error"), &json!("note"))
        );
        let unused = &of_rule("unreferenced-vertex")["locations"][0]["physicalLocation"]["region"];
        assert_eq!(unused["startLine"], 4);
    }

    #[test]
    fn counts_are_whole_where_lists_are_cut() {
        let document = sarif(TWICE, 1);
        let run = &document["runs"][0];
        let count = run["properties"]["counts"]
            .as_array()
            .unwrap()
            .iter()
            .map(|count| count["count"].as_u64().unwrap());
        assert!(count.sum::<u64>() > run["results"].as_array().unwrap().len() as u64);
        let rules = run["tool"]["driver"]["rules"].as_array().unwrap();
        assert_eq!(rules.len(), Rules::builtin().kinds().count());
    }

    #[test]
    fn a_fingerprint_stays_where_ids_change() {
        let moved = "v 5 5 5\nv 0 1 0\nv 0 0 0\nv 1 0 0\nf 2 3 4\nf 4 2 3\n";
        let prints = |document: Value| {
            let results = document["runs"][0]["results"].as_array().unwrap().clone();
            let mut prints: Vec<String> =
                results.iter().map(|result| result["partialFingerprints"]["place/v1"].to_string()).collect();
            prints.sort_unstable();
            prints
        };
        assert_eq!(prints(sarif(TWICE, 10)), prints(sarif(moved, 10)));
    }
}
