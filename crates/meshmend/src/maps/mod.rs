//! Maps of a repair: of every vertex, face and corner where it came from, what became of it, and why.
//!
//! They are plain arrays, for numpy ([`MapsFile::npz`]) or as JSON ([`MapsFile::json`]):
//!
//! | array | shape | what it says |
//! |---|---|---|
//! | `vertices_new_to_old`, `faces_…`, `corners_…` | int64, one a new element | the stored element that it is; −1 if it was created |
//! | `vertices_old_to_new_starts`, `…_items` | int64 | the new elements that the stored element `i` became: `items[starts[i]:starts[i + 1]]`, ascending |
//! | `cause_old_vertex`, `…_face`, `…_corner` | uint8, one a stored element | why: a place in `causes` |
//! | `faces_flipped` | uint8, one a new face | 1 where it runs the other way round than as stored |
//! | `created_vertices` | int64 | the created vertices, ascending |
//! | `created_from` | int64, four for each of them | the stored corners `a` and `b` that it lies between, and `n`, `d`: at a + (b − a) · n / d; −1 where it does not lie so |
//! | `created_in_face` | int64 | the stored face that it lies in; −1 where it does not lie so |
//! | `causes` | text | the words of causes, always the same |
//!
//! A corner is a place in the list of all corners, face after face. Of a file of parts, the arrays of part 3 are called
//! `part3/vertices_new_to_old` and so on.

mod array;
mod cause;
mod file;
mod npy;

use meshmend_core::{Blend, CornerId, Id, PolygonMesh, Provenance, VertexId};
use meshmend_repair::Repaired;

pub use self::cause::{CAUSES, Cause};
pub use self::file::MapsFile;

/// Where each element of a repaired mesh came from, what became of each stored one, and why.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct ElementMaps {
    /// Of the vertices.
    pub vertices: ElementMap,
    /// Of the faces.
    pub faces: ElementMap,
    /// Of the corners.
    pub corners: ElementMap,
    /// Of each new face whether it runs the other way round than as stored.
    pub flipped: Vec<bool>,
    /// The created vertices, ascending, and where each lies.
    pub created: Vec<(VertexId, Option<Blend>)>,
}

/// The map of the elements of one kind.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct ElementMap {
    /// Of each new element the stored one that it is.
    pub new_to_old: Vec<Option<u32>>,
    /// Where the new elements of each stored one begin among the items, and one more.
    pub starts: Vec<usize>,
    /// The new elements of the stored ones, one after another.
    pub items: Vec<u32>,
    /// Of each stored element why it became that.
    pub causes: Vec<Cause>,
}

impl ElementMap {
    /// The new elements that a stored one became.
    pub fn all_new_of(&self, old: usize) -> &[u32] {
        &self.items[self.starts[old]..self.starts[old + 1]]
    }

    /// The map by its pairs of stored and new elements, in which a stored one may be in several.
    fn of(new_to_old: Vec<Option<u32>>, old_count: usize, mut pairs: Vec<(u32, u32)>) -> Self {
        pairs.sort_unstable();
        pairs.dedup();
        let mut starts = vec![0; old_count + 1];
        pairs.iter().for_each(|&(old, _)| starts[old as usize + 1] += 1);
        for old in 0..old_count {
            starts[old + 1] += starts[old];
        }
        ElementMap {
            new_to_old,
            starts,
            items: pairs.into_iter().map(|(_, new)| new).collect(),
            causes: Vec::new(),
        }
    }
}

impl ElementMaps {
    /// The maps of the repair of a mesh as stored.
    ///
    /// *Cost*: O(n log n) for n elements.
    pub fn of(stored: &PolygonMesh, repaired: &Repaired) -> Self {
        let (provenance, result) = (&repaired.provenance, &repaired.mesh);
        let mut maps = ElementMaps {
            vertices: vertices(stored, result, provenance),
            faces: direct(provenance.faces.iter(), provenance.before.faces),
            corners: direct(provenance.corners.iter(), provenance.before.corners),
            flipped: vec![false; result.counts().faces],
            created: provenance.created.clone(),
        };
        provenance.flipped.iter().for_each(|face| maps.flipped[face.index()] = true);
        maps.find_causes(stored, &repaired.removed_faces);
        maps
    }
}

/// The map of elements each of which is one stored element, or was created.
fn direct<I: Id>(sources: impl ExactSizeIterator<Item = (I, Option<I>)>, old_count: usize) -> ElementMap {
    let new_to_old: Vec<Option<u32>> = sources.map(|(_, old)| old.map(|old| old.index() as u32)).collect();
    let pairs = (0u32..).zip(&new_to_old).filter_map(|(new, &old)| Some((old?, new))).collect();
    ElementMap::of(new_to_old, old_count, pairs)
}

/// The map of the vertices. A stored vertex became those that its corners have: so one that was welded to another is in it.
fn vertices(stored: &PolygonMesh, result: &PolygonMesh, provenance: &Provenance) -> ElementMap {
    let new_to_old: Vec<Option<u32>> =
        provenance.vertices.iter().map(|(_, old)| old.map(|old| old.0)).collect();
    let own = (0u32..).zip(&new_to_old).filter_map(|(new, &old)| Some((old?, new)));
    let of_corner = |(new, old): (CornerId, Option<CornerId>)| {
        Some((stored.faces().corner_vertex(old?).0, result.faces().corner_vertex(new).0))
    };
    let pairs = own.chain(provenance.corners.iter().filter_map(of_corner)).collect();
    ElementMap::of(new_to_old, provenance.before.vertices, pairs)
}

#[cfg(test)]
mod tests {
    use meshmend_core::{DefectKind, FaceId};
    use meshmend_io::read_bytes;
    use meshmend_repair::{
        AnyPass, Duplicates, NonOrientable, Orient, Pipeline, Triangulate, TriangulateFaces,
    };

    use super::*;

    fn maps(obj: &str, passes: impl IntoIterator<Item = AnyPass>) -> (PolygonMesh, Repaired, ElementMaps) {
        let stored = read_bytes(obj.as_bytes(), "a.obj", &Default::default()).unwrap().mesh;
        let pipeline = passes.into_iter().fold(Pipeline::default(), Pipeline::with);
        let repaired = pipeline.run(&stored).unwrap();
        let maps = ElementMaps::of(&stored, &repaired);
        (stored, repaired, maps)
    }

    fn words(causes: &[Cause]) -> Vec<&'static str> {
        causes.iter().map(|cause| cause.word()).collect()
    }

    /// A square of two triangles with a crack, the first of them again, a point, and a vertex that nothing uses.
    const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 9 9 9\n\
                          f 1 2 3\nf 4 5 6\nf 1 1 2\nf 2 3 1\n";

    #[test]
    fn what_became_of_each_element_is_told_both_ways_with_the_cause() {
        let (_, repaired, maps) = maps(SQUARE, []);
        assert_eq!(maps.vertices.new_to_old, [0, 1, 2, 5].map(Some));
        let new: Vec<&[u32]> = (0..7).map(|old| maps.vertices.all_new_of(old)).collect();
        assert_eq!(new, [&[0][..], &[1], &[2], &[1], &[2], &[3], &[]]);
        let causes = ["kept", "kept", "kept", "welded", "welded", "kept", "compacted"];
        assert_eq!(words(&maps.vertices.causes), causes);
        assert_eq!(words(&maps.faces.causes), ["kept", "kept", "degenerate", "repeated-same"]);
        let gone = [["degenerate"; 3], ["repeated-same"; 3]].concat();
        assert_eq!(words(&maps.corners.causes), [vec!["kept"; 6], gone].concat());
        assert_eq!(
            maps.flipped,
            repaired.mesh.faces().faces().map(|face| face == FaceId(1)).collect::<Vec<_>>()
        );
    }

    #[test]
    fn cuts_splits_and_other_removals_have_their_causes() {
        let quad = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
        let all = Triangulate { faces: TriangulateFaces::All };
        let (_, _, cut) = maps(quad, [all.into()]);
        assert_eq!((words(&cut.faces.causes), cut.faces.all_new_of(0)), (vec!["cut"], &[0, 1][..]));
        let twice = cut.corners.causes.iter().filter(|&&cause| cause == Cause::Cut).count();
        assert_eq!((twice, cut.corners.new_to_old.len()), (2, 6));

        // Two triangles that meet in a vertex alone.
        let pinched = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\nf 1 2 3\nf 1 4 5\n";
        let (_, _, split) = maps(pinched, []);
        assert_eq!((words(&split.vertices.causes)[0], split.vertices.all_new_of(0).len()), ("split", 2));

        let infinite = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nf 1 2 3\nf 1 2 4\nf 3 2 1\n";
        let pairs = Orient { duplicates: Duplicates::RemovePair, ..Orient::default() };
        let (_, repaired, gone) =
            maps(&(infinite.to_owned() + "v 5 0 0\nv 6 0 0\nv 5 1 0\nf 5 6 7\n"), [pairs.into()]);
        assert_eq!(
            words(&gone.faces.causes),
            ["repeated-opposite", "non-finite", "repeated-opposite", "kept"]
        );
        assert_eq!(
            words(&gone.vertices.causes)[..4],
            ["repeated-opposite", "repeated-opposite", "repeated-opposite", "non-finite"]
        );
        assert_eq!(repaired.removed_faces[1].reason, DefectKind::NonFiniteFace);
    }

    #[test]
    fn a_corner_that_repeats_another_goes_alone() {
        let (_, _, maps) = maps("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 2 3 4\n", []);
        assert_eq!(words(&maps.corners.causes), ["kept", "kept", "repeated-corner", "kept", "kept"]);
        assert_eq!(words(&maps.faces.causes), ["kept"]);
    }

    #[test]
    fn both_ways_agree_on_shapes_in_every_state_of_damage() {
        use meshmend_testkit::shapes::{self, Tiles};

        for soup in
            [shapes::moebius_band(5, 2, Tiles::Quads).soup, shapes::moebius_band(7, 1, Tiles::Triangles).soup]
        {
            let stored = soup.mesh();
            for cut in [NonOrientable::Report, NonOrientable::Cut] {
                let orient = Orient { non_orientable: cut, ..Orient::default() };
                let repaired = Pipeline::default().with(orient).run(&stored).unwrap();
                let maps = ElementMaps::of(&stored, &repaired);
                for map in [&maps.vertices, &maps.faces, &maps.corners] {
                    for (new, old) in (0u32..).zip(&map.new_to_old) {
                        assert!(old.is_none_or(|old| map.all_new_of(old as usize).contains(&new)));
                    }
                    assert_eq!(map.causes.len() + 1, map.starts.len());
                    assert_eq!(map.starts.last(), Some(&map.items.len()));
                }
            }
        }
    }
}
