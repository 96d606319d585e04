//! A mesh as plain lists: the common coin of tests.

use std::sync::Arc;

use meshmend_core::{
    Carry, Complex, Domain, FaceTable, FaceTableBuilder, Layer, PolygonMesh, Values, VertexId,
};

/// Positions, and faces as lists of vertices; nothing is promised but that the vertices exist.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Soup {
    /// The point of each vertex.
    pub positions: Vec<[f64; 3]>,
    /// The vertices of each face, in order.
    pub faces: Vec<Vec<u32>>,
}

impl Soup {
    /// Faces over vertices in general position: vertex `i` is at (i, i², i³), so no two coincide, no three are on
    /// a line and no four in a plane.
    pub fn generic(vertex_count: usize, faces: impl IntoIterator<Item = impl AsRef<[u32]>>) -> Self {
        let positions = (0..vertex_count).map(moment_curve).collect();
        Soup { positions, faces: faces.into_iter().map(|f| f.as_ref().to_vec()).collect() }
    }

    /// How many vertices there are, unreferenced ones included.
    pub fn vertex_count(&self) -> usize {
        self.positions.len()
    }

    /// The faces as the library's table.
    pub fn table(&self) -> FaceTable {
        let mut builder = FaceTableBuilder::default();
        self.faces.iter().for_each(|face| builder.push_face(face.iter().copied().map(VertexId)));
        builder.build(self.vertex_count()).expect("the vertices of a soup exist")
    }

    /// The library's mesh.
    pub fn mesh(&self) -> PolygonMesh {
        PolygonMesh::new(self.positions.clone(), self.table()).expect("one position a vertex")
    }

    /// The library's mesh, each of whose vertices, corners and faces carries its own number.
    pub fn numbered(&self) -> PolygonMesh {
        let mesh = self.mesh();
        let counts = mesh.counts();
        let layer = |name, domain, count: usize| {
            Layer::direct(name, domain, 1, Carry::Clear, Values::U32((0..count as u32).collect()))
        };
        let layers = vec![
            layer("vertex number", Domain::Vertex, counts.vertices),
            layer("corner number", Domain::Corner, counts.corners),
            layer("face number", Domain::Face, counts.faces),
        ];
        mesh.with_layers(layers).expect("a layer speaks of every element")
    }

    /// The library's complex.
    pub fn complex(&self) -> Complex {
        Complex::of(&Arc::new(self.table()))
    }

    /// The plain lists of a mesh; loose elements and attributes are left behind.
    pub fn of_mesh(mesh: &PolygonMesh) -> Self {
        let faces = mesh.faces();
        let list = |f| faces.face_vertices(f).iter().map(|v| v.0).collect();
        Soup { positions: mesh.positions().to_vec(), faces: faces.faces().map(list).collect() }
    }

    /// The same mesh with other names: vertex `v` is called `names[v]`, which must be a permutation.
    pub fn renamed(&self, names: &[u32]) -> Self {
        let mut positions = self.positions.clone();
        names.iter().zip(&self.positions).for_each(|(&new, place)| positions[new as usize] = *place);
        let rename = |face: &Vec<u32>| face.iter().map(|&v| names[v as usize]).collect();
        Soup { positions, faces: self.faces.iter().map(rename).collect() }
    }

    /// The same mesh with each face begun at another corner: face `f` further on by `by + f`.
    pub fn rotated(&self, by: usize) -> Self {
        let mut faces = self.faces.clone();
        for (f, face) in faces.iter_mut().enumerate().filter(|(_, face)| !face.is_empty()) {
            let turn = (by + f) % face.len();
            face.rotate_left(turn);
        }
        Soup { positions: self.positions.clone(), faces }
    }

    /// All parts beside one another, without a common vertex; part `i` is moved by `i * step` along each axis.
    pub fn beside(parts: &[Soup], step: f64) -> Self {
        let mut all = Soup::default();
        for (i, part) in parts.iter().enumerate() {
            let base = all.positions.len() as u32;
            let offset = i as f64 * step;
            all.positions.extend(part.positions.iter().map(|p| p.map(|x| x + offset)));
            all.faces.extend(part.faces.iter().map(|face| face.iter().map(|v| v + base).collect::<Vec<_>>()));
        }
        all
    }
}

fn moment_curve(i: usize) -> [f64; 3] {
    let t = i as f64;
    [t, t * t, t * t * t]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_soup_becomes_a_mesh_and_comes_back() {
        let soup = Soup::generic(5, [&[0, 1, 2][..], &[], &[3, 3], &[0, 1, 2, 3]]);
        assert_eq!(Soup::of_mesh(&soup.mesh()), soup);
        assert_eq!(soup.complex().degenerate_faces().len(), 2);
    }

    #[test]
    fn renaming_moves_positions_with_their_vertices() {
        let soup = Soup::generic(3, [[0, 1, 2]]);
        let renamed = soup.renamed(&[2, 0, 1]);
        assert_eq!(renamed.faces, [[2, 0, 1]]);
        assert_eq!(renamed.positions[2], soup.positions[0]);
    }
}
