//! What is true of a shape, known beforehand.

/// The figures of a mesh, from closed forms; χ is V − E + F.
///
/// Figures that are not defined for a mesh that is not a manifold are `None`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Truth {
    /// V: vertices in faces.
    pub vertices: usize,
    /// E.
    pub edges: usize,
    /// F: faces that are not degenerate.
    pub faces: usize,
    /// By shared vertices.
    pub components: usize,
    /// Whether every edge has one side or two, and every vertex one umbrella.
    pub manifold: bool,
    /// Whether every patch can be oriented.
    pub orientable: bool,
    /// Cycles of boundary edges, over all components.
    pub boundary_loops: Option<usize>,
    /// The sum over the orientable components, where there are any.
    pub genus: Option<usize>,
    /// The sum over the others, where there are any.
    pub cross_caps: Option<usize>,
    /// β₀, β₁, β₂ over Z/2.
    pub betti_z2: [usize; 3],
    /// β₀, β₁, β₂ over Q.
    pub betti_q: [usize; 3],
}

/// Which closed surface: a sphere with handles, or with cross-caps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Closed {
    /// Orientable, of this genus; 0 is the sphere.
    Handles(usize),
    /// Non-orientable, with this many cross-caps, at least one.
    CrossCaps(usize),
}

impl Truth {
    /// The figures of one connected surface with V, E and F, by the classification theorem.
    pub fn surface(kind: Closed, holes: usize, [vertices, edges, faces]: [usize; 3]) -> Self {
        let closed = usize::from(holes == 0);
        let (genus, cross_caps) = match kind {
            Closed::Handles(genus) => (Some(genus), None),
            Closed::CrossCaps(caps) => (None, Some(caps)),
        };
        let loops = 2 * genus.unwrap_or(0) + cross_caps.unwrap_or(0) + holes.saturating_sub(1);
        let betti_z2 = [1, loops, closed];
        let betti_q = match kind {
            Closed::CrossCaps(_) if holes == 0 => [1, loops.saturating_sub(1), 0],
            _ => betti_z2,
        };
        Truth {
            vertices,
            edges,
            faces,
            components: 1,
            manifold: true,
            orientable: cross_caps.is_none(),
            boundary_loops: Some(holes),
            genus,
            cross_caps,
            betti_z2,
            betti_q,
        }
    }

    /// The figures of one connected complex with V, E and F that is not a manifold, whose patches are all orientable
    /// and whose homology has no torsion.
    pub fn branched(betti: [usize; 3], [vertices, edges, faces]: [usize; 3]) -> Self {
        Truth {
            vertices,
            edges,
            faces,
            components: 1,
            manifold: false,
            orientable: true,
            boundary_loops: None,
            genus: None,
            cross_caps: None,
            betti_z2: betti,
            betti_q: betti,
        }
    }

    /// χ = V − E + F.
    pub fn euler_characteristic(&self) -> i64 {
        self.vertices as i64 - self.edges as i64 + self.faces as i64
    }
}
