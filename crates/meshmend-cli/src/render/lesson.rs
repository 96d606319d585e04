//! Markdown laid out for the terminal: headings, paragraphs, lists, figures and tables, and nothing else.

use super::Style;

/// How wide a paragraph is.
pub(super) const WIDTH: usize = 96;

/// A text in Markdown as lines of a page.
pub(crate) fn lesson(text: &str, style: Style) -> String {
    let (mut page, mut is_figure) = (String::new(), false);
    let mut block = Block::default();
    for line in text.lines() {
        if line.trim_start().starts_with("```") {
            block.end(&mut page);
            is_figure = !is_figure;
        } else if is_figure || line.starts_with('|') {
            block.end(&mut page);
            page.push_str(&format!("  {line}\n"));
        } else if let Some(heading) = line.strip_prefix('#') {
            block.end(&mut page);
            page.push_str(&style.heading(plain(heading.trim_start_matches('#')).trim()));
            page.push('\n');
        } else if line.trim().is_empty() {
            block.end(&mut page);
            page.push('\n');
        } else {
            if item(line).is_some() {
                block.end(&mut page);
            }
            block.add(line);
        }
    }
    block.end(&mut page);
    page
}

/// A paragraph, or an item of a list, that is being read.
#[derive(Default)]
struct Block {
    words: String,
    /// What the first line begins with, such as `* `.
    mark: String,
}

impl Block {
    fn add(&mut self, line: &str) {
        let text = match item(line) {
            Some(mark) if self.words.is_empty() => {
                self.mark = line[..mark].to_owned();
                &line[mark..]
            }
            _ => line,
        };
        self.words.push_str(text.trim());
        self.words.push(' ');
    }

    /// Lays the block out, if there is one.
    fn end(&mut self, page: &mut String) {
        let Block { words, mark } = std::mem::take(self);
        let width = mark.chars().count();
        for (place, line) in wrapped(&plain(&words), WIDTH - width).iter().enumerate() {
            let before = if place == 0 { mark.clone() } else { " ".repeat(width) };
            page.push_str(&format!("  {before}{line}\n"));
        }
    }
}

/// How many bytes of a line are the mark of a list item, with the blanks before it.
fn item(line: &str) -> Option<usize> {
    let text = line.trim_start();
    let indent = line.len() - text.len();
    let digits = text.len() - text.trim_start_matches(|c: char| c.is_ascii_digit()).len();
    let is_numbered = digits > 0 && text[digits..].starts_with(". ");
    match text {
        _ if text.starts_with("* ") || text.starts_with("- ") => Some(indent + 2),
        _ if is_numbered => Some(indent + digits + 2),
        _ => None,
    }
}

/// Text without the marks of emphasis, and links as their words.
fn plain(text: &str) -> String {
    let (mut said, mut is_code, mut rest) = (String::new(), false, text);
    while let Some(letter) = rest.chars().next() {
        let link = if letter == '[' && !is_code { link(rest) } else { None };
        if let Some((words, length)) = link {
            said.push_str(&plain(words));
            rest = &rest[length..];
            continue;
        }
        is_code ^= letter == '`';
        if letter != '*' || is_code {
            said.push(letter);
        }
        rest = &rest[letter.len_utf8()..];
    }
    said
}

/// The words of a link with which a text begins, and how long the link is. A name of code in brackets is a link too.
fn link(text: &str) -> Option<(&str, usize)> {
    let words = text[1..].split_once(']')?.0;
    let after = &text[words.len() + 2..];
    match after.strip_prefix('(').and_then(|after| after.split_once(')')) {
        Some((target, _)) => Some((words, words.len() + target.len() + 4)),
        None => words.starts_with('`').then_some((words, words.len() + 2)),
    }
}

/// A text in lines of a width.
pub(super) fn wrapped(text: &str, width: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if line.chars().count() + word.chars().count() < width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_kind_of_block_has_its_layout() {
        let text = "# Half-edge\n\nEach *edge* is **split** into [`Half`](x::Half)s and [`Edge`]s,\nsee `a*b`.\n\n* `twin`: the\n  other\n* next\n12. third\n\n```text\n  * v0 *\n```\n| a | b |\n";
        let expected = "Half-edge\n\n  Each edge is split into `Half`s and `Edge`s, see `a*b`.\n\n  * `twin`: the other\n  * next\n  12. third\n\n    * v0 *\n  | a | b |\n";
        assert_eq!(lesson(text, Style::Plain), expected);
    }

    #[test]
    fn a_lone_bracket_is_a_bracket_and_long_lines_are_broken() {
        assert_eq!(plain("wing[end] and [v0, v1"), "wing[end] and [v0, v1");
        let long = lesson(&"word ".repeat(60), Style::Plain);
        assert!(long.lines().all(|line| line.chars().count() <= WIDTH + 2) && long.lines().count() == 4);
    }
}
