//! Double and single precision.

/// How precisely the coordinates of a result are stored.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Precision {
    /// As doubles.
    #[default]
    Double,
    /// In single precision, as in binary STL.
    Single,
}

impl Precision {
    /// A point as it is read again when it was stored in this precision.
    pub fn round(self, point: [f64; 3]) -> [f64; 3] {
        match self {
            Precision::Double => point,
            Precision::Single => point.map(|x| f64::from(x as f32)),
        }
    }

    /// The number so many units in the last place away.
    pub(crate) fn moved(self, x: f64, steps: i64) -> f64 {
        match self {
            Precision::Double => {
                let place = |bits: i64| if bits < 0 { i64::MIN.wrapping_sub(bits) } else { bits };
                f64::from_bits(place(place(x.to_bits() as i64).saturating_add(steps)) as u64)
            }
            Precision::Single => {
                let place = |bits: i32| if bits < 0 { i32::MIN.wrapping_sub(bits) } else { bits };
                let steps = i32::try_from(steps).unwrap_or(if steps < 0 { i32::MIN } else { i32::MAX });
                let moved = place((x as f32).to_bits() as i32).saturating_add(steps);
                f64::from(f32::from_bits(place(moved) as u32))
            }
        }
    }
}
