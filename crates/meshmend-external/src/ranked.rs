//! A set of numbers that tells which place each has, in a little more than a bit a number.

/// How many words of bits share a count.
const WORDS: usize = 8;

/// A set of numbers below a bound. Numbers are added first; [`ranked`](RankedSet::ranked) makes it ready for questions.
#[derive(Debug)]
pub(crate) struct RankedSet {
    words: Vec<u64>,
    /// How many numbers lie before each run of words.
    before: Vec<u32>,
}

impl RankedSet {
    pub(crate) fn new(bound: usize) -> Self {
        RankedSet { words: vec![0; bound.div_ceil(64)], before: Vec::new() }
    }

    pub(crate) fn insert(&mut self, number: u32) {
        self.words[number as usize / 64] |= 1 << (number % 64);
    }

    pub(crate) fn remove(&mut self, number: u32) {
        self.words[number as usize / 64] &= !(1 << (number % 64));
    }

    /// All numbers below the bound.
    pub(crate) fn full(bound: usize) -> Self {
        let mut set = RankedSet::new(bound);
        set.words.fill(u64::MAX);
        if !bound.is_multiple_of(64)
            && let Some(last) = set.words.last_mut()
        {
            *last = (1 << (bound % 64)) - 1;
        }
        set
    }

    /// The set, ready for questions about places, and how many numbers it has.
    pub(crate) fn ranked(mut self) -> (Self, u32) {
        let mut count = 0;
        self.before = self
            .words
            .chunks(WORDS)
            .map(|run| {
                let before = count;
                count += run.iter().map(|word| word.count_ones()).sum::<u32>();
                before
            })
            .collect();
        (self, count)
    }

    /// How many numbers of the set are lower.
    #[inline]
    pub(crate) fn rank(&self, number: u32) -> u32 {
        let word = number as usize / 64;
        let run = word / WORDS;
        let whole: u32 = self.words[run * WORDS..word].iter().map(|word| word.count_ones()).sum();
        let below = (1 << (number % 64)) - 1;
        self.before[run] + whole + (self.words[word] & below).count_ones()
    }

    /// The number at a place, if there are so many.
    pub(crate) fn at(&self, place: u32) -> Option<u32> {
        let run = self.before.partition_point(|&before| before <= place).checked_sub(1)?;
        let mut left = place - self.before[run];
        for (word, &bits) in self.words.iter().enumerate().skip(run * WORDS) {
            if left < bits.count_ones() {
                let lowest = (0..left).fold(bits, |bits, _| bits & (bits - 1)).trailing_zeros();
                return Some(word as u32 * 64 + lowest);
            }
            left -= bits.count_ones();
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_and_numbers_are_inverse() {
        for bound in [1, 63, 64, 65, 512, 513, 5000] {
            let mut set = RankedSet::full(bound);
            let numbers: Vec<u32> = (0..bound as u32).filter(|n| n * n % 11 < 5).collect();
            (0..bound as u32).filter(|n| n * n % 11 >= 5).for_each(|n| set.remove(n));
            let (set, count) = set.ranked();
            assert_eq!(count as usize, numbers.len());
            for (place, &number) in (0..).zip(&numbers) {
                assert_eq!((set.rank(number), set.at(place)), (place, Some(number)));
            }
            assert_eq!(set.at(count), None);
        }
        let mut set = RankedSet::new(100);
        set.insert(70);
        assert_eq!(set.ranked().0.at(0), Some(70));
    }
}
