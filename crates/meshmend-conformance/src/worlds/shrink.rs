//! Meshes made smaller while something stays true of them.

use crate::Soup;

/// The mesh with faces left out one by one, then corners, then with its vertices named densely, as long as it is one of
/// those that are looked for.
pub(crate) fn shrunk(soup: &Soup, mut is_one: impl FnMut(&Soup) -> bool) -> Soup {
    let mut least = soup.clone();
    let mut place = 0;
    while place < least.faces.len() {
        let mut fewer = least.clone();
        fewer.faces.remove(place);
        if is_one(&fewer) {
            least = fewer;
        } else {
            place += 1;
        }
    }
    for face in 0..least.faces.len() {
        let mut corner = 0;
        while corner < least.faces[face].len() {
            let mut fewer = least.clone();
            fewer.faces[face].remove(corner);
            if is_one(&fewer) {
                least = fewer;
            } else {
                corner += 1;
            }
        }
    }
    let dense = renamed_densely(&least);
    if is_one(&dense) { dense } else { least }
}

/// The vertices that are in faces, in their order, and no others.
fn renamed_densely(soup: &Soup) -> Soup {
    let mut used: Vec<u32> = soup.faces.iter().flatten().copied().collect();
    used.sort_unstable();
    used.dedup();
    let name = |vertex: &u32| used.binary_search(vertex).map_or(0, |place| place as u32);
    let faces: Vec<Vec<u32>> = soup.faces.iter().map(|face| face.iter().map(name).collect()).collect();
    Soup::generic(used.len(), faces)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_needed_stays_and_gets_dense_names() {
        let soup = Soup::generic(9, [&[0, 1, 2][..], &[5, 7, 8, 6], &[3, 3], &[2, 4, 7, 5]]);
        let has_side = |soup: &Soup| {
            soup.faces.iter().any(|face| face.len() > 2 && face.windows(2).any(|s| s[0] > s[1]))
        };
        let least = shrunk(&soup, has_side);
        assert_eq!((least.faces, least.positions.len()), (vec![vec![0, 2, 1]], 3));
        let keeps_names = shrunk(&soup, |soup| soup.faces.iter().flatten().any(|&vertex| vertex == 8));
        assert_eq!((keeps_names.faces, keeps_names.positions.len()), (vec![vec![8]], 9));
    }
}
