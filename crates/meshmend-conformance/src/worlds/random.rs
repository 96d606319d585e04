//! Random tables, the same in every run.

use crate::Soup;

/// A source of numbers: splitmix64.
struct Draws(u64);

impl Draws {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number below another one, which is not 0.
    fn below(&mut self, end: usize) -> usize {
        (self.next() % end as u64) as usize
    }

    /// Once in so many times.
    fn once_in(&mut self, times: usize) -> bool {
        self.below(times) == 0
    }

    fn shuffle<T>(&mut self, list: &mut [T]) {
        for last in (1..list.len()).rev() {
            list.swap(last, self.below(last + 1));
        }
    }
}

/// The random table of a number: any table, faces that touch themselves, or one of the surfaces with harm done to it.
pub(super) fn random_table(number: usize, surfaces: &[Soup]) -> Soup {
    let mut draws = Draws((number as u64).wrapping_mul(0x2545_f491_4f6c_dd1d));
    match number % 8 {
        0 | 1 => any_table(&mut draws),
        2 => touching_faces(&mut draws),
        _ if surfaces.is_empty() => any_table(&mut draws),
        kind => {
            let base = surfaces[draws.below(surfaces.len())].clone();
            harmed(&mut draws, base, kind >= 6)
        }
    }
}

/// Up to eight faces over up to eight vertices, most of them triangles and quads without repeats.
fn any_table(draws: &mut Draws) -> Soup {
    let vertices = 1 + draws.below(8);
    let faces = (0..draws.below(9)).map(|_| {
        let mut names: Vec<u32> = (0..vertices as u32).collect();
        draws.shuffle(&mut names);
        let corners = if draws.once_in(4) { draws.below(8) } else { 3 + draws.below(2) };
        if draws.once_in(4) {
            return (0..corners).map(|_| draws.below(vertices) as u32).collect();
        }
        names.truncate(corners);
        names
    });
    let faces: Vec<Vec<u32>> = faces.collect();
    Soup::generic(vertices, faces)
}

/// One or two faces with many corners on few vertices.
fn touching_faces(draws: &mut Draws) -> Soup {
    let faces: Vec<Vec<u32>> = (0..1 + draws.below(2))
        .map(|_| (0..3 + draws.below(5)).map(|_| draws.below(6) as u32).collect())
        .collect();
    Soup::generic(6, faces)
}

/// A surface under other names, its faces in another order and begun elsewhere; some faces gone, turned or doubled, some
/// degenerate, and two vertices made one, as it comes.
fn harmed(draws: &mut Draws, base: Soup, is_rough: bool) -> Soup {
    let extra = draws.below(2);
    let mut names: Vec<u32> = (0..(base.vertex_count() + extra) as u32).collect();
    draws.shuffle(&mut names);
    let mut faces = base.faces;
    draws.shuffle(&mut faces);
    let loss = [usize::MAX, 12, 4, 2][draws.below(4)];
    faces.retain(|_| loss == usize::MAX || !draws.once_in(loss));
    for face in faces.iter_mut().filter(|face| !face.is_empty()) {
        let turn = draws.below(face.len());
        face.rotate_left(turn);
        if is_rough && draws.once_in(6) {
            face.reverse();
        }
        face.iter_mut().for_each(|vertex| *vertex = names[*vertex as usize]);
    }
    if draws.once_in(3) {
        let place = draws.below(faces.len() + 1);
        faces.insert(place, vec![names[0], names[1], names[0]]);
    }
    if is_rough && draws.once_in(2) && !faces.is_empty() {
        let again = faces[draws.below(faces.len())].clone();
        faces.push(again);
    }
    if is_rough && draws.once_in(2) {
        faces
            .iter_mut()
            .flatten()
            .filter(|vertex| **vertex == names[0])
            .for_each(|vertex| *vertex = names[1]);
    }
    Soup::generic(names.len(), faces)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tables_are_the_same_in_every_run_and_all_different() {
        let base = [Soup::generic(4, [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]])];
        let tables: Vec<Soup> = (0..200).map(|number| random_table(number, &base)).collect();
        assert!((0..200).all(|number| random_table(number, &base) == tables[number]));
        let equal = tables.iter().filter(|one| tables.iter().filter(|other| one == other).count() > 1);
        assert!(equal.count() < 60);
        assert!(tables.iter().any(|table| table.complex().degenerate_faces().len() > 1));
    }

    #[test]
    fn the_numbers_are_those_of_splitmix64() {
        let mut draws = Draws(1_234_567);
        assert_eq!([draws.next(), draws.next()], [6_457_827_717_110_365_317, 3_203_168_211_198_807_973]);
    }
}
