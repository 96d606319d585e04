//! How things look. What differs in colour differs in dashes, width or a mark too, so that a picture printed in grey
//! says the same.

use crate::Placed;

/// Red, green and blue.
pub(crate) type Colour = [u8; 3];

pub(crate) const PAPER: Colour = [255, 255, 255];
pub(crate) const TEXT: Colour = [32, 32, 32];

/// How a line is drawn. Its ends and corners are round.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ink {
    pub(crate) colour: Colour,
    /// In pixels.
    pub(crate) width: f64,
    /// Lengths of dashes and gaps in turn, in pixels, between the middles of the round ends; none for a whole line.
    pub(crate) dashes: &'static [f64],
}

impl Ink {
    const fn new(colour: Colour, width: f64, dashes: &'static [f64]) -> Self {
        Ink { colour, width, dashes }
    }

    /// The same line where it is behind faces: pale and thin, with its own dashes.
    pub(crate) fn behind(self) -> Self {
        Ink { colour: mixed(self.colour, PAPER, 0.5), width: self.width * 0.55, ..self }
    }
}

pub(crate) const BOUNDARY: Ink = Ink::new([20, 84, 166], 3.0, &[]);
pub(crate) const NON_MANIFOLD: Ink = Ink::new([200, 20, 40], 4.5, &[7.0, 8.0]);
pub(crate) const INCONSISTENT: Ink = Ink::new([190, 88, 0], 3.2, &[9.0, 6.0, 0.1, 6.0]);
pub(crate) const WITNESS: Ink = Ink::new([104, 30, 126], 2.2, &[]);
pub(crate) const TREE: Ink = Ink::new([16, 110, 60], 1.8, &[]);
pub(crate) const COTREE: Ink = Ink::new([150, 60, 20], 1.4, &[3.0, 4.0]);
pub(crate) const SEAM: Ink = Ink::new([20, 20, 20], 4.0, &[0.1, 7.0]);
pub(crate) const FACE_OUTLINE: Ink = Ink::new([90, 88, 84], 0.6, &[]);
pub(crate) const LOOSE_EDGE: Ink = Ink::new([70, 70, 70], 1.3, &[]);
pub(crate) const HATCHING: Ink = Ink::new([88, 106, 132], 0.7, &[]);
/// The colour of what stands for all lines behind faces in a legend.
pub(crate) const BEHIND: Ink = Ink::new([60, 60, 60], 3.0, &[]);

/// The line of what positions tell.
pub(crate) fn placed(what: Placed) -> Ink {
    match what {
        Placed::Crossings => Ink::new([206, 16, 16], 2.6, &[]),
        Placed::TJunctions => Ink::new([178, 60, 0], 3.4, &[2.0, 6.0]),
        Placed::Holes => Ink::new([0, 92, 190], 4.2, &[12.0, 6.0]),
        Placed::Slivers => Ink::new([150, 0, 120], 2.2, &[6.0, 4.0]),
        Placed::InsideOut => Ink::new([120, 70, 20], 1.8, &[9.0, 5.0, 0.1, 5.0]),
        Placed::Internal => Ink::new([70, 70, 150], 1.6, &[0.1, 4.0]),
    }
}

const GENERATORS: [Ink; 6] = [
    Ink::new([176, 0, 90], 3.4, &[]),
    Ink::new([0, 96, 160], 3.4, &[10.0, 7.0]),
    Ink::new([0, 120, 84], 3.4, &[0.1, 6.0]),
    Ink::new([196, 84, 0], 3.4, &[12.0, 6.5, 0.1, 6.5]),
    Ink::new([92, 44, 160], 2.2, &[5.0, 5.0]),
    Ink::new([60, 60, 60], 4.6, &[14.0, 9.0]),
];

/// The line of the generator of a number; after six they come again.
pub(crate) fn generator(number: usize) -> Ink {
    GENERATORS[number % GENERATORS.len()]
}

const COMPONENTS: [Colour; 8] = [
    [240, 196, 110],
    [126, 178, 214],
    [156, 206, 150],
    [222, 150, 132],
    [196, 176, 222],
    [232, 224, 140],
    [140, 200, 196],
    [214, 178, 150],
];

/// What colours a face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Fill {
    /// Nothing in particular.
    Plain,
    /// The component of a number; after eight the colours come again.
    Component(u32),
    /// Being in a one-sided strip.
    Strip,
}

impl Fill {
    /// Its colour under full light, on the front.
    pub(crate) fn colour(self) -> Colour {
        match self {
            Fill::Plain => [244, 240, 230],
            Fill::Component(number) => COMPONENTS[number as usize % COMPONENTS.len()],
            Fill::Strip => [250, 212, 140],
        }
    }
}

/// What tints the backs of faces.
const BACK: Colour = [150, 178, 214];

/// What shows the backs of faces in a legend.
pub(crate) const BACK_SWATCH: Colour = [158, 178, 202];

/// How a face looks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Tone {
    pub(crate) colour: Colour,
    pub(crate) side: Side,
}

/// Which side of a face is seen. Backs are bluish and hatched.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Side {
    Front,
    Back,
}

/// Shades are this many at most, so that files have few colours.
const SHADES: f64 = 40.0;

impl Tone {
    /// The look of a face in some light, between none at 0 and all of it at 1.
    pub(crate) fn new(fill: Fill, side: Side, light: f64) -> Self {
        let light = 0.36 + 0.64 * (light.clamp(0.0, 1.0) * SHADES).round() / SHADES;
        let whole = match side {
            Side::Front => fill.colour(),
            Side::Back => mixed(fill.colour(), BACK, 0.7),
        };
        Tone { colour: whole.map(|part| (f64::from(part) * light).round() as u8), side }
    }
}

/// A colour on the way from one to another.
pub(crate) fn mixed(from: Colour, to: Colour, part: f64) -> Colour {
    [0, 1, 2].map(|k| (f64::from(from[k]) + (f64::from(to[k]) - f64::from(from[k])) * part).round() as u8)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_differ_without_their_colours() {
        let mut inks = vec![BOUNDARY, NON_MANIFOLD, INCONSISTENT, WITNESS, TREE, COTREE, SEAM, LOOSE_EDGE];
        inks.extend(GENERATORS);
        for (place, one) in inks.iter().enumerate() {
            for other in &inks[..place] {
                let is_same = one.dashes == other.dashes && (one.width - other.width).abs() < 0.3;
                assert!(!is_same, "{one:?} and {other:?}");
            }
        }
    }

    #[test]
    fn lines_are_darker_than_any_face_that_they_are_on() {
        let grey = |colour: Colour| colour.map(u32::from).iter().sum::<u32>() / 3;
        let lit = Tone::new(Fill::Plain, Side::Front, 0.5).colour;
        for ink in [BOUNDARY, NON_MANIFOLD, INCONSISTENT, WITNESS, TREE, COTREE, SEAM] {
            assert!(grey(ink.colour) + 60 < grey(lit), "{ink:?}");
        }
    }

    #[test]
    fn more_light_is_lighter_and_backs_are_darker() {
        let shades = [0.0, 0.5, 1.0].map(|light| Tone::new(Fill::Plain, Side::Front, light).colour[0]);
        assert!(shades.is_sorted() && shades[0] < shades[2]);
        for fill in [Fill::Plain, Fill::Strip, Fill::Component(9)] {
            let sides = [Side::Front, Side::Back].map(|side| Tone::new(fill, side, 1.0).colour);
            assert_ne!(sides[0], sides[1]);
        }
    }
}
