//! Declarations in the order of a header, which are found by name without searching all of them.

/// Something with a name.
pub(super) trait Named {
    fn name(&self) -> &str;
}

/// Declarations in the order of a header. If several have one name, the first is found.
#[derive(Debug, PartialEq)]
pub(super) struct Listed<T> {
    all: Vec<T>,
    /// The places of all, sorted by name. Places of one name ascend.
    by_name: Vec<usize>,
}

impl<T: Named> Listed<T> {
    /// *Cost*: that of sorting the names.
    pub(super) fn new(all: Vec<T>) -> Self {
        let mut by_name: Vec<usize> = (0..all.len()).collect();
        by_name.sort_by(|&one, &other| all[one].name().cmp(all[other].name()));
        Listed { all, by_name }
    }

    /// All declarations, in order.
    pub(super) fn all(&self) -> &[T] {
        &self.all
    }

    /// The first declaration of a name, with its place.
    ///
    /// *Cost*: O(log n).
    pub(super) fn find(&self, name: &str) -> Option<(usize, &T)> {
        let at = self.by_name.partition_point(|&place| self.all[place].name() < name);
        let &place = self.by_name.get(at)?;
        let found = &self.all[place];
        (found.name() == name).then_some((place, found))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    impl Named for &str {
        fn name(&self) -> &str {
            self
        }
    }

    #[test]
    fn the_first_of_a_name_is_found() {
        let listed = Listed::new(vec!["y", "x", "z", "x", ""]);
        assert_eq!(listed.find("x"), Some((1, &"x")));
        assert_eq!(listed.find("z"), Some((2, &"z")));
        assert_eq!(listed.find(""), Some((4, &"")));
        assert_eq!(listed.find("w").or(listed.find("zz")), None);
        assert_eq!(Listed::<&str>::new(Vec::new()).find("x"), None);
    }
}
