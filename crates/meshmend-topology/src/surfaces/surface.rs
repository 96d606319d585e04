//! Which surface is a manifold component, by the classification theorem?
//!
//! A connected compact surface is known by three facts: whether it is orientable, its Euler characteristic χ and
//! its number of boundary loops b. An orientable one is a sphere with g = (2 − χ − b) / 2 handles and b holes, any
//! other a sphere with μ = 2 − χ − b cross-caps and b holes.

use meshmend_core::counted;

/// A connected compact surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Surface {
    /// A sphere with handles and holes.
    Orientable {
        /// How many handles.
        genus: u64,
        /// How many boundary loops.
        holes: u64,
    },
    /// A sphere with cross-caps and holes.
    NonOrientable {
        /// How many cross-caps, one at least.
        cross_caps: u64,
        /// How many boundary loops.
        holes: u64,
    },
}

impl Surface {
    /// The orientable surface with an Euler characteristic and a number of boundary loops; none has an odd or
    /// negative 2 − χ − b.
    ///
    /// ```
    /// # use meshmend_topology::{Surface, surface_name};
    /// assert_eq!(Surface::orientable(0, 0).map(surface_name).as_deref(), Some("torus"));
    /// assert_eq!(Surface::orientable(3, 0), None);
    /// ```
    pub fn orientable(euler_characteristic: i64, holes: u64) -> Option<Self> {
        let twice_genus = missing(euler_characteristic, holes)?;
        twice_genus.is_multiple_of(2).then_some(Surface::Orientable { genus: twice_genus / 2, holes })
    }

    /// The non-orientable surface with an Euler characteristic and a number of boundary loops; none has fewer
    /// than one cross-cap.
    pub fn non_orientable(euler_characteristic: i64, holes: u64) -> Option<Self> {
        let cross_caps = missing(euler_characteristic, holes).filter(|&cross_caps| cross_caps > 0)?;
        Some(Surface::NonOrientable { cross_caps, holes })
    }

    /// The number of handles of an orientable surface.
    pub fn genus(self) -> Option<u64> {
        match self {
            Surface::Orientable { genus, .. } => Some(genus),
            Surface::NonOrientable { .. } => None,
        }
    }

    /// The number of cross-caps of a non-orientable surface.
    pub fn cross_caps(self) -> Option<u64> {
        match self {
            Surface::Orientable { .. } => None,
            Surface::NonOrientable { cross_caps, .. } => Some(cross_caps),
        }
    }

    /// The number of boundary loops.
    pub fn holes(self) -> u64 {
        match self {
            Surface::Orientable { holes, .. } | Surface::NonOrientable { holes, .. } => holes,
        }
    }
}

/// 2 − χ − b, where that is not negative.
fn missing(euler_characteristic: i64, holes: u64) -> Option<u64> {
    let holes = i64::try_from(holes).ok()?;
    u64::try_from(2i64.checked_sub(euler_characteristic)?.checked_sub(holes)?).ok()
}

/// What a surface is called.
///
/// ```
/// # use meshmend_topology::{Surface, surface_name};
/// assert_eq!(surface_name(Surface::Orientable { genus: 0, holes: 3 }), "pair of pants");
/// assert_eq!(surface_name(Surface::NonOrientable { cross_caps: 2, holes: 0 }), "Klein bottle");
/// ```
pub fn surface_name(surface: Surface) -> String {
    let with_boundary = match surface {
        Surface::Orientable { genus: 0, holes: 1 } => Some("disc"),
        Surface::Orientable { genus: 0, holes: 2 } => Some("annulus"),
        Surface::Orientable { genus: 0, holes: 3 } => Some("pair of pants"),
        Surface::NonOrientable { cross_caps: 1, holes: 1 } => Some("Möbius band"),
        _ => None,
    };
    match (with_boundary, surface.holes()) {
        (Some(name), _) => name.to_owned(),
        (None, 0) => closed_name(surface),
        (None, holes) => format!("{} with {}", closed_name(surface), counted(holes, "hole")),
    }
}

/// The name of the surface with its holes filled.
fn closed_name(surface: Surface) -> String {
    match surface {
        Surface::Orientable { genus: 0, .. } => "sphere".to_owned(),
        Surface::Orientable { genus: 1, .. } => "torus".to_owned(),
        Surface::Orientable { genus: 2, .. } => "double torus".to_owned(),
        Surface::Orientable { genus, .. } => format!("genus-{genus} surface"),
        Surface::NonOrientable { cross_caps: 1, .. } => "projective plane".to_owned(),
        Surface::NonOrientable { cross_caps: 2, .. } => "Klein bottle".to_owned(),
        Surface::NonOrientable { cross_caps: 3, .. } => "Dyck's surface".to_owned(),
        Surface::NonOrientable { cross_caps, .. } => format!("sphere with {cross_caps} cross-caps"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_by_the_classification_theorem() {
        let orientable = |genus, holes| surface_name(Surface::Orientable { genus, holes });
        let twisted = |cross_caps, holes| surface_name(Surface::NonOrientable { cross_caps, holes });
        let closed = [orientable(0, 0), orientable(1, 0), orientable(2, 0), orientable(3, 0)];
        assert_eq!(closed, ["sphere", "torus", "double torus", "genus-3 surface"]);
        let closed = [twisted(1, 0), twisted(2, 0), twisted(3, 0), twisted(4, 0)];
        assert_eq!(
            closed,
            ["projective plane", "Klein bottle", "Dyck's surface", "sphere with 4 cross-caps"]
        );
        let open = [orientable(0, 1), orientable(0, 2), orientable(0, 3), twisted(1, 1)];
        assert_eq!(open, ["disc", "annulus", "pair of pants", "Möbius band"]);
        let others = [orientable(0, 4), orientable(1, 1), twisted(1, 2), twisted(5, 7)];
        let names = ["sphere with 4 holes", "torus with 1 hole", "projective plane with 2 holes"];
        assert_eq!(others[..3], names);
        assert_eq!(others[3], "sphere with 5 cross-caps with 7 holes");
    }

    #[test]
    fn numbers_that_fit_no_surface_are_refused() {
        assert_eq!(Surface::orientable(1, 0), None);
        assert_eq!(Surface::orientable(2, 1), None);
        assert_eq!(Surface::non_orientable(2, 0), None);
        assert_eq!(Surface::orientable(i64::MIN, u64::MAX), None);
    }
}
