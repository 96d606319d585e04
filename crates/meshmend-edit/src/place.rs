//! Where corners lie in terms of the mesh that is edited, and what lies between two of them.

use meshmend_core::{Blend, CornerId, FaceId, FaceTable, Id};

/// Where a corner lies, and so where its attributes come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    /// Where a corner of the mesh is.
    Corner(CornerId),
    /// Between corners of the mesh.
    Between(Blend),
    /// Its vertex has become another one, and it has kept its attributes.
    Elsewhere(Blend),
    /// There is nothing to be said.
    Unknown,
}

/// A numerator and a denominator.
pub(crate) type Fraction = [u32; 2];

/// A point of a side of the mesh: from one corner to the next, and how far.
type Spot = ([CornerId; 2], Fraction);

impl Place {
    /// Somewhere within a face of the mesh.
    pub(crate) fn within(face: Option<FaceId>) -> Self {
        face.map_or(Place::Unknown, |face| Place::Between(Blend::Inside { face }))
    }

    /// Where that is in terms of the mesh, for a vertex that is created there.
    pub(crate) fn blend(self) -> Option<Blend> {
        match self {
            Place::Between(blend) => Some(blend),
            Place::Corner(_) | Place::Elsewhere(_) | Place::Unknown => None,
        }
    }

    /// What its attributes are blended from.
    pub(crate) fn attributes(self) -> Option<Blend> {
        match self {
            Place::Corner(corner) => {
                Some(Blend::Along { from: corner, to: corner, numerator: 0, denominator: 1 })
            }
            Place::Between(blend) | Place::Elsewhere(blend) => Some(blend),
            Place::Unknown => None,
        }
    }

    /// The place of the same corner when its vertex becomes another one.
    pub(crate) fn handed_over(self) -> Self {
        self.attributes().map_or(Place::Unknown, Place::Elsewhere)
    }

    /// A fraction of the way between two corners that follow each other round a piece of a face of the mesh.
    ///
    /// It is on a side of the mesh where both corners are, and the fraction can be said in whole numbers of 32 bits; else it
    /// is within the face.
    pub(crate) fn between(
        ends: [Place; 2],
        at: Option<Fraction>,
        face: Option<FaceId>,
        faces: &FaceTable,
    ) -> Self {
        let Some(face) = face else { return Place::Unknown };
        let along = || {
            let (side, [start, end]) = common_side(ends, face, faces)?;
            let fraction = composed(start, end, at?)?;
            Some(Place::Between(Blend::Along {
                from: side[0],
                to: side[1],
                numerator: fraction[0],
                denominator: fraction[1],
            }))
        };
        along().unwrap_or(Place::within(Some(face)))
    }
}

/// The side of a face on which two places lie one after the other, and how far along it they are.
fn common_side(ends: [Place; 2], face: FaceId, faces: &FaceTable) -> Option<([CornerId; 2], [Fraction; 2])> {
    let range = faces.corner_range(face);
    let is_own = |corner: CornerId| range.contains(&corner.index());
    let spot = |place: Place| -> Option<Spot> {
        match place {
            Place::Between(Blend::Along { from, to, numerator, denominator }) => {
                Some(([from, to], [numerator, denominator]))
            }
            _ => None,
        }
    };
    let (side, fractions) = match ends {
        [Place::Corner(one), Place::Corner(other)] => ([one, other], [[0, 1], [1, 1]]),
        [Place::Corner(one), second] => {
            let (side, fraction) = spot(second)?;
            (side[0] == one).then_some((side, [[0, 1], fraction]))?
        }
        [first, Place::Corner(other)] => {
            let (side, fraction) = spot(first)?;
            (side[1] == other).then_some((side, [fraction, [1, 1]]))?
        }
        [first, second] => {
            let ((side, start), (same, end)) = (spot(first)?, spot(second)?);
            (side == same).then_some((side, [start, end]))?
        }
    };
    (side.into_iter().all(is_own) && is_followed_by(side, face, faces)).then_some((side, fractions))
}

/// Whether one corner of a simple face comes right after another one, corners that repeat a vertex left out.
fn is_followed_by([one, other]: [CornerId; 2], face: FaceId, faces: &FaceTable) -> bool {
    let range = faces.corner_range(face);
    let vertex = faces.corner_vertex(one);
    let after = (one.index() + 1..range.end).chain(range.start..one.index());
    let following = after.map(|corner| faces.corner_vertex(CornerId::new(corner))).find(|&v| v != vertex);
    following == Some(faces.corner_vertex(other))
}

/// start + (end − start) · at in lowest terms, if its terms fit 32 bits.
fn composed(start: Fraction, end: Fraction, at: Fraction) -> Option<Fraction> {
    let [[n1, d1], [n2, d2], [p, q]] = [start, end, at].map(|fraction| fraction.map(u128::from));
    let numerator = n1 * d2 * (q - p) + n2 * d1 * p;
    let denominator = d1 * d2 * q;
    let common = greatest_common_divisor(numerator, denominator);
    let lowest = [numerator / common, denominator / common].map(|term| u32::try_from(term).ok());
    Some([lowest[0]?, lowest[1]?])
}

fn greatest_common_divisor(mut a: u128, mut b: u128) -> u128 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}

/// The first convergent p/q of a number between 0 and 1 that is the number itself when it is rounded to a double.
pub(crate) fn simplest(at: f64) -> Option<Fraction> {
    const MANTISSA: u32 = f64::MANTISSA_DIGITS - 1;
    let (bits, exponent) = (at.to_bits() & ((1 << MANTISSA) - 1), (at.to_bits() >> MANTISSA) as u32);
    let shift = (f64::MAX_EXP as u32 - 1 + MANTISSA).checked_sub(exponent).filter(|&shift| shift < 120)?;
    let (mut numerator, mut denominator) = (u128::from(bits | 1 << MANTISSA), 1u128 << shift);
    let (mut last, mut before) = ([1u128, 0], [0u128, 1]);
    while denominator != 0 {
        let whole = numerator / denominator;
        (numerator, denominator) = (denominator, numerator % denominator);
        (last, before) = ([whole * last[0] + before[0], whole * last[1] + before[1]], last);
        let [p, q] = [u32::try_from(last[0]).ok()?, u32::try_from(last[1]).ok()?];
        if f64::from(p) / f64::from(q) == at {
            return Some([p, q]);
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use meshmend_core::{FaceTableBuilder, VertexId};

    use super::*;

    #[test]
    fn a_double_is_the_simplest_fraction_that_rounds_to_it() {
        let cases =
            [(0.5, [1, 2]), (1.0 / 3.0, [1, 3]), (0.2, [1, 5]), (5.0 / 7.0, [5, 7]), (0.999, [999, 1000])];
        for (at, fraction) in cases {
            assert_eq!(simplest(at), Some(fraction), "{at}");
        }
        assert_eq!(simplest(1e-9), Some([1, 1_000_000_000]));
        assert_eq!(simplest(1.0 / 3.0 + 1e-13), None, "the next convergent is beyond 32 bits");
        for tiny in [1e-300, f64::MIN_POSITIVE, 5e-324] {
            assert_eq!(simplest(tiny), None, "{tiny}");
        }
        assert_eq!(
            simplest(std::f64::consts::FRAC_1_PI).map(|[p, q]| f64::from(p) / f64::from(q)),
            Some(1.0 / std::f64::consts::PI)
        );
    }

    #[test]
    fn fractions_are_composed_exactly() {
        assert_eq!(composed([0, 1], [1, 1], [1, 3]), Some([1, 3]));
        assert_eq!(composed([1, 3], [1, 1], [1, 2]), Some([2, 3]));
        assert_eq!(composed([1, 4], [1, 2], [1, 3]), Some([1, 3]));
        assert_eq!(composed([1, 65_537], [1, 1], [1, 65_539]), None, "the denominator is beyond 32 bits");
    }

    #[test]
    fn a_place_is_on_a_side_of_the_mesh_or_within_its_face() {
        let mut builder = FaceTableBuilder::default();
        // The last corner repeats the first one's vertex, and so does the second.
        builder.push_face([0, 0, 1, 2, 0].map(VertexId));
        let faces = builder.build(3).unwrap();
        let along = |from, to, numerator, denominator| {
            let (from, to) = (CornerId(from), CornerId(to));
            Place::Between(Blend::Along { from, to, numerator, denominator })
        };
        let corner = |c| Place::Corner(CornerId(c));
        let within = Place::Between(Blend::Inside { face: FaceId(0) });
        let between = |one, other, at| Place::between([one, other], simplest(at), Some(FaceId(0)), &faces);
        assert_eq!(between(corner(0), corner(2), 0.5), along(0, 2, 1, 2));
        assert_eq!(between(corner(3), corner(0), 0.5), along(3, 0, 1, 2));
        assert_eq!(between(corner(2), corner(0), 0.5), within);
        assert_eq!(between(corner(0), along(0, 2, 1, 2), 0.5), along(0, 2, 1, 4));
        assert_eq!(between(along(0, 2, 1, 2), corner(2), 0.5), along(0, 2, 3, 4));
        assert_eq!(between(along(0, 2, 1, 4), along(0, 2, 1, 2), 0.5), along(0, 2, 3, 8));
        assert_eq!(between(along(0, 2, 1, 2), corner(3), 0.5), within);
        assert_eq!(between(within, corner(3), 0.5), within);
        assert_eq!(between(corner(0), Place::Unknown, 0.5), within);
        assert_eq!(Place::between([corner(0), corner(2)], Some([1, 2]), None, &faces), Place::Unknown);
    }
}
