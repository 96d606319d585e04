//! A chain of duplicates, each of which becomes one only when the one before it has gone.
//!
//! ```text
//!   link k:      base (2 faces)      the edge a-b as stored has three sides: base, leaf k and double k − 1,
//!               a ──────── b         so nothing is joined across it
//!                ╲ leaf k ╱
//!                 ╲      ╱           leaf k runs against its base; double k, at the same three points but with
//!                    c               vertices of its own, runs with it: an opposite duplicate, to be kept
//! ```
//!
//! When double k − 1 goes, the edge a-b has two sides; base and leaf become one patch, orienting it flips the leaf,
//! and now double k, a patch of one face, is a duplicate that runs the same way. It goes, and the edge of link k + 1,
//! of which it was the third side, has two. So orienting by rounds over the whole mesh takes n rounds.
//!
//! Link k + 1 stands on the edge b-c of double k. A fourth face in each link, the blocker, along a-c, keeps leaf and
//! double from being joined there by their positions; so does one along b-c after the last link. Before the first
//! link stands a plain duplicate, which starts it all.

use crate::Soup;

/// A chain of duplicates, and what orienting it does.
#[derive(Clone, Debug)]
pub struct DuplicateChain {
    /// The mesh; every face is a triangle, the positions are small integers.
    pub soup: Soup,
    /// The faces that go, in the order in which they become duplicates: n + 1 of them.
    pub dropped: Vec<u32>,
    /// The faces that are flipped and stay, ascending: n of them.
    pub flipped: Vec<u32>,
}

/// A chain of n links: 5n + 3 faces, of which n + 1 go.
pub fn duplicate_chain(n: usize) -> DuplicateChain {
    let mut chain = DuplicateChain { soup: Soup::default(), dropped: Vec::new(), flipped: Vec::new() };
    let place = |soup: &mut Soup, p: [f64; 3]| {
        soup.positions.push(p);
        soup.positions.len() as u32 - 1
    };
    let spine = |k: usize| [k as f64, (k % 2) as f64, 0.0];
    let soup = &mut chain.soup;
    // The face that the first duplicate doubles, on vertices of its own.
    let corners = [[-1.0, 1.0, 0.0], spine(0), spine(1)];
    let original = corners.map(|p| place(soup, p));
    soup.faces.push(original.to_vec());
    let first = corners.map(|p| place(soup, p));
    chain.dropped.push(soup.faces.len() as u32);
    soup.faces.push(first.to_vec());
    let (mut a, mut b) = (first[1], first[2]);
    for k in 0..n {
        let own = |height: f64, at: usize| [spine(at)[0], spine(at)[1] + 1.0, height];
        let [low, high] = [1.0, 2.0].map(|height| place(soup, own(height, k)));
        soup.faces.push(vec![b, a, low]);
        soup.faces.push(vec![a, high, low]);
        let c = place(soup, spine(k + 2));
        chain.flipped.push(soup.faces.len() as u32);
        soup.faces.push(vec![b, a, c]);
        let double = [k, k + 1, k + 2].map(|at| place(soup, spine(at)));
        chain.dropped.push(soup.faces.len() as u32);
        soup.faces.push(double.to_vec());
        let blocker = [spine(k), spine(k + 2), own(3.0, k)].map(|p| place(soup, p));
        soup.faces.push(blocker.to_vec());
        (a, b) = (double[1], double[2]);
    }
    let last = [spine(n + 1), spine(n), [n as f64, 0.0, 4.0]].map(|p| place(soup, p));
    soup.faces.push(last.to_vec());
    chain
}
