//! A winged edge as a lecture draws it, correct but for one mistake of choice.
//!
//! What it claims is a matter of its type. Every other mistake is chosen for the whole process, since each student is
//! examined in a process of its own, and one type is compiled once.
//!
//! An edge has its two ends, the corners whose sides run along it, forwards and backwards, and at each end the next edge
//! clockwise and counter-clockwise. Wings go on round a hole at the boundary.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicU8, Ordering::Relaxed};

use meshmend_core::{
    Array, Capabilities, Cell, Complex, Connectivity, CornerId, EdgeId, FaceId, Id, ManifoldConnectivity,
    Per, Pointer, Target, VertexId,
};

/// No mistake.
pub(crate) const NONE: u8 = 0;
/// The way round a face follows the first wing of the end that an edge names second, whichever way the edge is walked.
pub(crate) const FOLLOWS_FIRST_WING: u8 = 1;
/// Clockwise is taken for counter-clockwise at the smaller end of an edge.
pub(crate) const CLOCKWISE: u8 = 2;
/// A walk about a vertex ends where an edge comes again that is never met.
pub(crate) const ENDLESS_WALK: u8 = 3;
/// Edges have their numbers in the order in which faces name them.
pub(crate) const AS_MET: u8 = 4;
/// A face begins at its side along the edge that is lowest.
pub(crate) const BEGINS_ANYWHERE: u8 = 5;
/// A boundary edge has no wing beside the hole.
pub(crate) const NO_BOUNDARY_WING: u8 = 6;
/// It says that it holds edges whose sides run the same way.
pub(crate) const CLAIMS_MIXED: u8 = 1;
/// It says that it holds vertices with several umbrellas.
pub(crate) const CLAIMS_PINCHED: u8 = 2;
/// It says that it holds edges of three sides.
pub(crate) const CLAIMS_BOOKS: u8 = 3;
/// The list of corners at a vertex grows without end.
pub(crate) const TAKES_MEMORY: u8 = 7;
/// So does a list that is made when the kernel is.
pub(crate) const TAKES_MEMORY_AT_ONCE: u8 = 8;
/// A walk about a vertex goes on and gives no answer.
pub(crate) const SILENT_WALK: u8 = 9;
/// The kernel is not assembled within any time.
pub(crate) const ENDLESS_ASSEMBLY: u8 = 10;
/// A question asks itself.
pub(crate) const ENDLESS_RECURSION: u8 = 11;
/// The corners along an edge are looked for in the whole list.
pub(crate) const SEARCHES: u8 = 12;
/// A face is thought to be a third of the corner.
pub(crate) const FACE_IS_A_THIRD: u8 = 13;
/// One array is left out of the bytes.
pub(crate) const FORGETS_AN_ARRAY: u8 = 14;
/// An overridden answer is another one than the provided one.
pub(crate) const OWN_DEGREE: u8 = 15;
/// It ends the process.
pub(crate) const EXITS: u8 = 16;

/// A degenerate face is not counted.
pub(crate) const FORGETS_DEGENERATE: u8 = 17;
/// The sides of an edge come in the order of the record.
pub(crate) const AS_RECORDED: u8 = 18;
/// A star begins at the lowest corner, on the boundary too.
pub(crate) const BEGINS_LOWEST: u8 = 19;
/// The boundary leads to itself.
pub(crate) const ACROSS_ITSELF: u8 = 20;
/// Two arrays have one name.
pub(crate) const ONE_NAME: u8 = 21;
/// The arrays are not all that there is.
pub(crate) const LEAVES_AN_ARRAY_OUT: u8 = 22;
/// A pointer leads out of the mesh.
pub(crate) const POINTS_OUTSIDE: u8 = 23;
/// A pointer that is called `twin` leads to the next corner.
pub(crate) const TWIN_IS_NEXT: u8 = 24;
/// What is opposite is the corner itself.
pub(crate) const OPPOSITE_ITSELF: u8 = 25;
/// It holds less than it is asked for.
pub(crate) const HOLDS_LITTLE: u8 = 4;
/// An answer is wrong where a face has five corners or more.
pub(crate) const WRONG_ON_PENTAGONS: u8 = 26;

/// The mistake that is made in this process.
static MISTAKE: AtomicU8 = AtomicU8::new(NONE);

/// Has every student of this process make a mistake.
pub(crate) fn make(mistake: u8) {
    MISTAKE.store(mistake, Relaxed);
}

fn mistake() -> u8 {
    MISTAKE.load(Relaxed)
}

/// What is not there.
const NOTHING: usize = usize::MAX;

/// The edges of a mesh with their wings.
pub(crate) struct Student<const CLAIM: u8> {
    edges: Vec<Record>,
    /// The edge along which a corner's side runs, and whether it runs backwards.
    side: Vec<(usize, usize)>,
    /// The first corner of each face, the corner after the last one, and the lowest corner at each vertex.
    face: Vec<[usize; 2]>,
    vertex: Vec<usize>,
}

/// An edge. What belongs to an end is a pair: at the smaller end, at the larger one.
#[derive(Clone, Copy)]
struct Record {
    ends: [usize; 2],
    /// The corners of the forward and of the backward side.
    corners: [usize; 2],
    /// The next edge clockwise and counter-clockwise at each end.
    wings: [[usize; 2]; 2],
}

const CLOCK: usize = 0;
const COUNTER: usize = 1;

impl<const CLAIM: u8> Student<CLAIM> {
    /// The faces as lists of vertices, and the edges without their wings.
    fn of_faces(faces: &[Vec<usize>], vertex_count: usize) -> Self {
        let mut numbers: BTreeMap<[usize; 2], usize> = BTreeMap::new();
        let ends_of = |face: &[usize], i: usize| [face[i], face[(i + 1) % face.len()]];
        let sorted = |[a, b]: [usize; 2]| [a.min(b), a.max(b)];
        let all: Vec<[usize; 2]> =
            faces.iter().flat_map(|face| (0..face.len()).map(|i| sorted(ends_of(face, i)))).collect();
        all.iter().for_each(|ends| numbers.extend([(*ends, 0)]));
        let mut order: Vec<[usize; 2]> = numbers.keys().copied().collect();
        if mistake() == AS_MET {
            order.sort_by_key(|ends| all.iter().position(|met| met == ends));
        }
        order.iter().enumerate().for_each(|(number, ends)| numbers.extend([(*ends, number)]));
        let record = |&ends| Record { ends, corners: [NOTHING; 2], wings: [[NOTHING; 2]; 2] };
        let mut kernel = Student {
            edges: order.iter().map(record).collect(),
            side: Vec::new(),
            face: Vec::new(),
            vertex: vec![NOTHING; vertex_count],
        };
        for face in faces {
            let first = kernel.side.len();
            kernel.face.push([first, first + face.len()]);
            for i in 0..face.len() {
                let (ends, corner) = (ends_of(face, i), first + i);
                let (edge, way) = (numbers[&sorted(ends)], usize::from(ends[0] > ends[1]));
                kernel.edges[edge].corners[way] = corner;
                kernel.side.push((edge, way));
                if kernel.vertex[ends[0]] == NOTHING {
                    kernel.vertex[ends[0]] = corner;
                }
            }
        }
        kernel
    }

    /// Sets the wings at a vertex: in a face, the side that leaves a vertex has the one that comes to it counter-clockwise.
    fn join(&mut self, leaves: usize, comes: usize, vertex: usize) {
        let (leaving, coming) = (self.end(leaves, vertex), self.end(comes, vertex));
        self.edges[leaves].wings[leaving][COUNTER] = comes;
        self.edges[comes].wings[coming][CLOCK] = leaves;
    }

    fn next(&self, corner: usize) -> usize {
        let (edge, way) = self.side[corner];
        let record = self.edges[edge];
        let far = record.ends[1 - way];
        let end = if mistake() == FOLLOWS_FIRST_WING { 1 } else { 1 - way };
        let turn = if mistake() == CLOCKWISE && end == 0 { COUNTER } else { CLOCK };
        let next = record.wings[end][turn];
        self.edges[next].corners[usize::from(self.edges[next].ends[0] != far)]
    }

    fn prev(&self, corner: usize) -> usize {
        let (edge, way) = self.side[corner];
        let record = self.edges[edge];
        let before = record.wings[way][COUNTER];
        self.edges[before].corners[usize::from(self.edges[before].ends[1] != record.ends[way])]
    }

    fn origin(&self, corner: usize) -> usize {
        let (edge, way) = self.side[corner];
        self.edges[edge].ends[way]
    }

    /// At which of its ends an edge has a vertex.
    fn end(&self, edge: usize, vertex: usize) -> usize {
        usize::from(self.edges[edge].ends[1] == vertex)
    }

    /// The corner of the side along an edge that leaves a vertex.
    fn leaving(&self, edge: usize, vertex: usize) -> usize {
        self.edges[edge].corners[self.end(edge, vertex)]
    }

    /// The first edge at a vertex: the one that has the hole clockwise of it, or that of the lowest corner.
    fn first_edge(&self, vertex: usize) -> usize {
        let Some(&(lowest, _)) = self.side.get(self.vertex[vertex]) else { return NOTHING };
        let mut edge = lowest;
        loop {
            let end = self.end(edge, vertex);
            if self.edges[edge].corners[1 - end] == NOTHING {
                return edge;
            }
            edge = self.edges[edge].wings[end][CLOCK];
            if edge == lowest {
                return edge;
            }
        }
    }

    /// Sets the wings beside the holes: the last edge of each fan has the first one counter-clockwise.
    fn join_holes(&mut self) {
        for vertex in 0..self.vertex.len() {
            let first = self.first_edge(vertex);
            if first == NOTHING || self.edges[first].corners[1 - self.end(first, vertex)] != NOTHING {
                continue;
            }
            let mut last = first;
            while self.leaving(last, vertex) != NOTHING {
                last = self.edges[last].wings[self.end(last, vertex)][COUNTER];
            }
            self.join(last, first, vertex);
        }
    }
}

/// A walk about a vertex from edge to edge, counter-clockwise.
#[derive(Clone)]
struct Star<'a, const CLAIM: u8> {
    kernel: &'a Student<CLAIM>,
    vertex: usize,
    first: usize,
    edge: usize,
    is_over: bool,
}

impl<const CLAIM: u8> Iterator for Star<'_, CLAIM> {
    type Item = CornerId;
    fn next(&mut self) -> Option<CornerId> {
        while !self.is_over {
            let corner = self.kernel.leaving(self.edge, self.vertex);
            let record = self.kernel.edges[self.edge];
            self.edge = record.wings[self.kernel.end(self.edge, self.vertex)][COUNTER];
            self.is_over = self.edge == self.first && mistake() != ENDLESS_WALK;
            if corner != NOTHING {
                return Some(CornerId::new(corner));
            }
            while mistake() == SILENT_WALK {
                std::hint::spin_loop();
            }
            let mut all = Vec::new();
            while mistake() == TAKES_MEMORY {
                all.push([corner; 64]);
            }
        }
        None
    }
}

impl<const CLAIM: u8> Connectivity for Student<CLAIM> {
    const NAME: &'static str = "student";
    const CAPABILITIES: Capabilities = Capabilities {
        mixed_orientation: CLAIM == CLAIMS_MIXED,
        polygons: CLAIM != HOLDS_LITTLE,
        non_manifold_vertices: CLAIM == CLAIMS_PINCHED || CLAIM == CLAIMS_BOOKS,
        non_manifold_edges: CLAIM == CLAIMS_BOOKS,
        ordered_vertex_stars: true,
        ..Capabilities::ORIENTED_SURFACES
    };

    fn assemble(complex: &Complex) -> Self {
        let table = complex.faces();
        let list = |face| table.face_vertices(face).iter().map(|vertex| vertex.index()).collect();
        let faces: Vec<Vec<usize>> = table.faces().map(list).collect();
        let mut kernel = Self::of_faces(&faces, table.vertex_count());
        for &[first, end] in &kernel.face.clone() {
            for corner in first..end {
                let before = if corner == first { end - 1 } else { corner - 1 };
                let [leaves, comes] = [corner, before].map(|corner| kernel.side[corner].0);
                kernel.join(leaves, comes, kernel.origin(corner));
            }
        }
        while mistake() == ENDLESS_ASSEMBLY && kernel.side.len() > 3 {
            std::hint::spin_loop();
        }
        while mistake() == TAKES_MEMORY_AT_ONCE && kernel.side.len() > 3 {
            kernel.side.extend_from_within(..);
        }
        if mistake() != NO_BOUNDARY_WING {
            kernel.join_holes();
        }
        kernel
    }

    fn vertex_count(&self) -> usize {
        self.vertex.len()
    }
    fn edge_count(&self) -> usize {
        self.edges.len()
    }
    fn face_count(&self) -> usize {
        if mistake() == FORGETS_DEGENERATE {
            return self.face.iter().filter(|[first, end]| first < end).count();
        }
        self.face.len()
    }
    fn corner_count(&self) -> usize {
        self.side.len()
    }
    fn corner_vertex(&self, corner: CornerId) -> VertexId {
        VertexId::new(self.origin(corner.index()))
    }
    fn corner_edge(&self, corner: CornerId) -> EdgeId {
        EdgeId::new(self.side[corner.index()].0)
    }
    fn corner_face(&self, corner: CornerId) -> FaceId {
        if mistake() == FACE_IS_A_THIRD {
            return FaceId::new(corner.index() / 3);
        }
        if mistake() == ENDLESS_RECURSION {
            return self.corner_face(std::hint::black_box(corner));
        }
        if mistake() == EXITS {
            std::process::exit(3);
        }
        FaceId::new(self.face.partition_point(|&[_, end]| end <= corner.index()))
    }
    fn next_corner(&self, corner: CornerId) -> CornerId {
        let face = self.face[self.face.partition_point(|&[_, end]| end <= corner.index())];
        if mistake() == WRONG_ON_PENTAGONS && face[1] - face[0] > 4 && corner.index() + 1 == face[1] {
            return corner;
        }
        CornerId::new(self.next(corner.index()))
    }
    fn prev_corner(&self, corner: CornerId) -> CornerId {
        CornerId::new(self.prev(corner.index()))
    }
    fn across(&self, corner: CornerId) -> Option<CornerId> {
        let (edge, way) = self.side[corner.index()];
        let other = self.edges[edge].corners[1 - way];
        let on_boundary = (mistake() == ACROSS_ITSELF).then_some(corner);
        if other == NOTHING { on_boundary } else { Some(CornerId::new(other)) }
    }
    fn edge_ends(&self, edge: EdgeId) -> [VertexId; 2] {
        self.edges[edge.index()].ends.map(VertexId::new)
    }

    fn face_corners(&self, face: FaceId) -> impl Iterator<Item = CornerId> + Clone {
        let [first, end] = self.face[face.index()];
        let mut corners: Vec<usize> = (first..end).collect();
        if mistake() == BEGINS_ANYWHERE {
            let lowest = (0..corners.len()).min_by_key(|&place| self.side[corners[place]].0);
            corners.rotate_left(lowest.unwrap_or(0));
        }
        corners.into_iter().map(CornerId::new)
    }
    fn edge_corners(&self, edge: EdgeId) -> impl Iterator<Item = CornerId> + Clone {
        let mut corners = self.edges[edge.index()].corners;
        if mistake() == SEARCHES {
            let along = |corner: &usize| self.side[*corner].0 == edge.index();
            let mut found = (0..self.side.len()).filter(along);
            corners = [found.next(), found.next()].map(|corner| corner.unwrap_or(NOTHING));
        }
        if mistake() != AS_RECORDED {
            corners.sort_unstable();
        }
        corners.into_iter().filter(|&corner| corner != NOTHING).map(CornerId::new)
    }
    fn vertex_corners(&self, vertex: VertexId) -> impl Iterator<Item = CornerId> + Clone {
        let lowest = self.side.get(self.vertex[vertex.index()]).map_or(NOTHING, |&(edge, _)| edge);
        let first = if mistake() == BEGINS_LOWEST { lowest } else { self.first_edge(vertex.index()) };
        Star { kernel: self, vertex: vertex.index(), first, edge: first, is_over: first == NOTHING }
    }
    fn edge_degree(&self, edge: EdgeId) -> usize {
        if mistake() == OWN_DEGREE { 2 } else { self.edge_corners(edge).count() }
    }

    fn heap_bytes(&self) -> usize {
        let forgotten =
            if mistake() == FORGETS_AN_ARRAY { self.vertex.capacity() * size_of::<usize>() } else { 0 };
        self.all_arrays().iter().map(Array::bytes).sum::<usize>() - forgotten
    }
    fn arrays(&self) -> Vec<Array> {
        let mut arrays = self.all_arrays().to_vec();
        if mistake() == ONE_NAME {
            arrays[1].name = "edges";
        }
        if mistake() == LEAVES_AN_ARRAY_OUT || mistake() == FORGETS_AN_ARRAY {
            arrays.pop();
        }
        arrays
    }
    fn pointers(&self, of: Cell) -> Vec<Pointer> {
        let Cell::Corner(corner) = of else { return Vec::new() };
        let mut pointers = vec![
            Pointer::new("next", self.next_corner(corner)),
            Pointer::new("edge", self.corner_edge(corner)),
        ];
        let twin = self.across(corner).map_or(Target::Hole, |twin| Target::Cell(Cell::Corner(twin)));
        pointers.push(Pointer {
            field: "twin",
            to: if mistake() == TWIN_IS_NEXT { pointers[0].to } else { twin },
        });
        if mistake() == POINTS_OUTSIDE {
            pointers.push(Pointer::new("wing", EdgeId::new(self.edges.len())));
        }
        pointers
    }
}

impl<const CLAIM: u8> ManifoldConnectivity for Student<CLAIM> {
    fn opposite(&self, corner: CornerId) -> Option<CornerId> {
        if mistake() == OPPOSITE_ITSELF { Some(corner) } else { self.across(corner) }
    }
}

impl<const CLAIM: u8> Student<CLAIM> {
    fn all_arrays(&self) -> [Array; 4] {
        [
            Array::new("edges", Per::Edge, size_of::<Record>(), self.edges.capacity()),
            Array::new("side", Per::Corner, size_of::<(usize, usize)>(), self.side.capacity()),
            Array::new("face", Per::Face, size_of::<[usize; 2]>(), self.face.capacity()),
            Array::new("vertex", Per::Vertex, size_of::<usize>(), self.vertex.capacity()),
        ]
    }
}
