//! The editor by vertex numbers.

pub use meshmend_conformance::editing::{Draw, Editing, edit_laws};
use meshmend_conformance::editing::{Edited, Opening, Operator, Side};
use meshmend_core::{Id, PolygonMesh, VertexId};
use meshmend_edit::{Done, Edit, Editor, HalfKey, Refused, VertexKey};

use crate::Soup;

/// An editor with the key of each vertex by number; new ones get the next numbers.
#[derive(Debug)]
pub struct Indexed {
    /// The editor itself.
    pub editor: Editor,
    keys: Vec<VertexKey>,
}

impl Editing for Indexed {
    const NAME: &'static str = "meshmend-edit";

    fn begin(vertices: usize, faces: &[Vec<u32>]) -> Self {
        Indexed::of(&Soup::generic(vertices, faces).mesh())
    }

    fn apply(&mut self, operator: &Operator) -> Result<Edited, Vec<String>> {
        let edit = self.edit(operator).ok_or_else(|| vec!["no such element".to_owned()])?;
        let can = self.editor.can(&edit);
        let done = self.editor.apply(&edit);
        assert_eq!(can.err().as_ref(), done.as_ref().err(), "the question and the deed agree");
        let codes = |refused: Refused| -> Vec<String> {
            refused.reasons.iter().map(|reason| reason.code().to_owned()).collect()
        };
        Ok(self.edited(done.map_err(codes)?))
    }

    fn faces(&self) -> Vec<Vec<u32>> {
        let face = |face| {
            let halves = self.editor.face_halves(face).unwrap();
            halves.map(|half| self.number(self.editor.origin(half).unwrap())).collect()
        };
        self.editor.faces().map(face).collect()
    }
}

impl Indexed {
    /// Begins with a mesh that an editor takes.
    pub fn of(mesh: &PolygonMesh) -> Self {
        let editor = Editor::new(mesh).unwrap();
        let vertices = 0..mesh.counts().vertices;
        Indexed { keys: vertices.map(|v| editor.vertex_of(VertexId::new(v)).unwrap()).collect(), editor }
    }

    fn number(&self, key: VertexKey) -> u32 {
        self.keys.iter().position(|&other| other == key).unwrap() as u32
    }

    fn half(&self, [from, to]: Side) -> Option<HalfKey> {
        let key = |vertex: u32| self.keys.get(vertex as usize).copied();
        self.editor.half_between(key(from)?, key(to)?).ok()?
    }

    fn side(&self, half: HalfKey) -> Side {
        [self.editor.origin(half).unwrap(), self.editor.target(half).unwrap()].map(|key| self.number(key))
    }

    /// The call that an operator is; None if it names something that the mesh has not.
    pub fn edit(&self, operator: &Operator) -> Option<Edit> {
        let vertex = |vertex: u32| self.keys.get(vertex as usize).copied();
        let edge = |side| self.editor.edge(self.half(side)?).ok();
        let face = |side| self.editor.face(self.half(side)?).ok()?;
        let point = [0.25, 0.5, 0.75];
        let opening = |opening: Opening| {
            let half = self.half(opening.side())?;
            Some(match opening {
                Opening::Corner(_) => meshmend_edit::Opening::Corner(half),
                Opening::Edge(_) => meshmend_edit::Opening::Edge(half),
            })
        };
        Some(match *operator {
            Operator::SplitEdge(side) => Edit::SplitEdge { edge: edge(side)?, at: 0.25 },
            Operator::JoinEdges(at) => Edit::JoinEdges { vertex: vertex(at)? },
            Operator::SplitFace(one, other) => {
                Edit::SplitFace { from: self.half(one)?, to: self.half(other)? }
            }
            Operator::JoinFaces(side) => Edit::JoinFaces { edge: edge(side)? },
            Operator::Poke(side) => Edit::Poke { face: face(side)?, point },
            Operator::RemoveVertex(at) => Edit::RemoveVertex { vertex: vertex(at)? },
            Operator::Flip(side) => Edit::Flip { edge: edge(side)? },
            Operator::Collapse(side) => {
                let point = self.editor.position(vertex(side[1])?).ok()?;
                Edit::Collapse { half: self.half(side)?, point }
            }
            Operator::SplitVertex(from, to) => {
                let point = self.editor.position(vertex(from.side()[0])?).ok()?;
                Edit::SplitVertex { from: opening(from)?, to: opening(to)?, point }
            }
            Operator::OpenFace(side) => Edit::OpenFace { face: face(side)? },
            Operator::CloseHole(side) => Edit::CloseHole { half: self.half(side)? },
            Operator::CutLoop(ref walk) => {
                let side = |at: usize| [walk[at], walk[(at + 1) % walk.len()]];
                let halves = (0..walk.len()).map(|at| self.half(side(at)));
                Edit::CutLoop { halves: halves.collect::<Option<_>>()? }
            }
            Operator::ZipHoles(one, other) => {
                Edit::ZipHoles { half: self.half(one)?, other: self.half(other)? }
            }
        })
    }

    fn edited(&mut self, done: Done) -> Edited {
        let first = self.keys.len() as u32;
        self.keys.extend(&done.vertices);
        let vertices = (first..self.keys.len() as u32).collect();
        Edited { vertices, undo: self.operator(&done.undo) }
    }

    fn operator(&self, edit: &Edit) -> Operator {
        let of_edge = |edge| self.side(self.editor.edge_halves(edge).unwrap()[0]);
        let of_face = |face| self.side(self.editor.face_halves(face).unwrap().next().unwrap());
        let opening = |opening| match opening {
            meshmend_edit::Opening::Corner(half) => Opening::Corner(self.side(half)),
            meshmend_edit::Opening::Edge(half) => Opening::Edge(self.side(half)),
        };
        match *edit {
            Edit::SplitEdge { edge, .. } => Operator::SplitEdge(of_edge(edge)),
            Edit::JoinEdges { vertex } => Operator::JoinEdges(self.number(vertex)),
            Edit::SplitFace { from, to } => Operator::SplitFace(self.side(from), self.side(to)),
            Edit::JoinFaces { edge } => Operator::JoinFaces(of_edge(edge)),
            Edit::Poke { face, .. } => Operator::Poke(of_face(face)),
            Edit::RemoveVertex { vertex } => Operator::RemoveVertex(self.number(vertex)),
            Edit::Flip { edge } => Operator::Flip(of_edge(edge)),
            Edit::Collapse { half, .. } => Operator::Collapse(self.side(half)),
            Edit::SplitVertex { from, to, .. } => Operator::SplitVertex(opening(from), opening(to)),
            Edit::OpenFace { face } => Operator::OpenFace(of_face(face)),
            Edit::CloseHole { half } => Operator::CloseHole(self.side(half)),
            Edit::CutLoop { ref halves } => {
                Operator::CutLoop(halves.iter().map(|&half| self.side(half)[0]).collect())
            }
            Edit::ZipHoles { half, other } => Operator::ZipHoles(self.side(half), self.side(other)),
        }
    }
}
