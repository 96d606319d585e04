//! Names by which faces know their materials, where a file may have one name twice.

use std::collections::BTreeSet;

use crate::text::{one_or_many, shown};
use crate::{Loss, LossKind};

/// A name for each of some materials, no two of them the same.
#[derive(Debug)]
pub(crate) struct DistinctNames {
    names: Vec<Vec<u8>>,
    /// Those whose name has a number, as one before has the name as well.
    numbered: Vec<usize>,
}

impl DistinctNames {
    /// The names of materials: that of one without a name is `material_N`, and of two that share a name the later is
    /// `NAME_N`, where N is its place.
    ///
    /// *Cost*: near-linear in the names.
    pub(crate) fn of(given: &[Option<Vec<u8>>]) -> Self {
        let known: BTreeSet<&[u8]> = given.iter().flatten().map(Vec::as_slice).collect();
        let (mut taken, mut numbered) = (BTreeSet::new(), Vec::new());
        let mut names = Vec::with_capacity(given.len());
        for (at, name) in given.iter().enumerate() {
            let mut own = name.clone().unwrap_or_else(|| b"material".to_vec());
            if name.is_none() || !taken.insert(own.clone()) {
                numbered.extend(name.is_some().then_some(at));
                own.extend(format!("_{at}").into_bytes());
                // Another may have the very name that a number makes of this one.
                while known.contains(&own[..]) || !taken.insert(own.clone()) {
                    own.extend(format!("_{at}").into_bytes());
                }
            }
            names.push(own);
        }
        DistinctNames { names, numbered }
    }

    /// The name of one of them.
    pub(crate) fn name(&self, at: usize) -> &[u8] {
        &self.names[at]
    }

    /// What a format is told that knows materials by names.
    pub(crate) fn loss(&self) -> Option<Loss> {
        let first = shown(&self.names[*self.numbered.first()?]);
        Loss::if_any(LossKind::Names, self.numbered.len(), |count| {
            let share = one_or_many(count, "material shares its name", "materials share their names");
            let called = if count == 1 { "and is called" } else { "and have numbers, such as" };
            format!("{share} with another {called} `{first}`")
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_that_is_there_already_has_a_number() {
        let given = ["red", "red", "", "red_1", "red", "material_2"];
        let given = given.map(|name| (!name.is_empty()).then(|| name.as_bytes().to_vec()));
        let names = DistinctNames::of(&given);
        let all: Vec<&[u8]> = (0..given.len()).map(|at| names.name(at)).collect();
        assert_eq!(all, [&b"red"[..], b"red_1_1", b"material_2_2", b"red_1", b"red_4", b"material_2"]);
        let loss = names.loss().unwrap();
        assert_eq!(loss.count, 2);
        assert_eq!(
            loss.message,
            "2 materials share their names with another and have numbers, such as `red_1_1`"
        );
        assert!(DistinctNames::of(&given[2..4]).loss().is_none());
    }
}
