//! Matrices as files of the Matrix Market, which numerical programs read.
//!
//! A header, the size and the number of entries, then a line for each entry: row, column and value, counted from 1. A
//! symmetric matrix lists what is on and below its diagonal.
//!
//! *Source*: R. Boisvert, R. Pozo, K. Remington, *The Matrix Market exchange formats*, 1996.

use std::io::{self, Write};

use meshmend_core::{Adjacency, EdgeId, Id, Incidence, VertexId};

use super::{Graph, IncidenceMatrices, Operator};

/// A matrix that can be written.
#[derive(Clone, Copy, Debug)]
pub enum MatrixMarket<'a> {
    /// ∂₁: a row for each vertex, a column for each edge.
    Boundary1(&'a IncidenceMatrices),
    /// ∂₂: a row for each edge, a column for each face.
    Boundary2(&'a IncidenceMatrices),
    /// The adjacency matrix, or the Laplacian, of a graph.
    OfGraph(&'a Graph, Operator),
}

impl MatrixMarket<'_> {
    /// Writes the matrix, row by row.
    ///
    /// # Errors
    /// Those of the sink.
    ///
    /// *Cost*: linear.
    pub fn write(self, out: &mut dyn Write) -> io::Result<()> {
        match self {
            MatrixMarket::Boundary1(matrices) => {
                let [vertices, edges, _] = matrices.cell_counts();
                let [entries, _] = matrices.entry_counts();
                header(out, "general", "∂₁: vertices by edges", [vertices, edges, entries])?;
                (0..vertices).try_for_each(|v| row(out, v, matrices.coboundary_of_vertex(VertexId::new(v))))
            }
            MatrixMarket::Boundary2(matrices) => {
                let [_, edges, faces] = matrices.cell_counts();
                let [_, entries] = matrices.entry_counts();
                header(out, "general", "∂₂: edges by faces", [edges, faces, entries])?;
                (0..edges).try_for_each(|e| row(out, e, matrices.coboundary_of_edge(EdgeId::new(e))))
            }
            MatrixMarket::OfGraph(graph, operator) => of_graph(out, graph, operator),
        }
    }
}

fn of_graph(out: &mut dyn Write, graph: &Graph, operator: Operator) -> io::Result<()> {
    let [vertices, edges] = graph.graph_counts();
    let ids = (0..vertices).map(VertexId::new);
    let (name, value, on_diagonal) = match operator {
        Operator::Adjacency => ("A: vertices by vertices", 1, 0),
        Operator::Laplacian => {
            ("L = D − A: vertices by vertices", -1, ids.clone().filter(|&v| graph.degree(v) > 0).count())
        }
    };
    header(out, "symmetric", name, [vertices, vertices, edges + on_diagonal])?;
    for vertex in ids {
        let smaller = graph.neighbours(vertex).take_while(|&neighbour| neighbour < vertex);
        row(out, vertex.index(), smaller.map(|neighbour| (neighbour, value)))?;
        let degree = graph.degree(vertex) as i64;
        if operator == Operator::Laplacian && degree > 0 {
            row(out, vertex.index(), [(vertex, degree)].into_iter())?;
        }
    }
    Ok(())
}

fn header(out: &mut dyn Write, form: &str, name: &str, sizes: [usize; 3]) -> io::Result<()> {
    let [rows, columns, entries] = sizes;
    writeln!(out, "%%MatrixMarket matrix coordinate integer {form}\n% {name}\n{rows} {columns} {entries}")
}

fn row<I: Id>(
    out: &mut dyn Write,
    row: usize,
    mut entries: impl Iterator<Item = (I, i64)>,
) -> io::Result<()> {
    entries.try_for_each(|(column, value)| writeln!(out, "{} {} {value}", row + 1, column.index() + 1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::{self, Shape};

    fn text(matrix: MatrixMarket<'_>) -> String {
        let mut out = Vec::new();
        matrix.write(&mut out).unwrap();
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn a_triangle_in_four_files() {
        let mesh = Shape::of(&[&[0, 1, 2]]).mesh();
        let (matrices, graph) = (IncidenceMatrices::of(mesh.complex()), Graph::of(mesh.complex()));
        assert_eq!(
            text(MatrixMarket::Boundary1(&matrices)),
            "%%MatrixMarket matrix coordinate integer general\n% ∂₁: vertices by edges\n3 3 6\n\
             1 1 -1\n1 2 -1\n2 1 1\n2 3 -1\n3 2 1\n3 3 1\n"
        );
        assert!(text(MatrixMarket::Boundary2(&matrices)).ends_with("3 1 3\n1 1 1\n2 1 -1\n3 1 1\n"));
        assert!(
            text(MatrixMarket::OfGraph(&graph, Operator::Adjacency))
                .ends_with("3 3 3\n2 1 1\n3 1 1\n3 2 1\n")
        );
        assert!(
            text(MatrixMarket::OfGraph(&graph, Operator::Laplacian))
                .ends_with("3 3 6\n1 1 2\n2 1 -1\n2 2 2\n3 1 -1\n3 2 -1\n3 3 2\n")
        );
    }

    #[test]
    fn as_many_entries_as_the_header_says() {
        let soup = Shape::of(&[&[0, 1, 2, 3, 2], &[0, 1, 4, 0, 1, 5], &[6, 7, 8, 6, 7, 6, 7], &[10, 11, 12]]);
        for shape in [soup, shapes::klein_bottle(3, 4), Shape::of(&[])] {
            let mesh = shape.mesh();
            let (matrices, graph) = (IncidenceMatrices::of(mesh.complex()), Graph::of(mesh.complex()));
            for matrix in [
                MatrixMarket::Boundary1(&matrices),
                MatrixMarket::Boundary2(&matrices),
                MatrixMarket::OfGraph(&graph, Operator::Adjacency),
                MatrixMarket::OfGraph(&graph, Operator::Laplacian),
            ] {
                let text = text(matrix);
                let lines: Vec<&str> = text.lines().collect();
                assert!(lines[2].ends_with(&format!(" {}", lines.len() - 3)), "{}", lines[2]);
            }
        }
    }
}
