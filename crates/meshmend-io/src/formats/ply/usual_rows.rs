//! Rows of text as almost all programs write them: one on each line, with numbers and at most one list, the indices
//! of a face.

use meshmend_core::{FaceTableBuilder, VertexId};

use crate::formats::ply::header::{Element, Property};
use crate::formats::ply::scalar::Scalar;
use crate::input::indices::MaxIndex;
use crate::text::speculative_parse::UsualRows;
use crate::text::usual_line::UsualLine;

/// Rows of an element.
pub(super) struct ParsedRows {
    kind: Kind,
    cells: Vec<Cell>,
    pub(super) rows: usize,
    pub(super) positions: Vec<[f64; 3]>,
    pub(super) faces: FaceTableBuilder,
    pub(super) max_index: MaxIndex,
    /// The other numbers, row by row. Doubles hold the values of every type exactly.
    pub(super) others: Vec<f64>,
}

/// What the rows are.
#[derive(Clone, Copy)]
enum Kind {
    Vertex,
    Face,
}

/// What a property is.
#[derive(Clone, Copy)]
enum Cell {
    /// A coordinate, by its axis.
    Coordinate(usize, Scalar),
    /// The indices of a face, with the types of their number and of each index.
    Indices(Scalar, Scalar),
    /// Any other number.
    Other(Scalar),
}

impl ParsedRows {
    /// An empty collection of vertices with these properties as coordinates, or `None` if they have lists.
    pub(super) fn of_vertices(element: &Element, axes: [usize; 3]) -> Option<Self> {
        let cell = |(column, property): (usize, &Property)| {
            let axis = axes.iter().position(|&axis| axis == column);
            let item = property.item;
            property
                .length
                .is_none()
                .then(|| axis.map_or(Cell::Other(item), |axis| Cell::Coordinate(axis, item)))
        };
        let cells = element.properties.iter().enumerate().map(cell).collect::<Option<_>>()?;
        Some(ParsedRows::of(Kind::Vertex, cells))
    }

    /// An empty collection of faces with this property as indices, or `None` if they have other lists.
    pub(super) fn of_faces(element: &Element, list: usize) -> Option<Self> {
        let cell = |(column, property): (usize, &Property)| match property.length {
            None => Some(Cell::Other(property.item)),
            Some(length) => (column == list).then_some(Cell::Indices(length, property.item)),
        };
        let cells = element.properties.iter().enumerate().map(cell).collect::<Option<_>>()?;
        Some(ParsedRows::of(Kind::Face, cells))
    }

    fn of(kind: Kind, cells: Vec<Cell>) -> Self {
        let (positions, others) = (Vec::new(), Vec::new());
        let (faces, max_index) = (FaceTableBuilder::default(), MaxIndex::default());
        ParsedRows { kind, cells, rows: 0, positions, faces, max_index, others }
    }

    #[inline]
    fn row(&mut self, mut line: UsualLine<'_>, point: &mut [f64; 3]) -> Option<usize> {
        for &cell in &self.cells {
            match cell {
                Cell::Coordinate(axis, scalar) => point[axis] = number(&mut line, scalar)?,
                Cell::Other(scalar) => self.others.push(number(&mut line, scalar)?),
                Cell::Indices(length, item) => {
                    for _ in 0..whole(&mut line, length)? {
                        let vertex = whole(&mut line, item)?;
                        self.max_index.see(vertex, line.at - 1);
                        self.faces.push_corner(VertexId(vertex));
                    }
                }
            }
        }
        line.end()
    }
}

impl UsualRows for ParsedRows {
    fn none(&self) -> Self {
        ParsedRows::of(self.kind, self.cells.clone())
    }

    fn clear(&mut self) {
        self.rows = 0;
        self.positions.clear();
        self.faces.clear();
        self.max_index = MaxIndex::default();
        self.others.clear();
    }

    #[inline]
    fn add(&mut self, text: &[u8], at: usize) -> Option<usize> {
        let (others, max_index, mut point) = (self.others.len(), self.max_index, [0.0; 3]);
        let end = self.row(UsualLine::from(text, at), &mut point);
        if end.is_none() {
            self.others.truncate(others);
            self.max_index = max_index;
            self.faces.abandon_face();
            return None;
        }
        match self.kind {
            Kind::Vertex => self.positions.push(point),
            Kind::Face => self.faces.end_face(),
        }
        self.rows += 1;
        end
    }
}

#[inline]
fn number(line: &mut UsualLine<'_>, scalar: Scalar) -> Option<f64> {
    match scalar {
        Scalar::F32 => line.real::<f32>().map(f64::from),
        Scalar::F64 => line.real::<f64>(),
        _ => whole(line, scalar).map(f64::from),
    }
}

/// A whole number within the range of its type.
#[inline]
fn whole(line: &mut UsualLine<'_>, scalar: Scalar) -> Option<u32> {
    line.whole().filter(|&value| i64::from(value) <= scalar.range().1)
}
