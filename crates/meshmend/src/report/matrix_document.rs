//! The document of the matrices of a mesh.

use meshmend_core::{Adjacency, Array, Cell, EdgeId, FaceId, Id, Incidence, PolygonMesh, VertexId};
use meshmend_io::{Note, ReadFile};
use meshmend_repair::Distance;
use meshmend_topology::matrices::{
    CellSet, Eigenvalue, IncidenceMatrices, is_complex, pure_dimension, triangle_count,
};
use serde::Serialize;

use super::{Listing, SCHEMA};
use crate::{MatrixAnswers, MatrixQuestions, View};

/// The matrices of a mesh, and the answers to questions to them, with every list cut to a limit.
#[derive(Clone, Debug, Serialize)]
pub struct MatrixDocument {
    /// The number of this form.
    pub schema: u32,
    /// The file that the mesh is from, if it is from one.
    pub file: Option<String>,
    /// Which form of which format the file has, such as `ply-le`.
    pub format: Option<&'static str>,
    /// `indexed` or `welded`.
    pub view: &'static str,
    /// The distance of a welded view.
    pub weld: Option<Distance>,
    /// ∂₁, with a row for each vertex and a column for each edge.
    pub d1: MatrixSize,
    /// ∂₂, with a row for each edge and a column for each face.
    pub d2: MatrixSize,
    /// The adjacency matrix, with a row and a column for each vertex.
    pub adjacency: MatrixSize,
    /// Whether ∂₁∂₂ = 0.
    pub boundary_of_boundary_is_zero: bool,
    /// The sides that cancel in ∂₂.
    pub lost_sides: Listing<LostSideDocument>,
    /// How many cycles of three edges there are.
    pub three_cycles: u64,
    /// How many faces have three sides.
    pub triangles: usize,
    /// How many vertices have no neighbour.
    pub lone_vertices: usize,
    /// The arrays of ∂₁ and ∂₂, and of the adjacency matrix.
    pub arrays: ArraysDocument,
    /// The walks, if they are asked for.
    pub walks: Option<WalksDocument>,
    /// The eigenvalues, if they are asked for.
    pub spectrum: Option<SpectrumDocument>,
    /// The ranks over each field that is asked for.
    pub ranks: Vec<RankDocument>,
    /// The neighbourhoods that are asked for.
    pub neighbourhoods: Vec<NeighbourhoodDocument>,
    /// What the reader had to say about the file.
    pub notes: Vec<Note>,
}

/// How large a matrix is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct MatrixSize {
    /// How many rows it has.
    pub rows: usize,
    /// How many columns.
    pub columns: usize,
    /// How many entries that are not 0.
    pub entries: usize,
}

/// The arrays of which the matrices consist.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct ArraysDocument {
    /// Those of ∂₁ and ∂₂.
    pub incidence: Vec<Array>,
    /// Those of the adjacency matrix.
    pub adjacency: Vec<Array>,
}

/// A face that runs along an edge both ways.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct LostSideDocument {
    /// The face.
    pub face: FaceId,
    /// The edge.
    pub edge: EdgeId,
    /// The vertices that it joins.
    pub ends: [VertexId; 2],
    /// How many pairs of sides cancel.
    pub pairs: u32,
}

/// How many walks of a length lead from a vertex to others.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct WalksDocument {
    /// How long they are.
    pub length: u32,
    /// Where they begin.
    pub from: VertexId,
    /// The vertices to which some lead, ascending.
    pub to: Listing<WalksTo>,
}

/// How many walks lead to a vertex.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct WalksTo {
    /// The vertex.
    pub vertex: VertexId,
    /// How many, in digits: it may have 39.
    pub walks: String,
}

/// Eigenvalues of a matrix.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SpectrumDocument {
    /// `adjacency` or `laplacian`.
    pub of: &'static str,
    /// The values: the largest ones of the adjacency matrix, descending, or the smallest ones of the Laplacian, ascending.
    pub values: Vec<EigenvalueDocument>,
}

/// An eigenvalue.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct EigenvalueDocument {
    /// The value.
    pub value: f64,
    /// How far from it there is surely an eigenvalue.
    pub residual: f64,
}

/// The ranks of ∂₁ and ∂₂ over a field.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct RankDocument {
    /// The field: `Q`, or `Z/2` and so on.
    pub field: String,
    /// The rank of ∂₁.
    pub d1: usize,
    /// The rank of ∂₂.
    pub d2: usize,
    /// The Betti numbers that follow.
    pub betti: [usize; 3],
}

/// What is round some cells.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct NeighbourhoodDocument {
    /// `star`, `closure`, `link` or `boundary`.
    pub kind: &'static str,
    /// The cells that it is of, such as `v3`.
    pub of: Vec<String>,
    /// Its vertices.
    pub vertices: Listing<VertexId>,
    /// Its edges.
    pub edges: Listing<EdgeDocument>,
    /// Its faces.
    pub faces: Listing<FaceId>,
    /// Whether it contains all that its cells contain.
    pub is_complex: bool,
    /// Its dimension, if it is a complex of one dimension.
    pub pure_dimension: Option<usize>,
}

/// An edge with its ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct EdgeDocument {
    /// The edge.
    pub edge: EdgeId,
    /// The vertices that it joins.
    pub ends: [VertexId; 2],
}

impl MatrixDocument {
    /// The document of answers, with at most `limit` items in a list. The mesh is the one of which they were asked.
    ///
    /// *Cost*: that of counting cycles of three edges.
    pub fn new(
        mesh: &PolygonMesh,
        view: View,
        questions: &MatrixQuestions,
        answers: &MatrixAnswers,
        limit: usize,
    ) -> Self {
        let (incidence, graph) = (&answers.incidence, &answers.graph);
        let [vertices, edges, faces] = incidence.cell_counts();
        let [of_d1, of_d2] = incidence.entry_counts();
        let size = |rows, columns, entries| MatrixSize { rows, columns, entries };
        let table = mesh.complex().faces();
        MatrixDocument {
            schema: SCHEMA,
            file: None,
            format: None,
            view: view.name(),
            weld: view.distance(),
            d1: size(vertices, edges, of_d1),
            d2: size(edges, faces, of_d2),
            adjacency: size(vertices, vertices, 2 * graph.graph_counts()[1]),
            boundary_of_boundary_is_zero: incidence.boundary_of_boundary_is_zero(),
            lost_sides: lost_sides(incidence, limit),
            three_cycles: triangle_count(graph),
            triangles: table.faces().filter(|&face| table.corner_range(face).len() == 3).count(),
            lone_vertices: (0..vertices).filter(|&v| graph.degree(VertexId::new(v)) == 0).count(),
            arrays: ArraysDocument { incidence: incidence.arrays(), adjacency: graph.arrays() },
            walks: walks(questions, answers, limit),
            spectrum: spectrum(questions, answers),
            ranks: ranks(questions, answers),
            neighbourhoods: neighbourhoods(questions, answers, limit),
            notes: Vec::new(),
        }
    }

    /// The document with what is known of the file that the mesh was read from.
    pub fn of_file(self, name: String, file: &ReadFile) -> Self {
        let format = Some(file.variant);
        MatrixDocument { file: Some(name), format, notes: file.notes.clone(), ..self }
    }
}

fn lost_sides(incidence: &IncidenceMatrices, limit: usize) -> Listing<LostSideDocument> {
    let lost = incidence.lost_sides().iter().map(|lost| LostSideDocument {
        face: lost.face,
        edge: lost.edge,
        ends: incidence.ends(lost.edge),
        pairs: lost.pairs,
    });
    Listing::cut(lost, limit)
}

fn walks(questions: &MatrixQuestions, answers: &MatrixAnswers, limit: usize) -> Option<WalksDocument> {
    let (length, from) = questions.walks?;
    let mut to = Listing::default();
    for (vertex, &walks) in answers.walks.as_ref()?.iter().filter(|to| *to.1 > 0) {
        to.add(limit, || WalksTo { vertex, walks: walks.to_string() });
    }
    Some(WalksDocument { length, from, to })
}

fn spectrum(questions: &MatrixQuestions, answers: &MatrixAnswers) -> Option<SpectrumDocument> {
    let value = |found: &Eigenvalue| EigenvalueDocument { value: found.value, residual: found.residual };
    let values = answers.spectrum.as_ref()?.iter().map(value).collect();
    Some(SpectrumDocument { of: questions.spectrum?.0.name(), values })
}

fn ranks(questions: &MatrixQuestions, answers: &MatrixAnswers) -> Vec<RankDocument> {
    let ranks = questions.fields.iter().zip(&answers.ranks);
    let document = ranks.map(|(field, &[d1, d2])| {
        let betti = answers.incidence.betti_of_ranks([d1, d2]);
        RankDocument { field: field.to_string(), d1, d2, betti }
    });
    document.collect()
}

fn neighbourhoods(
    questions: &MatrixQuestions,
    answers: &MatrixAnswers,
    limit: usize,
) -> Vec<NeighbourhoodDocument> {
    let incidence = &answers.incidence;
    let edge = |&edge: &EdgeId| EdgeDocument { edge, ends: incidence.ends(edge) };
    let document = |((which, of), cells): (&(_, Vec<Cell>), &CellSet)| {
        let which: &crate::Neighbourhood = which;
        NeighbourhoodDocument {
            kind: which.name(),
            of: of.iter().map(Cell::to_string).collect(),
            vertices: Listing::cut(cells.vertices().iter().copied(), limit),
            edges: Listing::cut(cells.edges().iter().map(edge), limit),
            faces: Listing::cut(cells.faces().iter().copied(), limit),
            is_complex: is_complex(incidence, cells),
            pure_dimension: pure_dimension(incidence, cells),
        }
    };
    questions.neighbourhoods.iter().zip(&answers.neighbourhoods).map(document).collect()
}

#[cfg(test)]
mod tests {
    use meshmend_testkit::Soup;
    use meshmend_topology::matrices::{Field, Operator};
    use serde_json::json;

    use super::*;
    use crate::Neighbourhood;

    #[test]
    fn every_answer_is_in_it() {
        let soup = Soup::generic(5, [vec![0, 1, 2], vec![0, 2, 3], vec![0, 1, 2, 1]]);
        let mesh = soup.mesh();
        let questions = MatrixQuestions::default()
            .with_walks(2, VertexId(1))
            .with_spectrum(Operator::Laplacian, 1)
            .with_fields(vec![Field::Rationals])
            .with_neighbourhood(Neighbourhood::Link, vec![VertexId(3).into()]);
        let answers = questions.ask(mesh.complex()).unwrap();
        let document = MatrixDocument::new(&mesh, View::Indexed, &questions, &answers, 1);
        let document = serde_json::to_value(document).unwrap();
        assert_eq!(document["d2"], json!({"rows": 5, "columns": 3, "entries": 6}));
        assert_eq!(document["lost_sides"]["count"], 2);
        let lost = json!({"face": 2, "edge": 0, "ends": [0, 1], "pairs": 1});
        assert_eq!(document["lost_sides"]["items"], json!([lost]));
        assert_eq!((&document["three_cycles"], &document["triangles"]), (&json!(2), &json!(2)));
        assert_eq!(document["lone_vertices"], 1);
        let walks = json!({"count": 4, "items": [{"vertex": 0, "walks": "1"}]});
        assert_eq!(document["walks"], json!({"length": 2, "from": 1, "to": walks}));
        assert_eq!(document["ranks"], json!([{"field": "Q", "d1": 3, "d2": 2, "betti": [1, 0, 1]}]));
        let link = &document["neighbourhoods"][0];
        assert_eq!(
            (&link["kind"], &link["of"], &link["pure_dimension"]),
            (&json!("link"), &json!(["v3"]), &json!(1))
        );
        assert_eq!(link["edges"]["items"], json!([{"edge": 1, "ends": [0, 2]}]));
        assert_eq!(document["spectrum"]["of"], "laplacian");
        assert!(document["spectrum"]["values"][0]["value"].as_f64().unwrap().abs() < 1e-9);
        assert_eq!(document["arrays"]["adjacency"][0]["per"], "vertex");
    }
}
