//! The figures of a mesh, as the library reports them.

use meshmend_core::Connectivity;
use meshmend_kernels::{KernelKind, KernelTask};
use meshmend_testkit::Soup;
use meshmend_topology::{TopologyReport, topology};
use serde_json::Value;

struct Report<'a>(&'a meshmend_core::PolygonMesh);

impl KernelTask for Report<'_> {
    type Output = TopologyReport;
    fn run<K: Connectivity>(self, kernel: &K) -> TopologyReport {
        topology(kernel, self.0)
    }
}

/// The topology of a mesh.
pub(crate) fn report(soup: &Soup) -> TopologyReport {
    let mesh = soup.mesh();
    KernelKind::default().run(mesh.complex(), Report(&mesh)).unwrap()
}

/// All figures of sections 2 and 3, but for the names of vertices and the order that follows from them.
pub(crate) fn figures(soup: &Soup) -> Value {
    let mut figures = serde_json::to_value(report(soup)).unwrap();
    let kinds = figures["component_kinds"].as_array_mut().unwrap();
    kinds.iter_mut().for_each(|kind| kind["first_vertex"] = Value::Null);
    kinds.sort_by_key(Value::to_string);
    figures
}
