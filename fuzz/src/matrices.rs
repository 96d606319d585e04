//! Matrices: the views over a small mesh agree with the default kernel, with the naive oracle, and with one another.

use arbitrary::{Arbitrary, Unstructured};
use meshmend_core::{Adjacency, Cell, Connectivity, EdgeUse, Id, Incidence, VertexId};
use meshmend_testkit::oracle;
use meshmend_topology::matrices::{
    CellSet, Field, Graph, IncidenceMatrices, MatrixMarket, Operator, Prime, closure, is_complex, link,
    spectrum, star, triangle_count, walks,
};

use crate::arguments::assert_matrix_whole;
use crate::input::SmallMesh;

/// A small mesh by its matrices.
pub fn matrices(data: &[u8]) {
    let Ok(SmallMesh(soup)) = SmallMesh::arbitrary(&mut Unstructured::new(data)) else { return };
    let complex = soup.complex();
    let (matrices, graph) = (IncidenceMatrices::of(&complex), Graph::of(&complex));
    assert!(matrices.boundary_of_boundary_is_zero(), "{:?}", soup.faces);
    let expected = serde_json::to_value(oracle::report(&soup)).expect("a report is JSON");
    for (field, key) in [(Field::Modulo(Prime::TWO), "z2"), (Field::Rationals, "q")] {
        let found = matrices.betti(field).expect("a small mesh is within the limits");
        assert_eq!(serde_json::json!(found), expected["betti"][key], "{field}: {:?}", soup.faces);
    }
    assert_neighbourhoods(&matrices, &EdgeUse::assemble(&complex));
    assert_graph(&graph);
    for matrix in [
        MatrixMarket::Boundary1(&matrices),
        MatrixMarket::Boundary2(&matrices),
        MatrixMarket::OfGraph(&graph, Operator::Adjacency),
        MatrixMarket::OfGraph(&graph, Operator::Laplacian),
    ] {
        let mut file = Vec::new();
        matrix.write(&mut file).expect("memory takes anything");
        assert_matrix_whole("a matrix", &String::from_utf8_lossy(&file));
    }
}

/// What is round each cell is the same by the matrices and by a kernel.
fn assert_neighbourhoods(matrices: &IncidenceMatrices, kernel: &EdgeUse) {
    let vertices = kernel.vertices().map(Cell::from);
    for cell in vertices.chain(kernel.edges().map(Cell::from)).chain(kernel.faces().map(Cell::from)) {
        let cells = CellSet::of([cell]);
        let closed = closure(matrices, &cells);
        assert!(is_complex(matrices, &closed));
        assert_eq!(closed, closure(kernel, &cells), "{cell}");
        assert_eq!(star(matrices, &cells), star(kernel, &cells), "{cell}");
        assert_eq!(link(matrices, &cells), link(kernel, &cells), "{cell}");
        if let Some(rim) = matrices.boundary(&closed) {
            assert!(is_complex(matrices, &rim) && rim.faces().is_empty());
        }
    }
    assert_eq!(matrices.cell_counts(), kernel.cell_counts());
}

/// Walks of three steps come back round each cycle of three edges six times, and eigenvalues lie within the degrees.
fn assert_graph(graph: &Graph) {
    let vertices = || (0..graph.graph_counts()[0]).map(VertexId::new);
    let closed: u128 = vertices().map(|v| walks(graph, 3, v).expect("few walks")[v]).sum();
    assert_eq!(closed, 6 * u128::from(triangle_count(graph)));
    let highest = vertices().map(|v| graph.degree(v)).max().unwrap_or(0) as f64;
    for operator in [Operator::Adjacency, Operator::Laplacian] {
        let found = spectrum(graph, operator, 32).expect("a small graph");
        assert_eq!(found.len(), graph.graph_counts()[0]);
        for eigenvalue in &found {
            assert!(
                eigenvalue.residual <= 1e-9 && eigenvalue.value.abs() <= 2.0 * highest + 1e-9,
                "{eigenvalue:?}"
            );
        }
        // All eigenvalues together are the trace: 0, or twice the number of edges.
        let edges = graph.graph_counts()[1] as f64;
        let trace = if operator == Operator::Adjacency { 0.0 } else { 2.0 * edges };
        let sum: f64 = found.iter().map(|eigenvalue| eigenvalue.value).sum();
        assert!((sum - trace).abs() < 1e-8, "{sum} is not {trace}");
    }
}
