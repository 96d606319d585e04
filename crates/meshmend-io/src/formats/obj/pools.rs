//! The values of statements: texture coordinates, normals, colours.

use meshmend_core::{Carry, Domain, Layer, NO_VALUE, Values};

/// Values of one to three numbers. All are as wide as the widest.
#[derive(Default)]
pub(super) struct Pool {
    pub(super) width: usize,
    pub(super) values: Vec<f64>,
    /// How many values were padded.
    pub(super) mixed: u64,
}

#[derive(Default)]
pub(super) struct Colors {
    width: usize,
    values: Vec<[f64; 4]>,
    uses: Vec<u32>,
}

impl Pool {
    pub(super) fn len(&self) -> usize {
        self.values.len().checked_div(self.width).unwrap_or(0)
    }

    pub(super) fn push(&mut self, value: &[f64]) {
        if value.len() > self.width {
            self.widen(value.len());
        }
        self.mixed += u64::from(value.len() < self.width);
        self.values.extend_from_slice(value);
        self.values.resize(self.values.len() + self.width - value.len(), 0.0);
    }

    /// Appends the values of another pool if both have the same width, and returns whether they have.
    pub(super) fn append(&mut self, other: &Pool) -> bool {
        let fits = other.values.is_empty() || [0, other.width].contains(&self.width);
        if fits && !other.values.is_empty() {
            self.width = other.width;
            self.values.extend_from_slice(&other.values);
        }
        fits
    }

    /// Forgets all values, but keeps their memory.
    pub(super) fn clear(&mut self) {
        self.values.clear();
        (self.width, self.mixed) = (0, 0);
    }

    fn widen(&mut self, width: usize) {
        let count = self.len();
        let mut wider = Vec::with_capacity((count + 1) * width);
        for value in self.values.chunks_exact(self.width.max(1)) {
            wider.extend_from_slice(value);
            wider.resize(wider.len() + width - self.width, 0.0);
        }
        self.mixed += count as u64;
        (self.values, self.width) = (wider, width);
    }
}

impl Colors {
    pub(super) fn set(&mut self, vertex: usize, value: [f64; 4], width: usize) {
        self.width = self.width.max(width);
        self.uses.resize(vertex, NO_VALUE);
        self.uses.push(self.values.len() as u32);
        self.values.push(value);
    }

    /// Appends the colours of later vertices. This vertex is the first of them.
    pub(super) fn append(&mut self, vertex: usize, later: &Colors) {
        if !later.values.is_empty() {
            self.width = self.width.max(later.width);
            self.uses.resize(vertex, NO_VALUE);
            let first = self.values.len() as u32;
            let shifted = |&value: &u32| if value == NO_VALUE { NO_VALUE } else { first + value };
            self.uses.extend(later.uses.iter().map(shifted));
            self.values.extend_from_slice(&later.values);
        }
    }

    /// Whether any colour has a fourth number.
    pub(super) fn has_alpha(&self) -> bool {
        self.width == 4
    }

    /// Forgets all colours, but keeps their memory.
    pub(super) fn clear(&mut self) {
        self.width = 0;
        self.values.clear();
        self.uses.clear();
    }

    pub(super) fn layer(mut self, vertices: usize) -> Option<Layer> {
        let width = self.width;
        let values = self.values.iter().flat_map(|value| &value[..width]).copied().collect();
        let values = Values::F64(values);
        match self.values.len() {
            0 => None,
            all if all == vertices => {
                Some(Layer::direct("color", Domain::Vertex, width, Carry::Interpolate, values))
            }
            _ => {
                self.uses.resize(vertices, NO_VALUE);
                Some(Layer::indexed("color", Domain::Vertex, width, Carry::Interpolate, values, self.uses))
            }
        }
    }
}
