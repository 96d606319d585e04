//! The words of topology that reports use, each explained in a few lines with a formula, a source and something to try.
//!
//! A word is one file beside this one, and one line of the list.

/// A word with its explanation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Word {
    /// The word, in lower case with hyphens.
    pub name: &'static str,
    /// What it means, in Markdown; the word is the heading.
    pub text: &'static str,
}

macro_rules! words {
    ($($name:literal,)*) => {
        /// Every word, in alphabetical order.
        pub static WORDS: &[Word] = &[$(Word { name: $name, text: include_str!(concat!($name, ".md")) },)*];
    };
}

words! {
    "betti-numbers",
    "euler-characteristic",
    "genus",
    "homology",
    "homotopy",
    "instigator",
    "manifold",
    "orientable",
    "umbrella",
}

impl Word {
    /// The word of a name, if it is explained.
    pub fn from_name(name: &str) -> Option<Self> {
        WORDS.iter().copied().find(|word| word.name == name)
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    #[test]
    fn each_text_has_its_heading_its_formula_its_source_and_something_to_try() {
        assert!(WORDS.is_sorted_by_key(|word| word.name));
        for Word { name, text } in WORDS {
            assert!(text.starts_with(&format!("# {name}\n")), "{name}");
            for part in ["\n```text\n", "\n*Source*: ", "\n```sh\nmeshmend "] {
                assert!(text.contains(part), "{name} lacks {part:?}");
            }
            assert!(text.lines().count() < 25, "{name}");
            assert_eq!(Word::from_name(name).map(|word| word.text), Some(*text));
        }
        assert_eq!(Word::from_name("spleen"), None);
    }

    #[test]
    fn each_file_is_a_word() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/src/words");
        let files =
            fs::read_dir(folder).unwrap().map(|file| file.unwrap().file_name().into_string().unwrap());
        let mut names: Vec<String> =
            files.filter_map(|name| Some(name.strip_suffix(".md")?.to_owned())).collect();
        names.sort();
        assert_eq!(names, WORDS.iter().map(|word| word.name).collect::<Vec<_>>());
    }
}
