//! Star, closure and link: the neighbourhood of some cells.
//!
//! ```text
//! closure   the cells, and all that they contain                faces → edges → vertices
//! star      the cells, and all that contain one of them         vertices → edges → faces
//! link      closure of the star, less the star of the closure   the rim of the neighbourhood
//! ```
//!
//! In a triangle mesh a vertex is a disc just when its link is one cycle, and a half-disc when it is one path.
//!
//! Each needs to know what touches what, and nothing else, so it takes any [`Incidence`]: the matrices, and every kernel.

use meshmend_core::{Cell, EdgeId, FaceId, Incidence, VertexId};

/// Vertices, edges and faces, each once, ascending.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct CellSet {
    vertices: Vec<VertexId>,
    edges: Vec<EdgeId>,
    faces: Vec<FaceId>,
}

impl CellSet {
    /// The vertices, edges and faces among some cells. A corner is left out: these sets know none.
    pub fn of(cells: impl IntoIterator<Item = Cell>) -> Self {
        let mut set = CellSet::default();
        for cell in cells {
            match cell {
                Cell::Vertex(vertex) => set.vertices.push(vertex),
                Cell::Edge(edge) => set.edges.push(edge),
                Cell::Face(face) => set.faces.push(face),
                Cell::Corner(_) => {}
            }
        }
        CellSet::from_parts(set.vertices, set.edges, set.faces)
    }

    /// A set of these cells, in any order.
    pub(super) fn from_parts(
        mut vertices: Vec<VertexId>,
        mut edges: Vec<EdgeId>,
        mut faces: Vec<FaceId>,
    ) -> Self {
        sort_once(&mut vertices);
        sort_once(&mut edges);
        sort_once(&mut faces);
        CellSet { vertices, edges, faces }
    }

    /// The vertices, ascending.
    pub fn vertices(&self) -> &[VertexId] {
        &self.vertices
    }

    /// The edges, ascending.
    pub fn edges(&self) -> &[EdgeId] {
        &self.edges
    }

    /// The faces, ascending.
    pub fn faces(&self) -> &[FaceId] {
        &self.faces
    }

    /// How many vertices, edges and faces are in it.
    pub fn counts(&self) -> [usize; 3] {
        [self.vertices.len(), self.edges.len(), self.faces.len()]
    }

    /// Whether nothing is in it.
    pub fn is_empty(&self) -> bool {
        self.counts() == [0; 3]
    }

    /// The first of its cells that a structure does not have. The functions of this page take sets without one.
    pub fn missing_from(&self, view: &impl Incidence) -> Option<Cell> {
        let [vertices, edges, faces] = view.cell_counts();
        let vertex = self.vertices.last().filter(|vertex| vertex.0 as usize >= vertices);
        let edge = self.edges.last().filter(|edge| edge.0 as usize >= edges);
        let face = self.faces.last().filter(|face| face.0 as usize >= faces);
        let first = vertex.map(|&vertex| vertex.into()).or(edge.map(|&edge| edge.into()));
        first.or(face.map(|&face| face.into()))
    }

    /// The cells that are not in another set.
    #[must_use]
    pub fn without(&self, other: &CellSet) -> CellSet {
        CellSet {
            vertices: difference(&self.vertices, &other.vertices),
            edges: difference(&self.edges, &other.edges),
            faces: difference(&self.faces, &other.faces),
        }
    }
}

/// The smallest complex that contains some cells: they, the edges of the faces, and the ends of all these edges.
///
/// *Cost*: n log n for n cells in the answer.
pub fn closure(view: &impl Incidence, cells: &CellSet) -> CellSet {
    let mut edges = cells.edges.clone();
    edges.extend(cells.faces.iter().flat_map(|&face| view.edges_of(face)));
    sort_once(&mut edges);
    let mut vertices = cells.vertices.clone();
    vertices.extend(edges.iter().flat_map(|&edge| view.ends(edge)));
    CellSet::from_parts(vertices, edges, cells.faces.clone())
}

/// All cells that contain one of some cells: they, the edges at the vertices, and the faces along all these edges.
///
/// *Cost*: n log n for n cells in the answer.
pub fn star(view: &impl Incidence, cells: &CellSet) -> CellSet {
    let mut edges = cells.edges.clone();
    edges.extend(cells.vertices.iter().flat_map(|&vertex| view.edges_at(vertex)));
    sort_once(&mut edges);
    let mut faces = cells.faces.clone();
    faces.extend(edges.iter().flat_map(|&edge| view.faces_along(edge)));
    CellSet::from_parts(cells.vertices.clone(), edges, faces)
}

/// The closure of the star of some cells, without the star of their closure.
///
/// ```
/// use meshmend_core::{FaceTable, PolygonMesh, VertexId};
/// use meshmend_topology::matrices::{CellSet, IncidenceMatrices, link};
///
/// // In a tetrahedron the link of a vertex is the triangle opposite to it, without the face.
/// let faces = [0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0].map(VertexId).to_vec();
/// let mesh = PolygonMesh::new(vec![[0.0; 3]; 4], FaceTable::triangles(4, faces)?)?;
/// let matrices = IncidenceMatrices::of(mesh.complex());
/// let link = link(&matrices, &CellSet::of([VertexId(0).into()]));
/// assert_eq!(link.counts(), [3, 3, 0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// *Cost*: n log n for n cells in the closure of the star and the star of the closure.
pub fn link(view: &impl Incidence, cells: &CellSet) -> CellSet {
    closure(view, &star(view, cells)).without(&star(view, &closure(view, cells)))
}

/// Whether some cells are a complex: they contain the edges of their faces and the ends of their edges.
///
/// *Cost*: that of [`closure`].
pub fn is_complex(view: &impl Incidence, cells: &CellSet) -> bool {
    closure(view, cells) == *cells
}

/// The dimension of some cells that are a complex of one dimension: the closure of their faces alone (2), edges alone (1)
/// or vertices alone (0). `None` if they are not, or there are none.
///
/// *Cost*: that of [`closure`].
pub fn pure_dimension(view: &impl Incidence, cells: &CellSet) -> Option<usize> {
    let dimension = cells.counts().iter().rposition(|&count| count > 0)?;
    let mut top = CellSet::default();
    match dimension {
        0 => top.vertices.clone_from(&cells.vertices),
        1 => top.edges.clone_from(&cells.edges),
        _ => top.faces.clone_from(&cells.faces),
    }
    (closure(view, &top) == *cells).then_some(dimension)
}

fn sort_once<T: Ord>(items: &mut Vec<T>) {
    items.sort_unstable();
    items.dedup();
}

/// The items of an ascending list that are not in another one.
fn difference<T: Ord + Copy>(items: &[T], others: &[T]) -> Vec<T> {
    let mut others = others.iter().peekable();
    let is_other = |item: &T| {
        while others.next_if(|&other| other < item).is_some() {}
        others.peek() == Some(&item)
    };
    let mut is_other = is_other;
    items.iter().copied().filter(|item| !is_other(item)).collect()
}

#[cfg(test)]
mod tests {
    use meshmend_core::CornerId;

    use super::*;
    use crate::shapes::{self, Shape};

    fn at(vertex: u32) -> CellSet {
        CellSet::of([VertexId(vertex).into()])
    }

    #[test]
    fn a_set_is_sorted_and_knows_no_corners() {
        let cells: [Cell; 4] = [FaceId(2).into(), VertexId(1).into(), CornerId(0).into(), VertexId(1).into()];
        let set = CellSet::of(cells);
        assert_eq!((set.vertices(), set.counts()), (&[VertexId(1)][..], [1, 0, 1]));
        let kernel = shapes::tetrahedron().kernel();
        assert_eq!(set.missing_from(&kernel), None);
        assert_eq!(at(4).missing_from(&kernel), Some(Cell::Vertex(VertexId(4))));
        assert_eq!(CellSet::of([EdgeId(6).into()]).missing_from(&kernel), Some(Cell::Edge(EdgeId(6))));
        assert_eq!(CellSet::of([FaceId(4).into()]).missing_from(&kernel), Some(Cell::Face(FaceId(4))));
    }

    #[test]
    fn star_and_closure_stay_when_taken_twice() {
        let kernel = shapes::torus(4, 5).kernel();
        let cells = CellSet::of([VertexId(3).into(), EdgeId(7).into(), FaceId(11).into()]);
        let (closed, around) = (closure(&kernel, &cells), star(&kernel, &cells));
        assert_eq!((closure(&kernel, &closed), star(&kernel, &around)), (closed.clone(), around));
        assert!(is_complex(&kernel, &closed) && !is_complex(&kernel, &cells));
    }

    #[test]
    fn links_of_the_textbook() {
        let kernel = shapes::tetrahedron().kernel();
        assert_eq!(link(&kernel, &at(0)).counts(), [3, 3, 0]);
        // The link of an edge are the two vertices opposite to it; a face has none.
        let edge = CellSet::of([EdgeId(0).into()]);
        assert_eq!(link(&kernel, &edge).counts(), [2, 0, 0]);
        let pair = shapes::bow_tie().kernel();
        assert_eq!(link(&pair, &at(2)).counts(), [4, 2, 0]);
        assert!(link(&kernel, &CellSet::of([FaceId(0).into()])).is_empty());
    }

    #[test]
    fn dimensions() {
        let kernel = Shape::of(&[&[0, 1, 2], &[1, 3, 2]]).kernel();
        let face = closure(&kernel, &CellSet::of([FaceId(0).into()]));
        assert_eq!(pure_dimension(&kernel, &face), Some(2));
        assert_eq!(pure_dimension(&kernel, &at(3)), Some(0));
        assert_eq!(pure_dimension(&kernel, &CellSet::default()), None);
        let mixed = CellSet::from_parts(
            [face.vertices(), &[VertexId(3)]].concat(),
            face.edges().to_vec(),
            face.faces().to_vec(),
        );
        assert!(is_complex(&kernel, &mixed));
        assert_eq!(pure_dimension(&kernel, &mixed), None);
        assert_eq!(pure_dimension(&kernel, &CellSet::of([EdgeId(0).into()])), None);
    }
}
