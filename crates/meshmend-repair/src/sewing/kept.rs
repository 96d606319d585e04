//! The sewing of a mesh, kept from the pass that found it out for the pass that needs it next.

use std::sync::Mutex;

use meshmend_core::PolygonMesh;

use super::Sewing;

/// Keeps the sewing of one mesh.
///
/// `orient` finds out how its result is sewn if a patch is not orientable, and `split` begins with that.
#[derive(Debug, Default)]
pub(crate) struct KeptSewing {
    kept: Mutex<Option<(PolygonMesh, Sewing)>>,
}

impl KeptSewing {
    /// Keeps the sewing of a mesh in place of any other.
    pub(crate) fn keep(&self, mesh: &PolygonMesh, sewing: Sewing) {
        if let Ok(mut kept) = self.kept.lock() {
            *kept = Some((mesh.clone(), sewing));
        }
    }

    /// The sewing of a mesh, if that is the one that is kept. From then on none is kept.
    pub(crate) fn take(&self, mesh: &PolygonMesh) -> Option<Sewing> {
        let (of_mesh, sewing) = self.kept.lock().ok()?.take()?;
        of_mesh.is_copy_of(mesh).then_some(sewing)
    }

    /// Drops what is kept, unless it is of this mesh.
    pub(crate) fn keep_only_of(&self, mesh: &PolygonMesh) {
        if let Some(sewing) = self.take(mesh) {
            self.keep(mesh, sewing);
        }
    }
}

#[cfg(test)]
mod tests {
    use meshmend_testkit::shapes::{self, Tiles};

    use super::*;
    use crate::{Context, History, Orient, Pass, Split};

    #[test]
    fn split_begins_with_what_orient_found_out() {
        let band = shapes::moebius_band(5, 2, Tiles::Quads).soup.mesh();
        let (kept, history) = (KeptSewing::default(), History::begin(&band));
        let context = Context { sewing: Some(&kept), history: Some(&history), ..Context::default() };
        let oriented = Orient::default().apply(&band, &context).unwrap();
        assert_eq!(oriented.left.len(), 1);
        kept.keep_only_of(&oriented.mesh);
        assert!(kept.kept.lock().unwrap().is_some());
        let split = Split::default().apply(&oriented.mesh, &context).unwrap();
        assert!(kept.kept.lock().unwrap().is_none());
        let afresh = Split::default().apply(&oriented.mesh, &Context { sewing: None, ..context }).unwrap();
        assert_eq!(split.mesh.faces(), afresh.mesh.faces());
    }

    #[test]
    fn the_sewing_of_another_mesh_is_dropped() {
        let [one, other] = [1, 2].map(|width| shapes::moebius_band(5, width, Tiles::Quads).soup.mesh());
        let kept = KeptSewing::default();
        let context = Context { sewing: Some(&kept), ..Context::default() };
        let oriented = Orient::default().apply(&one, &context).unwrap();
        kept.keep_only_of(&other);
        assert!(kept.take(&oriented.mesh).is_none());
    }
}
