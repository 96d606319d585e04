//! The page: a template, the viewer and the data.

use std::io::{self, Write};

use meshmend::Rules;
use meshmend::formats::base64;
use serde::Serialize;
use sha2::{Digest, Sha256};

use crate::Entry;
use crate::kinds::{KindData, kinds};

const TEMPLATE: &str = include_str!("../assets/page.html");
const STYLE: &str = include_str!("../assets/page.css");
const VIEWER: &str = include_str!("../assets/viewer.js");

/// The form of a page's data; it changes with what a viewer has to know of it.
const FORM: u32 = 1;

/// A page with reports on meshes.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Page {
    /// What the page is called.
    pub title: String,
    /// When its reports were made, as the page is to say it. Without a date a page is the same bytes every time.
    pub date: Option<String>,
    /// The kinds of defect that it can explain.
    pub rules: Rules,
    /// The meshes, in order.
    pub entries: Vec<Entry>,
}

#[derive(Serialize)]
struct Data<'a> {
    form: u32,
    program: &'static str,
    title: &'a str,
    date: Option<&'a str>,
    kinds: std::collections::BTreeMap<&'static str, KindData>,
    entries: &'a [Entry],
}

impl Page {
    /// A page without a mesh.
    pub fn titled(title: &str) -> Self {
        Page { title: title.to_owned(), date: None, rules: Rules::default(), entries: Vec::new() }
    }

    /// Writes the page.
    ///
    /// # Errors
    /// If the sink can't take it.
    ///
    /// *Cost*: linear in the data.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        for piece in TEMPLATE.split("{{").flat_map(|piece| piece.split("}}")) {
            match piece {
                "title" => out.write_all(escaped(&self.title).as_bytes())?,
                "style" => out.write_all(STYLE.as_bytes())?,
                "viewer" => out.write_all(VIEWER.as_bytes())?,
                "style-hash" => out.write_all(hash(STYLE).as_bytes())?,
                "viewer-hash" => out.write_all(hash(VIEWER).as_bytes())?,
                "data" => self.write_data(out)?,
                text => out.write_all(text.as_bytes())?,
            }
        }
        out.flush()
    }

    fn write_data(&self, out: &mut dyn Write) -> io::Result<()> {
        let data = Data {
            form: FORM,
            program: concat!("meshmend ", env!("CARGO_PKG_VERSION")),
            title: &self.title,
            date: self.date.as_deref(),
            kinds: kinds(self.rules),
            entries: &self.entries,
        };
        serde_json::to_writer(InScript { out }, &data).map_err(io::Error::from)
    }
}

/// A sink for JSON within a script element: `<` stands only in texts there, and is written as an escape, so that no text can
/// end the element or begin a comment.
struct InScript<'a> {
    out: &'a mut dyn Write,
}

impl Write for InScript<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let mut pieces = bytes.split(|&byte| byte == b'<');
        self.out.write_all(pieces.next().unwrap_or_default())?;
        for piece in pieces {
            self.out.write_all(b"\\u003c")?;
            self.out.write_all(piece)?;
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}

/// A text as HTML.
fn escaped(text: &str) -> String {
    text.chars().fold(String::with_capacity(text.len()), |mut html, character| {
        match character {
            '<' => html.push_str("&lt;"),
            '>' => html.push_str("&gt;"),
            '&' => html.push_str("&amp;"),
            '"' => html.push_str("&quot;"),
            _ => html.push(character),
        }
        html
    })
}

/// What a content security policy says of a script or a style that may stand in the page.
fn hash(text: &str) -> String {
    format!("'sha256-{}'", base64(&Sha256::digest(text.as_bytes())))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_of_a_file_ends_the_element_that_it_stands_in() {
        let hostile = "</script><script>alert(1)</script><!-- {{viewer}}";
        let mut page = Page::titled(hostile);
        page.entries.push(Entry::without(hostile, hostile));
        let mut html = Vec::new();
        page.write(&mut html).unwrap();
        let html = String::from_utf8(html).unwrap();
        assert_eq!((html.matches("alert(1)").count(), html.matches("<script>alert").count()), (4, 0));
        let data = html.split(r#"<script type="application/json" id="data">"#).nth(1).unwrap();
        let data = data.split("</script>").next().unwrap();
        let data: serde_json::Value = serde_json::from_str(data).unwrap();
        assert_eq!(data["entries"][0]["name"], hostile);
        assert!(html.contains("<title>&lt;/script&gt;"));
    }

    #[test]
    fn the_policy_lets_in_what_the_page_brings_and_nothing_else() {
        let mut html = Vec::new();
        Page::titled("a").write(&mut html).unwrap();
        let html = String::from_utf8(html).unwrap();
        let policy = html.split("Content-Security-Policy\" content=\"").nth(1).unwrap();
        let policy = policy.split('"').next().unwrap();
        assert!(policy.starts_with("default-src 'none';"), "{policy}");
        assert!(policy.contains(&hash(VIEWER)) && policy.contains(&hash(STYLE)));
        assert!(!policy.contains("unsafe") && !policy.contains("http"));
    }

    #[test]
    fn the_assets_can_stand_in_a_page() {
        assert!(!VIEWER.to_ascii_lowercase().contains("</script") && !VIEWER.contains("<!--"));
        assert!(!STYLE.contains('<'));
        assert!(TEMPLATE.matches("{{").count() == 6 && TEMPLATE.matches("}}").count() == 6);
    }
}
