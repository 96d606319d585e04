//! Kernels and analyses: every kernel keeps the laws, and gives the report that the naive oracle gives.

use arbitrary::{Arbitrary, Unstructured};
use meshmend_core::{Connectivity, DefectKind, Element, PolygonMesh};
use meshmend_kernels::{KernelKind, KernelTask};
use meshmend_testkit::{Soup, laws, oracle};
use meshmend_topology::{TopologyReport, topology};
use serde_json::Value;

use crate::input::SmallMesh;

/// A small mesh in every kernel: it holds the mesh and keeps every law, or refuses for the right reasons.
pub fn kernels(data: &[u8]) {
    let Ok(SmallMesh(soup)) = SmallMesh::arbitrary(&mut Unstructured::new(data)) else { return };
    let complex = soup.complex();
    for &kind in KernelKind::ALL {
        match kind.run(&complex, Laws(&complex)) {
            Ok(kept) => assert_eq!(kept, Ok(()), "{kind}: {:?}", soup.faces),
            Err(refusal) => {
                let kept = laws::refusal_law(&refusal, kind.name(), &kind.capabilities(), &complex);
                assert_eq!(kept, Ok(()), "{:?}", soup.faces);
            }
        }
    }
}

/// A small mesh in the eyes of every kernel that can hold it, and of the oracle; then with its faces begun at other
/// corners, which no figure depends on.
pub fn analysis(data: &[u8]) {
    let Ok(SmallMesh(soup)) = SmallMesh::arbitrary(&mut Unstructured::new(data)) else { return };
    let mesh = soup.mesh();
    let wanted = serde_json::to_value(oracle::report(&soup)).expect("a report is JSON");
    for &kind in KernelKind::ALL {
        let Ok(report) = kind.run(mesh.complex(), Report(&mesh)) else {
            assert!(!kind.capabilities().is_permissive(), "{kind} refuses");
            continue;
        };
        assert_agrees(&report, &wanted, kind);
        assert_witnessed(&soup, &report);
    }
    let turned = soup.rotated(1).mesh();
    let report =
        KernelKind::default().run(turned.complex(), Report(&turned)).expect("the default holds anything");
    assert_agrees(&report, &wanted, KernelKind::default());
}

struct Laws<'a>(&'a meshmend_core::Complex);

impl KernelTask for Laws<'_> {
    type Output = Result<(), String>;
    fn run<K: Connectivity>(self, _: &K) -> Self::Output {
        laws::kernel_laws::<K>(self.0)
    }
}

/// The topology of a mesh.
struct Report<'a>(&'a PolygonMesh);

impl KernelTask for Report<'_> {
    type Output = TopologyReport;
    fn run<K: Connectivity>(self, kernel: &K) -> TopologyReport {
        topology(kernel, self.0)
    }
}

/// Every figure that the oracle knows is the report's.
fn assert_agrees(report: &TopologyReport, wanted: &Value, kind: KernelKind) {
    let report = serde_json::to_value(report).expect("a report is JSON");
    for (figure, value) in wanted.as_object().expect("a report is an object") {
        assert_eq!(report.get(figure), Some(value), "{figure} by {kind}");
    }
}

/// Every patch without a consistent side has a strip that shows it.
fn assert_witnessed(soup: &Soup, report: &TopologyReport) {
    for defect in report.defects.of_kind(DefectKind::NonOrientablePatch) {
        let Element::Strip(strip) = defect.at else { panic!("{defect} is at another element") };
        let faces: Vec<u32> = strip.faces.iter().map(|face| face.0).collect();
        let edges: Vec<u32> = strip.edges.iter().map(|edge| edge.0).collect();
        assert_eq!(oracle::check_witness(soup, &faces, &edges), Ok(()), "{faces:?} {edges:?}");
    }
}
