//! What stands for all that an output depends on beside its input: the plan, and the form of the output.

use meshmend_io::WriteOptions;
use serde::Serialize;

use super::{FileRepair, PartChoice, sha256};

/// The form of an output, as it is digested.
#[derive(Serialize)]
struct Form<'a> {
    format: Option<&'static str>,
    encoding: Option<&'static str>,
    seams: String,
    precision: String,
    manifold_extension: String,
    companions: String,
    kernel: &'static str,
    parts: &'a [String],
    taken_apart_by: Option<&'static str>,
}

impl FileRepair {
    /// The SHA-256, in hexadecimal digits, of the plan as canonical TOML and of the form of an output: with the same input and
    /// the same version of meshmend, the same digest means the same output. `None` stands for no output.
    ///
    /// # Errors
    /// When the plan can't be written as TOML. None is known that can't.
    pub fn digest(&self, options: Option<&WriteOptions>) -> Result<String, toml::ser::Error> {
        let shown = |value: &dyn std::fmt::Debug| format!("{value:?}");
        let PartChoice { parts, by } = &self.parts;
        let unsaid = WriteOptions::default();
        let written = options.unwrap_or(&unsaid);
        let mut plan = self.plan_for(written.format);
        // What the plan says of files is in the form, or does not change the output.
        plan.files = Default::default();
        let plan = toml::to_string(&plan)?;
        let form = Form {
            format: written.format.map(|format| format.name()),
            encoding: written.encoding.map(|encoding| encoding.name()),
            seams: shown(&written.seams),
            precision: shown(&written.precision),
            manifold_extension: shown(&written.manifold_extension),
            companions: shown(&written.companions),
            kernel: self.kernel.name(),
            parts,
            taken_apart_by: by.map(|names| names.name()),
        };
        let form = toml::to_string(&form)?;
        Ok(sha256(format!("{plan}\n[output]\n{form}").as_bytes()))
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use meshmend_core::FlippedNormals;
    use meshmend_io::{Format, Seams};
    use meshmend_repair::Plan;

    use super::*;
    use crate::files::CutPolygons;

    #[test]
    fn whatever_changes_the_output_changes_the_digest() {
        let usual = FileRepair::default();
        let [obj, stl] = [Format::Obj, Format::Stl].map(WriteOptions::of);
        let mut plan = Plan::default();
        plan.orient.flipped_normals = FlippedNormals::Keep;
        let cut = FileRepair { cut_polygons: CutPolygons::AsPlanned, ..FileRepair::default() };
        let digests = [
            usual.digest(None),
            usual.digest(Some(&obj)),
            usual.digest(Some(&WriteOptions::of(Format::Ply))),
            usual.digest(Some(&obj.clone().with_seams(Seams::Fail))),
            FileRepair::of(plan).digest(Some(&obj)),
            usual.digest(Some(&stl)),
            cut.digest(Some(&stl)),
        ];
        let digests: BTreeSet<String> = digests.into_iter().map(Result::unwrap).collect();
        assert!(digests.len() == 7 && digests.iter().all(|digest| digest.len() == 64), "{digests:?}");
    }

    #[test]
    fn what_would_be_done_to_polygons_counts_where_something_is() {
        let cut = FileRepair { cut_polygons: CutPolygons::AsPlanned, ..FileRepair::default() };
        let obj = WriteOptions::of(Format::Obj);
        assert_eq!(cut.digest(Some(&obj)).unwrap(), FileRepair::default().digest(Some(&obj)).unwrap());
    }

    #[test]
    fn what_the_report_shows_does_not_change_it() {
        let usual = FileRepair::default();
        let shown = FileRepair { limit: 3, ..FileRepair::default() };
        assert_eq!(usual.digest(None).unwrap(), shown.digest(None).unwrap());
    }
}
