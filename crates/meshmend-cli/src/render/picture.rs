//! What a picture shows, and what it does not.

use meshmend::mesh::counted;
use meshmend_render::{Overlay, Picture, Scene};

use super::{paragraph, printable};

/// One line, what is shown how often, and what is left out.
pub(crate) fn picture(input: &str, output: &str, scenes: &[Scene], picture: &Picture) -> String {
    let (width, height) = (picture.size().width(), picture.size().height());
    let mut page = format!("{} → {}: {width} × {height} pixels\n", printable(input), printable(output));
    for (scene, left_out) in scenes.iter().zip(picture.left_out()) {
        let counts = scene.overlays.iter().map(|overlay| {
            let (name, count) = (overlay.kind().name(), overlay.element_count());
            match overlay {
                Overlay::Generators { more, .. } if *more > 0 => {
                    format!("{name}: {count}, and {more} more that are not drawn")
                }
                _ => format!("{name}: {count}"),
            }
        });
        let heading = scene.caption.as_deref().unwrap_or("shown");
        let missing = format!("left out, as a corner is not finite: {}", counted(left_out.len(), "face"));
        let missing = (!left_out.is_empty()).then_some(missing);
        page.push_str(&paragraph(&printable(heading), counts.chain(missing)));
    }
    page
}
