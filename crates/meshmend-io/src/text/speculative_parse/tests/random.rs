//! Numbers, words and line ends in an order that is the same every time.

/// Numbers in an order that is the same every time.
pub(super) struct Random(pub(super) u64);

impl Random {
    pub(super) fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) % bound as u64) as usize
    }

    pub(super) fn one_in(&mut self, count: usize) -> bool {
        count > 0 && self.below(count) == 0
    }

    pub(super) fn of<'a>(&mut self, list: &[&'a str]) -> &'a str {
        list[self.below(list.len())]
    }

    pub(super) fn number(&mut self) -> String {
        match self.below(8) {
            0 => self
                .of(&["0", "-0", "1e3", "-1.5E-3", "+2", ".5", "3.", "12345678901234567890.25"])
                .to_owned(),
            1 => format!("{}", self.below(1000)),
            _ => format!("{:.3}", self.below(200_000) as f64 / 100.0 - 1000.0),
        }
    }

    pub(super) fn numbers(&mut self, count: usize) -> String {
        let numbers: Vec<String> = (0..count).map(|_| self.number()).collect();
        numbers.join(self.of(&[" ", " ", " ", "  ", "\t"]))
    }

    /// Lines that are put together as some system does, or as several do, the last one with or without its end.
    pub(super) fn joined(&mut self, lines: &[String]) -> String {
        let ends = ["\n", "\r\n", "\r"];
        let (usual, mixes) = (self.of(&ends[..2]), self.one_in(4));
        let mut text = String::new();
        for line in lines {
            text += line;
            text += if mixes { self.of(&ends) } else { usual };
            text += if self.one_in(40) { "\n" } else { "" };
        }
        if self.one_in(3) {
            text.truncate(text.trim_end_matches(['\n', '\r']).len());
        }
        text
    }
}
