//! What a pass fixed, in little memory.

use meshmend_core::{Defect, EdgeId, Id, SharedPlaces, VertexId};

/// What was wrong and no longer is, by ids of the mesh before.
///
/// Welding a soup of ten million triangles joins twenty-five million vertices, and turning half of its faces fixes seven
/// million edges, so those are kept as bare numbers and are made into defects as they are asked for.
#[derive(Clone, Debug, Default)]
pub struct Fixed {
    listed: Vec<Defect>,
    /// Inconsistent edges with their ends, ascending.
    turned: Vec<(EdgeId, [VertexId; 2])>,
    joined_to: JoinedTo,
    joined: usize,
}

/// For each vertex the one that it was joined to, or itself.
#[derive(Clone, Debug)]
enum JoinedTo {
    Listed(Vec<VertexId>),
    /// The first vertex at the place of each.
    Places(SharedPlaces, Vec<VertexId>),
}

impl Default for JoinedTo {
    fn default() -> Self {
        JoinedTo::Listed(Vec::new())
    }
}

impl JoinedTo {
    fn of(&self, vertex: usize) -> VertexId {
        match self {
            JoinedTo::Listed(listed) => listed[vertex],
            JoinedTo::Places(places, first) => first[places.of_vertex()[vertex].index()],
        }
    }

    fn len(&self) -> usize {
        match self {
            JoinedTo::Listed(listed) => listed.len(),
            JoinedTo::Places(places, _) => places.of_vertex().len(),
        }
    }
}

impl Fixed {
    /// The vertices that were joined to others: for each vertex the lowest one of its class.
    pub(crate) fn joined(joined_to: Vec<VertexId>) -> Self {
        let joined = joined_to.iter().enumerate().filter(|(v, low)| low.index() != *v).count();
        Fixed { joined_to: JoinedTo::Listed(joined_to), joined, ..Fixed::default() }
    }

    /// The vertices that were joined to the first one at their place.
    pub(crate) fn sharing(places: SharedPlaces, first: Vec<VertexId>) -> Self {
        let joined = places.of_vertex().len() - first.len();
        Fixed { joined_to: JoinedTo::Places(places, first), joined, ..Fixed::default() }
    }

    /// Inconsistent edges with their ends, ascending, and faces that went before they could be turned.
    pub(crate) fn turned(turned: Vec<(EdgeId, [VertexId; 2])>, faces: Vec<Defect>) -> Self {
        Fixed { turned, ..faces.into() }
    }

    /// How many defects were fixed.
    pub fn len(&self) -> usize {
        self.listed.len() + self.turned.len() + self.joined
    }

    /// Whether there was nothing to fix.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The defects, by kind and id.
    pub fn iter(&self) -> impl Iterator<Item = Defect> + '_ {
        let joined = self.joined_vertices().map(|(v, original)| Defect::coincident_vertex(v, original));
        let turned = self.turned.iter().map(|&(edge, ends)| Defect::inconsistent_edge(edge, ends));
        // A pass joins vertices or turns faces; those that it drops come before edges.
        self.listed.iter().cloned().chain(turned).chain(joined)
    }

    /// The vertices that were joined to others, ascending, each with the one that it was joined to.
    pub fn joined_vertices(&self) -> impl Iterator<Item = (VertexId, VertexId)> + '_ {
        let all = (0..self.joined_to.len()).map(|vertex| (VertexId::new(vertex), self.joined_to.of(vertex)));
        all.filter(|(vertex, low)| vertex != low)
    }

    /// The defects but for vertices that were joined and edges whose faces were turned.
    pub(crate) fn listed(&self) -> &[Defect] {
        &self.listed
    }
}

impl From<Vec<Defect>> for Fixed {
    /// Sorts them by kind and id.
    fn from(mut listed: Vec<Defect>) -> Self {
        listed.sort();
        Fixed { listed, ..Fixed::default() }
    }
}
