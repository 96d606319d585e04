//! `report`: a cross-check of all answers at once.

use meshmend_core::{Connectivity, EdgeUse};
use meshmend_topology::{TopologyReport, topology};

use super::asked::Asked;
use super::law::{Breach, Law};

pub(super) const REPORT: Law = Law {
    id: "report",
    sentence: "`topology` gives the report that the default kernel gives",
    why: "a cross-check: all algorithms of the library take a kernel of one's own as it is",
    often: None,
};

pub(super) fn report<K: Connectivity>(asked: &Asked<'_, K>) -> Result<(), Breach> {
    let Some(mesh) = asked.mesh else { return Ok(()) };
    let found = topology(asked.kernel, mesh);
    let expected = topology(&EdgeUse::assemble(mesh.complex()), mesh);
    if format!("{found:?}") == format!("{expected:?}") {
        Ok(())
    } else {
        Err(first_difference(&found, &expected))
    }
}

/// The first figure that differs, as it is in JSON.
fn first_difference(found: &TopologyReport, expected: &TopologyReport) -> Breach {
    let [found, expected] = [found, expected].map(|report| serde_json::to_value(report).unwrap_or_default());
    let none = serde_json::Map::new();
    let [said, right] = [&found, &expected].map(|report| report.as_object().unwrap_or(&none));
    let differs = right.iter().find(|&(figure, value)| said.get(figure) != Some(value));
    let (figure, value) =
        differs.map_or(("the list of defects", &expected), |(name, value)| (name.as_str(), value));
    let answer = said.get(figure).unwrap_or(&found).to_string();
    Breach { question: format!("`{figure}` of the report"), found: answer, expected: value.to_string() }
}
