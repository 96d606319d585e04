//! Layers of several numbers, spread over properties and put together again.

use meshmend_core::Values;

use crate::formats::ply::property_names::{GROUPS, Group};

/// Whether a group has the default names of its layer.
pub(super) fn is_usual(group: &Group) -> bool {
    let width = group.members.len();
    usual(group.layer, width).is_some_and(|usual| usual.members == group.members)
}

/// The group in which a layer of some name and width is written by default.
pub(super) fn usual(layer: &str, width: usize) -> Option<&'static Group> {
    GROUPS.iter().find(|group| group.layer == layer && group.members.len() == width)
}

macro_rules! interleave {
    ($columns:expr, $($kind:ident),*) => {
        match &$columns[0] {
            $(Values::$kind(first) => {
                let columns: Vec<_> = $columns
                    .iter()
                    .filter_map(|column| if let Values::$kind(values) = column { Some(values) } else { None })
                    .collect();
                let rows = 0..first.len();
                Values::$kind(rows.flat_map(|row| columns.iter().map(move |column| column[row])).collect())
            })*
            Values::Text(_) | Values::Lists { .. } => Values::U8(Vec::new()),
        }
    };
}

/// Columns of one type, row by row.
pub(super) fn interleaved(columns: &[Values]) -> Values {
    interleave!(columns, I8, U8, I16, U16, I32, U32, F32, F64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_become_rows() {
        let columns = [Values::I16(vec![1, 2]), Values::I16(vec![3, 4]), Values::I16(vec![5, 6])];
        assert_eq!(interleaved(&columns), Values::I16(vec![1, 3, 5, 2, 4, 6]));
    }

    #[test]
    fn one_set_of_names_is_the_usual_one() {
        let usual: Vec<&str> = GROUPS.iter().filter(|g| is_usual(g)).map(|g| g.members[0]).collect();
        assert_eq!(usual, ["nx", "red", "red", "s"]);
    }
}
