//! What files say about materials and an output does not.

use std::collections::BTreeMap;

use meshmend_core::counted;

use crate::{Loss, LossKind, Material, text};

/// The loss of what files say of materials beyond what formats have in common. `format` is that of the output.
pub(crate) fn other_words_loss(materials: &[Material], format: &str) -> Option<Loss> {
    let words = materials.iter().flat_map(|material| &material.others);
    let mut times: BTreeMap<&str, usize> = BTreeMap::new();
    words.for_each(|word| *times.entry(word).or_default() += 1);
    Loss::if_any(LossKind::Material, times.values().sum(), |count| {
        let listed: Vec<String> =
            times.keys().map(|word| format!("`{}`", text::shown(word.as_bytes()))).collect();
        let of = counted(count, "statement");
        format!("{of} about materials that {format} has no word for: {}", listed.join(", "))
    })
}
