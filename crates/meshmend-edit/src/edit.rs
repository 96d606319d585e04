//! The operators as values: what is to be done, and what was done.

use crate::{EdgeKey, Editor, FaceKey, HalfKey, Refused, VertexKey};

/// Where the arc of edges begins or ends that [`Editor::split_vertex`] hands to the new vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Opening {
    /// In the corner to the left of a half-edge: its face or hole gets a side more.
    Corner(HalfKey),
    /// Along a half-edge: its edge becomes a triangle.
    Edge(HalfKey),
}

impl Opening {
    /// The half-edge that leaves the vertex there.
    pub fn half(self) -> HalfKey {
        match self {
            Opening::Corner(half) | Opening::Edge(half) => half,
        }
    }
}

/// A call of an operator: the methods of [`Editor`] of the same names say what each of them does.
#[derive(Clone, Debug, PartialEq)]
pub enum Edit {
    /// [`Editor::split_edge`]
    SplitEdge {
        /// The edge.
        edge: EdgeKey,
        /// How far along it.
        at: f64,
    },
    /// [`Editor::join_edges`]
    JoinEdges {
        /// The vertex between the edges.
        vertex: VertexKey,
    },
    /// [`Editor::split_face`]
    SplitFace {
        /// One corner.
        from: HalfKey,
        /// The other one.
        to: HalfKey,
    },
    /// [`Editor::join_faces`]
    JoinFaces {
        /// The edge between the faces.
        edge: EdgeKey,
    },
    /// [`Editor::poke`]
    Poke {
        /// The face.
        face: FaceKey,
        /// Where the new vertex lies.
        point: [f64; 3],
    },
    /// [`Editor::remove_vertex`]
    RemoveVertex {
        /// The vertex.
        vertex: VertexKey,
    },
    /// [`Editor::flip`]
    Flip {
        /// The edge.
        edge: EdgeKey,
    },
    /// [`Editor::collapse`]
    Collapse {
        /// The half-edge.
        half: HalfKey,
        /// Where the vertex lies that is left.
        point: [f64; 3],
    },
    /// [`Editor::split_vertex`]
    SplitVertex {
        /// Where the arc begins.
        from: Opening,
        /// Where it ends.
        to: Opening,
        /// Where the new vertex lies.
        point: [f64; 3],
    },
    /// [`Editor::open_face`]
    OpenFace {
        /// The face.
        face: FaceKey,
    },
    /// [`Editor::close_hole`]
    CloseHole {
        /// A half-edge along the hole.
        half: HalfKey,
    },
    /// [`Editor::cut_loop`]
    CutLoop {
        /// The walk.
        halves: Vec<HalfKey>,
    },
    /// [`Editor::zip_holes`]
    ZipHoles {
        /// A half-edge along one hole.
        half: HalfKey,
        /// The one along the other hole that it is laid on.
        other: HalfKey,
    },
}

/// What an operator did.
#[derive(Clone, Debug, PartialEq)]
pub struct Done {
    /// The vertices that it made.
    pub vertices: Vec<VertexKey>,
    /// The edges that it made.
    pub edges: Vec<EdgeKey>,
    /// The faces that it made.
    pub faces: Vec<FaceKey>,
    /// The vertex that it moved, and where that was.
    pub moved: Option<(VertexKey, [f64; 3])>,
    /// The call that undoes it: the faces are then what they were, but that elements which were gone have new keys.
    /// It is never refused if nothing else was done since. A vertex that was moved is not moved back.
    pub undo: Edit,
}

impl Done {
    /// Nothing was made but what is added, and this undoes it.
    pub(crate) fn undone_by(undo: Edit) -> Self {
        Done { vertices: Vec::new(), edges: Vec::new(), faces: Vec::new(), moved: None, undo }
    }
}

impl Editor {
    /// Whether an operator can be applied.
    ///
    /// # Errors
    /// Every reason against it.
    ///
    /// *Cost*: the operator's.
    pub fn can(&self, edit: &Edit) -> Result<(), Refused> {
        match *edit {
            Edit::SplitEdge { edge, at } => self.can_split_edge(edge, at),
            Edit::JoinEdges { vertex } => self.can_join_edges(vertex),
            Edit::SplitFace { from, to } => self.can_split_face(from, to),
            Edit::JoinFaces { edge } => self.can_join_faces(edge),
            Edit::Poke { face, .. } => self.can_poke(face),
            Edit::RemoveVertex { vertex } => self.can_remove_vertex(vertex),
            Edit::Flip { edge } => self.can_flip(edge),
            Edit::Collapse { half, .. } => self.can_collapse(half),
            Edit::SplitVertex { from, to, .. } => self.can_split_vertex(from, to),
            Edit::OpenFace { face } => self.can_open_face(face),
            Edit::CloseHole { half } => self.can_close_hole(half),
            Edit::CutLoop { ref halves } => self.can_cut_loop(halves),
            Edit::ZipHoles { half, other } => self.can_zip_holes(half, other),
        }
    }

    /// Applies an operator.
    ///
    /// # Errors
    /// Every reason against it; then nothing has changed.
    ///
    /// *Cost*: the operator's.
    pub fn apply(&mut self, edit: &Edit) -> Result<Done, Refused> {
        match *edit {
            Edit::SplitEdge { edge, at } => self.split_edge(edge, at),
            Edit::JoinEdges { vertex } => self.join_edges(vertex),
            Edit::SplitFace { from, to } => self.split_face(from, to),
            Edit::JoinFaces { edge } => self.join_faces(edge),
            Edit::Poke { face, point } => self.poke(face, point),
            Edit::RemoveVertex { vertex } => self.remove_vertex(vertex),
            Edit::Flip { edge } => self.flip(edge),
            Edit::Collapse { half, point } => self.collapse(half, point),
            Edit::SplitVertex { from, to, point } => self.split_vertex(from, to, point),
            Edit::OpenFace { face } => self.open_face(face),
            Edit::CloseHole { half } => self.close_hole(half),
            Edit::CutLoop { ref halves } => self.cut_loop(halves),
            Edit::ZipHoles { half, other } => self.zip_holes(half, other),
        }
    }
}
