//! Values that a change creates at corners are pooled: those that are the same to the bit are one value. (Values of
//! vertices are not: its place says which vertex it stands for.)

use std::sync::Arc;

use crate::{Layer, NO_VALUE, Values};

impl Layer {
    /// Lets elements that use a created value, one from `first` on, use the first value that is the same to the bit;
    /// what is then no longer used goes.
    ///
    /// *Cost*: constant where nothing was created; else linear in the pool and the uses, and a sort of what was
    /// created.
    pub(crate) fn pool_created(&mut self, first: usize, uses: &mut [u32]) {
        let count = self.value_count();
        if count == first {
            return;
        }
        // Each different created value, with the first value that is the same.
        let mut classes: Vec<(Vec<u64>, usize)> =
            (first..count).map(|value| (self.bits(value), value)).collect();
        classes.sort_unstable();
        classes.dedup_by(|later, earlier| later.0 == earlier.0);
        for value in (0..first).rev() {
            if let Ok(class) = classes.binary_search_by(|(bits, _)| bits.cmp(&self.bits(value))) {
                classes[class].1 = value;
            }
        }
        let mut kept: Vec<usize> =
            classes.iter().map(|class| class.1).filter(|&value| value >= first).collect();
        kept.sort_unstable();
        let pooled = |value: usize| {
            let bits = self.bits(value);
            let same = classes[classes.partition_point(|class| class.0 < bits)].1;
            if same < first { same } else { first + kept.partition_point(|&other| other < same) }
        };
        for slot in uses {
            if *slot != NO_VALUE && *slot as usize >= first {
                *slot = pooled(*slot as usize) as u32;
            }
        }
        let width = self.width;
        match Arc::make_mut(&mut self.values) {
            Values::F32(pool) => keep(pool, first, &kept, width),
            Values::F64(pool) => keep(pool, first, &kept, width),
            _ => {}
        }
    }

    /// A value as bits; only numbers with a fraction are ever created.
    fn bits(&self, value: usize) -> Vec<u64> {
        let range = value * self.width..(value + 1) * self.width;
        match &*self.values {
            Values::F32(pool) => pool[range].iter().map(|x| u64::from(x.to_bits())).collect(),
            Values::F64(pool) => pool[range].iter().map(|x| x.to_bits()).collect(),
            _ => Vec::new(),
        }
    }
}

/// Takes away all values of a pool from `first` on but some.
fn keep<T: Copy>(pool: &mut Vec<T>, first: usize, kept: &[usize], width: usize) {
    let tail: Vec<T> =
        kept.iter().flat_map(|value| &pool[value * width..(value + 1) * width]).copied().collect();
    pool.truncate(first * width);
    pool.extend(tail);
}
