//! What may be drawn over the faces of a mesh.

use meshmend_core::{EdgeId, Id, PolygonMesh, VertexId};
use meshmend_topology::OneSidedStrip;
use thiserror::Error;

/// Something to show on a mesh; edges are named as in the mesh's [complex](PolygonMesh::complex).
///
/// Those that follow from the mesh alone are found by [`boundary`](crate::boundary) and its kin and by
/// [`loops`](crate::loops()); but what is shown may come from anywhere.
#[derive(Clone, Debug, PartialEq)]
pub enum Overlay {
    /// Where the surface is open.
    Boundary {
        /// The edges with one face.
        edges: Vec<EdgeId>,
    },
    /// Where the mesh is not a surface.
    NonManifold {
        /// The edges with three faces or more.
        edges: Vec<EdgeId>,
        /// The vertices that join several umbrellas.
        vertices: Vec<VertexId>,
    },
    /// Where two faces that share an edge run along it the same way.
    Inconsistent {
        /// Those edges.
        edges: Vec<EdgeId>,
    },
    /// What shows that patches have one side only.
    Witness {
        /// Closed strips of faces that come back mirrored.
        strips: Vec<OneSidedStrip>,
    },
    /// The faces, coloured by what they hang together with.
    Components {
        /// For each vertex the number of its component; `None` for those in no face.
        of_vertex: Vec<Option<u32>>,
    },
    /// Closed paths round handles, cross-caps and holes.
    Generators {
        /// The vertices of each, the first one not repeated at the end.
        loops: Vec<Vec<VertexId>>,
        /// How many more there are that are not drawn.
        more: usize,
    },
    /// A spanning tree of the vertices.
    Tree {
        /// Its edges.
        edges: Vec<EdgeId>,
    },
    /// A spanning tree of the faces.
    Cotree {
        /// The edges across which it joins faces.
        edges: Vec<EdgeId>,
    },
    /// Where the surface is to be cut.
    Seam {
        /// Its edges.
        edges: Vec<EdgeId>,
    },
    /// What positions tell.
    Placed {
        /// What it is.
        what: Placed,
        /// The edges of the faces that it is about, or of the loops.
        edges: Vec<EdgeId>,
        /// The vertices that it is about.
        vertices: Vec<VertexId>,
    },
}

/// What positions tell of a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Placed {
    /// Faces that cross or overlap.
    Crossings,
    /// Vertices on open edges that they are not joined to.
    TJunctions,
    /// Boundary loops that are not the outer borders of sheets.
    Holes,
    /// Faces that are too thin, or have no area.
    Slivers,
    /// Closed components that look inward.
    InsideOut,
    /// Faces inside of what others enclose.
    Internal,
}

impl Placed {
    /// Everything that positions tell.
    pub const ALL: [Placed; 6] = [
        Placed::Crossings,
        Placed::TJunctions,
        Placed::Holes,
        Placed::Slivers,
        Placed::InsideOut,
        Placed::Internal,
    ];

    /// Its name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Placed::Crossings => "crossings",
            Placed::TJunctions => "t-junctions",
            Placed::Holes => "holes",
            Placed::Slivers => "slivers",
            Placed::InsideOut => "inside-out",
            Placed::Internal => "internal",
        }
    }

    /// What a legend says.
    pub(crate) fn title(self) -> &'static str {
        match self {
            Placed::Crossings => "crossing faces",
            Placed::TJunctions => "T-junctions",
            Placed::Holes => "holes",
            Placed::Slivers => "slivers",
            Placed::InsideOut => "inside out",
            Placed::Internal => "internal faces",
        }
    }
}

/// The kinds of [`Overlay`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum OverlayKind {
    /// [`Overlay::Boundary`]
    Boundary,
    /// [`Overlay::NonManifold`]
    NonManifold,
    /// [`Overlay::Inconsistent`]
    Inconsistent,
    /// [`Overlay::Witness`]
    Witness,
    /// [`Overlay::Components`]
    Components,
    /// [`Overlay::Generators`]
    Generators,
    /// [`Overlay::Tree`]
    Tree,
    /// [`Overlay::Cotree`]
    Cotree,
    /// [`Overlay::Seam`]
    Seam,
    /// [`Overlay::Placed`]
    Placed(Placed),
}

impl OverlayKind {
    /// Every kind, in the order of their names' use in this crate.
    pub const ALL: &'static [OverlayKind] = &[
        OverlayKind::Boundary,
        OverlayKind::NonManifold,
        OverlayKind::Inconsistent,
        OverlayKind::Witness,
        OverlayKind::Components,
        OverlayKind::Generators,
        OverlayKind::Tree,
        OverlayKind::Cotree,
        OverlayKind::Seam,
        OverlayKind::Placed(Placed::Crossings),
        OverlayKind::Placed(Placed::TJunctions),
        OverlayKind::Placed(Placed::Holes),
        OverlayKind::Placed(Placed::Slivers),
        OverlayKind::Placed(Placed::InsideOut),
        OverlayKind::Placed(Placed::Internal),
    ];

    /// Its name on the command line, such as `non-manifold`.
    pub fn name(self) -> &'static str {
        match self {
            OverlayKind::Boundary => "boundary",
            OverlayKind::NonManifold => "non-manifold",
            OverlayKind::Inconsistent => "inconsistent",
            OverlayKind::Witness => "witness",
            OverlayKind::Components => "components",
            OverlayKind::Generators => "generators",
            OverlayKind::Tree => "tree",
            OverlayKind::Cotree => "cotree",
            OverlayKind::Seam => "seam",
            OverlayKind::Placed(what) => what.name(),
        }
    }
}

/// An overlay names an element that the mesh does not have.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("the overlay `{overlay}` names {element}, which the mesh does not have")]
pub struct NoSuchElement {
    /// The kind of overlay.
    pub overlay: &'static str,
    /// The element, such as `e17`.
    pub element: String,
}

impl Overlay {
    /// Which kind it is.
    pub fn kind(&self) -> OverlayKind {
        match self {
            Overlay::Boundary { .. } => OverlayKind::Boundary,
            Overlay::NonManifold { .. } => OverlayKind::NonManifold,
            Overlay::Inconsistent { .. } => OverlayKind::Inconsistent,
            Overlay::Witness { .. } => OverlayKind::Witness,
            Overlay::Components { .. } => OverlayKind::Components,
            Overlay::Generators { .. } => OverlayKind::Generators,
            Overlay::Tree { .. } => OverlayKind::Tree,
            Overlay::Cotree { .. } => OverlayKind::Cotree,
            Overlay::Seam { .. } => OverlayKind::Seam,
            Overlay::Placed { what, .. } => OverlayKind::Placed(*what),
        }
    }

    /// How many elements it shows: edges and vertices, strips, components, or loops.
    pub fn element_count(&self) -> usize {
        match self {
            Overlay::NonManifold { edges, vertices } | Overlay::Placed { edges, vertices, .. } => {
                edges.len() + vertices.len()
            }
            Overlay::Witness { strips } => strips.len(),
            Overlay::Generators { loops, .. } => loops.len(),
            Overlay::Components { of_vertex } => component_count(of_vertex),
            _ => self.edges().len(),
        }
    }

    /// The edges, where the overlay is about some.
    fn edges(&self) -> &[EdgeId] {
        match self {
            Overlay::Boundary { edges }
            | Overlay::NonManifold { edges, .. }
            | Overlay::Inconsistent { edges }
            | Overlay::Tree { edges }
            | Overlay::Cotree { edges }
            | Overlay::Placed { edges, .. }
            | Overlay::Seam { edges } => edges,
            Overlay::Witness { .. } | Overlay::Components { .. } | Overlay::Generators { .. } => &[],
        }
    }

    /// The vertices that it names as such.
    pub(crate) fn vertices(&self) -> impl Iterator<Item = VertexId> + '_ {
        let (loops, own): (&[Vec<VertexId>], &[VertexId]) = match self {
            Overlay::Generators { loops, .. } => (loops, &[]),
            Overlay::NonManifold { vertices, .. } | Overlay::Placed { vertices, .. } => (&[], vertices),
            _ => (&[], &[]),
        };
        loops.iter().flatten().chain(own).copied()
    }

    /// Fails when the mesh does not have what the overlay names.
    pub(crate) fn check(&self, mesh: &PolygonMesh) -> Result<(), NoSuchElement> {
        let strips: &[OneSidedStrip] = if let Overlay::Witness { strips } = self { strips } else { &[] };
        let complex = mesh.complex();
        let vertex = self.vertices().find(|v| v.index() >= mesh.positions().len()).map(|v| v.to_string());
        let faces = strips.iter().flat_map(|strip| &strip.faces);
        let face = faces.copied().find(|f| f.index() >= complex.faces().face_count()).map(|f| f.to_string());
        let mut edges = strips.iter().flat_map(|strip| &strip.edges).chain(self.edges()).copied().peekable();
        // Edges are numbered only where some are named.
        let edge_count = edges.peek().map_or(0, |_| complex.edges().edge_count());
        let edge = edges.find(|e| e.index() >= edge_count).map(|e| e.to_string());
        match vertex.or(face).or(edge) {
            Some(element) => Err(NoSuchElement { overlay: self.kind().name(), element }),
            None => Ok(()),
        }
    }
}

/// How many components there are: one more than the highest number.
pub(crate) fn component_count(of_vertex: &[Option<u32>]) -> usize {
    of_vertex.iter().flatten().max().map_or(0, |&last| last as usize + 1)
}

#[cfg(test)]
mod tests {
    use meshmend_core::{FaceId, FaceTable};
    use meshmend_topology::PatchId;

    use super::*;

    #[test]
    fn what_the_mesh_does_not_have_is_named() {
        let faces = FaceTable::triangles(3, [0, 1, 2].map(VertexId).to_vec()).unwrap();
        let mesh = PolygonMesh::new(vec![[0.0; 3]; 3], faces).unwrap();
        let strip = |face, edge| OneSidedStrip {
            patch: PatchId(0),
            faces: vec![FaceId(face)],
            edges: vec![EdgeId(edge)],
        };
        let cases = [
            (Overlay::Boundary { edges: vec![EdgeId(2)] }, None),
            (Overlay::Boundary { edges: vec![EdgeId(3)] }, Some("e3")),
            (Overlay::Generators { loops: vec![vec![VertexId(0), VertexId(3)]], more: 0 }, Some("v3")),
            (Overlay::NonManifold { edges: vec![], vertices: vec![VertexId(9)] }, Some("v9")),
            (Overlay::Witness { strips: vec![strip(0, 0)] }, None),
            (Overlay::Witness { strips: vec![strip(1, 0)] }, Some("f1")),
            (Overlay::Witness { strips: vec![strip(0, 7)] }, Some("e7")),
        ];
        for (overlay, element) in cases {
            let expected = element.map(|element| (overlay.kind().name(), element.to_owned()));
            assert_eq!(overlay.check(&mesh).err().map(|error| (error.overlay, error.element)), expected);
        }
    }

    #[test]
    fn kinds_have_different_names() {
        let names: std::collections::BTreeSet<_> = OverlayKind::ALL.iter().map(|kind| kind.name()).collect();
        assert_eq!(names.len(), 9 + Placed::ALL.len());
    }
}
