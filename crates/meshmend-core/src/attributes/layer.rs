//! Attribute layers: a pool of values and, for each element of one kind, which value it uses.
//!
//! A seam (one vertex, several texture coordinates) is corners that use different values, and no special case.
//! Layers are carried through every change in one place, [`PolygonMesh::rebuild`]; a pass never sees them.
//!
//! [`PolygonMesh::rebuild`]: crate::PolygonMesh::rebuild

use std::cmp::Ordering;
use std::sync::Arc;

use super::role::Turn;
use crate::{CornerId, FaceTable, Id, Role, Values};

/// The use of an element that has no value.
pub const NO_VALUE: u32 = u32::MAX;

/// Which elements a layer gives values to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Domain {
    /// One value a vertex.
    Vertex,
    /// One value a corner of a face.
    Corner,
    /// One value a face.
    Face,
    /// One value an edge that is an element of its own.
    LooseEdge,
    /// One value a point that is an element of its own.
    LoosePoint,
}

impl Domain {
    /// `vertex`, `corner`, `face`, `loose edge` or `loose point`.
    pub fn name(self) -> &'static str {
        match self {
            Domain::Vertex => "vertex",
            Domain::Corner => "corner",
            Domain::Face => "face",
            Domain::LooseEdge => "loose edge",
            Domain::LoosePoint => "loose point",
        }
    }
}

/// What happens to a layer's values where a change creates a corner, a vertex or a face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Carry {
    /// A created element takes the value of the element that it was created beside.
    Copy,
    /// A created element takes the value between those that it was created between; for numbers with a fraction
    /// only, others are copied.
    Interpolate,
    /// A created element has no value.
    Clear,
}

/// One attribute of the vertices, corners, faces or loose elements of a mesh.
///
/// Value `i` of the pool is `width` consecutive entries of [`values`](Layer::values). Cloning is O(1).
#[derive(Clone, Debug, PartialEq)]
pub struct Layer {
    pub(super) name: String,
    pub(super) domain: Domain,
    pub(super) home: Domain,
    pub(crate) width: usize,
    pub(super) carry: Carry,
    pub(super) role: Role,
    /// Whether whole numbers stand for fractions.
    pub(super) is_normalized: bool,
    /// How many of the first values are those of a vertex as stored, each of the vertex of its own place.
    pub(super) stored_vertices: usize,
    pub(crate) values: Arc<Values>,
    /// Which value each element uses; absent when element `i` uses value `i`.
    pub(super) uses: Option<Arc<Vec<u32>>>,
    /// For a vertex layer that moved to the corners: the values of the vertices, for those without a corner.
    pub(super) vertex_uses: Option<Arc<Vec<u32>>>,
}

impl Layer {
    /// A layer in which element `i` uses value `i` of the pool.
    pub fn direct(
        name: impl Into<String>,
        domain: Domain,
        width: usize,
        carry: Carry,
        values: Values,
    ) -> Self {
        let width = width.max(1);
        let stored_vertices = if domain == Domain::Vertex { values.len() / width } else { 0 };
        Layer {
            name: name.into(),
            domain,
            home: domain,
            width,
            carry,
            role: Role::Plain,
            is_normalized: false,
            stored_vertices,
            values: Arc::new(values),
            uses: None,
            vertex_uses: None,
        }
    }

    /// A layer in which element `i` uses value `uses[i]` of the pool, or has no value if that is [`NO_VALUE`].
    pub fn indexed(
        name: impl Into<String>,
        domain: Domain,
        width: usize,
        carry: Carry,
        values: Values,
        uses: Vec<u32>,
    ) -> Self {
        let layer = Layer::direct(name, domain, width, carry, values);
        Layer { uses: Some(Arc::new(uses)), stored_vertices: 0, ..layer }
    }

    /// The layer with a role.
    pub fn with_role(self, role: Role) -> Self {
        Layer { role, ..self }
    }

    /// The layer, whose whole numbers stand for fractions from 0 or −1 to 1 or don't.
    pub fn with_normalized(self, is_normalized: bool) -> Self {
        Layer { is_normalized, ..self }
    }

    /// The layer with another pool, in which each value stands for the one at its place: the same values in another type or
    /// width. A mesh refuses a layer whose pool is too short.
    pub fn with_pool(self, width: usize, values: Values) -> Self {
        Layer { width: width.max(1), values: Arc::new(values), ..self }
    }

    /// What the layer is called, such as `texcoord`, `normal`, `color`, `material` or `group`.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Which elements have values now.
    pub fn domain(&self) -> Domain {
        self.domain
    }

    /// Which elements had values as stored: a vertex layer moves to the corners when vertices that differ are
    /// welded, and returns when no vertex has corners that differ.
    pub fn home(&self) -> Domain {
        self.home
    }

    /// How many entries make one value.
    pub fn width(&self) -> usize {
        self.width
    }

    /// What created elements get.
    pub fn carry(&self) -> Carry {
        self.carry
    }

    /// What its values mean.
    pub fn role(&self) -> Role {
        self.role
    }

    /// Whether whole numbers stand for fractions: 255 in a byte for 1, −127 in a signed byte for −1.
    pub fn is_normalized(&self) -> bool {
        self.is_normalized
    }

    /// The pool: `width` entries a value.
    pub fn values(&self) -> &Values {
        &self.values
    }

    /// How many values the pool holds.
    pub fn value_count(&self) -> usize {
        self.values.len() / self.width
    }

    /// The value that an element uses, by its place in the pool.
    pub fn value_of(&self, element: usize) -> Option<usize> {
        match &self.uses {
            None => Some(element),
            Some(uses) => uses.get(element).filter(|&&value| value != NO_VALUE).map(|&value| value as usize),
        }
    }

    /// The value that a vertex had as stored, in a layer that is at home on the vertices, wherever the layer is now.
    ///
    /// A vertex that several became has the value of the one whose place it kept, unless its corners agree on another.
    pub fn value_of_vertex(&self, vertex: usize) -> Option<usize> {
        Some(self.vertex_use(vertex)).filter(|&value| value != NO_VALUE).map(|value| value as usize)
    }

    /// For each corner of the faces of the layer's mesh, the value that it has: its own, or that of its vertex or face. A layer
    /// of loose elements has no value at a corner.
    ///
    /// So texture coordinates are found at the corners, wherever the layer is. See
    /// [`PolygonMesh::layer_named`](crate::PolygonMesh::layer_named) for an example.
    ///
    /// *Cost*: constant for each corner.
    pub fn corner_values(&self, faces: &FaceTable) -> impl Iterator<Item = Option<usize>> {
        faces.faces().flat_map(move |face| {
            faces.face_corners(face).map(move |corner| match self.domain {
                Domain::Corner => self.value_of(corner.index()),
                Domain::Vertex => self.value_of(faces.corner_vertex(corner).index()),
                Domain::Face => self.value_of(face.index()),
                Domain::LooseEdge | Domain::LoosePoint => None,
            })
        })
    }

    /// Whether two elements have the same value to the bit, or neither has one.
    pub fn agree(&self, one: usize, other: usize) -> bool {
        self.same_value(self.use_of(one), self.use_of(other))
    }

    /// Whether element `i` uses value `i`, for each element.
    pub fn is_direct(&self) -> bool {
        self.uses.is_none()
    }

    /// How many elements the layer speaks of.
    pub fn element_count(&self) -> usize {
        self.uses.as_ref().map_or_else(|| self.value_count(), |uses| uses.len())
    }

    /// Whether every use names a value of the pool, and the pool is one.
    pub(crate) fn is_consistent(&self) -> bool {
        let count = self.value_count();
        let uses = self.uses.iter().chain(&self.vertex_uses);
        self.values.are_consistent()
            && self.values.len().is_multiple_of(self.width)
            && self.stored_vertices <= count
            && uses.flat_map(|uses| uses.iter()).all(|&value| value == NO_VALUE || (value as usize) < count)
    }

    fn use_of(&self, element: usize) -> u32 {
        self.value_of(element).map_or(NO_VALUE, |value| value as u32)
    }

    /// Whether two uses give the same value to the bit.
    pub(crate) fn same_value(&self, one: u32, other: u32) -> bool {
        one == other
            || (one != NO_VALUE
                && other != NO_VALUE
                && self.values.same_bits(one as usize * self.width, other as usize * self.width, self.width))
    }

    /// An order of values in which those that are the same to the bit are neighbours.
    pub(crate) fn cmp_values(&self, one: u32, other: u32) -> Ordering {
        let width = self.width;
        self.values.cmp_bits(one as usize * width, other as usize * width, width)
    }

    /// A layer of corners as one of vertices that is at the corners for now, and returns when no vertex has corners that
    /// differ. Vertices without a corner have no value unless the layer knows one.
    pub fn at_home_on_vertices(self, vertex_count: usize) -> Self {
        let no_values = || Arc::new(vec![NO_VALUE; vertex_count]);
        let vertex_uses = Some(self.vertex_uses.clone().unwrap_or_else(no_values));
        Layer { home: Domain::Vertex, vertex_uses, ..self }
    }

    /// A layer of vertices as it is read when each of them was stored with its value: NaN or 0 where it has none. Others stay as
    /// they are, and so do lists.
    pub(crate) fn stored_with_vertices(self) -> Self {
        let values = (0..self.element_count()).map(|vertex| self.value_of(vertex));
        let is_of_vertices = self.domain == Domain::Vertex;
        let Some(values) = is_of_vertices.then(|| self.values.picked(values, self.width)).flatten() else {
            return self;
        };
        Layer::direct(self.name, Domain::Vertex, self.width, self.carry, values)
            .with_role(self.role)
            .with_normalized(self.is_normalized)
    }

    /// The vertex as stored that had the value which a corner uses, if that can be told.
    pub(crate) fn stored_vertex(&self, corner: CornerId) -> Option<u32> {
        self.value_of(corner.index()).filter(|&value| value < self.stored_vertices).map(|value| value as u32)
    }

    /// The use of a new value that is the turned one of a value; the same use where its type has no signs.
    pub(crate) fn push_turned(&mut self, value: u32, turn: Turn) -> u32 {
        if !self.values.have_signs() {
            return value;
        }
        let (new, at) = (self.value_count() as u32, value as usize * self.width);
        Arc::make_mut(&mut self.values).push_turned(at, self.width, |place| turn.concerns(place));
        new
    }

    /// Whether a value is that of another layer with each number's sign changed.
    pub(crate) fn is_opposite(&self, value: usize, other: &Layer, other_value: usize) -> bool {
        let width = self.width;
        width == other.width
            && self.values.are_opposite(value * width, &other.values, other_value * width, width)
    }

    /// A layer of other elements over the same pool: element `i` uses value `uses[i]`, or has no value if that is [`NO_VALUE`].
    ///
    /// *Cost*: the pool is shared.
    pub fn over_same_values(
        &self,
        name: impl Into<String>,
        domain: Domain,
        carry: Carry,
        uses: Vec<u32>,
    ) -> Self {
        let name = name.into();
        Layer {
            name,
            domain,
            home: domain,
            carry,
            uses: Some(Arc::new(uses)),
            vertex_uses: None,
            stored_vertices: 0,
            ..self.clone()
        }
    }

    /// The layer with other uses over the same pool.
    pub(crate) fn with_uses(&self, domain: Domain, uses: Vec<u32>) -> Self {
        Layer { domain, uses: Some(Arc::new(uses)), ..self.clone() }
    }

    pub(crate) fn with_vertex_uses(self, uses: Vec<u32>) -> Self {
        Layer { vertex_uses: Some(Arc::new(uses)), ..self }
    }

    pub(crate) fn without_vertex_uses(self) -> Self {
        Layer { vertex_uses: None, ..self }
    }

    /// What a vertex uses: in a vertex layer its own value, in one that moved to the corners what it had before.
    pub(crate) fn vertex_use(&self, vertex: usize) -> u32 {
        match &self.vertex_uses {
            Some(uses) => uses.get(vertex).copied().unwrap_or(NO_VALUE),
            None => self.use_of(vertex),
        }
    }

    /// What each vertex uses, in a layer that stands at the corners for now.
    pub(crate) fn all_vertex_uses(&self, least_count: usize) -> Vec<u32> {
        let mut uses: Vec<u32> = self.vertex_uses.as_deref().cloned().unwrap_or_default();
        uses.resize(uses.len().max(least_count), NO_VALUE);
        uses
    }

    /// Adds a value to the pool; its use.
    pub(crate) fn push_numbers(&mut self, numbers: &[f64]) -> u32 {
        let new = self.value_count() as u32;
        Arc::make_mut(&mut self.values).push_numbers(numbers);
        new
    }

    pub(crate) fn element_use(&self, element: usize) -> u32 {
        self.use_of(element)
    }

    /// A use for a created element between some uses, by the layer's carry rule; may add a value to the pool.
    pub(crate) fn blended(&mut self, parts: &[(u32, f64)]) -> u32 {
        let first = parts.first().map_or(NO_VALUE, |part| part.0);
        let all_equal = parts.iter().all(|part| self.same_value(part.0, first));
        match self.carry {
            Carry::Clear => NO_VALUE,
            _ if self.role == Role::Identity => NO_VALUE,
            _ if parts.iter().any(|part| part.0 == NO_VALUE) => NO_VALUE,
            Carry::Copy => first,
            Carry::Interpolate if all_equal => first,
            Carry::Interpolate => {
                let new = self.value_count() as u32;
                let parts: Vec<(usize, f64)> =
                    parts.iter().map(|&(v, weight)| (v as usize, weight)).collect();
                if Arc::make_mut(&mut self.values).push_mean(&parts, self.width) { new } else { first }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A layer of each type whose first two values are the same to the bit, and the third is another.
    fn twins() -> Vec<Layer> {
        let lists = |items| Values::Lists { starts: vec![0, 2, 4, 6], items: Box::new(items) };
        let pools = vec![
            Values::I8(vec![-1, -1, 1]),
            Values::U8(vec![1, 1, 2]),
            Values::I16(vec![-1, -1, 1]),
            Values::U16(vec![1, 1, 2]),
            Values::I32(vec![-1, -1, 1]),
            Values::U32(vec![1, 1, 2]),
            Values::F32(vec![f32::NAN, f32::NAN, 0.0]),
            Values::F32(vec![0.0, 0.0, -0.0]),
            Values::F64(vec![f64::NAN, f64::NAN, 0.0]),
            Values::F64(vec![0.0, 0.0, -0.0]),
            Values::Text(vec![b"a".to_vec(), b"a".to_vec(), b"b".to_vec()]),
            lists(Values::U8(vec![1, 2, 1, 2, 1, 3])),
            Values::Lists { starts: vec![0, 1, 2, 4], items: Box::new(Values::U8(vec![1, 1, 1, 1])) },
        ];
        pools.into_iter().map(|pool| Layer::direct("twins", Domain::Vertex, 1, Carry::Copy, pool)).collect()
    }

    #[test]
    fn values_are_the_same_when_their_bits_are() {
        for layer in twins() {
            assert!(layer.same_value(0, 1) && !layer.same_value(1, 2), "{:?}", layer.values());
            assert!(!layer.same_value(0, NO_VALUE) && layer.same_value(NO_VALUE, NO_VALUE));
            assert_eq!((layer.values().len(), layer.values().is_empty()), (3, false));
        }
        assert!(Values::Text(Vec::new()).is_empty());
        let wide = Layer::direct("wide", Domain::Face, 2, Carry::Copy, Values::U8(vec![1, 2, 1, 2, 1, 3]));
        assert!(wide.same_value(0, 1) && !wide.same_value(0, 2));
    }

    #[test]
    fn what_a_created_element_uses_is_what_the_rule_says() {
        let layer = |carry, values| Layer::direct("quality", Domain::Vertex, 1, carry, values);
        let real = |carry| layer(carry, Values::F32(vec![1.0, 3.0]));
        let middle = [(0, 0.5), (1, 0.5)];
        assert_eq!(real(Carry::Clear).blended(&middle), NO_VALUE);
        assert_eq!(real(Carry::Copy).blended(&middle), 0);
        assert_eq!(real(Carry::Interpolate).blended(&[(1, 0.5), (1, 0.5)]), 1);
        assert_eq!(real(Carry::Copy).blended(&[(0, 0.5), (NO_VALUE, 0.5)]), NO_VALUE);
        let mut between = real(Carry::Interpolate);
        assert_eq!(between.blended(&middle), 2);
        assert_eq!(between.values(), &Values::F32(vec![1.0, 3.0, 2.0]));
        // Whole numbers have nothing in between.
        assert_eq!(layer(Carry::Interpolate, Values::U8(vec![1, 3])).blended(&middle), 0);
    }
}
