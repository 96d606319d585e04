//! The values of attribute layers: pools of one type each.

use std::cmp::Ordering;
use std::ops::Range;

/// The values of a layer, in the type in which a file stores them.
#[derive(Clone, Debug, PartialEq)]
pub enum Values {
    /// Signed bytes.
    I8(Vec<i8>),
    /// Bytes.
    U8(Vec<u8>),
    /// Signed 16-bit integers.
    I16(Vec<i16>),
    /// 16-bit integers.
    U16(Vec<u16>),
    /// Signed 32-bit integers.
    I32(Vec<i32>),
    /// 32-bit integers.
    U32(Vec<u32>),
    /// Single-precision numbers.
    F32(Vec<f32>),
    /// Double-precision numbers.
    F64(Vec<f64>),
    /// Names, as bytes: files need not be UTF-8.
    Text(Vec<Vec<u8>>),
    /// Lists of varying length: value `i` is `items[starts[i] .. starts[i + 1]]`.
    Lists {
        /// Where each list begins, and one more.
        starts: Vec<u32>,
        /// The items of all lists.
        items: Box<Values>,
    },
}

impl Values {
    /// How many numbers, names or lists there are.
    pub fn len(&self) -> usize {
        match self {
            Values::I8(v) => v.len(),
            Values::U8(v) => v.len(),
            Values::I16(v) => v.len(),
            Values::U16(v) => v.len(),
            Values::I32(v) => v.len(),
            Values::U32(v) => v.len(),
            Values::F32(v) => v.len(),
            Values::F64(v) => v.len(),
            Values::Text(v) => v.len(),
            Values::Lists { starts, .. } => starts.len().saturating_sub(1),
        }
    }

    /// Whether there is no value.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The number at a place of the pool, exactly, as a double. `None` beyond its end, and for names and lists.
    pub fn number(&self, place: usize) -> Option<f64> {
        match self {
            Values::I8(v) => v.get(place).copied().map(f64::from),
            Values::U8(v) => v.get(place).copied().map(f64::from),
            Values::I16(v) => v.get(place).copied().map(f64::from),
            Values::U16(v) => v.get(place).copied().map(f64::from),
            Values::I32(v) => v.get(place).copied().map(f64::from),
            Values::U32(v) => v.get(place).copied().map(f64::from),
            Values::F32(v) => v.get(place).copied().map(f64::from),
            Values::F64(v) => v.get(place).copied(),
            Values::Text(_) | Values::Lists { .. } => None,
        }
    }

    /// The largest number of the type, which stands for 1 in layers whose whole numbers stand for fractions. `None` for
    /// types of fractions, names and lists.
    pub fn largest(&self) -> Option<f64> {
        match self {
            Values::I8(_) => Some(i8::MAX.into()),
            Values::U8(_) => Some(u8::MAX.into()),
            Values::I16(_) => Some(i16::MAX.into()),
            Values::U16(_) => Some(u16::MAX.into()),
            Values::I32(_) => Some(i32::MAX.into()),
            Values::U32(_) => Some(u32::MAX.into()),
            _ => None,
        }
    }

    /// Whether each list is one of the items.
    pub(crate) fn are_consistent(&self) -> bool {
        match self {
            Values::Lists { starts, items } => {
                starts.is_sorted()
                    && starts.last().is_none_or(|&end| end as usize <= items.len())
                    && items.are_consistent()
            }
            _ => true,
        }
    }

    /// Whether the numbers from `one` and from `other` on are the same to the bit.
    pub(crate) fn same_bits(&self, one: usize, other: usize, width: usize) -> bool {
        fn slices<T>(v: &[T], one: usize, other: usize, width: usize, same: impl Fn(&T, &T) -> bool) -> bool {
            v[one..one + width].iter().zip(&v[other..other + width]).all(|(a, b)| same(a, b))
        }
        match self {
            Values::I8(v) => slices(v, one, other, width, |a, b| a == b),
            Values::U8(v) => slices(v, one, other, width, |a, b| a == b),
            Values::I16(v) => slices(v, one, other, width, |a, b| a == b),
            Values::U16(v) => slices(v, one, other, width, |a, b| a == b),
            Values::I32(v) => slices(v, one, other, width, |a, b| a == b),
            Values::U32(v) => slices(v, one, other, width, |a, b| a == b),
            Values::F32(v) => slices(v, one, other, width, |a, b| a.to_bits() == b.to_bits()),
            Values::F64(v) => slices(v, one, other, width, |a, b| a.to_bits() == b.to_bits()),
            Values::Text(v) => slices(v, one, other, width, |a, b| a == b),
            Values::Lists { starts, items } => (0..width).all(|i| {
                let range = |at: usize| starts[at + i] as usize..starts[at + i + 1] as usize;
                let (a, b) = (range(one), range(other));
                a.len() == b.len() && items.same_bits(a.start, b.start, a.len())
            }),
        }
    }

    /// An order of the numbers from `one` and from `other` on, by bits.
    pub(crate) fn cmp_bits(&self, one: usize, other: usize, width: usize) -> Ordering {
        fn cmp<T, K: Ord>(
            v: &[T],
            one: usize,
            other: usize,
            width: usize,
            key: impl Fn(&T) -> K,
        ) -> Ordering {
            v[one..one + width].iter().map(&key).cmp(v[other..other + width].iter().map(&key))
        }
        match self {
            Values::I8(v) => cmp(v, one, other, width, |x| *x),
            Values::U8(v) => cmp(v, one, other, width, |x| *x),
            Values::I16(v) => cmp(v, one, other, width, |x| *x),
            Values::U16(v) => cmp(v, one, other, width, |x| *x),
            Values::I32(v) => cmp(v, one, other, width, |x| *x),
            Values::U32(v) => cmp(v, one, other, width, |x| *x),
            Values::F32(v) => cmp(v, one, other, width, |x| x.to_bits()),
            Values::F64(v) => cmp(v, one, other, width, |x| x.to_bits()),
            Values::Text(v) => v[one..one + width].cmp(&v[other..other + width]),
            Values::Lists { starts, items } => {
                let range = |at: usize| starts[at] as usize..starts[at + 1] as usize;
                let pairs = (0..width).map(|i| (range(one + i), range(other + i)));
                let cmp_lists = |(a, b): (Range<usize>, Range<usize>)| {
                    a.len().cmp(&b.len()).then_with(|| items.cmp_bits(a.start, b.start, a.len()))
                };
                pairs.map(cmp_lists).find(|order| order.is_ne()).unwrap_or(Ordering::Equal)
            }
        }
    }

    /// A pool of these values in this order, each of so many numbers; where there is none NaN, or 0 or an empty name
    /// in types that have no NaN. `None` for lists.
    pub(crate) fn picked(&self, order: impl Iterator<Item = Option<usize>>, width: usize) -> Option<Values> {
        macro_rules! pick {
            ($kind:ident, $values:expr, $absent:expr) => {{
                let mut picked = Vec::with_capacity(order.size_hint().0 * width);
                for value in order {
                    match value.map(|value| value * width) {
                        Some(at) => picked.extend_from_slice(&$values[at..at + width]),
                        None => picked.extend(std::iter::repeat_n($absent, width)),
                    }
                }
                Some(Values::$kind(picked))
            }};
        }
        match self {
            Values::I8(v) => pick!(I8, v, 0),
            Values::U8(v) => pick!(U8, v, 0),
            Values::I16(v) => pick!(I16, v, 0),
            Values::U16(v) => pick!(U16, v, 0),
            Values::I32(v) => pick!(I32, v, 0),
            Values::U32(v) => pick!(U32, v, 0),
            Values::F32(v) => pick!(F32, v, f32::NAN),
            Values::F64(v) => pick!(F64, v, f64::NAN),
            Values::Text(v) => pick!(Text, v, Vec::new()),
            Values::Lists { .. } => None,
        }
    }

    /// Appends the values from a place on, those with the opposite sign that `is_turned` tells by their place.
    pub(crate) fn push_turned(&mut self, at: usize, width: usize, is_turned: impl Fn(usize) -> bool) {
        macro_rules! push {
            ($values:expr, $negative:expr) => {
                for place in 0..width {
                    let value = $values[at + place];
                    $values.push(if is_turned(place) { $negative(value) } else { value });
                }
            };
        }
        match self {
            Values::I8(v) => push!(v, i8::saturating_neg),
            Values::I16(v) => push!(v, i16::saturating_neg),
            Values::I32(v) => push!(v, i32::saturating_neg),
            Values::F32(v) => push!(v, |x: f32| -x),
            Values::F64(v) => push!(v, |x: f64| -x),
            Values::U8(v) => v.extend_from_within(at..at + width),
            Values::U16(v) => v.extend_from_within(at..at + width),
            Values::U32(v) => v.extend_from_within(at..at + width),
            Values::Text(_) | Values::Lists { .. } => {}
        }
    }

    /// Whether the numbers from `one` on are those from `other` on of values of the same type, turned.
    pub(crate) fn are_opposite(&self, one: usize, others: &Values, other: usize, width: usize) -> bool {
        macro_rules! all {
            ($values:expr, $others:expr, $is_opposite:expr) => {
                $values[one..one + width].iter().zip(&$others[other..other + width]).all($is_opposite)
            };
        }
        match (self, others) {
            (Values::I8(v), Values::I8(w)) => all!(v, w, |(a, b)| *a == b.saturating_neg()),
            (Values::I16(v), Values::I16(w)) => all!(v, w, |(a, b)| *a == b.saturating_neg()),
            (Values::I32(v), Values::I32(w)) => all!(v, w, |(a, b)| *a == b.saturating_neg()),
            (Values::F32(v), Values::F32(w)) => all!(v, w, |(a, b)| a.to_bits() == (-b).to_bits()),
            (Values::F64(v), Values::F64(w)) => all!(v, w, |(a, b)| a.to_bits() == (-b).to_bits()),
            _ => false,
        }
    }

    /// Whether the values are numbers that can change their sign.
    pub(crate) fn have_signs(&self) -> bool {
        matches!(self, Values::I8(_) | Values::I16(_) | Values::I32(_) | Values::F32(_) | Values::F64(_))
    }

    /// Appends some numbers, each as near to it as the type allows; nothing to names and lists.
    pub(crate) fn push_numbers(&mut self, numbers: &[f64]) {
        macro_rules! push {
            ($values:expr, $type:ty) => {
                $values.extend(numbers.iter().map(|&number| number as $type))
            };
        }
        match self {
            Values::I8(v) => push!(v, i8),
            Values::U8(v) => push!(v, u8),
            Values::I16(v) => push!(v, i16),
            Values::U16(v) => push!(v, u16),
            Values::I32(v) => push!(v, i32),
            Values::U32(v) => push!(v, u32),
            Values::F32(v) => push!(v, f32),
            Values::F64(v) => push!(v, f64),
            Values::Text(_) | Values::Lists { .. } => {}
        }
    }

    /// Appends the weighted mean of some values; says whether the type has fractions, so that it could.
    pub(crate) fn push_mean(&mut self, parts: &[(usize, f64)], width: usize) -> bool {
        let mean = |at: &dyn Fn(usize) -> f64, i: usize| -> f64 {
            parts.iter().map(|&(value, weight)| at(value * width + i) * weight).sum()
        };
        match self {
            Values::F32(v) => {
                let new: Vec<f32> = (0..width).map(|i| mean(&|at| f64::from(v[at]), i) as f32).collect();
                v.extend(new);
                true
            }
            Values::F64(v) => {
                let new: Vec<f64> = (0..width).map(|i| mean(&|at| v[at], i)).collect();
                v.extend(new);
                true
            }
            _ => false,
        }
    }
}
