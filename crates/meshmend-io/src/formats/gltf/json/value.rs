//! A value of a JSON text, by where it stands.

use std::ops::Range;

use serde::de::IgnoredAny;

use super::scan::{end_of_value, skip_blanks, too_deep};
use crate::formats::gltf::fault::Fault;
use crate::limits::{JSON_BYTES, JSON_DEPTH};
use crate::{Limits, Place, ReadErrorKind};

/// A value of a text that is well formed.
#[derive(Clone, Copy, Debug)]
pub(in crate::formats::gltf) struct Value<'a> {
    text: &'a str,
    start: usize,
    end: usize,
}

/// A member of an object, or an item of an array: where it stands between its separators.
pub(in crate::formats::gltf) struct Child<'a> {
    /// After the bracket or the comma before it.
    pub(in crate::formats::gltf) start: usize,
    /// The member's name; empty for items.
    pub(in crate::formats::gltf) name: String,
    pub(in crate::formats::gltf) value: Value<'a>,
    /// The comma or bracket after it.
    pub(in crate::formats::gltf) end: usize,
}

/// The value that a text is.
///
/// # Errors
/// If it is larger or deeper than the limits allow, no UTF-8, or no JSON.
pub(in crate::formats::gltf) fn parse<'a>(bytes: &'a [u8], limits: &Limits) -> Result<Value<'a>, Fault> {
    Fault::if_more(JSON_BYTES, bytes.len() as u64, limits.max_json_bytes)?;
    let text = std::str::from_utf8(bytes)
        .map_err(|error| Fault::new(Place::Byte(error.valid_up_to() as u64), "the JSON is not UTF-8"))?;
    if let Some(at) = too_deep(bytes, limits.max_json_depth) {
        let (found, limit) = (limits.max_json_depth.saturating_add(1), limits.max_json_depth);
        let kind = ReadErrorKind::LimitExceeded { what: JSON_DEPTH, found, limit };
        return Err(Fault { place: Place::Byte(at as u64), kind });
    }
    serde_json::from_str::<IgnoredAny>(text).map_err(|error| {
        let start =
            text.split_inclusive('\n').take(error.line().saturating_sub(1)).map(str::len).sum::<usize>();
        let at = start + error.column().saturating_sub(1);
        let told = error.to_string();
        let reason = told.rsplit_once(" at line ").map_or(told.as_str(), |(reason, _)| reason);
        Fault::new(Place::Byte(at as u64), format!("the JSON is malformed: {reason}"))
    })?;
    let start = skip_blanks(bytes, 0);
    Ok(Value { text, start, end: end_of_value(bytes, start) })
}

impl<'a> Value<'a> {
    /// Where it stands in the whole text.
    pub(in crate::formats::gltf) fn range(self) -> Range<usize> {
        self.start..self.end
    }

    /// Its text.
    pub(in crate::formats::gltf) fn raw(self) -> &'a str {
        self.text.get(self.start..self.end).unwrap_or_default()
    }

    /// The whole text that it stands in.
    pub(in crate::formats::gltf) fn whole_text(self) -> &'a str {
        self.text
    }

    pub(in crate::formats::gltf) fn is_object(self) -> bool {
        self.raw().starts_with('{')
    }

    /// The members of an object or the items of an array, as they stand. Empty for other values.
    pub(in crate::formats::gltf) fn children(self) -> Vec<Child<'a>> {
        let mut children = Vec::new();
        self.each_child(|child| children.push(child));
        children
    }

    /// The items of an array; `None` for other values.
    pub(in crate::formats::gltf) fn items(self) -> Option<Vec<Value<'a>>> {
        let mut items = Vec::new();
        self.raw().starts_with('[').then(|| {
            self.each_child(|child| items.push(child.value));
            items
        })
    }

    fn each_child(self, mut see: impl FnMut(Child<'a>)) {
        let bytes = self.text.as_bytes();
        let is_object = self.is_object();
        if !is_object && !self.raw().starts_with('[') {
            return;
        }
        let (mut start, last) = (self.start + 1, self.end - 1);
        while skip_blanks(bytes, start) < last {
            let mut at = skip_blanks(bytes, start);
            let mut name = String::new();
            if is_object {
                let key = Value { text: self.text, start: at, end: end_of_value(bytes, at) };
                name = key.as_text().unwrap_or_default();
                at = skip_blanks(bytes, skip_blanks(bytes, key.end) + 1);
            }
            let value = Value { text: self.text, start: at, end: end_of_value(bytes, at) };
            let end = skip_blanks(bytes, value.end);
            see(Child { start, name, value, end });
            start = end + 1;
        }
    }

    /// The string that it is. Half of a surrogate pair, which no text can hold, is a mark of replacement.
    pub(in crate::formats::gltf) fn as_text(self) -> Option<String> {
        let inner = self.raw().strip_prefix('"')?.strip_suffix('"')?;
        if !inner.contains('\\') {
            return Some(inner.to_owned());
        }
        serde_json::from_str(self.raw()).ok().or_else(|| Some(inner.to_owned()))
    }

    pub(in crate::formats::gltf) fn as_number(self) -> Option<f64> {
        self.raw().parse().ok().filter(|_| self.raw().starts_with(|c: char| c == '-' || c.is_ascii_digit()))
    }

    /// The whole number that it is, however it is spelled.
    pub(in crate::formats::gltf) fn as_count(self) -> Option<u64> {
        const EXACT: f64 = 9_007_199_254_740_992.0;
        self.raw().parse().ok().or_else(|| {
            let number = self.as_number()?;
            (number.fract() == 0.0 && (0.0..=EXACT).contains(&number)).then_some(number as u64)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(text: &str) -> Value<'_> {
        parse(text.as_bytes(), &Limits::default()).unwrap()
    }

    #[test]
    fn values_are_found_where_they_stand() {
        let text = r#" { "a" : [1, "x,]\"", {}] , "b\u0041":-2.5e1,"c":{"d":null } } "#;
        let children = value(text).children();
        let names: Vec<&str> = children.iter().map(|child| child.name.as_str()).collect();
        assert_eq!(names, ["a", "bA", "c"]);
        let items: Vec<&str> = children[0].value.items().unwrap().iter().map(|item| item.raw()).collect();
        assert_eq!(items, ["1", r#""x,]\"""#, "{}"]);
        assert_eq!(children[1].value.as_number(), Some(-25.0));
        assert_eq!(children[2].value.raw(), r#"{"d":null }"#);
        assert_eq!(&text[children[2].value.range()], children[2].value.raw());
        assert!(value("7").children().is_empty() && value("7").items().is_none());
        assert!(value("[ ]").items().unwrap().is_empty());
    }

    #[test]
    fn whole_numbers_may_be_spelled_as_others() {
        let counts: Vec<Option<u64>> =
            ["3", "3.0", "3e2", "18446744073709551615", "-1", "0.5", "1e300", "\"3\""]
                .map(|text| value(text).as_count())
                .to_vec();
        assert_eq!(counts, [Some(3), Some(3), Some(300), Some(u64::MAX), None, None, None, None]);
        assert_eq!(value("true").as_number(), None);
        assert_eq!(value(r#""a\nb""#).as_text().unwrap(), "a\nb");
        assert_eq!(value(r#""\ud800""#).as_text().unwrap(), r"\ud800");
        assert_eq!(value("1").as_text(), None);
    }

    #[test]
    fn what_is_no_json_is_named_with_its_place() {
        let place = |bytes: &[u8], limits: Limits| parse(bytes, &limits).unwrap_err().place;
        let usual = Limits::default();
        assert_eq!(place(b"{\n\"a\":]}", usual), Place::Byte(6));
        assert_eq!(place(b"{\"\xff\"}", usual), Place::Byte(2));
        assert_eq!(place("[".repeat(129).as_bytes(), usual), Place::Byte(128));
        assert_eq!(place(b"[[\"]]]]\"]]", usual.with_max_json_depth(1)), Place::Byte(1));
        assert_eq!(place(b"[1, 2]", usual.with_max_json_bytes(5)), Place::File);
        assert!(parse(b"", &usual).is_err() && parse(b"{} {}", &usual).is_err());
        // A million brackets overflow no stack.
        assert_eq!(
            place("[".repeat(1_000_000).as_bytes(), usual.with_max_json_depth(u64::MAX)),
            Place::Byte(999_999)
        );
    }
}
