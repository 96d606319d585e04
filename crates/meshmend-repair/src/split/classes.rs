//! The new vertices: classes of corners that are joined across matched sides.

use meshmend_core::{Column, Connectivity, CornerId, Id, VertexId};
use petgraph::unionfind::UnionFind;

use crate::StoredNames;
use crate::matching::{Matching, run_the_same_way};

/// The classes of corners, named and in order.
pub(super) struct NewVertices {
    /// The new vertex at each corner of the complex.
    pub(super) of_corner: Column<CornerId, VertexId>,
    /// For each new vertex the present vertex that it is a part of.
    pub(super) present: Vec<VertexId>,
    /// For each new vertex its point: that of its lowest vertex as stored.
    pub(super) positions: Vec<[f64; 3]>,
    /// For each present vertex the first new vertex that is a part of it.
    pub(super) first_part: Vec<VertexId>,
}

const NONE: u32 = u32::MAX;

/// Joins corners across matched sides, and across `joined` ones as well.
pub(super) fn corner_classes<K: Connectivity>(
    kernel: &K,
    matching: &Matching,
    joined: &[(CornerId, CornerId)],
) -> UnionFind<u32> {
    let mut classes = UnionFind::new(kernel.corner_count());
    for (one, other) in matching.pairs().chain(joined.iter().copied()) {
        for (here, there) in corners_that_meet(kernel, one, other) {
            classes.union(here.0, there.0);
        }
    }
    classes
}

/// The corners at each end of an edge that are one vertex when two of its sides are joined.
pub(super) fn corners_that_meet<K: Connectivity>(
    kernel: &K,
    one: CornerId,
    other: CornerId,
) -> [(CornerId, CornerId); 2] {
    let (after_one, after_other) = (kernel.next_corner(one), kernel.next_corner(other));
    if run_the_same_way(kernel, one, other) {
        [(one, other), (after_one, after_other)]
    } else {
        [(one, after_other), (after_one, other)]
    }
}

impl NewVertices {
    /// Names each class after its lowest stored vertex: the first class (by lowest corner) of each stored vertex keeps
    /// that vertex's place in the order; further classes follow at the end in corner order. Vertices in no face of
    /// the complex keep their places.
    ///
    /// *Cost*: linear.
    pub(super) fn name<K: Connectivity>(
        kernel: &K,
        names: &StoredNames<'_>,
        mut classes: UnionFind<u32>,
    ) -> Self {
        let mut lowest_name = vec![VertexId(NONE); kernel.corner_count()];
        let mut lowest_corners = Vec::new();
        for corner in kernel.corners() {
            let root = classes.find_mut(corner.0) as usize;
            if lowest_name[root].0 == NONE {
                lowest_corners.push(corner);
            }
            lowest_name[root] = lowest_name[root].min(names.of(corner));
        }
        let mut name_of = |corner: CornerId| lowest_name[classes.find_mut(corner.0) as usize];
        let mut holders = vec![Holder::Nothing; names.count()];
        let mut further = Vec::new();
        let unreferenced = kernel.vertices().filter(|&v| !kernel.is_referenced(v));
        let classes_first = lowest_corners.iter().map(|&c| (name_of(c), Holder::Class(c)));
        for (name, holder) in
            classes_first.chain(unreferenced.map(|v| (names.of_vertex(v), Holder::Alone(v))))
        {
            match &mut holders[name.index()] {
                free @ Holder::Nothing => *free = holder,
                _ => further.push((name, holder)),
            }
        }
        let in_place = holders.into_iter().enumerate().map(|(name, holder)| (VertexId::new(name), holder));
        let mut new = NewVertices {
            of_corner: Column::default(),
            present: Vec::new(),
            positions: Vec::new(),
            first_part: vec![VertexId(NONE); kernel.vertex_count()],
        };
        // The names are given, so their places can be used again.
        let mut of_root = lowest_name;
        for (name, holder) in in_place.chain(further) {
            match holder {
                Holder::Nothing => {}
                Holder::Alone(vertex) => {
                    new.push(vertex, names.position(name));
                }
                Holder::Class(corner) => {
                    let id = new.push(kernel.corner_vertex(corner), names.position(name));
                    of_root[classes.find_mut(corner.0) as usize] = id;
                }
            }
        }
        new.of_corner = kernel.corners().map(|c| of_root[classes.find_mut(c.0) as usize]).collect();
        new
    }

    fn push(&mut self, present: VertexId, position: [f64; 3]) -> VertexId {
        let id = VertexId(self.present.len() as u32);
        self.present.push(present);
        self.positions.push(position);
        let first = &mut self.first_part[present.0 as usize];
        if first.0 == NONE {
            *first = id;
        }
        id
    }
}

/// What has a name's place in the order.
#[derive(Clone, Copy)]
enum Holder {
    Nothing,
    /// The class with this lowest corner.
    Class(CornerId),
    /// A present vertex in no face of the complex.
    Alone(VertexId),
}
