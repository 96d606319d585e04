//! Bars as an SVG picture, in grey.

use std::fmt::Write as _;

use serde::Deserialize;

/// Groups of bars. In each group the longest bar fills the width.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub(crate) struct Chart {
    pub(crate) title: String,
    pub(crate) groups: Vec<Group>,
}

/// Bars that are compared.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub(crate) struct Group {
    pub(crate) title: String,
    pub(crate) bars: Vec<Bar>,
}

/// A bar, or a word instead of one.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub(crate) struct Bar {
    pub(crate) label: String,
    /// Its length; absent where there is only a word.
    pub(crate) value: Option<f64>,
    /// What stands behind it.
    pub(crate) text: String,
    /// Whether it is to be seen before the others.
    pub(crate) is_dark: bool,
}

const WIDTH: f64 = 640.0;
const LABELS: f64 = 190.0;
const BARS: f64 = 320.0;
const ROW: f64 = 15.0;
const MARGIN: f64 = 8.0;

impl Chart {
    /// The picture.
    pub(crate) fn svg(&self) -> String {
        let rows: usize = self.groups.iter().map(|group| group.bars.len() + 2).sum();
        let height = 2.0 * MARGIN + ROW * (rows + 1) as f64;
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" height=\"{height}\" \
             font-family=\"sans-serif\" font-size=\"11\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n"
        );
        let mut top = MARGIN + ROW;
        text(&mut svg, MARGIN, top, &self.title, " font-weight=\"bold\"");
        for group in &self.groups {
            top += 2.0 * ROW;
            text(&mut svg, MARGIN, top, &group.title, " font-weight=\"bold\" fill=\"#444\"");
            let longest = group.bars.iter().filter_map(|bar| bar.value).fold(0.0, f64::max);
            for bar in &group.bars {
                top += ROW;
                bar.draw(&mut svg, top, longest);
            }
        }
        svg + "</svg>\n"
    }
}

impl Bar {
    fn draw(&self, svg: &mut String, base: f64, longest: f64) {
        text(svg, LABELS - MARGIN, base, &self.label, " text-anchor=\"end\"");
        let length = match self.value {
            Some(value) if longest > 0.0 => BARS * value / longest,
            _ => 0.0,
        };
        let (fill, top, height) = (if self.is_dark { "#444" } else { "#aaa" }, base - 9.0, ROW - 4.0);
        // Writing to a text can't fail.
        let _ = writeln!(
            svg,
            "<rect x=\"{LABELS}\" y=\"{top}\" width=\"{length:.1}\" height=\"{height}\" fill=\"{fill}\"/>"
        );
        text(svg, LABELS + length + 4.0, base, &self.text, " fill=\"#444\"");
    }
}

fn text(svg: &mut String, x: f64, y: f64, words: &str, style: &str) {
    let words = words.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    let _ = writeln!(svg, "<text x=\"{x:.1}\" y=\"{y:.1}\"{style}>{words}</text>");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_longest_bar_of_a_group_fills_the_width_and_words_are_escaped() {
        let bar = |value, text: &str| Bar { label: "a < b".into(), value, text: text.into(), is_dark: false };
        let group = |bars| Group { title: "group".into(), bars };
        let chart = Chart {
            title: "R & D".into(),
            groups: vec![
                group(vec![bar(Some(1.0), "1"), bar(Some(2.0), "2"), bar(None, "wrong")]),
                group(vec![bar(Some(0.5), "0.5")]),
            ],
        };
        let svg = chart.svg();
        assert_eq!(svg.matches("width=\"320.0\"").count(), 2);
        assert_eq!(svg.matches("width=\"160.0\"").count(), 1);
        assert_eq!(svg.matches("width=\"0.0\"").count(), 1);
        assert!(svg.contains("R &amp; D") && svg.contains("a &lt; b") && svg.contains(">wrong<"));
    }
}
