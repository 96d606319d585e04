//! A report on a file of several parts: a report on each, and above them what they come to together.

use std::collections::BTreeMap;

use serde::{Serialize, Serializer};
use serde_json::{Map, Value, json};

use meshmend_io::Part;

/// Keys whose value is the same for all parts or has no meaning for them together.
const NOT_ADDED: [&str; 8] = ["schema", "weld", "view", "file", "format", "limit", "provenance", "output"];

/// Figures that several parts don't have together.
const OF_ONE: [&str; 4] = ["genus", "cross_caps", "component_kinds", "component_kinds_total"];

/// Reports on the parts of a file. As JSON it has `parts`, each with all keys of a report; at the top stand the same
/// keys for the file: sums of counts, *and* for verdicts, `null` for what several parts don't have together, such as a
/// genus. Lists at the top are empty unless there is one part.
#[derive(Clone, Debug, Default)]
pub struct PartsDocument {
    /// What each part is called, with its report if it has one.
    parts: Vec<(Map<String, Value>, Option<Value>)>,
    own: Map<String, Value>,
}

impl PartsDocument {
    /// Adds the report on a part.
    ///
    /// # Errors
    /// When the report has a map whose keys are not texts. No document has one.
    pub fn add(
        &mut self,
        index: usize,
        part: &Part,
        report: &impl Serialize,
    ) -> Result<(), serde_json::Error> {
        self.parts.push((head(index, part), Some(serde_json::to_value(report)?)));
        Ok(())
    }

    /// Adds a part without a report, and why it has none: under `sealed` or `given_back`.
    pub fn add_without(&mut self, index: usize, part: &Part, key: &str, reason: &str) {
        let mut keys = head(index, part);
        keys.insert(key.to_owned(), reason.into());
        self.parts.push((keys, None));
    }

    /// Says something of the file as a whole.
    ///
    /// # Errors
    /// When the value has a map whose keys are not texts.
    pub fn say(&mut self, key: &str, value: &impl Serialize) -> Result<(), serde_json::Error> {
        self.own.insert(key.to_owned(), serde_json::to_value(value)?);
        Ok(())
    }
}

fn head(index: usize, part: &Part) -> Map<String, Value> {
    let name = String::from_utf8_lossy(&part.name).into_owned();
    [("part", json!(index)), ("name", json!(name)), ("title", json!(part.title()))]
        .map(|(key, value)| (key.to_owned(), value))
        .into_iter()
        .collect()
}

impl Serialize for PartsDocument {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let reports: Vec<&Value> = self.parts.iter().filter_map(|(_, report)| report.as_ref()).collect();
        let mut top = match &reports[..] {
            [only] => only.as_object().cloned().unwrap_or_default(),
            reports => together_of_objects(reports),
        };
        top.insert("schema".to_owned(), super::SCHEMA.into());
        top.extend(self.own.clone());
        let whole = |(head, report): &(Map<String, Value>, Option<Value>)| {
            let report = report.as_ref().and_then(Value::as_object).cloned().unwrap_or_default();
            Value::Object(head.clone().into_iter().chain(report).collect())
        };
        top.insert("parts".to_owned(), self.parts.iter().map(whole).collect());
        top.serialize(serializer)
    }
}

/// What values under one key come to.
fn together(key: &str, values: &[&Value]) -> Value {
    if NOT_ADDED.contains(&key) {
        return all_same(values);
    }
    if key == "items" {
        return json!([]);
    }
    let all = |is_fit: fn(&Value) -> bool| values.iter().all(|value| is_fit(value));
    if OF_ONE.contains(&key) {
        Value::Null
    } else if all(Value::is_boolean) {
        let is_true = |value: &&Value| **value == Value::Bool(true);
        // A file is changed when one of its parts is.
        let verdict = if key == "changed" { values.iter().any(is_true) } else { values.iter().all(is_true) };
        verdict.into()
    } else if all(Value::is_i64) {
        values.iter().filter_map(|value| value.as_i64()).sum::<i64>().into()
    } else if all(Value::is_object) {
        Value::Object(together_of_objects(values))
    } else if all(Value::is_array) {
        together_of_lists(values)
    } else {
        all_same(values)
    }
}

/// The value, if all have the same.
fn all_same(values: &[&Value]) -> Value {
    match values {
        [first, rest @ ..] if rest.iter().all(|value| value == first) => (*first).clone(),
        _ => Value::Null,
    }
}

/// Objects, key by key. A key that not all have is a count that is not there: it counts nothing where it lacks.
fn together_of_objects(objects: &[&Value]) -> Map<String, Value> {
    let mut keys: BTreeMap<&String, Vec<&Value>> = BTreeMap::new();
    for (key, value) in objects.iter().filter_map(|object| object.as_object()).flatten() {
        keys.entry(key).or_default().push(value);
    }
    keys.into_iter().map(|(key, values)| (key.clone(), together(key, &values))).collect()
}

/// Lists of entries that say what they are about are added entry by entry, and lists of the same three numbers too. Other
/// lists name elements, and those are the parts' own.
fn together_of_lists(lists: &[&Value]) -> Value {
    let lists: Vec<&Vec<Value>> = lists.iter().filter_map(|list| list.as_array()).collect();
    let entries = || lists.iter().copied().flatten();
    if lists.iter().all(|list| list.len() == 3) && entries().all(Value::is_i64) {
        let sum = |at: usize| lists.iter().filter_map(|list| list[at].as_i64()).sum::<i64>();
        return json!([sum(0), sum(1), sum(2)]);
    }
    let Some(subject) =
        ["kind", "pass", "name"].into_iter().find(|key| entries().all(|e| e.get(key).is_some()))
    else {
        return json!([]);
    };
    let mut subjects: Vec<(&Value, Vec<&Value>)> = Vec::new();
    for entry in entries() {
        match subjects.iter_mut().find(|(known, _)| *known == &entry[subject]) {
            Some((_, found)) => found.push(entry),
            None => subjects.push((&entry[subject], vec![entry])),
        }
    }
    subjects.iter().map(|(_, entries)| Value::Object(together_of_objects(entries))).collect()
}

#[cfg(test)]
mod tests {
    use meshmend_core::{FaceTable, PolygonMesh};
    use meshmend_io::{PartSource, PartStatus};

    use super::*;

    fn part(index: u32, name: &str) -> Part {
        Part {
            name: name.as_bytes().to_vec(),
            source: PartSource::GltfMesh { index, tells_vertices: false },
            mesh: PolygonMesh::new(Vec::new(), FaceTable::empty(0)).unwrap(),
            status: PartStatus::Editable,
        }
    }

    fn report(faces: u32, manifold: bool, defects: Value) -> Value {
        json!({
            "schema": 2, "faces": faces, "manifold": manifold, "genus": 0, "betti": [1, 0, faces], "view": "welded",
            "defects": defects, "removed": {"count": faces, "items": [{"kind": "face"}]},
        })
    }

    #[test]
    fn counts_are_added_verdicts_joined_and_figures_of_one_surface_left_out() {
        let mut document = PartsDocument::default();
        let pinched = json!([{"kind": "pinched-vertex", "severity": "defect", "count": 2, "items": [1, 2]}]);
        document.add(0, &part(0, "Body"), &report(4, true, json!([]))).unwrap();
        document.add_without(1, &part(1, ""), "sealed", "it is compressed");
        document.add(2, &part(2, "Lid"), &report(5, false, pinched.clone())).unwrap();
        document.say("file", &"car.glb").unwrap();
        let value = serde_json::to_value(&document).unwrap();
        assert_eq!(
            (&value["schema"], &value["faces"], &value["view"]),
            (&json!(2), &json!(9), &json!("welded"))
        );
        assert_eq!((&value["manifold"], &value["genus"]), (&json!(false), &Value::Null));
        assert_eq!((&value["betti"], &value["file"]), (&json!([2, 0, 9]), &json!("car.glb")));
        assert_eq!(value["removed"], json!({"count": 9, "items": []}));
        assert_eq!(value["defects"][0]["count"], 2);
        assert_eq!(value["defects"][0]["items"], json!([]));
        assert_eq!(
            (&value["parts"][2]["title"], &value["parts"][2]["faces"]),
            (&json!("Lid (mesh 2)"), &json!(5))
        );
        assert_eq!(value["parts"][2]["defects"], pinched);
        assert_eq!(value["parts"][1]["sealed"], "it is compressed");
    }

    #[test]
    fn one_part_is_the_whole() {
        let mut document = PartsDocument::default();
        document.add(0, &part(0, "Body"), &report(4, true, json!([]))).unwrap();
        let value = serde_json::to_value(&document).unwrap();
        assert_eq!((&value["genus"], &value["removed"]["items"]), (&json!(0), &json!([{"kind": "face"}])));
        assert_eq!(value["parts"][0]["genus"], 0);
    }
}
