//! Which surface comes of a disc whose rim is glued to itself?
//!
//! Cut open into a disc, a surface is a polygon, and going once round it *spells* how it was glued: each letter
//! stands for a side, a⁻¹ for the same side met the other way round, and a letter that comes once for a side that
//! stays open. So a b a⁻¹ b⁻¹ is a torus, a b a⁻¹ b a Klein bottle, a a⁻¹ a sphere, and a b a⁻¹ c an annulus. The
//! word tells the surface again: χ by counting the corners that become one, orientability by a letter that comes
//! twice the same way round, and boundary loops by the open sides that follow one another.
//!
//! *Source*: the classification theorem in its usual proof by gluing words; H. Seifert, W. Threlfall, *Lehrbuch der
//! Topologie*, 1934, §38.

use std::fmt;

use meshmend_core::VertexId;
use petgraph::unionfind::UnionFind;
use serde::{Serialize, Serializer};

use crate::Surface;

/// A side of a polygon, as it is met on the way round.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Letter {
    /// Which side: 0 is shown as `a`, 26 as `a1`.
    pub side: u32,
    /// Whether it is met the other way round than where it comes first.
    pub is_inverse: bool,
}

/// How the rim of a disc is glued to itself. Shown, and written in reports, as `a b a⁻¹ b⁻¹`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GluingWord {
    /// Sides are numbered in the order in which they come, each first as it is; none comes more than twice.
    letters: Vec<Letter>,
}

impl GluingWord {
    /// The word of sides with names of any kind, each with whether it is met the other way round.
    ///
    /// `None` where there is no side, or one comes more than twice.
    ///
    /// ```
    /// # use meshmend_topology::{GluingWord, surface_name};
    /// let word = GluingWord::of_sides(&[(7, true), (4, false), (7, true), (4, true)]).unwrap();
    /// assert_eq!(word.to_string(), "a b a b⁻¹");
    /// assert_eq!(word.surface().map(surface_name).as_deref(), Some("Klein bottle"));
    /// ```
    ///
    /// *Cost*: O(n log n).
    pub fn of_sides(sides: &[(u32, bool)]) -> Option<Self> {
        let mut places: Vec<(u32, usize)> = sides.iter().map(|side| side.0).zip(0..).collect();
        places.sort_unstable();
        let mut first_place = vec![0; sides.len()];
        for run in places.chunk_by(|one, other| one.0 == other.0) {
            if run.len() > 2 {
                return None;
            }
            run.iter().for_each(|&(_, place)| first_place[place] = run[0].1);
        }
        let mut numbers = vec![0; sides.len()];
        let mut next = 0;
        let letter = |(place, &(_, is_inverse)): (usize, &(u32, bool))| {
            let first = first_place[place];
            if first == place {
                numbers[place] = next;
                next += 1;
            }
            Letter { side: numbers[first], is_inverse: is_inverse != sides[first].1 }
        };
        let letters: Vec<Letter> = sides.iter().enumerate().map(letter).collect();
        (!letters.is_empty()).then_some(GluingWord { letters })
    }

    /// The word of a closed walk along edges, the last vertex joined to the first: the rim of a disc, by the vertices
    /// from which it was cut.
    ///
    /// Edges that follow one another wherever they come are one side. `None` where there is no edge, one comes more
    /// than twice, or a vertex follows itself.
    ///
    /// ```
    /// # use meshmend_core::VertexId;
    /// # use meshmend_topology::GluingWord;
    /// // A torus whose two sides have three edges each.
    /// let rim = [0, 1, 2, 0, 3, 4, 0, 2, 1, 0, 4, 3].map(VertexId);
    /// assert_eq!(GluingWord::of_rim(&rim).map(|word| word.to_string()).as_deref(), Some("a b a⁻¹ b⁻¹"));
    /// ```
    ///
    /// *Cost*: O(n log n).
    pub fn of_rim(walk: &[VertexId]) -> Option<Self> {
        let edges = Rim::of(walk)?;
        let first = (0..walk.len()).find(|&place| edges.is_joint[place])?;
        let mut sides: Vec<(u32, bool)> = Vec::new();
        for place in (first..walk.len()).chain(0..first) {
            let edge = (edges.number[place], walk[place] > walk[(place + 1) % walk.len()]);
            match sides.last_mut().filter(|_| !edges.is_joint[place]) {
                // A side is called by the lowest of its edges, and runs as that one does.
                Some(side) => *side = (*side).min(edge),
                None => sides.push(edge),
            }
        }
        GluingWord::of_sides(&sides)
    }

    /// The sides in the order in which they come.
    pub fn letters(&self) -> &[Letter] {
        &self.letters
    }

    /// The surface that comes of gluing. There is always one; nothing but for words beyond all memory.
    ///
    /// *Cost*: near-linear.
    pub fn surface(&self) -> Option<Surface> {
        let count = self.letters.len();
        let mut corners = UnionFind::<u32>::new(count);
        let ends = |place: usize| [place as u32, ((place + 1) % count) as u32];
        let mut partner = vec![None; count];
        let mut is_orientable = true;
        for (place, letter) in self.letters.iter().enumerate() {
            let first = partner[letter.side as usize].replace(place);
            let Some([from, to]) = first.map(ends) else { continue };
            let [here_from, here_to] = ends(place);
            is_orientable &= letter.is_inverse;
            let (at_from, at_to) =
                if letter.is_inverse { (here_to, here_from) } else { (here_from, here_to) };
            corners.union(from, at_from);
            corners.union(to, at_to);
        }
        let vertices = classes(&corners, 0..count as u32);
        let sides = partner.iter().flatten().count();
        let euler_characteristic = vertices as i64 - sides as i64 + 1;
        let open: Vec<u32> = self.open_places().collect();
        let mut loops = corners;
        open.iter().for_each(|&place| {
            let [from, to] = ends(place as usize);
            loops.union(from, to);
        });
        let holes = classes(&loops, open.into_iter()) as u64;
        if is_orientable {
            Surface::orientable(euler_characteristic, holes)
        } else {
            Surface::non_orientable(euler_characteristic, holes)
        }
    }

    /// The places of the letters that come once.
    fn open_places(&self) -> impl Iterator<Item = u32> + '_ {
        let mut times = vec![0u8; self.letters.len()];
        self.letters.iter().for_each(|letter| times[letter.side as usize] += 1);
        (0..).zip(&self.letters).filter(move |(_, l)| times[l.side as usize] == 1).map(|(place, _)| place)
    }
}

/// How many classes some elements are in.
fn classes(sets: &UnionFind<u32>, elements: impl Iterator<Item = u32>) -> usize {
    let mut roots: Vec<u32> = elements.map(|element| sets.find(element)).collect();
    roots.sort_unstable();
    roots.dedup();
    roots.len()
}

/// The edges of a closed walk.
struct Rim {
    /// A number for each edge, by its ends.
    number: Vec<u32>,
    /// Whether a side begins at a place: its vertex has not two edges of one kind, or there is no such vertex and it
    /// is the lowest one.
    is_joint: Vec<bool>,
}

impl Rim {
    /// `None` where an edge comes more than twice, or a vertex follows itself.
    fn of(walk: &[VertexId]) -> Option<Self> {
        let count = walk.len();
        let mut sorted: Vec<([VertexId; 2], usize)> = (0..count)
            .map(|place| {
                let (from, to) = (walk[place], walk[(place + 1) % count]);
                ([from.min(to), from.max(to)], place)
            })
            .collect();
        sorted.sort_unstable();
        let mut number = vec![0; count];
        // For each edge and each of its ends: that vertex, and whether the edge comes twice.
        let mut at_vertex: Vec<(VertexId, bool)> = Vec::new();
        for (edge, run) in (0..).zip(sorted.chunk_by(|one, other| one.0 == other.0)) {
            let ends = run[0].0;
            if run.len() > 2 || ends[0] == ends[1] {
                return None;
            }
            run.iter().for_each(|&(_, place)| number[place] = edge);
            at_vertex.extend(ends.map(|end| (end, run.len() == 2)));
        }
        at_vertex.sort_unstable();
        let passes = at_vertex.chunk_by(|one, other| one.0 == other.0).filter(|star| is_passed(star));
        let passed: Vec<VertexId> = passes.map(|star| star[0].0).collect();
        let mut is_joint: Vec<bool> = walk.iter().map(|v| passed.binary_search(v).is_err()).collect();
        if !is_joint.contains(&true) {
            let lowest = walk.iter().min()?;
            is_joint = walk.iter().map(|vertex| vertex == lowest).collect();
        }
        Some(Rim { number, is_joint })
    }
}

/// Whether a side goes on through the vertex with these edges.
fn is_passed(star: &[(VertexId, bool)]) -> bool {
    matches!(star, [one, other] if one.1 == other.1)
}

impl fmt::Display for Letter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let letter = (b'a' + (self.side % 26) as u8) as char;
        write!(f, "{letter}")?;
        if self.side >= 26 {
            write!(f, "{}", self.side / 26)?;
        }
        f.write_str(if self.is_inverse { "⁻¹" } else { "" })
    }
}

impl fmt::Display for GluingWord {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (place, letter) in self.letters.iter().enumerate() {
            write!(f, "{}{letter}", if place == 0 { "" } else { " " })?;
        }
        Ok(())
    }
}

impl Serialize for GluingWord {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface_name;

    /// A word of letters, a capital one standing for the other way round.
    fn word(text: &str) -> GluingWord {
        let side = |letter: char| (letter.to_ascii_lowercase() as u32, letter.is_ascii_uppercase());
        GluingWord::of_sides(&text.chars().map(side).collect::<Vec<_>>()).unwrap()
    }

    fn name(text: &str) -> String {
        surface_name(word(text).surface().unwrap())
    }

    #[test]
    fn the_classics_are_known_by_their_words() {
        let words = [
            ("aA", "sphere"),
            ("aa", "projective plane"),
            ("abAB", "torus"),
            ("abAb", "Klein bottle"),
            ("aabb", "Klein bottle"),
            ("aabbcc", "Dyck's surface"),
            ("abABcc", "Dyck's surface"),
            ("abABcdCD", "double torus"),
            ("abcdABCD", "double torus"),
            ("abcABC", "torus"),
            ("aabbccdd", "sphere with 4 cross-caps"),
            ("abc", "disc"),
            ("aAb", "disc"),
            ("abAc", "annulus"),
            ("abac", "Möbius band"),
            ("abAcdC", "annulus"),
            ("abAcdCe", "pair of pants"),
            ("abcABCd", "torus with 1 hole"),
        ];
        for (text, expected) in words {
            assert_eq!(name(text), expected, "{text}");
        }
    }

    #[test]
    fn where_a_word_begins_and_which_way_it_runs_does_not_matter() {
        for text in ["abABccd", "abcdABCD", "abAcdCe"] {
            let surface = word(text).surface();
            for by in 0..text.len() {
                let turned = [&text[by..], &text[..by]].concat();
                let mirrored: String = turned.chars().rev().map(other_way).collect();
                assert_eq!([word(&turned).surface(), word(&mirrored).surface()], [surface, surface]);
            }
        }
    }

    fn other_way(letter: char) -> char {
        if letter.is_ascii_uppercase() { letter.to_ascii_lowercase() } else { letter.to_ascii_uppercase() }
    }

    #[test]
    fn letters_are_named_as_they_come() {
        let named = word("zYyX");
        assert_eq!(named.to_string(), "a b b⁻¹ c");
        let letters: Vec<_> = named.letters().iter().map(|letter| (letter.side, letter.is_inverse)).collect();
        assert_eq!(letters, [(0, false), (1, false), (1, true), (2, false)]);
        assert_eq!(Letter { side: 27, is_inverse: true }.to_string(), "b1⁻¹");
        assert_eq!(GluingWord::of_sides(&[]), None);
        assert_eq!(GluingWord::of_sides(&[(1, false), (1, true), (1, false)]), None);
    }

    #[test]
    fn edges_that_follow_one_another_are_one_side() {
        let spelt = |walk: &[u32]| {
            let walk: Vec<VertexId> = walk.iter().copied().map(VertexId).collect();
            GluingWord::of_rim(&walk).map(|word| word.to_string())
        };
        // A sphere opened along a path of two edges, a projective plane, a disc.
        assert_eq!(spelt(&[1, 0, 2, 0]).as_deref(), Some("a a⁻¹"));
        assert_eq!(spelt(&[2, 0, 1, 2, 0, 1]).as_deref(), Some("a a"));
        assert_eq!(spelt(&[2, 0, 1]).as_deref(), Some("a"));
        // An annulus between the triangles 0 1 2 and 3 4 5, cut along 0 6 3.
        assert_eq!(spelt(&[6, 0, 1, 2, 0, 6, 3, 5, 4, 3]).as_deref(), Some("a b c b⁻¹"));
        // A sphere opened along one edge.
        assert_eq!(spelt(&[1, 0]).as_deref(), Some("a a⁻¹"));
        for no_rim in [&[][..], &[0], &[0, 0, 1], &[0, 1, 0, 1, 0, 1]] {
            assert_eq!(spelt(no_rim), None, "{no_rim:?}");
        }
    }
}
