//! Small pictures of what `explain` explains.

/// All pictures, each under the name of what it shows.
const PICTURES: &str = include_str!("pictures.md");

/// A page with the picture of what it explains, if there is one.
pub(crate) fn pictured(page: String, name: &str) -> String {
    match picture(name) {
        Some(picture) => format!("{page}\n{picture}\n"),
        None => page,
    }
}

/// The picture of a kind of defect or of a pass, if there is one: lines, the first and the last of which are not empty.
fn picture(name: &str) -> Option<&'static str> {
    let of_name = |section: &&'static str| section.lines().next() == Some(name);
    let section = PICTURES.split("# ").find(of_name)?;
    let (_, picture) = section.split_once("\n\n")?;
    Some(picture.trim_end())
}

#[cfg(test)]
mod tests {
    use meshmend::mesh::Found;
    use meshmend::{DefectKind, PassKind};

    use super::*;

    #[test]
    fn what_positions_tell_and_what_mends_it_has_a_picture() {
        let kinds = DefectKind::ALL.iter().filter(|kind| matches!(kind.rule().found, Found::ByGeometry));
        let passes = PassKind::ALL.iter().filter(|pass| !pass.row().is_default);
        let names: Vec<&str> = kinds.map(|kind| kind.code()).chain(passes.map(|pass| pass.name())).collect();
        assert!(names.len() > 15, "{names:?}");
        for name in names {
            assert!(picture(name).is_some_and(|picture| picture.lines().count() > 1), "{name}");
        }
    }

    #[test]
    fn every_picture_is_of_something_and_fits_a_line() {
        for section in PICTURES.split("# ").filter(|section| !section.is_empty()) {
            let name = section.lines().next().unwrap_or_default();
            let is_kind = DefectKind::ALL.iter().any(|kind| kind.code() == name);
            assert!(is_kind || PassKind::from_name(name).is_some(), "{name}");
            assert!(section.lines().all(|line| line.chars().count() <= 90), "{name}");
        }
        assert_eq!(picture("weld"), None);
    }
}
