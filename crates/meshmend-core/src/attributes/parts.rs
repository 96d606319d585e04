//! A layer as plain data, for programs that store layers or pass them on.

use std::sync::Arc;

use crate::{Carry, Domain, Layer, Role, Values};

/// All that a layer is made of.
///
/// ```
/// use meshmend_core::{Carry, Domain, Layer, Values};
///
/// let layer = Layer::direct("heat", Domain::Vertex, 1, Carry::Interpolate, Values::F32(vec![0.5, 1.0]));
/// let parts = layer.to_parts();
/// assert_eq!(parts.values, Values::F32(vec![0.5, 1.0]));
/// assert_eq!(Layer::from_parts(parts), layer);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct LayerParts {
    /// What the layer is called.
    pub name: String,
    /// Which elements have values now.
    pub domain: Domain,
    /// Which elements had values as stored.
    pub home: Domain,
    /// How many entries make one value.
    pub width: usize,
    /// What created elements get.
    pub carry: Carry,
    /// What its values mean.
    pub role: Role,
    /// Whether whole numbers stand for fractions.
    pub is_normalized: bool,
    /// How many of the first values are those of a vertex as stored, each of the vertex of its own place.
    pub stored_vertices: usize,
    /// The pool: `width` entries a value.
    pub values: Values,
    /// Which value each element uses, [`NO_VALUE`](crate::NO_VALUE) for none; absent when element `i` uses value `i`.
    pub uses: Option<Vec<u32>>,
    /// For a vertex layer that moved to the corners: the values of the vertices.
    pub vertex_uses: Option<Vec<u32>>,
}

impl Layer {
    /// All that the layer is made of.
    ///
    /// *Cost*: a copy of the pool and the uses.
    pub fn to_parts(&self) -> LayerParts {
        LayerParts {
            name: self.name.clone(),
            domain: self.domain,
            home: self.home,
            width: self.width,
            carry: self.carry,
            role: self.role,
            is_normalized: self.is_normalized,
            stored_vertices: self.stored_vertices,
            values: Values::clone(&self.values),
            uses: self.uses.as_deref().cloned(),
            vertex_uses: self.vertex_uses.as_deref().cloned(),
        }
    }

    /// The layer that is made of this. A mesh refuses one whose parts don't fit each other.
    pub fn from_parts(parts: LayerParts) -> Self {
        Layer {
            name: parts.name,
            domain: parts.domain,
            home: parts.home,
            width: parts.width.max(1),
            carry: parts.carry,
            role: parts.role,
            is_normalized: parts.is_normalized,
            stored_vertices: parts.stored_vertices,
            values: Arc::new(parts.values),
            uses: parts.uses.map(Arc::new),
            vertex_uses: parts.vertex_uses.map(Arc::new),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::PolygonMesh;

    fn is_taken(change: impl FnOnce(&mut LayerParts)) -> bool {
        let numbers = Values::F64(vec![0.0, 1.0, 2.0]);
        let mut parts = Layer::direct("heat", Domain::Vertex, 1, Carry::Copy, numbers).to_parts();
        change(&mut parts);
        let mesh = PolygonMesh::from_triangles(&[[0.0; 3]; 3], &[[0, 1, 2]]).unwrap();
        mesh.with_layers(vec![Layer::from_parts(parts)]).is_ok()
    }

    #[test]
    fn parts_that_do_not_fit_each_other_are_refused() {
        assert!(is_taken(|_| {}));
        assert!(is_taken(|parts| parts.uses = Some(vec![2, u32::MAX, 0])));
        assert!(!is_taken(|parts| parts.uses = Some(vec![2, 3, 0])));
        assert!(is_taken(|parts| parts.vertex_uses = Some(vec![2, u32::MAX, 0])));
        assert!(!is_taken(|parts| parts.vertex_uses = Some(vec![3])));
        assert!(!is_taken(|parts| parts.stored_vertices = 4));
        assert!(!is_taken(|parts| parts.width = 2));
        let lists = |starts: &[u32]| Values::Lists {
            starts: starts.to_vec(),
            items: Box::new(Values::U8(vec![7, 8])),
        };
        assert!(is_taken(|parts| parts.values = lists(&[0, 1, 1, 2])));
        for starts in [[0, 2, 1, 2], [0, 1, 2, 3]] {
            assert!(!is_taken(|parts| parts.values = lists(&starts)), "{starts:?}");
        }
    }
}
