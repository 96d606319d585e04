//! Values as bytes of an accessor.

use meshmend_core::{Role, Values};

use crate::formats::gltf::accessor::{Component, Form};
use crate::formats::gltf::rows::{Number, unit_of};

/// Whether two values of one type are the same to the bit.
pub(super) fn same_bits(one: &Values, at: usize, other: &Values, other_at: usize, width: usize) -> bool {
    macro_rules! same {
        ($a:expr, $b:expr, $is_same:expr) => {
            match ($a.get(at * width..(at + 1) * width), $b.get(other_at * width..(other_at + 1) * width)) {
                (Some(a), Some(b)) => a.iter().zip(b).all($is_same),
                _ => false,
            }
        };
    }
    match (one, other) {
        (Values::I8(a), Values::I8(b)) => same!(a, b, |(a, b)| a == b),
        (Values::U8(a), Values::U8(b)) => same!(a, b, |(a, b)| a == b),
        (Values::I16(a), Values::I16(b)) => same!(a, b, |(a, b)| a == b),
        (Values::U16(a), Values::U16(b)) => same!(a, b, |(a, b)| a == b),
        (Values::U32(a), Values::U32(b)) => same!(a, b, |(a, b)| a == b),
        (Values::F32(a), Values::F32(b)) => same!(a, b, |(a, b)| a.to_bits() == b.to_bits()),
        _ => false,
    }
}

/// Rows of one form, one after the other.
#[derive(Clone)]
pub(super) struct RowBytes {
    pub(super) form: Form,
    pub(super) bytes: Vec<u8>,
}

impl RowBytes {
    pub(super) fn new(form: Form) -> Self {
        RowBytes { form, bytes: Vec::new() }
    }

    pub(super) fn count(&self) -> usize {
        self.bytes.len() / self.form.size()
    }

    /// Appends a row whose numbers these are.
    fn push<T: Number>(&mut self, numbers: impl Iterator<Item = T>) {
        let start = self.bytes.len();
        self.bytes.resize(start + self.form.size(), 0);
        for (at, number) in self.form.places().zip(numbers) {
            number.put(&mut self.bytes[start + at..]);
        }
    }

    /// Appends a value of a pool of the same type.
    pub(super) fn push_value(&mut self, values: &Values, at: usize) {
        let range = at * self.form.width()..(at + 1) * self.form.width();
        macro_rules! push {
            ($values:expr) => {
                self.push($values.get(range).unwrap_or_default().iter().copied())
            };
        }
        match values {
            Values::I8(v) => push!(v),
            Values::U8(v) => push!(v),
            Values::I16(v) => push!(v),
            Values::U16(v) => push!(v),
            Values::U32(v) => push!(v),
            Values::F32(v) => push!(v),
            _ => self.push(std::iter::empty::<u8>()),
        }
    }

    /// Appends numbers, rounded to the type of the rows, and returns by how much the farthest was moved.
    pub(super) fn push_numbers(&mut self, numbers: &[f64]) -> f64 {
        let unit = if self.form.normalized { unit_of(self.form.component) } else { 1.0 };
        let mut farthest = 0.0_f64;
        let mut rounded = |number: f64, least: f64, most: f64| -> f64 {
            let stored = (number * unit).round().clamp(least, most);
            farthest = farthest.max((stored / unit - number).abs());
            stored
        };
        macro_rules! push {
            ($number:ty) => {{
                let limits = (f64::from(<$number>::MIN), f64::from(<$number>::MAX));
                let stored: Vec<$number> =
                    numbers.iter().map(|&number| rounded(number, limits.0, limits.1) as $number).collect();
                self.push(stored.into_iter());
            }};
        }
        match self.form.component {
            Component::I8 => push!(i8),
            Component::U8 => push!(u8),
            Component::I16 => push!(i16),
            Component::U16 => push!(u16),
            Component::U32 => push!(u32),
            Component::F32 => {
                for &number in numbers {
                    let moved = (f64::from(number as f32) - number).abs();
                    farthest = if moved > farthest { moved } else { farthest };
                }
                self.push(numbers.iter().map(|&number| number as f32));
            }
        }
        farthest
    }

    /// Makes the last row that of a created vertex: a mean of directions has unit length, and one side or the other.
    pub(super) fn settle_last(&mut self, role: Role) {
        let is_direction =
            matches!(role, Role::Normal | Role::Tangent) && self.form.component == Component::F32;
        let start = self.bytes.len().saturating_sub(self.form.size());
        if !is_direction || self.form.width() < 3 || start == self.bytes.len() {
            return;
        }
        let mut numbers: Vec<f64> =
            self.form.places().map(|at| f32::of(&self.bytes[start + at..]).wide()).collect();
        let length = numbers.iter().take(3).map(|x| x * x).sum::<f64>().sqrt();
        if length > 1e-12 {
            numbers.iter_mut().take(3).for_each(|x| *x /= length);
        }
        if let Some(side) = numbers.get_mut(3) {
            *side = if *side < 0.0 { -1.0 } else { 1.0 };
        }
        self.bytes.truncate(start);
        self.push(numbers.into_iter().map(|number| number as f32));
    }

    /// Appends what stands for no value: a direction, all weight on one joint, or zeros.
    pub(super) fn push_absent(&mut self, role: Role) {
        let numbers: &[f64] = match role {
            Role::Normal => &[0.0, 0.0, 1.0],
            Role::Tangent => &[1.0, 0.0, 0.0, 1.0],
            Role::Weights(0) => &[1.0],
            _ => &[],
        };
        let mut row = vec![0.0; self.form.width()];
        row.iter_mut().zip(numbers).for_each(|(slot, &number)| *slot = number);
        self.push_numbers(&row);
    }

    /// The least and the greatest of each number of a row.
    pub(super) fn bounds(&self) -> [Vec<f64>; 2] {
        let width = self.form.width();
        let mut bounds = [vec![f64::INFINITY; width], vec![f64::NEG_INFINITY; width]];
        for row in self.bytes.chunks(self.form.size()) {
            for (place, at) in self.form.places().enumerate() {
                let number = number_in(self.form.component, &row[at..]);
                bounds[0][place] = bounds[0][place].min(number);
                bounds[1][place] = bounds[1][place].max(number);
            }
        }
        bounds
    }
}

fn number_in(component: Component, bytes: &[u8]) -> f64 {
    match component {
        Component::I8 => i8::of(bytes).wide(),
        Component::U8 => u8::of(bytes).wide(),
        Component::I16 => i16::of(bytes).wide(),
        Component::U16 => u16::of(bytes).wide(),
        Component::U32 => u32::of(bytes).wide(),
        Component::F32 => f32::of(bytes).wide(),
    }
}
