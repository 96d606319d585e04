//! Where an element is: its vertices, and the faces round it.

use super::{Defect, Element};
use crate::{CornerId, FaceId, PolygonMesh, VertexId};

impl Defect {
    /// The vertices by whose positions the defect is found, at most `most`: those of the element, and a vertex beside it.
    pub fn vertices(&self, mesh: &PolygonMesh, most: usize) -> Vec<VertexId> {
        let mut vertices = self.at.vertices(mesh, most);
        if let Some(Element::Vertex(beside)) = self.beside {
            vertices.push(beside);
        }
        vertices.truncate(most);
        vertices
    }
}

impl Element {
    /// The vertices of the element, at most `most`: all corners of a face, those of the lowest face of a patch
    /// or component, and the first
    /// one of each face of a strip.
    pub fn vertices(&self, mesh: &PolygonMesh, most: usize) -> Vec<VertexId> {
        let of_face = |face: FaceId| mesh.faces().face_vertices(face).iter().copied();
        match self {
            Element::Vertex(vertex) | Element::LoosePoint { vertex, .. } => vec![*vertex],
            Element::Edge { ends, .. } | Element::LooseEdge { ends, .. } => ends.to_vec(),
            Element::Face(face)
            | Element::Corner { face, .. }
            | Element::Patch(face)
            | Element::Component(face) => of_face(*face).take(most).collect(),
            Element::Strip(strip) => {
                strip.faces.iter().filter_map(|&face| of_face(face).next()).take(most).collect()
            }
        }
    }

    /// The faces along an edge or round a vertex, ascending, each once; `None` for elements that have no faces round
    /// them. Degenerate faces are round nothing.
    ///
    /// *Cost*: that of the corners at the element, and once for the mesh that of its edges, or of the corners of its
    /// vertices, where nobody has asked for them before.
    pub fn faces_round(&self, mesh: &PolygonMesh) -> Option<Vec<FaceId>> {
        let complex = mesh.complex();
        let face = |corner: CornerId| complex.faces().corner_face(corner);
        let mut faces: Vec<FaceId> = match self {
            Element::Edge { edge, .. } => complex.edges().edge_corners(*edge).map(face).collect(),
            Element::Vertex(vertex) => {
                complex.shared_vertex_corners().of(*vertex).iter().copied().map(face).collect()
            }
            _ => return None,
        };
        faces.sort_unstable();
        faces.dedup();
        Some(faces)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{EdgeId, FaceTableBuilder, Strip};

    /// Three triangles on v0-v1, one of them with a corner twice; a quad that runs along v4-v5 twice; a degenerate face.
    fn mesh() -> PolygonMesh {
        let faces: [&[u32]; 5] = [&[0, 1, 2], &[0, 1, 3], &[1, 1], &[1, 0, 0, 6], &[4, 5, 7, 4, 5, 6]];
        let mut builder = FaceTableBuilder::default();
        faces.iter().for_each(|face| builder.push_face(face.iter().copied().map(VertexId)));
        PolygonMesh::new(vec![[0.0; 3]; 8], builder.build(8).unwrap()).unwrap()
    }

    fn edge(mesh: &PolygonMesh, ends: [u32; 2]) -> Element {
        let ends = ends.map(VertexId);
        let edges = mesh.complex().edges();
        let edge = edges.edges().find(|&edge| edges.ends(edge) == ends).unwrap();
        Element::Edge { edge, ends }
    }

    #[test]
    fn an_edge_has_the_faces_along_it_each_once() {
        let mesh = mesh();
        assert_eq!(edge(&mesh, [0, 1]).faces_round(&mesh), Some(vec![FaceId(0), FaceId(1), FaceId(3)]));
        assert_eq!(edge(&mesh, [4, 5]).faces_round(&mesh), Some(vec![FaceId(4)]));
        assert_eq!(edge(&mesh, [1, 3]).faces_round(&mesh), Some(vec![FaceId(1)]));
    }

    #[test]
    fn a_vertex_has_the_faces_round_it_but_no_degenerate_ones() {
        let mesh = mesh();
        let round = |vertex| Element::Vertex(VertexId(vertex)).faces_round(&mesh).unwrap();
        assert_eq!(round(1), [0, 1, 3].map(FaceId));
        assert_eq!(round(4), [FaceId(4)]);
        assert_eq!(round(6), [3, 4].map(FaceId));
    }

    #[test]
    fn other_elements_have_no_faces_round_them() {
        let mesh = mesh();
        let strip = Strip { faces: vec![FaceId(0), FaceId(3)], edges: vec![EdgeId(0)] };
        let ends = [VertexId(0), VertexId(1)];
        for element in
            [Element::Face(FaceId(0)), Element::LooseEdge { index: 0, ends }, Element::Patch(FaceId(1))]
        {
            assert_eq!(element.faces_round(&mesh), None);
        }
        assert_eq!(Element::Strip(Box::new(strip)).vertices(&mesh, 9), [0, 1].map(VertexId));
    }

    #[test]
    fn a_place_has_no_more_vertices_than_asked_for() {
        let mesh = mesh();
        assert_eq!(Element::Face(FaceId(4)).vertices(&mesh, 4), [4, 5, 7, 4].map(VertexId));
        let joined = Defect::coincident_vertex(VertexId(4), VertexId(0));
        assert_eq!(joined.vertices(&mesh, 16), [4, 0].map(VertexId));
        let repeated = Defect::duplicate_face(FaceId(1), FaceId(0));
        assert_eq!(repeated.vertices(&mesh, 16), [0, 1, 3].map(VertexId));
    }
}
