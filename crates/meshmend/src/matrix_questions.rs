//! Questions to the matrices of a mesh, asked together.

use meshmend_core::{Adjacency, Cell, Column, Complex, FaceId, Id, VertexId};
use meshmend_topology::matrices::{
    CellSet, Eigenvalue, Field, Graph, IncidenceMatrices, Operator, RankError, SpectrumError, closure, link,
    spectrum, star, walks,
};
use thiserror::Error;

/// What is asked of the matrices of a mesh.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct MatrixQuestions {
    /// How many walks of this length lead from this vertex to each other one.
    pub walks: Option<(u32, VertexId)>,
    /// So many eigenvalues.
    pub spectrum: Option<(Operator, usize)>,
    /// The ranks of ∂₁ and ∂₂ over these fields.
    pub fields: Vec<Field>,
    /// What is round these cells.
    pub neighbourhoods: Vec<(Neighbourhood, Vec<Cell>)>,
}

/// A set of cells that belongs to others.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Neighbourhood {
    /// All that contains one of them.
    Star,
    /// All that they contain.
    Closure,
    /// The closure of the star without the star of the closure.
    Link,
    /// What is in one of them alone, and all that it contains.
    Boundary,
}

impl Neighbourhood {
    /// What it is called in commands and reports.
    pub fn name(self) -> &'static str {
        match self {
            Neighbourhood::Star => "star",
            Neighbourhood::Closure => "closure",
            Neighbourhood::Link => "link",
            Neighbourhood::Boundary => "boundary",
        }
    }
}

/// The matrices of a mesh, and the answers.
#[derive(Clone, Debug)]
pub struct MatrixAnswers {
    /// ∂₁ and ∂₂.
    pub incidence: IncidenceMatrices,
    /// The adjacency matrix.
    pub graph: Graph,
    /// The number of walks to each vertex.
    pub walks: Option<Column<VertexId, u128>>,
    /// The eigenvalues, in the order of the question.
    pub spectrum: Option<Vec<Eigenvalue>>,
    /// The ranks over each field.
    pub ranks: Vec<[usize; 2]>,
    /// The neighbourhoods.
    pub neighbourhoods: Vec<CellSet>,
}

/// Why a question to the matrices of a mesh has no answer.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum MatrixError {
    /// The mesh has no such cell.
    #[error("there is no {cell} in the mesh")]
    NoSuchCell {
        /// The cell.
        cell: Cell,
    },
    /// A face is degenerate.
    #[error("{face} is degenerate, so it is not a cell of the complex")]
    Degenerate {
        /// The face.
        face: FaceId,
    },
    /// There are more walks than a number holds.
    #[error(
        "there are 2^128 walks of length {length} from {from} to some vertex, or more, which is not counted"
    )]
    TooManyWalks {
        /// How long they are.
        length: u32,
        /// Where they begin.
        from: VertexId,
    },
    /// The ranks can't be found.
    #[error(transparent)]
    Rank(#[from] RankError),
    /// The eigenvalues can't be found.
    #[error(transparent)]
    Spectrum(#[from] SpectrumError),
    /// The cells are not a complex of one dimension.
    #[error(
        "only the closure of some faces, of some edges or of some vertices has a boundary; --closure shows what is missing"
    )]
    NoBoundary,
}

impl MatrixQuestions {
    /// These questions with that for walks of a length from a vertex.
    #[must_use]
    pub fn with_walks(self, length: u32, from: VertexId) -> Self {
        MatrixQuestions { walks: Some((length, from)), ..self }
    }

    /// These questions with that for so many eigenvalues.
    #[must_use]
    pub fn with_spectrum(self, operator: Operator, count: usize) -> Self {
        MatrixQuestions { spectrum: Some((operator, count)), ..self }
    }

    /// These questions with that for the ranks over fields.
    #[must_use]
    pub fn with_fields(self, fields: Vec<Field>) -> Self {
        MatrixQuestions { fields, ..self }
    }

    /// These questions with that for what is round some cells.
    #[must_use]
    pub fn with_neighbourhood(mut self, which: Neighbourhood, cells: Vec<Cell>) -> Self {
        self.neighbourhoods.push((which, cells));
        self
    }

    /// Asks them of a complex.
    ///
    /// ```
    /// use meshmend::{FaceTable, MatrixQuestions, PolygonMesh, VertexId};
    /// # let faces = [0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0].map(VertexId).to_vec();
    /// # let mesh = PolygonMesh::new(vec![[0.0; 3]; 4], FaceTable::triangles(4, faces)?)?;
    ///
    /// // The walks of four steps in a tetrahedron: 21 come back.
    /// let answers = MatrixQuestions::default().with_walks(4, VertexId(0)).ask(mesh.complex())?;
    /// assert_eq!(answers.walks.map(|walks| walks.into_vec()), Some(vec![21, 20, 20, 20]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// When a cell does not exist or a face is degenerate; when there is no answer within the limits of the questions.
    ///
    /// *Cost*: that of the matrices and of each question.
    pub fn ask(&self, complex: &Complex) -> Result<MatrixAnswers, MatrixError> {
        let (incidence, graph) = (IncidenceMatrices::of(complex), Graph::of(complex));
        let walks = self.walks.map(|(length, from)| walks_from(&graph, length, from)).transpose()?;
        let spectrum =
            self.spectrum.map(|(operator, count)| spectrum(&graph, operator, count)).transpose()?;
        let ranks = self.fields.iter().map(|&field| incidence.ranks(field)).collect::<Result<_, _>>()?;
        let asked = self.neighbourhoods.iter();
        let neighbourhoods =
            asked.map(|(which, cells)| neighbourhood(&incidence, *which, cells)).collect::<Result<_, _>>()?;
        Ok(MatrixAnswers { incidence, graph, walks, spectrum, ranks, neighbourhoods })
    }
}

fn walks_from(graph: &Graph, length: u32, from: VertexId) -> Result<Column<VertexId, u128>, MatrixError> {
    if from.index() >= graph.graph_counts()[0] {
        return Err(MatrixError::NoSuchCell { cell: from.into() });
    }
    walks(graph, length, from).ok_or(MatrixError::TooManyWalks { length, from })
}

fn neighbourhood(
    incidence: &IncidenceMatrices,
    which: Neighbourhood,
    cells: &[Cell],
) -> Result<CellSet, MatrixError> {
    let cells = CellSet::of(cells.iter().copied());
    if let Some(cell) = cells.missing_from(incidence) {
        return Err(MatrixError::NoSuchCell { cell });
    }
    if let Some(&face) = cells.faces().iter().find(|&&face| !incidence.is_proper(face)) {
        return Err(MatrixError::Degenerate { face });
    }
    match which {
        Neighbourhood::Star => Ok(star(incidence, &cells)),
        Neighbourhood::Closure => Ok(closure(incidence, &cells)),
        Neighbourhood::Link => Ok(link(incidence, &cells)),
        Neighbourhood::Boundary => incidence.boundary(&cells).ok_or(MatrixError::NoBoundary),
    }
}

#[cfg(test)]
mod tests {
    use meshmend_core::EdgeId;
    use meshmend_testkit::{Soup, assert_every_variant};
    use meshmend_topology::matrices::{MOST_EIGENVALUES, Prime};

    use super::*;

    fn refusal(questions: &MatrixQuestions) -> MatrixError {
        let soup = Soup::generic(5, [vec![0, 1, 2], vec![1, 2, 3], vec![4, 4, 4]]);
        questions.ask(&soup.complex()).unwrap_err()
    }

    #[test]
    fn what_has_no_answer() {
        let none = MatrixQuestions::default;
        let round = |which, cell: Cell| none().with_neighbourhood(which, vec![cell]);
        let many = MOST_EIGENVALUES + 1;
        let cases = vec![
            (none().with_walks(1, VertexId(5)), "there is no v5 in the mesh"),
            (round(Neighbourhood::Star, EdgeId(99).into()), "there is no e99 in the mesh"),
            (
                round(Neighbourhood::Closure, FaceId(2).into()),
                "f2 is degenerate, so it is not a cell of the complex",
            ),
            (
                none().with_walks(1000, VertexId(0)),
                "there are 2^128 walks of length 1000 from v0 to some vertex, or more, which is not counted",
            ),
            (none().with_spectrum(Operator::Laplacian, many), "up to 32 eigenvalues are found, not 33"),
            (
                round(Neighbourhood::Boundary, FaceId(0).into()),
                "only the closure of some faces, of some edges or of some vertices has a boundary; --closure shows what is missing",
            ),
        ];
        let mut cases: Vec<_> =
            cases.into_iter().map(|(questions, message)| (refusal(&questions), message.to_owned())).collect();
        let grid = meshmend_testkit::shapes::torus(30, 30, meshmend_testkit::shapes::Tiles::Quads);
        let large = none().with_fields(vec![Field::Modulo(Prime::TWO), Field::Rationals]);
        let refused = large.ask(&grid.soup.complex()).unwrap_err();
        let message = refused.to_string();
        assert!(message.contains("there are 3600"), "{message}");
        cases.push((refused, message));
        assert_every_variant!(
            cases,
            MatrixError { NoSuchCell, Degenerate, TooManyWalks, Rank, Spectrum, NoBoundary }
        );
    }
}
